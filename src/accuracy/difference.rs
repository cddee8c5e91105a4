//! Two pictures of one view compared pixel by pixel: a renderer's against the reference's.

use glam::DVec3;
use relativity_core::math;
use relativity_render::{GroupView, Hit, HitImage, PreparedScene, View};
use serde::Serialize;

use super::spread::Spread;

/// Arcseconds of a radian.
pub const ARCSECONDS: f64 = 3600.0 * 180.0 / std::f64::consts::PI;

/// The difference of one pixel from the reference's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PixelDifference {
    /// Neither picture shows anything.
    Nothing,
    /// Another body, or only one of the two shows any.
    WrongBody,
    /// Both pictures show the same body.
    SameBody {
        /// Angle between the pixel's line of sight and that along which the point shown is really seen.
        arcseconds: f64,
        /// |D / D of the reference - 1|.
        doppler: f64,
    },
}

/// The difference of a picture from the reference's.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Difference of each pixel, row by row from the top left.
    pub pixels: Vec<PixelDifference>,
    /// Summary of the differences.
    pub figures: DifferenceFigures,
}

/// A difference in figures.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DifferenceFigures {
    /// Pixels in which the reference shows a body.
    pub covered_pixels: usize,
    /// Pixels with the wrong body, or with one where there is none, or without one where there is.
    pub wrong_pixels: usize,
    /// Wrong pixels whose eight neighbours all show the same as they do in the reference.
    pub wrong_pixels_off_outlines: usize,
    /// Over pixels with the right body: see [`PixelDifference::SameBody`].
    pub line_of_sight_arcseconds: Option<Spread>,
    /// Over the same pixels: relative error of the Doppler factor.
    pub doppler_relative: Option<Spread>,
}

impl DifferenceFigures {
    /// Wrong pixels per covered pixel.
    #[must_use]
    pub fn wrong_share(&self) -> f64 {
        self.wrong_pixels as f64 / self.covered_pixels.max(1) as f64
    }
}

impl Difference {
    /// Returns the difference of `shown` from `reference`, both being pictures of `view`.
    #[must_use]
    pub fn new(scene: &PreparedScene, view: &View, reference: &HitImage, shown: &HitImage) -> Self {
        let group_views = scene.group_views(view);
        let lines_of_sight = view.camera.lines_of_sight();
        let width = view.camera.size[0] as usize;
        let pairs = reference.hits.iter().zip(&shown.hits).enumerate();
        let pixels: Vec<_> = pairs
            .map(|(i, (reference, shown))| {
                let centre = [(i % width) as f64 + 0.5, (i / width) as f64 + 0.5];
                let line_of_sight = lines_of_sight.through(centre);
                let seen = |hit: &Hit| direction(&group_views[scene.group_of(hit.body)], hit);
                pixel_difference(line_of_sight, reference.as_ref(), shown.as_ref(), seen)
            })
            .collect();
        Self { size: view.camera.size, figures: figures(reference, &pixels), pixels }
    }
}

fn pixel_difference(
    line_of_sight: DVec3,
    reference: Option<&Hit>,
    shown: Option<&Hit>,
    seen: impl Fn(&Hit) -> DVec3,
) -> PixelDifference {
    match (reference, shown) {
        (None, None) => PixelDifference::Nothing,
        (Some(reference), Some(shown)) if reference.body == shown.body => PixelDifference::SameBody {
            arcseconds: ARCSECONDS * angle(line_of_sight, seen(shown)),
            doppler: (shown.doppler_factor / reference.doppler_factor - 1.0).abs(),
        },
        _ => PixelDifference::WrongBody,
    }
}

/// Along which `view` sees what was hit; through the core's light cone, not back along the ray.
fn direction(view: &GroupView, hit: &Hit) -> DVec3 {
    // Outside the domain of the core lies nothing that a scene can hold.
    view.apparent_position(hit.rest_position).unwrap_or(DVec3::NAN)
}

/// Angle between two directions, radians: accurate also where it is tiny.
fn angle(a: DVec3, b: DVec3) -> f64 {
    math::atan2(a.cross(b).length(), a.dot(b))
}

