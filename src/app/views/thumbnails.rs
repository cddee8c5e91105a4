//! Small pictures of what lessons and presets show: each is drawn once, by the reference renderer in the
//! background, while somebody looks at them.

use std::collections::HashMap;
use std::sync::Arc;

use eframe::egui::{Context, TextureHandle, TextureOptions};
use relativity_render::Picture;
use serde::{Deserialize, Serialize};

use crate::accuracy::REFERENCE_SAMPLES;
use crate::app::state::State;
use crate::app::tools::image;
use crate::app::tools::worker::{BackgroundWork, StepOutcome, Wanted, Work};
use crate::app::views::reference_steps::{ReferencePicture, ReferenceSteps};
use crate::eye::Eye;
use crate::lesson::Lesson;
use crate::settings::Settings;

/// The look of a thumbnail, which it depends on beside its lesson.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct ThumbnailLook {
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Whether the thumbnail is shown in a light window.
    pub in_light_window: bool,
    /// Eye whose view the thumbnail shows.
    pub eye: Eye,
}

/// The drawing of a thumbnail; there is nothing to draw where its lesson cannot be shown.
pub struct ThumbnailSteps(Option<ReferenceSteps>);

impl Work for ThumbnailSteps {
    const NAME: &'static str = "thumbnail";
    type Base = ();
    /// Settings of the lesson, in TOML, if there are any; and the look.
    type Job = (Option<String>, ThumbnailLook);
    type Result = Option<Picture>;
    type Tools = ();

    fn begin((): (), (settings, look): (Option<String>, ThumbnailLook)) -> Self {
        Self(settings.and_then(|settings| steps(&settings, look)))
    }

    fn step(&mut self, (): &mut (), wanted: &Wanted) -> StepOutcome<Option<Picture>> {
        let Some(steps) = &mut self.0 else { return StepOutcome::Last(Some(None)) };
        steps.step(&mut (), wanted).map(Some)
    }
}

/// The key of a thumbnail: a preset may be called like a lesson.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct ThumbnailKey {
    name: String,
    is_of_a_preset: bool,
    eye: Eye,
    size: [u32; 2],
}

impl ThumbnailKey {
    fn new(lesson: &Lesson, ThumbnailLook { size, eye, .. }: ThumbnailLook) -> Self {
        Self { name: lesson.name.clone(), is_of_a_preset: lesson.is_a_preset(), eye, size }
    }
}

/// A kept thumbnail. In a window that has since changed its theme, it stays until the other is drawn.
struct KeptThumbnail {
    in_light_window: bool,
    texture: Option<TextureHandle>,
}

/// The thumbnails that were drawn, the one that is drawn now, and the one that comes next.
#[derive(Default)]
pub struct Thumbnails {
    worker: Option<BackgroundWork<ThumbnailSteps, (ThumbnailKey, bool)>>,
    kept: HashMap<ThumbnailKey, KeptThumbnail>,
    /// The first that is missing, and whether it is in view.
    missing: Option<(Arc<Lesson>, ThumbnailLook, bool)>,
    /// Number of thumbnails drawn.
    count: usize,
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
        let Some(((key, in_light_window), picture)) = self.worker.as_ref().and_then(BackgroundWork::result)
        else {
            return;
        };
        let texture = picture.map(|Picture { size, rgba }| {
            ctx.load_texture(&key.name, image::of_pixels(size, &rgba), TextureOptions::LINEAR)
        });
        self.kept.insert(key, KeptThumbnail { in_light_window, texture });
        self.count += 1;
    }

    /// Returns the thumbnail of `lesson`, once there is one; until it has this `look` it is noted as missing.
    /// Those in view come first.
    pub fn picture(
        &mut self,
        lesson: &Arc<Lesson>,
        look: ThumbnailLook,
        is_in_view: bool,
    ) -> Option<&TextureHandle> {
        let kept = self.kept.get(&ThumbnailKey::new(lesson, look));
        let is_missing = kept.is_none_or(|kept| kept.in_light_window != look.in_light_window);
        if is_missing && self.missing.as_ref().is_none_or(|(.., other)| is_in_view && !other) {
            self.missing = Some((Arc::clone(lesson), look, is_in_view));
        }
        kept.and_then(|kept| kept.texture.as_ref())
    }

    /// Has the first of those drawn that were noted as missing, unless another is being drawn.
    pub fn go_on(&mut self, ctx: &Context) {
        let missing = self.missing.take();
        let Some((lesson, look, _)) = missing.filter(|_| self.is_settled()) else { return };
        let settings = lesson.settings(0, true, &Settings::default()).ok();
        let settings = settings.map(|settings| settings.to_toml());
        let label = (ThumbnailKey::new(&lesson, look), look.in_light_window);
        let worker = self.worker.get_or_insert_with(|| BackgroundWork::new(ctx, ()));
        worker.request(label, (), (settings, look));
    }
}

/// The drawing of the first step of a lesson, after its reveal; `None` where it cannot be shown.
fn steps(
    settings: &str,
    ThumbnailLook { size, in_light_window, eye }: ThumbnailLook,
) -> Option<ReferenceSteps> {
    let settings = Settings::default().with_toml(settings, "the lesson").ok()?;
    let mut state = State::open(settings).ok()?;
    state.frame.picture_size = size;
    let (view, appearance) = (state.view(eye, size), state.appearance(in_light_window));
    let drawing = ReferencePicture { view, appearance, samples: REFERENCE_SAMPLES };
    Some(ReferenceSteps::begin(state.document.prepared.clone(), drawing))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::Library;

    #[test]
    fn every_lesson_and_preset_has_a_picture_of_its_own_size() {
        let look = ThumbnailLook { size: [22, 13], in_light_window: false, eye: Eye::Left };
        for lesson in Library::own().all() {
            let settings = lesson.settings(0, true, &Settings::default()).expect("they can be");
            let wanted = Wanted::new(1, Arc::new(1.into()), Arc::default());
            let mut steps = ThumbnailSteps::begin((), (Some(settings.to_toml()), look));
            let StepOutcome::Last(Some(Some(picture))) = steps.step(&mut (), &wanted) else {
                panic!("{} cannot be shown", lesson.name)
            };
            assert_eq!(picture.size, look.size, "{}", lesson.name);
            let first = picture.rgba[0];
            assert!(picture.rgba.iter().any(|pixel| *pixel != first), "{} shows nothing", lesson.name);
        }
    }
}
