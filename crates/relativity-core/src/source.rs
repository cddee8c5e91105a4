//! What is seen: a point that moves uniformly, or one of a wheel.

use crate::apparent::SourcePoint;
use crate::wheel::WheelPoint;

/// A source of light that moves along +x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Source {
    /// It rests in the moving frame.
    Point(SourcePoint),
    /// It turns about an axle there.
    Wheel(WheelPoint),
}

impl Source {
    /// The same source, a point on the axle being one that does not turn.
    pub(crate) fn simplest(self) -> Self {
        match self {
            Self::Wheel(wheel) if wheel.rho == 0.0 => Self::Point(wheel.hub),
            source => source,
        }
    }

    /// The point that rests in the moving frame: the source itself, or the hub that it turns about.
    #[must_use]
    pub const fn place(&self) -> SourcePoint {
        match self {
            Self::Point(point) => *point,
            Self::Wheel(wheel) => wheel.hub,
        }
    }
}

impl From<SourcePoint> for Source {
    fn from(point: SourcePoint) -> Self {
        Self::Point(point)
    }
}

impl From<WheelPoint> for Source {
    fn from(point: WheelPoint) -> Self {
        Self::Wheel(point)
    }
}
