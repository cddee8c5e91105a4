//! The sticks of a game controller.

/// Both sticks, each to the right and up, -1 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sticks {
    /// The stick under the left thumb.
    pub left: [f64; 2],
    /// The stick under the right thumb.
    pub right: [f64; 2],
}

/// Both sticks as they are held now; a desktop has none that a program reads without a library of the system's.
#[cfg(feature = "desktop")]
#[must_use]
pub const fn sticks() -> Option<Sticks> {
    None
}

#[cfg(not(feature = "desktop"))]
pub use super::web::controller::sticks;
