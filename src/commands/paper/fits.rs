//! The paper's fits of the tracked point of its cyclist, in each model.

use std::path::Path;

use relativity_core::{
    Aperture, Curves, FitError, FitOptions, Model, Observations, Parameter, Simulation, SourcePoint,
    bootstrap, fit,
};

use super::curves::{APPENDIX_A, Setup, title};
use super::figures;
use crate::estimate::FitReport;
use crate::plot::{BLACK, Line, LineStroke, Panel, VERMILION};
use crate::time_range::passage_times;

const SAMPLES: usize = 240;
/// Noise of the second set of fits, as a share of each curve's range.
const NOISE: f64 = 0.02;
const REPLICATES: usize = 1000;
const SEED: u64 = 1;
/// Observation times about T0, and noise, that give uncertainties like the paper's from delta-phi.
const WINDOW: [f64; 2] = [-1.25, 0.75];
const WINDOW_NOISE: f64 = 0.016;

/// The fits in one model.
#[derive(Debug)]
pub struct ModelFits {
    /// Fits of curves without noise.
    pub clean: FitReport,
    /// Fits of curves with noise.
    pub noisy: FitReport,
}

/// Standard errors of beta, y and z from delta-phi in the published model.
#[derive(Debug)]
pub struct Errors {
    /// With noise of 2 % of the range, over the whole passage.
    pub passage: [f64; 3],
    /// With noise of 1.6 % of the range, from T0 - 1.25 to T0 + 0.75.
    pub window: [f64; 3],
}

/// Returns the uncertainties for each range of time in which samples were taken.
pub fn errors_of_published() -> anyhow::Result<Errors> {
    let t0 = Setup::CYCLIST.equidistance_time()?;
    let errors = |simulation: &Simulation| -> anyhow::Result<[f64; 3]> {
        let options = FitOptions { model: APPENDIX_A, curves: Curves::Azimuth, ..FitOptions::default() };
        let replicates = bootstrap(&fit(&simulation.observations()?, &options)?, REPLICATES, SEED)?;
        Ok([Parameter::Beta, Parameter::Y, Parameter::Z]
            .map(|parameter| replicates.standard_error(parameter)))
    };
    Ok(Errors {
        passage: errors(&simulation(APPENDIX_A, NOISE)?)?,
        window: errors(&simulation_at(APPENDIX_A, WINDOW_NOISE, WINDOW.map(|after| t0 + after)))?,
    })
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

/// Returns the bias of the published model fitted to exact curves.
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
    let point = SourcePoint { x0: 0.0, y, z };
    let range = passage_times(&Setup::CYCLIST.speed(), point, Aperture::pair(separation))?;
    Ok(simulation_at(model, noise, range.unwrap_or_default()))
}

fn simulation_at(model: Model, noise: f64, [from, to]: [f64; 2]) -> Simulation {
    let Setup { y, z, separation, .. } = Setup::CYCLIST;
    let (speed, point) = (Setup::CYCLIST.speed(), SourcePoint { x0: 0.0, y, z });
    let time = |index: usize| from + (to - from) * index as f64 / (SAMPLES - 1) as f64;
    let times = (0..SAMPLES).map(time).collect();
    let pair = Aperture::pair(separation);
    Simulation { speed, point, rolling: None, pair, model, times, noise, seed: SEED }
}

fn model_fits(model: Model) -> anyhow::Result<ModelFits> {
    let report = |observations: &Observations| {
        FitReport::new(observations, &FitOptions { model, ..FitOptions::default() }, REPLICATES, SEED)
    };
    Ok(ModelFits {
        clean: report(&simulation(model, 0.0)?.observations()?)?,
        noisy: report(&simulation(model, NOISE)?.observations()?)?,
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
        let data = observations.samples().iter().filter_map(|sample| sample.readings()[curve]);
        let data: Vec<f64> = data.map(|reading| reading.value).collect();
        let fitted: Vec<f64> = times.iter().filter_map(|&time| Some(best.angles(0, time)?[curve])).collect();
        let points = |values: &[f64]| times.iter().zip(values).map(|(&t, &v)| [t, v]).collect();
        let lines = vec![
            Line::solid("simulated, noise 2 % of the range", BLACK, points(&data)).with(LineStroke::Dots),
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
