//! The strokes that a shape is drawn with: lines and circles at rest, with the thickness of what they stand for.

use std::f64::consts::TAU;

use glam::{DQuat, DVec3};
use relativity_core::math::sin_cos;

use super::Shape;

/// A line or a circle at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    /// A straight line between two places.
    Line {
        /// The end at s = 0.
        from: DVec3,
        /// The end at s = 1.
        to: DVec3,
    },
    /// A circle, from s = 0 to 1.
    Circle {
        /// Centre of the ring.
        center: DVec3,
        /// Vectors at right angles from the centre to the circle.
        across: [DVec3; 2],
    },
}

impl Path {
    /// The circle about `axis` (unit vector).
    #[must_use]
    pub fn circle(center: DVec3, axis: DVec3, radius: f64) -> Self {
        let (u, v) = axis.any_orthonormal_pair();
        Self::Circle { center, across: [u * radius, v * radius] }
    }

    /// The point at `s`, which runs from 0 to 1.
    #[must_use]
    pub fn at(&self, s: f64) -> DVec3 {
        match *self {
            Self::Line { from, to } => from.lerp(to, s),
            Self::Circle { center, across: [u, v] } => {
                let (sin, cos) = sin_cos(s * TAU);
                center + cos * u + sin * v
            }
        }
    }

    /// The number of parts that it is divided into at least, so that no bend is overlooked.
    #[must_use]
    pub const fn parts(&self) -> u32 {
        match self {
            Self::Line { .. } => 2,
            Self::Circle { .. } => 12,
        }
    }
}

/// A line that a shape is drawn with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// The line or circle in its middle.
    pub path: Path,
    /// Half its thickness; 0 of an edge.
    pub radius: f64,
}

impl Stroke {
    /// An edge, which has no thickness.
    #[must_use]
    pub const fn edge(path: Path) -> Self {
        Self { path, radius: 0.0 }
    }

    const fn line(from: DVec3, to: DVec3) -> Self {
        Self::edge(Path::Line { from, to })
    }
}

impl Shape {
    /// The strokes that it is drawn with; none of a ball, whose outline depends on who looks.
    #[must_use]
    pub fn strokes(&self) -> Vec<Stroke> {
        match *self {
            Self::Sphere { .. } => Vec::new(),
            Self::Tube { from, to, radius } => {
                vec![Stroke { radius, ..Stroke::line(from.into(), to.into()) }]
            }
            Self::Ring { center, axis, radius, tube_radius } => {
                let path = Path::circle(center.into(), axis.into(), radius);
                vec![Stroke { path, radius: tube_radius }]
            }
            Self::Box { center, half, turn } => edges(center.into(), half, DQuat::from_array(turn)).collect(),
            Self::Cylinder { from, to, radius } => {
                let mut strokes = Vec::with_capacity(8);
                cylinder(from.into(), to.into(), radius, &mut strokes);
                strokes
            }
        }
    }
}

/// The twelve edges of a box.
fn edges(center: DVec3, half: [f64; 3], turn: DQuat) -> impl Iterator<Item = Stroke> {
    let axes = [DVec3::X * half[0], DVec3::Y * half[1], DVec3::Z * half[2]].map(|axis| turn * axis);
    (0..12).map(move |edge: usize| {
        let (along, corner) = (edge / 4, edge % 4);
        let sign = |bit: usize| if corner & bit == 0 { -1.0 } else { 1.0 };
        let middle = center + sign(1) * axes[(along + 1) % 3] + sign(2) * axes[(along + 2) % 3];
        Stroke::line(middle - axes[along], middle + axes[along])
    })
}

/// Both ends, and four lines along it.
fn cylinder(from: DVec3, to: DVec3, radius: f64, strokes: &mut Vec<Stroke>) {
    let axis = (to - from).try_normalize().unwrap_or(DVec3::Z);
    for end in [from, to] {
        strokes.push(Stroke::edge(Path::circle(end, axis, radius)));
    }
    // Where the sides are seen from above and from the side, as far as they can be.
    let beside = |towards: DVec3| towards.reject_from_normalized(axis).try_normalize();
    for side in [DVec3::X, DVec3::Y, DVec3::Z].into_iter().filter_map(beside) {
        for offset in [radius * side, -radius * side] {
            strokes.push(Stroke::line(from + offset, to + offset));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The distance of `point` from the surface of `shape`, by the definition of each shape.
    fn off_surface(shape: &Shape, point: DVec3) -> f64 {
        match *shape {
            Shape::Sphere { center, radius } => (point.distance(center.into()) - radius).abs(),
            Shape::Box { center, half, turn } => {
                let own = DQuat::from_array(turn).inverse() * (point - DVec3::from(center));
                let beyond = own.abs() - DVec3::from(half);
                beyond.max_element().abs()
            }
            Shape::Cylinder { from, to, radius } => {
                let axis = (DVec3::from(to) - DVec3::from(from)).normalize();
                ((point - DVec3::from(from)).reject_from_normalized(axis).length() - radius).abs()
            }
            Shape::Tube { .. } | Shape::Ring { .. } => 0.0,
        }
    }

    #[test]
    fn outlines_lie_on_the_surfaces_that_they_stand_for() {
        let turn = DQuat::from_rotation_z(0.3) * DQuat::from_rotation_x(1.1);
        for shape in [
            Shape::Box { center: [1.0, -2.0, 0.5], half: [1.0, 0.2, 3.0], turn: turn.to_array() },
            Shape::Cylinder { from: [0.0, 1.0, 2.0], to: [1.0, 3.0, -1.0], radius: 0.4 },
        ] {
            for stroke in shape.strokes() {
                for i in 0..=8 {
                    let off = off_surface(&shape, stroke.path.at(f64::from(i) / 8.0));
                    assert!(off < 1e-12, "{shape:?}: {off} off at {i}/8 of {stroke:?}");
                }
            }
        }
    }

    #[test]
    fn a_ring_is_drawn_as_thick_as_it_is_around_its_middle_circle() {
        let shape =
            Shape::Ring { center: [0.0, 3.0, 2.0], axis: [0.0, 1.0, 0.0], radius: 0.5, tube_radius: 0.03 };
        let strokes = shape.strokes();
        assert_eq!((strokes.len(), strokes[0].radius), (1, 0.03));
        let top =
            (0..1000).map(|i| strokes[0].path.at(f64::from(i) / 1000.0)).fold(0.0, |top, p| p.z.max(top));
        assert!((top - 2.5).abs() < 1e-5, "{top}");
    }
}
