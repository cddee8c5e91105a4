//! How the observation time runs. The wall clock's step is an argument, so tests decide what it is.

use relativity_core::math;
use relativity_core::{SourcePoint, Speed, observation_time_when_seen_at};

/// Largest magnitude of the observation time that the window accepts.
pub const MAX_TIME: f64 = 1e12;

/// Slowest beta that the fitted range makes room for; slower passages are shown in part.
const SLOWEST_FITTED_BETA: f64 = 0.2;
/// Smallest passing distance that the fitted range makes room for.
const NEAREST_FITTED_DISTANCE: f64 = 0.05;

/// T after a step of the wall clock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tick {
    /// The new observation time.
    pub time: f64,
    /// Whether it goes on from there.
    pub playing: bool,
}

/// T that was `time`, after `step` seconds of the wall clock at `rate` units per second, inside `range`.
///
/// At the end it starts again if `looping`, else stops. A time outside the range enters it first.
#[must_use]
pub fn advanced(time: f64, step: f64, rate: f64, looping: bool, range: [f64; 2]) -> Tick {
    let [from, to] = range;
    let next = time.clamp(from, to) + rate * step;
    if next < to {
        return Tick { time: next, playing: true };
    }
    if looping && to > from {
        Tick { time: from + (next - to).rem_euclid(to - from), playing: true }
    } else {
        Tick { time: to, playing: false }
    }
}

/// First and last T of a range that shows `point` approaching, abreast and receding.
#[must_use]
pub fn fitted_range(speed: &Speed, point: SourcePoint) -> [f64; 2] {
    let passage = Passage::new(speed, point);
    let (abreast, beta) = (passage.time_seen_at(0.0), passage.speed.beta());
    [-2.0, 3.0].map(|widths| bounded(abreast + widths * passage.nearest / beta))
}

/// When `point` is seen 45 degrees before it is abreast: near enough to look at, and still approaching.
#[must_use]
pub fn time_of_approach(speed: &Speed, point: SourcePoint) -> f64 {
    let passage = Passage::new(speed, point);
    bounded(passage.time_seen_at(-passage.nearest))
}

/// A passage that is neither too slow nor too near to be shown.
struct Passage {
    speed: Speed,
    x0: f64,
    nearest: f64,
}

impl Passage {
    fn new(speed: &Speed, point: SourcePoint) -> Self {
        let slowest = Speed::from_beta(SLOWEST_FITTED_BETA).expect("it is below 1");
        Self {
            speed: if speed.beta() < slowest.beta() { slowest } else { *speed },
            x0: point.x0,
            nearest: math::hypot(point.y, point.z).max(NEAREST_FITTED_DISTANCE),
        }
    }

    /// 0 outside the domain of the core.
    fn time_seen_at(&self, x: f64) -> f64 {
        let point = SourcePoint { x0: self.x0, y: self.nearest, z: 0.0 };
        observation_time_when_seen_at(&self.speed, point, x, 0.0).ok().flatten().unwrap_or_default()
    }
}

/// `time` inside the magnitudes that the window accepts.
#[must_use]
pub fn bounded(time: f64) -> f64 {
    // Beyond MAX_TIME a step of the scrubber would round away.
    if time.is_nan() { 0.0 } else { time.clamp(-MAX_TIME, MAX_TIME) }
}

/// A step of the scrubber: about 1/200 of the range, rounded to 1, 2 or 5 times a power of ten.
#[must_use]
pub fn step_size([from, to]: [f64; 2]) -> f64 {
    let ideal = ((to - from) / 200.0).max(1e-9);
    let decade = math::powf(10.0, math::log10(ideal).floor());
    let factor = match ideal / decade {
        ratio if ratio < 1.5 => 1.0,
        ratio if ratio < 3.5 => 2.0,
        ratio if ratio < 7.5 => 5.0,
        _ => 10.0,
    };
    factor * decade
}

#[cfg(test)]
mod tests {
    use super::*;
    use relativity_core::{Aperture, sighting};

    const TRACKED: SourcePoint = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };

    #[test]
    fn playing_loops_or_stops_at_the_end() {
        let range = [0.0, 10.0];
        assert_eq!(advanced(9.0, 0.5, 1.0, true, range), Tick { time: 9.5, playing: true });
        assert_eq!(advanced(9.0, 1.5, 1.0, true, range), Tick { time: 0.5, playing: true });
        assert_eq!(advanced(9.0, 1.5, 1.0, false, range), Tick { time: 10.0, playing: false });
        assert_eq!(advanced(-50.0, 1.0, 2.0, true, range), Tick { time: 2.0, playing: true });
        assert_eq!(advanced(5.0, 1.0, 1.0, true, [3.0, 3.0]), Tick { time: 3.0, playing: false });
    }

    #[test]
    fn fitted_range_shows_approach_and_recession() {
        for beta in [0.2, 0.6, 0.9, 0.9999] {
            let speed = Speed::from_beta(beta).expect("in range");
            let [from, to] = fitted_range(&speed, TRACKED);
            let x = |time| {
                sighting(&speed, TRACKED, Aperture::default(), time).expect("in the domain").position[0]
            };
            let distance = 3.0f64.hypot(2.0);
            assert!(x(from) < -2.0 * distance && x(to) > 0.8 * distance, "beta = {beta}");
        }
    }

    #[test]
    fn approach_is_seen_at_45_degrees() {
        let speed = Speed::from_beta(0.9).expect("in range");
        let time = time_of_approach(&speed, TRACKED);
        let seen = sighting(&speed, TRACKED, Aperture::default(), time).expect("in the domain");
        assert!((seen.position[0] + 3.0f64.hypot(2.0)).abs() < 1e-12);
    }

    #[test]
    fn steps_are_round_numbers() {
        assert!((step_size([0.0, 20.0]) - 0.1).abs() < 1e-12);
        assert!((step_size([0.0, 9.0]) - 0.05).abs() < 1e-12);
    }
}
