//! Pictures of lessons and presets for their cards. They ship with the program; `examples/cards.rs` makes
//! them.

use anyhow::Context as _;
use gamow_platform::shipped::ShippedFile;
use relativity_render::Picture;

use super::library;
use super::plan::{CardPicture, Lesson};
use crate::flags::choices::{Layout, RendererChoice, Size};
use crate::settings::{PictureSettings, Preset, QualitySettings, Settings};
use crate::studio::Studio;

/// Width and height of a card's picture, pixels.
pub const SIZE: [u32; 2] = [320, 186];

/// Returns the file of the picture of `lesson`, a JPEG; `None` for a lesson of the user's own.
#[must_use]
pub fn shipped(lesson: &Lesson) -> Option<ShippedFile> {
    if lesson.path.is_some() {
        return None;
    }
    library::card(&lesson.name).or_else(|| Preset::named(&lesson.name).map(|preset| preset.card))
}

/// Returns the settings of the picture of `lesson`: the preset or the step that it names, else its first
/// step, after the reveal; as the left eye sees it.
///
/// # Errors
/// A setting that cannot be.
pub fn settings(lesson: &Lesson) -> anyhow::Result<Settings> {
    let settings = match &lesson.card {
        CardPicture::Preset(name) => Preset::named(name).context("it was read")?.settings.clone(),
        CardPicture::Step(step) => lesson.settings(*step, true, &Settings::default())?,
    };
    let picture =
        PictureSettings { size: Size(SIZE), layout: Layout::Left, labels: false, ..settings.picture };
    Ok(Settings { picture, ..settings })
}

/// Draws the picture of `lesson` by this `renderer`, with so many rays per pixel and direction.
///
/// # Errors
/// Those of the studio.
pub fn drawn(lesson: &Lesson, renderer: RendererChoice, samples: u32) -> anyhow::Result<Picture> {
    let settings = settings(lesson)?;
    let mut studio = Studio::new(Settings {
        quality: QualitySettings { renderer, ..settings.quality },
        picture: PictureSettings { samples, ..settings.picture },
        ..settings
    })?;
    let frame = studio.frame(None)?;
    Ok(studio.still(&frame)?.frames.swap_remove(0))
}
