//! The paper's fits of the tracked point of its cyclist, in each model.

use std::path::Path;

use relativity_core::{
    Aperture, Curves, FitError, FitOptions, Model, Observations, Simulation, SourcePoint, bootstrap, fit,
};

use super::curves::{APPENDIX_A, Setup, title};
use super::figures;
use crate::estimate::FitReport;
use crate::passage::passage_times;
use crate::plot::{BLACK, Line, Panel, Stroke, VERMILION};

const SAMPLES: usize = 240;
/// Noise of the second set of fits, as a share of each curve's range.
const NOISE: f64 = 0.02;
const REPLICATES: usize = 1000;
const SEED: u64 = 1;
/// The paper's uncertainty of beta from delta-phi.
const PAPER_BETA_ERROR: f64 = 0.005;

/// The fits in one model.
#[derive(Debug)]
pub struct ModelFits {
    /// The model of both data and fit.
    pub model: Model,
    /// Fits of curves without noise.
    pub clean: FitReport,
    /// Fits of curves with noise.
    pub noisy: FitReport,
    /// The noise (a share of the curve's range) at which the uncertainty of beta from delta-phi would be
    /// the paper's.
    pub noise_of_paper: f64,
}

/// Fits in the published and in the exact model, with their figures in `folder`.
pub fn write_all(folder: &Path) -> anyhow::Result<[ModelFits; 2]> {
    let [published, exact] = [APPENDIX_A, Model::Exact].map(model_fits);
    let fits = [published?, exact?];
    write_figure(folder, "fit-phi", 0, Curves::Azimuth)?;
    write_figure(folder, "fit-theta", 1, Curves::Polar)?;
    Ok(fits)
}

/// Beta, y and z from some curves, or why there is no fit.
pub type Bias = (Curves, Result<[f64; 3], FitError>);

/// What the published model makes of exact curves.
pub fn bias_of_published() -> anyhow::Result<[Bias; 3]> {
    let observations = simulation(Model::Exact, 0.0)?.observations()?;
    Ok([Curves::Azimuth, Curves::Polar, Curves::Both].map(|curves| {
        let options = FitOptions { model: APPENDIX_A, curves, ..FitOptions::default() };
        let [beta, y, z] = [0, 1, 2];
        (curves, fit(&observations, &options).map(|fit| [fit.values[beta], fit.values[y], fit.values[z]]))
    }))
}

fn simulation(model: Model, noise: f64) -> anyhow::Result<Simulation> {
    let Setup { y, z, separation, .. } = Setup::CYCLIST;
    let (speed, point) = (Setup::CYCLIST.speed(), SourcePoint { x0: 0.0, y, z });
    let pair = Aperture::pair(separation);
    let [from, to] = passage_times(&speed, point, pair)?.unwrap_or_default();
    let time = |index: usize| from + (to - from) * index as f64 / (SAMPLES - 1) as f64;
    let times = (0..SAMPLES).map(time).collect();
    Ok(Simulation { speed, point, pair, model, times, noise, seed: SEED })
}

fn model_fits(model: Model) -> anyhow::Result<ModelFits> {
    let report = |observations: &Observations| {
        FitReport::new(observations, &FitOptions { model, ..FitOptions::default() }, REPLICATES, SEED)
    };
    let noisy = simulation(model, NOISE)?.observations()?;
    let options = FitOptions { model, curves: Curves::Azimuth, ..FitOptions::default() };
    let azimuth = bootstrap(&fit(&noisy, &options)?, REPLICATES, SEED)?;
    let beta_error = azimuth.standard_error(relativity_core::Parameter::Beta);
    Ok(ModelFits {
        model,
        clean: report(&simulation(model, 0.0)?.observations()?)?,
        noisy: report(&noisy)?,
        noise_of_paper: NOISE * PAPER_BETA_ERROR / beta_error,
    })
}

/// Noisy data and the fit through them, in each model.
fn write_figure(folder: &Path, name: &str, curve: usize, curves: Curves) -> anyhow::Result<()> {
    let mut panels = Vec::new();
    let mut columns: Vec<figures::Column> = Vec::new();
    for model in [APPENDIX_A, Model::Exact] {
        let observations = simulation(model, NOISE)?.observations()?;
        let best = fit(&observations, &FitOptions { model, curves, ..FitOptions::default() })?;
        let times: Vec<f64> = observations.samples().iter().map(|sample| sample.time).collect();
        let data = observations.samples().iter().filter_map(|sample| [sample.dphi, sample.dtheta][curve]);
        let data: Vec<f64> = data.map(|reading| reading.value).collect();
        let fitted: Vec<f64> = times.iter().filter_map(|&time| Some(best.angles(0, time)?[curve])).collect();
        let points = |values: &[f64]| times.iter().zip(values).map(|(&t, &v)| [t, v]).collect();
        let lines = vec![
            Line::solid("simulated, noise 2 % of the range", BLACK, points(&data)).with(Stroke::Dots),
            Line::solid("fit", VERMILION, points(&fitted)),
        ];
        let labels = ["T", if curve == 0 { "delta-phi, rad" } else { "delta-theta, rad" }];
        panels.push(Panel::new(title(model), labels, lines));
        if columns.is_empty() {
            columns.push(("T".to_owned(), times));
        }
        columns.push((format!("{}_simulated_{}", curves.name(), model.name()), data));
        columns.push((format!("{}_fit_{}", curves.name(), model.name()), fitted));
    }
    figures::write(folder, name, &panels, &columns)
}
