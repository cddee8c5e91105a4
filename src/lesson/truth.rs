//! What is predicted, as it is: curves over T and places in a view.

use relativity_render::Gaze;

use super::plan::Quantity;
use crate::scene::{Scene, Track};
use crate::settings::Settings;

impl Quantity {
    /// It of the point at `track` at `time`; `None` outside the domain of the core. Radians, or a ratio.
    #[must_use]
    pub fn at(self, settings: &Settings, track: &Track, time: f64) -> Option<f64> {
        let seen = settings.disparity(track, time).ok()?;
        Some(match self {
            Self::Dphi => seen.dphi,
            Self::Dtheta => seen.dtheta,
            Self::Doppler => seen.primary.doppler_factor,
            Self::Phi => seen.primary.phi(),
        })
    }

    /// Its sign and its unit, for an axis.
    #[must_use]
    pub const fn axis(self) -> [&'static str; 2] {
        match self {
            Self::Dphi => ["Δφ", "rad"],
            Self::Dtheta => ["Δθ", "rad"],
            Self::Doppler => ["D", ""],
            Self::Phi => ["φ", "rad"],
        }
    }
}

/// The direction in which the left eye sees the body of this name at the settings' T.
#[must_use]
pub fn direction(settings: &Settings, scene: &Scene, body: &str) -> Option<Gaze> {
    let body = scene.names.iter().position(|name| name == body)?;
    let track = scene.track_on(body)?;
    let time = settings.time.unwrap_or_else(|| settings.time_of_approach(&track));
    let [left, _] = settings.directions(&track, time);
    left.map(|direction| Gaze::along(direction.into()))
}

/// The angle between two directions, radians.
#[must_use]
pub fn angle_between(a: Gaze, b: Gaze) -> f64 {
    a.axes().forward.angle_between(b.axes().forward)
}

/// The root mean square by which the drawn `points` (T and value) differ from `truth` over T; none where no truth is.
#[must_use]
pub fn rms(points: &[[f64; 2]], truth: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    let squares: Vec<f64> =
        points.iter().filter_map(|[time, value]| Some((value - truth(*time)?).powi(2))).collect();
    (!squares.is_empty()).then(|| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
}
