//! The limits of a model: its number of triangles, its size, and how far away its corners may be.

/// Greatest number of triangles in one model: they take about 600 MB while they are prepared.
pub const MOST_TRIANGLES: usize = 5_000_000;
/// Greatest magnitude of a coordinate.
pub const MOST_COORDINATE: f64 = 1e6;
/// Least size of the box around a model.
pub const LEAST_SIZE: f64 = 1e-6;
