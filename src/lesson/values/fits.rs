//! Values of the fit of the selected point, as the *Fit* tab has it.

use std::cell::OnceCell;

use relativity_core::{DEFAULT_REPLICATES, Parameter, bootstrap, fit};

use super::here::{Here, Value};
use crate::estimate::samples::{Taken, samples_of};
use crate::estimate::{Estimate, estimate};
use crate::scene::Scene;
use crate::settings::Settings;

/// Them.
pub const VALUES: &[Value] = &[
    Value {
        name: "fit_beta",
        what: "fitted speed of the selected point, c",
        work_out: |here| here.fitted(|fitted| fitted[0].estimate.value),
    },
    Value {
        name: "fit_beta_sigma",
        what: "its standard error, by the bootstrap",
        work_out: |here| here.fitted(|fitted| fitted[0].estimate.uncertainty),
    },
    Value {
        name: "fit_beta_off",
        what: "by how many standard errors it is off",
        work_out: |here| here.fitted(|fitted| fitted[0].sigmas_off()),
    },
    Value {
        name: "fit_y",
        what: "fitted distance in front of the eyes",
        work_out: |here| here.fitted(|fitted| fitted[1].estimate.value),
    },
    Value {
        name: "fit_y_sigma",
        what: "its standard error, by the bootstrap",
        work_out: |here| here.fitted(|fitted| fitted[1].estimate.uncertainty),
    },
    Value {
        name: "fit_y_off",
        what: "by how many standard errors it is off",
        work_out: |here| here.fitted(|fitted| fitted[1].sigmas_off()),
    },
    Value {
        name: "fit_z",
        what: "fitted height above the eyes",
        work_out: |here| here.fitted(|fitted| fitted[2].estimate.value),
    },
    Value {
        name: "fit_z_sigma",
        what: "its standard error, by the bootstrap",
        work_out: |here| here.fitted(|fitted| fitted[2].estimate.uncertainty),
    },
    Value {
        name: "fit_z_off",
        what: "by how many standard errors it is off",
        work_out: |here| here.fitted(|fitted| fitted[2].sigmas_off()),
    },
    Value {
        name: "fit_off",
        what: "the most standard errors by which one of these three is off",
        work_out: |here| here.fitted(|fitted| fitted.iter().map(Fitted::sigmas_off).fold(0.0, f64::max)),
    },
    Value {
        name: "fit_samples",
        what: "number of its samples",
        work_out: |here| Some(here.settings.fit.fit_samples as f64),
    },
    Value {
        name: "noise_percent",
        what: "their noise, per cent of each curve's range",
        work_out: |here| Some(here.settings.fit.noise_percent),
    },
];

/// A fit that is made when it is first asked for. `None` in it: there is none.
pub type Fit = OnceCell<Option<[Fitted; 3]>>;

/// What a fit finds for a parameter, and the truth.
#[derive(Debug, Clone)]
pub struct Fitted {
    estimate: Estimate,
    truth: f64,
}

impl Fitted {
    /// By how many standard errors it is off, up or down.
    fn sigmas_off(&self) -> f64 {
        ((self.estimate.value - self.truth) / self.estimate.uncertainty).abs()
    }
}

impl Here<'_> {
    /// `of` the fitted beta, y and z.
    fn fitted(&self, of: fn(&[Fitted; 3]) -> f64) -> Option<f64> {
        self.fit.get_or_init(|| fitted(self.settings, self.scene)).as_ref().map(of)
    }
}

fn fitted(settings: &Settings, scene: &Scene) -> Option<[Fitted; 3]> {
    let taken: Taken = samples_of(settings, scene).ok()?;
    let best = fit(&taken.fittable.observations, &taken.fittable.options).ok()?;
    let replicates = bootstrap(&best, DEFAULT_REPLICATES, settings.fit.seed).ok();
    Some([Parameter::Beta, Parameter::Y, Parameter::Z].map(|parameter| Fitted {
        estimate: estimate(&best, replicates.as_ref(), parameter),
        truth: taken.true_value(parameter),
    }))
}
