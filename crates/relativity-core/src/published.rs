//! The published binocular model: the paper's, as printed, so that it can be reproduced and compared.
//!
//! The paper evaluates the right eye through the left eye's formula at a shifted time and measures
//! both angles from the left aperture, so that ordinary parallax is left out. It is an approximation
//! by construction; [`crate::disparity`] is exact. Reference: the paper, eqs. (1) and (5), Appendix A.

use crate::apparent::{Aperture, LightCone, SourcePoint, check_inputs};
use crate::disparity::{Disparity, Offset, angle_differences};
use crate::domain::{DomainError, check};
use crate::speed::Speed;

/// The sign of the delay `Delta T` (eq. 5), on which the paper disagrees with itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PublishedVariant {
    /// `X_S = X(T - Delta T)`, as Appendix A prints it; right to first order.
    AppendixA,
    /// `X_S = X(T + Delta T)`, as the text of section 3 writes.
    TextSign,
}

/// Disparity of `point` in the published model, for the paper's pair of apertures.
///
/// The secondary sighting is the left aperture's at the shifted time, measured from the left
/// aperture, as published. A point not on x(0) = 0 is brought there by a shift of both times.
///
/// # Accuracy
///
/// As [`crate::disparity`], towards the published formulas.
///
/// # Errors
///
/// A coordinate or time outside the domain.
pub fn published_disparity(
    speed: &Speed,
    point: SourcePoint,
    separation: f64,
    observation_time: f64,
    variant: PublishedVariant,
) -> Result<Disparity, DomainError> {
    check_inputs(point, Aperture::default(), observation_time)?;
    check("d", separation)?;
    let [left_aperture, _] = Aperture::pair(separation);
    let left = LightCone::new(speed, point, left_aperture, observation_time);
    let delay = delay(speed, point, separation, &left, observation_time);
    let shift = match variant {
        PublishedVariant::AppendixA => -delay,
        PublishedVariant::TextSign => delay,
    };
    let right = LightCone::at(speed, left.s + speed.beta() * shift, left.y, left.z);
    let offset = Offset { s: -speed.beta() * shift, y: 0.0, z: 0.0 };
    let (dphi, dtheta) = angle_differences(speed, &left, &right, offset);
    Ok(Disparity {
        primary: left.sighting(observation_time),
        secondary: right.sighting(observation_time + shift),
        dphi,
        dtheta,
    })
}

/// Delta T (eq. 5): how much longer light from the event that the left eye sees takes to the right.
///
/// The difference of the two distances is `-2 u d` over their sum, u being the event's x; u comes from
/// the retarded time, since X - d/2 would cancel at low speed.
pub(crate) fn delay(
    speed: &Speed,
    point: SourcePoint,
    separation: f64,
    left: &LightCone,
    observation_time: f64,
) -> f64 {
    let u = point.x0 + speed.beta() * (observation_time - left.solution.r);
    let to_right = u - separation / 2.0;
    let right_distance = (to_right * to_right + left.y * left.y + left.z * left.z).sqrt();
    let sum = left.solution.r + right_distance;
    if sum == 0.0 { 0.0 } else { -2.0 * u * separation / sum }
}

/// Apparent X by eq. (1) as printed, with gamma/c before the root instead of gamma beta.
///
/// Shown for comparison only: with it, a resting point would not appear where it is.
///
/// # Errors
///
/// A coordinate or time outside the domain.
pub fn printed_apparent_x(
    speed: &Speed,
    point: SourcePoint,
    aperture: Aperture,
    observation_time: f64,
) -> Result<f64, DomainError> {
    check_inputs(point, aperture, observation_time)?;
    let cone = LightCone::new(speed, point, aperture, observation_time);
    let gamma = speed.gamma();
    let gamma_squared = gamma * gamma;
    // gamma^2 (S - q); for S > 0 the difference is -(rho/gamma)^2/(S + q).
    Ok(if cone.s > 0.0 {
        -(cone.y * cone.y + cone.z * cone.z) / (cone.s + cone.solution.q)
    } else {
        gamma_squared * (cone.s - cone.solution.q)
    })
}
