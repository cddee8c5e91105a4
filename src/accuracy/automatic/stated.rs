//! Stated errors of each method, and the methods that there are to choose from.

use relativity_render::{Method, Motion, PreparedScene, View};

/// Error in f32 up to [`MEASURED_GAMMA`], pixels (docs/accuracy.md).
const F32_ERROR_PX: f64 = 0.002;
/// Error in f32 as an angle, radians: it counts where a pixel is small.
const F32_ERROR_RADIANS: f64 = 1e-6;
/// The greatest gamma for which that is measured.
const MEASURED_GAMMA: f64 = 1000.0;
/// Error in f32 from there to [`GROUPS_GAMMA`], pixels: where another body is shown, an outline is no
/// further.
const F32_FAST_ERROR_PX: f64 = 0.05;
/// Greatest gamma up to which f32 distinguishes groups that fly apart.
const GROUPS_GAMMA: f64 = 1e5;

/// Number of triangles from which a model is large: a million of them, near, take the rays longer than the
/// mesh (docs/accuracy.md).
const LARGE_MODEL: usize = 500_000;

/// A method, and what is stated of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StatedMethod {
    /// Method that the error is stated of.
    pub method: Method,
    /// No point is drawn further from where it is seen, pixels.
    pub error_px: f64,
}

/// The methods that draw `view` of `scene`, the most accurate first, with a GPU if it `has_gpu`.
///
/// There is a mesh where no rays are drawn, and of large models: else rays cost less, and are far more
/// accurate.
#[must_use]
pub fn candidates(has_gpu: bool, scene: &PreparedScene, view: &View) -> Vec<StatedMethod> {
    let f32_error_px = f32_error_px(scene, view);
    let is_mesh_of_use = Method::Rays.of_view(view) != Method::Rays || has_large_model(scene);
    let mesh = is_mesh_of_use.then(|| (Method::Mesh, f32_error_px.max(Method::mesh_error_px(view))));
    let exact = [Method::Packets, Method::Rays].map(|method| (method, f32_error_px));
    let all = [(Method::Reference, 0.0)].into_iter().chain(exact).chain(mesh);
    let is_drawn = |method: Method| (has_gpu || method.is_on_cpu()) && method.of_view(view) == method;
    all.filter(|(method, _)| is_drawn(*method))
        .map(|(method, error_px)| StatedMethod { method, error_px })
        .collect()
}

/// Whether `scene` has a model that does not turn, of so many triangles that a GPU may draw them sooner than
/// rays find them.
fn has_large_model(scene: &PreparedScene) -> bool {
    scene.bodies().iter().any(|body| {
        let is_large = body.triangles.as_ref().is_some_and(|triangles| triangles.count() >= LARGE_MODEL);
        is_large && body.spin.is_none()
    })
}

/// Returns the stated error in f32, pixels; infinity where bodies may be mistaken for others.
fn f32_error_px(scene: &PreparedScene, view: &View) -> f64 {
    let gamma = |motion: &Motion| match motion {
        Motion::Scene => view.speed.gamma(),
        Motion::Own(velocity) => velocity.speed.gamma(),
        Motion::WithEyes => 1.0,
    };
    let fastest = scene.groups().iter().map(|group| gamma(&group.motion)).fold(1.0, f64::max);
    let is_one = scene.groups().iter().filter(|group| !group.bodies.is_empty()).count() <= 1;
    let by_angle = F32_ERROR_RADIANS * view.camera.px_per_radian();
    by_angle.max(if fastest <= MEASURED_GAMMA {
        F32_ERROR_PX
    } else if fastest <= GROUPS_GAMMA || is_one {
        F32_FAST_ERROR_PX
    } else {
        f64::INFINITY
    })
}
