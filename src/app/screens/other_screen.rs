//! The screen of the projector's window.

/// The screen on which the projector's window opens.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Screen {
    /// No screen, while the window is closed.
    #[default]
    NotChosen,
    /// There is no other one than the lecturer's.
    Same,
    /// The one of this number, in the system's order.
    Other(usize),
}
