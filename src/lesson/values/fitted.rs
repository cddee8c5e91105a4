//! The fit of the selected point, made when a value of it is first needed.

use std::cell::OnceCell;

use relativity_core::{DEFAULT_REPLICATES, Parameter, bootstrap, fit};

use crate::estimate::samples::samples_of;
use crate::estimate::{Estimate, estimate};
use crate::scene::Scene;
use crate::settings::Settings;

/// A fit, made when it is first needed. `None` inside: there is none.
pub type CachedFit = OnceCell<Option<[FittedParameter; 3]>>;

/// A fitted parameter, and the truth.
#[derive(Debug, Clone)]
pub struct FittedParameter {
    /// Best value and its uncertainty.
    pub estimate: Estimate,
    truth: f64,
}

impl FittedParameter {
    /// Deviation from the truth, in standard deviations over the replicates, up or down.
    #[must_use]
    pub fn sigmas_off(&self) -> f64 {
        ((self.estimate.value - self.truth) / self.estimate.scatter).abs()
    }
}

/// The fitted beta, y and z of the selected point; `None` where there is no fit.
pub fn fitted(settings: &Settings, scene: &Scene) -> Option<[FittedParameter; 3]> {
    let taken = samples_of(settings, scene).ok()?;
    let best = fit(&taken.fittable.observations, &taken.fittable.options).ok()?;
    let replicates = bootstrap(&best, DEFAULT_REPLICATES, settings.fit.seed).ok();
    Some([Parameter::Beta, Parameter::Y, Parameter::Z].map(|parameter| FittedParameter {
        estimate: estimate(&best, replicates.as_ref(), parameter),
        truth: taken.true_value(parameter),
    }))
}
