//! Simulated measurements of the selected point and their fit, computed beside the window.
//!
//! One thread serves the newest request. It hands out the fit as soon as it is there and its bootstrap
//! later, and leaves either undone when something newer is asked for.

use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;

use eframe::egui::Context;
use egui_plot::PlotPoint;
use relativity_core::bootstrap::bootstrap;
use relativity_core::fit::{
    Fit, FitError, FitModel, FitOptions, Parameter, Passage, Sample, Simulation, fit,
};
use relativity_core::{Aperture, PublishedVariant, SourcePoint, Speed, disparity, published_disparity};

use super::settings::Fitting;
use super::state::State;

/// Replicates of the bootstrap.
const REPLICATES: usize = 1000;
/// Replicates that the band is drawn from.
const BAND_REPLICATES: usize = 250;
/// Points of a drawn curve of the fit.
const CURVE_POINTS: usize = 161;
/// Seed of the noise and of the bootstrap: the same measurement for the same settings.
const SEED: u64 = 1;

/// Everything a fit depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    simulation: Simulation,
    options: FitOptions,
}

/// A fit, or why there is none.
pub struct Outcome {
    /// What was measured.
    pub samples: Vec<Sample>,
    /// What came of it.
    pub result: Result<Fitted, FitError>,
}

/// A fit as it is shown. Arrays of two are Delta-phi, Delta-theta; of four as [`Parameter::ALL`].
pub struct Fitted {
    /// Best values.
    pub values: [f64; 4],
    /// Standard errors: by the bootstrap once it is there, before by linearisation.
    pub errors: [f64; 4],
    /// Which parameters were fitted.
    pub parameters: &'static [Parameter],
    /// Root mean square of the residuals, radians.
    pub rms: f64,
    /// The curves of the best values.
    pub curves: [Vec<PlotPoint>; 2],
    /// Lower and upper edge of the band that holds 95 % of the replicates' curves; empty at first.
    pub band: [Vec<[f64; 3]>; 2],
    /// Whether the bootstrap is there.
    pub bootstrapped: bool,
    model: FitModel,
    separation: f64,
}

impl Request {
    /// What `state` asks to be measured and fitted; `None` for a scene at rest, which tells nothing.
    #[must_use]
    pub fn of(state: &State) -> Option<Self> {
        let Fitting { samples, noise, curves, model, passage, .. } = state.settings.fitting;
        let point = state.selected_source();
        let simulation = Simulation {
            speed: state.speed(),
            point,
            separation: state.settings.motion.separation,
            model: FitModel::Exact,
            times: even_times(state.time_range(), samples),
            noise,
            seed: SEED,
        };
        let passage = if passage { Passage::Fitted } else { Passage::Known(point.x0) };
        let moves = simulation.speed.beta() > 0.0;
        moves.then_some(Self { simulation, options: FitOptions { model, curves, passage } })
    }

    fn fitted(&self) -> (Vec<Sample>, Result<Fit, FitError>) {
        match self.simulation.observations() {
            Ok(observations) => (observations.samples().to_vec(), fit(&observations, &self.options)),
            Err(error) => (Vec::new(), Err(error)),
        }
    }

    fn shown(&self, fit: &Fit) -> Fitted {
        let times = even_times(self.range(), CURVE_POINTS);
        let (model, separation) = (self.options.model, self.simulation.separation);
        let curves = [0, 1].map(|curve| {
            let point =
                |&time: &f64| Some(PlotPoint::new(time, angles(model, separation, fit.values, time)?[curve]));
            times.iter().filter_map(point).collect()
        });
        Fitted {
            values: fit.values,
            errors: Parameter::ALL.map(|parameter| fit.standard_error(parameter)),
            parameters: fit.parameters(),
            rms: fit.rms,
            curves,
            band: [Vec::new(), Vec::new()],
            bootstrapped: false,
            model,
            separation,
        }
    }

    fn range(&self) -> [f64; 2] {
        let times = &self.simulation.times;
        [times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(0.0)]
    }

    /// `fitted` with the bootstrap's errors and band.
    fn bootstrapped(&self, fit: &Fit, fitted: Fitted) -> Result<Fitted, FitError> {
        let bootstrap = bootstrap(fit, REPLICATES, SEED)?;
        let estimates: Vec<[f64; 4]> =
            bootstrap.estimates.iter().flatten().take(BAND_REPLICATES).copied().collect();
        let edges = |time: f64| band_at(self.options.model, self.simulation.separation, &estimates, time);
        let edges: Vec<_> = even_times(self.range(), CURVE_POINTS / 2)
            .into_iter()
            .filter_map(|time| Some((time, edges(time)?)))
            .collect();
        let band = [0, 1].map(|curve| {
            edges.iter().map(|(time, edges)| [*time, edges[curve][0], edges[curve][1]]).collect()
        });
        let errors = Parameter::ALL.map(|parameter| bootstrap.standard_error(parameter));
        Ok(Fitted { errors, band, bootstrapped: true, ..fitted })
    }
}

