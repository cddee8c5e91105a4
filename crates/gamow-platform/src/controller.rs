//! A game controller at a desktop, where a program reads none without a library of the system's.

use crate::sticks::Sticks;

/// Both sticks as they are held now: none.
#[must_use]
pub const fn sticks() -> Option<Sticks> {
    None
}
