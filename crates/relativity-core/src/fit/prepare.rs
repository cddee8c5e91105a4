//! From observations to weighed rows, with the verdicts that need no fit.

use crate::domain::check;
use crate::fit::error::FitError;
use crate::fit::loss::{Loss, LossShape};
use crate::fit::observations::{Observations, Reading, Sample};
use crate::fit::options::{FitOptions, Passage};
use crate::fit::problem::{PreparedSample, Problem};
use crate::fit::scatter;
use crate::fit::trial::Trial;
use crate::model::Model;

const NAMES: [&str; 2] = ["dphi", "dtheta"];
/// Least noise of a curve that is assumed, relative to its range: what rounding leaves of noise-free data.
const LEAST_NOISE: f64 = 1e-12;

/// A problem, and what is known of its noise.
pub(super) struct PreparedData {
    pub problem: Problem,
    /// Whether every fitted reading has a sigma.
    pub has_all_sigmas: bool,
    /// Whether each curve is fitted.
    used: [bool; 2],
    /// Whether each curve's readings have sigmas.
    has_sigmas: [bool; 2],
    /// Largest minus smallest value of each curve.
    ranges: [f64; 2],
}

/// Checks the observations against what `options` ask of them, and weighs them.
pub(super) fn prepare(observations: &Observations, options: &FitOptions) -> Result<PreparedData, FitError> {
    check_pairs(observations, options.model)?;
    let asked = options.curves.used();
    let mut has_sigmas = [false; 2];
    let mut ranges = [0.0; 2];
    for curve in 0..2 {
        if asked[curve] {
            has_sigmas[curve] = check_sigmas(observations, curve)?;
            ranges[curve] = range(observations, curve);
        }
    }
    let used = [asked[0] && has_reading(observations, 0), asked[1] && has_reading(observations, 1)];
    let scales = scales(ranges);
    let rows = observations.samples().iter().map(|sample| row(sample, used, scales)).collect();
    let passage_x = match options.passage {
        Passage::Known(x0) => check("x0", x0)?,
        Passage::Fitted => 0.0,
    };
    let fits_passage = options.passage == Passage::Fitted;
    if let Some(rolling) = options.rolling {
        rolling.check()?;
    }
    let mut problem = Problem {
        model: options.model,
        pairs: observations.pairs().to_vec(),
        rows,
        passage_x,
        fits_passage,
        rolling: options.rolling,
        loss: options.loss,
    };
    problem.rows.retain(|row| row.weights != [0.0; 2]);
    let has_all_sigmas = (0..2).all(|curve| has_sigmas[curve] || !used[curve]);
    let mut data = PreparedData { problem, has_all_sigmas, used, has_sigmas, ranges };
    if options.loss.is_robust() {
        data.weigh_roughly();
    }
    data.check_number(options)?;
    data.check_variation(options)?;
    Ok(data)
}

impl PreparedData {
    pub fn degrees_of_freedom(&self) -> f64 {
        (self.problem.readings() - self.problem.parameters()) as f64
    }

    /// Whether the scatter of a curve is to be found: its weight against the other, or the scale of the loss.
    pub fn estimates_noise(&self) -> bool {
        let is_needed = self.used == [true, true] || self.problem.loss.is_robust();
        is_needed && !self.has_all_sigmas
    }

    /// Weighs each curve without sigmas by what it scatters about the lines between neighbours.
    fn weigh_roughly(&mut self) {
        for (curve, scale) in scales(self.ranges).into_iter().enumerate() {
            if !self.has_sigmas[curve] && self.used[curve] {
                self.weigh(curve, self.rough(curve).max(LEAST_NOISE * scale));
            }
        }
    }

    fn rough(&self, curve: usize) -> f64 {
        scatter::rough(&self.problem.rows, self.problem.pairs.len(), curve)
    }

