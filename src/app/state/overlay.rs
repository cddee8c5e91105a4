//! Overlays over the whole window, one at a time.

/// Something that is shown until it is closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Overlay {
    /// The help page.
    Help,
    /// The command palette.
    Palette,
    /// The user's own answers in the open lesson, as a link.
    Answers,
    /// The links with the answers of a class.
    Class,
    /// The start page: the ways in, and the chapters.
    Start,
    /// The lessons of the chapter with this number, from 0.
    Chapter(usize),
    /// The page of all presets, in groups.
    Presets,
}

impl Overlay {
    /// Whether the overlay is a page in place of the parts of the window.
    #[must_use]
    pub const fn is_page(self) -> bool {
        matches!(self, Self::Start | Self::Chapter(_) | Self::Presets)
    }

    /// Returns the overlay below this one, to which Escape leads back.
    #[must_use]
    pub const fn below(self) -> Option<Self> {
        match self {
            Self::Chapter(_) | Self::Presets => Some(Self::Start),
            Self::Help | Self::Palette | Self::Answers | Self::Class | Self::Start => None,
        }
    }
}
