//! The views: the pictures of the eyes, what is drawn over them, and the places of all parts of the window.

pub(in crate::app) mod background_picture;
pub mod corrected;
pub mod dial;
pub mod examination;
pub(in crate::app) mod eyes;
pub(in crate::app) mod fade;
pub(in crate::app) mod flicker;
pub(in crate::app) mod halo;
pub(in crate::app) mod heat_map;
pub mod highlight;
pub mod hover;
pub mod instruments;
pub(in crate::app) mod laid_ruler;
pub(in crate::app) mod layouts;
pub mod offscreen;
pub mod offscreen_arrows;
pub mod panes;
pub(in crate::app) mod picture_steps;
pub(in crate::app) mod predicted_place;
pub(in crate::app) mod slide;
pub mod start_picture;
pub(in crate::app) mod stereoscope;
pub mod thumbnails;
mod titles;
pub(in crate::app) mod window_layout;