    /// By how many times the scale of a robust loss is too small to search with.
    pub fn roughness(&self) -> f64 {
        let of_curve = |curve: usize| {
            let rows = self.problem.rows.iter().filter(|row| row.is_read()[curve]);
            let most = rows.map(|row| row.weights[curve]).fold(0.0, f64::max);
            if self.has_sigmas[curve] { self.rough(curve) * most } else { 1.0 }
        };
        of_curve(0).max(of_curve(1)).max(1.0)
    }

    /// The problem to search with: its loss lets the worst readings go, where another would have a spike of a
    /// near passage reach for them; and its scale is larger by `factor`.
    pub fn softened(&self, factor: f64) -> Problem {
        let loss = Loss::of(LossShape::Cauchy);
        Problem { loss: Loss { scale: factor * loss.scale, ..loss }, ..self.problem.clone() }
    }

    /// The scatter of each curve that the scale of a robust loss is in, radians, where it has no sigmas.
    pub fn scatter(&self) -> [Option<f64>; 2] {
        let is_found =
            |curve: usize| self.problem.loss.is_robust() && self.used[curve] && !self.has_sigmas[curve];
        [0, 1].map(|curve| {
            let weights = self.problem.rows.iter().map(|row| row.weights[curve]);
            let weight = weights.clone().find(|weight| *weight > 0.0).filter(|_| is_found(curve))?;
            Some(1.0 / weight)
        })
    }

    fn weigh(&mut self, curve: usize, sigma: f64) {
        for row in &mut self.problem.rows {
            if row.weights[curve] > 0.0 {
                row.weights[curve] = 1.0 / sigma;
            }
        }
    }

    /// Weighs each curve without sigmas by its scatter about `trial`: by the median for a robust loss.
    pub fn reweigh(&mut self, trial: &Trial) {
        for (curve, scale) in scales(self.ranges).into_iter().enumerate() {
            if self.has_sigmas[curve] || !self.used[curve] {
                continue;
            }
            let only = [curve == 0, curve == 1];
            let sigma = if self.problem.loss.is_robust() {
                let sizes = self.residuals(trial, only).map(|(off, _)| off.abs());
                scatter::standard_deviation(sizes, self.problem.parameters())
            } else {
                self.rms(trial, only)
            };
            self.weigh(curve, sigma.max(LEAST_NOISE * scale));
        }
    }

    /// Root mean square of the unweighed residuals of the readings of the given curves, each as large as the
    /// loss has it count.
    pub fn rms(&self, trial: &Trial, curves: [bool; 2]) -> f64 {
        let loss = self.problem.loss;
        let (mut sum, mut count) = (0.0, 0.0);
        for (off, weight) in self.residuals(trial, curves) {
            sum += if loss.is_robust() { loss.cost(weight * off) / weight.powi(2) } else { off * off };
            count += 1.0;
        }
        if count == 0.0 { 0.0 } else { f64::sqrt(sum / count) }
    }

    /// The residuals of the readings of the given curves, with their weights.
    fn residuals(&self, trial: &Trial, curves: [bool; 2]) -> impl Iterator<Item = (f64, f64)> {
        self.problem.rows.iter().flat_map(move |row| {
            let angles = self.problem.angles(trial, row);
            let fitted = (0..2).filter(move |&curve| curves[curve] && row.weights[curve] > 0.0);
            fitted.map(move |curve| (angles[curve] - row.values[curve], row.weights[curve]))
        })
    }

    /// Largest range of a fitted curve.
    pub fn range(&self) -> f64 {
        self.ranges[0].max(self.ranges[1])
    }

    /// The cost of the mean of each curve.
    pub fn variation(&self) -> f64 {
        (0..2).map(|curve| self.variation_of(curve, self.problem.loss)).sum()
    }

