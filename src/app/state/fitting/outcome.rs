//! A fit for the window: the samples, the point that fits them best, its uncertainty by the bootstrap, and
//! what there is to draw.

use std::time::Duration;

use egui_plot::PlotPoint;
use gamow_platform::clock::Instant;
use gamow_platform::threads::prelude::*;
use relativity_core::bootstrap::percentiles_95;
use relativity_core::{
    Aperture, Bootstrap, DEFAULT_REPLICATES, Fit, FitOptions, Observations, Parameter, Rolling,
    Sample as Measured, Source, SourcePoint, Speed, Turning, WheelPoint, fit,
};
use serde::{Deserialize, Serialize};

use super::plot_line::PlotLine;
use crate::app::state::plots::curves::Bends;
use crate::app::tools::worker::{StepOutcome, Wanted, Work};
use crate::estimate::outliers::{self, Outlier};
use crate::estimate::residuals::{self, Residuals};
use crate::estimate::samples::{FitKey, Fittable, Samples, Simulated};
use crate::estimate::{Estimate, estimate, other_side};
use crate::plot::CurveSample;

/// The samples and what became of them.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct FitOutcome {
    /// Key of the fit.
    pub key: FitKey,
    /// First and last T of the samples.
    pub range: [f64; 2],
    /// The samples, in their order.
    pub samples: Vec<Measured>,
    /// Samples of Delta-phi and of Delta-theta.
    pub data: [PlotLine; 2],
    /// The fit, or why there is none.
    pub fitted: Result<Fitted, String>,
    /// Bias of the fitted model on simulated curves without noise: fitted minus true beta, y and z, or the
    /// reason why it fits nothing. `None` for the model by which they are made, and of measured ones.
    pub bias: Option<Result<[f64; 3], String>>,
    /// Duration of the fit.
    pub elapsed: Duration,
}

/// A fit that was made.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Fitted {
    /// Each fitted parameter, its best value with uncertainty, and its true value if that is known.
    pub estimates: Vec<(Parameter, Estimate, Option<f64>)>,
    /// Delta-phi and Delta-theta of the best fit for each sample.
    pub at_samples: Vec<Option<[f64; 2]>>,
    /// Delta-phi and Delta-theta; `None` if not fitted.
    pub curves: [Option<FittedCurve>; 2],
    /// Root mean square of the residuals, radians.
    pub rms: f64,
    /// Chi squared per degree of freedom, if there were sigmas.
    pub reduced_chi_squared: Option<f64>,
    /// Number of readings fitted.
    pub readings: usize,
    /// The test of the residuals; none where they are rounding.
    pub residuals: Option<Residuals>,
    /// Warning that the fit cannot be right, as its residuals follow one another.
    pub warning: Option<String>,
    /// What may be wrong with a file's readings, if something explains them, with the command that fits them
    /// then.
    pub cause: Option<String>,
    /// Readings that stand out, in words.
    pub outliers: Option<String>,
    /// The remark on z of the other sign, where that fits within the noise too.
    pub other_side: Option<String>,
    /// Why the uncertainties are by linearisation, not by the bootstrap.
    pub no_bootstrap: Option<String>,
}

/// A fitted curve, with its residuals.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct FittedCurve {
    /// The curve of the best fit; of several pairs of eyes that of the first.
    pub line: PlotLine,
    /// Band of 95 % of the bootstrap's curves at each point of `line`, minus the best
    /// fit; empty without a bootstrap.
    pub band: Vec<[f64; 2]>,
    /// Sample minus best fit.
    pub residuals: PlotLine,
    /// Samples that stand out, and what is left of these.
    pub outliers: [PlotLine; 2],
}

/// Greatest number of times at which the band is computed; in between it is interpolated.
const BAND_TIMES: usize = 120;

/// Replicates drawn in a step.
const REPLICATES_A_STEP: usize = 100;

/// The making of a fit: the best fit, then the replicates in steps, then what is drawn.
pub struct FitSteps {
    key: FitKey,
    start: Instant,
    begun: Option<Begun>,
}

/// Samples, their best fit, and the replicates so far.
struct Begun {
    samples: Fittable,
    best: Fit,
    replicates: Bootstrap,
}

impl Work for FitSteps {
    const NAME: &'static str = "fit";
    type Base = ();
    type Job = FitKey;
    type Result = FitOutcome;
    type Tools = ();

