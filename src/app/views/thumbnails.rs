//! Small pictures of what lessons and presets show: those that ship with the program, and of lessons of the
//! user's own a picture that is drawn once, by the reference renderer in the background, while somebody looks
//! at it.

use std::collections::HashMap;
use std::sync::Arc;

use eframe::egui::{Context, TextureHandle, TextureOptions};
use relativity_render::{Method, Picture};

use crate::accuracy::REFERENCE_SAMPLES;
use crate::app::state::State;
use crate::app::tools::image;
use crate::app::tools::worker::{BackgroundWork, StepOutcome, Wanted, Work};
use crate::app::views::picture_steps::{PictureJob, PictureSteps};
use crate::eye::Eye;
use crate::files::jpeg;
use crate::lesson::{Lesson, card};
use crate::settings::Settings;

/// The drawing of a thumbnail; there is nothing to draw where its lesson cannot be shown.
pub struct ThumbnailSteps(Option<PictureSteps>);

impl Work for ThumbnailSteps {
    const NAME: &'static str = "thumbnail";
    type Base = ();
    /// Settings of the lesson, in TOML, if there are any.
    type Job = Option<String>;
    type Result = Option<Picture>;
    type Tools = ();

    fn begin((): (), settings: Option<String>) -> Self {
        Self(settings.and_then(|settings| steps(&settings)))
    }

    fn step(&mut self, (): &mut (), wanted: &Wanted) -> StepOutcome<Option<Picture>> {
        let Some(steps) = &mut self.0 else { return StepOutcome::Last(Some(None)) };
        steps.step(&mut (), wanted).map(Some)
    }
}

/// The thumbnails that are there, the one that is drawn now, and the one that comes next.
#[derive(Default)]
pub struct Thumbnails {
    worker: Option<BackgroundWork<ThumbnailSteps, ThumbnailKey>>,
    /// The thumbnails by their lessons; none of a lesson that cannot be shown.
    kept: HashMap<ThumbnailKey, Option<TextureHandle>>,
    /// The first that is missing, and whether it is in view.
    missing: Option<(Arc<Lesson>, bool)>,
    /// Number of thumbnails drawn.
    count: usize,
}

/// The key of a thumbnail: the lesson's name, and whether the lesson is the user's own.
type ThumbnailKey = (String, bool);

/// Returns the key of the thumbnail of `lesson`.
fn key(lesson: &Lesson) -> ThumbnailKey {
    (lesson.name.clone(), lesson.path.is_some())
}

impl Thumbnails {
    /// Returns the number of thumbnails drawn since the window opened.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// Whether none is being drawn.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        !self.worker.as_ref().is_some_and(BackgroundWork::is_pending)
    }

    /// Takes in what was drawn.
    pub fn receive(&mut self, ctx: &Context) {
        if let Some((key, picture)) = self.worker.as_ref().and_then(BackgroundWork::result) {
            let texture = picture.map(|Picture { size, rgba }| load(ctx, &key.0, size, &rgba));
            self.kept.insert(key, texture);
            self.count += 1;
        }
    }

    /// Returns the thumbnail of `lesson`, once it is in view or drawn; until then it is noted as missing.
    /// Those in view come first.
    pub fn picture(
        &mut self,
        ctx: &Context,
        lesson: &Arc<Lesson>,
        is_in_view: bool,
    ) -> Option<&TextureHandle> {
        let key = key(lesson);
        if !self.kept.contains_key(&key) {
            match card::shipped(lesson) {
                Some(file) if is_in_view => {
                    let then = ctx.clone();
                    if let Some(bytes) = file.bytes(move || then.request_repaint()) {
                        let decoded = jpeg::decode(bytes, |_| Ok(())).ok();
                        let texture = decoded.map(|(size, rgba)| load(ctx, &key.0, size, &rgba));
                        self.kept.insert(key.clone(), texture);
                    }
                }
                None if self.missing.as_ref().is_none_or(|(_, other)| is_in_view && !other) => {
                    self.missing = Some((Arc::clone(lesson), is_in_view));
                }
                _ => {}
            }
        }
        self.kept.get(&key)?.as_ref()
    }

    /// Has the first of those drawn that were noted as missing, unless another is being drawn.
    pub fn go_on(&mut self, ctx: &Context) {
        let missing = self.missing.take();
        let Some((lesson, _)) = missing.filter(|_| self.is_settled()) else { return };
        let settings = card::settings(&lesson).ok().map(|settings| settings.to_toml());
        let worker = self.worker.get_or_insert_with(|| BackgroundWork::new(ctx, ()));
        worker.request(key(&lesson), (), settings);
    }
}

/// Returns the texture of a thumbnail called `name`.
fn load(ctx: &Context, name: &str, size: [u32; 2], rgba: &[[u8; 4]]) -> TextureHandle {
    ctx.load_texture(name, image::of_pixels(size, rgba), TextureOptions::LINEAR)
}

/// The drawing of a lesson with these settings; `None` where it cannot be shown.
fn steps(settings: &str) -> Option<PictureSteps> {
    let settings = Settings::default().with_toml(settings, "the lesson").ok()?;
    let mut state = State::open(settings).ok()?;
    state.frame.picture.size = card::SIZE;
    let (view, appearance) = (state.view(Eye::Left, card::SIZE), state.appearance(false));
    let drawing = PictureJob { view, appearance, method: Method::Reference, samples: REFERENCE_SAMPLES };
    Some(PictureSteps::begin(state.document.prepared.clone(), drawing))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lesson_of_ones_own_has_a_picture_of_the_size_of_the_others() {
        let text = "---\ntitle: x\n---\n\n## One\n\n```state\nscene = \"globe\"\n```\n\nLook.\n";
        let lesson = Lesson::read("own", text, "own.md").expect("a lesson");
        let settings = card::settings(&lesson).expect("they can be");
        let wanted = Wanted::new(1, Arc::new(1.into()), Arc::default());
        let mut steps = ThumbnailSteps::begin((), Some(settings.to_toml()));
        let StepOutcome::Last(Some(Some(picture))) = steps.step(&mut (), &wanted) else {
            panic!("it cannot be shown")
        };
        assert_eq!(picture.size, card::SIZE);
        let first = picture.rgba[0];
        assert!(picture.rgba.iter().any(|pixel| *pixel != first), "it shows nothing");
    }
}
