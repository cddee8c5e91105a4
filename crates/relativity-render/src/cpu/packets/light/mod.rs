//! The light that rays receive, from the bodies they meet to the bytes of a picture.

pub(super) mod colour;
mod daylight;
pub(super) mod encode;
pub(super) mod received;
pub(super) mod tables;
