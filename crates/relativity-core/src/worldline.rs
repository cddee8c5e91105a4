//! Events along x, frames that move along x, and the worldlines of clocks at rest in them.
//!
//! y and z are what they are in every such frame. A [`Boost`] moves either way; functions of a [`Speed`]
//! alone are of what moves along +x.
//!
//! # Accuracy
//!
//! As [`crate::sighting`]: events in another frame, clocks, places and times of reception (`tests/oracle`,
//! 15,000 inputs, both ways): median 0.2, 99 % 1.5, worst 2.9 units.

use crate::MAX_GAMMA;
use crate::math;
use crate::source::SourcePoint;
use crate::speed::Speed;

/// Below this beta a frame is slow: [`Event::in_frame`] says what that decides.
const SLOW: f64 = 0.5;

/// An event: a place along x and a time. Of a step from one event to another both are differences.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Place along x.
    pub x: f64,
    /// The time, by the clocks of the frame.
    pub t: f64,
}

/// A boost along x: from one frame, the ground, to a frame that moves against it.
///
/// # Examples
///
/// ```
/// use relativity_core::{Boost, Event, Speed};
///
/// let oncoming = Boost { speed: Speed::from_beta(0.6)?, is_backward: true };
/// let there = Event { x: 0.0, t: 4.0 }.in_frame(oncoming);
/// assert!((there.x - 3.0).abs() < 1e-15 && (there.t - 5.0).abs() < 1e-15);
/// # Ok::<(), relativity_core::SpeedError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boost {
    /// Magnitude of the velocity.
    pub speed: Speed,
    /// Whether it points towards -x.
    pub is_backward: bool,
}

/// The worldline of a clock that rests in a frame which moves along x, by the ground's coordinates. All
/// clocks of that frame are set alike there, and the one at its origin shows 0 at the ground's origin.
///
/// # Examples
///
/// ```
/// use relativity_core::{Event, Speed, Worldline};
///
/// // A clock that passes x = -3 at t = -5 at 0.6 c is at x = 0 at t = 0, and shows 0 there; at t = -5 it
/// // showed -5/gamma.
/// let clock = Worldline::new(Speed::from_beta(0.6)?, 0.0);
/// assert_eq!(clock.at(-5.0), Event { x: -3.0, t: -5.0 });
/// assert!((clock.proper_time(-5.0) + 4.0).abs() < 1e-15);
/// # Ok::<(), relativity_core::SpeedError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worldline {
    boost: Boost,
    x0: f64,
}

impl Event {
    /// Returns the event in the frame that moves at `frame`, its origin being the same event.
    ///
    /// Of a fast frame t - x and t + x are scaled, by the head-on Doppler factor, so that what is on one
    /// light ray stays on one. A slow one hardly mixes x and t, and there that would lose the digits of the
    /// smaller.
    #[must_use]
    pub fn in_frame(self, frame: impl Into<Boost>) -> Self {
        let boost = frame.into();
        let Boost { speed, is_backward } = boost;
        if speed.beta() < SLOW {
            let (gamma, proper) = (speed.gamma(), boost.direction() * speed.proper());
            return Self { x: gamma * self.x - proper * self.t, t: gamma * self.t - proper * self.x };
        }
        let factor = speed.head_on_doppler_factor();
        let factor = if is_backward { 1.0 / factor } else { factor };
        let (outgoing, incoming) = (factor * (self.t - self.x), (self.t + self.x) / factor);
        Self { x: 0.5 * (incoming - outgoing), t: 0.5 * (incoming + outgoing) }
    }

    /// Returns the event a `step` away.
    #[must_use]
    pub fn plus(self, step: Self) -> Self {
        Self { x: self.x + step.x, t: self.t + step.t }
    }

    /// Returns the event at `x` that is at the same time as this one by the clocks of the frame that moves at
    /// `frame`.
    #[must_use]
    pub fn simultaneous_at(self, x: f64, frame: impl Into<Boost>) -> Self {
        Self { x, t: self.t + frame.into().beta() * (x - self.x) }
    }
}

impl Boost {
    /// v/c, negative towards -x.
    #[must_use]
    pub fn beta(&self) -> f64 {
        self.direction() * self.speed.beta()
    }

    const fn direction(&self) -> f64 {
        if self.is_backward { -1.0 } else { 1.0 }
    }

