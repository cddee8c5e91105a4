//! Capsules and blocks that contain a shape: what its bounds in a picture are worked out from.

use std::f64::consts::{PI, TAU};

use glam::{DMat3, DVec3};
use relativity_core::math::{cos, sin};

use crate::body::Shape;
use crate::group_view::GroupView;
use crate::turn::turn_of;

/// A tube with rounded ends in the rest frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Capsule {
    /// Centre of one end.
    pub from: DVec3,
    /// Centre of the other.
    pub to: DVec3,
    /// Radius.
    pub radius: f64,
}

/// A box in the rest frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// Centre.
    pub center: DVec3,
    /// From there to the middles of three faces, at right angles.
    pub half_axes: [DVec3; 3],
    /// The least radius of the shape in it.
    pub radius: f64,
}

impl Capsule {
    /// A ball.
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

    /// From the camera's event, reflected so that the group moves along +x.
    pub fn reflected_from_camera(&self, view: &GroupView) -> Self {
        let [from, to] = [self.from, self.to].map(|end| view.reflected_from_camera(end));
        Self { from, to, ..*self }
    }

    /// Its two halves.
    pub fn halves(&self) -> [Self; 2] {
        let middle = 0.5 * (self.from + self.to);
        [Self { to: middle, ..*self }, Self { from: middle, ..*self }]
    }
}

impl Block {
    /// From the camera's event, reflected so that the group moves along +x.
    pub fn reflected_from_camera(&self, view: &GroupView) -> Self {
        Self {
            center: view.reflected_from_camera(self.center),
            half_axes: self.half_axes.map(|axis| view.velocity.reflected(axis)),
            ..*self
        }
    }

    /// Its two halves, across its longest axis.
    pub fn halves(&self) -> [Self; 2] {
        let squares = DVec3::from(self.half_axes.map(DVec3::length_squared));
        let mut half = *self;
        half.half_axes[squares.max_position()] *= 0.5;
        let step = half.half_axes[squares.max_position()];
        [-step, step].map(|step| Self { center: self.center + step, ..half })
    }

    /// Its corners.
    pub fn corners(&self) -> [DVec3; 8] {
        let [x, y, z] = self.half_axes;
        std::array::from_fn(|i| {
            let side = |bit: usize| if i & bit == 0 { -1.0 } else { 1.0 };
            self.center + x * side(1) + y * side(2) + z * side(4)
        })
    }

    /// Its edges, tubes without a radius.
    pub fn edges(&self) -> impl Iterator<Item = Capsule> + use<> {
        let corners = self.corners();
        let edge = move |from: usize, bit: usize| {
            (from & bit == 0).then(|| Capsule { from: corners[from], to: corners[from | bit], radius: 0.0 })
        };
        (0..8).flat_map(move |from| [1, 2, 4].map(|bit| edge(from, bit)).into_iter().flatten())
    }

    /// The ball around it.
    pub fn ball_around(&self) -> Capsule {
        let radius = self.half_axes.iter().map(|axis| axis.length_squared()).sum::<f64>().sqrt();
        Capsule::ball(self.center, radius)
    }

    /// How far from the origin it is; 0 around it.
    pub fn distance(&self) -> f64 {
        let nearest = self.half_axes.iter().fold(self.center, |from_origin, axis| {
            let along = -self.center.dot(*axis) / axis.length_squared();
            from_origin + *axis * along.clamp(-1.0, 1.0)
        });
        nearest.length()
    }
}

/// The block that contains `shape`, if its bounds are better worked out from that than from capsules.
pub fn block(shape: &Shape) -> Option<Block> {
    let axes = |half: DVec3| {
        let turn = DMat3::from_quat(turn_of(shape));
        [turn.x_axis * half.x, turn.y_axis * half.y, turn.z_axis * half.z]
    };
    let block = |center, half: DVec3| Block { center, half_axes: axes(half), radius: half.min_element() };
    match *shape {
        Shape::Box { center, half, .. } => Some(block(center.into(), half.into())),
        Shape::Cylinder { from, to, radius } => {
            let (from, to) = (DVec3::from(from), DVec3::from(to));
            let half_length = 0.5 * (to - from).length();
            // Of a longer one the ends of a capsule are less than the corners of a block.
            (half_length < radius).then(|| block(0.5 * (from + to), DVec3::new(radius, radius, half_length)))
        }
        Shape::Sphere { .. } | Shape::Tube { .. } | Shape::Ring { .. } => None,
    }
}

/// Adds capsules to `out` that contain `shape`, unless it has a [`block`].
pub fn add_capsules(shape: &Shape, out: &mut Vec<Capsule>) {
    if block(shape).is_some() {
        return;
    }
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
