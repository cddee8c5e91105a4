//! What draws: the chosen renderer, prepared for one scene.

use anyhow::Context as _;
use relativity_render::{
    Appearance, Body, Geometry, Gpu, HitImage, MeshRenderer, Picture, PreparedScene, View,
};

use super::gpu_painter::{Drawer, GpuPainter};
use crate::flags::choices::RendererChoice;
use crate::platform::threads;
use crate::settings::Settings;

/// A renderer and the scene it draws.
pub enum Painter {
    /// In f64 on the CPU.
    Reference {
        /// The scene.
        scene: PreparedScene,
        /// Rays per pixel are the square of this.
        samples: u32,
    },
    /// On the GPU.
    Gpu(Box<GpuPainter>),
}

/// The renderer to use where none is asked for.
fn usual(geometry: Geometry) -> RendererChoice {
    if geometry == Geometry::Published { RendererChoice::Mesh } else { RendererChoice::Auto }
}

fn gpu_painter(gpu: Gpu, drawer: Drawer, bodies: &[Body]) -> Painter {
    Painter::Gpu(Box::new(GpuPainter::new(gpu, drawer, bodies)))
}

impl Painter {
    /// The renderer that `settings` choose, for `bodies`. Where that is automatic and there is no graphics adapter, it
    /// says so on standard error.
    ///
    /// # Errors
    ///
    /// A renderer that cannot be had, or that cannot draw the published geometry.
    pub fn new(settings: &Settings, bodies: &[Body]) -> anyhow::Result<Self> {
        let samples = settings.picture.samples;
        let reference = || Self::Reference { scene: PreparedScene::moving(bodies), samples };
        let exact = |gpu: Gpu| {
            let drawer = Drawer::exact(&gpu);
            gpu_painter(gpu, drawer, bodies)
        };
        let geometry = settings.look.geometry;
        let asked = settings.quality.renderer;
        let choice = if asked == RendererChoice::Auto { usual(geometry) } else { asked };
        anyhow::ensure!(
            geometry != Geometry::Published || choice == RendererChoice::Mesh,
            "--geometry published is defined point by point: only `--renderer mesh` draws it"
        );
        match choice {
            RendererChoice::Reference => Ok(reference()),
            RendererChoice::Mesh => {
                let gpu = Gpu::headless().context("the mesh renderer")?;
                let mut mesh = MeshRenderer::new(&gpu);
                mesh.bound_px = settings.quality.bound_px;
                Ok(gpu_painter(gpu, Drawer::Mesh(mesh), bodies))
            }
            RendererChoice::Exact => Ok(exact(Gpu::headless().context("the exact renderer")?)),
            RendererChoice::Auto => Ok(Gpu::headless().map_or_else(
                |error| {
                    eprintln!("gamow: drawing with the reference renderer on the CPU: {error}");
                    reference()
                },
                exact,
            )),
        }
    }

    /// The choice that leads to this renderer again.
    #[must_use]
    pub const fn choice(&self) -> RendererChoice {
        match self {
            Self::Reference { .. } => RendererChoice::Reference,
            Self::Gpu(painter) => painter.choice(),
        }
    }
    /// The picture of `view`.
    ///
    /// # Errors
    ///
    /// A size the device cannot draw, or a device that was lost.
    pub fn picture(&mut self, view: &View, appearance: &Appearance) -> anyhow::Result<Picture> {
        match self {
            Self::Reference { scene, samples } => Ok(scene.picture(view, appearance, *samples)),
            Self::Gpu(painter) => painter.picture(view, appearance),
        }
    }

    /// What the centre of every pixel of `view` shows.
    ///
    /// # Errors
    ///
    /// A size the device cannot draw, or a device that was lost.
    pub fn hits(&mut self, view: &View) -> anyhow::Result<HitImage> {
        match self {
            Self::Reference { scene, .. } => Ok(scene.hit_image(view)),
            Self::Gpu(painter) => painter.hits(view),
        }
    }

    /// What it is, for a reader.
    #[must_use]
    pub fn description(&self) -> String {
        match self {
            Self::Reference { samples, .. } => {
                let threads = threads::count();
                format!("reference, f64 on {threads} threads, {samples}x{samples} rays per pixel")
            }
            Self::Gpu(painter) => painter.description(),
        }
    }
}
