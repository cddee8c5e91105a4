//! The mesh renderer: triangles whose corners go through the apparent position.
//!
//! Each body is an instance of a grid over its unit shape, divided as finely as the bound asks for
//! (`division`). Corners lie exactly where the light cone says; between them pictures are off by no more
//! than the bound. Unlike the exact renderer it can draw any map of points, and so the published
//! binocular model, which is defined point by point and has no lines of sight.
//!
//! Which of two bodies is nearer is decided by the pixel's ray where there is one, as in the exact renderer:
//! bodies that nearly touch are nearer to each other than triangles are to their surfaces.

mod division;
mod map;
mod parts;
mod template;

use std::collections::HashMap;
use std::ops::Range;

use crate::body::Body;
use crate::buffers::{self, fill_vertex_buffer, vertex_buffer};
use crate::canvas::Canvas;
use crate::effects::Effects;
use crate::frame::Frame;
use crate::gpu::{Gpu, GpuError};
use crate::kind::Kind;
use crate::pipelines::{Key, Output, Pipelines, Technique};
use crate::placed::PlacedBodies;
use crate::reference::HitImage;
use crate::target::EyeTarget;
use crate::view::{Appearance, Colour, Geometry, View};
use map::Map;
pub(crate) use parts::Instance;
use parts::Parts;
pub(crate) use template::Corner;
use template::Division;

/// Draws triangles that keep a bound on the picture.
#[derive(Debug)]
pub struct MeshRenderer {
    canvas: Canvas,
    pipelines: Pipelines,
    templates: HashMap<Division, Loaded>,
    /// How far any point may be drawn from where it is seen, pixels, above 0.
    pub bound_px: f64,
    parts: Parts,
    instances: Vec<Instance>,
    draws: Vec<Draw>,
}

/// A template on the device.
#[derive(Debug)]
struct Loaded {
    corners: wgpu::Buffer,
    triangles: wgpu::Buffer,
    count: u32,
}

/// Neighbouring parts of one division.
#[derive(Debug)]
struct Draw {
    division: Division,
    key: Key,
    instances: Range<u32>,
}

/// Triangles over each body, their corners where they appear.
pub(crate) const TECHNIQUE: Technique = Technique {
    source: Kind::mesh,
    vertex: "corner",
    buffers: &[Some(Corner::LAYOUT), Some(Instance::LAYOUT)],
    primitive: wgpu::PrimitiveState { cull_mode: Some(wgpu::Face::Back), ..Technique::TRIANGLES },
    picture: "picture",
    constant: |key| ("MAP", key.geometry.map_number()),
};

impl MeshRenderer {
    /// The bound unless another is chosen, pixels.
    pub const DEFAULT_BOUND_PX: f64 = 0.5;

    /// A renderer on `gpu` with the default bound.
    #[must_use]
    pub fn new(gpu: &Gpu) -> Self {
        let canvas = Canvas::new(gpu);
        let pipelines = Pipelines::new(TECHNIQUE, canvas.body_layout(gpu));
        Self {
            canvas,
            pipelines,
            templates: HashMap::new(),
            bound_px: Self::DEFAULT_BOUND_PX,
            parts: Parts::default(),
            instances: Vec::new(),
            draws: Vec::new(),
        }
    }

    /// Draws `bodies` into `target`, whose size overrides the camera's.
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        bodies: &[Body],
        view: &View,
        appearance: &Appearance,
        target: &mut EyeTarget,
    ) {
        let view = &view.with_size(target.size());
        let geometry = view.geometry;
        let effects = Effects::new(geometry.has_doppler_effect(), appearance);
        let scene = PlacedBodies::new(bodies);
        self.parts.refill(&scene, view, appearance.colour, &Map::new(view), self.bound_px, true);
        self.load(gpu, &mut target.vertices, geometry, |is_thin| Output::Picture { is_thin, effects });
        let frame = Frame::new(view, appearance, &scene.extent);
        self.canvas.paint(gpu, target, &frame, appearance, |pass| self.record(pass, &target.vertices));
    }

    /// What the centre of every pixel of `view`'s camera shows, without anti-aliasing.
    ///
    /// # Errors
    ///
    /// The device was lost.
    pub fn hits(&mut self, gpu: &Gpu, bodies: &[Body], view: &View) -> Result<HitImage, GpuError> {
        self.hits_in_part(gpu, bodies, view, view)
    }

    /// What `part`, a magnified view of a small part of `whole`, shows of the triangles that `whole` is drawn with.
    ///
    /// # Errors
    ///
    /// The device was lost.
    pub fn hits_in_part(
        &mut self,
        gpu: &Gpu,
        bodies: &[Body],
        whole: &View,
        part: &View,
    ) -> Result<HitImage, GpuError> {
        let scene = PlacedBodies::new(bodies);
        self.parts.refill(&scene, part, Colour::Visible, &Map::new(whole), self.bound_px, false);
        let mut vertices = vertex_buffer(gpu, 0);
        self.load(gpu, &mut vertices, part.geometry, |_| Output::Hits);
        let frame = Frame::new(part, &Appearance::default(), &scene.extent);
        let measures =
            self.canvas.measure(gpu, part.camera.size, &frame, |pass| self.record(pass, &vertices))?;
        Ok(measures.hit_image(&crate::scene::PreparedScene::moving(bodies), part))
    }

    /// Loads the parts, and makes the pipelines and templates they need.
    fn load(
        &mut self,
        gpu: &Gpu,
        vertices: &mut wgpu::Buffer,
        geometry: Geometry,
        output: impl Fn(bool) -> Output,
    ) {
        self.instances.clear();
        self.draws.clear();
        for run in self.parts.runs() {
            let start = self.instances.len() as u32;
            self.instances.extend(run.iter().map(|part| part.instance));
            let division = run[0].division;
            let key = Key { kind: division.kind(), geometry, output: output(run[0].is_thin()) };
            self.pipelines.prepare(gpu, key);
            self.templates.entry(division).or_insert_with(|| Loaded::new(gpu, division));
            self.draws.push(Draw { division, key, instances: start..self.instances.len() as u32 });
        }
        fill_vertex_buffer(gpu, vertices, &self.instances);
    }

    fn record(&self, pass: &mut wgpu::RenderPass<'_>, instances: &wgpu::Buffer) {
        for draw in &self.draws {
            let template = &self.templates[&draw.division];
            pass.set_pipeline(self.pipelines.get(draw.key));
            pass.set_vertex_buffer(0, template.corners.slice(..));
            pass.set_vertex_buffer(1, instances.slice(..));
            pass.set_index_buffer(template.triangles.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..template.count, 0, draw.instances.clone());
        }
    }
}

impl Loaded {
    fn new(gpu: &Gpu, division: Division) -> Self {
        let template = division.template();
        let (vertex, index) = (wgpu::BufferUsages::VERTEX, wgpu::BufferUsages::INDEX);
        Self {
            corners: buffers::filled(gpu, "corners", vertex, &template.corners),
            triangles: buffers::filled(gpu, "triangles", index, &template.triangles),
            count: template.triangles.len() as u32,
        }
    }
}
