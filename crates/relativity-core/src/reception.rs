//! Receptions of light, in the frame of what sent it.
//!
//! # Accuracy
//!
//! The event in the frame is as accurate as [`crate::sighting`] (`tests/oracle`). A time of emission is
//! within [`crate::MAX_ERROR_UNITS`] roundings of gamma (|x| + |t|) + |x'| + |y| + |z|, with x and t of the
//! reception on the ground, and x', y and z of the place in the frame. Long after a passage it is as accurate
//! as [`crate::sighting`].

use crate::speed::Speed;
use crate::stereo::dot;
use crate::worldline::Event;

/// A reception of light, in a frame that moves along +x.
///
/// # Examples
///
/// ```
/// use relativity_core::{Event, Reception, Speed};
///
/// // A clock that passed an eye at its time 0 is seen long after: it shows T over the Doppler factor,
/// // though the eye's place and time are by then 2e6 times as large in its frame.
/// let speed = Speed::from_gamma(1e3)?;
/// let eye = Reception::new(Event { x: 0.0, t: 1e9 }, &speed);
/// let shown = 1e9 / speed.head_on_doppler_factor();
/// assert!((eye.emission_time(0.0, [0.0; 2]) / shown - 1.0).abs() < 1e-15);
/// # Ok::<(), relativity_core::SpeedError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reception {
    event: Event,
    /// t + x and t - x of the event, with the digits that these sums lose where it is far away in the frame.
    cone_times: [f64; 2],
}

impl Reception {
    /// The reception at an event `on_ground`, in the frame that moves at `speed`; both have one origin.
    #[must_use]
    pub fn new(on_ground: Event, speed: &Speed) -> Self {
        let (Event { x, t }, beta, gamma) = (on_ground, speed.beta(), speed.gamma());
        let head_on = speed.head_on_doppler_factor();
        Self {
            event: Event { x: gamma * (x - beta * t), t: gamma * (t - beta * x) },
            cone_times: [(t + x) / head_on, (t - x) * head_on],
        }
    }

    /// The reception at an `event` that is given in the frame already.
    #[must_use]
    pub fn in_frame(event: Event) -> Self {
        let Event { x, t } = event;
        Self { event, cone_times: [t + x, t - x] }
    }

    /// Returns the event in the frame: gamma (x - beta t) and gamma (t - beta x).
    #[must_use]
    pub const fn event(&self) -> Event {
        self.event
    }

    /// Returns the time in the frame at which the light that is received left a place at this `x`, its y and
    /// z being `aside` of those of the reception: t - R.
    ///
    /// After t = 0 it is (t^2 - R^2)/(t + R): what is seen long after it has passed is about as far as that
    /// is long.
    #[must_use]
    pub fn emission_time(&self, x: f64, aside: [f64; 2]) -> f64 {
        let Self { event, cone_times: [plus_x, minus_x] } = *self;
        let [y, z] = aside;
        let from_event = [x - event.x, y, z];
        let distance = dot(from_event, from_event).sqrt();
        if event.t <= 0.0 {
            return event.t - distance;
        }
        ((plus_x - x) * (minus_x + x) - y * y - z * z) / (event.t + distance)
    }
}
