//! The renderers of one scene behind one face: what they show, and how long they take.

use std::fmt;
use std::sync::Arc;
use std::time::Instant;

use relativity_render::{
    Appearance, Body, ExactRenderer, EyeTarget, Gpu, GpuError, HitImage, ReferenceScene, View,
};

/// A way to draw a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// A ray test per pixel on the CPU, in f64.
    Reference,
    /// A ray test per pixel on the GPU, in f32.
    Exact,
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Reference => "reference f64",
            Self::Exact => "exact f32",
        })
    }
}

/// Rays per pixel and direction of the reference, so that it takes as many samples as the GPU does.
const REFERENCE_SAMPLES: u32 = 2;
/// Frames of one timed run on the GPU, besides the first.
const FRAMES: u32 = 4;

/// Renderers of one scene.
pub struct Renderers {
    bodies: Vec<Body>,
    reference: Arc<ReferenceScene>,
    graphics: Option<Graphics>,
}

/// What the GPU's renderers need.
struct Graphics {
    gpu: Gpu,
    exact: ExactRenderer,
    target: Option<EyeTarget>,
}

impl Renderers {
    /// Renderers of `bodies`; without a `gpu` only those that need none.
    #[must_use]
    pub fn new(bodies: &[Body], gpu: Option<Gpu>) -> Self {
        let graphics = gpu.map(|gpu| Graphics { exact: ExactRenderer::new(&gpu), gpu, target: None });
        Self { bodies: bodies.to_vec(), reference: Arc::new(ReferenceScene::new(bodies)), graphics }
    }

    /// The truth.
    #[must_use]
    pub fn reference(&self) -> Arc<ReferenceScene> {
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
        let on_gpu = self.graphics.iter().map(|_| Method::Exact);
        std::iter::once(Method::Reference).chain(on_gpu).collect()
    }

    /// What the centre of every pixel of `view` shows by `method`.
    ///
    /// # Errors
    ///
    /// No GPU where `method` needs one; a device that was lost.
    pub fn hits(&mut self, method: Method, view: &View) -> Result<HitImage, GpuError> {
        match method {
            Method::Reference => Ok(self.reference.hit_image(view)),
            Method::Exact => {
                let Graphics { gpu, exact, .. } = self.graphics.as_mut().ok_or(GpuError::NoAdapter)?;
                exact.hits(gpu, &self.bodies, view)
            }
        }
    }

    /// Milliseconds that `method` takes for a picture of `view`: the fastest of `rounds` runs.
    ///
    /// On the GPU a run of five frames less a run of one, so that reading back, which a window need not,
    /// does not count.
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
        match method {
            Method::Reference => Ok(fastest_ms(rounds, || {
                std::hint::black_box(self.reference.picture(view, appearance, REFERENCE_SAMPLES));
            })),
            Method::Exact => {
                let graphics = self.graphics.as_mut().ok_or(GpuError::NoAdapter)?;
                graphics.frame_ms(&self.bodies, view, appearance, rounds)
            }
        }
    }
}

impl Graphics {
    fn frame_ms(
        &mut self,
        bodies: &[Body],
        view: &View,
        appearance: &Appearance,
        rounds: u32,
    ) -> Result<f64, GpuError> {
        self.frames(bodies, view, appearance, 1)?; // makes pipelines and target
        let mut fastest = [f64::INFINITY; 2];
        for _ in 0..rounds {
            for (fastest, frames) in fastest.iter_mut().zip([1, 1 + FRAMES]) {
                let start = Instant::now();
                self.frames(bodies, view, appearance, frames)?;
                *fastest = fastest.min(milliseconds(start));
            }
        }
        let [one, all] = fastest;
        Ok((all - one).max(0.0) / f64::from(FRAMES))
    }

    /// Draws some frames and waits until they are done.
    fn frames(
        &mut self,
        bodies: &[Body],
        view: &View,
        appearance: &Appearance,
        frames: u32,
    ) -> Result<(), GpuError> {
        let size = view.camera.size;
        let Self { gpu, exact, target } = self;
        let outgrown = target.take_if(|target| target.size() != size);
        drop(outgrown);
        let target = target.get_or_insert_with(|| EyeTarget::new(gpu, size));
        for _ in 0..frames {
            exact.draw(gpu, bodies, view, appearance, target);
        }
        target.rgba8(gpu).map(drop)
    }
}

/// Milliseconds of the fastest of `rounds` runs of `work`.
fn fastest_ms(rounds: u32, mut work: impl FnMut()) -> f64 {
    let run = |_| {
        let start = Instant::now();
        work();
        milliseconds(start)
    };
    (0..rounds).map(run).fold(f64::INFINITY, f64::min)
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}
