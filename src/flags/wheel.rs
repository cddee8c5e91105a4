//! Flags for a point on a rolling wheel.

use clap::Args;
use relativity_core::{Rolling, Source, SourcePoint, Turning, WheelPoint};

use super::finite_number;

/// The place of a point on a rolling wheel: all or none.
#[derive(Debug, Clone, Copy, Args)]
pub struct WheelArgs {
    /// The point is on a wheel of this radius, that rolls towards +x; --x0, --y and --z are then its hub's.
    #[arg(long, value_name = "W", value_parser = finite_number, allow_hyphen_values = true,
          requires_all = ["rho", "angle"])]
    wheel_radius: Option<f64>,
    /// Distance of the point from the hub, in radii of its wheel, 0 to 1.
    #[arg(long, value_parser = finite_number, allow_hyphen_values = true, requires = "wheel_radius")]
    rho: Option<f64>,
    /// Angle of the point at t' = 0 by the clocks that ride with the hub: from +x towards +z, radians.
    #[arg(long, value_name = "RAD", value_parser = finite_number, allow_hyphen_values = true,
          requires = "wheel_radius")]
    angle: Option<f64>,
}

impl WheelArgs {
    /// Radius, rho and angle, where they are given.
    #[must_use]
    pub fn given(&self) -> Option<[f64; 3]> {
        Some([self.wheel_radius?, self.rho?, self.angle?])
    }

    /// Radius, rho and angle for a fit.
    #[must_use]
    pub fn rolling(&self) -> Option<Rolling> {
        self.given().map(|[radius, rho, angle]| Rolling { radius, rho, angle })
    }

    /// The point at `place`, or the one of the wheel whose hub is there.
    #[must_use]
    pub fn source(&self, place: SourcePoint) -> Source {
        self.given().map_or_else(|| place.into(), |wheel| rolling(place, wheel))
    }
}

/// The point of a rolling wheel at a radius, a rho and an angle.
#[must_use]
pub fn rolling(hub: SourcePoint, [radius, rho, angle]: [f64; 3]) -> Source {
    WheelPoint { hub, radius, rho, angle, turning: Turning::Rolling }.into()
}
