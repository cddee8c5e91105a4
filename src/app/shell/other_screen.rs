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

/// Returns the number of a screen that the window of this `frame` is not on, in the system's order.
#[cfg(feature = "desktop")]
pub fn other_screen(frame: &eframe::Frame) -> Option<usize> {
    let window = frame.winit_window()?;
    let own = window.current_monitor()?;
    window.available_monitors().position(|screen| screen != own)
}

/// Returns `None`: a browser reports no other screen.
#[cfg(not(feature = "desktop"))]
pub const fn other_screen(_: &eframe::Frame) -> Option<usize> {
    None
}
