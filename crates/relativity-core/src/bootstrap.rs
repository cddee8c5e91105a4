//! Uncertainty of a fit by the non-parametric bootstrap: refits of samples drawn with replacement.
//!
//! A replicate is the original samples with integer counts. Each starts at the original optimum, whose
//! residuals and derivatives all replicates share; its first step costs one weighed sum. What follows
//! are a few Gauss-Newton steps on normal equations, damped when one fails. A general solver would set up
//! a 2n x 4 matrix and factorise it for every trial of every replicate; near the optimum, with four
//! parameters on comparable scales, the normal equations lose no digit that the statistics show.
//!
//! References: B. Efron and R. J. Tibshirani, *An Introduction to the Bootstrap* (1993), chapters 9
//! (resampling pairs) and 13 (percentile intervals).

use nalgebra::Matrix4;
use rand::{RngExt as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;

use crate::fit::{
    Fit, FitError, Free, NORMAL_975, NormalEquations, Parameter, RegularProblem, Trial, height,
};
use crate::math;
use crate::threads::prelude::*;

/// The number of replicates from which 95 % intervals are steady.
pub const DEFAULT_REPLICATES: usize = 1000;
/// A replicate ends with the first step below this in units of its standard error. As each step is much
/// smaller than the one before, what is left is far below the scatter of any statistic over replicates.
const TOLERANCE: f64 = 1e-2;
/// Step, in units of the parameters themselves, below which a refit also ends: data without noise leave
/// nothing but rounding to step towards.
const SMALLEST_STEP: f64 = 1e-12;
/// Evaluations of the whole curve that a replicate gets: far more than the few steps that lead there from
/// near.
const MAX_EVALUATIONS: usize = 30;
/// Damping of the first step after one that failed, in units of the diagonal that it adds to: little, as a
/// minimum is near. And the damping at which no step can be told from none.
const FIRST_DAMPING: f64 = 1e-3;
const LAST_DAMPING: f64 = 1e12;
/// Share of replicates that may have no fit: as much as a 95 % interval leaves outside, so that its ends
/// could be anywhere if more were missing.
const MAX_FAILED_SHARE: f64 = 0.05;

/// A bootstrap: refits of resampled data.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Bootstrap {
    /// Beta, y, z and x0 of each replicate, in the order of their random streams; `None` without a fit.
    pub estimates: Vec<Option<[f64; 4]>>,
    /// u or z of each replicate where its sum of squares is least, beyond the end of the domain, too.
    heights: Vec<Option<f64>>,
    centre: Option<Center>,
}

/// The best fit in parameters in which its errors are the most alike: ln(rapidity), ln(y), z and x0; u for z
/// where only |z| matters, see [`RegularProblem`].
#[derive(Debug, Clone, Copy, PartialEq)]
struct Center {
    values: [f64; 4],
    /// Half the least width of the 95 % intervals, see [`half_widths`].
    half_widths: [f64; 4],
    /// Length of u, if that stands for z.
    scale: Option<f64>,
}

impl Bootstrap {
    /// Draws `more` further replicates of `fit`, as [`bootstrap`] does. Drawing all at once or in parts with
    /// the same `seed` gives the same replicates.
    pub fn extend(&mut self, fit: &Fit, more: usize, seed: u64) {
        let shared = ReplicateData::new(fit);
        self.centre = shared.as_ref().map(|shared| shared.centre);
        for replicate in replicates(shared.as_ref(), self.estimates.len(), more, seed) {
            self.estimates.push(replicate.map(|replicate| replicate.values));
            self.heights.push(replicate.map(|replicate| replicate.height));
        }
    }

    /// Returns the bootstrap, if enough of its replicates have a fit.
    ///
    /// # Errors
    ///
    /// As [`bootstrap`].
    pub fn checked(self) -> Result<Self, FitError> {
        let (failed, replicates) = (self.failed(), self.estimates.len());
        if replicates < 2 || failed as f64 > MAX_FAILED_SHARE * replicates as f64 {
            return Err(FitError::Bootstrap { failed, replicates });
        }
        Ok(self)
    }

