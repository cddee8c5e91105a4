//! The left eye's picture, corrected to what a camera riding along would have taken: made in the
//! background from the speed that the fit found.

use relativity_core::{Speed, math};
use relativity_render::picture::rectified_hits::Blank;
use relativity_render::picture::rectify::Rectification;
use relativity_render::street::backdrop::Backdrop;
use relativity_render::{Appearance, Camera, Picture, PreparedScene, Projection, Velocity, View};
use serde::{Deserialize, Serialize};

use crate::app::tools::worker::{StepOutcome, Wanted, Work};
use crate::app::views::background_picture::BackgroundPicture;

/// Greatest number of pixels of a corrected picture: enough to judge it by, and drawn in a blink on the CPU.
const MAX_PIXELS: f64 = 200_000.0;
/// Resolution of the eye's picture relative to the corrected one, along each side: parts of it come out
/// enlarged.
const FINENESS: u32 = 2;
/// Brightness outside the eye's picture, relative to the background inside it.
const OUTSIDE: f64 = 0.6;

/// The key of a corrected picture of a scene: everything else that it depends on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CorrectedKey {
    /// The eye's view, as seen.
    pub view: View,
    /// Speed for which the picture is corrected.
    pub speed: Speed,
    /// Appearance of the light.
    pub appearance: Appearance,
}

/// The corrected picture that is shown, and the one that is being made.
pub type Corrected = BackgroundPicture<Correction>;

/// The correction of the left eye's picture of a scene, in one step.
pub struct Correction(PreparedScene, CorrectedKey);

impl Work for Correction {
    const NAME: &'static str = "corrected";
    type Base = PreparedScene;
    type Job = CorrectedKey;
    type Result = Picture;
    type Tools = ();

    fn begin(scene: PreparedScene, job: CorrectedKey) -> Self {
        Self(scene, job)
    }

    fn step(&mut self, (): &mut (), _: &Wanted) -> StepOutcome<Picture> {
        let Self(scene, job) = self;
        StepOutcome::Last(Some(picture(scene, job)))
    }
}

/// The corrected picture of `scene`.
fn picture(scene: &PreparedScene, job: &CorrectedKey) -> Picture {
    let size = size(job.view.camera.size);
    let camera = Camera { size: size.map(|side| FINENESS * side), ..job.view.camera };
    let view = View { camera, ..job.view };
    let velocity = Velocity::forward(job.speed);
    let ground = if camera.projection.is_conformal() { camera } else { across_gaze(&camera) };
    let rest = Camera { size, ..Rectification::rest_camera(&ground, &velocity) };
    let rectification = Rectification::new(view.camera, rest, velocity);
    let hits = scene.hit_image(&view);
    let plain = Appearance { sky: false, ground_z: None, ..job.appearance };
    let background = Backdrop::new(&view.camera, view.geometry, &plain).sky(view.camera.gaze.axes().forward);
    let blank = Blank { background, outside: background.map(|part| OUTSIDE * part) };
    rectification.picture_of_hits(&hits, scene, &job.appearance, blank)
}

/// The camera that has what `camera` has in its middle in its own, as high there, and its picture across the
/// gaze.
fn across_gaze(camera: &Camera) -> Camera {
    // A sheared picture is further from the eye in its middle than on its axis.
    let further = (camera.px_per_radian() / camera.focal_length_px()).sqrt();
    let half_width = math::tan(0.5 * camera.horizontal_fov) / further;
    Camera { projection: Projection::Gaze, horizontal_fov: 2.0 * math::atan(half_width), ..*camera }
}

/// `size`, scaled down to what is made in time.
fn size(size: [u32; 2]) -> [u32; 2] {
    let pixels = size.map(f64::from).iter().product::<f64>();
    let scale = (MAX_PIXELS / pixels).sqrt().min(1.0);
    size.map(|side| ((f64::from(side) * scale).round() as u32).max(1))
}
