//! The truth about a prediction: curves over T and places in a view.

use glam::DVec3;
use relativity_render::{Gaze, PreparedScene};

use super::plan::CurveAnswer;
use crate::plot::{CurveSample, CurveSampling};
use crate::scene::{Scene, Track};
use crate::settings::Settings;

/// Distance up to which a place counts as that of a body, radians.
pub const NEAR: f64 = 2.0 / 180.0 * std::f64::consts::PI;

/// Equal parts in which a curve is sampled at least.
const PARTS: u32 = 128;

/// The picture of a scene.
#[derive(Debug, Clone, Copy)]
pub struct Sight<'a> {
    /// Settings of the picture.
    pub settings: &'a Settings,
    /// Scene in the picture.
    pub scene: &'a Scene,
    /// Scene, ready to be drawn.
    pub prepared: &'a PreparedScene,
    /// Selected point of the scene.
    pub track: Track,
    /// Observation time T.
    pub time: f64,
}

impl Sight<'_> {
    /// The direction in which the left eye sees the body of this name.
    #[must_use]
    pub fn direction(&self, body: &str) -> Option<Gaze> {
        let [left, _] = self.directions(body)?;
        left.map(|direction| Gaze::along(direction.into()))
    }

    /// From each eye to where it sees the point that is followed on the body of this name.
    #[must_use]
    pub fn directions(&self, body: &str) -> Option<[Option<DVec3>; 2]> {
        let track = self.scene.track_on(self.scene.body_called(body).ok()?)?;
        Some(self.settings.directions(&track, self.time))
    }

    /// Whether what the left eye sees in this direction is the body of this name.
    #[must_use]
    pub fn is_on(&self, direction: Gaze, body: &str) -> bool {
        let [left, _] = self.settings.views_ahead(self.time);
        let hit = self.prepared.first_hit(&left, direction.axes().forward);
        hit.is_some_and(|hit| self.scene.body_called(body) == Ok(hit.body))
    }
}

/// The curve of `value` over T from the first to the last of `times`, in pieces: it ends where there is none.
fn curve(times: [f64; 2], value: impl Fn(f64) -> Option<f64>) -> Vec<Vec<[f64; 2]>> {
    let values = |time| value(time).map(|value| [value]);
    let points = |piece| {
        let samples = CurveSampling::even(piece, PARTS).samples(values).into_iter();
        samples.map(|CurveSample { time, values: [value] }| [time, value]).collect()
    };
    CurveSampling::even(times, PARTS).pieces(values).into_iter().map(points).collect()
}

impl CurveAnswer {
    /// Returns the value of the curve for the point at `track` at `time`; `None` outside the domain of the
    /// core. Radians, or a ratio.
    #[must_use]
    pub fn at(&self, settings: &Settings, track: &Track, time: f64) -> Option<f64> {
        self.quantity.seen(&settings.disparity(track, time).ok()?)
    }

    /// Returns the curve over `times` (first and last T), in pieces, densely where it bends.
    #[must_use]
    pub fn over(&self, settings: &Settings, track: &Track, times: [f64; 2]) -> Vec<Vec<[f64; 2]>> {
        curve(times, |time| self.at(settings, track, time))
    }
}

/// The angle between two directions, radians.
#[must_use]
pub fn angle_between(a: Gaze, b: Gaze) -> f64 {
    a.axes().forward.angle_between(b.axes().forward)
}

/// The root mean square by which the drawn `points` (T and value) differ from `truth` over T; none where no
/// truth is.
#[must_use]
pub fn rms(points: &[[f64; 2]], truth: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    let squares: Vec<f64> =
        points.iter().filter_map(|[time, value]| Some((value - truth(*time)?).powi(2))).collect();
    (!squares.is_empty()).then(|| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_is_within_a_thousandth_of_its_height_wherever_it_is() {
        let step = |time: f64| Some((20.0 * (time - 0.3)).tanh());
        let [points] = &curve([-5.0, 5.0], step)[..] else { panic!("one piece") };
        assert!(points.is_sorted_by(|a, b| a[0] < b[0]) && points[0][0] == -5.0);
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            for share in [0.25, 0.5, 0.75] {
                let time = a[0] + share * (b[0] - a[0]);
                let drawn = a[1] + share * (b[1] - a[1]);
                assert!((drawn - (20.0 * (time - 0.3)).tanh()).abs() < 3e-3, "{time}");
            }
        }
    }

    #[test]
    fn a_curve_ends_where_there_is_none() {
        let pieces = curve([-2.0, 2.0], |time| (time.abs() > 0.5).then_some(time));
        assert_eq!(pieces.len(), 2);
        assert!(pieces.iter().flatten().all(|[time, value]| time == value && time.abs() > 0.5));
    }
}
