//! The free parameters, in the form in which the curves depend on them to first order everywhere.
//!
//! Where only |z| matters, the curves have no slope at z = 0, so that no error of z follows from slopes
//! there, and least squares crawl. They have one with respect to u = hypot(z, s) - s, which is z^2/(2 s) near
//! z = 0 and |z| far above, for any length s; and u stops at 0.

use nalgebra::Vector4;

use crate::fit::gradients::Gradient;
use crate::fit::problem::{Free, NormalEquations, PreparedSample, Problem, Residual};
use crate::fit::trial::Trial;
use crate::math;

/// Least z in units of s at which the derivative by u is formed, from that by z: u is then 5e-13 s, which is
/// nothing, and the slope by z, which falls with z, keeps ten digits.
const LEAST_HEIGHT: f64 = 1e-6;

/// A problem in its regular parameters: ln(rapidity), ln(y), z or u, and t0.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RegularProblem<'a> {
    problem: &'a Problem,
    /// s, if only |z| matters.
    scale: Option<f64>,
}

impl<'a> RegularProblem<'a> {
    /// With the depth of `near` for s.
    pub fn new(problem: &'a Problem, near: &Trial) -> Self {
        Self { problem, scale: problem.is_even_in_z().then_some(near.y) }
    }

    /// The regular parameters for the free ones.
    pub fn parameters(&self, free: &Free) -> Free {
        let Some(scale) = self.scale else { return *free };
        let z = free[2];
        Free::new(free[0], free[1], z * z / (math::hypot(z, scale) + scale), free[3])
    }

    /// Derivative of beta by ln(rapidity).
    pub fn speed_slope(&self, trial: &Trial) -> f64 {
        self.problem.chain(trial)[0]
    }

    /// The object that `parameters` describe; z = 0 for u below 0.
    pub fn trial(&self, parameters: &Free) -> Option<Trial> {
        let z = self.scale.map_or(parameters[2], |scale| height(parameters[2], scale));
        self.problem.trial(&Free::new(parameters[0], parameters[1], z, parameters[3]))
    }

    /// Whether the third parameter is one that stops at 0.
    pub fn stops_at_zero(&self) -> bool {
        self.scale.is_some()
    }

    /// Normal equations at `trial`, each row counted as often as `counts` say.
    pub fn equations(&self, trial: &Trial, counts: impl Iterator<Item = f64>) -> NormalEquations {
        let trial = self.raised(trial);
        let mut sum = NormalEquations::default();
        for (row, count) in self.problem.rows.iter().zip(counts).filter(|(_, count)| *count > 0.0) {
            sum.add(&self.problem.slopes(&trial, row), row, count, self.problem.loss);
        }
        sum.in_free_parameters(self.chain(&trial))
    }

    /// Delta-phi and Delta-theta of `row` at `trial`: weighed residuals as large as the loss has them count,
    /// rho' r, with the derivatives of r.
    pub fn weighed(&self, trial: &Trial, row: &PreparedSample) -> [Residual; 2] {
        let trial = self.raised(trial);
        let (slopes, chain) = (self.problem.slopes(&trial, row), Vector4::from(self.chain(&trial)));
        std::array::from_fn(|curve| {
            let weight = row.weights[curve];
            let gradient = Vector4::from(slopes.gradients[curve]).component_mul(&chain);
            let residual = weight * (slopes.angles[curve] - row.values[curve]);
            (self.problem.loss.weight(residual) * residual, weight * gradient)
        })
    }

    /// Each row's part in the normal equations at `trial`.
    pub fn parts(&self, trial: &Trial) -> Vec<NormalEquations> {
        let trial = self.raised(trial);
        let chain = self.chain(&trial);
        let part = |row| {
            let mut part = NormalEquations::default();
            part.add(&self.problem.slopes(&trial, row), row, 1.0, self.problem.loss);
            part.in_free_parameters(chain)
        };
        self.problem.rows.iter().map(part).collect()
    }

    /// Standard error of z over that of the third parameter, `error`. `step` leads from z to where the sum of
    /// squares is least, which is beyond the end of the domain where z = 0 fits best.
    pub fn height_error(&self, z: f64, step: f64, error: f64) -> f64 {
        let Some(scale) = self.scale else { return 1.0 };
        let best = self.parameters(&Free::new(0.0, 0.0, z, 0.0))[2] + step;
        rise(best, error, scale) / error
    }

    /// `trial`, a little above z = 0 where the derivative by u is to be had from that by z.
    fn raised(&self, trial: &Trial) -> Trial {
        let z = self.scale.map_or(trial.z, |scale| trial.z.abs().max(LEAST_HEIGHT * scale));
        Trial { z, ..*trial }
    }

    /// d(beta, y, z, t0)/d(regular parameters).
    fn chain(&self, trial: &Trial) -> Gradient {
        let mut chain = self.problem.chain(trial);
        if let Some(scale) = self.scale {
            chain[2] = math::hypot(trial.z, scale) / trial.z;
        }
        chain
    }
}

/// The z for which hypot(z, scale) - scale is `u`.
pub(crate) fn height(u: f64, scale: f64) -> f64 {
    let u = u.max(0.0);
    (u * (u + 2.0 * scale)).sqrt()
}

/// Returns the rise of |z| at which the sum of squares, least at u = `best` with standard error `error`, has
/// risen by one variance.
fn rise(best: f64, error: f64, scale: f64) -> f64 {
    if best < 0.0 {
        // best + hypot(best, error), without the subtraction
        return height(error * error / (math::hypot(best, error) - best), scale);
    }
    // height(best + error) - height(best), likewise
    let sum = height(best + error, scale) + height(best, scale);
    error * (2.0 * (best + scale) + error) / sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_standard_error_above_costs_one_variance() {
        let scale: f64 = 3.0;
        for best in [-5.0, -0.1, -1e-9, 0.0, 0.01, 2.0, 40.0_f64] {
            for error in [1e-3, 0.2, 4.0] {
                let lowest = best.max(0.0);
                let z = height(lowest, scale) + rise(best, error, scale);
                let u = math::hypot(z, scale) - scale;
                let cost = |u: f64| ((u - best) / error).powi(2);
                let change = cost(u) - cost(lowest);
                assert!((change - 1.0).abs() < 1e-6, "{change} at {best} +- {error}");
            }
        }
    }
}
