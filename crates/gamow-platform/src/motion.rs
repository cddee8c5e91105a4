//! Motion that the system asks to leave out.

/// Whether the system asks for less motion. Of desktops it is not known: none says so to a program without
/// its own libraries.
#[cfg(not(target_family = "wasm"))]
#[must_use]
pub const fn is_reduced() -> bool {
    false
}

#[cfg(target_family = "wasm")]
pub use crate::web::page::is_motion_reduced as is_reduced;
