//! Geometry of shapes with flat faces: distances from a box, and the part of a ray between planes or within a
//! tube.

use glam::DVec3;

/// Sines below this are none: a turn by a right angle is not exact.
pub(super) const LEVEL: f64 = 1e-12;

/// Returns the distance of `place` from a box about the origin along the axes, below 0 inside; and the unit
/// vector away from the nearest place on the surface.
pub(super) fn block_distance(place: DVec3, half: DVec3) -> (f64, DVec3) {
    let beyond = place.abs() - half;
    let outside = beyond.max(DVec3::ZERO);
    if outside == DVec3::ZERO {
        let face = beyond.max_position();
        return (beyond[face], DVec3::AXES[face] * 1f64.copysign(place[face]));
    }
    let distance = outside.length();
    (distance, outside / distance * place.signum())
}

/// Returns the range in which a ray at `start`, as seen along an axis, is between the planes at -`half` and
/// `half`; everywhere if it stays between them for good.
pub(crate) fn between_planes(start: f64, slope: f64, half: f64) -> Option<[f64; 2]> {
    if slope == 0.0 {
        return (start.abs() <= half).then_some([f64::NEG_INFINITY, f64::INFINITY]);
    }
    let towards = 1f64.copysign(slope);
    Some([-half, half].map(|plane| (plane - towards * start) / slope.abs()))
}
