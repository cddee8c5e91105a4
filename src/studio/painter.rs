//! What draws for files: the method that the settings choose, on the device it needs.

use anyhow::Context as _;
use relativity_render::{
    Appearance, Geometry, Gpu, HitImage, Method, Picture, PreparedScene, Renderers, View,
};

use crate::flags::choices::{ProjectionChoice, RendererChoice};
use crate::platform::{tell, threads};
use crate::settings::Settings;

/// A method, and the renderers that draw by it.
pub struct Painter {
    renderers: Renderers,
    method: Method,
    /// Rays per pixel of the reference are the square of this.
    samples: u32,
}

impl Painter {
    /// The one that `settings` choose. Where that is automatic and there is no graphics adapter, it says so on standard
    /// error.
    ///
    /// # Errors
    ///
    /// A renderer that cannot be had, or that cannot draw the geometry.
    pub fn new(settings: &Settings) -> anyhow::Result<Self> {
        let is_published = settings.look.geometry == Geometry::Published;
        let has_one_cone = settings.look.geometry == Geometry::OneCone;
        if settings.look.projection == ProjectionChoice::Vr180 {
            return Self::of_vr180(settings);
        }
        let mesh = Method::Mesh { bound_px: settings.quality.bound_px };
        let (method, gpu) = match settings.quality.renderer {
            RendererChoice::Mesh => (mesh, Some(Gpu::headless().context("the mesh renderer")?)),
            RendererChoice::Auto if is_published => {
                (mesh, Some(Gpu::headless().context("the mesh renderer")?))
            }
            _ if is_published => anyhow::bail!(
                "--geometry published is defined point by point: only `--renderer mesh` draws it"
            ),
            RendererChoice::Rays | RendererChoice::Packets if has_one_cone => anyhow::bail!(
                "--geometry one-cone is seen along curved rays: only `--renderer mesh` and `--renderer reference` draw it"
            ),
            RendererChoice::Auto if has_one_cone => match automatic() {
                (Method::Reference, gpu) => (Method::Reference, gpu),
                (_, gpu) => (mesh, gpu),
            },
            RendererChoice::Reference => (Method::Reference, None),
            RendererChoice::Packets => (Method::Packets, None),
            RendererChoice::Rays => (Method::Rays, Some(Gpu::headless().context("the renderer rays")?)),
            RendererChoice::Auto => automatic(),
        };
        Ok(Self { renderers: Renderers::new(gpu), method, samples: settings.picture.samples })
    }

    /// What draws half of the sky.
    fn of_vr180(settings: &Settings) -> anyhow::Result<Self> {
        anyhow::ensure!(
            settings.look.geometry != Geometry::Published,
            "--geometry published is drawn by triangles, and --projection vr180 by rays: there is no picture of both"
        );
        match settings.quality.renderer {
            RendererChoice::Reference => {}
            RendererChoice::Auto => {
                tell::remark(
                    "gamow: drawing with the reference renderer on the CPU, the one that knows vr180",
                );
            }
            RendererChoice::Rays | RendererChoice::Packets | RendererChoice::Mesh => {
                anyhow::bail!("--projection vr180: only `--renderer reference` draws it")
            }
        }
        let samples = settings.picture.samples;
        Ok(Self { renderers: Renderers::new(None), method: Method::Reference, samples })
    }

    /// The choice that leads to this method again.
    #[must_use]
    pub const fn choice(&self) -> RendererChoice {
        match self.method {
            Method::Reference => RendererChoice::Reference,
            Method::Rays => RendererChoice::Rays,
            Method::Packets => RendererChoice::Packets,
            Method::Mesh { .. } => RendererChoice::Mesh,
        }
    }

    /// The picture of `view`.
    ///
    /// # Errors
    ///
    /// A size the device cannot draw, or a device that was lost.
    pub fn picture(
        &mut self,
        scene: &PreparedScene,
        view: &View,
        appearance: &Appearance,
    ) -> anyhow::Result<Picture> {
        Ok(self.renderers.picture(self.method, scene, view, appearance, self.samples)?)
    }

    /// What the centre of every pixel of `view` shows.
    ///
    /// # Errors
    ///
    /// A size the device cannot draw, or a device that was lost.
    pub fn hits(&mut self, scene: &PreparedScene, view: &View) -> anyhow::Result<HitImage> {
        Ok(self.renderers.hits(self.method, scene, view)?)
    }

    /// What it is, for a reader.
    #[must_use]
    pub fn description(&self) -> String {
        let device = self.renderers.gpu().map(Gpu::description).unwrap_or_default();
        match self.method {
            Method::Reference => {
                let (threads, samples) = (threads::count(), self.samples);
                format!("reference, f64 on {threads} threads, {samples}x{samples} rays per pixel")
            }
            Method::Rays => format!("rays, f32 on {device}"),
            Method::Packets => format!("packets, f32 on {} threads", threads::count()),
            Method::Mesh { bound_px } => format!("mesh within {bound_px} px, f32 on {device}"),
        }
    }
}

/// Rays where there is a graphics adapter, else the reference.
fn automatic() -> (Method, Option<Gpu>) {
    match Gpu::headless() {
        Ok(gpu) => (Method::Rays, Some(gpu)),
        Err(error) => {
            tell::remark(format_args!("gamow: drawing with the reference renderer on the CPU: {error}"));
            (Method::Reference, None)
        }
    }
}
