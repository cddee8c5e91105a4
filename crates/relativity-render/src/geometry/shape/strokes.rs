//! The strokes that a shape is drawn with: lines and circles at rest, with the thickness of what they stand
//! for.

use std::f64::consts::TAU;

use glam::{DQuat, DVec3};
use relativity_core::math::sin_cos;

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
        centre: DVec3,
        /// Vectors at right angles from the centre to the circle.
        across: [DVec3; 2],
    },
}

impl Path {
    /// The circle about `axis` (unit vector).
    #[must_use]
    pub fn circle(centre: DVec3, axis: DVec3, radius: f64) -> Self {
        let (u, v) = axis.any_orthonormal_pair();
        Self::Circle { centre, across: [u * radius, v * radius] }
    }

    /// The point at `s`, which runs from 0 to 1.
    #[must_use]
    pub fn at(&self, s: f64) -> DVec3 {
        match *self {
            Self::Line { from, to } => from.lerp(to, s),
            Self::Circle { centre, across: [u, v] } => {
                let (sin, cos) = sin_cos(s * TAU);
                centre + cos * u + sin * v
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

/// Whoever looks at something, in its rest frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Onlooker {
    /// An eye at this place.
    At(DVec3),
    /// An eye far away, which looks along this direction everywhere.
    Afar(DVec3),
}

impl Onlooker {
    /// The direction, of any length, along which `place` is seen.
    #[must_use]
    pub fn line_of_sight(self, place: DVec3) -> DVec3 {
        match self {
            Self::At(eye) => place - eye,
            Self::Afar(direction) => direction,
        }
    }

    /// The same onlooker in axes that are turned by `turn` about `middle`, and have their origin there.
    pub(crate) fn in_axes(self, middle: DVec3, turn: DQuat) -> Self {
        let back = turn.inverse();
        match self {
            Self::At(eye) => Self::At(back * (eye - middle)),
            Self::Afar(direction) => Self::Afar(back * direction),
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

    /// A straight edge.
    pub(super) const fn line(from: DVec3, to: DVec3) -> Self {
        Self::edge(Path::Line { from, to })
    }
}
