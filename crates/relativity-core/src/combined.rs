//! The azimuthal and the polar fit taken together: their weighted mean, with their correlation.
//!
//! The paper weighs each fit by the inverse square of its uncertainty. Both fits come from the same samples,
//! so their errors are correlated; the covariance of the two estimates over common bootstrap replicates says
//! how much. A joint fit ([`crate::fit::Curves::Both`]) uses the same data better.

use crate::bootstrap::{Bootstrap, covariance, percentiles_95};
use crate::fit::{Fit, NOISE_FREE_ERROR, Parameter};

/// A weighted mean of the azimuthal and the polar estimate of one parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Combined {
    /// Weighted mean.
    pub value: f64,
    /// Standard error of the mean, with the correlation accounted for.
    pub standard_error: f64,
    /// Interval that holds 95 %: the percentiles of the replicates' means, widened as those of both
    /// estimates.
    pub interval_95: [f64; 2],
    /// Correlation of both estimates over the replicates.
    pub correlation: f64,
    /// Weight of the azimuthal estimate, 0 to 1.
    pub azimuth_weight: f64,
    /// By how many of its own standard errors the difference of both estimates is off 0; 0 where it is no
    /// more than the accuracy of a fit, [`NOISE_FREE_ERROR`].
    pub disagreement: f64,
}

/// The weighted mean of two fits of `parameter`.
///
/// Both bootstraps must have drawn the same samples: same observations, seed and number of replicates. Where
/// the azimuthal fit knows z but for its sign, it takes that of the polar fit.
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, Curves, FitOptions, Parameter, bootstrap, combined, fit};
/// # use relativity_core::{Model, Simulation, SourcePoint, Speed};
/// # let truth = Simulation {
/// #     speed: Speed::from_beta(0.9)?,
/// #     point: SourcePoint { x0: 0.0, y: 3.0, z: 2.0 },
/// #     rolling: None,
/// #     pair: Aperture::pair(0.1),
/// #     model: Model::Exact,
/// #     times: (0..100).map(|i| -1.0 + 0.1 * f64::from(i)).collect(),
/// #     noise: 0.01,
/// #     seed: 1,
/// # };
///
/// let observations = truth.observations()?;
/// let fitted = |curves| {
///     let found = fit(&observations, &FitOptions { curves, ..FitOptions::default() })?;
///     let replicates = bootstrap(&found, 200, 7)?;
///     Ok::<_, relativity_core::FitError>((found, replicates))
/// };
/// let (azimuth, polar) = (fitted(Curves::Azimuth)?, fitted(Curves::Polar)?);
/// let mean = combined((&azimuth.0, &azimuth.1), (&polar.0, &polar.1), Parameter::Beta);
/// assert!((mean.value - 0.9).abs() < 3.0 * mean.standard_error);
/// assert!((0.0..=1.0).contains(&mean.azimuth_weight));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn combined(azimuth: (&Fit, &Bootstrap), polar: (&Fit, &Bootstrap), parameter: Parameter) -> Combined {
    let of = |estimate: &Option<[f64; 4]>| estimate.map(|values| values[parameter as usize]);
    let is_mirrored =
        parameter == Parameter::Z && azimuth.0.problem.is_even_in_z() && polar.0.value(parameter) < 0.0;
    let sign = if is_mirrored { -1.0 } else { 1.0 };
    let pairs: Vec<(f64, f64)> = azimuth
        .1
        .estimates
        .iter()
        .zip(&polar.1.estimates)
        .filter_map(|(a, b)| Some((sign * of(a)?, of(b)?)))
        .collect();
    let covariance = covariance(pairs.iter().copied());
    let [error_a, error_b] = [azimuth.1, polar.1].map(|bootstrap| bootstrap.standard_error(parameter));
    let (variance_a, variance_b) = (error_a * error_a, error_b * error_b);
    let total = variance_a + variance_b;
    // Weights 1/variance_a and 1/variance_b, brought to a sum of 1; equal if there is no scatter at all.
    let weight = if total > 0.0 { variance_b / total } else { 0.5 };
    let rest = 1.0 - weight;
    let mean = |a: f64, b: f64| weight * a + rest * b;
    let variance = weight * weight * variance_a + rest * rest * variance_b + 2.0 * weight * rest * covariance;
    let correlation = if error_a * error_b > 0.0 { covariance / (error_a * error_b) } else { 0.0 };
    let estimates = (sign * azimuth.0.value(parameter), polar.0.value(parameter));
    let difference = (estimates.0 - estimates.1).abs();
    let apart = (total - 2.0 * covariance).max(0.0).sqrt();
    let widening = weight * azimuth.1.widening(parameter) + rest * polar.1.widening(parameter);
    let value = mean(estimates.0, estimates.1);
    let percentiles = percentiles_95(pairs.iter().map(|&(a, b)| mean(a, b)));
    Combined {
        value,
        disagreement: if difference > NOISE_FREE_ERROR && apart > 0.0 { difference / apart } else { 0.0 },
        standard_error: variance.max(0.0).sqrt(),
        interval_95: percentiles.map(|end| value + widening * (end - value)),
        correlation,
        azimuth_weight: weight,
    }
}
