//! The surfaces of shapes over two parameters: what triangles are corners of, and how they are turned.

use glam::DVec3;
use relativity_core::math;

use crate::body::Shape;

/// A body's surface in the rest frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Surface {
    /// Of a tube with rounded ends, or of a ball.
    Tube(TubeSurface),
    /// Of a torus.
    Ring(RingSurface),
}

/// Of a tube with rounded ends; of a ball if it has no length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TubeSurface {
    center: DVec3,
    turn: Turn,
    /// Half the length of its axis.
    pub half_length: f64,
    radius: f64,
}

/// Of a torus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingSurface {
    center: DVec3,
    turn: Turn,
    radius: f64,
    tube_radius: f64,
}

/// Three unit vectors at right angles: how a shape is turned around its axis.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Turn {
    axis: DVec3,
    across: DVec3,
    side: DVec3,
}

impl Turn {
    fn new(axis: DVec3) -> Self {
        let across = axis.any_orthonormal_vector();
        Self { axis, across, side: axis.cross(across) }
    }

    /// Unit vector off the axis.
    fn outward(&self, angle: f64) -> DVec3 {
        self.across * math::cos(angle) + self.side * math::sin(angle)
    }
}

impl Surface {
    /// Of `shape`.
    pub fn new(shape: &Shape) -> Self {
        match *shape {
            Shape::Sphere { center, radius } => {
                Self::Tube(TubeSurface::new(center.into(), center.into(), radius))
            }
            Shape::Tube { from, to, radius } => Self::Tube(TubeSurface::new(from.into(), to.into(), radius)),
            Shape::Ring { center, axis, radius, tube_radius } => Self::Ring(RingSurface {
                center: center.into(),
                turn: Turn::new(axis.into()),
                radius,
                tube_radius,
            }),
        }
    }

    /// Unit vector across the axis, from which corners count their turn.
    pub fn across(&self) -> DVec3 {
        match self {
            Self::Tube(tube) => tube.turn.across,
            Self::Ring(ring) => ring.turn.across,
        }
    }
}

impl TubeSurface {
    fn new(from: DVec3, to: DVec3, radius: f64) -> Self {
        let axis = (to - from).try_normalize().unwrap_or(DVec3::X);
        Self {
            center: 0.5 * (from + to),
            turn: Turn::new(axis),
            half_length: 0.5 * (to - from).length(),
            radius,
        }
    }

    /// On the side, `t` half lengths along the axis from the middle.
    pub fn side(&self, t: f64, angle: f64) -> DVec3 {
        self.along(t) + self.turn.outward(angle) * self.radius
    }

    /// On the circle of the tube's radius through the axis, `t` half lengths along it, turned by `turn`.
    pub fn meridian(&self, t: f64, turn: f64, angle: f64) -> DVec3 {
        let normal = self.turn.axis * math::cos(angle) + self.turn.outward(turn) * math::sin(angle);
        self.along(t) + normal * self.radius
    }

    fn along(&self, t: f64) -> DVec3 {
        self.center + self.turn.axis * (t * self.half_length)
    }
}

impl RingSurface {
    /// Turned around the axis by `turn`, and around the tube by `angle`.
    pub fn at(&self, turn: f64, angle: f64) -> DVec3 {
        self.center
            + self.turn.outward(turn) * (self.radius + self.tube_radius * math::cos(angle))
            + self.turn.axis * (self.tube_radius * math::sin(angle))
    }
}
