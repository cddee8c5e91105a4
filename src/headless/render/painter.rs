//! What draws a view: the chosen renderer, prepared for one scene.

use anyhow::Context as _;
use relativity_render::{
    Appearance, Body, ExactRenderer, EyeTarget, Gpu, HitImage, Picture, ReferenceScene, View,
};

use super::choices::RendererChoice;

/// A renderer and the scene it draws.
pub enum Painter {
    /// In f64 on the CPU.
    Reference {
        /// The scene.
        scene: ReferenceScene,
        /// Rays per pixel are the square of this.
        samples: u32,
    },
    /// On the GPU.
    Exact(Box<ExactPainter>),
}

/// The exact renderer, its device and its target.
pub struct ExactPainter {
    gpu: Gpu,
    renderer: ExactRenderer,
    bodies: Vec<Body>,
    target: Option<EyeTarget>,
}

impl Painter {
    /// The renderer of choice; without one, `exact` where there is a graphics adapter, else `reference`,
    /// and then it says so on standard error.
    ///
    /// # Errors
    ///
    /// A renderer asked for that cannot be had.
    pub fn new(choice: Option<RendererChoice>, bodies: &[Body], samples: u32) -> anyhow::Result<Self> {
        let reference = || Self::Reference { scene: ReferenceScene::new(bodies), samples };
        match choice {
            Some(RendererChoice::Reference) => Ok(reference()),
            Some(RendererChoice::Mesh) => anyhow::bail!("this version has no mesh renderer"),
            Some(RendererChoice::Exact) => {
                let gpu = Gpu::headless().context("--renderer exact needs a graphics adapter")?;
                Ok(Self::exact(gpu, bodies))
            }
            None => Ok(Gpu::headless().map_or_else(
                |error| {
                    eprintln!("gamow: drawing with the reference renderer on the CPU: {error}");
                    reference()
                },
                |gpu| Self::exact(gpu, bodies),
            )),
        }
    }

    fn exact(gpu: Gpu, bodies: &[Body]) -> Self {
        let renderer = ExactRenderer::new(&gpu);
        Self::Exact(Box::new(ExactPainter { gpu, renderer, bodies: bodies.to_vec(), target: None }))
    }

    /// The picture of `view`.
    ///
    /// # Errors
    ///
    /// A size the device cannot draw, or a device that was lost.
    pub fn picture(&mut self, view: &View, appearance: &Appearance) -> anyhow::Result<Picture> {
        match self {
            Self::Reference { scene, samples } => Ok(scene.picture(view, appearance, *samples)),
            Self::Exact(painter) => painter.picture(view, appearance),
        }
    }

    /// What the centre of every pixel of `view` shows.
    ///
    /// # Errors
    ///
    /// A device that was lost.
    pub fn hits(&mut self, view: &View) -> anyhow::Result<HitImage> {
        match self {
            Self::Reference { scene, .. } => Ok(scene.hit_image(view)),
            Self::Exact(painter) => Ok(painter.renderer.hits(&painter.gpu, &painter.bodies, view)?),
        }
    }

    /// The flags that choose this renderer again.
    #[must_use]
    pub fn flags(&self) -> Vec<(&'static str, String)> {
        match self {
            Self::Reference { samples, .. } => {
                vec![("renderer", "reference".to_owned()), ("samples", samples.to_string())]
            }
            Self::Exact(_) => vec![("renderer", "exact".to_owned())],
        }
    }

    /// What it is, for a reader.
    #[must_use]
    pub fn description(&self) -> String {
        match self {
            Self::Reference { samples, .. } => {
                format!(
                    "reference, f64 on {} threads, {samples}x{samples} rays per pixel",
                    rayon::current_num_threads()
                )
            }
            Self::Exact(painter) => format!("exact, f32 on {}", painter.gpu.description()),
        }
    }
}

impl ExactPainter {
    fn picture(&mut self, view: &View, appearance: &Appearance) -> anyhow::Result<Picture> {
        let size = view.camera.size;
        let target = match &mut self.target {
            Some(target) if target.size() == size => target,
            target => target.insert(EyeTarget::new(&self.gpu, size)),
        };
        anyhow::ensure!(
            target.size() == size,
            "{} draws at most {}x{} pixels; `--renderer reference` has no such limit",
            self.gpu.description(),
            target.size()[0],
            target.size()[1]
        );
        self.renderer.draw(&self.gpu, &self.bodies, view, appearance, target);
        let bytes = target.rgba8(&self.gpu)?;
        let rgba = bytes.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2], pixel[3]]).collect();
        Ok(Picture { size, rgba })
    }
}
