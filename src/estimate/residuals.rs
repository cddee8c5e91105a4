//! What the residuals of a fit say of it: whether they are chance, or follow one another.

use relativity_core::{Fit, Observations, Sample, SerialCorrelation};
use serde::{Deserialize, Serialize};

use crate::number_text::significant;

/// The test of a fit's residuals, see [`SerialCorrelation`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Residuals {
    /// The number of Durbin and Watson, from 0 to 4.
    pub durbin_watson: f64,
    /// Its mean by chance.
    pub expected: f64,
    /// The probability that chance gives so small a number.
    pub probability: f64,
    /// Whether they may be chance; else no uncertainties follow from them.
    pub chance: bool,
}

impl From<SerialCorrelation> for Residuals {
    fn from(serial: SerialCorrelation) -> Self {
        let SerialCorrelation { durbin_watson, expected, probability } = serial;
        Self { durbin_watson, expected, probability, chance: serial.is_chance() }
    }
}

/// Returns by how much a reading is off the fit, radians: that of `curve`, 0 for dphi and 1 for dtheta.
/// `None` where there is none.
#[must_use]
pub fn miss(fit: &Fit, sample: &Sample, curve: usize) -> Option<f64> {
    let reading = sample.readings()[curve]?;
    Some(reading.value - fit.angles(sample.pair, sample.time)?[curve])
}

/// Returns the same for all samples and both curves: NaN without a reading, or if its curve is not fitted.
#[must_use]
pub fn misses(fit: &Fit, observations: &Observations) -> [Vec<f64>; 2] {
    let used = fit.options.curves.used();
    let of_sample = |sample, curve: usize| {
        if used[curve] { miss(fit, sample, curve).unwrap_or(f64::NAN) } else { f64::NAN }
    };
    let samples = observations.samples();
    [0, 1].map(|curve| samples.iter().map(|sample| of_sample(sample, curve)).collect())
}

/// Whether the residuals of `fit` may be chance.
#[must_use]
pub fn are_chance(fit: &Fit) -> bool {
    fit.serial.is_none_or(|serial| serial.is_chance())
}

/// Returns a sentence if the residuals of a fit follow one another, one of those of `curves`, by their names.
#[must_use]
pub fn remark(curves: &[(&'static str, Option<Residuals>)]) -> Option<String> {
    let failed =
        curves.iter().filter_map(|(name, residuals)| Some((name, residuals.filter(|found| !found.chance)?)));
    let failed: Vec<_> = failed.collect();
    let (_, worst) = failed.iter().min_by(|(_, a), (_, b)| a.probability.total_cmp(&b.probability))?;
    let names: Vec<&str> = failed.iter().map(|(name, _)| **name).collect();
    let [found, expected] = [worst.durbin_watson, worst.expected].map(|number| significant(number, 2));
    Some(format!(
        "the residuals of {} follow one another (Durbin-Watson {found}, by chance {expected}; good readings do so in 1 of 1,000 fits): \
         the model, or the clock, units, d or head given to it, is wrong, so that no uncertainties follow",
        names.join(", ")
    ))
}