    fn variation_of(&self, curve: usize, loss: Loss) -> f64 {
        let rows = || self.problem.rows.iter().map(|row| (row.weights[curve].powi(2), row.values[curve]));
        let weight: f64 = rows().map(|(weight, _)| weight).sum();
        if weight == 0.0 {
            return 0.0;
        }
        let mean = rows().map(|(weight, value)| weight * value).sum::<f64>() / weight;
        if loss.is_robust() {
            return rows().map(|(weight, value)| loss.cost(weight.sqrt() * (value - mean))).sum();
        }
        rows().map(|(weight, value)| weight * (value - mean).powi(2)).sum()
    }

    /// Checks that there are twice as many samples as a fit needs: a bootstrap replicate keeps about 63 % of
    /// them.
    fn check_number(&self, options: &FitOptions) -> Result<(), FitError> {
        let parameters = self.problem.parameters();
        let (samples, needed) = (self.problem.rows.len(), 2 * parameters);
        if samples >= needed {
            return Ok(());
        }
        Err(FitError::TooFew { samples, curves: options.curves.name(), parameters, needed })
    }

    /// Refuses curves that are constant, or constant within their sigmas (by three standard deviations of
    /// chi squared).
    fn check_variation(&self, options: &FitOptions) -> Result<(), FitError> {
        let varies = (0..2).any(|curve| {
            let free = self.problem.rows.iter().filter(|row| row.weights[curve] > 0.0).count() as f64 - 1.0;
            let scatter = free + 3.0 * (2.0 * free).sqrt();
            self.ranges[curve] > 0.0
                && (!self.has_sigmas[curve] || self.variation_of(curve, Loss::default()) > scatter)
        });
        if varies {
            return Ok(());
        }
        Err(FitError::Flat { curves: options.curves.name(), range: self.ranges[0].max(self.ranges[1]) })
    }
}

fn has_reading(observations: &Observations, curve: usize) -> bool {
    observations.samples().iter().any(|sample| sample.readings()[curve].is_some())
}

fn range(observations: &Observations, curve: usize) -> f64 {
    let values =
        || observations.samples().iter().filter_map(|sample| sample.readings()[curve]).map(|r| r.value);
    let range = values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min);
    range.max(0.0)
}

/// The scale of each curve's noise before a fit: its range, and for a curve that is constant a thousandth
/// of the other's, so that it counts for much and not for all.
fn scales(ranges: [f64; 2]) -> [f64; 2] {
    let least = 1e-3 * ranges[0].max(ranges[1]).max(f64::MIN_POSITIVE.sqrt());
    ranges.map(|range| range.max(least))
}

fn row(sample: &Sample, used: [bool; 2], scales: [f64; 2]) -> PreparedSample {
    let mut row =
        PreparedSample { time: sample.time, pair: sample.pair, values: [0.0; 2], weights: [0.0; 2] };
    for curve in (0..2).filter(|&curve| used[curve]) {
        if let Some(Reading { value, sigma }) = sample.readings()[curve] {
            row.values[curve] = value;
            row.weights[curve] = 1.0 / sigma.unwrap_or(scales[curve]);
        }
    }
    row
}

/// Whether the readings of `curve` have sigmas: all or none must.
fn check_sigmas(observations: &Observations, curve: usize) -> Result<bool, FitError> {
    let readings = || observations.samples().iter().filter_map(|sample| sample.readings()[curve]);
    let (with, of) = (readings().filter(|reading| reading.sigma.is_some()).count(), readings().count());
    if with != 0 && with != of {
        return Err(FitError::MixedSigma { curve: NAMES[curve], with, of });
    }
    Ok(of > 0 && with == of)
}

pub(super) fn check_pairs(observations: &Observations, model: Model) -> Result<(), FitError> {
    if !matches!(model, Model::Published(_)) {
        return Ok(());
    }
    for (pair, [primary, secondary]) in observations.pairs().iter().enumerate() {
        if primary.y != secondary.y || primary.z != secondary.z {
            let problem = "the published model needs both on a line along x";
            return Err(FitError::Pair { pair, problem });
        }
    }
    Ok(())
}
