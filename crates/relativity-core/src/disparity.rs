//! Exact disparities: how differently two apertures see one point, each through its own light cone.

use crate::apparent::{Aperture, LightCone, Sighting, SourcePoint, check_inputs};
use crate::domain::{DomainError, check};
use crate::speed::Speed;

/// Two sightings of one point, and the differences between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disparity {
    /// The primary (left) aperture's sighting.
    pub primary: Sighting,
    /// The secondary (right) aperture's sighting.
    pub secondary: Sighting,
    /// Delta-phi: azimuth, primary minus secondary, in [-pi, pi].
    pub dphi: f64,
    /// Delta-theta: elevation, primary minus secondary.
    pub dtheta: f64,
}

/// Disparity of `point` between two apertures at `observation_time`. For N apertures, take each
/// against the primary.
///
/// # Accuracy
///
/// As [`crate::sighting`]; relative accuracy holds however close the apertures are, since no
/// difference of two sightings is formed.
///
/// # Errors
///
/// A coordinate or time outside the domain.
pub fn disparity(
    speed: &Speed,
    point: SourcePoint,
    primary: Aperture,
    secondary: Aperture,
    observation_time: f64,
) -> Result<Disparity, DomainError> {
    check_inputs(point, primary, observation_time)?;
    check_inputs(point, secondary, observation_time)?;
    let offset =
        Offset { s: secondary.x - primary.x, y: secondary.y - primary.y, z: secondary.z - primary.z };
    let left = LightCone::new(speed, point, primary, observation_time);
    let right = LightCone::new(speed, point, secondary, observation_time);
    let (dphi, dtheta) = angle_differences(speed, &left, &right, offset);
    Ok(Disparity {
        primary: left.sighting(observation_time),
        secondary: right.sighting(observation_time),
        dphi,
        dtheta,
    })
}

/// S, y and z of the primary light cone minus those of the secondary, known without subtraction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Offset {
    pub s: f64,
    pub y: f64,
    pub z: f64,
}

/// (Delta-phi, Delta-theta) of two light cones whose origins differ by `offset`.
///
/// With q^2 = S^2 + rho^2/gamma^2, X = gamma^2 (S - beta q); so the difference of the two X is
/// `(dS (R_l + R_r) - beta d(rho^2))/(q_l + q_r)`, in which small separations do not cancel. The angles
/// follow from the sines and cosines of the differences.
pub(crate) fn angle_differences(
    speed: &Speed,
    left: &LightCone,
    right: &LightCone,
    offset: Offset,
) -> (f64, f64) {
    let sum_q = left.solution.q + right.solution.q;
    if sum_q == 0.0 {
        return (0.0, 0.0); // the point is inside both apertures, which then coincide
    }
    let (xl, xr) = (left.solution.x, right.solution.x);
    let d_rho_squared = offset.y * (left.y + right.y) + offset.z * (left.z + right.z);
    let dx = (offset.s * (left.solution.r + right.solution.r) - speed.beta() * d_rho_squared) / sum_q;
    let dphi = -(left.y * dx - xl * offset.y).atan2(xl * xr + left.y * right.y);
    let hl = (xl * xl + left.y * left.y).sqrt();
    let hr = (xr * xr + right.y * right.y).sqrt();
    let sum_h = hl + hr;
    let dh =
        if sum_h == 0.0 { 0.0 } else { dx * ((xl + xr) / sum_h) + offset.y * ((left.y + right.y) / sum_h) };
    let dtheta = (offset.z * hl - left.z * dh).atan2(hl * hr + left.z * right.z);
    (dphi, dtheta)
}

/// T0: the observation time at which `point` is seen equidistant from both apertures of the paper's
/// pair (eq. 6 of the paper, shifted by -x0/beta for a point not on x(0) = 0).
///
/// At rest (beta = 0) a point is equidistant always or never, so there is no such time: `None`.
///
/// # Errors
///
/// A coordinate outside the domain.
pub fn equidistance_time(
    speed: &Speed,
    point: SourcePoint,
    separation: f64,
) -> Result<Option<f64>, DomainError> {
    check_inputs(point, Aperture::default(), check("d", separation)?)?;
    if speed.beta() == 0.0 {
        return Ok(None);
    }
    let half = separation / 2.0;
    let distance = (half * half + point.y * point.y + point.z * point.z).sqrt();
    Ok(Some(distance - point.x0 / speed.beta()))
}
