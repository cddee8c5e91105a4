//! The test of Durbin and Watson: whether residuals follow one another, as they do where the model is wrong.
//!
//! In the order of time, d is the sum of the squares of the differences of neighbours over that of the
//! residuals: near 2 for chance, near 0 where neighbours are alike. Each curve of each pair of apertures is a
//! chain of its own, and both are judged together: with e the weighed residuals and A the sum of the chains'
//! difference matrices, d = e'Ae / e'e.
//!
//! A fit leaves residuals e = M n of a noise n, M = 1 - J (J'J)^-1 J' with the slopes J, so that even chance
//! has a d that depends on the number of readings and on the parameters. The mean and the variance of d
//! follow from traces; the probability of so small a d is that of the beta distribution on 0 to 4 with these.
//! `tests/fit.rs` counts how often it is below a level in fits of good readings.
//!
//! Reference: J. Durbin and G. S. Watson, *Testing for serial correlation in least squares regression* I and
//! II, Biometrika 37 (1950) 409 and 38 (1951) 159.

use nalgebra::{Matrix4, Vector4};

use crate::fit::problem::{Problem, Residual};
use crate::fit::regular::RegularProblem;
use crate::fit::trial::Trial;
use crate::math;

/// The probability of a false alarm: good readings fail the test once in so many fits.
pub const FALSE_ALARM: f64 = 1e-3;

/// How much the residuals of a fit follow one another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SerialCorrelation {
    /// The number d of Durbin and Watson, from 0 to 4.
    pub durbin_watson: f64,
    /// Its mean by chance.
    pub expected: f64,
    /// The probability that chance gives so small a number.
    pub probability: f64,
}

impl SerialCorrelation {
    /// Whether the residuals may be chance: false for one in 1,000 fits of good readings.
    #[must_use]
    pub fn is_chance(&self) -> bool {
        self.probability >= FALSE_ALARM
    }

    /// Judges the residuals at `trial`; `None` where there are hardly more readings than parameters.
    pub(super) fn of(problem: &Problem, trial: &Trial) -> Option<Self> {
        let regular = RegularProblem::new(problem, trial);
        let mut rows: Vec<usize> = (0..problem.rows.len()).collect();
        rows.sort_by(|&a, &b| problem.rows[a].time.total_cmp(&problem.rows[b].time));
        let mut sums = Sums::default();
        for pair in 0..problem.pairs.len() {
            let of_pair = || rows.iter().map(|&row| &problem.rows[row]).filter(|row| row.pair == pair);
            let slopes: Vec<_> = of_pair().map(|row| regular.weighed(trial, row)).collect();
            for curve in 0..2 {
                let chain = of_pair().zip(&slopes).filter(|(row, _)| row.is_read()[curve]);
                sums.add(&chain.map(|(_, slopes)| slopes[curve]).collect::<Vec<_>>());
            }
        }
        sums.judged(problem.parameters())
    }
}

/// Traces and products, summed over chains.
#[derive(Default)]
struct Sums {
    readings: usize,
    /// Of the squares of residuals, and of the differences of neighbours.
    squares: f64,
    differences: f64,
    /// Traces of A and A A.
    trace: f64,
    trace_squared: f64,
    /// J'J, J'AJ and J'AAJ.
    slopes: Matrix4<f64>,
    once: Matrix4<f64>,
    twice: Matrix4<f64>,
}

impl Sums {
    fn add(&mut self, chain: &[Residual]) {
        let count = chain.len();
        self.readings += count;
        for (residual, slopes) in chain {
            self.squares += residual * residual;
            self.slopes += slopes * slopes.transpose();
        }
        if count < 2 {
            return;
        }
        self.trace += 2.0 * (count - 1) as f64;
        self.trace_squared += 6.0 * count as f64 - 8.0;
        let mut before = Vector4::zeros();
        for index in 0..count {
            let after = chain.get(index + 1).map_or_else(Vector4::zeros, |next| next.1 - chain[index].1);
            // A row of AJ: by what the slopes bend there.
            let bend = before - after;
            self.twice += bend * bend.transpose();
            self.once += after * after.transpose();
            self.differences += chain.get(index + 1).map_or(0.0, |next| (next.0 - chain[index].0).powi(2));
            before = after;
        }
    }