    /// Replicates that have no fit.
    #[must_use]
    pub fn failed(&self) -> usize {
        self.estimates.iter().filter(|estimate| estimate.is_none()).count()
    }

    /// Standard error of `parameter`: the standard deviation over the replicates.
    #[must_use]
    pub fn standard_error(&self, parameter: Parameter) -> f64 {
        self.covariance(parameter, parameter).sqrt()
    }

    /// Covariance of two parameters over the replicates.
    #[must_use]
    pub fn covariance(&self, a: Parameter, b: Parameter) -> f64 {
        covariance(self.values(a).zip(self.values(b)))
    }

    /// Correlation of two fitted parameters over the replicates.
    #[must_use]
    pub fn correlation(&self, a: Parameter, b: Parameter) -> f64 {
        self.covariance(a, b) / (self.standard_error(a) * self.standard_error(b))
    }

    /// The interval of `parameter` that holds 95 %: the percentiles of the replicates say how it lies about
    /// the best fit, and a standard error with its degrees of freedom how wide it is at least. Where z is at
    /// its limit 0, so is the lower end; the upper one never is.
    #[must_use]
    pub fn interval_95(&self, parameter: Parameter) -> [f64; 2] {
        let Some(centre) = &self.centre else { return percentiles_95(self.values(parameter)) };
        let value = centre.values[parameter as usize];
        let (ends, widening) = self.percentiles(centre, parameter);
        let [low, high] = ends.map(|end| widening * (end - value));
        let is_bounded = centre.scale.is_some() && parameter == Parameter::Z;
        let above = if is_bounded { value.max(0.0) } else { value };
        [value + low, above + high].map(|end| centre.reported(parameter, end))
    }

    /// By how many times the interval of `parameter` is wider than the percentiles of the replicates.
    pub(crate) fn widening(&self, parameter: Parameter) -> f64 {
        self.centre.as_ref().map_or(1.0, |centre| self.percentiles(centre, parameter).1)
    }

    /// The percentiles of a parameter of [`Center`], and by how many times they are drawn apart.
    fn percentiles(&self, centre: &Center, parameter: Parameter) -> ([f64; 2], f64) {
        let ends = match parameter {
            Parameter::Z => percentiles_95(self.heights.iter().flatten().copied()),
            _ => percentiles_95(self.values(parameter)).map(|end| inner(parameter, end)),
        };
        let widening = 2.0 * centre.half_widths[parameter as usize] / (ends[1] - ends[0]);
        // Without noise there is no width; and far from a straight line replicates know better.
        (ends, if widening.is_finite() { widening.max(1.0) } else { 1.0 })
    }

    fn values(&self, parameter: Parameter) -> impl Iterator<Item = f64> + Clone {
        self.estimates.iter().flatten().map(move |estimate| estimate[parameter as usize])
    }
}

/// A reported `value` of a parameter, other than z, as it is in [`Center`].
fn inner(parameter: Parameter, value: f64) -> f64 {
    match parameter {
        Parameter::Beta => math::ln(math::atanh(value)),
        Parameter::Y => math::ln(value),
        Parameter::Z | Parameter::X0 => value,
    }
}

/// Covariance of two series, from sums about their means.
pub(crate) fn covariance(pairs: impl Iterator<Item = (f64, f64)> + Clone) -> f64 {
    let count = pairs.clone().count() as f64;
    let mean = |sum: f64| sum / count;
    let mean_a = mean(pairs.clone().map(|(a, _)| a).sum());
    let mean_b = mean(pairs.clone().map(|(_, b)| b).sum());
    pairs.map(|(a, b)| (a - mean_a) * (b - mean_b)).sum::<f64>() / (count - 1.0)
}

