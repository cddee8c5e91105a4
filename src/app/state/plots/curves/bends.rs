//! The times around which curves bend: as the point passes, and at every turn of a wheel that it is on.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use relativity_core::math;
use relativity_core::{
    Aperture, Event, Source, Speed, WheelPoint, equidistance_time, observation_time_when_seen_at, sighting,
};

use crate::time_range::time_within;

/// Number of parts of the range, in which less than a quarter of a turn is seen where turns can be
/// distinguished: there a turn is two pixels of a plot wide, or wider.
const CELLS: u32 = 512;
/// Steps of a turn, at each of which there is a sample: from pi/2 on they fall by pi/4.
const STEPS: f64 = 8.0;

/// The bends of curves in a range of T.
#[derive(Debug, Clone, Default)]
pub struct Bends {
    /// Times of the passage: T0, when the point is objectively abreast of each eye, and when that sees it
    /// there.
    pub passage: Vec<f64>,
    /// When the point of a wheel has turned by eighths of a turn from its lowest place, as each eye and the
    /// middle between them sees it and as it is measured.
    pub turns: Vec<f64>,
    /// End of the range in which it turns too fast for turns to be distinguished: there it is drawn only
    /// where it is lowest, highest, or moves along the line of sight, now on one side and now on the other,
    /// and the line fills what it moves in.
    pub blurred_until: Option<f64>,
}

impl Bends {
    /// Returns the bends for `source`, which moves along +x, before a `pair` of eyes in this `range` of T.
    #[must_use]
    pub fn new(speed: &Speed, source: impl Into<Source>, pair: [Aperture; 2], range: [f64; 2]) -> Self {
        let source = source.into();
        let bends = Self { passage: passage(speed, source, pair), ..Self::default() };
        match source {
            Source::Point(_) => bends,
            Source::Wheel(wheel) => bends.with_turns(speed, &wheel, pair, range),
        }
    }

    /// With those of the turns of `wheel`.
    fn with_turns(mut self, speed: &Speed, wheel: &WheelPoint, pair: [Aperture; 2], range: [f64; 2]) -> Self {
        let [left, right] = pair;
        let middle = Aperture {
            x: left.x.midpoint(right.x),
            y: left.y.midpoint(right.y),
            z: left.z.midpoint(right.z),
        };
        for eye in [left, middle, right] {
            let turning = SeenTurning { speed, wheel, eye };
            // How many steps its hub's clock tells by each of these times.
            let counted: Vec<_> = (0..=CELLS)
                .map(|cell| time_within(range, f64::from(cell) / f64::from(CELLS)))
                .filter_map(|time| Some((time, turning.steps_at(time)?)))
                .collect();
            let is_blurred = |ends: &&[(f64, f64)]| (ends[1].1 - ends[0].1).abs() > 0.25 * STEPS;
            let blurred = counted.windows(2).rev().find(is_blurred).map(|ends| ends[1].0);
            self.blurred_until = later(self.blurred_until, blurred);
            let within = counted.iter().take_while(|(time, _)| Some(*time) <= blurred);
            for (index, &(time, steps)) in within.enumerate() {
                let half = STEPS * (steps / STEPS).round() + 0.5 * STEPS * (index % 2) as f64;
                let ends = [half, half + turning.along_sight(time)];
                self.turns.extend(ends.into_iter().filter_map(|steps| turning.time_of(steps)));
            }
            let after = counted.iter().filter(|(time, _)| Some(*time) >= blurred).map(|(_, steps)| *steps);
            let (first, last) = after.fold((f64::INFINITY, f64::NEG_INFINITY), |(first, last), steps| {
                (first.min(steps), last.max(steps))
            });
            // The point may be seen a little later or sooner than the hub.
            let around = [first - STEPS / 4.0, last + STEPS / 4.0];
            let steps = whole(around).flat_map(|step| close_by(speed, step).chain([step]));
            self.turns.extend(steps.filter_map(|steps| turning.time_of(steps)));
        }
        self.turns.extend(measured(speed, wheel, range));
        self
    }
}

/// The later of two times, of which either may be none.
fn later(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    if a > b { a } else { b }
}

/// Returns the whole numbers from `first` to `last`; only the first if they are too many to be distinguished.
fn whole([first, last]: [f64; 2]) -> impl Iterator<Item = f64> {
    let most = f64::from(CELLS) * STEPS;
    let count = (last.floor() - first.ceil() + 1.0).clamp(0.0, most) as u32;
    (0..count).map(move |index| first.ceil() + f64::from(index))
}

