//! The painter of files: the method that the settings choose, on the device it needs.

use anyhow::Context as _;
use gamow_platform::clock::Instant;
use gamow_platform::{messages, threads};
use relativity_render::{
    Appearance, Geometry, Gpu, HitImage, Method, Picture, PreparedScene, Renderers, View,
};

use crate::accuracy::{Automatic, Choice, Machine, MethodViews};
use crate::flags::choices::{ProjectionChoice, RendererChoice};
use crate::number_text;
use crate::settings::{QualitySettings, Settings};

/// A method, and the renderers that draw by it.
pub struct Painter {
    renderers: Renderers,
    method: Method,
    /// Rays per pixel of the reference are the square of this.
    samples: u32,
    /// Choice of the method, where that is automatic.
    automatic: Option<Choosing>,
    /// Moment at which the painter was made.
    clock: Instant,
}

/// The automatic choice, and its progress.
struct Choosing {
    automatic: Automatic,
    /// Last choice that was made.
    choice: Option<Choice>,
    /// Whether a picture was measured since.
    is_measured: bool,
    /// Whether the choice stays: once the first picture was measured, so that frames of a film look alike.
    is_settled: bool,
}

impl Painter {
    /// The one that `settings` choose. Where that is automatic, [`Self::choose`] decides; and where there is
    /// no graphics adapter for it, it says so on standard error.
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
        let (method, gpu) = match settings.quality.renderer {
            RendererChoice::Auto => return Self::automatic(settings),
            RendererChoice::Mesh => (Method::Mesh, Some(Gpu::headless().context("the mesh renderer")?)),
            _ if is_published => anyhow::bail!(
                "--geometry published is defined point by point: only `--renderer mesh` draws it"
            ),
            RendererChoice::Rays | RendererChoice::Packets if has_one_cone => anyhow::bail!(
                "--geometry one-cone is seen along curved rays: only `--renderer mesh` and `--renderer reference` draw it"
            ),
            RendererChoice::Reference => (Method::Reference, None),
            RendererChoice::Packets => (Method::Packets, None),
            RendererChoice::Rays => (Method::Rays, Some(Gpu::headless().context("the renderer rays")?)),
        };
        Ok(Self::of_method(settings, method, gpu))
    }

    fn of_method(settings: &Settings, method: Method, gpu: Option<Gpu>) -> Self {
        let renderers = Renderers::new(gpu);
        let samples = settings.picture.samples;
        Self { renderers, method, samples, automatic: None, clock: Instant::now() }
    }

    /// The one whose method is chosen later.
    fn automatic(settings: &Settings) -> anyhow::Result<Self> {
        let gpu = match Gpu::headless() {
            Ok(gpu) => Some(gpu),
            Err(error) if settings.look.geometry == Geometry::Published => {
                return Err(error).context("the mesh renderer");
            }
            Err(error) => {
                messages::remark(format_args!("gamow: drawing on the CPU: {error}"));
                None
            }
        };
        let machine = Machine::from_gpu(gpu.as_ref());
        let automatic = Automatic::with_samples(machine, settings.picture.samples);
        let automatic = Some(Choosing { automatic, choice: None, is_measured: false, is_settled: false });
        Ok(Self { automatic, ..Self::of_method(settings, Method::Reference, gpu) })
    }

    /// Returns the painter of half the sky.
    fn of_vr180(settings: &Settings) -> anyhow::Result<Self> {
        anyhow::ensure!(
            settings.look.geometry != Geometry::Published,
            "--geometry published needs the mesh renderer, and --projection vr180 the reference: choose \
                one of the two"
        );
        match settings.quality.renderer {
            RendererChoice::Reference => {}
            RendererChoice::Auto => {
                messages::remark(
                    "gamow: drawing with the reference renderer on the CPU, the one that knows vr180",
                );
            }
            RendererChoice::Rays | RendererChoice::Packets | RendererChoice::Mesh => {
                anyhow::bail!("--projection vr180: only `--renderer reference` draws it")
            }
        }
        Ok(Self::of_method(settings, Method::Reference, None))
    }

    /// Chooses the method for this number of pictures like that of `view` where the choice is automatic: by
    /// the methods' usual costs, and once more when the first picture was measured. Returns the `quality`
    /// that leads to this method again.
    #[must_use]
    pub fn choose(
        &mut self,
        quality: QualitySettings,
        scene: &PreparedScene,
        view: &View,
        pictures: usize,
    ) -> QualitySettings {
        if let Some(choosing) = self.automatic.as_mut().filter(|choosing| !choosing.is_settled) {
            let pixels = pictures as f64 * view.camera.size.map(f64::from).iter().product::<f64>();
            choosing.choice = choosing.automatic.choose(quality.goal, MethodViews { scene, view, pixels });
            choosing.is_settled = choosing.is_measured;
            self.method = choosing.choice.map_or(Method::Reference, |choice| choice.method);
        }
        quality.with_method(self.method)
    }

    /// The picture of `view`.
    ///
    /// # Errors
    ///
    /// A size the device cannot draw, a device that was lost, or work that was given up.
    pub fn picture(
        &mut self,
        scene: &PreparedScene,
        view: &View,
        appearance: &Appearance,
    ) -> anyhow::Result<Picture> {
        let start = Instant::now();
        let picture = self.renderers.picture(self.method, scene, view, appearance, self.samples)?;
        check_whole()?;
        if let Some(Choosing { automatic, is_measured, .. }) = &mut self.automatic {
            let (method, now_ms) = (self.method.of_view(view), self.clock.elapsed_ms());
            let is_due = automatic.costs.is_due(method, view.geometry, now_ms);
            let pixels = picture.rgba.len() as f64;
            let measured = is_due.then(|| (start.elapsed_ms(), pixels));
            *is_measured |= is_due;
            automatic.costs.note(method, view.geometry, measured, now_ms);
        }
        Ok(picture)
    }

    /// Returns the hits at the centre of every pixel of `view`.
    ///
    /// # Errors
    ///
    /// A size the device cannot draw, a device that was lost, or work that was given up.
    pub fn hits(&mut self, scene: &PreparedScene, view: &View) -> anyhow::Result<HitImage> {
        let hits = self.renderers.hits(self.method, scene, view)?;
        check_whole()?;
        Ok(hits)
    }

    /// Returns a description of the painter of `view`, for a reader.
    #[must_use]
    pub fn description(&self, view: &View) -> String {
        let device = self.renderers.gpu().map(Gpu::description).unwrap_or_default();
        let method = match self.method {
            Method::Reference => {
                let (threads, samples) = (threads::count(), self.samples);
                format!("reference, f64 on {threads} threads, {samples}x{samples} rays per pixel")
            }
            Method::Rays => format!("rays, f32 on {device}"),
            Method::Packets => format!("packets, f32 on {} threads", threads::count()),
            Method::Mesh => {
                let error_px = number_text::trimmed(Method::mesh_error_px(view), 3);
                format!("mesh within {error_px} px, f32 on {device}")
            }
        };
        match self.automatic.as_ref().and_then(|choosing| choosing.choice) {
            Some(choice) => format!("{method}; automatic: {choice}"),
            None => method,
        }
    }
}

/// Refuses a picture that was given up before it was whole.
fn check_whole() -> anyhow::Result<()> {
    anyhow::ensure!(relativity_core::threads::goes_on()(), "given up");
    Ok(())
}
