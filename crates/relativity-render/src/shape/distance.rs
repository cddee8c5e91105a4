//! The distance of places from the surface of a shape.

use glam::{DQuat, DVec2, DVec3};
use relativity_core::math::hypot;

use super::Shape;

impl Shape {
    /// The distance of `place` at rest from the surface; below 0 inside.
    #[must_use]
    pub fn distance(&self, place: DVec3) -> f64 {
        match *self {
            Self::Sphere { center, radius } => place.distance(center.into()) - radius,
            Self::Tube { from, to, radius } => {
                let (from, axis) = axis(from, to);
                let off = place - from;
                let along = (off.dot(axis) / axis.length_squared()).clamp(0.0, 1.0);
                (off - along * axis).length() - radius
            }
            Self::Ring { center, axis, radius, tube_radius } => {
                let off = place - DVec3::from(center);
                let along = off.dot(axis.into());
                let across = (off - along * DVec3::from(axis)).length();
                hypot(across - radius, along) - tube_radius
            }
            Self::Box { center, half, turn } => {
                let own = DQuat::from_array(turn).conjugate() * (place - DVec3::from(center));
                let beyond = own.abs() - DVec3::from(half);
                beyond.max(DVec3::ZERO).length() + beyond.max_element().min(0.0)
            }
            Self::Cylinder { from, to, radius } => {
                let (from, axis) = axis(from, to);
                let off = place - (from + 0.5 * axis);
                let along = off.dot(axis) / axis.length();
                let across = off.reject_from(axis).length();
                let beyond = DVec2::new(across - radius, along.abs() - 0.5 * axis.length());
                beyond.max(DVec2::ZERO).length() + beyond.max_element().min(0.0)
            }
        }
    }
}

/// Returns the start of an axis, and the vector along it.
fn axis(from: [f64; 3], to: [f64; 3]) -> (DVec3, DVec3) {
    (from.into(), DVec3::from(to) - DVec3::from(from))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_forward_most_point_of_a_shape_is_on_its_surface() {
        let turn = (DQuat::from_rotation_z(0.3) * DQuat::from_rotation_x(1.1)).to_array();
        for shape in [
            Shape::Sphere { center: [1.0, 2.0, 3.0], radius: 0.7 },
            Shape::Tube { from: [1.0, 2.0, 3.0], to: [2.0, 0.0, 1.0], radius: 0.2 },
            Shape::Ring { center: [1.0, 2.0, 3.0], axis: [0.6, 0.0, 0.8], radius: 0.5, tube_radius: 0.1 },
            Shape::Box { center: [1.0, -2.0, 0.5], half: [1.0, 0.2, 3.0], turn },
            Shape::Cylinder { from: [0.0, 1.0, 2.0], to: [1.0, 3.0, -1.0], radius: 0.4 },
        ] {
            let point = shape.forward_most();
            for ahead in [-1e-3, 1e-3] {
                let off = shape.distance(point + ahead * DVec3::X);
                // At an edge or a corner the surface comes nearer from the side, but not from ahead.
                assert!(off.signum() == ahead.signum() && off.abs() <= 1e-3 + 1e-15, "{shape:?}: {off}");
            }
            assert!(shape.distance(point).abs() < 1e-15, "{shape:?}");
        }
    }

    #[test]
    fn distances_to_a_box_and_a_cylinder_are_those_of_sides_edges_and_the_inside() {
        let cuboid =
            Shape::Box { center: [1.0, 0.0, 0.0], half: [1.0, 2.0, 3.0], turn: [0.0, 0.0, 0.0, 1.0] };
        let cylinder = Shape::Cylinder { from: [0.0, 0.0, -1.0], to: [0.0, 0.0, 1.0], radius: 2.0 };
        for (shape, place, expected) in [
            (cuboid, [2.5, 0.0, 0.0], 0.5),
            (cuboid, [5.0, 6.0, 0.0], 5.0),
            (cuboid, [1.0, 0.5, 0.0], -1.0),
            (cylinder, [0.0, 2.25, 0.0], 0.25),
            (cylinder, [5.0, 0.0, 5.0], 5.0),
            (cylinder, [0.0, 0.0, 0.5], -0.5),
        ] {
            assert!((shape.distance(place.into()) - expected).abs() < 1e-15, "{shape:?} at {place:?}");
        }
    }
}
