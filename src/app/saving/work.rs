//! Jobs of the thread that saves: pictures, films and fits.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use eframe::egui::ColorImage;
use relativity_core::DEFAULT_REPLICATES;

use crate::estimate::FitReport;
use crate::estimate::samples::{FitKey, Fittable};
use crate::files::whole::{write_json, write_whole};
use crate::flags::choices::FileKind;
use crate::flags::words::Shell;
use crate::lesson::worksheet::{self, Sheet};
use crate::lesson::{Course, Lesson, report};
use crate::number_text;
use crate::platform::files;
use crate::scene::{Scene, Track, scene_text};
use crate::settings::Settings;
use crate::studio::Studio;
use crate::studio::film::{FRAMES_PER_SECOND, FilmKind, Stopped, Written};

/// A scene as it is to be drawn.
#[derive(Debug, Clone)]
pub struct SceneSnapshot {
    /// Settings of the picture.
    pub settings: Settings,
    /// Scene in the picture.
    pub scene: Scene,
    /// Point that gazes may follow.
    pub tracked: Track,
}

/// A job of the thread that saves.
pub enum Job {
    /// A picture, as a file.
    Picture(SceneSnapshot, PathBuf),
    /// A picture, to be copied.
    Clipboard(SceneSnapshot),
    /// A film of the frames at these T.
    Film(SceneSnapshot, Vec<f64>, FilmKind, PathBuf),
    /// The scene in which the model in the first file rides.
    Scene(PathBuf, PathBuf),
    /// The numbers of a fit, as JSON.
    Fit(Box<FitKey>, PathBuf),
    /// Report of a lesson, whose states build on these settings; with a fit.
    Report(Box<Course>, Box<Settings>, Option<Box<FitKey>>, PathBuf),
    /// A sheet of a lesson, to print.
    Sheet(Box<Lesson>, Sheet, PathBuf),
}

/// The outcome of a job.
pub enum Made {
    /// A file, and a message about it.
    File(PathBuf, String),
    /// A film, a message about it, and a command that makes an MP4 of it.
    Film(PathBuf, String, String),
    /// A picture to be copied.
    Picture(ColorImage),
    /// No file there, and why.
    Nothing(PathBuf, String),
}

/// The name of the file at `path`, without its folder.
pub fn name_of(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

impl SceneSnapshot {
    fn studio(self) -> anyhow::Result<Studio> {
        Studio::of_scene(self.settings, self.scene, self.tracked)
    }
}

impl Job {
    /// Does the job; `goes_on` is called before each frame of a film, with what is written. `None` if it was stopped.
    pub fn made(self, goes_on: impl FnMut(Written) -> bool) -> Option<Made> {
        let path = self.path().to_owned();
        match self.try_made(goes_on) {
            Err(error) if error.is::<Stopped>() => None,
            Err(error) => Some(Made::Nothing(path, format!("{error:#}"))),
            Ok(made) => Some(made),
        }
    }

    /// Returns the path of its file; empty if it has none.
    fn path(&self) -> &Path {
        match self {
            Self::Picture(_, path)
            | Self::Film(.., path)
            | Self::Scene(_, path)
            | Self::Fit(_, path)
            | Self::Report(.., path)
            | Self::Sheet(.., path) => path,
            Self::Clipboard(_) => Path::new(""),
        }
    }

    fn try_made(self, goes_on: impl FnMut(Written) -> bool) -> anyhow::Result<Made> {
        match self {
            Self::Picture(drawn, path) => {
                let mut studio = drawn.studio()?;
                let frame = studio.frame(None)?;
                studio.make_file(&frame, FileKind::Png, &path)?;
                let text = format!("Saved {}.", name_of(&path));
                Ok(Made::File(path, text))
            }
            Self::Clipboard(drawn) => {
                let mut studio = drawn.studio()?;
                let frame = studio.frame(None)?;
                let picture = studio.still(&frame)?.frames.swap_remove(0);
                let size = picture.size.map(|side| side as usize);
                let pixels = picture.rgba.as_flattened();
                Ok(Made::Picture(ColorImage::from_rgba_unmultiplied(size, pixels)))
            }
            Self::Film(drawn, times, kind, path) => {
                let bytes = drawn.studio()?.make_film(&times, kind, &path, goes_on)?;
                let seconds = times.len() as f64 / f64::from(FRAMES_PER_SECOND);
                let size = number_text::bytes(bytes, 2);
                let text =
                    format!("Saved {}: {} frames, {seconds:.1} s, {size}.", name_of(&path), times.len());
                let command = kind.mp4_command(&path, Shell::here());
                Ok(Made::Film(path, text, command))
            }
            Self::Scene(model, path) => {
                let text = scene_text(&model, files::folder_of(&path)).map_err(anyhow::Error::msg)?;
                write_whole(&path, |file| Ok(file.write_all(text.as_bytes())?))?;
                let text = format!("Saved {}.", name_of(&path));
                Ok(Made::File(path, text))
            }
            Self::Report(course, base, key, path) => {
                // Of what cannot be fitted there is no table.
                let fit = key.and_then(|key| fitted(&key).ok()).map(|(report, _)| report.to_string());
                let page = report::page(&course, &base, fit.as_deref())?;
                write_whole(&path, |file| Ok(file.write_all(page.as_bytes())?))?;
                let text = format!("Saved {}.", name_of(&path));
                Ok(Made::File(path, text))
            }
            Self::Sheet(lesson, sheet, path) => {
                let page = worksheet::page(&lesson, sheet)?;
                write_whole(&path, |file| Ok(file.write_all(page.as_bytes())?))?;
                let text = format!("Saved {}.", name_of(&path));
                Ok(Made::File(path, text))
            }
            Self::Fit(key, path) => {
                let (report, remark) = fitted(&key)?;
                write_whole(&path, |file| write_json(&report, file))?;
                let text = format!("Saved {}.{remark}", name_of(&path));
                Ok(Made::File(path, text))
            }
        }
    }
}

/// The numbers of a fit, and a remark on them.
fn fitted(key: &FitKey) -> anyhow::Result<(FitReport, String)> {
    let Fittable { observations, options } = key.fittable().map_err(anyhow::Error::msg)?;
    let report = |replicates| FitReport::new(&observations, &options, replicates, key.setup.seed);
    // Where the replicates cannot be fitted, the numbers are those that stand in the tab.
    Ok(match report(DEFAULT_REPLICATES) {
        Ok(report) => (report, String::new()),
        Err(problem) => (report(0)?, format!(" Without a bootstrap: {problem}.")),
    })
}