    /// From the rapidity, negative towards -x; of one beyond [`MAX_GAMMA`] that.
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "the greatest gamma is a speed")]
    pub fn from_rapidity(rapidity: f64) -> Self {
        let speed = Speed::from_rapidity(rapidity.abs()).or_else(|_| Speed::from_gamma(MAX_GAMMA));
        Self { speed: speed.expect("the greatest gamma is one"), is_backward: rapidity < 0.0 }
    }

    /// Returns the rapidity along +x, below 0 for the other way.
    #[must_use]
    pub fn rapidity(&self) -> f64 {
        self.direction() * self.speed.rapidity()
    }

    /// Returns this velocity in the frame that moves at `frame`: rapidities subtract.
    #[must_use]
    pub fn seen_from(self, frame: impl Into<Self>) -> Self {
        let frame = frame.into();
        if frame.speed == Speed::REST {
            return self;
        }
        if self.speed == Speed::REST {
            return Self { is_backward: !frame.is_backward, ..frame };
        }
        // Two that fly apart at the greatest gamma part no faster than that.
        Self::from_rapidity(self.rapidity() - frame.rapidity())
    }

    /// Returns the step that a clock which moves so makes in a unit of the ground's time, in the frame that
    /// moves at `frame`: 1/gamma of its own time there, which the frame's clocks have as gamma of the
    /// velocity between the two. A clock that rests in the frame has no step along x, exactly.
    ///
    /// # Accuracy
    ///
    /// Within (1 + H1 + H2) [`crate::MAX_ERROR_UNITS`], of the rapidities H1 of the clock and H2 of the
    /// frame: a rounding of a rapidity H changes gamma by H roundings.
    #[must_use]
    pub fn unit_step_in(self, frame: impl Into<Self>) -> Event {
        let relative = self.seen_from(frame);
        let t = relative.speed.gamma() / self.speed.gamma();
        Event { x: relative.beta() * t, t }
    }

    /// Returns the reading, at the ground's time `t`, of the clock at `rest_x` in the frame that moves so:
    /// the proper time on [`Worldline::at_rest`], with one rounding less.
    #[must_use]
    pub fn clock_reading(&self, rest_x: f64, t: f64) -> f64 {
        t / self.speed.gamma() - self.beta() * rest_x
    }

    /// Returns the step on the ground between two events at one time of the frame, the second `length`
    /// further along +x there.
    #[must_use]
    pub fn simultaneous_step(&self, length: f64) -> Event {
        let gamma = self.speed.gamma();
        Event { x: gamma * length, t: gamma * self.beta() * length }
    }
}

impl From<Speed> for Boost {
    fn from(speed: Speed) -> Self {
        Self { speed, is_backward: false }
    }
}

impl Worldline {
    /// The worldline through `x0` at the ground's time 0.
    #[must_use]
    pub fn new(boost: impl Into<Boost>, x0: f64) -> Self {
        Self { boost: boost.into(), x0 }
    }

    /// The worldline of the clock at `rest_x` in the frame that moves at `boost`.
    #[must_use]
    pub fn at_rest(boost: impl Into<Boost>, rest_x: f64) -> Self {
        let boost = boost.into();
        Self { x0: rest_x / boost.speed.gamma(), boost }
    }

    /// The event of the clock at the ground's time `t`.
    #[must_use]
    pub fn at(&self, t: f64) -> Event {
        Event { x: self.x0 + self.boost.beta() * t, t }
    }

    /// Returns the reading of the clock at the ground's time `t`.
    #[must_use]
    pub fn proper_time(&self, t: f64) -> f64 {
        let gamma = self.boost.speed.gamma();
        t / gamma - gamma * self.boost.beta() * self.x0
    }

    /// Returns how far along +x the clock is from an `event` on the ground, as measured in the frame in which
    /// it rests: gamma times as far as it is on the ground then.
    #[must_use]
    pub fn rest_distance_from(&self, event: Event) -> f64 {
        self.boost.speed.gamma() * (self.at(event.t).x - event.x)
    }

    /// The event at which the clock shows `proper_time`.
    #[must_use]
    pub fn at_proper_time(&self, proper_time: f64) -> Event {
        let (beta, gamma) = (self.boost.beta(), self.boost.speed.gamma());
        Event {
            x: gamma * (beta * proper_time + gamma * self.x0),
            t: gamma * (proper_time + gamma * beta * self.x0),
        }
    }

    /// Returns the velocity of the clock on the ground.
    #[must_use]
    pub const fn boost(&self) -> Boost {
        self.boost
    }

    /// The ground's time at which the clock is at `x`; `None` if it rests, or would take longer than any f64.
    #[must_use]
    pub fn time_at(&self, x: f64) -> Option<f64> {
        Some((x - self.x0) / self.boost.beta()).filter(|time| time.is_finite())
    }

    /// Returns the time of reception at the ground's origin of the light that leaves the clock at the
    /// ground's time `t`, the line along which it moves being `aside` from there.
    #[must_use]
    pub fn reception(&self, t: f64, aside: f64) -> f64 {
        // Mirrored to move along +x.
        let (x0, beta) = (self.boost.direction() * self.x0, self.boost.speed.beta());
        let x = x0 + beta * t;
        let distance = math::hypot(x, aside);
        if x < 0.0 && t < 0.0 {
            // t + distance, of which at high speed little is left, without the subtraction.
            return aside * (aside / (distance - x)) + (self.boost.speed.one_minus_beta() * t - x0);
        }
        t + distance
    }
}

impl SourcePoint {
    /// The worldline of a point that moves along +x at `speed`.
    #[must_use]
    pub fn worldline(self, speed: &Speed) -> Worldline {
        Worldline::new(*speed, self.x0)
    }
}
