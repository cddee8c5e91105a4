//! A fit for the window: noisy samples of the exact curves, the point that fits them best, its
//! uncertainty by the bootstrap, and what there is to draw.

use std::time::Duration;

use egui_plot::PlotPoint;
use relativity_core::bootstrap::percentiles_95;
use relativity_core::{
    Aperture, Bootstrap, Curves, DEFAULT_REPLICATES, Fit, FitOptions, Model, Observations, Parameter,
    Passage, Simulation, SourcePoint, Speed, bootstrap_unless, fit,
};
use relativity_render::Velocity;

use crate::app::curves::{Sample, bends, sampled};
use crate::estimate::{Estimate, estimate};
use crate::passage::time_within;
use crate::platform::clock::Instant;
use crate::platform::threads::prelude::*;
use crate::settings::FitSetup;

/// Everything that a fit depends on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitKey {
    /// True speed.
    pub velocity: Velocity,
    /// True worldline.
    pub source: SourcePoint,
    /// The eyes, from the middle between them.
    pub pair: [Aperture; 2],
    /// First and last T of the samples.
    pub range: [f64; 2],
    /// The model by which the samples are made: that of what the views show.
    pub model: Model,
    /// Samples and fit.
    pub setup: FitSetup,
}

/// The samples and what became of them.
#[derive(Debug, Clone)]
pub struct FitOutcome {
    /// What it was made for.
    pub key: FitKey,
    /// The samples of Delta-phi and of Delta-theta.
    pub data: [Vec<PlotPoint>; 2],
    /// The fit, or why there is none.
    pub fitted: Result<Fitted, String>,
    /// What the fitted model makes of curves without noise: fitted minus true beta, y and z, or why it fits nothing.
    /// `None` for the model by which they are made.
    pub bias: Option<Result<[f64; 3], String>>,
    /// How long it took.
    pub elapsed: Duration,
}

/// A fit.
#[derive(Debug, Clone)]
pub struct Fitted {
    /// Each fitted parameter, its best value with uncertainty, and its true value.
    pub estimates: Vec<(Parameter, Estimate, f64)>,
    /// Delta-phi and Delta-theta; `None` if not fitted.
    pub curves: [Option<FittedCurve>; 2],
    /// Root mean square of the residuals, radians.
    pub rms: f64,
    /// Readings fitted.
    pub readings: usize,
    /// Why the uncertainties are by linearisation, not by the bootstrap.
    pub no_bootstrap: Option<String>,
}

/// A fitted curve.
#[derive(Debug, Clone)]
pub struct FittedCurve {
    /// The curve of the best fit.
    pub line: Vec<PlotPoint>,
    /// Of the curves of the bootstrap's replicates, the 95 % interval at each point of `line`, minus the best
    /// fit; empty without a bootstrap.
    pub band: Vec<[f64; 2]>,
    /// Sample minus best fit.
    pub residuals: Vec<PlotPoint>,
}

/// Most times at which the band is found; in between it is interpolated.
const BAND_TIMES: usize = 120;

impl FitOutcome {
    /// The outcome for `key`; `None` soon after `stopped` becomes true.
    pub fn new(key: FitKey, stopped: &(impl Fn() -> bool + Sync)) -> Option<Self> {
        let start = Instant::now();
        let (data, fitted) = match observations(&key, key.setup.noise_percent) {
            Ok(observed) => (data(&observed), Fitted::new(&key, &observed, stopped)?),
            Err(problem) => ([Vec::new(), Vec::new()], Err(problem)),
        };
        let bias = (key.setup.model != key.model).then(|| bias(&key));
        Some(Self { key, data, fitted, bias, elapsed: start.elapsed() })
    }
}

impl FitKey {
    fn options(&self) -> FitOptions {
        let FitSetup { model, curves, fit_x0, .. } = self.setup;
        let passage = if fit_x0 { Passage::Fitted } else { Passage::Known(self.source.x0) };
        FitOptions { model, curves, passage }
    }

    fn true_value(&self, parameter: Parameter) -> f64 {
        match parameter {
            Parameter::Beta => self.velocity.speed.beta(),
            Parameter::Y => self.source.y,
            // Delta-phi alone does not tell above from below.
            Parameter::Z if self.setup.curves == Curves::Azimuth => self.source.z.abs(),
            Parameter::Z => self.source.z,
            Parameter::X0 => self.source.x0,
        }
    }

    /// The times around which curves bend.
    fn bends(&self) -> Vec<f64> {
        let SourcePoint { x0, y, z } = self.source;
        bends(&self.velocity, [self.velocity.speed.gamma() * x0, y, z], self.pair)
    }

    /// Why there is nothing to fit, whatever the noise.
    fn obstacle(&self) -> Option<&'static str> {
        if self.pair[0] == self.pair[1] {
            Some("both eyes are in one place (d = 0) and see the same")
        } else if self.velocity.speed.beta() == 0.0 {
            Some("at rest (β = 0) no disparity changes with T")
        } else if self.velocity.is_backward {
            Some("the fit takes what moves towards +x, and the point moves the other way")
        } else if self.source.y <= 0.0 {
            Some("the fit looks in front of the eyes, and the point is not there (y ≤ 0)")
        } else {
            None
        }
    }
}