    fn begin((): (), key: FitKey) -> Self {
        Self { key, start: Instant::now(), begun: None }
    }

    fn step(&mut self, (): &mut (), _: &Wanted) -> StepOutcome<FitOutcome> {
        let Some(begun) = &mut self.begun else {
            return match self.key.fittable() {
                Ok(samples) => self.begin_with(samples),
                Err(problem) => StepOutcome::Last(Some(self.outcome([0.0, 1.0], Vec::new(), Err(problem)))),
            };
        };
        let missing = DEFAULT_REPLICATES - begun.replicates.estimates.len();
        if missing > 0 {
            begun.replicates.extend(&begun.best, missing.min(REPLICATES_A_STEP), self.key.setup.seed);
            return StepOutcome::More;
        }
        let Some(Begun { samples, best, replicates }) = self.begun.take() else {
            return StepOutcome::Last(None);
        };
        let range = range(&self.key, &samples.observations);
        let fitted = Fitted::new(&self.key, &samples, range, &best, replicates);
        StepOutcome::Last(Some(self.outcome(range, samples.observations.samples().to_vec(), fitted)))
    }
}

impl FitSteps {
    /// Finds the best fit of the samples; it ends the job if there is none.
    fn begin_with(&mut self, samples: Fittable) -> StepOutcome<FitOutcome> {
        match fit(&samples.observations, &samples.options) {
            Ok(best) => {
                self.begun = Some(Begun { samples, best, replicates: Bootstrap::default() });
                StepOutcome::More
            }
            Err(error) => {
                let range = range(&self.key, &samples.observations);
                let samples = samples.observations.samples().to_vec();
                StepOutcome::Last(Some(self.outcome(range, samples, Err(error.to_string()))))
            }
        }
    }

    /// The outcome with these samples.
    fn outcome(&self, range: [f64; 2], samples: Vec<Measured>, fitted: Result<Fitted, String>) -> FitOutcome {
        let key = self.key.clone();
        let data = data(&samples);
        let simulated = key.simulated().filter(|simulated| simulated.model != key.setup.model);
        let bias = simulated.map(|simulated| bias(&key, simulated));
        FitOutcome { key, range, samples, data, fitted, bias, elapsed: self.start.elapsed() }
    }
}

/// First and last T that are plotted.
fn range(key: &FitKey, observed: &Observations) -> [f64; 2] {
    if let Samples::Simulated(simulated) = &key.samples {
        return simulated.range;
    }
    let times = || observed.samples().iter().map(|sample| sample.time);
    let [first, last] = [times().fold(f64::INFINITY, f64::min), times().fold(f64::NEG_INFINITY, f64::max)];
    if first < last { [first, last] } else { [0.0, 1.0] }
}

fn data(samples: &[Measured]) -> [PlotLine; 2] {
    [0, 1].map(|curve| {
        let point = |sample: &Measured| Some(PlotPoint::new(sample.time, reading(sample, curve)?));
        samples.iter().filter_map(point).collect()
    })
}

/// Returns the angle of the sample's reading of a curve, 0 for Delta-phi and 1 for Delta-theta, if it was
/// taken.
#[must_use]
pub fn reading(sample: &Measured, curve: usize) -> Option<f64> {
    sample.readings()[curve].map(|reading| reading.value)
}

fn bias(key: &FitKey, simulated: &Simulated) -> Result<[f64; 3], String> {
    let options = key.fittable()?.options;
    let clean = simulated.observations(&key.setup, 0.0)?;
    let best = fit(&clean, &options).map_err(|error| error.to_string())?;
    let truth = |parameter| simulated.true_value(parameter, key.setup.curves);
    Ok([Parameter::Beta, Parameter::Y, Parameter::Z].map(|p| best.value(p) - truth(p)))
}

impl Fitted {
    /// Best value of `parameter`, if it was fitted.
    #[must_use]
    pub fn value(&self, parameter: Parameter) -> Option<f64> {
        let found = self.estimates.iter().find(|(fitted, ..)| *fitted == parameter);
        found.map(|(_, estimate, _)| estimate.value)
    }

