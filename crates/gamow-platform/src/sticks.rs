//! The sticks of a game controller.

/// Both sticks, each to the right and up, -1 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sticks {
    /// The stick under the left thumb.
    pub left: [f64; 2],
    /// The stick under the right thumb.
    pub right: [f64; 2],
}
