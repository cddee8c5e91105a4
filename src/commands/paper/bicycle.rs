//! The paper's two-dimensional bicycle of straight lines and circles, and how it appears.
//!
//! It rides in the plane of its path and the eyes, at rest coordinates (x, y): x along the motion, y the
//! distance from the line of the eyes, which stays as it is.

use relativity_core::math;
use std::f64::consts::TAU;

use relativity_core::{Aperture, Model, PairError, SourcePoint, observation_time_when_seen_at, sighting};

use super::curves::Setup;

/// A polyline of rest coordinates (x, y).
pub type Polyline = Vec<[f64; 2]>;

const WHEEL_RADIUS: f64 = 0.35;
/// Axles: rear and front.
const AXLES: [[f64; 2]; 2] = [[-1.4, 0.85], [-0.35, 0.85]];
const CRANK: [f64; 2] = [-0.93, 0.82];
const SEAT: [f64; 2] = [-1.05, 1.35];
const HEAD: [f64; 2] = [-0.5, 1.35];
const SPOKES: usize = 8;
/// Points along a straight part, and around a wheel.
const POINTS: usize = 60;

/// The parts of the bicycle.
pub fn strokes() -> Vec<Polyline> {
    let mut strokes: Vec<Polyline> = Vec::new();
    for axle in AXLES {
        let rim = |i: usize, of: usize| {
            let (sin, cos) = math::sin_cos(TAU * i as f64 / of as f64);
            [axle[0] + WHEEL_RADIUS * cos, axle[1] + WHEEL_RADIUS * sin]
        };
        strokes.push((0..=2 * POINTS).map(|i| rim(i, 2 * POINTS)).collect());
        strokes.extend((0..SPOKES).map(|i| straight(axle, rim(i, SPOKES))));
    }
    let [rear, front] = AXLES;
    let frame = [[rear, CRANK], [rear, SEAT], [CRANK, SEAT], [CRANK, HEAD], [SEAT, HEAD], [HEAD, front]];
    strokes.extend(frame.map(|[from, to]| straight(from, to)));
    strokes.push(straight([SEAT[0] - 0.14, 1.42], [SEAT[0] + 0.12, 1.42])); // saddle
    strokes.push(straight(SEAT, [SEAT[0] - 0.01, 1.42]));
    strokes.push(straight(HEAD, [HEAD[0] - 0.04, 1.5])); // stem
    strokes.push(straight([HEAD[0] - 0.04, 1.5], [HEAD[0] + 0.12, 1.5])); // handlebar
    strokes
}

fn straight(from: [f64; 2], to: [f64; 2]) -> Polyline {
    let at = |i: usize| {
        let u = i as f64 / POINTS as f64;
        [from[0] + u * (to[0] - from[0]), from[1] + u * (to[1] - from[1])]
    };
    (0..=POINTS).map(at).collect()
}

/// The observation time at which the eye at the origin sees the bicycle's crank at `x`.
pub fn time_when_seen_at(setup: &Setup, x: f64) -> Result<f64, PairError> {
    let time = observation_time_when_seen_at(&setup.speed(), source(setup, CRANK), x, Aperture::pair(0.0))?;
    Ok(time.expect("the paper's bicycles ride"))
}

/// Returns the place where a point at `rest` appears to a single eye at the origin.
pub fn seen_by_one(setup: &Setup, rest: [f64; 2], time: f64) -> Result<[f64; 2], PairError> {
    let seen = sighting(&setup.speed(), source(setup, rest), Aperture::default(), time)?;
    Ok([seen.position[0], seen.position[1]])
}

/// Returns the places of the left and the right eye from the middle between them, for what [`seen_by_two`]
/// gives of each: the published model measures both from the left eye.
pub fn measured_from(setup: &Setup, model: Model) -> [f64; 2] {
    let half = 0.5 * setup.separation;
    [-half, if model == Model::Exact { half } else { -half }]
}

/// Returns the places where a point at `rest` appears to the left and to the right eye, x from the eye, as
/// `gamow eval` writes it.
pub fn seen_by_two(
    setup: &Setup,
    model: Model,
    rest: [f64; 2],
    time: f64,
) -> Result<[[f64; 2]; 2], PairError> {
    let seen = setup.seen_at(model, source(setup, rest), time)?;
    Ok([seen.primary.position, seen.secondary.position].map(|[x, y, _]| [x, y]))
}

fn source(setup: &Setup, [x, y]: [f64; 2]) -> SourcePoint {
    SourcePoint::from_rest([x, y, 0.0], &setup.speed())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The paper: sqrt((1 + beta)/(1 - beta)) before and its inverse after the passage.
    #[test]
    fn far_away_the_bicycle_is_stretched_and_squeezed_by_the_known_ratios() {
        let setup = Setup { separation: 0.0, ..Setup::SECTION_3 };
        let [rear, front] = AXLES;
        let ratio = (1.9_f64 / 0.1).sqrt();
        for (x, expected) in [(-1e5, ratio), (1e5, 1.0 / ratio)] {
            let time = time_when_seen_at(&setup, x).expect("inside the domain");
            let seen = |rest| seen_by_one(&setup, rest, time).expect("inside the domain")[0];
            let stretch = (seen(front) - seen(rear)) / (front[0] - rear[0]);
            assert!((stretch / expected - 1.0).abs() < 1e-6, "{stretch}");
        }
    }
}
