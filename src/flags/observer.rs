//! Flags for an observer who moves.

use clap::Args;

use super::{COORDINATES, HEAD_DEGREES, SpeedParameter, finite_number, within};

/// The motion of an observer, as given; a number that is not given is 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GivenObserver {
    /// The parameter that gives the speed, and its value.
    pub speed: Option<(SpeedParameter, f64)>,
    /// Azimuth and elevation of the velocity, degrees.
    pub direction: [f64; 2],
    /// Place on the ground of the middle between the eyes.
    pub place: [f64; 3],
}

/// Velocity and place of an observer.
#[derive(Debug, Clone, Copy, Args)]
pub struct ObserverArgs {
    #[command(flatten)]
    speed: ObserverSpeedArgs,
    /// Direction of the observer's motion, degrees from +x towards +y.
    #[arg(long, value_name = "DEG", value_parser = within(HEAD_DEGREES), allow_hyphen_values = true,
          hide_short_help = true)]
    observer_azimuth: Option<f64>,
    /// Elevation of the observer's motion, degrees up from the x-y plane.
    #[arg(long, value_name = "DEG", value_parser = within(HEAD_DEGREES), allow_hyphen_values = true,
          hide_short_help = true)]
    observer_elevation: Option<f64>,
    /// x of the middle between the eyes when the observer's clock shows 0, at T = 0.
    #[arg(long, value_name = "X", value_parser = within(COORDINATES), allow_hyphen_values = true,
          hide_short_help = true)]
    observer_x: Option<f64>,
    /// y of the middle between the eyes then.
    #[arg(long, value_name = "Y", value_parser = within(COORDINATES), allow_hyphen_values = true,
          hide_short_help = true)]
    observer_y: Option<f64>,
    /// z of the middle between the eyes then.
    #[arg(long, value_name = "Z", value_parser = within(COORDINATES), allow_hyphen_values = true,
          hide_short_help = true)]
    observer_z: Option<f64>,
}

/// An observer's speed, given in exactly one of three ways.
#[derive(Debug, Clone, Copy, Args)]
#[group(multiple = false)]
#[expect(clippy::struct_field_names, reason = "the flags are named so")]
struct ObserverSpeedArgs {
    /// The observer moves at this v/c, 0 <= beta < 1.
    #[arg(long, value_name = "BETA", value_parser = finite_number, allow_hyphen_values = true)]
    observer_beta: Option<f64>,
    /// The observer's Lorentz factor, 1 <= gamma <= 1e30.
    #[arg(long, value_name = "GAMMA", value_parser = finite_number, allow_hyphen_values = true,
          hide_short_help = true)]
    observer_gamma: Option<f64>,
    /// The observer's rapidity, 0 to 69.77.
    #[arg(long, value_name = "RAPIDITY", value_parser = finite_number, allow_hyphen_values = true,
          hide_short_help = true)]
    observer_rapidity: Option<f64>,
}

impl ObserverArgs {
    /// Returns how the observer moves; `None` without any of these flags.
    #[must_use]
    pub fn given(&self) -> Option<GivenObserver> {
        let ObserverSpeedArgs { observer_beta, observer_gamma, observer_rapidity } = self.speed;
        let speed = SpeedParameter::ALL
            .into_iter()
            .zip([observer_beta, observer_gamma, observer_rapidity])
            .find_map(|(parameter, value)| Some((parameter, value?)));
        let direction = [self.observer_azimuth, self.observer_elevation];
        let place = [self.observer_x, self.observer_y, self.observer_z];
        let is_given = speed.is_some() || direction.iter().chain(&place).any(Option::is_some);
        is_given.then(|| GivenObserver {
            speed,
            direction: direction.map(Option::unwrap_or_default),
            place: place.map(Option::unwrap_or_default),
        })
    }
}
