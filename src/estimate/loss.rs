//! The robust loss of a fit, as its report states it.

use std::fmt;

use relativity_core::Fit;
use serde::Serialize;

use crate::number_text::significant;

/// A robust loss, and what its scale is in.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LossReport {
    /// The name of the [`LossShape`](relativity_core::LossShape).
    pub name: &'static str,
    /// The residual from which on a reading counts less, in sigmas or scatters.
    pub scale: f64,
    /// Standard deviation of dphi, radians, from the median of its residuals, where it has no sigmas.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scatter_dphi: Option<f64>,
    /// Standard deviation of dtheta, likewise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scatter_dtheta: Option<f64>,
}

impl LossReport {
    /// The loss of `fit`; `None` if it is linear.
    pub fn of(fit: &Fit) -> Option<Self> {
        let (loss, [scatter_dphi, scatter_dtheta]) = (fit.options.loss, fit.scatter);
        let report = Self { name: loss.shape.name(), scale: loss.scale, scatter_dphi, scatter_dtheta };
        loss.is_robust().then_some(report)
    }
}

impl fmt::Display for LossReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, readings count less from {} ", self.name, self.scale)?;
        let scatters = [("dphi", self.scatter_dphi), ("dtheta", self.scatter_dtheta)];
        let found = scatters.into_iter().filter_map(|(name, scatter)| Some((name, scatter?)));
        let found: Vec<String> =
            found.map(|(name, scatter)| format!("{} rad of {name}", significant(scatter, 3))).collect();
        if found.is_empty() {
            return f.write_str("sigmas on");
        }
        write!(f, "standard deviations on: {}, from the median of the residuals", found.join(", "))
    }
}
