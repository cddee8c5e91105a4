//! Wheels: bodies that turn about an axle along y in the frame of their group, while that moves along x.

pub(crate) mod bounds;
mod model;
pub(crate) mod packed;
pub(crate) mod solid;
