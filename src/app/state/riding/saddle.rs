//! The saddle: what a rider asks for, and does just now.

use glam::DVec3;
use relativity_core::{ObserverVelocity, Speed};

use crate::flags::StreetVelocity;
use crate::flags::choices::Layout;
use crate::settings::{Rider, Riding};

/// A command of the rider.
#[derive(Debug, Clone, PartialEq)]
pub enum RideCommand {
    /// Gets on the bicycle, or off it.
    Toggle,
    /// Rides in this way from now on: the speed at the start, the place and the legs.
    Set(Riding),
    /// Pedals or brakes until this speed is reached.
    Reach(StreetVelocity),
    /// Faces where one moves: the head and the gaze, as high as that was.
    Face,
    /// Shows the keys, the odometers and the place again for a while.
    Remind,
    /// Pushes in this direction for this step of the rider's clock.
    Push(PushDirection, f64),
}

/// The direction of a push.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PushDirection {
    /// A push where the rider moves; along the line of the ride at rest.
    Forwards,
    /// A push against that.
    Backwards,
    /// A push in a direction given in degrees to the left of the gaze.
    Beside(i16),
}

/// Walks are pushed along directions that are so far apart, degrees: a head that turns does not make a leg in
/// every frame.
const DEGREES_OF_WALKS: f64 = 5.0;
/// Greatest sine of the angle between a push and the motion at which both still count as along one line.
const ALONG: f64 = 1e-9;
/// A smaller rapidity is none: what rounding leaves of one that was braked away.
const AT_REST: f64 = 1e-12;

/// The saddle: what the rider does just now.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Saddle {
    /// Whether the rider steers, so that the ride does not end with its last leg.
    pub is_taken: bool,
    /// The push that is held.
    pub push: Option<Push>,
    /// The layout before one got on, which getting off gives back.
    pub layout_before: Option<Layout>,
    /// Number of requests for keys, odometers and place.
    pub requests: u32,
}

/// A push that is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Push {
    /// Direction of the push.
    pub direction: PushDirection,
    /// Unit vector of the push in the axes of the head, along the line of the ride, to its left and up.
    pub towards: [f64; 3],
    /// Whether the push brakes: then it ends at rest.
    pub brakes: bool,
}

impl Push {
    /// Returns the push that `rider` begins in this `direction`. The gaze `looks` to the left of the line of
    /// the ride by this angle, degrees.
    #[must_use]
    pub fn new(direction: PushDirection, looks: f64, rider: &Rider) -> Self {
        let ahead = rider.ahead;
        let towards = match direction {
            PushDirection::Forwards => ahead,
            PushDirection::Backwards => ahead.map(|part| 0.0 - part),
            PushDirection::Beside(degrees) => {
                let steps = ((looks + f64::from(degrees)) / DEGREES_OF_WALKS).round();
                ObserverVelocity::new(Speed::REST, (steps * DEGREES_OF_WALKS).to_radians(), 0.0).direction()
            }
        };
        let [way, motion] = [towards, ahead].map(DVec3::from);
        let (along, aside) = (way.dot(motion), way.cross(motion).length());
        let rapidity = rider.velocity.rapidity();
        let brakes = rapidity.abs() > AT_REST && along * rapidity < 0.0 && aside < ALONG;
        Self { direction, towards, brakes }
    }

    /// The part of `step` for which it is pushed at this proper `acceleration`: who brakes comes to rest, and
    /// pushes off the other way by another push.
    #[must_use]
    pub fn duration(&self, step: f64, acceleration: f64, rider: &Rider) -> f64 {
        let rapidity = rider.velocity.rapidity().abs();
        match self.brakes {
            true if rapidity <= AT_REST => 0.0,
            true => step.min(rapidity / acceleration),
            false => step,
        }
    }
}
