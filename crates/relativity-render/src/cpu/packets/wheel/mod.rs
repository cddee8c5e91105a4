//! Rays against bodies that turn.

mod course;
pub(super) mod spin;
pub(super) mod turning;
