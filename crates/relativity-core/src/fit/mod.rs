//! Fits speed, distance and passage of a moving point to its measured disparities.
//!
//! Non-linear least squares (Levenberg-Marquardt, as in MINPACK) with analytic derivatives, in the
//! exact or the published model, for any number of pairs of apertures. No initial guess is needed. Whatever
//! the data cannot tell is an error in words, never a result.
//!
//! Conventions: y > 0, the object is in front of the apertures. (Behind them, Delta-phi has the other sign.)
//! Delta-phi alone, seen by apertures at z = 0, tells only |z|; Delta-theta tells the sign.
//!
//! Of a point on a wheel that rolls ([`Rolling`]) the hub is fitted. Its curves have many minima, since the
//! wheel may have turned some times more or less before it passes: the search starts from many speeds about
//! that of the smooth curve, and from other numbers of turns, which takes many times as long.
//!
//! References: the paper, sections 3(b) and 4(c); J. J. More, *The Levenberg-Marquardt algorithm:
//! implementation and theory* (1978).

mod curve;
mod descent;
mod error;
mod gradients;
mod loss;
mod observations;
mod options;
mod prepare;
mod problem;
mod regular;
mod rolling;
mod scatter;
mod search;
mod serial;
mod simulation;
mod start;
mod trial;
mod verdict;
mod wheel_start;

pub use error::{FitError, NotConverged};
pub use loss::{Loss, LossShape};
pub use observations::{Observations, Reading, Sample};
pub use options::{Curves, FitOptions, Parameter, Passage};
pub use scatter::standard_deviation;
pub use serial::{FALSE_ALARM, SerialCorrelation};
pub use simulation::Simulation;
pub use trial::Rolling;

pub(crate) use problem::{Free, NormalEquations, Problem};
pub(crate) use regular::{RegularProblem, height};
pub(crate) use trial::Trial;

use nalgebra::{Matrix4, Vector4};

use crate::math;
use descent::Minimum;
use prepare::PreparedData;
use search::Starts;

/// The accuracy of a fit of curves without noise: the largest error of beta, y, z and x0 for the paper's
/// object, with every choice of model and curves, x0 known or not (`tests/fit.rs`).
pub const NOISE_FREE_ERROR: f64 = 1e-9;

/// The factor by which the scale of a robust loss shrinks from the one that the search is made with.
const SOFTENING: f64 = 0.1;
/// Number of times that the scatter of a robust fit is found from its residuals, and the fit anew: by then
/// both have settled.
const ROBUST_ROUNDS: usize = 6;

/// The 97.5th percentile of the standard normal distribution: half the width of a 95 % interval.
pub(crate) const NORMAL_975: f64 = 1.959_963_984_540_054;

/// The best fit of a model to observations.
#[derive(Debug, Clone)]
pub struct Fit {
    /// Options that the fit was made with.
    pub options: FitOptions,
    /// Best values of beta, y, z, x0.
    pub values: [f64; 4],
    /// Covariance of the parameters by linearisation; 0 for a known x0. From the sigmas where all readings
    /// have one and the loss is linear, else scaled by the scatter of the residuals.
    pub covariance: [[f64; 4]; 4],
    /// Root mean square of the residuals of all fitted readings, radians; each as large as it counts.
    pub rms: f64,
    /// The scatter of each curve that the scale of a robust loss is in, radians, where it has no sigmas: from
    /// the median of its residuals.
    pub scatter: [Option<f64>; 2],
    /// The sum of squares per degree of freedom, in units of the sigmas; 1 within its scatter if the model
    /// and the sigmas are right. `None` without sigmas, and of a robust loss.
    pub reduced_chi_squared: Option<f64>,
    /// Readings that were fitted.
    pub readings: usize,
    /// Whether the residuals follow one another; `None` where they are rounding, within [`NOISE_FREE_ERROR`]
    /// of the curves' range, or where there are hardly more readings than parameters.
    pub serial: Option<SerialCorrelation>,
    /// The best fit on the other side of z = 0, where the search looked there: of a wheel's point seen in
    /// Delta-phi alone.
    pub other_side: Option<OtherSide>,
    pub(crate) problem: Problem,
    pub(crate) free: Free,
}

