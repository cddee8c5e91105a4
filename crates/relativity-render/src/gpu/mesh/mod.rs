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
//! bodies that nearly touch are nearer to each other than triangles are to their surfaces. And where a group
//! has straight lines of sight though others have none, as a street at rest has beside a rider, the rays draw
//! it, exactly and at a fraction of the cost.

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
use crate::gpu::rays::{self, Bounds, RayRenderer};
use crate::view::group_view::GroupView;
pub use parts::MeshInstance;
use parts::Parts;
use template::Grid;

/// Draws triangles over each body that rays do not draw beside it.
#[derive(Debug)]
pub struct MeshRenderer {
    beside: Beside,
    parts: Parts,
    /// The grids on the device: of models those of the scene drawn last.
    templates: HashMap<Grid, LoadedTemplate>,
    batches: Batches<MeshInstance, Grid>,
}

/// The rays that draw the groups with straight lines of sight among others.
#[derive(Debug)]
struct Beside {
    rays: RayRenderer,
    vertices: wgpu::Buffer,
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
    constant: Some(|key| ("MAP", key.geometry.map_number())),
};

/// Returns the technique that draws a group on `gpu` which `view` is of.
pub fn technique(gpu: &Gpu, view: &GroupView) -> Technique {
    if view.is_straight_among_bent() { rays::technique(gpu) } else { TECHNIQUE }
}

impl MeshRenderer {
    /// A renderer on `gpu`; the rays beside it look for bodies within `bounds`.
    pub fn new(gpu: &Gpu, canvas: &Canvas, bounds: Bounds) -> Self {
        let pipelines = Pipelines::new(TECHNIQUE, canvas.body_layout(gpu));
        let beside =
            Beside { rays: RayRenderer::new(gpu, canvas, bounds), vertices: buffers::vertex_buffer(gpu, 0) };
        Self { beside, parts: Parts::default(), templates: HashMap::new(), batches: Batches::new(pipelines) }
    }
}

impl Drawing for MeshRenderer {
    fn load(&mut self, gpu: &Gpu, vertices: &mut wgpu::Buffer, shot: &Shot<'_>) {
        let Beside { rays, vertices: theirs } = &mut self.beside;
        rays.load_groups(gpu, theirs, shot, GroupView::is_straight_among_bent);
        self.parts.refill(shot, |view| !view.is_straight_among_bent());
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

    fn record_bodies(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        vertices: &wgpu::Buffer,
        frames: &[wgpu::BindGroup],
        are_thin: bool,
    ) {
        for batch in self.batches.of_bodies(are_thin) {
            let template = &self.templates[&batch.template];
            self.batches.begin(pass, frames, batch);
            pass.set_vertex_buffer(0, template.corners.slice(..));
            pass.set_vertex_buffer(1, vertices.slice(..));
            pass.set_index_buffer(template.triangles.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..template.count, 0, batch.instances.clone());
        }
        self.beside.rays.record_bodies(pass, &self.beside.vertices, frames, are_thin);
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
