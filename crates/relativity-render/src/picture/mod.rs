//! Pictures and their parts: the tiles, where in them a body may be, the hits of their pixels, and what is
//! made of finished ones.

pub(crate) mod candidates;
pub mod compose;
pub(crate) mod footprint;
pub(crate) mod hit;
mod painted;
pub mod pixels;
pub mod rectified_hits;
pub mod rectify;
mod sight;
pub(crate) mod tiles;