/// What both eyes see of the point, and with noise.
fn observations(key: &FitKey, noise_percent: f64) -> Result<Observations, String> {
    if let Some(obstacle) = key.obstacle() {
        return Err(obstacle.to_owned());
    }
    let last = key.setup.fit_samples.max(2) - 1;
    let time = |index: usize| time_within(key.range, index as f64 / last as f64);
    let simulation = Simulation {
        speed: key.velocity.speed,
        point: key.source,
        pair: key.pair,
        model: key.model,
        times: (0..=last).map(time).collect(),
        noise: 0.01 * noise_percent,
        seed: key.setup.seed,
    };
    simulation.observations().map_err(|error| error.to_string())
}

fn data(observed: &Observations) -> [Vec<PlotPoint>; 2] {
    [0, 1].map(|curve| {
        let point = |sample: &relativity_core::Sample| {
            let reading = [sample.dphi, sample.dtheta][curve]?;
            Some(PlotPoint::new(sample.time, reading.value))
        };
        observed.samples().iter().filter_map(point).collect()
    })
}

fn bias(key: &FitKey) -> Result<[f64; 3], String> {
    let clean = observations(key, 0.0)?;
    let best = fit(&clean, &key.options()).map_err(|error| error.to_string())?;
    Ok([Parameter::Beta, Parameter::Y, Parameter::Z].map(|p| best.value(p) - key.true_value(p)))
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
        observed: &Observations,
        stopped: &(impl Fn() -> bool + Sync),
    ) -> Option<Result<Self, String>> {
        let best = match fit(observed, &key.options()) {
            Ok(best) => best,
            Err(error) => return Some(Err(error.to_string())),
        };
        let (replicates, no_bootstrap) =
            match bootstrap_unless(&best, DEFAULT_REPLICATES, key.setup.seed, stopped)? {
                Ok(replicates) => (Some(replicates), None),
                Err(error) => (None, Some(error.to_string())),
            };
        let estimate = |&parameter: &Parameter| {
            (parameter, estimate(&best, replicates.as_ref(), parameter), key.true_value(parameter))
        };
        let estimates: Vec<_> = best.parameters().iter().map(estimate).collect();
        if estimates.iter().any(|(_, estimate, _)| !estimate.value.is_finite()) {
            return Some(Err("the best fit is beyond what numbers can hold".to_owned()));
        }
        Some(Ok(Self {
            estimates,
            curves: curves(key, observed, &best, replicates.as_ref()),
            rms: best.rms,
            readings: best.readings,
            no_bootstrap,
        }))
    }
}

/// What there is to draw of the fitted curves.
fn curves(
    key: &FitKey,
    observed: &Observations,
    best: &Fit,
    replicates: Option<&Bootstrap>,
) -> [Option<FittedCurve>; 2] {
    let at = |time| best.angles(0, time).filter(|angles| angles.iter().all(|angle| angle.is_finite()));
    let lines = sampled(key.range, &key.bends(), at);
    let bands = replicates.map(|replicates| bands(key, &lines, replicates)).unwrap_or_default();
    let (data, used) = (data(observed), key.setup.curves.used());
    [0, 1].map(|curve| {
        let residual = |point: &PlotPoint| Some(PlotPoint::new(point.x, point.y - at(point.x)?[curve]));
        used[curve].then(|| FittedCurve {
            line: lines.iter().map(|line| PlotPoint::new(line.time, line.values[curve])).collect(),
            band: bands.iter().map(|band| band[curve]).collect(),
            residuals: data[curve].iter().filter_map(residual).collect(),
        })
    })
}

/// For each sample of the best fit's `lines` the replicates' 95 % intervals, relative to the best fit.
fn bands(key: &FitKey, lines: &[Sample<2>], replicates: &Bootstrap) -> Vec<[[f64; 2]; 2]> {
    let stride = lines.len().div_ceil(BAND_TIMES).max(1);
    let found: Vec<_> = lines.par_iter().step_by(stride).map(|line| band_at(key, line, replicates)).collect();
    let interpolated = |index: usize| {
        let (before, rest) = (index / stride, index % stride);
        let (a, b) = (&found[before], found.get(before + 1).unwrap_or(&found[before]));
        let share = rest as f64 / stride as f64;
        [0, 1].map(|curve| [0, 1].map(|end| a[curve][end] + share * (b[curve][end] - a[curve][end])))
    };
    (0..lines.len()).map(interpolated).collect()
}

/// The same at one time; of no width where the replicates have no curve.
fn band_at(key: &FitKey, line: &Sample<2>, replicates: &Bootstrap) -> [[f64; 2]; 2] {
    let points = replicates.estimates.iter().flatten();
    let angles: Vec<[f64; 2]> = points.filter_map(|point| angles(key, *point, line.time)).collect();
    if angles.is_empty() {
        return [[0.0; 2]; 2];
    }
    [0, 1].map(|curve| percentiles_95(angles.iter().map(|angles| angles[curve] - line.values[curve])))
}

/// Delta-phi and Delta-theta, in the model of the fit, of a point given by beta, y, z and x0.
fn angles(key: &FitKey, [beta, y, z, x0]: [f64; 4], time: f64) -> Option<[f64; 2]> {
    let (speed, point) = (Speed::from_beta(beta).ok()?, SourcePoint { x0, y, z });
    let both = key.setup.model.disparity(&speed, point, key.pair, time).ok()?;
    let angles = [both.dphi, both.dtheta];
    angles.iter().all(|angle| angle.is_finite()).then_some(angles)
}
