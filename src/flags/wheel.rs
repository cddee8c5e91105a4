//! Where on a wheel that rolls a point is, as flags have it.

use clap::Args;
use relativity_core::Rolling;

use super::{finite_number, positive, within};

/// The wheel that a point turns with; y, z and x0 are then its hub's.
#[derive(Debug, Clone, Copy, Args)]
pub struct WheelArgs {
    /// The point is on a wheel that rolls on this radius: y, z and x0 are its hub's.
    #[arg(long, value_name = "W", value_parser = positive)]
    wheel_radius: Option<f64>,
    /// How far the point is from the axle, in radii of its wheel.
    #[arg(long, value_name = "R", default_value_t = 1.0, value_parser = within(0.0..=1.0), requires = "wheel_radius")]
    rho: f64,
    /// Its angle on the wheel when the wheel's own clock shows 0: radians from +x towards +z.
    #[arg(
        long, value_name = "A", default_value_t = 0.0, value_parser = finite_number, allow_hyphen_values = true,
        requires = "wheel_radius"
    )]
    angle: f64,
}

impl WheelArgs {
    /// Where the point is on its wheel; `None` of one that is on none.
    #[must_use]
    pub fn rolling(&self) -> Option<Rolling> {
        let &Self { wheel_radius, rho, angle } = self;
        wheel_radius.map(|radius| Rolling { radius, rho, angle })
    }
}
