//! Counts over many fits: right minima, refusals, and intervals that hold the truth.

#![allow(dead_code, reason = "each program that includes this module uses its own part")]
#![allow(clippy::allow_attributes, reason = "an expectation would fail in the programs that use every part")]

use std::fmt;

use relativity_core::{Curves, Fit, FitOptions, Observations, Parameter, bootstrap, fit, fit_from};

use crate::common::Case;

/// Replicates per case: enough for a 95 % interval.
const REPLICATES: usize = 500;

#[derive(Debug, Default, Clone)]
pub struct Tally {
    pub cases: usize,
    /// Fits in the minimum that a fit started at the truth finds, or in a lower one.
    pub right: usize,
    /// Fits that reported no result, as does a fit from the truth.
    pub refused: usize,
    /// Fits in another minimum, and refusals where a fit from the truth has a result.
    pub wrong: usize,
    /// Right fits that reported to be too uncertain for a bootstrap.
    pub unsteady: usize,
    /// Fits, and those whose bootstrap interval holds the truth, by parameter.
    pub fitted: usize,
    pub within_error: [usize; 4],
    pub within_interval: [usize; 4],
    /// Messages about fits that are not right.
    pub complaints: Vec<String>,
}

impl Tally {
    /// Fits `case` and asks a bootstrap how far that may be off.
    pub fn add(&mut self, case: &Case, options: &FitOptions, seed: u64) {
        if let Some(best) = self.add_fit(case, options, seed) {
            self.add_intervals(case, &best, seed);
        }
    }

    /// Fits `case`; returns the fit if it is right.
    pub fn add_fit(&mut self, case: &Case, options: &FitOptions, seed: u64) -> Option<Fit> {
        self.cases += 1;
        let observations = case.observations(options.model, seed);
        let best = match fit(&observations, options) {
            Ok(best) => best,
            Err(error) => {
                let is_found_from_truth = fit_from(&observations, options, case.truth()).is_ok();
                *if is_found_from_truth { &mut self.wrong } else { &mut self.refused } += 1;
                let what = if is_found_from_truth { "lost" } else { "refused" };
                self.complaints.push(format!("{what}: {error}; {case:?}"));
                return None;
            }
        };
        if !is_right(&best, &observations, case) {
            self.wrong += 1;
            self.complaints.push(format!("wrong: {:?} {case:?}", best.values));
            return None;
        }
        self.right += 1;
        Some(best)
    }

    fn add_intervals(&mut self, case: &Case, best: &Fit, seed: u64) {
        let Ok(replicates) = bootstrap(best, REPLICATES, seed) else {
            self.unsteady += 1;
            return;
        };
        self.fitted += 1;
        for (index, &parameter) in best.parameters().iter().enumerate() {
            // Delta-phi alone tells only |z|.
            let is_even = parameter == Parameter::Z && best.options.curves == Curves::Azimuth;
            let truth = if is_even { case.z.abs() } else { case.truth()[index] };
            let [low, high] = replicates.interval_95(parameter);
            let error = (best.value(parameter) - truth).abs();
            self.within_error[index] += usize::from(error <= replicates.standard_error(parameter));
            self.within_interval[index] += usize::from((low..=high).contains(&truth));
        }
    }

    /// Shares, in %, of the fits of `parameters` whose standard error and interval hold the truth.
    pub fn coverage(&self, parameters: usize) -> [f64; 2] {
        let all = self.fitted * parameters;
        [self.within_error, self.within_interval].map(|counts| percentage(counts.iter().sum(), all))
    }
}

fn percentage(count: usize, of: usize) -> f64 {
    100.0 * count as f64 / of.max(1) as f64
}

/// Whether `best` is the minimum that a fit started at the truth finds, or a better one.
fn is_right(best: &Fit, observations: &Observations, case: &Case) -> bool {
    let Ok(from_truth) = fit_from(observations, &best.options, case.truth()) else { return true };
    let is_near = |&parameter: &Parameter| {
        let difference = best.value(parameter) - from_truth.value(parameter);
        difference.abs() < 0.1 * best.standard_error(parameter)
    };
    best.parameters().iter().all(is_near) || best.rms < from_truth.rms
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for count in [self.right, self.refused, self.wrong, self.unsteady] {
            write!(f, "{:6.1}", percentage(count, self.cases))?;
        }
        for counts in [self.within_error, self.within_interval] {
            write!(f, " |")?;
            for count in counts {
                write!(f, "{:6.1}", percentage(count, self.fitted))?;
            }
        }
        Ok(())
    }
}
