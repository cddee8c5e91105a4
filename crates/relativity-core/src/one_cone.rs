//! One light cone for both apertures: both receive the same events, those that the middle between them
//! receives.
//!
//! This is not what two apertures see ([`crate::disparity()`] is), but the part of it that is not due to
//! their having two light cones: both see the point in one place, from two sides.

use crate::aperture::Aperture;
use crate::apparent::{LightCone, Sighting, check_inputs};
use crate::cone_pair::ConePair;
use crate::disparity::Disparity;
use crate::domain::DomainError;
use crate::source::Source;
use crate::source::SourcePoint;
use crate::speed::Speed;

/// Disparity of `source` for the `pair` of apertures, if both received what the middle between them receives
/// at `observation_time`.
///
/// Both sightings have the same retarded time and Doppler factor, the middle's; position and distance are
/// from each aperture to the one event.
///
/// # Accuracy
///
/// As [`crate::disparity()`], at any separation: the place that the middle sees is looked at by two apertures
/// as a point at rest is. Measured for the paper's pair (`tests/oracle`, 15,000 inputs): median 0.2, 99 % 2,
/// worst 4 units.
///
/// # Errors
///
/// A coordinate or time outside the domain.
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, SourcePoint, Speed, disparity, one_cone_disparity, sighting};
///
/// let speed = Speed::from_beta(0.9)?;
/// let point = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };
/// let [left, right] = Aperture::pair(1e-3);
/// // Far ahead two eyes see gamma D times the parallax of a point that rests where it is seen;
/// // with one cone, once.
/// let exact = disparity(&speed, point, left, right, -40.0)?;
/// let one = one_cone_disparity(&speed, point, [left, right], -40.0)?;
/// let middle = sighting(&speed, point, Aperture::default(), -40.0)?;
/// let gain = speed.gamma() * middle.doppler_factor;
/// assert!((exact.dphi / one.dphi - gain).abs() < 1e-6 * gain);
/// assert!((one.primary.position[0] - one.secondary.position[0] - 1e-3).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn one_cone_disparity(
    speed: &Speed,
    source: impl Into<Source>,
    pair: [Aperture; 2],
    observation_time: f64,
) -> Result<Disparity, DomainError> {
    let source = source.into();
    for aperture in pair {
        check_inputs(source, aperture, observation_time)?;
    }
    let (cone, middle) = match source.simplest() {
        Source::Point(point) => {
            let cone = middle_cone(speed, point, pair, observation_time);
            (cone, cone.sighting(speed, point.x0, middle(pair).x, observation_time))
        }
        Source::Wheel(wheel) => {
            let seen = wheel.seen(speed, middle(pair), observation_time);
            (seen.cone, wheel.sighting(speed, &seen, observation_time))
        }
    };
    Ok(disparity_of_event(&cone_pair(&cone, pair), middle))
}

/// Disparity of the event of the `middle`'s sighting, which both apertures look at from two sides, through
/// `cones`.
pub(crate) fn disparity_of_event(cones: &ConePair<f64>, middle: Sighting) -> Disparity {
    let (dphi, dtheta) = cones.angle_differences();
    let sighting = |cone: LightCone<f64>| Sighting {
        position: [cone.s, cone.y, cone.z],
        distance: cone.solution.r,
        ..middle
    };
    Disparity { primary: sighting(cones.left), secondary: sighting(cones.right), dphi, dtheta }
}

/// Both apertures' views of the place that the middle between them sees: the light cones of a point at rest
/// there.
pub(crate) fn cone_pair(middle: &LightCone<f64>, pair: [Aperture; 2]) -> ConePair<f64> {
    cones_to_place([middle.solution.x, middle.y, middle.z], pair)
}

/// Both apertures' light cones of a point at rest at a place from the middle between them.
pub(crate) fn cones_to_place([x0, y, z]: [f64; 3], pair: [Aperture; 2]) -> ConePair<f64> {
    let [left, right] = from_middle(pair);
    ConePair::new(&Speed::REST.coefficients(), SourcePoint { x0, y, z }, left, right, 0.0)
}

/// The light cone of the middle between two apertures.
pub(crate) fn middle_cone(
    speed: &Speed,
    point: SourcePoint,
    pair: [Aperture; 2],
    observation_time: f64,
) -> LightCone<f64> {
    LightCone::new(speed, point, middle(pair), observation_time)
}

/// The middle between two apertures.
pub(crate) const fn middle([primary, secondary]: [Aperture; 2]) -> Aperture {
    Aperture {
        x: primary.x.midpoint(secondary.x),
        y: primary.y.midpoint(secondary.y),
        z: primary.z.midpoint(secondary.z),
    }
}

/// Two apertures from the middle between them.
fn from_middle([primary, secondary]: [Aperture; 2]) -> [Aperture; 2] {
    let half = Aperture {
        x: 0.5 * (secondary.x - primary.x),
        y: 0.5 * (secondary.y - primary.y),
        z: 0.5 * (secondary.z - primary.z),
    };
    [Aperture { x: -half.x, y: -half.y, z: -half.z }, half]
}
