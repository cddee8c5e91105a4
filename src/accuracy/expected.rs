//! The expected error of a method in one view, and its cost there.

use gamow_platform::threads::prelude::*;
use relativity_render::{Appearance, GpuError, HitImage, Method, PreparedScene, Renderers, View};

use super::cost::frame_ms;
use super::difference::Difference;
use super::outline::{OutlinePoint, RESOLUTION_PX, displacement_px, outline_pixels};
use super::spread::Spread;

/// The effort with which a view is examined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Effort {
    /// Places on outlines at which displacements are measured.
    pub outline_places: usize,
    /// Timed runs, of which the fastest counts.
    pub rounds: u32,
}

impl Effort {
    /// For a panel that is to be filled in a moment.
    pub const GLANCE: Self = Self { outline_places: 40, rounds: 2 };
    /// The effort for a report.
    pub const REPORT: Self = Self { outline_places: 60, rounds: 2 };
}

/// A method's cost and its difference to the reference, in one view.
#[derive(Debug, Clone, PartialEq)]
pub struct ExpectedError {
    /// Milliseconds per picture (of one eye).
    pub frame_ms: f64,
    /// Displacement of outlines, pixels; `None` if there are none, and for the reference itself.
    pub outlines_px: Option<Spread>,
    /// Pixel by pixel, for a heat map, and in figures.
    pub difference: Difference,
}

/// The total error of a picture, pixels: the displacement of outlines or the error of directions, whichever
/// is larger. Outlines that are nearer than can be distinguished count as exact.
#[must_use]
pub fn total_error_px(outlines_px: Option<f64>, arcseconds: Option<f64>, px_per_radian: f64) -> f64 {
    let resolved_px = outlines_px.filter(|&px| px > RESOLUTION_PX).unwrap_or(0.0);
    resolved_px.max((arcseconds.unwrap_or(0.0) / 3600.0).to_radians() * px_per_radian)
}

/// Measures `method` in `view` of `scene`; `None` if `is_cancelled` becomes true.
///
/// May take seconds: meant for a thread of its own. Whether it `is_cancelled` is asked between pictures.
///
/// # Errors
///
/// No GPU where `method` needs one; a device that was lost.
pub fn expected_error(
    renderers: &mut Renderers,
    scene: &PreparedScene,
    method: Method,
    view: &View,
    appearance: &Appearance,
    effort: Effort,
    is_cancelled: &dyn Fn() -> bool,
) -> Result<Option<ExpectedError>, GpuError> {
    let reference = scene.hit_image(view);
    if is_cancelled() {
        return Ok(None);
    }
    let difference = Difference::new(scene, view, &reference, &renderers.hits(method, scene, view)?);
    let places = if method == Method::Reference { 0 } else { effort.outline_places };
    let mut displacements = Vec::new();
    for place in outline_places(scene, view, &reference, places) {
        if is_cancelled() {
            return Ok(None);
        }
        let strips = |strip: &View| renderers.hits(method, scene, strip);
        displacements.push(displacement_px(scene, view, &place, strips)?);
    }
    let frame_ms = frame_ms(renderers, method, scene, view, appearance, effort.rounds)?;
    let outlines_px = Spread::from_errors(displacements);
    Ok((!is_cancelled()).then_some(ExpectedError { frame_ms, outlines_px, difference }))
}

fn outline_places(scene: &PreparedScene, view: &View, image: &HitImage, count: usize) -> Vec<OutlinePoint> {
    let place = |pixels| OutlinePoint::between(pixels, scene, view);
    outline_pixels(image, count).par_iter().filter_map(place).collect()
}

#[cfg(test)]
mod tests {
    use relativity_core::Speed;

    use super::*;
    use crate::accuracy::{TrackedPlace, view_at};
    use crate::scene::Scene;

    #[test]
    fn it_runs_on_another_thread_until_it_is_cancelled() {
        let scene = Scene::preset("cyclist").expect("a preset");
        let (mut renderers, prepared) = (Renderers::new(None), scene.prepared());
        let speed = Speed::from_beta(0.9).expect("it is a speed");
        let view = view_at(TrackedPlace::Abreast, speed, scene.tracked, 0.1, 1.0, [32, 24])
            .expect("inside the domain");
        let mut examined = |cancelled| {
            let appearance = Appearance::default();
            let work = || {
                let method = Method::Reference;
                expected_error(&mut renderers, &prepared, method, &view, &appearance, Effort::GLANCE, &|| {
                    cancelled
                })
            };
            std::thread::scope(|scope| scope.spawn(work).join().expect("it does not panic"))
        };
        assert!(matches!(examined(true), Ok(None)));
        let found = examined(false).expect("it needs no GPU").expect("it was not cancelled");
        assert_eq!(found.difference.pixels.len(), 32 * 24);
        assert_eq!(found.difference.figures.wrong_pixels, 0);
        assert!(found.difference.figures.covered_pixels > 0 && found.frame_ms > 0.0);
    }
}
