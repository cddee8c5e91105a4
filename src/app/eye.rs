//! Which of the two eyes.

/// One of the two eyes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Eye {
    /// The primary aperture.
    Left,
    /// The secondary aperture.
    Right,
}

impl Eye {
    /// Left, then right, as everywhere on screen.
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// Its place in [`Self::BOTH`].
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::Left => 0,
            Self::Right => 1,
        }
    }

    /// What it is called.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Left => "Left eye",
            Self::Right => "Right eye",
        }
    }
}