/// The interval that holds all but the lowest and the highest 2.5 % of `values` (at least one).
#[must_use]
pub fn percentiles_95(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    [quantile(&values, 0.025), quantile(&values, 0.975)]
}

/// The value below which `share` of the sorted `values` lie, by linear interpolation.
fn quantile(values: &[f64], share: f64) -> f64 {
    let position = share * (values.len() - 1) as f64;
    let below = position as usize;
    let above = (below + 1).min(values.len() - 1);
    values[below] + (position - below as f64) * (values[above] - values[below])
}

/// Refits `fit` to `replicates` (at least 2) samples drawn with replacement.
///
/// Replicate i draws from stream i of a `ChaCha8` generator with `seed`, so the result depends on neither
/// the number of threads nor their order.
///
/// # Errors
///
/// [`FitError::Bootstrap`] if more than 5 % of the replicates have no fit, or none were asked for.
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, FitOptions, Parameter, bootstrap, fit};
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
/// let found = fit(&truth.observations()?, &FitOptions::default())?;
/// let replicates = bootstrap(&found, 200, 7)?;
/// let [low, high] = replicates.interval_95(Parameter::Beta);
/// assert!(low < 0.9 && 0.9 < high && high - low < 0.02);
/// assert_eq!(replicates, bootstrap(&found, 200, 7)?); // on any number of threads
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn bootstrap(fit: &Fit, replicates: usize, seed: u64) -> Result<Bootstrap, FitError> {
    let mut bootstrap = Bootstrap::default();
    bootstrap.extend(fit, replicates, seed);
    bootstrap.checked()
}

/// A replicate that has a fit.
#[derive(Debug, Clone, Copy)]
struct Replicate {
    /// Beta, y, z and x0.
    values: [f64; 4],
    /// u or z where the sum of squares is least, beyond the end of the domain, too.
    height: f64,
}

/// Returns `count` replicates from number `first` on.
fn replicates(
    shared: Option<&ReplicateData<'_>>,
    first: usize,
    count: usize,
    seed: u64,
) -> Vec<Option<Replicate>> {
    let Some(shared) = shared else { return vec![None; count] };
    (first as u64..(first + count) as u64)
        .into_par_iter()
        .map_init(
            || vec![0.0; shared.parts.len()],
            |counts, stream| {
                draw(counts, seed, stream);
                shared.replicate(counts)
            },
        )
        .collect()
}

impl Center {
    /// `value` of a parameter in here as it is reported.
    fn reported(&self, parameter: Parameter, value: f64) -> f64 {
        match (parameter, self.scale) {
            (Parameter::Beta, _) => math::tanh(math::exp(value)),
            (Parameter::Y, _) => math::exp(value),
            (Parameter::Z, Some(scale)) => height(value, scale),
            (Parameter::Z, None) | (Parameter::X0, _) => value,
        }
    }
}

/// Draws the number of times that each sample counts in a replicate.
fn draw(counts: &mut [f64], seed: u64, stream: u64) {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(stream);
    counts.fill(0.0);
    let samples = counts.len() as u32; // the same draws whatever the width of usize
    for _ in 0..samples {
        counts[random.random_range(0..samples) as usize] += 1.0;
    }
}

/// The data that all replicates share.
struct ReplicateData<'a> {
    regular: RegularProblem<'a>,
    /// The regular parameters of the original optimum.
    free: Free,
    /// Each row's part in the normal equations there.
    parts: Vec<NormalEquations>,
    /// Sizes of the regular parameters.
    sizes: Free,
    centre: Center,
}

impl<'a> ReplicateData<'a> {
    fn new(fit: &'a Fit) -> Option<Self> {
        let trial = fit.problem.trial(&fit.free)?;
        let regular = RegularProblem::new(&fit.problem, &trial);
        let parts = regular.parts(&trial);
        let (free, sizes) = (regular.parameters(&fit.free), fit.problem.sizes(&trial));
        let scale = regular.stops_at_zero().then_some(trial.y);
        let values = [free[0], free[1], free[2], trial.reported()[3]];
        let centre = Center { values, half_widths: half_widths(fit, &regular, &trial)?, scale };
        let mut shared = Self { regular, free, parts, sizes, centre };
        let equations = shared.at_original_optimum(&vec![1.0; shared.parts.len()]);
        shared.centre.values[2] = shared.height(&free, &free, &equations)?;
        Some(shared)
    }

