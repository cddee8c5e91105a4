//! The surfaces of shapes over two parameters: what triangles are corners of, and how they are turned.

use std::f64::consts::FRAC_PI_2;

use glam::{DQuat, DVec3};
use relativity_core::math;

use crate::shape::Shape;

/// A body's surface in the rest frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Surface {
    /// Surface of a tube with rounded ends, or of a ball.
    Tube(TubeSurface),
    /// Surface of a torus.
    Ring(RingSurface),
    /// Surface of a box.
    Box(BoxSurface),
    /// Surface of a cylinder with flat ends.
    Cylinder(CylinderSurface),
}

/// The surface of a tube with rounded ends; of a ball if it has no length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TubeSurface {
    center: DVec3,
    turn: DQuat,
    /// Half the length of its axis.
    pub half_length: f64,
    radius: f64,
}

/// The surface of a torus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingSurface {
    center: DVec3,
    turn: DQuat,
    radius: f64,
    tube_radius: f64,
}

/// The surface of a box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoxSurface {
    center: DVec3,
    turn: DQuat,
    half: DVec3,
}

/// The surface of a cylinder with flat ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CylinderSurface {
    center: DVec3,
    turn: DQuat,
    half_length: f64,
    radius: f64,
}

impl Surface {
    /// Returns the surface of `shape`, whose own axes have this `turn`.
    pub fn new(shape: &Shape, turn: DQuat) -> Self {
        match *shape {
            Shape::Sphere { center, radius } => {
                Self::Tube(TubeSurface { center: center.into(), turn, half_length: 0.0, radius })
            }
            Shape::Tube { from, to, radius } => {
                let (from, to) = (DVec3::from(from), DVec3::from(to));
                let half_length = 0.5 * (to - from).length();
                Self::Tube(TubeSurface { center: 0.5 * (from + to), turn, half_length, radius })
            }
            Shape::Ring { center, radius, tube_radius, .. } => {
                Self::Ring(RingSurface { center: center.into(), turn, radius, tube_radius })
            }
            Shape::Box { center, half, .. } => {
                Self::Box(BoxSurface { center: center.into(), turn, half: half.into() })
            }
            Shape::Cylinder { from, to, radius } => {
                let (from, to) = (DVec3::from(from), DVec3::from(to));
                let half_length = 0.5 * (to - from).length();
                Self::Cylinder(CylinderSurface { center: 0.5 * (from + to), turn, half_length, radius })
            }
        }
    }
}

impl Surface {
    /// Returns places of which one is about as far away as the farthest of the surface: both ends of a tube or cylinder, four
    /// places of a ring, the corners of a box.
    pub fn ends(&self) -> impl Iterator<Item = DVec3> {
        let place = |i: u32| {
            let sign = |bit: u32| if i & bit == 0 { -1.0 } else { 1.0 };
            match self {
                Self::Tube(tube) => tube.side(sign(1), 0.0),
                Self::Ring(ring) => ring.at(FRAC_PI_2 * f64::from(i), 0.0),
                Self::Box(surface) => surface.at(DVec3::new(sign(1), sign(2), sign(4))),
                Self::Cylinder(cylinder) => cylinder.at(sign(1), 0.0, 0.0),
            }
        };
        let count = match self {
            Self::Tube(_) | Self::Cylinder(_) => 2,
            Self::Ring(_) => 4,
            Self::Box(_) => 8,
        };
        (0..count).map(place)
    }
}

/// Unit vector off the z axis, `angle` from the x axis.
fn outward(angle: f64) -> DVec3 {
    let (sine, cosine) = math::sin_cos(angle);
    DVec3::new(cosine, sine, 0.0)
}

impl TubeSurface {
    /// On the side, `t` half lengths along the axis from the middle.
    pub fn side(&self, t: f64, angle: f64) -> DVec3 {
        self.along(t, outward(angle))
    }

    /// On the circle of the tube's radius through the axis, `t` half lengths along it, turned by `turn`.
    pub fn meridian(&self, t: f64, turn: f64, angle: f64) -> DVec3 {
        let (sine, cosine) = math::sin_cos(angle);
        self.along(t, DVec3::Z * cosine + outward(turn) * sine)
    }

    fn along(&self, t: f64, normal: DVec3) -> DVec3 {
        self.center + self.turn * (DVec3::Z * (t * self.half_length) + normal * self.radius)
    }
}

impl RingSurface {
    /// Turned around the axis by `turn`, and around the tube by `angle`.
    pub fn at(&self, turn: f64, angle: f64) -> DVec3 {
        let (sine, cosine) = math::sin_cos(angle);
        let off_axis = outward(turn) * (self.radius + self.tube_radius * cosine);
        self.center + self.turn * (off_axis + DVec3::Z * (self.tube_radius * sine))
    }
}

impl BoxSurface {
    /// The middle of the box.
    pub const fn center(&self) -> DVec3 {
        self.center
    }

    /// At a place on the cube from -1 to 1.
    pub fn at(&self, place: DVec3) -> DVec3 {
        self.center + self.turn * (place * self.half)
    }
}

impl CylinderSurface {
    /// `t` half lengths along the axis from the middle, and `share` of the radius off it.
    pub fn at(&self, t: f64, share: f64, angle: f64) -> DVec3 {
        let off_axis = outward(angle) * (share * self.radius);
        self.center + self.turn * (off_axis + DVec3::Z * (t * self.half_length))
    }
}
