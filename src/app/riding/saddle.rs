//! The saddle: what a rider asks for, and does just now.

use crate::flags::StreetVelocity;
use crate::settings::Riding;

/// A command of the rider.
#[derive(Debug, Clone, PartialEq)]
pub enum RideCommand {
    /// Get on the bicycle, or off it.
    Toggle,
    /// Ride in this way from now on: the speed at the start, the place and the legs.
    Set(Riding),
    /// Pedal or brake until this speed is reached.
    Reach(StreetVelocity),
    /// Pedals pushed towards +x (1) or -x (-1) for this step of the rider's clock.
    Push(Direction, f64),
}

/// The direction of a push along the street.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// A push towards +x.
    Forwards,
    /// A push towards -x.
    Backwards,
}

impl Direction {
    /// 1 towards +x, -1 towards -x.
    #[must_use]
    pub const fn sign(self) -> f64 {
        match self {
            Self::Forwards => 1.0,
            Self::Backwards => -1.0,
        }
    }
}

/// The saddle: what the rider does just now.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Saddle {
    /// Whether the rider steers, so that the ride does not end with its last leg.
    pub is_taken: bool,
    /// The push that is held.
    pub push: Option<Push>,
}

/// A push that is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Push {
    /// Direction of the push.
    pub direction: Direction,
    /// Whether the push brakes: then it ends at rest.
    pub brakes: bool,
}