    fn judged(&self, parameters: usize) -> Option<SerialCorrelation> {
        let free = self.readings.checked_sub(parameters).filter(|&free| free > 1)? as f64;
        let mut slopes = self.slopes;
        for unfitted in parameters..4 {
            slopes[(unfitted, unfitted)] = 1.0;
        }
        let inverse = slopes.cholesky()?.inverse();
        let by_slopes = inverse * self.once;
        let first = self.trace - by_slopes.trace();
        let second =
            self.trace_squared - 2.0 * (inverse * self.twice).trace() + (by_slopes * by_slopes).trace();
        let mean = first / free;
        let variance = 2.0 * (free * second - first * first) / (free * free * (free + 2.0));
        let durbin_watson = self.differences / self.squares;
        let (share, spread) = (0.25 * mean, variance / 16.0);
        let size = share * (1.0 - share) / spread - 1.0;
        let is_judged = durbin_watson.is_finite() && size > 0.0 && (0.0..1.0).contains(&share);
        is_judged.then(|| SerialCorrelation {
            durbin_watson,
            expected: mean,
            probability: beta_below(0.25 * durbin_watson, share * size, (1.0 - share) * size),
        })
    }
}

/// The probability of the beta distribution below x: the regularised incomplete beta function, by its
/// continued fraction (W. J. Lentz's way; DLMF 8.17.22).
fn beta_below(x: f64, a: f64, b: f64) -> f64 {
    if x <= 0.0 || x >= 1.0 {
        return if x > 0.0 { 1.0 } else { 0.0 };
    }
    // The fraction converges where x is below the middle.
    if x > (a + 1.0) / (a + b + 2.0) {
        return 1.0 - beta_below(1.0 - x, b, a);
    }
    let scale = math::ln_gamma(a + b) - math::ln_gamma(a) - math::ln_gamma(b);
    let front = math::exp(scale + a * math::ln(x) + b * math::ln_1p(-x)) / a;
    let away_from_zero = |value: f64| if value.abs() < 1e-300 { 1e-300 } else { value };
    let (mut above, mut below) = (1.0, 1.0 / away_from_zero(1.0 - (a + b) * x / (a + 1.0)));
    let mut fraction = below;
    for step in 1..1000 {
        let m = f64::from(step);
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let mut last = 0.0;
        for term in [even, odd] {
            below = 1.0 / away_from_zero(1.0 + term * below);
            above = away_from_zero(1.0 + term / above);
            last = above * below;
            fraction *= last;
        }
        if (last - 1.0).abs() < 1e-14 {
            break;
        }
    }
    front * fraction
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By `scipy.stats.beta.cdf` of `SciPy` 1.17.1.
    #[test]
    fn the_incomplete_beta_function_is_that_of_scipy() {
        for (x, a, b, expected) in BETA {
            let found = beta_below(x, a, b);
            assert!((found - expected).abs() < 1e-11 * expected, "{x} {a} {b}: {found:e} for {expected:e}");
        }
    }

    const BETA: [(f64, f64, f64, f64); 7] = [
        (0.02, 3.0, 3.5, 0.000_111_220_580_313_988_66),
        (0.25, 39.2, 38.5, 8.142_284_734_645_231e-7),
        (0.5, 39.2, 38.5, 0.468_182_108_431_528_47),
        (0.7, 12.0, 5.0, 0.449_904_119_824_904_4),
        (0.4, 250.0, 255.0, 7.992_109_397_131_854e-6),
        (0.05, 1.2, 1.1, 0.030_484_447_218_275_89),
        (0.001, 40.0, 41.0, 1.033_906_887_667_276_8e-97),
    ];
}
