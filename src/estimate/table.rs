//! The report of `gamow fit` as a table.

use std::fmt;

use relativity_core::Parameter;

use super::{Attempt, BootstrapSummary, CurvesFit, Estimate, FitReport, WheelPlace, outliers};
use crate::number_text;

/// Difference of the estimates of both curves, in standard errors, beyond which it is remarked on.
const AGREEING: f64 = 3.0;

/// The meaning of the parameters where the eyes rode.
const RIDING: &str = "beta is the observer's own speed, x0 how far the point is behind when the clock shows 0, \
    contracted";

impl fmt::Display for FitReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let wheel = |WheelPlace { wheel_radius, rho, angle }| {
            let known = format!("radius {wheel_radius}, rho {rho}, angle {angle}");
            format!("{known}, taken as known: y, z and x0 are the hub's")
        };
        let bootstrap = self.bootstrap.as_ref().map(|BootstrapSummary { replicates, failed, seed }| {
            format!("{replicates} replicates, seed {seed}, {failed} failed")
        });
        let head = [
            ("model", Some(self.model.to_owned())),
            ("data", self.data.clone()),
            ("riding", self.riding.then(|| RIDING.to_owned())),
            ("wheel", self.wheel.map(wheel)),
            ("loss", self.loss.as_ref().map(ToString::to_string)),
            ("bootstrap", Some(bootstrap.unwrap_or_else(|| "none".to_owned()))),
            ("sigmas", self.sigmas.clone()),
            ("warning", self.warning.clone()),
            ("cause", self.cause.clone()),
            ("outliers", outliers::remark(&self.outliers)),
        ];
        for (name, text) in head.into_iter().filter_map(|(name, text)| Some((name, text?))) {
            writeln!(f, "{name:11}{text}")?;
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
            let decimals =
                number_text::decimals_of(mean.uncertainty.or(mean.value).unwrap_or_default().abs());
            write_estimate(f, parameter, mean.value, mean.uncertainty, mean.ci95, decimals)?;
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
        if let Some(reduced) = self.reduced_chi_squared {
            write!(f, ", reduced chi squared {reduced:.3}")?;
        }
        if let Some(residuals) = &self.residuals {
            let meaning = if residuals.chance { "chance" } else { "no chance" };
            write!(f, ", Durbin-Watson {:.2} ({meaning})", residuals.durbin_watson)?;
        }
        writeln!(f)?;
        let is_stated = self.residuals.is_none_or(|residuals| residuals.chance);
        let head = if is_stated { "     value +- uncertainty" } else { "     value, no uncertainty" };
        writeln!(f, "  {head:29} {:24} linear     correlations", "95 % interval")?;
        for ((parameter, estimate), correlations) in self.parameters.iter().zip(&self.correlations) {
            let Estimate { value, uncertainty, ci95, .. } = *estimate;
            write_estimate(f, parameter, Some(value), uncertainty, ci95, estimate.decimals())?;
            let linear =
                estimate.uncertainty_linear.map_or_else(|| "-".to_owned(), |linear| format!("{linear:.1e}"));
            write!(f, "  {linear:7} ")?;
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

/// A line of a table, with this many decimals and a dash for what is not stated.
fn write_estimate(
    f: &mut fmt::Formatter<'_>,
    parameter: Parameter,
    value: Option<f64>,
    uncertainty: Option<f64>,
    interval: Option<[f64; 2]>,
    decimals: usize,
) -> fmt::Result {
    let number = |number: f64| format!("{number:.decimals$}");
    let or_dash = |text: Option<String>| text.unwrap_or_else(|| "-".to_owned());
    let value = match uncertainty {
        Some(uncertainty) => format!("{} +- {}", or_dash(value.map(number)), number(uncertainty)),
        None => or_dash(value.map(number)),
    };
    let interval = or_dash(interval.map(|[low, high]| format!("{} ... {}", number(low), number(high))));
    write!(f, "  {:5}{value:24} {interval:24}", parameter.name())
}
