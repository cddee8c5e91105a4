//! The rays: a test per pixel, in the rest frame, on the GPU.
//!
//! Each piece of a body is drawn as a rectangle that surely contains its image (`footprint`); the
//! fragment stage boosts the pixel's line of sight into the rest frame, where rays are straight, and
//! tests it against the body.

mod crowd;
mod piece;
mod pieces;

use crate::geometry::kind::Kind;
use crate::gpu::canvas::Canvas;
use crate::gpu::device::Gpu;
use crate::gpu::drawing::{Batches, Drawing, Shot};
use crate::gpu::pipelines::{Pipelines, Technique};
use crate::gpu::sampling::Sampling;
use crate::view::group_view::GroupView;
use crowd::Crowd;
pub use piece::Piece;
pub use pieces::Bounds;
use pieces::Pieces;

/// Draws exactly what an aperture sees.
#[derive(Debug)]
pub struct RayRenderer {
    bounds: Bounds,
    pieces: Pieces,
    batches: Batches<Piece, ()>,
    crowd: Crowd,
}

/// Rectangles, and a ray test for each of their pixels.
pub const TECHNIQUE: Technique = Technique {
    source: Kind::impostor,
    vertex: "rectangle",
    buffers: &[Some(Piece::LAYOUT)],
    primitive: wgpu::PrimitiveState {
        topology: wgpu::PrimitiveTopology::TriangleStrip,
        ..Technique::TRIANGLES
    },
    constant: None,
};

/// The same where each sample of a pixel is drawn as a pixel.
pub const TECHNIQUE_AS_PIXELS: Technique = Technique { source: Kind::impostor_as_pixels, ..TECHNIQUE };

/// Returns the technique on `gpu`.
pub fn technique(gpu: &Gpu) -> Technique {
    if gpu.sampling() == Sampling::AS_PIXELS { TECHNIQUE_AS_PIXELS } else { TECHNIQUE }
}

impl RayRenderer {
    /// A renderer on `gpu` that looks for bodies within `bounds`; pipelines are made when first needed.
    pub fn new(gpu: &Gpu, canvas: &Canvas, bounds: Bounds) -> Self {
        let batches = || Batches::new(Pipelines::new(technique(gpu), canvas.body_layout(gpu)));
        Self { bounds, pieces: Pieces::default(), batches: batches(), crowd: Crowd::new(gpu, batches()) }
    }

    /// Puts the bodies of the groups whose views are `meant` into the vertex buffer, and makes the pipelines
    /// that they need, as [`Drawing::load`] does for all groups.
    pub fn load_groups(
        &mut self,
        gpu: &Gpu,
        vertices: &mut wgpu::Buffer,
        shot: &Shot<'_>,
        meant: impl Fn(&GroupView) -> bool,
    ) {
        self.pieces.refill(&mut self.crowd, shot, self.bounds, meant);
        self.batches.refill(gpu, vertices, shot, self.pieces.runs());
        self.crowd.load(gpu, shot);
    }
}

impl Drawing for RayRenderer {
    fn load(&mut self, gpu: &Gpu, vertices: &mut wgpu::Buffer, shot: &Shot<'_>) {
        self.load_groups(gpu, vertices, shot, |_| true);
    }

    fn record_bodies(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        vertices: &wgpu::Buffer,
        frames: &[wgpu::BindGroup],
        are_thin: bool,
    ) {
        for (batches, vertices) in [(&self.batches, vertices), self.crowd.drawn()] {
            for batch in batches.of_bodies(are_thin) {
                batches.begin(pass, frames, batch);
                pass.set_vertex_buffer(0, vertices.slice(..));
                pass.draw(0..4, batch.instances.clone());
            }
        }
    }
}
