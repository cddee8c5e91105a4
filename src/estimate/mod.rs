//! The report of `gamow fit`: one structure, written as JSON or as a table; and its data, [`data`] from files
//! and [`samples`] of a point.

pub mod cause;
mod command;
pub mod correction;
pub mod data;
pub mod data_file;
pub mod left_out;
mod loss;
pub mod other_side;
pub mod outliers;
pub mod residuals;
pub mod samples;
pub mod sigmas;
mod table;

use relativity_core::{
    Bootstrap, Curves, Fit, FitError, FitOptions, Observations, Parameter, Rolling, combined, fit,
};
use serde::{Deserialize, Serialize};

use crate::number_text;
use loss::LossReport;
use outliers::Outlier;
use residuals::Residuals;

/// The fit, and with both curves also the fit of each and their weighted mean.
#[derive(Debug, Serialize)]
pub struct FitReport {
    /// The name of the [`Model`](relativity_core::Model).
    pub model: &'static str,
    /// What was done to the file before it was fitted, if anything was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub data: Option<String>,
    /// Always true: what did not converge is an error.
    pub converged: bool,
    /// Whether the eyes rode past a point at rest: beta is their own speed, and x0 by how much the point is
    /// behind them when their clock shows 0, contracted.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub riding: bool,
    /// Place of the point on its wheel, if it is on one: y, z and x0 are its hub's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wheel: Option<WheelPlace>,
    /// The loss function, unless it is linear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loss: Option<LossReport>,
    /// Fit of all curves together.
    #[serde(flatten)]
    pub fit: CurvesFit,
    /// Remark on the sigmas, if the scatter is another than theirs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sigmas: Option<String>,
    /// Warning that the fit cannot be right, as residuals follow one another.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub warning: Option<String>,
    /// What may be wrong, if something explains the readings, with the command that takes it into account.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cause: Option<String>,
    /// Readings that stand out.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub outliers: Vec<Outlier>,
    /// The line of each reading's row in its file; none of simulated ones.
    #[serde(skip)]
    pub lines: Vec<u64>,
    /// For dphi and dtheta the residual of each row, reading minus fit, radians; NaN where there is none.
    #[serde(skip)]
    pub misses: [Vec<f64>; 2],
    /// The bootstrap behind the uncertainties.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bootstrap: Option<BootstrapSummary>,
    /// Each curve on its own, and both together in the paper's way.
    pub fits: Fits,
}

/// The place of a point on a rolling wheel, which is taken for known.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct WheelPlace {
    /// The radius on which the wheel rolls.
    pub wheel_radius: f64,
    /// Distance of the point from the axle, in radii.
    pub rho: f64,
    /// Angle of the point when the wheel's own clock shows 0, radians.
    pub angle: f64,
}

impl From<Rolling> for WheelPlace {
    fn from(Rolling { radius, rho, angle }: Rolling) -> Self {
        Self { wheel_radius: radius, rho, angle }
    }
}

/// A fit of one set of curves.
#[derive(Debug, Serialize)]
pub struct CurvesFit {
    /// Name of the curves: `dphi`, `dtheta` or `both`.
    pub curves: &'static str,
    /// Best values and their uncertainties.
    pub parameters: Parameters<Estimate>,
    /// Correlations, in the order of `parameters`.
    pub correlations: Vec<Vec<f64>>,
    /// Root mean square of the residuals, radians.
    pub rms: f64,
    /// The test of the residuals; none where they are rounding.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub residuals: Option<Residuals>,
    /// Chi squared per degree of freedom, if there were sigmas.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reduced_chi_squared: Option<f64>,
    /// Number of readings fitted.
    pub readings: usize,
    /// The remark on z of the other sign, where that fits within the noise too.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub other_side: Option<String>,
}

/// Values, one for each parameter.
#[derive(Debug, Clone, Serialize)]
pub struct Parameters<T> {
    /// Speed over c, beta.
    pub beta: T,
    /// Depth y.
    pub y: T,
    /// Height z.
    pub z: T,
    /// Objective x at t = 0, if it was fitted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x0: Option<T>,
}

/// A value and its uncertainty, as far as there is one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Best value of the parameter.
    pub value: f64,
    /// Standard error, by the bootstrap if there was one. None follows where the residuals are no chance, and
    /// none is one number where the value is at its limit.
    pub uncertainty: Option<f64>,
    /// Interval that holds 95 %, where the residuals are chance.
    pub ci95: Option<[f64; 2]>,
    /// Standard error from the covariance at the best fit, likewise.
    pub uncertainty_linear: Option<f64>,
    /// Standard deviation over the replicates, or that from the covariance: how many digits are worth
    /// showing.
    pub scatter: f64,
}