    fn new(
        key: &FitKey,
        samples: &Fittable,
        range: [f64; 2],
        best: &Fit,
        replicates: Bootstrap,
    ) -> Result<Self, String> {
        let (replicates, no_bootstrap) = match replicates.checked() {
            Ok(replicates) => (Some(replicates), None),
            Err(error) => (None, Some(error.to_string())),
        };
        let estimate = |&parameter: &Parameter| {
            let truth = key.simulated().map(|point| point.true_value(parameter, samples.options.curves));
            (parameter, estimate(best, replicates.as_ref(), parameter), truth)
        };
        let estimates: Vec<_> = best.parameters().iter().map(estimate).collect();
        if estimates.iter().any(|(_, estimate, _)| !estimate.value.is_finite()) {
            return Err("the best fit has a parameter that is not finite".to_owned());
        }
        let residuals = best.serial.map(Residuals::from);
        let is_chance = residuals::are_chance(best);
        let observed = &samples.observations;
        let mut found = outliers::find(best, observed);
        outliers::name_lines(&mut found, &samples.lines);
        let at_samples: Vec<_> =
            observed.samples().iter().map(|sample| fitted_angles(best, sample.pair, sample.time)).collect();
        Ok(Self {
            estimates,
            // No band where no uncertainty follows.
            curves: curves(
                key,
                (observed, &at_samples),
                range,
                best,
                (replicates.as_ref().filter(|_| is_chance), &found),
            ),
            at_samples,
            rms: best.rms,
            reduced_chi_squared: best.reduced_chi_squared,
            readings: best.readings,
            residuals,
            warning: residuals::remark(&[(best.options.curves.name(), residuals)]),
            cause: if is_chance { None } else { key.cause(samples, best.rms) },
            outliers: outliers::remark(&found),
            other_side: other_side::remark(best),
            no_bootstrap,
        })
    }
}

/// Delta-phi and Delta-theta of the best fit for a pair of eyes, where they are numbers.
fn fitted_angles(best: &Fit, pair: usize, time: f64) -> Option<[f64; 2]> {
    best.angles(pair, time).filter(|angles| angles.iter().all(|angle| angle.is_finite()))
}

/// Returns the fitted curves for drawing: samples, and the best fit's curve of each.
fn curves(
    key: &FitKey,
    (observed, at_samples): (&Observations, &[Option<[f64; 2]>]),
    range: [f64; 2],
    best: &Fit,
    (replicates, outliers): (Option<&Bootstrap>, &[Outlier]),
) -> [Option<FittedCurve>; 2] {
    let Some(&pair) = observed.pairs().first() else { return [None, None] };
    let bends = bends_of(key, pair, range, best);
    let lines = bends.sampling(range).samples(|time| fitted_angles(best, 0, time));
    let eyes = (best.options, pair);
    let bands = replicates.map(|replicates| bands(eyes, &lines, replicates)).unwrap_or_default();
    let used = best.options.curves.used();
    [0, 1].map(|curve| {
        let residual = |(sample, fitted): (&Measured, &Option<[f64; 2]>)| {
            Some(PlotPoint::new(sample.time, reading(sample, curve)? - (*fitted)?[curve]))
        };
        let value = |(sample, _): (&Measured, _)| Some(PlotPoint::new(sample.time, reading(sample, curve)?));
        let samples = || observed.samples().iter().zip(at_samples);
        let of_curve = outliers.iter().filter(|found| found.curve == curve);
        let places: Vec<usize> = of_curve.map(|found| found.sample).collect();
        let standing_out = || places.iter().filter_map(|&place| samples().nth(place));
        used[curve].then(|| FittedCurve {
            line: lines.iter().map(|line| PlotPoint::new(line.time, line.values[curve])).collect(),
            band: bands.iter().map(|band| band[curve]).collect(),
            residuals: samples().filter_map(residual).collect(),
            outliers: [
                standing_out().filter_map(value).collect(),
                standing_out().filter_map(residual).collect(),
            ],
        })
    })
}

/// The times around which curves bend: those of the point that was simulated, else of the one that was found.
fn bends_of(key: &FitKey, pair: [Aperture; 2], range: [f64; 2], best: &Fit) -> Bends {
    let found = || worldline(best.options.rolling, best.values);
    let point = key.simulated().map(|point| (point.velocity.speed, point.source)).or_else(found);
    point.map(|(speed, source)| Bends::new(&speed, source, pair, range)).unwrap_or_default()
}

