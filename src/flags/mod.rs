//! Types of flags that several commands and the window share.

pub mod choices;

use clap::{Args, ValueEnum};
use relativity_core::{Speed, SpeedError};
use serde::{Deserialize, Serialize};

/// What draws.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize, Deserialize)]
pub enum RendererChoice {
    /// A ray test per pixel on the GPU, in f32.
    #[default]
    Exact,
    /// Triangles on the GPU.
    Mesh,
    /// A ray test per pixel on the CPU, in f64.
    Reference,
}

/// The three ways to give a speed: a flag each, and a column of a CSV file each.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum SpeedParameter {
    /// v/c.
    Beta,
    /// The Lorentz factor.
    Gamma,
    /// atanh(beta).
    Rapidity,
}

impl SpeedParameter {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Beta, Self::Gamma, Self::Rapidity];

    /// Its name as a flag and as a column.
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
    /// Speed as v/c, 0 <= beta < 1.
    #[arg(long, value_parser = finite_number, allow_hyphen_values = true)]
    pub beta: Option<f64>,
    /// Speed as Lorentz factor, 1 <= gamma <= 1e30.
    #[arg(long, value_parser = finite_number, allow_hyphen_values = true)]
    pub gamma: Option<f64>,
    /// Speed as rapidity atanh(beta), 0 to 69.77.
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

    /// The speed asked for, or `default_beta` if none was.
    pub fn speed(&self, default_beta: f64) -> anyhow::Result<Speed> {
        let (parameter, value) = self.parameter(default_beta);
        Ok(parameter.speed(value)?)
    }
}

/// Parses a flag's value: f64's own parser also takes `nan` and `inf`, which no flag means.
pub fn finite_number(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err("not a finite number".to_owned()),
        Err(_) => Err("not a number".to_owned()),
    }
}

/// Parses a number above 0.
pub fn positive(text: &str) -> Result<f64, String> {
    let value = finite_number(text)?;
    if value > 0.0 { Ok(value) } else { Err("must be above 0".to_owned()) }
}
