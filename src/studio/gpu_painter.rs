//! The renderers on the GPU, with the device and the target they draw on.

use relativity_render::{
    Appearance, Body, ExactRenderer, EyeTarget, Gpu, HitImage, MeshRenderer, Picture, View,
};

use crate::flags::choices::RendererChoice;

/// A renderer on the GPU.
pub enum Drawer {
    /// A ray test per pixel.
    Exact(ExactRenderer),
    /// Triangles.
    Mesh(MeshRenderer),
}

/// A renderer, its device and its target, and the bodies it draws.
pub struct GpuPainter {
    gpu: Gpu,
    drawer: Drawer,
    bodies: Vec<Body>,
    target: Option<EyeTarget>,
}

impl Drawer {
    /// The exact renderer on `gpu`.
    #[must_use]
    pub fn exact(gpu: &Gpu) -> Self {
        Self::Exact(ExactRenderer::new(gpu))
    }
}

impl GpuPainter {
    /// Draws `bodies` on `gpu`.
    #[must_use]
    pub fn new(gpu: Gpu, drawer: Drawer, bodies: &[Body]) -> Self {
        Self { gpu, drawer, bodies: bodies.to_vec(), target: None }
    }

    /// The picture of `view`.
    ///
    /// # Errors
    ///
    /// A size the device cannot draw, or a device that was lost.
    pub fn picture(&mut self, view: &View, appearance: &Appearance) -> anyhow::Result<Picture> {
        let Self { gpu, drawer, bodies, target } = self;
        let size = view.camera.size;
        let target = sized_target(gpu, target, size)?;
        match drawer {
            Drawer::Exact(exact) => exact.draw(gpu, bodies, view, appearance, target),
            Drawer::Mesh(mesh) => mesh.draw(gpu, bodies, view, appearance, target),
        }
        let bytes = target.rgba8(gpu)?;
        let rgba = bytes.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2], pixel[3]]).collect();
        Ok(Picture { size, rgba })
    }

    /// What the centre of every pixel of `view` shows.
    ///
    /// # Errors
    ///
    /// A size the device cannot draw, or a device that was lost.
    pub fn hits(&mut self, view: &View) -> anyhow::Result<HitImage> {
        let Self { gpu, drawer, bodies, target } = self;
        sized_target(gpu, target, view.camera.size)?;
        Ok(match drawer {
            Drawer::Exact(exact) => exact.hits(gpu, bodies, view)?,
            Drawer::Mesh(mesh) => mesh.hits(gpu, bodies, view)?,
        })
    }

    /// The choice that leads to this renderer again.
    #[must_use]
    pub const fn choice(&self) -> RendererChoice {
        match self.drawer {
            Drawer::Exact(_) => RendererChoice::Exact,
            Drawer::Mesh(_) => RendererChoice::Mesh,
        }
    }

    /// What it is, for a reader.
    #[must_use]
    pub fn description(&self) -> String {
        let device = self.gpu.description();
        match &self.drawer {
            Drawer::Exact(_) => format!("exact, f32 on {device}"),
            Drawer::Mesh(mesh) => format!("mesh within {} px, f32 on {device}", mesh.bound_px),
        }
    }
}

/// `target` made to be of `size` pixels; an error if the device cannot draw so large a picture.
fn sized_target<'a>(
    gpu: &Gpu,
    target: &'a mut Option<EyeTarget>,
    size: [u32; 2],
) -> anyhow::Result<&'a mut EyeTarget> {
    if target.as_ref().is_some_and(|target| target.size() != size) {
        *target = None;
    }
    let target = target.get_or_insert_with(|| EyeTarget::new(gpu, size));
    let [width, height] = target.size();
    anyhow::ensure!(
        target.size() == size,
        "{} draws at most {width}x{height} of these pixels; `--renderer reference` has no such limit",
        gpu.description()
    );
    Ok(target)
}
