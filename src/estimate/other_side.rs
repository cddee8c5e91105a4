//! The remark on a fit whose point may as well be on the other side of the eyes' level.

use relativity_core::{Fit, OtherSide, Parameter};

use crate::number_text::{decimals_of, significant};

/// Excess of chi squared up to which the other side is within the noise: three standard deviations.
const WITHIN_NOISE: f64 = 9.0;

/// Returns a sentence if the readings fit a point above and one below the eyes' level within their noise.
///
/// Delta-phi alone tells these apart only for a point on a wheel, and there only by its wiggle about the
/// hub's curve.
#[must_use]
pub fn remark(fit: &Fit) -> Option<String> {
    let OtherSide { values, excess } = fit.other_side.filter(|other| other.excess < WITHIN_NOISE)?;
    let z = values[Parameter::Z as usize];
    let decimals = decimals_of(fit.standard_error(Parameter::Z));
    let excess = significant(excess, 2);
    Some(format!(
        "the sign of z is uncertain: z = {z:.decimals$} fits too, with chi squared larger by {excess}; dtheta would tell"
    ))
}
