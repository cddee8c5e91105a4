//! Remarks on what was found in a picture, where it may not be one point; each is made once for all files.

use std::collections::BTreeMap;

use relativity_core::math;
use relativity_core::{Source, Turning, WheelPoint};
use relativity_render::Camera;

use super::locate::Target;
use super::place::PixelPlace;
use crate::files::exr::EYES;
use crate::settings::Settings;

/// Greatest miss of two eyes' lines of sight to one point, in standard deviations and pixels besides.
const MOST_SIGMAS: f64 = 5.0;
const MOST_PX: f64 = 1.0;

/// Greatest share of a body's outline beside which more of it is hidden, without a remark.
const MOST_HIDDEN: f64 = 0.05;

/// A remark on what was found.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Remark {
    /// An eye's picture (0 left, 1 right) has the colour in several places.
    Parts { eye: usize, parts: usize },
    /// Lines of sight of both eyes that pass above each other by this number of tenths of a pixel.
    OffPlane { tenths_px: i64 },
    /// Lines of sight that meet behind the eyes.
    Diverging,
    /// The target turns with a wheel: what is to be done about that.
    Turning(String),
    /// A body that is partly hidden from an eye (0 left, 1 right): the percentage of its visible outline that
    /// borders on nearer bodies or on the edge of the picture.
    Hidden { eye: usize, percent: u32 },
}

impl Remark {
    /// Returns a number for the kind: remarks with the same number are made once.
    const fn kind(&self) -> u8 {
        match self {
            Self::Parts { .. } => 0,
            Self::OffPlane { .. } => 1,
            Self::Diverging => 2,
            Self::Turning(_) => 3,
            Self::Hidden { .. } => 4,
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Parts { eye, parts } => format!(
                "in the {} eye's picture the colour is in {parts} separate places; the middle of all is \
                    measured",
                EYES[*eye]
            ),
            Self::OffPlane { tenths_px } => format!(
                "the colour is in places that cannot be one point, unless it turns with a wheel: the lines \
                    of sight of the two eyes miss each other by {} px",
                *tenths_px as f64 / 10.0
            ),
            Self::Diverging => "the colour is in places that cannot be one point: the lines of sight of \
                the two eyes diverge; the eyes may be swapped"
                .to_owned(),
            Self::Turning(advice) => format!("the target turns with a wheel: {advice}"),
            Self::Hidden { eye, percent } => format!(
                "other bodies, or the end of the picture, hide a part of the body from the {} eye, along \
                    {percent} % of the outline of what is left; the middle of that is measured, and the \
                    deviations do not know of it",
                EYES[*eye]
            ),
        }
    }
}

/// Returns a remark on a `target` in the scene of `settings` that turns with a wheel, which a fit has to
/// know.
///
/// # Errors
///
/// A scene that cannot be had.
pub fn of_target(settings: &Settings, target: Target<'_>) -> anyhow::Result<Option<Remark>> {
    let advice = match target {
        Target::Marker(_) => None,
        Target::Body(name) => {
            let scene = settings.opened_scene()?;
            let body = scene.body_called(name).map_err(anyhow::Error::msg)?;
            scene.bodies[body]
                .displacing_spin()
                .map(|_| "follow a --point of it, which can be fitted".to_owned())
        }
        Target::Point(point) => {
            let scene = settings.opened_scene()?;
            match settings.source(&scene.track(Some(point))) {
                Source::Point(_) => None,
                Source::Wheel(WheelPoint { radius, rho, angle, turning: Turning::Rolling, .. }) => {
                    Some(format!(
                        "fit it by `gamow fit --wheel-radius {radius} --rho {rho} --angle={angle}`, which gives the hub's y and z"
                    ))
                }
                Source::Wheel(_) => Some("it does not roll, and a fit takes it for a fixed point".to_owned()),
            }
        }
    };
    Ok(advice.map(Remark::Turning))
}

/// Returns a remark on the shares of a body's outline beside which more of it is hidden from each eye: on the
/// greater one, if that is not small.
pub fn of_hidden_shares([left, right]: [f64; 2]) -> Option<Remark> {
    let (eye, share) = if left >= right { (0, left) } else { (1, right) };
    (share > MOST_HIDDEN).then(|| Remark::Hidden { eye, percent: (100.0 * share).round() as u32 })
}

/// Returns a remark on the places that both eyes have of one colour, if the head is held along the motion: a
/// point is then in one plane with the eyes, whenever its light left, and in front of them.
pub fn of_places(settings: &Settings, cameras: &[Camera; 2], places: [PixelPlace; 2]) -> Option<Remark> {
    let baseline = settings.baseline();
    if !baseline.is_along_motion() || baseline.separation == 0.0 {
        return None;
    }
    let [left, right] = [0, 1].map(|eye: usize| cameras[eye].line_of_sight(places[eye].at));
    let pixel = cameras[0].horizontal_fov / f64::from(cameras[0].size[0]);
    let sigma_px = places.iter().flat_map(|place| place.sigma).fold(0.0, math::hypot);
    let most = MOST_SIGMAS * sigma_px + MOST_PX;
    let off_plane_px = (left.z * right.y - left.y * right.z) / math::hypot(left.y, left.z) / pixel;
    if off_plane_px.abs() > most {
        return Some(Remark::OffPlane { tenths_px: (10.0 * off_plane_px.abs()).round() as i64 });
    }
    // The angle from the axis of motion is the smaller one in the left eye.
    let [of_left, of_right] = [left, right].map(|line| math::atan2(math::hypot(line.y, line.z), line.x));
    let diverging_px = (of_left - of_right) / pixel;
    (diverging_px > most).then_some(Remark::Diverging)
}

/// The remarks, each with the first file that it is about and the number of files.
#[derive(Debug, Default)]
pub struct Remarks(BTreeMap<u8, (String, usize)>);

impl Remarks {
    /// Takes note of what looks wrong in the file `name`.
    pub fn note(&mut self, name: &str, remarks: &[Remark]) {
        for remark in remarks {
            let first = || (format!("{name}: {}", remark.text()), 0);
            self.0.entry(remark.kind()).or_insert_with(first).1 += 1;
        }
    }

    /// A line for each kind.
    pub fn lines(&self, files: usize) -> impl Iterator<Item = String> {
        self.0.values().map(move |(text, count)| match count {
            1 => text.clone(),
            _ => format!("{text} (so in {count} of {files} files)"),
        })
    }
}
