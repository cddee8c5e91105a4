//! Capsules that contain a shape: what its bounds in a picture are worked out from.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use relativity_core::math::{cos, sin};

use crate::group_view::GroupView;
use crate::shape::Shape;

/// A tube with rounded ends in the rest frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Capsule {
    /// Centre of one end.
    pub from: DVec3,
    /// Centre of the other.
    pub to: DVec3,
    /// Radius of the tube.
    pub radius: f64,
}

impl Capsule {
    /// Returns a ball.
    pub const fn ball(center: DVec3, radius: f64) -> Self {
        Self { from: center, to: center, radius }
    }

    /// A ball around some, of which there is at least one.
    pub fn ball_around(all: &[Self]) -> Self {
        let ends = || all.iter().flat_map(|capsule| [capsule.from, capsule.to]);
        let (low, high) = ends()
            .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), end| (low.min(end), high.max(end)));
        let center = 0.5 * (low + high);
        let reach =
            |capsule: &Self| capsule.from.distance(center).max(capsule.to.distance(center)) + capsule.radius;
        Self::ball(center, all.iter().map(reach).fold(0.0, f64::max))
    }

    /// From the camera's event, in the axes along the group's motion.
    pub fn along_motion_from_camera(&self, view: &GroupView) -> Self {
        let [from, to] = [self.from, self.to].map(|end| view.along_motion_from_camera(end));
        Self { from, to, ..*self }
    }

    /// Adds balls to `out` that contain it, in its order, at most this long or no longer than wide.
    pub fn add_balls(&self, longest: f64, out: &mut Vec<Self>) {
        let length = self.from.distance(self.to);
        if length > longest && length > 2.0 * self.radius {
            for half in self.halves() {
                half.add_balls(longest, out);
            }
            return;
        }
        out.push(Self::ball(0.5 * (self.from + self.to), self.radius + 0.5 * length));
    }

    /// Returns both halves of the capsule.
    pub fn halves(&self) -> [Self; 2] {
        let middle = 0.5 * (self.from + self.to);
        [Self { to: middle, ..*self }, Self { from: middle, ..*self }]
    }
}

/// Adds capsules to `out` that contain `shape`; none for a box.
pub fn add_capsules(shape: &Shape, out: &mut Vec<Capsule>) {
    match *shape {
        Shape::Sphere { center, radius } => out.push(Capsule::ball(center.into(), radius)),
        Shape::Tube { from, to, radius } | Shape::Cylinder { from, to, radius } => {
            out.push(Capsule { from: from.into(), to: to.into(), radius });
        }
        Shape::Box { .. } => {}
        Shape::Ring { center, axis, radius, tube_radius } => {
            out.extend(arcs(center.into(), axis.into(), radius, tube_radius));
        }
    }
}

/// A ring's arcs, each in a capsule along its chord, moved outwards by half the sagitta.
fn arcs(center: DVec3, axis: DVec3, radius: f64, tube_radius: f64) -> impl Iterator<Item = Capsule> {
    // Half the sagitta, radius angle^2/16, adds no more than half the tube's radius. A thick ring has eight arcs
    // nevertheless, lest its hole be covered; the thinnest has no more than thirty-two, each worth a rectangle.
    let angle = (8.0 * tube_radius / radius).sqrt().clamp(0.2, 0.8);
    let count = (TAU / angle).ceil();
    let half_angle = PI / count;
    let half_sagitta = 0.5 * radius * (1.0 - cos(half_angle));
    let (u, v) = axis.any_orthonormal_pair();
    let point = move |middle: f64, end: f64| {
        let outward = u * cos(middle) + v * sin(middle);
        let along = v * cos(middle) - u * sin(middle);
        center
            + outward * (radius * cos(half_angle) + half_sagitta)
            + along * (end * radius * sin(half_angle))
    };
    (0..count as u32).map(move |i| {
        let middle = 2.0 * half_angle * f64::from(i);
        Capsule { from: point(middle, -1.0), to: point(middle, 1.0), radius: tube_radius + half_sagitta }
    })
}