/// A minimum on the other side of z = 0 from the best fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OtherSide {
    /// Values of beta, y, z, x0 there.
    pub values: [f64; 4],
    /// Excess of chi squared on that side, with the variance of a weighed residual that the covariance has:
    /// the square of the number of standard deviations by which noise must mislead for this side to be the
    /// true one.
    pub excess: f64,
}

impl Fit {
    /// The fitted parameters: all, or all but a known x0.
    #[must_use]
    pub fn parameters(&self) -> &'static [Parameter] {
        &Parameter::ALL[..self.problem.parameters()]
    }

    /// Best value of `parameter`.
    #[must_use]
    pub fn value(&self, parameter: Parameter) -> f64 {
        self.values[parameter as usize]
    }

    /// Standard error of `parameter` by linearisation.
    #[must_use]
    pub fn standard_error(&self, parameter: Parameter) -> f64 {
        self.covariance[parameter as usize][parameter as usize].sqrt()
    }

    /// 95 % interval of `parameter` by linearisation, as far as the parameter goes: up to beta = 1, down to
    /// y = 0, and to z = 0 where only |z| matters.
    #[must_use]
    pub fn interval_95(&self, parameter: Parameter) -> [f64; 2] {
        let (value, half) = (self.value(parameter), NORMAL_975 * self.standard_error(parameter));
        let is_bounded = match parameter {
            Parameter::Beta | Parameter::Y => true,
            Parameter::Z => self.problem.is_even_in_z(),
            Parameter::X0 => false,
        };
        let least = if is_bounded { 0.0 } else { f64::NEG_INFINITY };
        let most = if parameter == Parameter::Beta { 1.0 } else { f64::INFINITY };
        [(value - half).max(least), (value + half).min(most)]
    }

    /// Whether the best value of `parameter` is the end of its domain: z = 0 where only |z| matters.
    #[must_use]
    pub fn is_at_limit(&self, parameter: Parameter) -> bool {
        parameter == Parameter::Z && self.values[2] == 0.0 && self.problem.is_even_in_z()
    }

    /// Correlation of two fitted parameters by linearisation.
    #[must_use]
    pub fn correlation(&self, a: Parameter, b: Parameter) -> f64 {
        let covariance = self.covariance[a as usize][b as usize];
        covariance / (self.standard_error(a) * self.standard_error(b))
    }

    /// Delta-phi and Delta-theta of the fitted object at `time`, for the given pair of apertures.
    #[must_use]
    pub fn angles(&self, pair: usize, time: f64) -> Option<[f64; 2]> {
        let trial = self.problem.trial(&self.free)?;
        Some(trial.angles(self.options.model, self.problem.pairs.get(pair)?, time))
    }
}

/// The object that fits `observations` best.
///
/// # Accuracy
///
/// Noise-free curves give the object back to [`NOISE_FREE_ERROR`]. Of noisy ones `tests/fit.rs` counts
/// how often the right minimum is found without a guess.
///
/// # Errors
///
/// Every variant of [`FitError`] but those of [`Observations::new`] and of the bootstrap.
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, FitOptions, Model, Parameter, Simulation, SourcePoint, Speed, fit};
///
/// let truth = Simulation {
///     speed: Speed::from_beta(0.9)?,
///     point: SourcePoint { x0: 0.0, y: 3.0, z: 2.0 },
///     rolling: None,
///     pair: Aperture::pair(0.1),
///     model: Model::Exact,
///     times: (0..100).map(|i| -1.0 + 0.1 * f64::from(i)).collect(),
///     noise: 0.01,
///     seed: 1,
/// };
/// let found = fit(&truth.observations()?, &FitOptions::default())?;
/// for (parameter, true_value) in [(Parameter::Beta, 0.9), (Parameter::Y, 3.0), (Parameter::Z, 2.0)] {
///     let error = (found.value(parameter) - true_value).abs();
///     assert!(error < 3.0 * found.standard_error(parameter) && error < 0.05);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fit(observations: &Observations, options: &FitOptions) -> Result<Fit, FitError> {
    let data = prepare::prepare(observations, options)?;
    let starts =
        if options.loss.is_robust() { robust_starts(&data) } else { search::best_starts(&data.problem) };
    let starts = starts.ok_or(FitError::NotConverged(NotConverged::NoStart))?;
    fit_downhill(data, options, &starts)
}