    fn replicate(&self, counts: &[f64]) -> Option<Replicate> {
        let (free, height) = self.minimum(counts)?;
        Some(Replicate { values: self.regular.trial(&free)?.reported(), height })
    }

    /// u or z where the sum of squares is least, whose minimum in the domain is `next`, beside `free`, where
    /// it has these `equations`.
    fn height(&self, next: &Free, free: &Free, equations: &NormalEquations) -> Option<f64> {
        if !self.regular.stops_at_zero() || next[2] > 0.0 {
            return Some(next[2]);
        }
        let step = equations.hessian.cholesky()?.solve(&equations.gradient)[2];
        Some((free[2] - step).min(0.0))
    }

    /// The minimum of a replicate, and its [`Self::height`].
    fn minimum(&self, counts: &[f64]) -> Option<(Free, f64)> {
        let mut free = self.free;
        let mut equations = self.at_original_optimum(counts);
        let mut damping = 0.0;
        for _ in 0..MAX_EVALUATIONS {
            let step = self.step(&free, &equations, damping)?;
            let scatter = equations.cost / counts.len() as f64;
            let next = free + step;
            let is_small = step.component_div(&self.sizes).amax() <= SMALLEST_STEP;
            if is_small || step.dot(&(equations.hessian * step)) <= TOLERANCE * TOLERANCE * scatter {
                return Some((next, self.height(&next, &free, &equations)?));
            }
            match self.at(&next, counts).filter(|there| there.cost <= equations.cost) {
                Some(there) => {
                    (free, equations) = (next, there);
                    damping = if damping > FIRST_DAMPING { 0.1 * damping } else { 0.0 };
                }
                None if damping > LAST_DAMPING => {
                    return Some((free, self.height(&free, &free, &equations)?));
                }
                None => damping = (10.0 * damping).max(FIRST_DAMPING),
            }
        }
        None
    }

    /// The step to the minimum of the quadratic model, which goes no further than to z = 0.
    fn step(&self, free: &Free, equations: &NormalEquations, damping: f64) -> Option<Free> {
        let mut hessian = damped(&equations.hessian, damping);
        let step = -hessian.cholesky()?.solve(&equations.gradient);
        if !self.regular.stops_at_zero() || free[2] + step[2] >= 0.0 {
            return Some(step);
        }
        let to_zero = -free[2];
        let mut gradient = equations.gradient + hessian.column(2) * to_zero;
        gradient[2] = -to_zero;
        hessian.row_mut(2).fill(0.0);
        hessian.column_mut(2).fill(0.0);
        hessian[(2, 2)] = 1.0;
        Some(-hessian.cholesky()?.solve(&gradient))
    }

    fn at_original_optimum(&self, counts: &[f64]) -> NormalEquations {
        let mut sum = NormalEquations::default();
        for (part, &count) in self.parts.iter().zip(counts) {
            sum.hessian += part.hessian * count;
            sum.gradient += part.gradient * count;
            sum.cost += part.cost * count;
        }
        sum
    }

    fn at(&self, free: &Free, counts: &[f64]) -> Option<NormalEquations> {
        let trial = self.regular.trial(free)?;
        let sum = self.regular.equations(&trial, counts.iter().copied());
        sum.cost.is_finite().then_some(sum)
    }
}

/// Greatest factor by which the squared part of a sample is made up for what the fit takes out of it.
const MOST_MADE_UP: f64 = 50.0;

