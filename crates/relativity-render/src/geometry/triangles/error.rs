//! Why triangles cannot be drawn.

use thiserror::Error;

use super::limits::{LEAST_SIZE, MOST_COORDINATE, MOST_TEXELS, MOST_TRIANGLES, MOST_WRAPS};

/// Why a model cannot be drawn, in one sentence.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum TrianglesError {
    /// No triangle with an area.
    #[error("the model has no triangle with an area")]
    NoArea,
    /// More triangles than are drawn.
    #[error("the model has {count} triangles, and {MOST_TRIANGLES} are the most")]
    TooMany {
        /// Number of its triangles.
        count: usize,
    },
    /// A corner that is not finite, or too far away.
    #[error(
        "corner {number} of the model is at {place:?}, and coordinates must lie between -{MOST_COORDINATE:e} and {MOST_COORDINATE:e}"
    )]
    Coordinate {
        /// Number of the corner, from 0.
        number: usize,
        /// The place of the corner.
        place: [f64; 3],
    },
    /// A model smaller than the least size.
    #[error("the model is {size:e} large, and {LEAST_SIZE:e} is the least")]
    Small {
        /// The greatest side of the box around it.
        size: f64,
    },
    /// Measured materials of some triangles, but not of all.
    #[error("the model has {triangles} triangles and the materials of {materials}")]
    MaterialCount {
        /// The number of materials.
        materials: usize,
        /// The number of triangles.
        triangles: usize,
    },
    /// A triangle with a corner that does not exist.
    #[error("triangle {triangle} of the model has a corner beyond the last of {count}")]
    NoCorner {
        /// Number of the triangle, from 0.
        triangle: usize,
        /// The number of corners in the model.
        count: usize,
    },
    /// Paint for some corners only.
    #[error("the model has {corners} corners and the colours of {paints}")]
    PaintCount {
        /// The number of paints in the model.
        paints: usize,
        /// The number of corners in the model.
        corners: usize,
    },
    /// Paint that reflects less than nothing or more than all.
    #[error(
        "the colour of corner {number} of the model is {paint:?}, and each part must lie between 0 and 1"
    )]
    Paint {
        /// Number of the corner, from 0.
        number: usize,
        /// The paint of the corner.
        paint: [f32; 3],
    },
    /// Textures of more texels than are kept.
    #[error("the textures of the model have {texels} texels, and {MOST_TEXELS} are the most")]
    ManyTexels {
        /// Number of texels of all its textures.
        texels: u64,
    },
    /// A texture that has not the texels of its size, or none.
    #[error("the texture has not as many texels as its size needs")]
    Texture,
    /// Textures for some triangles only, places for some corners only, or a texture that there is not.
    #[error(
        "each triangle of the model must name one of its textures or none, and each corner a place in it"
    )]
    TextureCount,
    /// A place in a texture that is not finite, or too far away.
    #[error(
        "corner {number} of the model is at {place:?} in its texture, and places must lie between -{MOST_WRAPS:e} and {MOST_WRAPS:e}"
    )]
    TexturePlace {
        /// Number of the corner, from 0.
        number: usize,
        /// The place of the corner in its texture.
        place: [f32; 2],
    },
}
