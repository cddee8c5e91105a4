//! The mesh renderer: triangles whose corners go through the apparent position.
//!
//! Each body is an instance of a grid over its unit shape, divided as finely as the bound asks for
//! (`division`). Corners lie exactly where the light cone says; between them pictures are off by no more
//! than the bound. Unlike the rays it can draw any map of points, and so the published
//! binocular model, which is defined point by point and has no lines of sight.
//!
//! Which of two bodies is nearer is decided by the pixel's ray where there is one, as by the rays:
//! bodies that nearly touch are nearer to each other than triangles are to their surfaces.

mod copies;
mod division;
mod model;
mod parts;
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
use template::Division;

/// Draws triangles that keep a bound on the picture.
#[derive(Debug)]
pub struct MeshRenderer {
    /// Greatest distance at which any point may be drawn from where it is seen, pixels, above 0.
    bound_px: f64,
    parts: Parts,
    templates: HashMap<Division, LoadedTemplate>,
    /// The divisions of models among these, the last that was drawn last.
    of_models: Vec<Division>,
    batches: Batches<MeshInstance, Division>,
}

/// Greatest number of divided models that are kept, unless more are drawn at once.
const MOST_KEPT: usize = 4;

/// A template on the device.
#[derive(Debug)]
struct LoadedTemplate {
    corners: wgpu::Buffer,
    triangles: wgpu::Buffer,
    count: u32,
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
    /// A renderer on `gpu`; its bound is set before each use.
    pub fn new(gpu: &Gpu, canvas: &Canvas) -> Self {
        let pipelines = Pipelines::new(TECHNIQUE, canvas.body_layout(gpu));
        Self {
            bound_px: f64::INFINITY,
            parts: Parts::default(),
            templates: HashMap::new(),
            of_models: Vec::new(),
            batches: Batches::new(pipelines),
        }
    }

    /// Sets the bound to keep from now on, pixels, above 0.
    pub const fn within(&mut self, bound_px: f64) -> &mut Self {
        self.bound_px = bound_px;
        self
    }
}

impl Drawing for MeshRenderer {
    fn load(&mut self, gpu: &Gpu, vertices: &mut wgpu::Buffer, shot: &Shot<'_>) {
        self.parts.refill(shot, self.bound_px);
        self.batches.refill(gpu, vertices, shot, self.parts.runs());
        for batch in self.batches.iter() {
            let division = batch.template;
            self.templates.entry(division).or_insert_with(|| {
                let template = division.template(shot.scene.models());
                LoadedTemplate::new(gpu, &template)
            });
        }
        self.forget_models();
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

impl MeshRenderer {
    /// Forgets the triangles of models that were not drawn for some time: those of two eyes are kept.
    fn forget_models(&mut self) {
        let divisions = self.batches.iter().map(|batch| batch.template);
        let drawn: Vec<_> = divisions.filter(|division| matches!(division, Division::Model { .. })).collect();
        self.of_models.retain(|division| !drawn.contains(division));
        self.of_models.extend(&drawn);
        let most = MOST_KEPT.max(2 * drawn.len());
        let too_many = self.of_models.len().saturating_sub(most);
        for division in self.of_models.drain(..too_many) {
            self.templates.remove(&division);
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
