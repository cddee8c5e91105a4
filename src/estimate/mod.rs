//! The report of `gamow fit`: one structure, written as JSON or as a table; and its data, [`data`] from files
//! and [`samples`] of a point.

pub mod data;
pub mod other_side;
pub mod samples;
pub mod sigmas;

use std::fmt;

use relativity_core::{
    Bootstrap, Combined, Curves, Fit, FitError, FitOptions, Observations, Parameter, Rolling, combined, fit,
};
use serde::{Deserialize, Serialize};

use crate::number_text;

/// The fit, and with both curves also the fit of each and their weighted mean.
#[derive(Debug, Serialize)]
pub struct FitReport {
    /// The name of the [`Model`](relativity_core::Model).
    pub model: &'static str,
    /// Always true: what did not converge is an error.
    pub converged: bool,
    /// Whether the eyes rode past a point at rest: beta is their own speed, and x0 by how much the point is
    /// behind them when their clock shows 0, contracted.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub riding: bool,
    /// Place of the point on its wheel, if it is on one: y, z and x0 are its hub's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wheel: Option<WheelPlace>,
    /// Fit of all curves together.
    #[serde(flatten)]
    pub fit: CurvesFit,
    /// Remark on the sigmas, if the scatter is another than theirs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sigmas: Option<String>,
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

/// A value and its uncertainty.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Best value of the parameter.
    pub value: f64,
    /// Standard error, by the bootstrap if there was one.
    pub uncertainty: f64,
    /// Interval that holds 95 %.
    pub ci95: [f64; 2],
    /// Standard error from the covariance at the best fit.
    pub uncertainty_linear: f64,
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
    /// Weighted mean.
    pub value: f64,
    /// Standard error of the mean.
    pub uncertainty: f64,
    /// Interval that holds 95 % of the replicates.
    pub ci95: [f64; 2],
    /// Correlation between both estimates.
    pub correlation: f64,
    /// By how many of its own standard errors the difference of both estimates is off 0.
    pub disagreement: f64,
}

impl From<Combined> for Mean {
    fn from(mean: Combined) -> Self {
        Self {
            value: mean.value,
            uncertainty: mean.standard_error,
            ci95: mean.interval_95,
            correlation: mean.correlation,
            disagreement: mean.disagreement,
        }
    }
}

/// Number of samples drawn in a round of replicates, before it is checked whether more are wanted: some
/// tenths of a second. But no less replicates than keep all threads busy.
const ROUND_SAMPLES: usize = 1_000_000;
const LEAST_ROUND: usize = 16;
const MOST_ROUND: usize = 4096;

/// Difference of the estimates of both curves, in standard errors, beyond which it is remarked on.
const AGREEING: f64 = 3.0;

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
        let model = options.model.name();
        let fit = CurvesFit::new(&joint);
        let sigmas = sigmas::remark(fit.reduced_chi_squared, fit.readings, fit.parameters.iter().count());
        let wheel = options.rolling.map(WheelPlace::from);
        Ok(Self { model, converged: true, riding: false, wheel, sigmas, fit, bootstrap, fits })
    }
}

