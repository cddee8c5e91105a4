//! The left eye's picture, corrected to what a camera riding along would have taken: made by a thread of its
//! own from the speed that the fit found.

use eframe::egui::{ColorImage, Context, TextureHandle, TextureOptions};
use relativity_core::Speed;
use relativity_render::backdrop::Backdrop;
use relativity_render::rectified_hits::Blank;
use relativity_render::rectify::Rectification;
use relativity_render::{Appearance, Body, Camera, ReferenceScene, View};

use super::worker::{Wanted, Worker};

/// Most pixels of a corrected picture: enough to judge it by, and made in a blink on the CPU.
const MAX_PIXELS: f64 = 200_000.0;
/// How much finer the eye's picture is, along each side: parts of it come out enlarged.
const FINENESS: u32 = 2;
/// How bright what lies outside the eye's picture is, beside the background inside it.
const OUTSIDE: f64 = 0.6;

/// What a corrected picture depends on.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    /// The eye's view, as seen.
    pub view: View,
    /// By which speed it is corrected.
    pub speed: Speed,
    /// Its looks.
    pub appearance: Appearance,
    /// What rides past.
    pub bodies: Vec<Body>,
}

/// The corrected picture that is shown, and the one that is being made.
#[derive(Default)]
pub struct Corrected {
    worker: Option<Worker<Job, ColorImage>>,
    requested: Option<Job>,
    texture: Option<TextureHandle>,
    pending: bool,
}

impl Corrected {
    /// The newest picture, and has the one for `job` made if that is another.
    pub fn picture(&mut self, ctx: &Context, job: Job) -> Option<&TextureHandle> {
        let work = |job: Job, _: &Wanted| Some(picture(&job));
        let worker = self.worker.get_or_insert_with(|| Worker::new(ctx.clone(), work));
        if let Some(image) = worker.result() {
            self.pending = false;
            match &mut self.texture {
                Some(texture) => texture.set(image, TextureOptions::LINEAR),
                none => *none = Some(ctx.load_texture("corrected", image, TextureOptions::LINEAR)),
            }
        }
        if self.requested.as_ref() != Some(&job) {
            worker.request(job.clone());
            self.requested = Some(job);
            self.pending = true;
        }
        self.texture.as_ref()
    }

    /// Whether the newest picture is what was asked for.
    #[must_use]
    pub const fn is_up_to_date(&self) -> bool {
        self.texture.is_some() && !self.pending
    }
}

/// The corrected picture of `job`.
fn picture(job: &Job) -> ColorImage {
    let size = size(job.view.camera.size);
    let camera = Camera { size: size.map(|side| FINENESS * side), ..job.view.camera };
    let view = View { camera, ..job.view };
    let rest = Camera { size, ..Rectification::rest_camera(&camera, &job.speed) };
    let rectification = Rectification::new(view.camera, rest, job.speed);
    let hits = ReferenceScene::new(&job.bodies).hit_image(&view);
    let wavelengths: Vec<f64> = job.bodies.iter().map(|body| body.rest_wavelength_nm).collect();
    let plain = Appearance { sky: false, ground_z: None, ..job.appearance };
    let background = Backdrop::new(&view.camera, &plain).sky(view.camera.gaze.axes().forward);
    let blank = Blank { background, outside: background.map(|part| OUTSIDE * part) };
    let picture = rectification.picture_of_hits(&hits, &wavelengths, &job.appearance, blank);
    let rgb: Vec<u8> = picture.rgba.iter().flat_map(|[r, g, b, _]| [*r, *g, *b]).collect();
    ColorImage::from_rgb(picture.size.map(|side| side as usize), &rgb)
}

/// `size`, scaled down to what is made in time.
fn size(size: [u32; 2]) -> [u32; 2] {
    let pixels = size.map(f64::from).iter().product::<f64>();
    let scale = (MAX_PIXELS / pixels).sqrt().min(1.0);
    size.map(|side| ((f64::from(side) * scale).round() as u32).max(1))
}
