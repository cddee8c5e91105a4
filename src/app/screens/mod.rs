//! Screens: the whole one, the projector's, a show for an audience, and pictures of the window.

pub(super) mod full_screen;
pub(super) mod other_screen;
pub(super) mod projector;
#[cfg(feature = "desktop")]
pub(super) mod screenshot;
pub mod stage;
