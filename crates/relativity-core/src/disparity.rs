//! Exact disparities: how differently two apertures see one point, each through its own light cone.

use crate::aperture::Aperture;
use crate::apparent::{Sighting, check_inputs, sighting_inside_domain};
use crate::cone_pair::ConePair;
use crate::domain::DomainError;
use crate::source::Source;
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

/// Disparity of `source` between two apertures at `observation_time`.
///
/// # Accuracy
///
/// As [`crate::sighting`], however close the apertures are: no difference of two sightings is formed. For the
/// paper's pair the unit's inputs are d and not each aperture's place. Measured (`tests/oracle`, 15,000
/// inputs): median 0.2, 99 % 1.5, worst 3 units. With y = 0, phi is 0 or pi by the sign of X; where rounding
/// of the inputs decides it, so it does dphi.
///
/// # Errors
///
/// A coordinate or time outside the domain.
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, SourcePoint, Speed, disparity};
///
/// // The paper's section 3: at beta = 0.9 the difference in azimuth reaches -0.6678.
/// let speed = Speed::from_beta(0.9)?;
/// let point = SourcePoint { x0: 0.0, y: 0.5, z: 0.5 };
/// let [left, right] = Aperture::pair(0.3);
/// let mut least = 0.0_f64;
/// for step in 0..10_000 {
///     least = least.min(disparity(&speed, point, left, right, f64::from(step) * 1e-4)?.dphi);
/// }
/// assert!((least + 0.6678).abs() < 5e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn disparity(
    speed: &Speed,
    source: impl Into<Source>,
    primary: Aperture,
    secondary: Aperture,
    observation_time: f64,
) -> Result<Disparity, DomainError> {
    let source = source.into();
    check_inputs(source, primary, observation_time)?;
    check_inputs(source, secondary, observation_time)?;
    let point = match source.simplest() {
        Source::Point(point) => point,
        Source::Wheel(wheel) => return Ok(wheel.disparity(speed, [primary, secondary], observation_time)),
    };
    let (dphi, dtheta) =
        ConePair::new(&speed.coefficients(), point, primary, secondary, observation_time).angle_differences();
    let seen_by = |aperture| sighting_inside_domain(speed, point, aperture, observation_time);
    Ok(Disparity { primary: seen_by(primary), secondary: seen_by(secondary), dphi, dtheta })
}

/// Disparities of `source` between the primary, first aperture of a slice and each of them (itself included);
/// none of no apertures.
///
/// # Errors
///
/// A coordinate or time outside the domain.
pub fn disparities(
    speed: &Speed,
    source: impl Into<Source>,
    apertures: &[Aperture],
    observation_time: f64,
) -> Result<Vec<Disparity>, DomainError> {
    let source = source.into();
    let against_primary =
        |&secondary: &Aperture| disparity(speed, source, apertures[0], secondary, observation_time);
    apertures.iter().map(against_primary).collect()
}