/// The best starts by a loss that is soft first, and harder with each descent.
fn robust_starts(data: &PreparedData) -> Option<Starts> {
    let mut factor = data.roughness();
    let mut starts = search::best_starts(&data.softened(factor))?;
    while factor > 1.0 {
        factor = (SOFTENING * factor).max(1.0);
        starts.best = descent::descent(&data.softened(factor), starts.best, descent::START_PATIENCE).free;
    }
    Some(starts)
}

/// The fit downhill of a guess of beta, y, z and x0: less work than [`fit`], if the guess is good.
///
/// # Errors
///
/// As [`fit`], and [`FitError::Guess`].
pub fn fit_from(observations: &Observations, options: &FitOptions, guess: [f64; 4]) -> Result<Fit, FitError> {
    let data = prepare::prepare(observations, options)?;
    let [beta, y, z, x0] = guess;
    let is_inside = (0.0..1.0).contains(&beta) && beta > 0.0 && y > 0.0 && z.is_finite() && x0.is_finite();
    if !is_inside {
        return Err(FitError::Guess { beta, y });
    }
    let passage_time = if data.problem.fits_passage { -x0 / beta } else { 0.0 };
    let best = Free::new(math::ln(math::atanh(beta)), math::ln(y), z, passage_time);
    fit_downhill(data, options, &Starts { best, other_side: None })
}

fn fit_downhill(mut data: PreparedData, options: &FitOptions, starts: &Starts) -> Result<Fit, FitError> {
    let mut minimum = descent::minimum(&data.problem, starts.best)?;
    if data.estimates_noise() {
        // Weights from the scatter about a first fit, twice: the weights move the fit a little. More often
        // from the rough scatter that a robust search begins with.
        for _ in 0..if options.loss.is_robust() { ROBUST_ROUNDS } else { 2 } {
            data.reweigh(&minimum.trial);
            minimum = descent::minimum(&data.problem, minimum.free)?;
        }
    }
    let other_side = starts.other_side.and_then(|start| descent::minimum(&data.problem, start).ok());
    let mut other_side = other_side.filter(|other| other.trial.z * minimum.trial.z < 0.0);
    // The weights may have moved since the search.
    if let Some(other) = other_side.as_mut().filter(|other| other.cost < minimum.cost) {
        std::mem::swap(&mut minimum, other);
    }
    verdict::check_explained(&data, minimum.cost)?;
    let Minimum { mut free, mut trial, cost } = minimum;
    if data.problem.is_even_in_z() {
        free[2] = free[2].abs();
        trial.z = trial.z.abs();
    }
    let reduced = cost / data.degrees_of_freedom();
    let is_robust = options.loss.is_robust();
    let scatter = if data.has_all_sigmas && !is_robust { 1.0 } else { reduced };
    let (covariance, scatter) = verdict::covariance(&data.problem, &trial, scatter)?;
    let rms = data.rms(&trial, [true, true]);
    let is_noisy = rms > NOISE_FREE_ERROR * data.range();
    let serial = if is_noisy { SerialCorrelation::of(&data.problem, &trial) } else { None };
    Ok(Fit {
        options: *options,
        values: trial.reported(),
        covariance: reported_covariance(&data.problem, &trial, &covariance),
        rms,
        scatter: data.scatter(),
        serial,
        reduced_chi_squared: (data.has_all_sigmas && !is_robust).then_some(reduced),
        readings: data.problem.readings(),
        other_side: other_side
            .map(|other| OtherSide { values: other.trial.reported(), excess: (other.cost - cost) / scatter }),
        problem: data.problem,
        free,
    })
}

/// From the covariance of the free parameters to that of the reported ones.
fn reported_covariance(problem: &Problem, trial: &Trial, covariance: &Matrix4<f64>) -> [[f64; 4]; 4] {
    let mut jacobian = Matrix4::from_diagonal(&Vector4::from(problem.chain(trial)));
    // x0 = const - beta t0.
    jacobian[(3, 0)] = -trial.passage_time * jacobian[(0, 0)];
    jacobian[(3, 3)] *= -trial.speed.beta();
    // nalgebra's arrays are columns; a covariance is symmetric.
    (jacobian * covariance * jacobian.transpose()).into()
}
