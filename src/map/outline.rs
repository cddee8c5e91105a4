//! The outlines of bodies at rest: lines and circles with the thickness of what they stand for.

use glam::{DQuat, DVec3};
use relativity_core::math;
use relativity_render::Shape;

use super::Projection;

/// A line or a circle at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Path {
    /// From a place to another.
    Line { from: DVec3, to: DVec3 },
    /// Around a centre, through the centre plus each of two vectors at right angles.
    Circle { center: DVec3, across: [DVec3; 2] },
}

impl Path {
    /// The point at `s`, which runs from 0 to 1.
    pub fn at(&self, s: f64) -> DVec3 {
        match *self {
            Self::Line { from, to } => from.lerp(to, s),
            Self::Circle { center, across: [u, v] } => {
                let (sin, cos) = math::sin_cos(s * std::f64::consts::TAU);
                center + cos * u + sin * v
            }
        }
    }

    /// Into how many parts it is divided at least, so that no bend is overlooked.
    pub const fn parts(&self) -> u32 {
        match self {
            Self::Line { .. } => 2,
            Self::Circle { .. } => 12,
        }
    }
}

/// A part of an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stroke {
    pub path: Path,
    /// Half its thickness; 0 of an edge.
    pub radius: f64,
    /// The only projection that it is drawn in, if not in both.
    pub only: Option<Projection>,
}

impl Stroke {
    const fn edge(path: Path) -> Self {
        Self { path, radius: 0.0, only: None }
    }

    const fn line(from: DVec3, to: DVec3) -> Self {
        Self::edge(Path::Line { from, to })
    }
}

/// Adds the outline of `shape` to `strokes`; `line_of_sight` tells which direction of the body at a place, at rest, a
/// projection looks along.
pub(super) fn outline(
    shape: &Shape,
    line_of_sight: impl Fn(DVec3, Projection) -> DVec3,
    strokes: &mut Vec<Stroke>,
) {
    match *shape {
        Shape::Sphere { center, radius } => {
            let center = center.into();
            strokes.extend(great_circles(center, radius, |projection| line_of_sight(center, projection)));
        }
        Shape::Tube { from, to, radius } => {
            strokes.push(Stroke { radius, ..Stroke::line(from.into(), to.into()) });
        }
        Shape::Ring { center, axis, radius, tube_radius } => {
            let path = circle(center.into(), axis.into(), radius);
            strokes.push(Stroke { radius: tube_radius, ..Stroke::edge(path) });
        }
        Shape::Box { center, half, turn } => {
            strokes.extend(edges(center.into(), half, DQuat::from_array(turn)));
        }
        Shape::Cylinder { from, to, radius } => cylinder(from.into(), to.into(), radius, strokes),
    }
}

/// The places along each stroke of the outline of `shape`, at rest: of a ball along no stroke, since that depends on who looks.
pub fn strokes(shape: &Shape) -> impl Iterator<Item = Vec<DVec3>> + use<> {
    let mut all = Vec::new();
    if !matches!(shape, Shape::Sphere { .. }) {
        outline(shape, |_, _| DVec3::Y, &mut all);
    }
    all.into_iter().map(|stroke| {
        let parts = 4 * stroke.path.parts();
        (0..=parts).map(|part| stroke.path.at(f64::from(part) / f64::from(parts))).collect()
    })
}

/// The circle that a ball shows to each projection: across its line of sight.
fn great_circles(center: DVec3, radius: f64, line_of_sight: impl Fn(Projection) -> DVec3) -> [Stroke; 2] {
    Projection::BOTH.map(|projection| {
        let path = circle(center, line_of_sight(projection), radius);
        Stroke { only: Some(projection), ..Stroke::edge(path) }
    })
}

fn circle(center: DVec3, axis: DVec3, radius: f64) -> Path {
    let (u, v) = axis.any_orthonormal_pair();
    Path::Circle { center, across: [u * radius, v * radius] }
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
        strokes.push(Stroke::edge(circle(end, axis, radius)));
    }
    // Where the sides are seen from above and from the side, in as far as they can be.
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

    /// How far `point` is from the surface of `shape`, worked out from what each shape is.
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
            Shape::Sphere { center: [1.0, 2.0, 3.0], radius: 0.7 },
            Shape::Box { center: [1.0, -2.0, 0.5], half: [1.0, 0.2, 3.0], turn: turn.to_array() },
            Shape::Cylinder { from: [0.0, 1.0, 2.0], to: [1.0, 3.0, -1.0], radius: 0.4 },
        ] {
            let mut strokes = Vec::new();
            outline(&shape, |_, projection| projection.line_of_sight(), &mut strokes);
            for stroke in strokes {
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
        let mut strokes = Vec::new();
        outline(&shape, |_, projection| projection.line_of_sight(), &mut strokes);
        assert_eq!((strokes.len(), strokes[0].radius), (1, 0.03));
        let top =
            (0..1000).map(|i| strokes[0].path.at(f64::from(i) / 1000.0)).fold(0.0, |top, p| p.z.max(top));
        assert!((top - 2.5).abs() < 1e-5, "{top}");
    }
}
