//! The course of the observation time. The wall clock's step is an argument, so that tests decide it.

use crate::flags::MAX_TIME;
use relativity_core::math;

/// T after a step of the wall clock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClockTick {
    /// The new observation time.
    pub time: f64,
    /// Whether playback goes on from there.
    pub playing: bool,
}

/// T that was `time`, after `step` seconds of the wall clock at `rate` units per second, inside `range`.
///
/// At the end it starts again if `looping`, else stops. A time outside the range enters it first.
#[must_use]
pub fn advanced(time: f64, step: f64, rate: f64, looping: bool, range: [f64; 2]) -> ClockTick {
    let [from, to] = range;
    let next = time.clamp(from, to) + rate * step;
    if next < to {
        return ClockTick { time: next, playing: true };
    }
    if looping && to > from {
        ClockTick { time: from + (next - to).rem_euclid(to - from), playing: true }
    } else {
        ClockTick { time: to, playing: false }
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
    use crate::settings::Preset;

    #[test]
    fn playing_loops_or_stops_at_the_end() {
        let range = [0.0, 10.0];
        assert_eq!(advanced(9.0, 0.5, 1.0, true, range), ClockTick { time: 9.5, playing: true });
        assert_eq!(advanced(9.0, 1.5, 1.0, true, range), ClockTick { time: 0.5, playing: true });
        assert_eq!(advanced(9.0, 1.5, 1.0, false, range), ClockTick { time: 10.0, playing: false });
        assert_eq!(advanced(-50.0, 1.0, 2.0, true, range), ClockTick { time: 2.0, playing: true });
        assert_eq!(advanced(5.0, 1.0, 1.0, true, [3.0, 3.0]), ClockTick { time: 3.0, playing: false });
    }

    /// Each moment of a ride is computed without those before it.
    #[test]
    fn a_ride_ends_alike_at_5_and_at_120_frames_a_second() {
        let ride = &Preset::named("ride-twins").expect("a preset").settings.ride;
        let [slow, fast] = [5.0, 120.0].map(|frames: f64| {
            let mut tick = ClockTick { time: 0.0, playing: true };
            let mut frame = 0.0;
            while tick.playing {
                tick = advanced(tick.time, 1.0 / frames, 1.0, false, [0.0, ride.duration()]);
                frame += 1.0;
            }
            assert!((frame / frames - ride.duration()).abs() < 1.5 / frames, "{frame}");
            ride.rider(tick.time)
        });
        assert_eq!(slow, fast);
    }

    #[test]
    fn steps_are_round_numbers() {
        assert!((step_size([0.0, 20.0]) - 0.1).abs() < 1e-12);
        assert!((step_size([0.0, 9.0]) - 0.05).abs() < 1e-12);
    }
}
