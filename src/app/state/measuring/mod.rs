//! Measuring in the views: a ruler for angles, and a stopwatch.

pub mod angle_ruler;
pub mod stopwatch;
