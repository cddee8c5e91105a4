//! The name of a shape in scene files, and the numbers that it is given by there.

use super::Shape;

impl Shape {
    /// The name in scene files.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Sphere { .. } => "sphere",
            Self::Tube { .. } => "tube",
            Self::Ring { .. } => "ring",
            Self::Box { .. } => "box",
            Self::Cylinder { .. } => "cylinder",
        }
    }

    /// The numbers in the order of the scene format; of a box half its size, and its turn as a quaternion.
    #[must_use]
    pub fn numbers(&self) -> Vec<f64> {
        match *self {
            Self::Sphere { center, radius } => [&center[..], &[radius]].concat(),
            Self::Tube { from, to, radius } | Self::Cylinder { from, to, radius } => {
                [&from[..], &to, &[radius]].concat()
            }
            Self::Ring { center, axis, radius, tube_radius } => {
                [&center[..], &axis, &[radius, tube_radius]].concat()
            }
            Self::Box { center, half, turn } => [&center[..], &half, &turn].concat(),
        }
    }
}