/// Half the least width of a 95 % interval of each parameter of [`Center`], whatever the noise of each sample
/// is.
///
/// The squared error is the sum of the samples' own parts, (a' r)^2 of sample c with residuals r and its part
/// a of the pseudo-inverse. Under even noise such a part has the mean s^2 (|a|^2 - |u|^2), u = Z'a, where Z
/// has the orthonormal columns of the slopes: it is made up for what the fit takes out of it, much where a
/// few readings count for most. The sum scatters like a chi squared of few degrees of freedom, which follow
/// from its own mean and variance, so that Student's t takes the place of the normal distribution.
/// Percentiles alone have neither: with 41 readings of each curve they hold the truth in 0.88 to 0.93 of the
/// sets.
///
/// References: R. M. Bell and D. F. `McCaffrey`, *Bias reduction in standard errors*, Survey Methodology 28
/// (2002) 169; T. C. Hesterberg, *What teachers should know about the bootstrap*, The American Statistician
/// 69 (2015) 371, section 4.1 (expanded percentile intervals).
fn half_widths(fit: &Fit, regular: &RegularProblem<'_>, trial: &Trial) -> Option<[f64; 4]> {
    let rows: Vec<_> = fit.problem.rows.iter().map(|row| regular.weighed(trial, row)).collect();
    let mut slopes = Matrix4::zeros();
    for (_, slope) in rows.iter().flatten() {
        slopes += slope * slope.transpose();
    }
    if !fit.problem.fits_passage {
        slopes[(3, 3)] = 1.0;
    }
    let whitened = slopes.cholesky()?.l().try_inverse()?;
    let unit = |index: usize| Free::from_fn(|row, _| f64::from(u8::from(row == index)));
    // x0 = const - beta t0.
    let passage = Free::new(-trial.passage_time * regular.speed_slope(trial), 0.0, 0.0, -trial.speed.beta());
    let directions = [unit(0), unit(1), unit(2), passage].map(|direction| whitened * direction);
    // A robust fit is the linear one of its residuals as they count, over the mean derivative of these.
    let (slope, _) = fit.problem.influence(trial);
    Some(directions.map(|direction| {
        let (mut variance, mut mean, mut squares, mut taken) = (0.0, 0.0, 0.0, Matrix4::zeros());
        for readings in &rows {
            let columns = readings.map(|(_, slope)| whitened * slope);
            let weights = columns.map(|column| column.dot(&direction));
            let size: f64 = weights.iter().map(|weight| weight * weight).sum();
            let part = columns[0] * weights[0] + columns[1] * weights[1];
            let left = size - part.norm_squared();
            if left <= 0.0 {
                continue;
            }
            let made_up = (size / left).min(MOST_MADE_UP);
            variance += made_up * (weights[0] * readings[0].0 + weights[1] * readings[1].0).powi(2);
            mean += made_up * left;
            squares += made_up * made_up * size * (size - 2.0 * part.norm_squared());
            taken += part * part.transpose() * made_up;
        }
        let freedom = mean * mean / (squares + taken.norm_squared());
        student_975(freedom) * variance.sqrt() / slope
    }))
}

/// The 97.5th percentile of Student's t of this many degrees of freedom, at least 2: to 0.1 from 2 on, to
/// 0.001 from 6 on (M. Abramowitz and I. A. Stegun, 26.7.5).
fn student_975(freedom: f64) -> f64 {
    let z = NORMAL_975;
    let by_square =
        |coefficients: &[f64]| coefficients.iter().rev().fold(0.0, |sum, factor| sum * z * z + factor) * z;
    let terms = [
        by_square(&[1.0]),
        by_square(&[1.0, 1.0]) / 4.0,
        by_square(&[3.0, 16.0, 5.0]) / 96.0,
        by_square(&[-15.0, 17.0, 19.0, 3.0]) / 384.0,
        by_square(&[-945.0, -1920.0, 1482.0, 776.0, 79.0]) / 92_160.0,
    ];
    let inverse = 1.0 / freedom.max(2.0);
    terms.iter().rev().fold(0.0, |sum, term| sum * inverse + term)
}

