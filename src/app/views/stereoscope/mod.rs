//! The window as the screen of a stereoscope, such as a phone in a viewer with two lenses: each eye's picture
//! in its half, the middles as far apart as the lenses, and both turned with the head as far as the device
//! tells how it is turned.

pub(in crate::app) mod card;
pub(in crate::app) mod lenses;
pub(in crate::app) mod orientation;
pub mod viewer;
