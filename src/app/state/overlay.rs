//! Overlays over the whole window, one at a time.

/// Something that is shown until it is closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Overlay {
    /// The help page.
    Help,
    /// The command palette.
    Palette,
    /// The start page: lessons and presets.
    Start,
}
