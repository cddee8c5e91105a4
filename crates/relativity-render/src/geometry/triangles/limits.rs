//! The limits of a model: its number of triangles, its size, how far away its corners may be, and its
//! textures.

/// Greatest number of triangles in one model: they take about 600 MB while they are prepared.
pub const MOST_TRIANGLES: usize = 5_000_000;
/// Greatest magnitude of a coordinate.
pub const MOST_COORDINATE: f64 = 1e6;
/// Least size of the box around a model.
pub const LEAST_SIZE: f64 = 1e-6;
/// Greatest number of texels of all textures of a model, those of 8192x8192: with their copies they take 360
/// MB.
pub const MOST_TEXELS: u64 = 1 << 26;
/// Greatest magnitude of a place in a texture, in its widths or heights: beyond, f32 has steps of a
/// thousandth of the texture.
pub const MOST_WRAPS: f32 = 1e4;
