//! Pictures of half of the sky for headsets, which know them by the end of their names.

use std::path::{Path, PathBuf};

use crate::flags::choices::{FileKind, Layout, ProjectionChoice, Size};
use crate::settings::{PictureSettings, Settings};

/// Mark that headsets look for before the extension: 180 x 180 degrees, left and right side by side.
const MARK: &str = "_180x180_LR";
/// Default side of each eye's picture, pixels.
const SIDE: u32 = 2048;

/// Whether `settings` ask for such pictures.
fn is_asked_for(settings: &Settings) -> bool {
    settings.look.projection == ProjectionChoice::Vr180
}

/// Returns these settings with the picture that headsets take, where they ask for one: both eyes side by
/// side, square, and nothing else.
///
/// # Errors
/// Another layout, or another shape.
pub fn fitted(mut settings: Settings) -> anyhow::Result<Settings> {
    if !is_asked_for(&settings) {
        return Ok(settings);
    }
    let PictureSettings { size, layout, .. } = settings.picture;
    anyhow::ensure!(
        layout == Layout::SideBySide,
        "--projection vr180: a headset takes both eyes side by side, `--layout side-by-side`"
    );
    let [width, height] = size.0;
    if size == PictureSettings::default().size {
        settings.picture.size = Size([SIDE; 2]);
    } else {
        anyhow::ensure!(width == height, "--size {size}: a vr180 picture is square, like {height}x{height}");
    }
    settings.picture.labels = false;
    Ok(settings)
}

/// Returns the path of a file of `settings` that is requested at `path`: a picture for headsets has a name
/// that they know.
#[must_use]
pub fn named(settings: &Settings, path: &Path) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default();
    let is_picture = FileKind::from_path(path) == Some(FileKind::Png);
    if !is_asked_for(settings) || !is_picture || stem.to_string_lossy().ends_with(MARK) {
        return path.to_owned();
    }
    let mut name = stem.to_owned();
    name.push(MARK);
    name.push(".");
    name.push(path.extension().unwrap_or_default());
    path.with_file_name(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_end_as_headsets_know_them() {
        let mut settings = Settings::default();
        let named = |settings: &Settings, path: &str| named(settings, Path::new(path)).display().to_string();
        assert_eq!(named(&settings, "a/ride.png"), "a/ride.png");
        settings.look.projection = ProjectionChoice::Vr180;
        assert_eq!(named(&settings, "a/ride.png"), "a/ride_180x180_LR.png");
        assert_eq!(named(&settings, "ride.2.PNG"), "ride.2_180x180_LR.PNG");
        assert_eq!(named(&settings, "ride_180x180_LR.png"), "ride_180x180_LR.png");
        assert_eq!(named(&settings, "ride.exr"), "ride.exr");
    }

    #[test]
    fn pictures_are_square_and_both_eyes() {
        let mut settings = Settings::default();
        assert_eq!(fitted(settings.clone()).expect("as usual"), settings);
        settings.look.projection = ProjectionChoice::Vr180;
        let picture = fitted(settings.clone()).expect("it has one").picture;
        assert_eq!((picture.size, picture.labels), (Size([2048, 2048]), false));
        settings.picture.size = Size([64, 48]);
        let error = fitted(settings.clone()).expect_err("it is not square").to_string();
        assert_eq!(error, "--size 64x48: a vr180 picture is square, like 48x48");
        settings.picture = PictureSettings { layout: Layout::Anaglyph, ..PictureSettings::default() };
        assert!(fitted(settings).is_err());
    }
}
