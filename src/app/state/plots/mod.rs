//! The plots against T: their curves, and the look at them.

pub mod curves;
pub mod look;
