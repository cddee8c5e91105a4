//! Values of the fit of the selected point, as the *Fit* tab shows it.

use super::fitted::{FittedParameter, fitted};
use super::here::{Here, Value};

/// Values of the fit.
pub const VALUES: &[Value] = &[
    Value {
        name: "fit_beta",
        what: "speed that the *Fit* tab finds for the selected point, c",
        work_out: |here| here.fitted(|fitted| fitted[0].estimate.value),
    },
    Value {
        name: "fit_beta_sigma",
        what: "its standard error, by the bootstrap",
        work_out: |here| here.fitted(|fitted| fitted[0].estimate.scatter),
    },
    Value {
        name: "fit_beta_off",
        what: "by how many standard errors it is off",
        work_out: |here| here.fitted(|fitted| fitted[0].sigmas_off()),
    },
    Value {
        name: "fit_y",
        what: "how far ahead of the eyes it finds that the point passes",
        work_out: |here| here.fitted(|fitted| fitted[1].estimate.value),
    },
    Value {
        name: "fit_y_sigma",
        what: "its standard error, by the bootstrap",
        work_out: |here| here.fitted(|fitted| fitted[1].estimate.scatter),
    },
    Value {
        name: "fit_y_off",
        what: "by how many standard errors it is off",
        work_out: |here| here.fitted(|fitted| fitted[1].sigmas_off()),
    },
    Value {
        name: "fit_z",
        what: "how high above the eyes it finds that the point passes",
        work_out: |here| here.fitted(|fitted| fitted[2].estimate.value),
    },
    Value {
        name: "fit_z_sigma",
        what: "its standard error, by the bootstrap",
        work_out: |here| here.fitted(|fitted| fitted[2].estimate.scatter),
    },
    Value {
        name: "fit_z_off",
        what: "by how many standard errors it is off",
        work_out: |here| here.fitted(|fitted| fitted[2].sigmas_off()),
    },
    Value {
        name: "fit_off",
        what: "the most standard errors by which one of the three is off",
        work_out: |here| {
            here.fitted(|fitted| fitted.iter().map(FittedParameter::sigmas_off).fold(0.0, f64::max))
        },
    },
    Value {
        name: "fit_samples",
        what: "number of the readings that are fitted",
        work_out: |here| Some(here.settings.fit.fit_samples as f64),
    },
    Value {
        name: "noise_percent",
        what: "their noise, per cent of each curve's range",
        work_out: |here| Some(here.settings.fit.noise_percent),
    },
];

impl Here<'_> {
    /// `of` the fitted beta, y and z.
    fn fitted(&self, of: fn(&[FittedParameter; 3]) -> f64) -> Option<f64> {
        self.fit.get_or_init(|| fitted(self.settings, self.scene)).as_ref().map(of)
    }
}
