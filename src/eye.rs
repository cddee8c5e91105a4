//! The two eyes, left and right.

use serde::{Deserialize, Serialize};

/// An eye, of two.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Eye {
    /// Left eye, the primary aperture.
    Left,
    /// Right eye, the secondary aperture.
    Right,
}

impl Eye {
    /// Left, then right, as everywhere on screen.
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// Returns the place of the eye in [`Self::BOTH`].
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::Left => 0,
            Self::Right => 1,
        }
    }

    /// Returns the name of the eye.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Left => "Left eye",
            Self::Right => "Right eye",
        }
    }
}
