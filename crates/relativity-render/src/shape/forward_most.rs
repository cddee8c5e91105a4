//! The forward-most point of a shape.

use glam::{DQuat, DVec3};

use super::Shape;

/// Sines below this are none: a turn by a right angle is not exact.
const LEVEL: f64 = 1e-12;

impl Shape {
    /// The point with the largest x, at rest; any of them where there are several.
    #[must_use]
    pub fn forward_most(&self) -> DVec3 {
        match *self {
            Self::Sphere { center, radius } => DVec3::from(center) + radius * DVec3::X,
            Self::Tube { from, to, radius } => {
                let front = if from[0] > to[0] { from } else { to };
                DVec3::from(front) + radius * DVec3::X
            }
            Self::Ring { center, axis, radius, tube_radius } => {
                let axis = DVec3::from(axis);
                let in_plane =
                    DVec3::X.reject_from_normalized(axis).normalize_or(axis.any_orthonormal_vector());
                DVec3::from(center) + radius * in_plane + tube_radius * DVec3::X
            }
            Self::Box { center, half, turn } => {
                let own = DQuat::from_array(turn).conjugate() * DVec3::X;
                // Along an edge or a face that is across x, its middle.
                let side = |i: usize| if own[i].abs() < LEVEL { 0.0 } else { half[i].copysign(own[i]) };
                let corner = DVec3::new(side(0), side(1), side(2));
                DVec3::from(center) + DQuat::from_array(turn) * corner
            }
            Self::Cylinder { from, to, radius } => {
                let (from, to) = (DVec3::from(from), DVec3::from(to));
                let axis = (to - from).normalize();
                let along = if axis.x.abs() < LEVEL { 0.5 } else { f64::from(axis.x > 0.0) };
                let outward = DVec3::X.reject_from_normalized(axis);
                let rim = if outward.length() < LEVEL { DVec3::ZERO } else { outward.normalize() * radius };
                from.lerp(to, along) + rim
            }
        }
    }
}
