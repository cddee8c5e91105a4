//! Corners of triangles over a unit shape, for bodies of that shape to be placed on.

use bytemuck::{Pod, Zeroable};
use relativity_core::math::log2;

/// Mirror of the shaders' `Corner`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Corner {
    pub profile: [f32; 4],
    pub turn: [f32; 2],
}

/// The coarseness of a grid over a shape: the number of times that its segments are halved, for each of the
/// directions of [`CentredShape::grid_sizes`](super::shape::questions::CentredShape::grid_sizes).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Coarseness([u8; 3]);

impl Coarseness {
    /// The number of halvings beyond which no shape has fewer segments.
    const MOST: u8 = 7;
    /// Size in the picture, pixels, up to which half the segments do. Of a circle of that size 32 segments
    /// are 0.24 px off.
    const HALVED_PX: f64 = 100.0;

    /// Returns the coarseness for these greatest sizes in the picture, pixels: infinite where nobody knows.
    ///
    /// A segment is as far off as its sagitta, in proportion to the size and to the square of the segment's
    /// share of it: a quarter of the size needs half the segments.
    pub fn for_sizes(px: [f64; 3]) -> Self {
        // What is no number is 0.
        Self(px.map(|px| ((1.0 + 0.5 * log2(Self::HALVED_PX / px)) as u8).min(Self::MOST)))
    }

    /// Returns how many segments are left of `finest`, at least `least`, in the way of this number.
    pub fn segments(self, way: usize, finest: u32, least: u32) -> u32 {
        (finest >> self.0[way]).max(least)
    }
}

/// The corners of a grid over a shape, and the triangles between them, counter-clockwise from outside.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Template {
    pub corners: Vec<Corner>,
    pub triangles: Vec<u32>,
}
