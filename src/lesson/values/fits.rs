//! Values of the fit of the selected point, as the *Fit* tab shows it.

use super::fitted::{FittedParameter, fitted};
use super::here::{Here, Value, value};

/// Values of the fit.
pub const VALUES: &[Value] = &[
    value("fit_beta", "speed that the *Fit* tab finds for the selected point, c", |here| {
        here.fitted(|fitted| fitted[0].estimate.value)
    }),
    value("fit_beta_sigma", "its standard error, by the bootstrap", |here| {
        here.fitted(|fitted| fitted[0].estimate.scatter)
    }),
    value("fit_beta_off", "by how many standard errors it is off", |here| {
        here.fitted(|fitted| fitted[0].sigmas_off())
    }),
    value("fit_y", "how far ahead of the eyes it finds that the point passes", |here| {
        here.fitted(|fitted| fitted[1].estimate.value)
    }),
    value("fit_y_sigma", "its standard error, by the bootstrap", |here| {
        here.fitted(|fitted| fitted[1].estimate.scatter)
    }),
    value("fit_y_off", "by how many standard errors it is off", |here| {
        here.fitted(|fitted| fitted[1].sigmas_off())
    }),
    value("fit_z", "how high above the eyes it finds that the point passes", |here| {
        here.fitted(|fitted| fitted[2].estimate.value)
    }),
    value("fit_z_sigma", "its standard error, by the bootstrap", |here| {
        here.fitted(|fitted| fitted[2].estimate.scatter)
    }),
    value("fit_z_off", "by how many standard errors it is off", |here| {
        here.fitted(|fitted| fitted[2].sigmas_off())
    }),
    value("fit_off", "the most standard errors by which one of the three is off", |here| {
        here.fitted(|fitted| fitted.iter().map(FittedParameter::sigmas_off).fold(0.0, f64::max))
    }),
    value("fit_samples", "number of the readings that are fitted", |here| {
        Some(here.settings.fit.fit_samples as f64)
    }),
    value("noise_percent", "their noise, per cent of each curve's range", |here| {
        Some(here.settings.fit.noise_percent)
    }),
];

impl Here<'_> {
    /// `of` the fitted beta, y and z.
    fn fitted(&self, of: fn(&[FittedParameter; 3]) -> f64) -> Option<f64> {
        self.fit.get_or_init(|| fitted(self.settings, self.scene)).as_ref().map(of)
    }
}
