//! A piece of a body as the GPU draws it: a rectangle with the whole body's data.

use bytemuck::{Pod, Zeroable};
use glam::DVec2;

use crate::gpu::drawing::Shot;
use crate::picture::footprint::Rectangle;
use crate::scene::prepared_body::{Placement, PreparedBody};
use crate::scene::wheel::packed::TurningStart;

/// Below this radius a piece is drawn as one that may be thin, px. The shader fades what it finds thinner
/// than [`FADED_PX`]; the rest is room. The radius is the one across x: what `Geometry::Contracted` flattens
/// along x below a pixel is drawn as thin as it is there.
pub const THIN_PX: f64 = 0.75;
/// Below this radius bodies are faded in pictures instead of drawn thinner, px.
pub const FADED_PX: f64 = 0.5;

/// Mirror of the shaders' `Piece`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Piece {
    pub place: [f32; 4],
    pub second_axis_index_brightness: [f32; 4],
    pub place_radius: [f32; 4],
    pub form: [f32; 4],
    pub turn: [f32; 4],
    pub light: [f32; 4],
    pub pattern: [f32; 3],
    pub spin: [f32; 4],
    pub rim: [f32; 2],
}

impl Piece {
    /// Layout in which the vertex stage reads a piece.
    pub const LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
        array_stride: size_of::<Self>() as u64,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![
            0 => Float32x4, 1 => Float32x4, 2 => Float32x4, 3 => Float32x4, 4 => Float32x4, 5 => Float32x4,
            6 => Float32x3, 7 => Float32x4, 8 => Float32x2
        ],
    };

    /// Returns the piece of `body` without a rectangle, which [`Self::placed`] gives it, or else the vertex
    /// stage.
    pub fn new(body: &PreparedBody, shot: &Shot<'_>) -> Self {
        let TurningStart { placement: Placement { place_radius, form, turn }, spin, rim } = shot.shown(body);
        Self {
            place: [0.0; 4],
            second_axis_index_brightness: [0.0, 0.0, body.index(), body.brightness as f32],
            place_radius,
            form,
            turn,
            light: shot.light(body),
            pattern: shot.pattern(body),
            spin,
            rim,
        }
    }

    /// Returns the piece in this rectangle.
    pub fn placed(&self, rectangle: &Rectangle) -> Self {
        let [middle, first, second] =
            [rectangle.middle, rectangle.half_axes[0], rectangle.half_axes[1]].map(DVec2::as_vec2);
        let [_, _, index, brightness] = self.second_axis_index_brightness;
        Self {
            place: [middle.x, middle.y, first.x, first.y],
            second_axis_index_brightness: [second.x, second.y, index, brightness],
            ..*self
        }
    }
}