impl Fits {
    fn new(azimuth: Result<BootstrappedFit, FitError>, polar: Result<BootstrappedFit, FitError>) -> Self {
        let combined = match (&azimuth, &polar) {
            (Ok((azimuth, Some(a))), Ok((polar, Some(p)))) => {
                let mean = |parameter| combined((azimuth, a), (polar, p), parameter).into();
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
            reduced_chi_squared: fit.reduced_chi_squared,
            readings: fit.readings,
            other_side: other_side::remark(fit),
        }
    }
}

/// `parameter` and its uncertainty: by the bootstrap, or from the covariance without one.
#[must_use]
pub fn estimate(fit: &Fit, bootstrap: Option<&Bootstrap>, parameter: Parameter) -> Estimate {
    let value = fit.value(parameter);
    let uncertainty_linear = fit.standard_error(parameter);
    let (uncertainty, ci95) = bootstrap.map_or_else(
        || (uncertainty_linear, fit.interval_95(parameter)),
        |bootstrap| (bootstrap.standard_error(parameter), bootstrap.interval_95(parameter)),
    );
    Estimate { value, uncertainty, ci95, uncertainty_linear }
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

impl fmt::Display for FitReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "model      {}", self.model)?;
        if self.riding {
            let x0 = "x0 how far the point is behind when the clock shows 0, contracted";
            writeln!(f, "riding     beta is the observer's own speed, {x0}")?;
        }
        if let Some(WheelPlace { wheel_radius, rho, angle }) = self.wheel {
            let known = format!("radius {wheel_radius}, rho {rho}, angle {angle}");
            writeln!(f, "wheel      {known}, taken as known: y, z and x0 are the hub's")?;
        }
        match &self.bootstrap {
            Some(BootstrapSummary { replicates, failed, seed }) => {
                writeln!(f, "bootstrap  {replicates} replicates, seed {seed}, {failed} failed")?;
            }
            None => writeln!(f, "bootstrap  none")?,
        }
        if let Some(remark) = &self.sigmas {
            writeln!(f, "sigmas     {remark}")?;
        }
        write!(f, "{}", self.fit)?;
        for (name, attempt) in [("dphi", &self.fits.dphi), ("dtheta", &self.fits.dtheta)] {
            match attempt {
                Some(Attempt::Fit(outcome)) => write!(f, "{outcome}")?,
                Some(Attempt::Failure { problem }) => writeln!(f, "\n{name}: no fit: {problem}")?,
                None => {}
            }
        }
        let Some(combined) = &self.fits.combined else { return Ok(()) };
        writeln!(f, "\nweighted mean of dphi and dtheta")?;
        writeln!(f, "  {:29} {:24} correlation", "     value +- uncertainty", "95 % interval")?;
        for (parameter, mean) in combined.iter() {
            write_estimate(f, parameter, mean.value, mean.uncertainty, mean.ci95)?;
            writeln!(f, "  {}", correlation_text(mean.correlation))?;
        }
        for (parameter, mean) in combined.iter().filter(|(_, mean)| mean.disagreement > AGREEING) {
            let (name, sigmas) = (parameter.name(), number_text::significant(mean.disagreement, 2));
            writeln!(
                f,
                "  {name} differs by {sigmas} standard errors between dphi and dtheta: the model may be wrong"
            )?;
        }
        Ok(())
    }
}

impl fmt::Display for CurvesFit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\n{}: {} readings, rms {:.3e} rad", self.curves, self.readings, self.rms)?;
        match self.reduced_chi_squared {
            Some(reduced) => writeln!(f, ", reduced chi squared {reduced:.3}")?,
            None => writeln!(f)?,
        }
        writeln!(f, "  {:29} {:24} linear     correlations", "     value +- uncertainty", "95 % interval")?;
        for ((parameter, estimate), correlations) in self.parameters.iter().zip(&self.correlations) {
            write_estimate(f, parameter, estimate.value, estimate.uncertainty, estimate.ci95)?;
            write!(f, "  {:.1e} ", estimate.uncertainty_linear)?;
            for correlation in correlations {
                write!(f, "{:>7}", correlation_text(*correlation))?;
            }
            writeln!(f)?;
        }
        if let Some(remark) = &self.other_side {
            writeln!(f, "  {remark}")?;
        }
        Ok(())
    }
}

/// Returns the correlation; a dash for parameters that no replicate moves, as without noise.
fn correlation_text(correlation: f64) -> String {
    if correlation.is_finite() { format!("{correlation:.3}") } else { "-".to_owned() }
}

/// A line of a table, with as many decimals as the uncertainty calls for.
fn write_estimate(
    f: &mut fmt::Formatter<'_>,
    parameter: Parameter,
    value: f64,
    uncertainty: f64,
    [low, high]: [f64; 2],
) -> fmt::Result {
    let decimals = number_text::decimals_of(uncertainty);
    let value = format!("{value:.decimals$} +- {uncertainty:.decimals$}");
    let interval = format!("{low:.decimals$} ... {high:.decimals$}");
    write!(f, "  {:5}{value:24} {interval:24}", parameter.name())
}
