//! The moving picture of the start page: the ride through the seasons, drawn as slowly as the machine does it
//! with ease.

use eframe::egui::{Context, Rect, TextureId, Ui};
use gamow_platform::clock::Instant;
use relativity_render::Method;

use crate::accuracy::MethodViews;
use crate::app::state::State;
use crate::app::views::eyes::{EyePictures, Request};
use crate::eye::Eye;
use crate::settings::Preset;

/// Name of the preset whose ride is shown.
const PRESET: &str = "ride-seasons";
/// The rider's clock where the picture begins and ends: from slow enough for green leaves to snow.
const FROM: f64 = 6.0;
const TO: f64 = 206.0;
/// Units of that clock that pass in a second.
const RATE: f64 = 6.0;
/// Part of the ride at its ends in which the picture fades, so that the leap back is not seen.
const FADE: f64 = 0.02;
/// Least time between two pictures, seconds, and in times of what one takes.
const LEAST: f64 = 1.0 / 15.0;
const EASE: f64 = 4.0;
/// Longest that a picture counts as, seconds: the first one has shaders compiled.
const LONGEST: f64 = 0.25;
/// Time from the page's opening to the first picture, seconds: the page itself comes first.
const FIRST: f64 = 0.4;
/// The largest pictures that a GPU draws and that the processor draws, pixels.
const MOST_PIXELS: f32 = 2.0e6;
const MOST_PIXELS_SOFTWARE: f32 = 1.6e5;

/// The moving picture, with its ride.
pub struct StartPicture {
    eyes: EyePictures,
    state: State,
    /// Place on the ride, as a part of it.
    place: f64,
    texture: Option<TextureId>,
    size: [u32; 2],
    /// Number of pictures drawn.
    drawings: u64,
    /// When the last picture was drawn, and when the next is due, seconds.
    drawn: f64,
    due: f64,
}

/// A picture to show, and how dark it is, 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShownStartPicture {
    /// Texture of the picture.
    pub texture: TextureId,
    /// Part by which it is darkened.
    pub dimmed: f32,
}

impl StartPicture {
    /// The picture that `eyes` draw; `None` if its scene cannot be had.
    #[must_use]
    pub fn new(ctx: &Context, eyes: EyePictures) -> Option<Self> {
        let settings = Preset::named(PRESET)?.settings.clone();
        let now = ctx.input(|input| input.time);
        let state = State::open(settings).ok()?;
        Some(Self {
            eyes,
            state,
            place: 0.35,
            texture: None,
            size: [0, 0],
            drawings: 0,
            drawn: now,
            due: now + FIRST,
        })
    }

    /// Returns the picture for `rect`, drawn again when that is due; it does not move where motion is not
    /// wanted and while the window is behind others.
    pub fn picture(&mut self, ui: &Ui, rect: Rect) -> Option<ShownStartPicture> {
        let ctx = ui.ctx();
        // A page has the keyboard only once it was clicked, and gets no frames behind others.
        let is_in_front = |focused| focused || cfg!(not(feature = "desktop"));
        let (now, is_in_front) = ctx.input(|input| (input.time, is_in_front(input.focused)));
        let moves = is_in_front && ui.style().animation_time > 0.0;
        let size = self.fitting(ui, rect);
        let is_outdated = self.texture.is_none() || size != self.size;
        if now >= self.due && (moves || is_outdated) {
            self.draw(ctx, now, size, moves);
        }
        if moves || is_outdated {
            ctx.request_repaint_after_secs((self.due - now).max(0.0) as f32);
        }
        let from_end = self.place.min(1.0 - self.place) / FADE;
        Some(ShownStartPicture { texture: self.texture?, dimmed: 1.0 - from_end.min(1.0) as f32 })
    }

    /// Draws the picture of `size` at the place that the ride has reached.
    fn draw(&mut self, ctx: &Context, now: f64, size: [u32; 2], moves: bool) {
        let step = if moves { (now - self.drawn).min(LONGEST) } else { 0.0 };
        self.place = (self.place + step * RATE / (TO - FROM)).fract();
        self.state.document.time = FROM + self.place * (TO - FROM);
        self.state.frame.picture.size = size;
        let start = Instant::now();
        let request = self.request(size);
        let shown = self.eyes.picture(ctx, Eye::Left.index(), &request);
        // A device that cannot be waited for draws as fast as it can.
        let _ = self.eyes.gpu().wait();
        let took = (1e-3 * start.elapsed_ms()).min(LONGEST);
        self.texture = shown.map(|shown| shown.texture).or(self.texture);
        self.size = size;
        self.drawings += 1;
        self.drawn = now;
        self.due = now + LEAST.max(EASE * took);
    }

    /// Returns the request for the picture, to be drawn by the method that is usual for it.
    fn request(&mut self, size: [u32; 2]) -> Request {
        let state = &self.state;
        let (view, scene) = (state.view(Eye::Left, size), state.document.prepared.clone());
        let pixels = f64::from(size[0]) * f64::from(size[1]);
        self.eyes.begin_frame(true);
        let chosen = self
            .eyes
            .choose(state.document.settings.quality.goal, MethodViews { scene: &scene, view: &view, pixels });
        let (method, at_once) =
            chosen.map_or((Method::Rays, false), |chosen| (chosen.method, chosen.at_once()));
        let method = if at_once || method != Method::Reference { method } else { Method::Rays };
        Request { view, appearance: state.appearance(false), scene, method, at_once, refine: false }
    }

    /// Returns the size of the picture in `rect`, pixels.
    fn fitting(&self, ui: &Ui, rect: Rect) -> [u32; 2] {
        let most = if self.eyes.gpu().is_software() { MOST_PIXELS_SOFTWARE } else { MOST_PIXELS };
        let size = rect.size() * ui.pixels_per_point();
        let size = size * (most / (size.x * size.y).max(1.0)).sqrt().min(1.0);
        let largest = self.eyes.largest_side() as f32;
        [size.x, size.y].map(|side| side.round().clamp(1.0, largest) as u32)
    }

    /// Returns the number of pictures drawn since the page opened.
    #[must_use]
    pub const fn drawings(&self) -> u64 {
        self.drawings
    }

    /// Gives up the picture, as nobody looks.
    pub fn forget(mut self) {
        self.eyes.forget();
    }
}