/// Returns the times around a whole step at which the point is highest or lowest: there it moves towards the
/// eyes or away from them, and is seen to be blue or red within an angle of 1/gamma.
fn close_by(speed: &Speed, step: f64) -> impl Iterator<Item = f64> {
    let is_end = step.rem_euclid(0.5 * STEPS) == 0.0;
    let offsets = [0.5, 1.0, 2.0, 4.0].map(|parts| parts / (speed.gamma() * FRAC_PI_4));
    let within = offsets.into_iter().filter(move |offset| is_end && *offset < 1.0);
    within.flat_map(move |offset| [step - offset, step + offset])
}

/// When the point of `wheel` is measured to have turned by whole steps.
fn measured(speed: &Speed, wheel: &WheelPoint, range: [f64; 2]) -> Vec<f64> {
    let hub = wheel.hub.worldline(speed);
    let ends = range.map(|time| steps(speed, wheel, hub.proper_time(time)));
    let time = |steps: f64| {
        let proper_time = proper_time_of(speed, wheel, steps)?;
        let place = wheel.place_at(speed, proper_time);
        Some(place.worldline(speed).at_proper_time(proper_time).t)
    };
    whole([ends[0].min(ends[1]), ends[0].max(ends[1])]).filter_map(time).collect()
}

/// Returns the number of steps from its highest place that `wheel` has turned by this proper time.
fn steps(speed: &Speed, wheel: &WheelPoint, proper_time: f64) -> f64 {
    (FRAC_PI_2 - wheel.angle_at(speed, proper_time)) / FRAC_PI_4
}

/// Returns the proper time by which it has turned by this number of steps.
fn proper_time_of(speed: &Speed, wheel: &WheelPoint, steps: f64) -> Option<f64> {
    let proper_time = (wheel.angle - FRAC_PI_2 + FRAC_PI_4 * steps) / wheel.omega(speed);
    Some(proper_time).filter(|time| time.is_finite())
}

/// The turning of a wheel's point as an eye sees it.
struct SeenTurning<'a> {
    speed: &'a Speed,
    wheel: &'a WheelPoint,
    eye: Aperture,
}

impl SeenTurning<'_> {
    /// Returns the number of steps that the wheel has turned by the time that the clock at its hub is seen to
    /// show at `time`.
    fn steps_at(&self, time: f64) -> Option<f64> {
        let hub = sighting(self.speed, self.wheel.hub, self.eye, time).ok()?;
        Some(steps(self.speed, self.wheel, hub.proper_time)).filter(|steps| steps.is_finite())
    }

    /// Around 0, how many steps from its highest place a point moves along the line of sight at `time`,
    /// towards the eye or away.
    fn along_sight(&self, time: f64) -> f64 {
        let Self { speed, wheel, eye } = *self;
        let x = wheel.hub.worldline(speed).rest_distance_from(Event { x: eye.x, t: time });
        let steps = -math::atan2(wheel.hub.z - eye.z, x) / FRAC_PI_4;
        steps - 0.5 * STEPS * (steps / (0.5 * STEPS)).round()
    }

    /// Returns the time when the point is seen to have turned by this number of steps.
    fn time_of(&self, steps: f64) -> Option<f64> {
        let Self { speed, wheel, eye } = *self;
        let proper_time = proper_time_of(speed, wheel, steps)?;
        let place = wheel.place_at(speed, proper_time);
        let there = place.worldline(speed).at_proper_time(proper_time);
        observation_time_when_seen_at(speed, place, there.x - eye.x, [eye; 2]).ok().flatten()
    }
}

/// The times around which curves of what passes bend.
fn passage(speed: &Speed, source: Source, pair: [Aperture; 2]) -> Vec<f64> {
    let point = source.place();
    let equidistant = equidistance_time(speed, source, pair).ok().flatten();
    let abreast = pair.map(|aperture| point.worldline(speed).time_at(aperture.x));
    let seen = pair.map(|eye| observation_time_when_seen_at(speed, point, 0.0, [eye; 2]).ok().flatten());
    equidistant.into_iter().chain(abreast.into_iter().flatten()).chain(seen.into_iter().flatten()).collect()
}
