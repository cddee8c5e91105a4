//! A ride: what the rider does, and its comfort.

pub mod comfort;
pub mod saddle;
