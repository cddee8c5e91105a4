//! The renderers of one scene behind one face: what they show, and how long they take.

use std::fmt;
use std::sync::Arc;

use relativity_render::{
    Appearance, Body, ExactRenderer, EyeTarget, Gpu, GpuError, HitImage, MeshRenderer, PreparedScene, View,
};

use crate::platform::clock::Instant;

/// A way to draw a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// A ray test per pixel on the CPU, in f64.
    Reference,
    /// A ray test per pixel on the GPU, in f32.
    Exact,
    /// Triangles on the GPU that keep a bound on the picture.
    Mesh {
        /// How far any point may be drawn from where it is seen, pixels, above 0.
        bound_px: f64,
    },
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reference => f.write_str("reference f64"),
            Self::Exact => f.write_str("exact f32"),
            Self::Mesh { bound_px } => write!(f, "mesh {bound_px} px"),
        }
    }
}

/// Rays per pixel and direction of the reference, so that it takes as many samples as the GPU does.
pub const REFERENCE_SAMPLES: u32 = 2;
/// Frames of one timed run on the GPU, besides the first.
const FRAMES: u32 = 3;
/// Frames that take longer are timed singly, reading back included, which then matters little.
const SLOW_MS: f64 = 100.0;
/// Bounds at which meshes are measured: a fine one, the default, a coarse one.
pub const MESH_BOUNDS_PX: [f64; 3] = [0.1, MeshRenderer::DEFAULT_BOUND_PX, 2.0];

/// Renderers of one scene.
pub struct Renderers {
    bodies: Vec<Body>,
    reference: Arc<PreparedScene>,
    graphics: Option<Graphics>,
}

/// What the GPU's renderers need.
struct Graphics {
    gpu: Gpu,
    exact: ExactRenderer,
    mesh: MeshRenderer,
    target: Option<EyeTarget>,
}

impl Renderers {
    /// Renderers of `bodies`; without a `gpu` only those that need none.
    #[must_use]
    pub fn new(bodies: &[Body], gpu: Option<Gpu>) -> Self {
        let graphics = gpu.map(Graphics::new);
        Self { bodies: bodies.to_vec(), reference: Arc::new(PreparedScene::moving(bodies)), graphics }
    }

    /// Renders these `bodies` from now on.
    pub fn set_bodies(&mut self, bodies: &[Body]) {
        if self.bodies != bodies {
            self.bodies = bodies.to_vec();
            self.reference = Arc::new(PreparedScene::moving(bodies));
        }
    }

    /// The truth.
    #[must_use]
    pub fn reference(&self) -> Arc<PreparedScene> {
        Arc::clone(&self.reference)
    }

    /// What the GPU is, if there is one.
    #[must_use]
    pub fn device(&self) -> Option<String> {
        Some(self.graphics.as_ref()?.gpu.description())
    }

    /// The methods that can be measured here.
    #[must_use]
    pub fn methods(&self) -> Vec<Method> {
        let meshes = MESH_BOUNDS_PX.map(|bound_px| Method::Mesh { bound_px });
        let on_gpu = self.graphics.iter().flat_map(|_| [Method::Exact].into_iter().chain(meshes));
        std::iter::once(Method::Reference).chain(on_gpu).collect()
    }

    /// What the centre of every pixel of `view` shows by `method`.
    ///
    /// # Errors
    ///
    /// No GPU where `method` needs one; a device that was lost.
    pub fn hits(&mut self, method: Method, view: &View) -> Result<HitImage, GpuError> {
        self.hits_in_part(method, view, view)
    }

    /// What `part`, a magnified view of a small part of `whole`, shows of what `method` draws `whole` with.
    ///
    /// # Errors
    ///
    /// As [`Self::hits`].
    pub fn hits_in_part(&mut self, method: Method, whole: &View, part: &View) -> Result<HitImage, GpuError> {
        if method == Method::Reference {
            return Ok(self.reference.hit_image(part));
        }
        let Graphics { gpu, exact, mesh, .. } = self.graphics.as_mut().ok_or(GpuError::NoAdapter)?;
        let Method::Mesh { bound_px } = method else { return exact.hits(gpu, &self.bodies, part) };
        mesh.bound_px = bound_px;
        mesh.hits_in_part(gpu, &self.bodies, whole, part)
    }

    /// Milliseconds that `method` takes for a picture of `view`: the fastest of `rounds` runs.
    ///
    /// On the GPU a run of four frames less a run of one, so that reading back, which a window need not, does not
    /// count; frames of over 100 ms are timed singly.
    ///
    /// # Errors
    ///
    /// As [`Self::hits`].
    pub fn frame_ms(
        &mut self,
        method: Method,
        view: &View,
        appearance: &Appearance,
        rounds: u32,
    ) -> Result<f64, GpuError> {
        if method == Method::Reference {
            return Ok(fastest_ms(rounds, || {
                std::hint::black_box(self.reference.picture(view, appearance, REFERENCE_SAMPLES));
            }));
        }
        let graphics = self.graphics.as_mut().ok_or(GpuError::NoAdapter)?;
        if let Method::Mesh { bound_px } = method {
            graphics.mesh.bound_px = bound_px;
        }
        let is_mesh = method != Method::Exact;
        let Self { bodies, .. } = self;
        fastest_frame_ms(rounds, |frames| graphics.draw(is_mesh, bodies, view, appearance, frames))
    }
}

impl Graphics {
    fn new(gpu: Gpu) -> Self {
        Self { exact: ExactRenderer::new(&gpu), mesh: MeshRenderer::new(&gpu), gpu, target: None }
    }

    /// Draws some frames and waits until they are done.
    fn draw(
        &mut self,
        is_mesh: bool,
        bodies: &[Body],
        view: &View,
        appearance: &Appearance,
        frames: u32,
    ) -> Result<(), GpuError> {
        let size = view.camera.size;
        let Self { gpu, exact, mesh, target } = self;
        drop(target.take_if(|target| target.size() != size));
        let target = target.get_or_insert_with(|| EyeTarget::new(gpu, size));
        for _ in 0..frames {
            if is_mesh {
                mesh.draw(gpu, bodies, view, appearance, target);
            } else {
                exact.draw(gpu, bodies, view, appearance, target);
            }
        }
        target.rgba8(gpu).map(drop)
    }
}

/// Milliseconds per frame of `draw`, which draws as many as it is told and waits for them.
fn fastest_frame_ms(rounds: u32, mut draw: impl FnMut(u32) -> Result<(), GpuError>) -> Result<f64, GpuError> {
    draw(1)?; // makes pipelines and target
    let mut run = |frames| {
        let start = Instant::now();
        draw(frames).map(|()| start.elapsed_ms())
    };
    let mut one = run(1)?.min(run(1)?);
    if one > SLOW_MS {
        return Ok(one);
    }
    let mut all = f64::INFINITY;
    for _ in 0..rounds {
        all = all.min(run(1 + FRAMES)?);
        one = one.min(run(1)?);
    }
    Ok((all - one).max(0.0) / f64::from(FRAMES))
}

/// Milliseconds of the fastest of `rounds` runs of `work`.
fn fastest_ms(rounds: u32, mut work: impl FnMut()) -> f64 {
    let run = |_| {
        let start = Instant::now();
        work();
        start.elapsed_ms()
    };
    (0..rounds.max(1)).map(run).fold(f64::INFINITY, f64::min)
}
