//! Rays against shapes with flat faces: boxes and cylinders, each what several pairs of planes or a tube have in common.

use glam::{DMat3, DVec3};
use relativity_core::math;

/// Entry of a ray at `start` into a box about the origin, of which the columns of `axes` are the axes.
pub(super) fn block_entry(start: DVec3, direction: DVec3, axes: DMat3, half: DVec3) -> Option<f64> {
    let (start, direction) = (axes.transpose() * start, axes.transpose() * direction);
    let (mut first, mut last) = (f64::NEG_INFINITY, f64::INFINITY);
    for i in 0..3 {
        let [enters, leaves] = between_planes(start[i], direction[i], half[i])?;
        (first, last) = (first.max(enters), last.min(leaves));
    }
    (first <= last).then_some(first)
}

/// Entry of a ray at `start` into a cylinder about the origin.
pub(super) fn cylinder_entry(
    start: DVec3,
    direction: DVec3,
    axis: DVec3,
    half_length: f64,
    radius: f64,
) -> Option<f64> {
    let [enters, leaves] = between_planes(axis.dot(start), axis.dot(direction), half_length)?;
    let across = direction.cross(axis);
    let sine_squared = across.length_squared();
    let (first, last) = if sine_squared == 0.0 {
        if start.cross(axis).length() > radius {
            return None;
        }
        (enters, leaves)
    } else {
        // As of a capsule.
        let offset = start.dot(across);
        let discriminant = radius * radius * sine_squared - offset * offset;
        if discriminant < 0.0 {
            return None;
        }
        let [middle, half_chord] = [-start.cross(axis).dot(across), discriminant.sqrt()];
        (enters.max((middle - half_chord) / sine_squared), leaves.min((middle + half_chord) / sine_squared))
    };
    (first <= last).then_some(first)
}

/// Returns the distance of `place` from a box about the origin along the axes, below 0 inside; and the unit vector away from the
/// nearest place on the surface.
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

/// Half the least width of a box, seen along the unit vector `direction` from afar.
pub(super) fn block_half_width(axes: DMat3, half: DVec3, direction: DVec3) -> f64 {
    // What is seen is a hexagon, with sides along the images of the axes.
    let steep = (axes.transpose() * direction).abs();
    let across = |i: usize, j: usize| {
        (half[i] * steep[j] + half[j] * steep[i]) / math::hypot(steep[i], steep[j]).max(1e-30)
    };
    let widths = [across(0, 1), across(1, 2), across(2, 0)];
    // Seen along an axis, that one has no image.
    widths.into_iter().filter(|&width| width > 0.0).fold(f64::INFINITY, f64::min)
}

/// Returns the range in which a ray at `start`, as seen along an axis, is between the planes at -`half` and `half`; everywhere if it
/// stays between them for good.
pub(crate) fn between_planes(start: f64, slope: f64, half: f64) -> Option<[f64; 2]> {
    if slope == 0.0 {
        return (start.abs() <= half).then_some([f64::NEG_INFINITY, f64::INFINITY]);
    }
    let towards = 1f64.copysign(slope);
    Some([-half, half].map(|plane| (plane - towards * start) / slope.abs()))
}