impl Fitted {
    /// What the fit leaves over of a sample's Delta-phi (0) or Delta-theta (1).
    #[must_use]
    pub fn residual(&self, sample: &Sample, curve: usize) -> Option<f64> {
        let reading = [sample.dphi, sample.dtheta][curve]?;
        Some(reading.value - angles(self.model, self.separation, self.values, sample.time)?[curve])
    }
}

/// `count` times over a range, its ends among them.
fn even_times([from, to]: [f64; 2], count: usize) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|i| from + (to - from) * (i as f64 / last)).collect()
}

/// Delta-phi and Delta-theta of an object with these beta, y, z, x0.
fn angles(model: FitModel, separation: f64, [beta, y, z, x0]: [f64; 4], time: f64) -> Option<[f64; 2]> {
    let speed = Speed::from_beta(beta).ok()?;
    let point = SourcePoint { x0, y, z };
    let [left, right] = Aperture::pair(separation);
    let both = match model {
        FitModel::Exact => disparity(&speed, point, left, right, time),
        FitModel::Published => {
            published_disparity(&speed, point, separation, time, PublishedVariant::AppendixA)
        }
    };
    let both = both.ok()?;
    Some([both.dphi, both.dtheta]).filter(|angles| angles.iter().all(|angle| angle.is_finite()))
}

/// Edges of the band that holds 95 % of the curves of `estimates` at `time`, for each curve.
fn band_at(model: FitModel, separation: f64, estimates: &[[f64; 4]], time: f64) -> Option<[[f64; 2]; 2]> {
    let all: Vec<[f64; 2]> =
        estimates.iter().filter_map(|estimate| angles(model, separation, *estimate, time)).collect();
    let last = all.len().checked_sub(1)?;
    Some([0, 1].map(|curve| {
        let mut values: Vec<f64> = all.iter().map(|angles| angles[curve]).collect();
        values.sort_by(f64::total_cmp);
        [0.025, 0.975].map(|share: f64| values[(share * last as f64).round() as usize])
    }))
}

/// The thread that fits, and what it last found.
pub struct Fitter {
    requests: Sender<Request>,
    outcomes: Receiver<Outcome>,
    asked: Option<Request>,
    latest: Option<Outcome>,
}

impl Fitter {
    /// A thread that waits for requests and wakes the window of `ctx` when it has an answer.
    #[must_use]
    pub fn new(ctx: &Context) -> Self {
        let (requests, incoming) = mpsc::channel();
        let (outgoing, outcomes) = mpsc::channel();
        let ctx = ctx.clone();
        // Ends when the window drops its ends of the channels.
        thread::spawn(move || {
            serve(&incoming, |outcome| {
                let heard = outgoing.send(outcome).is_ok();
                ctx.request_repaint();
                heard
            });
        });
        Self { requests, outcomes, asked: None, latest: None }
    }

    /// The newest answer; asks anew if `request` is another than before.
    pub fn outcome(&mut self, request: Option<Request>) -> Option<&Outcome> {
        if request != self.asked {
            self.asked.clone_from(&request);
            match request {
                // A thread that is gone has reported its panic; the old answer stays.
                Some(request) => drop(self.requests.send(request)),
                None => self.latest = None,
            }
        }
        if let Some(newest) = self.outcomes.try_iter().last() {
            self.latest = Some(newest);
        }
        self.latest.as_ref().filter(|_| self.asked.is_some())
    }
}

/// Answers requests until nobody asks or listens any more.
fn serve(requests: &Receiver<Request>, answer: impl Fn(Outcome) -> bool) {
    let mut next = requests.recv().ok();
    while let Some(request) = next.take() {
        let request = requests.try_iter().last().unwrap_or(request);
        let (samples, fit) = request.fitted();
        let first = fit.as_ref().map(|fit| request.shown(fit)).map_err(Clone::clone);
        if !answer(Outcome { samples: samples.clone(), result: first }) {
            return;
        }
        next = requests.try_iter().last();
        if next.is_some() {
            continue;
        }
        if let Ok(fit) = fit {
            let result = request.bootstrapped(&fit, request.shown(&fit));
            if !answer(Outcome { samples, result }) {
                return;
            }
        }
        next = requests.recv().ok();
    }
}