impl Estimate {
    /// Number of decimals that are worth showing.
    #[must_use]
    pub fn decimals(&self) -> usize {
        let width = self.ci95.map_or(0.0, |[low, high]| high - low);
        // At a limit the replicates may all be there.
        number_text::decimals_of(if self.scatter > 0.0 { self.scatter } else { width })
    }
}

/// The summary of a bootstrap.
#[derive(Debug, Serialize)]
pub struct BootstrapSummary {
    /// Number of replicates drawn.
    pub replicates: usize,
    /// Number of replicates without a fit.
    pub failed: usize,
    /// Seed of the random numbers.
    pub seed: u64,
}

/// Fits of single curves.
#[derive(Debug, Default, Serialize)]
pub struct Fits {
    /// Fit of the azimuths alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dphi: Option<Attempt>,
    /// Fit of the elevations alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dtheta: Option<Attempt>,
    /// Weighted mean of both.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub combined: Option<Parameters<Mean>>,
}

/// A fit of a single curve, or why there is none.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum Attempt {
    /// A fit that was found.
    Fit(Box<CurvesFit>),
    /// No fit.
    Failure {
        /// Reason why there is none.
        problem: String,
    },
}

/// A weighted mean of two estimates.
#[derive(Debug, Clone, Serialize)]
pub struct Mean {
    /// Weighted mean; none where one of the estimates is at its limit, so that its weight is none.
    pub value: Option<f64>,
    /// Standard error of the mean, where the residuals of both fits are chance.
    pub uncertainty: Option<f64>,
    /// Interval that holds 95 % of the replicates, likewise.
    pub ci95: Option<[f64; 2]>,
    /// Correlation between both estimates.
    pub correlation: f64,
    /// By how many of its own standard errors the difference of both estimates is off 0.
    pub disagreement: f64,
}

impl Mean {
    /// The mean of both fits' estimates of `parameter`.
    fn new(azimuth: (&Fit, &Bootstrap), polar: (&Fit, &Bootstrap), parameter: Parameter) -> Self {
        let mean = combined(azimuth, polar, parameter);
        let is_one = ![azimuth.0, polar.0].iter().any(|fit| fit.is_at_limit(parameter));
        let is_stated = is_one && residuals::are_chance(azimuth.0) && residuals::are_chance(polar.0);
        Self {
            value: is_one.then_some(mean.value),
            uncertainty: is_stated.then_some(mean.standard_error),
            ci95: is_stated.then_some(mean.interval_95),
            correlation: mean.correlation,
            disagreement: if is_one { mean.disagreement } else { 0.0 },
        }
    }
}

/// Number of samples drawn in a round of replicates, before it is checked whether more are wanted: some
/// tenths of a second. But no less replicates than keep all threads busy.
const ROUND_SAMPLES: usize = 1_000_000;
const LEAST_ROUND: usize = 16;
const MOST_ROUND: usize = 4096;

/// A fit and its bootstrap, if there is one.
type BootstrappedFit = (Fit, Option<Bootstrap>);

impl FitReport {
    /// Fits `observations`, with `replicates` bootstrap replicates unless that is 0.
    pub fn new(
        observations: &Observations,
        options: &FitOptions,
        replicates: usize,
        seed: u64,
    ) -> Result<Self, FitError> {
        Self::while_wanted(observations, options, replicates, seed, |_| true)
    }

