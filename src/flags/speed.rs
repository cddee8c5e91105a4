//! A speed, given in exactly one of three ways, and kept as it was given.

use clap::error::ErrorKind;
use clap::{ArgMatches, Args, Command, FromArgMatches};
use relativity_core::{Speed, SpeedError};
use serde::{Deserialize, Serialize, Serializer};

use super::finite_number;

/// The three ways to give a speed: a flag each, and a column of a CSV file each.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum SpeedParameter {
    /// Speed over c, beta.
    Beta,
    /// Lorentz factor, gamma.
    Gamma,
    /// Rapidity, atanh(beta).
    Rapidity,
}

impl SpeedParameter {
    /// Every parameter of a speed.
    pub const ALL: [Self; 3] = [Self::Beta, Self::Gamma, Self::Rapidity];

    /// Returns the name of the flag and of the column.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Beta => "beta",
            Self::Gamma => "gamma",
            Self::Rapidity => "rapidity",
        }
    }

    /// The speed whose parameter has this `value`.
    pub fn speed(self, value: f64) -> Result<Speed, SpeedError> {
        match self {
            Self::Beta => Speed::from_beta(value),
            Self::Gamma => Speed::from_gamma(value),
            Self::Rapidity => Speed::from_rapidity(value),
        }
    }
}

/// A speed, given in exactly one of three ways.
#[derive(Debug, Clone, Copy, Args)]
#[group(multiple = false)]
pub struct SpeedArgs {
    /// Speed as β = v/c, from 0 to below 1.
    #[arg(long, value_parser = finite_number, allow_hyphen_values = true)]
    pub beta: Option<f64>,
    /// Speed as Lorentz factor γ = 1/√(1 − β²), from 1 to 1e30.
    #[arg(long, value_parser = finite_number, allow_hyphen_values = true)]
    pub gamma: Option<f64>,
    /// Speed as rapidity η = artanh β, from 0 to 69.77.
    #[arg(long, value_parser = finite_number, allow_hyphen_values = true)]
    pub rapidity: Option<f64>,
}

impl SpeedArgs {
    /// The parameter given and its value.
    #[must_use]
    pub fn given(&self) -> Option<(SpeedParameter, f64)> {
        SpeedParameter::ALL
            .into_iter()
            .zip([self.beta, self.gamma, self.rapidity])
            .find_map(|(parameter, value)| Some((parameter, value?)))
    }

    /// The parameter given and its value, or `default_beta` if none was.
    #[must_use]
    pub fn parameter(&self, default_beta: f64) -> (SpeedParameter, f64) {
        self.given().unwrap_or((SpeedParameter::Beta, default_beta))
    }

    /// Returns the given speed, or `default_beta` without one.
    pub fn speed(&self, default_beta: f64) -> anyhow::Result<Speed> {
        let (parameter, value) = self.parameter(default_beta);
        Ok(parameter.speed(value)?)
    }
}

/// A speed that is in range, in the parameter it was given in: what was typed is what is kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpeedSetting {
    parameter: SpeedParameter,
    value: f64,
    speed: Speed,
}

impl SpeedSetting {
    /// Speed 0, given by beta.
    pub const REST: Self = Self { parameter: SpeedParameter::Beta, value: 0.0, speed: Speed::REST };

    /// The speed whose `parameter` has this `value`.
    ///
    /// # Errors
    /// A value out of range.
    pub fn new(parameter: SpeedParameter, value: f64) -> Result<Self, SpeedError> {
        Ok(Self { parameter, value, speed: parameter.speed(value)? })
    }

    /// The parameter it was given in, and its value.
    #[must_use]
    pub const fn given(&self) -> (SpeedParameter, f64) {
        (self.parameter, self.value)
    }

    /// Returns the speed itself.
    #[must_use]
    pub const fn speed(&self) -> Speed {
        self.speed
    }
}

impl Serialize for SpeedSetting {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map([(self.parameter.name(), self.value)])
    }
}

impl Args for SpeedSetting {
    fn augment_args(command: Command) -> Command {
        SpeedArgs::augment_args(command)
    }

    fn augment_args_for_update(command: Command) -> Command {
        SpeedArgs::augment_args_for_update(command)
    }
}

impl FromArgMatches for SpeedSetting {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut speed = Self::REST;
        speed.update_from_arg_matches(matches)?;
        Ok(speed)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        if let Some((parameter, value)) = SpeedArgs::from_arg_matches(matches)?.given() {
            let speed = Self::new(parameter, value);
            *self = speed.map_err(|error| clap::Error::raw(ErrorKind::ValueValidation, error))?;
        }
        Ok(())
    }
}

/// A speed in a message to another instance of the program: as it was given.
pub mod given_speed {
    use serde::de::Error as _;
    use serde::{Deserialize as _, Deserializer, Serialize as _, Serializer};

    use super::{SpeedParameter, SpeedSetting};

    /// Writes the parameter and its value.
    pub fn serialize<S: Serializer>(speed: &SpeedSetting, serializer: S) -> Result<S::Ok, S::Error> {
        speed.given().serialize(serializer)
    }

    /// Reads the parameter and its value.
    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<SpeedSetting, D::Error> {
        let (parameter, value) = <(SpeedParameter, f64)>::deserialize(deserializer)?;
        SpeedSetting::new(parameter, value).map_err(D::Error::custom)
    }
}
