//! The exact renderer: a ray test per pixel, in the rest frame, on the GPU.
//!
//! Each piece of a body is drawn as a rectangle that surely contains its image (`footprint`); the
//! fragment stage boosts the pixel's line of sight into the rest frame, where rays are straight, and
//! tests it against the body.

mod pieces;

use crate::body::Body;
use crate::buffers::{fill_vertex_buffer, vertex_buffer};
use crate::canvas::Canvas;
use crate::effects::{Effects, number};
use crate::frame::Frame;
use crate::gpu::{Gpu, GpuError};
use crate::kind::Kind;
use crate::pipelines::{Key, Output, Pipelines, Technique};
use crate::placed::PlacedBodies;
use crate::reference::HitImage;
use crate::target::EyeTarget;
use crate::view::{Appearance, Colour, Geometry, View};
pub(crate) use pieces::Piece;
use pieces::{Bounds, Pieces, THIN_PX};

/// Draws exactly what an aperture sees.
///
/// # Accuracy
///
/// `tests/gpu_exact.rs`, against the f64 reference up to gamma = 1000: the body differs at fewer than 0.1 % of
/// covered pixels, all of them within 0.05 px of an outline; D is within 1e-5; hits lie within 2e-6 of
/// the surfaces of bodies about 1 large. Where tubes share a rounded end, the first of them is seen. The
/// same holds at gamma = 1e30.
#[derive(Debug)]
pub struct ExactRenderer {
    canvas: Canvas,
    pipelines: Pipelines,
    bounds: Bounds,
    pieces: Pieces,
    instances: Vec<Piece>,
    draws: Vec<Draw>,
}

/// A range of instances drawn by one pipeline.
type Draw = (Key, std::ops::Range<u32>);

/// Rectangles, and a ray test for each of their pixels.
pub(crate) const TECHNIQUE: Technique = Technique {
    source: Kind::impostor,
    vertex: "rectangle",
    buffers: &[Some(Piece::LAYOUT)],
    primitive: wgpu::PrimitiveState {
        topology: wgpu::PrimitiveTopology::TriangleStrip,
        ..Technique::TRIANGLES
    },
    picture: "picture",
    constant: |key| {
        let is_thin = match key.output {
            Output::Picture { is_thin, .. } => is_thin,
            Output::Hits => false,
        };
        ("THIN", number(is_thin))
    },
};

impl ExactRenderer {
    /// A renderer on `gpu`; pipelines are made when first needed.
    #[must_use]
    pub fn new(gpu: &Gpu) -> Self {
        let canvas = Canvas::new(gpu);
        let picture = if gpu.has_sample_masks() { TECHNIQUE.picture } else { "picture_sample" };
        let pipelines = Pipelines::new(Technique { picture, ..TECHNIQUE }, canvas.body_layout(gpu));
        Self {
            canvas,
            pipelines,
            bounds: Bounds::Tight,
            pieces: Pieces::default(),
            instances: Vec::new(),
            draws: Vec::new(),
        }
    }

    /// A renderer that tests every body at every pixel: the same pictures, and what the bounds are worth.
    #[must_use]
    pub fn brute_force(gpu: &Gpu) -> Self {
        Self { bounds: Bounds::None, ..Self::new(gpu) }
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
        self.pieces.refill(&scene, view, appearance.colour, self.bounds, THIN_PX);
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
        let scene = PlacedBodies::new(bodies);
        self.pieces.refill(&scene, view, Colour::Visible, self.bounds, 0.0);
        let mut vertices = vertex_buffer(gpu, 0);
        self.load(gpu, &mut vertices, view.geometry, |_| Output::Hits);
        let frame = Frame::new(view, &Appearance::default(), &scene.extent);
        let measures =
            self.canvas.measure(gpu, view.camera.size, &frame, |pass| self.record(pass, &vertices))?;
        Ok(measures.hit_image(&crate::scene::PreparedScene::moving(bodies), view))
    }

    /// Loads the pieces and makes the pipelines they need.
    fn load(
        &mut self,
        gpu: &Gpu,
        vertices: &mut wgpu::Buffer,
        geometry: Geometry,
        output: impl Fn(bool) -> Output,
    ) {
        self.instances.clear();
        self.draws.clear();
        for (is_thin, kind, list) in self.pieces.lists() {
            let start = self.instances.len() as u32;
            self.instances.extend_from_slice(list);
            let key = Key { kind, geometry, output: output(is_thin) };
            self.pipelines.prepare(gpu, key);
            self.draws.push((key, start..self.instances.len() as u32));
        }
        fill_vertex_buffer(gpu, vertices, &self.instances);
    }

    fn record(&self, pass: &mut wgpu::RenderPass<'_>, vertices: &wgpu::Buffer) {
        if self.draws.is_empty() {
            return;
        }
        pass.set_vertex_buffer(0, vertices.slice(..));
        for (key, instances) in &self.draws {
            pass.set_pipeline(self.pipelines.get(*key));
            pass.draw(0..4, instances.clone());
        }
    }
}