    /// Fits likewise with the replicates drawn until `is_wanted`, which is called with their number, becomes
    /// false; with less than 2 there is no bootstrap.
    pub fn while_wanted(
        observations: &Observations,
        options: &FitOptions,
        replicates: usize,
        seed: u64,
        mut is_wanted: impl FnMut(usize) -> bool,
    ) -> Result<Self, FitError> {
        let best = |curves| fit(observations, &FitOptions { curves, ..*options });
        let mut fits = vec![(Ok(best(options.curves)?), Bootstrap::default())];
        if options.curves == Curves::Both {
            fits.extend([Curves::Azimuth, Curves::Polar].map(|curves| (best(curves), Bootstrap::default())));
        }
        let round = (ROUND_SAMPLES / observations.samples().len().max(1)).clamp(LEAST_ROUND, MOST_ROUND);
        let mut drawn = 0;
        while drawn < replicates && is_wanted(drawn) {
            let more = round.min(replicates - drawn);
            for (fit, bootstrap) in &mut fits {
                if let Ok(fit) = fit {
                    bootstrap.extend(fit, more, seed);
                }
            }
            drawn += more;
        }
        let mut fitted = fits
            .into_iter()
            .map(|(fit, bootstrap)| Ok((fit?, if drawn < 2 { None } else { Some(bootstrap.checked()?) })));
        let joint: BootstrappedFit =
            fitted.next().transpose()?.ok_or(FitError::Bootstrap { failed: 0, replicates })?;
        let bootstrap =
            joint.1.as_ref().map(|b| BootstrapSummary { replicates: drawn, failed: b.failed(), seed });
        let fits = match (fitted.next(), fitted.next()) {
            (Some(azimuth), Some(polar)) => Fits::new(azimuth, polar),
            _ => Fits::default(),
        };
        let outliers = outliers::find(&joint.0, observations);
        let misses = residuals::misses(&joint.0, observations);
        let model = options.model.name();
        let fit = CurvesFit::new(&joint);
        let sigmas = sigmas::remark(fit.reduced_chi_squared, fit.readings, fit.parameters.iter().count());
        let wheel = options.rolling.map(WheelPlace::from);
        let loss = LossReport::of(&joint.0);
        let of_curve = |attempt: &Option<Attempt>| match attempt {
            Some(Attempt::Fit(fit)) => fit.residuals,
            _ => None,
        };
        let tested =
            [(fit.curves, fit.residuals), ("dphi", of_curve(&fits.dphi)), ("dtheta", of_curve(&fits.dtheta))];
        let warning = residuals::remark(&tested);
        Ok(Self {
            model,
            data: None,
            warning,
            cause: None,
            outliers,
            converged: true,
            riding: false,
            wheel,
            loss,
            lines: Vec::new(),
            misses,
            sigmas,
            fit,
            bootstrap,
            fits,
        })
    }
}

impl Fits {
    fn new(azimuth: Result<BootstrappedFit, FitError>, polar: Result<BootstrappedFit, FitError>) -> Self {
        let combined = match (&azimuth, &polar) {
            (Ok((azimuth, Some(a))), Ok((polar, Some(p)))) => {
                let mean = |parameter| Mean::new((azimuth, a), (polar, p), parameter);
                Some(Parameters::new(azimuth.parameters(), mean))
            }
            _ => None,
        };
        Self { dphi: Some(Attempt::new(azimuth)), dtheta: Some(Attempt::new(polar)), combined }
    }
}

impl Attempt {
    fn new(fitted: Result<BootstrappedFit, FitError>) -> Self {
        match fitted {
            Ok(fitted) => Self::Fit(Box::new(CurvesFit::new(&fitted))),
            Err(error) => Self::Failure { problem: error.to_string() },
        }
    }
}

impl CurvesFit {
    fn new((fit, bootstrap): &BootstrappedFit) -> Self {
        let correlation = |&a: &Parameter, &b: &Parameter| match bootstrap {
            Some(bootstrap) => bootstrap.correlation(a, b),
            None => fit.correlation(a, b),
        };
        let parameters = fit.parameters();
        let row = |a: &Parameter| parameters.iter().map(|b| correlation(a, b)).collect();
        Self {
            curves: fit.options.curves.name(),
            parameters: Parameters::new(parameters, |parameter| estimate(fit, bootstrap.as_ref(), parameter)),
            correlations: parameters.iter().map(row).collect(),
            rms: fit.rms,
            residuals: fit.serial.map(Residuals::from),
            reduced_chi_squared: fit.reduced_chi_squared,
            readings: fit.readings,
            other_side: other_side::remark(fit),
        }
    }
}

/// `parameter` and its uncertainty: by the bootstrap, or from the covariance without one.
#[must_use]
pub fn estimate(fit: &Fit, bootstrap: Option<&Bootstrap>, parameter: Parameter) -> Estimate {
    let linear = fit.standard_error(parameter);
    let (scatter, ci95) = bootstrap.map_or_else(
        || (linear, fit.interval_95(parameter)),
        |bootstrap| (bootstrap.standard_error(parameter), bootstrap.interval_95(parameter)),
    );
    let is_stated = residuals::are_chance(fit);
    let is_one = is_stated && !fit.is_at_limit(parameter);
    Estimate {
        value: fit.value(parameter),
        uncertainty: is_one.then_some(scatter),
        ci95: is_stated.then_some(ci95),
        uncertainty_linear: is_stated.then_some(linear),
        scatter,
    }
}

impl<T> Parameters<T> {
    fn new(parameters: &[Parameter], of: impl Fn(Parameter) -> T) -> Self {
        let x0 = parameters.contains(&Parameter::X0).then(|| of(Parameter::X0));
        Self { beta: of(Parameter::Beta), y: of(Parameter::Y), z: of(Parameter::Z), x0 }
    }

    fn iter(&self) -> impl Iterator<Item = (Parameter, &T)> {
        let all = [Some(&self.beta), Some(&self.y), Some(&self.z), self.x0.as_ref()];
        Parameter::ALL.into_iter().zip(all).filter_map(|(parameter, value)| Some((parameter, value?)))
    }
}
