//! Coordinates of a place on a shape, along and around its axis.

use std::f64::consts::TAU;

use glam::DVec3;
use relativity_core::math::{atan2, hypot};

use crate::shape::Shape;

/// A body's shape about its middle, in its own axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Form {
    /// A tube with rounded ends; a ball if it has no length.
    Tube { half_length: f64, radius: f64 },
    /// A cylinder with flat ends.
    Cylinder { half_length: f64, radius: f64 },
    /// A ring, as a torus.
    Ring { radius: f64, tube_radius: f64 },
    /// A box, with three pairs of faces.
    Box { half: DVec3 },
}

/// A place on a round shape, in the shape's own coordinates.
#[derive(Debug, Clone, Copy)]
pub struct Chart {
    /// Arc along the axis, from the beginning; and its gradient.
    pub along: f64,
    pub along_gradient: DVec3,
    /// Angle around the axis, radians; and its gradient.
    pub around: f64,
    pub around_gradient: DVec3,
    /// Distance from the axis.
    pub off_axis: f64,
}

impl Form {
    /// Returns the form of `shape`.
    pub fn new(shape: &Shape) -> Self {
        match *shape {
            Shape::Sphere { radius, .. } => Self::Tube { half_length: 0.0, radius },
            Shape::Tube { from, to, radius } => Self::Tube { half_length: half_way(from, to), radius },
            Shape::Cylinder { from, to, radius } => {
                Self::Cylinder { half_length: half_way(from, to), radius }
            }
            Shape::Box { half, .. } => Self::Box { half: half.into() },
            Shape::Ring { radius, tube_radius, .. } => Self::Ring { radius, tube_radius },
        }
    }

    /// Returns half the length between the ends; 0 for a form without ends.
    pub const fn half_length(self) -> f64 {
        match self {
            Self::Tube { half_length, .. } | Self::Cylinder { half_length, .. } => half_length,
            Self::Ring { .. } | Self::Box { .. } => 0.0,
        }
    }

    /// Returns the radius of the circle that parallels divide.
    pub const fn radius(self) -> f64 {
        match self {
            Self::Tube { radius, .. } | Self::Cylinder { radius, .. } => radius,
            Self::Ring { tube_radius, .. } => tube_radius,
            Self::Box { .. } => 0.0,
        }
    }

    /// The steps of squares as near to `step` as close around the shape.
    pub fn squares(self, step: f64) -> [f64; 2] {
        let closing = |radius: f64| TAU / (2.0 * (0.5 * TAU * radius / step).round()).max(2.0);
        match self {
            Self::Tube { half_length: 0.0, radius } => [closing(radius) * radius, closing(radius)],
            Self::Tube { radius, .. } | Self::Cylinder { radius, .. } => [step, closing(radius)],
            Self::Ring { radius, tube_radius } => [closing(tube_radius) * tube_radius, closing(radius)],
            Self::Box { .. } => [step, 1.0],
        }
    }

    /// Returns the chart of `place`, on a round shape.
    pub fn chart(self, place: DVec3, normal: DVec3) -> Chart {
        let DVec3 { x, y, z } = place;
        let off_axis = hypot(x, y);
        let outward = DVec3::new(x, y, 0.0) / off_axis.max(1e-30);
        let (along, along_gradient) = self.along(off_axis, outward, z, normal.z);
        Chart {
            along,
            along_gradient,
            around: atan2(y, x),
            around_gradient: DVec3::Z.cross(outward) / off_axis.max(1e-30),
            off_axis,
        }
    }

    /// The arc along the axis, and its gradient, at the height `z` where the normal has this part along the axis.
    fn along(self, off_axis: f64, outward: DVec3, z: f64, normal: f64) -> (f64, DVec3) {
        match self {
            Self::Tube { half_length, radius } => {
                let beyond = z - z.clamp(-half_length, half_length);
                let (arc, gradient) = arc(off_axis, outward, beyond, radius);
                (half_length + (z - beyond) + arc, gradient)
            }
            Self::Cylinder { half_length, radius } if normal.abs() > 0.5 => {
                let inward = (radius - off_axis).copysign(normal);
                (half_length + half_length.copysign(normal) + inward, outward * -normal.signum())
            }
            Self::Ring { radius, tube_radius } => arc(off_axis - radius, outward, z, tube_radius),
            Self::Cylinder { half_length, .. } => (z + half_length, DVec3::Z),
            Self::Box { .. } => (0.0, DVec3::ZERO),
        }
    }
}

fn half_way(from: [f64; 3], to: [f64; 3]) -> f64 {
    0.5 * DVec3::from(from).distance(to.into())
}

/// The arc of a circle of this `radius` from its outermost place up to where `off` and `z` lead from its middle.
fn arc(off: f64, outward: DVec3, z: f64, radius: f64) -> (f64, DVec3) {
    let gradient = (DVec3::Z * off - outward * z) / hypot(off, z).max(1e-30);
    (radius * atan2(z, off), gradient)
}
