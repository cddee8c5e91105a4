//! Solid shapes at rest in the frame of their group, and their geometry: a file for each question.

mod bounds;
mod distance;
mod forward_most;
mod numbers;
pub mod samples;
pub mod strokes;

use glam::{DQuat, DVec3};

use crate::wheel::spin::{Spin, about_y};

/// A solid shape in the rest frame. Lengths in the scene's unit; `[x, y, z]`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Shape {
    /// A ball of any size.
    Sphere {
        /// Centre of the ball.
        center: [f64; 3],
        /// Radius of the ball, above 0.
        radius: f64,
    },
    /// A cylinder with rounded ends (a capsule).
    Tube {
        /// Centre of one rounded end.
        from: [f64; 3],
        /// Centre of the other.
        to: [f64; 3],
        /// Radius of the tube, above 0.
        radius: f64,
    },
    /// A torus, the shape of a tyre.
    Ring {
        /// Centre of the torus.
        center: [f64; 3],
        /// Unit vector along the axis of symmetry.
        axis: [f64; 3],
        /// Radius of the circle in the middle of the tube, above `tube_radius`.
        radius: f64,
        /// Radius of the tube, above 0.
        tube_radius: f64,
    },
    /// A box: three pairs of flat faces at right angles.
    Box {
        /// Centre of the box.
        center: [f64; 3],
        /// Half its lengths along its own axes, above 0.
        half: [f64; 3],
        /// Unit quaternion `[x, y, z, w]` that turns its own axes into those of the rest frame.
        turn: [f64; 4],
    },
    /// A cylinder with flat ends.
    Cylinder {
        /// Centre of one flat end.
        from: [f64; 3],
        /// Centre of the other, elsewhere.
        to: [f64; 3],
        /// Radius of the cylinder, above 0.
        radius: f64,
    },
}

impl Shape {
    /// Whether it stays as it is while it turns: a body of revolution about the axle of `spin`.
    #[must_use]
    pub fn is_round_about(&self, spin: &Spin) -> bool {
        let is_on_axle = |place: [f64; 3]| spin.off_axle(place.into()) == DVec3::ZERO;
        match *self {
            Self::Sphere { center, .. } => is_on_axle(center),
            Self::Tube { from, to, .. } | Self::Cylinder { from, to, .. } => {
                is_on_axle(from) && is_on_axle(to)
            }
            Self::Ring { center, axis: [x, _, z], .. } => is_on_axle(center) && x == 0.0 && z == 0.0,
            Self::Box { .. } => false,
        }
    }

    /// The shape moved by `offset`.
    #[must_use]
    pub fn moved(self, offset: [f64; 3]) -> Self {
        let moved = |[x, y, z]: [f64; 3]| [x + offset[0], y + offset[1], z + offset[2]];
        match self {
            Self::Sphere { center, radius } => Self::Sphere { center: moved(center), radius },
            Self::Tube { from, to, radius } => Self::Tube { from: moved(from), to: moved(to), radius },
            Self::Ring { center, axis, radius, tube_radius } => {
                Self::Ring { center: moved(center), axis, radius, tube_radius }
            }
            Self::Box { center, half, turn } => Self::Box { center: moved(center), half, turn },
            Self::Cylinder { from, to, radius } => {
                Self::Cylinder { from: moved(from), to: moved(to), radius }
            }
        }
    }

    /// The shape turned by `angle` about the axle of `spin`, as [`Spin::turned`].
    #[must_use]
    pub(crate) fn turned(self, spin: &Spin, angle: f64) -> Self {
        let turned = |place: [f64; 3]| spin.turned(place.into(), angle).to_array();
        match self {
            Self::Sphere { center, radius } => Self::Sphere { center: turned(center), radius },
            Self::Tube { from, to, radius } => Self::Tube { from: turned(from), to: turned(to), radius },
            Self::Ring { center, axis, radius, tube_radius } => {
                let axis = about_y(axis.into(), angle).to_array();
                Self::Ring { center: turned(center), axis, radius, tube_radius }
            }
            Self::Box { center, half, turn } => {
                let turn = DQuat::from_rotation_y(angle) * DQuat::from_array(turn);
                Self::Box { center: turned(center), half, turn: turn.to_array() }
            }
            Self::Cylinder { from, to, radius } => {
                Self::Cylinder { from: turned(from), to: turned(to), radius }
            }
        }
    }
}
