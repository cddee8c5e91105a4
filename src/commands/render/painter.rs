//! What draws: the chosen renderer, prepared for one scene.

use anyhow::Context as _;
use clap::Args;
use relativity_render::{Appearance, Body, Gpu, HitImage, MeshRenderer, Picture, PreparedScene, View};

use super::gpu_painter::{Drawer, GpuPainter};
use crate::flags::{RendererChoice, positive};
use crate::platform::threads;

/// Flags of the renderer.
#[derive(Debug, Clone, Args)]
pub struct RendererArgs {
    /// What draws [default: mesh for --geometry published; else exact where there is a graphics adapter,
    /// else reference]
    #[arg(long, value_enum)]
    renderer: Option<RendererChoice>,
    /// Rays per pixel of the reference renderer: N x N.
    #[arg(
        long,
        default_value_t = 3,
        value_name = "N",
        value_parser = clap::value_parser!(u32).range(1..=16)
    )]
    samples: u32,
    /// How far the mesh renderer may draw a point from where it is seen, pixels.
    #[arg(long, default_value_t = MeshRenderer::DEFAULT_BOUND_PX, value_name = "PX", value_parser = positive)]
    bound_px: f64,
}

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

impl RendererArgs {
    /// The renderer of choice for `bodies`. Without one, `exact` where there is a graphics adapter, else
    /// `reference`, and then it says so on standard error; the `published` geometry takes `mesh`.
    ///
    /// # Errors
    ///
    /// A renderer that cannot be had, or that cannot draw the published geometry.
    pub fn painter(&self, bodies: &[Body], published: bool) -> anyhow::Result<Painter> {
        let reference = || Painter::Reference { scene: PreparedScene::moving(bodies), samples: self.samples };
        let choice = self.renderer.or(published.then_some(RendererChoice::Mesh));
        anyhow::ensure!(
            !published || choice == Some(RendererChoice::Mesh),
            "--geometry published is defined point by point: only `--renderer mesh` draws it"
        );
        match choice {
            Some(RendererChoice::Reference) => Ok(reference()),
            Some(RendererChoice::Mesh) => {
                let gpu = Gpu::headless().context("the mesh renderer")?;
                let mut mesh = MeshRenderer::new(&gpu);
                mesh.bound_px = self.bound_px;
                Ok(gpu_painter(gpu, Drawer::Mesh(mesh), bodies))
            }
            Some(RendererChoice::Exact) => {
                let gpu = Gpu::headless().context("the exact renderer")?;
                Ok(exact(gpu, bodies))
            }
            None => Ok(Gpu::headless().map_or_else(
                |error| {
                    eprintln!("gamow: drawing with the reference renderer on the CPU: {error}");
                    reference()
                },
                |gpu| exact(gpu, bodies),
            )),
        }
    }
}

fn exact(gpu: Gpu, bodies: &[Body]) -> Painter {
    let drawer = Drawer::exact(&gpu);
    gpu_painter(gpu, drawer, bodies)
}

fn gpu_painter(gpu: Gpu, drawer: Drawer, bodies: &[Body]) -> Painter {
    Painter::Gpu(Box::new(GpuPainter::new(gpu, drawer, bodies)))
}

impl Painter {
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

    /// The flags that choose this renderer again.
    #[must_use]
    pub fn flags(&self) -> Vec<(&'static str, String)> {
        match self {
            Self::Reference { samples, .. } => {
                vec![("renderer", "reference".to_owned()), ("samples", samples.to_string())]
            }
            Self::Gpu(painter) => painter.flags(),
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
