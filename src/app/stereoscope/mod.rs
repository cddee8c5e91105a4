//! The window as the screen of a stereoscope, such as a phone in a viewer with two lenses: each eye's picture in its half, the middles as far apart as
//! the lenses, and both turned with the head as far as the device tells how it is turned.

mod card;
mod lenses;
mod menu;
mod orientation;
mod screen;
pub mod viewer;
