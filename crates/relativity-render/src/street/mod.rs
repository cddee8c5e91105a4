//! The street: the road, the house fronts and the sky, all at rest on the ground, and the shadows of bodies
//! on the road.

pub mod backdrop;
pub(crate) mod contact;
mod cover;
pub(crate) mod house_fronts;
pub(crate) mod sight;