fn figures(reference: &HitImage, pixels: &[PixelDifference]) -> DifferenceFigures {
    let all = |kind| (0..pixels.len()).filter(move |&i| pixels[i] == kind);
    let wrong: Vec<_> = all(PixelDifference::WrongBody).collect();
    let same = |value: fn(f64, f64) -> f64| {
        let errors = pixels.iter().filter_map(|pixel| match *pixel {
            PixelDifference::SameBody { arcseconds, doppler } => Some(value(arcseconds, doppler)),
            _ => None,
        });
        Spread::from_errors(errors.collect())
    };
    DifferenceFigures {
        covered_pixels: reference.hits.iter().flatten().count(),
        wrong_pixels: wrong.len(),
        wrong_pixels_off_outlines: wrong.iter().filter(|&&i| !is_at_outline(reference, i)).count(),
        line_of_sight_arcseconds: same(|arcseconds, _| arcseconds),
        doppler_relative: same(|_, doppler| doppler),
    }
}

/// Whether one of the eight neighbours of pixel `i` shows something else.
fn is_at_outline(image: &HitImage, i: usize) -> bool {
    let [width, height] = image.size.map(|side| side as usize);
    let body = |i: usize| image.hits[i].map(|hit| hit.body);
    let [u, v] = [i % width, i / width];
    let near = |at: usize, side: usize| at.saturating_sub(1)..(at + 2).min(side);
    near(v, height).any(|v| near(u, width).any(|u| body(v * width + u) != body(i)))
}

#[cfg(test)]
mod tests {
    use relativity_core::Speed;
    use relativity_render::{Body, Gaze, PreparedScene, Shape};

    use super::*;
    use crate::accuracy::{TrackedPlace, view_at};

    fn ball(centre: [f64; 3], radius: f64) -> Body {
        Body::new(Shape::Sphere { centre, radius }, 600.0)
    }

    fn view(beta: f64) -> View {
        let speed = Speed::from_beta(beta).expect("it is a speed");
        view_at(TrackedPlace::Abreast, speed, [0.0, 5.0, 0.0], 0.0, 1.0, [60, 40]).expect("inside the domain")
    }

    fn figures(view: &View, shown: &HitImage, truth: &[Body]) -> DifferenceFigures {
        let scene = PreparedScene::moving(truth);
        Difference::new(&scene, view, &scene.hit_image(view), shown).figures
    }

    #[test]
    fn a_gaze_off_by_ten_arcseconds_shows_as_ten_arcseconds() {
        let bodies = [ball([0.0, 5.0, 0.0], 1.0)];
        for beta in [0.0, 0.9, 0.9999] {
            let view = view(beta);
            let mut off = view;
            let azimuth = view.camera.gaze.azimuth + 10.0 / ARCSECONDS;
            off.camera.gaze = Gaze { azimuth, ..view.camera.gaze };
            let found = figures(&view, &PreparedScene::moving(&bodies).hit_image(&off), &bodies);
            let spread = found.line_of_sight_arcseconds.expect("the ball is seen");
            // Less by the cosine of the elevation, here up to 0.2.
            assert!(spread.worst < 10.000_01 && spread.median > 9.8, "{spread:?} at beta = {beta}");
        }
    }

    #[test]
    fn another_body_is_wrong_also_where_it_has_the_same_surface() {
        let view = view(0.5);
        let truth = [ball([0.0, 5.0, 0.0], 1.0), ball([0.0, 5.0, 0.0], 1.0)];
        let mut shown = PreparedScene::moving(&truth).hit_image(&view);
        assert_eq!(figures(&view, &shown, &truth).wrong_pixels, 0);
        let covered = shown.hits.iter().flatten().count();
        shown.hits.iter_mut().flatten().for_each(|hit| hit.body = 1);
        let found = figures(&view, &shown, &truth);
        assert_eq!(found.wrong_pixels, covered);
        assert!(found.wrong_pixels_off_outlines > 0 && found.wrong_pixels_off_outlines < covered);
    }
}
