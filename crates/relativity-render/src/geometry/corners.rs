//! Corners of triangles over a unit shape, for bodies of that shape to be placed on.

use bytemuck::{Pod, Zeroable};

/// Mirror of the shaders' `Corner`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Corner {
    pub profile: [f32; 4],
    pub turn: [f32; 2],
}

/// The corners of a grid over a shape, and the triangles between them, counter-clockwise from outside.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Template {
    pub corners: Vec<Corner>,
    pub triangles: Vec<u32>,
}
