//! Readings that stand out from those of a fit, by their line in the file.

use relativity_core::fit::standard_deviation;
use relativity_core::{Fit, Observations, math};
use serde::{Deserialize, Serialize};

use super::residuals;
use crate::number_text::significant;

/// A reading that stands out.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Outlier {
    /// Its sample, from 0.
    pub sample: usize,
    /// Its line in the file, if it has one.
    pub line: Option<u64>,
    /// When it was taken.
    pub time: f64,
    /// Its curve: 0 for dphi, 1 for dtheta.
    pub curve: usize,
    /// By how many standard deviations it is off the fit, up or down.
    pub deviation: f64,
}

/// Good sets of readings among which one has a reading that stands out by chance.
const SETS: f64 = 1000.0;
/// Readings of a curve below which its scatter is not known well enough.
const LEAST: usize = 10;

/// The readings that are further off `fit` than chance takes one of as many in 1,000 sets: by more than
/// sqrt(2 ln(1000 n)) standard deviations. These follow from the median of the residuals of a curve, which no
/// few readings move, or are the sigmas if there are any and they are larger.
#[must_use]
pub fn find(fit: &Fit, observations: &Observations) -> Vec<Outlier> {
    let used = fit.options.curves.used();
    (0..2).filter(|&curve| used[curve]).flat_map(|curve| of_curve(fit, observations, curve)).collect()
}

/// Sets the line of each reading that stands out, where `lines` contains that of its sample.
pub fn name_lines(outliers: &mut [Outlier], lines: &[u64]) {
    for found in outliers {
        found.line = lines.get(found.sample).copied();
    }
}

fn of_curve(fit: &Fit, observations: &Observations, curve: usize) -> Vec<Outlier> {
    let residual = |(sample, taken): (usize, &relativity_core::Sample)| {
        let (sigma, miss) = (taken.readings()[curve]?.sigma, residuals::miss(fit, taken, curve)?);
        Some((sample, miss / sigma.unwrap_or(1.0), sigma.is_some()))
    };
    let residuals: Vec<_> = observations.samples().iter().enumerate().filter_map(residual).collect();
    let parameters = fit.parameters().len();
    if residuals.len() < LEAST.max(3 * parameters) {
        return Vec::new();
    }
    let count = residuals.len() as f64;
    let scatter = standard_deviation(residuals.iter().map(|(_, residual, _)| residual.abs()), parameters);
    let has_sigmas = residuals.iter().all(|(.., has_sigma)| *has_sigma);
    let scatter = if has_sigmas { scatter.max(1.0) } else { scatter };
    // Of few residuals the median is known badly.
    let most = (2.0 * math::ln(SETS * count)).sqrt() * (1.0 + 6.0 / count);
    let standing_out = residuals.into_iter().filter(|(_, residual, _)| residual.abs() > most * scatter);
    standing_out
        .map(|(sample, residual, _)| Outlier {
            sample,
            line: None,
            time: observations.samples()[sample].time,
            curve,
            deviation: residual / scatter,
        })
        .collect()
}

/// The name of a reading of a curve, 0 for dphi and 1 for dtheta: by its line, or by when it was taken.
#[must_use]
pub fn reading_name(curve: usize, line: Option<u64>, time: f64) -> String {
    let place = line.map_or_else(|| format!("at T = {time}"), |line| format!("in line {line}"));
    format!("{} {place}", ["dphi", "dtheta"][curve])
}

/// Names of at most so many readings.
const MOST_NAMED: usize = 10;

/// Says which readings stand out; `None` if none does.
#[must_use]
pub fn remark(outliers: &[Outlier]) -> Option<String> {
    let name = |&Outlier { curve, line, time, deviation, .. }: &Outlier| {
        format!("{} by {}", reading_name(curve, line, time), significant(deviation, 2))
    };
    let named: Vec<String> = outliers.iter().take(MOST_NAMED).map(name).collect();
    let more = outliers.len().saturating_sub(MOST_NAMED);
    let more = if more > 0 { format!(", and {more} more") } else { String::new() };
    let are = if outliers.len() == 1 { "a reading stands" } else { "readings stand" };
    (!named.is_empty()).then(|| format!("{are} out, in standard deviations: {}{more}", named.join(", ")))
}
