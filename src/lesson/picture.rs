//! Pictures of a lesson's states, for pages.

use crate::files::html::data_uri;
use crate::flags::OnOff;
use crate::flags::choices::{Layout, RendererChoice, Size};
use crate::settings::{Daylight, LightSettings, PictureSettings, QualitySettings, Settings};
use crate::studio::Studio;

/// Width and height of an eye's picture on a page, pixels.
pub const SIZE: [u32; 2] = [480, 360];
/// Rays per pixel, each way.
const SAMPLES: u32 = 2;

/// Returns the picture of both eyes with these `settings`, side by side and by day, as an element of a page;
/// `what` describes it to readers who do not see it.
///
/// # Errors
/// Those of the studio.
pub fn figure(settings: &Settings, what: &str) -> anyhow::Result<String> {
    let labels: OnOff = true;
    let settings = Settings {
        quality: QualitySettings { renderer: RendererChoice::Reference, ..settings.quality },
        picture: PictureSettings {
            size: Size(SIZE),
            layout: Layout::SideBySide,
            samples: SAMPLES,
            labels,
            ..settings.picture
        },
        light: LightSettings { light: Daylight::On, ..settings.light },
        ..settings.clone()
    };
    let mut studio = Studio::new(settings)?;
    let frame = studio.frame(None)?;
    let mut png = Vec::new();
    studio.still(&frame)?.write(&[], &mut png)?;
    let alt = crate::markup::escaped(what);
    Ok(format!("<img alt=\"{alt}\" src=\"{}\">\n", data_uri("image/png", &png)))
}
