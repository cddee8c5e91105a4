//! The section of the fit: samples of the selected point, and what is fitted to them.

use std::ops::RangeInclusive;

use clap::{Args, ValueEnum};
use relativity_core::{Curves, Model, PublishedVariant};
use serde::Serialize;

use crate::flags::{OnOff, TimeRange, switch, whole_number, within};

/// Fewest and most samples that are fitted: their fit still takes less than a second.
pub const FIT_SAMPLES: RangeInclusive<usize> = 2..=5000;
/// Range of the noise, per cent.
pub const NOISE_PERCENT: RangeInclusive<f64> = 0.0..=100.0;
/// Largest seed: up to here a field of the window, whose numbers are `f64`, holds every whole number.
pub const MAX_SEED: u64 = 1 << f64::MANTISSA_DIGITS;

/// The fit of the selected point: the samples that both eyes take, and what is fitted to them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Fit")]
pub struct FitSettings {
    /// Number of samples of each curve, evenly spread over the range of T.
    #[arg(long, value_name = "N", value_parser = samples)]
    pub fit_samples: usize,
    /// Model by which the samples are simulated: that of the views, or another.
    #[arg(long, value_enum)]
    pub data_from: DataFrom,
    /// First and last T of the samples; `auto` takes the range that the plots show.
    #[arg(long, value_name = "auto|FROM,TO", allow_hyphen_values = true)]
    pub fit_range: TimeRange,
    /// Standard deviation of the normal noise on each sample, per cent of its curve's range: of the highest
    /// value less the lowest.
    #[arg(long, value_name = "PERCENT", value_parser = within(NOISE_PERCENT))]
    pub noise_percent: f64,
    /// Seed of the noise and of the bootstrap: the same seed gives the same numbers, another seed other noise
    /// of the same strength.
    #[arg(long, value_name = "S", value_parser = seed)]
    pub seed: u64,
    /// Curves that are fitted.
    #[arg(long, value_enum)]
    pub curves: Curves,
    /// The binocular model that is fitted.
    #[arg(long, value_enum)]
    pub model: Model,
    /// Whether x₀ is fitted too, the point's place at t = 0, as if the time of passage were unknown;
    /// otherwise x₀ is known.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub fit_x0: OnOff,
}

impl Default for FitSettings {
    fn default() -> Self {
        Self {
            fit_samples: 240,
            data_from: DataFrom::Views,
            fit_range: TimeRange(None),
            noise_percent: 1.0,
            seed: 1,
            curves: Curves::Both,
            model: Model::Exact,
            fit_x0: false,
        }
    }
}

/// The binocular model by which simulated samples are made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DataFrom {
    /// The model of the views, exact or one cone: the data are what the eyes see there.
    #[default]
    Views,
    /// Each eye solves its own light cone.
    Exact,
    /// Both eyes receive the events of the middle between them.
    OneCone,
    /// The paper's binocular model, which leaves out parallax: fitted by the same model, it gives the paper's
    /// own fit.
    Published,
}

impl DataFrom {
    /// The model, unless that of the views decides.
    #[must_use]
    pub const fn model(self) -> Option<Model> {
        match self {
            Self::Views => None,
            Self::Exact => Some(Model::Exact),
            Self::OneCone => Some(Model::OneCone),
            Self::Published => Some(Model::Published(PublishedVariant::AppendixA)),
        }
    }
}

fn samples(text: &str) -> Result<usize, String> {
    whole_number(text, FIT_SAMPLES)
}

fn seed(text: &str) -> Result<u64, String> {
    whole_number(text, 0..=MAX_SEED)
}
