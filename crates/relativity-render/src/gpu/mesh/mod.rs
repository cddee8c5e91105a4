//! The mesh renderer: triangles whose corners go through the apparent position.
//!
//! It draws any map of points, and so what has no straight lines of sight: the published binocular model,
//! which is defined point by point, and one light cone for both eyes. Each body is an instance of a grid over
//! its unit shape ([`template`]), as fine as the body is large in the picture ([`size`]), which the shader
//! spaces along the body by the rapidity at which it is seen. Corners lie exactly where the light cone says;
//! between them the picture is off by what [`Method::MESH_ERROR_PX`](crate::renderers::Method::MESH_ERROR_PX)
//! states.
//!
//! Which of two bodies is nearer is decided by the pixel's ray where there is one, as by the rays:
//! bodies that nearly touch are nearer to each other than triangles are to their surfaces.

mod model;
mod parts;
mod size;
mod template;

use std::collections::HashMap;

use crate::geometry::corners::{Corner, Template};
use crate::geometry::kind::Kind;
use crate::gpu::buffers;
use crate::gpu::canvas::Canvas;
use crate::gpu::device::Gpu;
use crate::gpu::drawing::{Batches, Drawing, Shot};
use crate::gpu::pipelines::{Pipelines, Technique};
pub use parts::MeshInstance;
use parts::Parts;
use template::Grid;

/// Draws triangles over each body.
#[derive(Debug)]
pub struct MeshRenderer {
    parts: Parts,
    /// The grids on the device: of models those of the scene drawn last.
    templates: HashMap<Grid, LoadedTemplate>,
    batches: Batches<MeshInstance, Grid>,
}

/// A template on the device.
#[derive(Debug)]
struct LoadedTemplate {
    corners: wgpu::Buffer,
    triangles: wgpu::Buffer,
    count: u32,
}

impl Corner {
    /// Layout in which the vertex stage reads a corner.
    pub const LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
        array_stride: size_of::<Self>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32x2],
    };
}

/// Triangles over each body, their corners where they appear.
pub const TECHNIQUE: Technique = Technique {
    source: Kind::mesh,
    vertex: "corner",
    buffers: &[Some(Corner::LAYOUT), Some(MeshInstance::LAYOUT)],
    primitive: wgpu::PrimitiveState { cull_mode: Some(wgpu::Face::Back), ..Technique::TRIANGLES },
    picture: "picture",
    constant: Some(|key| ("MAP", key.geometry.map_number())),
};

impl MeshRenderer {
    /// A renderer on `gpu`.
    pub fn new(gpu: &Gpu, canvas: &Canvas) -> Self {
        let pipelines = Pipelines::new(TECHNIQUE, canvas.body_layout(gpu));
        Self { parts: Parts::default(), templates: HashMap::new(), batches: Batches::new(pipelines) }
    }
}

impl Drawing for MeshRenderer {
    fn load(&mut self, gpu: &Gpu, vertices: &mut wgpu::Buffer, shot: &Shot<'_>) {
        self.parts.refill(shot);
        self.batches.refill(gpu, vertices, shot, self.parts.runs());
        self.templates.retain(|grid, _| match grid {
            Grid::Shape(..) => true,
            Grid::Model(fingerprint) => shot.scene.models().any(|model| model.fingerprint() == *fingerprint),
        });
        for batch in self.batches.iter() {
            let grid = batch.template;
            self.templates
                .entry(grid)
                .or_insert_with(|| LoadedTemplate::new(gpu, &grid.template(shot.scene.models())));
        }
    }

    fn record(&self, pass: &mut wgpu::RenderPass<'_>, vertices: &wgpu::Buffer, frames: &[wgpu::BindGroup]) {
        for batch in self.batches.iter() {
            let template = &self.templates[&batch.template];
            self.batches.begin(pass, frames, batch);
            pass.set_vertex_buffer(0, template.corners.slice(..));
            pass.set_vertex_buffer(1, vertices.slice(..));
            pass.set_index_buffer(template.triangles.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..template.count, 0, batch.instances.clone());
        }
    }
}

impl LoadedTemplate {
    fn new(gpu: &Gpu, template: &Template) -> Self {
        let (vertex, index) = (wgpu::BufferUsages::VERTEX, wgpu::BufferUsages::INDEX);
        Self {
            corners: buffers::filled(gpu, "corners", vertex, &template.corners),
            triangles: buffers::filled(gpu, "triangles", index, &template.triangles),
            count: template.triangles.len() as u32,
        }
    }
}