fn damped(hessian: &Matrix4<f64>, damping: f64) -> Matrix4<f64> {
    hessian + Matrix4::from_diagonal(&(hessian.diagonal() * damping))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::aperture::Aperture;
    use crate::disparity::disparity;
    use crate::fit::{Curves, FitOptions, Observations, Reading, Sample, fit, fit_from};
    use crate::source::SourcePoint;
    use crate::speed::Speed;

    /// A curve with a deterministic ripple for noise.
    fn samples() -> Vec<Sample> {
        let speed = Speed::from_beta(0.8).expect("a speed");
        let point = SourcePoint { x0: 0.0, y: 1.0, z: 0.7 };
        let [left, right] = Aperture::pair(0.1);
        let sample = |index: u32| {
            let time = -1.0 + f64::from(index) / 25.0;
            let seen = disparity(&speed, point, left, right, time).expect("inside the domain");
            let value = seen.dphi + 1e-3 * math::sin(f64::from(index * index));
            Sample { time, pair: 0, dphi: Some(Reading { value, sigma: None }), dtheta: None }
        };
        (0..150).map(sample).collect()
    }

    #[test]
    fn a_replicate_is_the_fit_of_its_samples() {
        let samples = samples();
        let options = FitOptions { curves: Curves::Azimuth, ..FitOptions::default() };
        let observations = Observations::of_pair(0.1, samples.clone()).expect("usable samples");
        let best = fit(&observations, &options).expect("a fit");
        let replicates = bootstrap(&best, 20, 3).expect("replicates");
        for (stream, estimate) in replicates.estimates.iter().enumerate() {
            let mut counts = vec![0.0; samples.len()];
            draw(&mut counts, 3, stream as u64);
            let repeated = samples.iter().zip(&counts).flat_map(|(sample, &n)| vec![*sample; n as usize]);
            let drawn = Observations::of_pair(0.1, repeated.collect()).expect("usable samples");
            let refit = fit_from(&drawn, &options, best.values).expect("a fit");
            let estimate = estimate.expect("a fit");
            for &parameter in best.parameters() {
                let error = (estimate[parameter as usize] - refit.value(parameter)).abs();
                assert!(error < 2e-3 * best.standard_error(parameter), "{parameter:?}: {error:e}");
            }
        }
    }

    #[test]
    fn replicates_drawn_in_parts_are_those_drawn_at_once() {
        let observations = Observations::of_pair(0.1, samples()).expect("usable samples");
        let best = fit(&observations, &FitOptions { curves: Curves::Azimuth, ..FitOptions::default() });
        let best = best.expect("a fit");
        let mut parts = Bootstrap::default();
        for part in [1, 0, 12, 7] {
            parts.extend(&best, part, 3);
        }
        assert_eq!(parts.checked(), bootstrap(&best, 20, 3));
        assert!(Bootstrap::default().checked().is_err());
    }

    /// By `scipy.stats.t.ppf(0.975, nu)` of `SciPy` 1.17.1.
    #[test]
    fn students_percentiles_are_those_of_scipy() {
        for (freedom, expected, tolerance) in [
            (2.0, 4.302_652_729_749_462, 0.1),
            (3.5, 2.940_088_637_982_728, 0.01),
            (6.0, 2.446_911_851_144_978_6, 1e-3),
            (25.0, 2.059_538_552_753_297, 1e-5),
            (1e9, NORMAL_975, 1e-8),
        ] {
            let found = student_975(freedom);
            assert!((found - expected).abs() < tolerance, "{freedom}: {found} for {expected}");
        }
    }

    #[test]
    fn quantiles_interpolate_between_values() {
        let values = [1.0, 2.0, 4.0];
        assert_eq!([0.0, 0.25, 0.5, 0.75, 1.0].map(|p| quantile(&values, p)), [1.0, 1.5, 2.0, 3.0, 4.0]);
    }
}
