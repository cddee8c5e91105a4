//! The exact renderer: a ray test per pixel, in the rest frame, on the GPU.
//!
//! Each piece of a body is drawn as a rectangle that surely contains its image (`footprint`); the
//! fragment stage boosts the pixel's line of sight into the rest frame, where rays are straight, and
//! tests it against the body.

mod footprint;
mod pieces;
mod pipelines;

use crate::body::Body;
use crate::canvas::{self, Canvas};
use crate::effects::Effects;
use crate::frame::{Extent, Frame};
use crate::gpu::{Gpu, GpuError};
use crate::reference::HitImage;
use crate::target::EyeTarget;
use crate::view::{Appearance, Colour, View};
pub(crate) use footprint::Projection;
pub(crate) use pieces::Instance;
use pieces::{Bounds, Pieces, THIN_PX};
use pipelines::{Key, Pipelines};

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
}

/// A range of instances drawn by one pipeline.
type Draw = (Key, std::ops::Range<u32>);

impl ExactRenderer {
    /// A renderer on `gpu`; pipelines are made when first needed.
    #[must_use]
    pub fn new(gpu: &Gpu) -> Self {
        let canvas = Canvas::new(gpu);
        let pipelines = Pipelines::new(gpu, canvas.body_layout(gpu));
        Self { canvas, pipelines, bounds: Bounds::Tight }
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
        let extent = Extent::new(bodies, view.rest_origin());
        let pieces = Pieces::new(bodies, view, appearance.colour, &extent, self.bounds, THIN_PX);
        let draws = self.load(gpu, &pieces, &mut target.vertices, |shape, thin| Key::Picture {
            shape,
            thin,
            geometry,
            effects,
        });
        let frame = Frame::new(view, appearance, &extent);
        self.canvas.paint(gpu, target, &frame, appearance, |pass| {
            self.record(pass, &target.vertices, &draws);
        });
    }

    /// What the centre of every pixel of `view`'s camera shows, without anti-aliasing.
    ///
    /// # Errors
    ///
    /// The device was lost.
    pub fn hits(&mut self, gpu: &Gpu, bodies: &[Body], view: &View) -> Result<HitImage, GpuError> {
        let extent = Extent::new(bodies, view.rest_origin());
        let pieces = Pieces::new(bodies, view, Colour::Visible, &extent, self.bounds, 0.0);
        let mut vertices = canvas::vertex_buffer(gpu, 0);
        let draws =
            self.load(gpu, &pieces, &mut vertices, |shape, _| Key::Hits { shape, geometry: view.geometry });
        let frame = Frame::new(view, &Appearance::default(), &extent);
        let measures = self.canvas.measure(gpu, view.camera.size, &frame, |pass| {
            self.record(pass, &vertices, &draws);
        })?;
        Ok(measures.hit_image(&crate::scene::PreparedScene::moving(bodies), view))
    }

    /// Loads the pieces and makes the pipelines they need.
    fn load(
        &mut self,
        gpu: &Gpu,
        pieces: &Pieces,
        vertices: &mut wgpu::Buffer,
        key: impl Fn(usize, bool) -> Key,
    ) -> Vec<Draw> {
        let mut instances = Vec::new();
        let mut draws = Vec::new();
        for (thin, lists) in [(false, &pieces.solid), (true, &pieces.thin)] {
            for (shape, list) in lists.iter().enumerate().filter(|(_, list)| !list.is_empty()) {
                let start = instances.len() as u32;
                instances.extend_from_slice(list);
                draws.push((key(shape, thin), start..instances.len() as u32));
            }
        }
        canvas::fill_vertex_buffer(gpu, vertices, &instances);
        for (key, _) in &draws {
            self.pipelines.prepare(gpu, *key);
        }
        draws
    }

    fn record(&self, pass: &mut wgpu::RenderPass<'_>, vertices: &wgpu::Buffer, draws: &[Draw]) {
        if draws.is_empty() {
            return;
        }
        pass.set_vertex_buffer(0, vertices.slice(..));
        for (key, instances) in draws {
            pass.set_pipeline(self.pipelines.get(*key));
            pass.draw(0..4, instances.clone());
        }
    }
}
