//! Readings that stand out from those of a fit, by their line in the file.

use relativity_core::{Fit, Observations, math};
use serde::{Deserialize, Serialize};

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

/// Median magnitude of a normal deviate.
const MEDIAN: f64 = 0.674_489_750_196_082;
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

/// Names the line of each reading that stands out, where `lines` has that of its sample.
pub fn name_lines(outliers: &mut [Outlier], lines: &[u64]) {
    for found in outliers {
        found.line = lines.get(found.sample).copied();
    }
}

fn of_curve(fit: &Fit, observations: &Observations, curve: usize) -> Vec<Outlier> {
    let residual = |(sample, taken): (usize, &relativity_core::Sample)| {
        let reading = [taken.dphi, taken.dtheta][curve]?;
        let fitted = fit.angles(taken.pair, taken.time)?[curve];
        Some((sample, (reading.value - fitted) / reading.sigma.unwrap_or(1.0), reading.sigma.is_some()))
    };
    let residuals: Vec<_> = observations.samples().iter().enumerate().filter_map(residual).collect();
    let parameters = fit.parameters().len();
    if residuals.len() < LEAST.max(3 * parameters) {
        return Vec::new();
    }
    let mut sizes: Vec<f64> = residuals.iter().map(|(_, residual, _)| residual.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let count = sizes.len() as f64;
    // The fit takes out a part of the scatter.
    let scatter = sizes[sizes.len() / 2] / MEDIAN * (count / (count - parameters as f64)).sqrt();
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

/// Names of at most so many readings.
const MOST_NAMED: usize = 10;

/// Says which readings stand out; `None` if none does.
#[must_use]
pub fn remark(outliers: &[Outlier]) -> Option<String> {
    let name = |outlier: &Outlier| {
        let curve = ["dphi", "dtheta"][outlier.curve];
        let place =
            outlier.line.map_or_else(|| format!("at T = {}", outlier.time), |line| format!("in line {line}"));
        format!("{curve} {place} by {}", significant(outlier.deviation, 2))
    };
    let named: Vec<String> = outliers.iter().take(MOST_NAMED).map(name).collect();
    let more = outliers.len().saturating_sub(MOST_NAMED);
    let more = if more > 0 { format!(", and {more} more") } else { String::new() };
    let are = if outliers.len() == 1 { "a reading stands" } else { "readings stand" };
    (!named.is_empty()).then(|| format!("{are} out, in standard deviations: {}{more}", named.join(", ")))
}
