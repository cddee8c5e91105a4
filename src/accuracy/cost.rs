//! The methods that are measured, and how long each takes for a picture.

use gamow_platform::clock::Instant;
use relativity_render::{Appearance, EyeTarget, GpuError, Method, PreparedScene, Renderers, View};

/// Rays per pixel and direction of the reference, so that it takes as many samples as the GPU does.
pub const REFERENCE_SAMPLES: u32 = 2;
/// Frames of one timed run on the GPU, besides the first.
const FRAMES: u32 = 3;
/// Frames that take longer are timed singly, reading back included, which then matters little.
const SLOW_MS: f64 = 100.0;

/// The methods that can be measured with these `renderers`, but for the mesh, which draws what they do not.
#[must_use]
pub fn methods(renderers: &Renderers) -> Vec<Method> {
    let on_gpu = renderers.gpu().map(|_| Method::Rays);
    [Method::Reference, Method::Packets].into_iter().chain(on_gpu).collect()
}

/// Milliseconds that `method` takes for a picture of `view`: the fastest of `rounds` runs.
///
/// On the GPU a run of four frames less a run of one, so that reading back, which a window need not, does not
/// count; frames of over 100 ms are timed singly.
///
/// # Errors
///
/// No GPU where `method` needs one; a device that was lost.
pub fn frame_ms(
    renderers: &mut Renderers,
    method: Method,
    scene: &PreparedScene,
    view: &View,
    appearance: &Appearance,
    rounds: u32,
) -> Result<f64, GpuError> {
    if method.is_on_cpu() {
        return fastest_ms(rounds, || {
            renderers.picture(method, scene, view, appearance, REFERENCE_SAMPLES).map(std::hint::black_box)
        });
    }
    let gpu = renderers.gpu().cloned().ok_or(GpuError::NoAdapter)?;
    let mut target = EyeTarget::new(&gpu, view.camera.size);
    fastest_frame_ms(rounds, |frames| {
        for _ in 0..frames {
            renderers.draw(method, scene, view, appearance, &mut target)?;
        }
        target.rgba8(&gpu).map(drop)
    })
}

/// Returns milliseconds per frame of `draw`, which draws the number of frames that it is given and waits for
/// them.
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
fn fastest_ms<T>(rounds: u32, mut work: impl FnMut() -> Result<T, GpuError>) -> Result<f64, GpuError> {
    let mut fastest = f64::INFINITY;
    for _ in 0..rounds.max(1) {
        let start = Instant::now();
        work()?;
        fastest = fastest.min(start.elapsed_ms());
    }
    Ok(fastest)
}
