//! Projections of the world onto the map.

use glam::DVec3;

/// A chart of the space face, of two.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapProjection {
    /// From above: x to the right, y up.
    Plan,
    /// From the side, from where the eyes are: x to the right, z up.
    Side,
}

impl MapProjection {
    /// Both, from the top.
    pub const BOTH: [Self; 2] = [Self::Plan, Self::Side];

    /// Returns the coordinates of the world that run right and up (x is 0).
    #[must_use]
    pub const fn axes(self) -> [usize; 2] {
        match self {
            Self::Plan => [0, 1],
            Self::Side => [0, 2],
        }
    }

    /// The coordinates of a place to the right and up.
    #[must_use]
    pub fn flat(self, place: DVec3) -> [f64; 2] {
        self.axes().map(|axis| place[axis])
    }

    /// The direction that the projection looks along.
    #[must_use]
    pub const fn line_of_sight(self) -> DVec3 {
        match self {
            Self::Plan => DVec3::NEG_Z,
            Self::Side => DVec3::Y,
        }
    }
}
