//! Where the forward-most point of bodies is.

use glam::DVec3;
use relativity_render::{Body, Shape};

/// The point with the largest x on any of the bodies; `None` without bodies.
pub(super) fn forward_most_point(bodies: &[Body]) -> Option<[f64; 3]> {
    let points = bodies.iter().map(|body| forward_most_on(&body.shape));
    points.max_by(|a, b| a.x.total_cmp(&b.x)).map(|point| point.to_array())
}

/// The point with the largest x on a shape; any of them where it has several.
pub(super) fn forward_most_on(shape: &Shape) -> DVec3 {
    match *shape {
        Shape::Sphere { center, radius } => DVec3::from(center) + radius * DVec3::X,
        Shape::Tube { from, to, radius } => {
            let front = if from[0] > to[0] { from } else { to };
            DVec3::from(front) + radius * DVec3::X
        }
        Shape::Ring { center, axis, radius, tube_radius } => {
            let axis = DVec3::from(axis);
            let in_plane = DVec3::X.reject_from_normalized(axis).normalize_or(axis.any_orthonormal_vector());
            DVec3::from(center) + radius * in_plane + tube_radius * DVec3::X
        }
    }
}