/// The point that these values of beta, y, z and x0 are of, or whose hub's they are.
fn worldline(rolling: Option<Rolling>, [beta, y, z, x0]: [f64; 4]) -> Option<(Speed, Source)> {
    let hub = SourcePoint { x0, y, z };
    let source = match rolling {
        None => hub.into(),
        Some(Rolling { radius, rho, angle }) => {
            WheelPoint { hub, radius, rho, angle, turning: Turning::Rolling }.into()
        }
    };
    Some((Speed::from_beta(beta).ok()?, source))
}

/// The model of a fit, and the eyes that it assumes.
type Seeing = (FitOptions, [Aperture; 2]);

/// For each sample of the best fit's `lines` the replicates' 95 % intervals, relative to the best fit.
fn bands(eyes: Seeing, lines: &[CurveSample<2>], replicates: &Bootstrap) -> Vec<[[f64; 2]; 2]> {
    let stride = lines.len().div_ceil(BAND_TIMES).max(1);
    let found: Vec<_> =
        lines.par_iter().step_by(stride).map(|line| band_at(eyes, line, replicates)).collect();
    let interpolated = |index: usize| {
        let (before, rest) = (index / stride, index % stride);
        let (a, b) = (&found[before], found.get(before + 1).unwrap_or(&found[before]));
        let share = rest as f64 / stride as f64;
        [0, 1].map(|curve| [0, 1].map(|end| a[curve][end] + share * (b[curve][end] - a[curve][end])))
    };
    (0..lines.len()).map(interpolated).collect()
}

/// The replicates' 95 % interval at one time; of no width where the replicates have no curve.
fn band_at(eyes: Seeing, line: &CurveSample<2>, replicates: &Bootstrap) -> [[f64; 2]; 2] {
    let points = replicates.estimates.iter().flatten();
    let angles: Vec<[f64; 2]> = points.filter_map(|point| angles(eyes, *point, line.time)).collect();
    if angles.is_empty() {
        return [[0.0; 2]; 2];
    }
    [0, 1].map(|curve| percentiles_95(angles.iter().map(|angles| angles[curve] - line.values[curve])))
}

/// Delta-phi and Delta-theta, in the model of the fit, of a point given by beta, y, z and x0.
fn angles((options, pair): Seeing, values: [f64; 4], time: f64) -> Option<[f64; 2]> {
    let (speed, source) = worldline(options.rolling, values)?;
    let both = options.model.disparity(&speed, source, pair, time).ok()?;
    let angles = [both.dphi, both.dtheta];
    angles.iter().all(|angle| angle.is_finite()).then_some(angles)
}

#[cfg(test)]
mod tests {
    use relativity_core::bootstrap;

    use super::*;
    use crate::app::tools::worker::sent;
    use crate::estimate::samples::Simulated;
    use crate::settings::Settings;

    fn key() -> FitKey {
        let mut settings = Settings::default();
        settings.fit.fit_samples = 40;
        let scene = settings.opened_scene().expect("it is a preset");
        let simulated = Simulated::new(&settings, &settings.track(&scene));
        FitKey { samples: Samples::Simulated(simulated), setup: settings.fit }
    }

    #[test]
    fn a_fit_in_steps_has_the_uncertainty_of_a_bootstrap_at_once() {
        let wanted = Wanted::new(1, std::sync::Arc::new(1.into()), std::sync::Arc::default());
        let mut steps = FitSteps::begin((), sent(&key()));
        let mut count = 0;
        let outcome = loop {
            count += 1;
            if let StepOutcome::Last(outcome) = steps.step(&mut (), &wanted) {
                break outcome.expect("it was not stopped");
            }
        };
        assert!(count > 5, "it could be stopped only {count} times");
        let Fittable { observations, options, .. } = key().fittable().expect("there are samples");
        let best = fit(&observations, &options).expect("they can be fitted");
        let replicates = bootstrap(&best, DEFAULT_REPLICATES, key().setup.seed).expect("and refitted");
        let outcome = sent(&outcome);
        assert_eq!(outcome.key, key());
        assert_eq!(outcome.data[0].len(), 40);
        for (parameter, found, _) in outcome.fitted.expect("it is a fit").estimates {
            assert_eq!(found, estimate(&best, Some(&replicates), parameter));
        }
    }
}
