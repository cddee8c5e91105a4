//! Jobs in the background that make files: pictures, films and fits, and pages to print.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use gamow_platform::files::{self, Sent};
use relativity_core::{DEFAULT_REPLICATES, FitError};
use relativity_render::Picture;
use serde::{Deserialize, Serialize};

use super::progress::Reporter;
use crate::app::tools::worker::{StepOutcome, Wanted, Work};
use crate::estimate::data_file::DataFile;
use crate::estimate::samples::FitKey;
use crate::estimate::{FitReport, outliers};
use crate::files::whole::{write_json, write_whole};
use crate::flags::choices::FileKind;
use crate::lesson::class::{self, Collected};
use crate::lesson::worksheet::{self, SheetKind};
use crate::lesson::{Course, Lesson, report};
use crate::number_text;
use crate::scene::{Scene, Track, scene_text};
use crate::settings::{Settings, message};
use crate::studio::Studio;
use crate::studio::film::{FRAMES_PER_SECOND, FilmKind, Stopped, Written};

/// A scene as it is to be drawn.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct SceneSnapshot {
    /// Settings of the picture.
    #[serde(with = "message::all")]
    pub settings: Settings,
    /// Scene in the picture.
    pub scene: Scene,
    /// Point that gazes may follow.
    pub tracked: Track,
}

/// A file to make, or a picture to be copied.
#[derive(Debug, Serialize, Deserialize)]
pub enum SaveJob {
    /// A picture, as a file.
    Picture(SceneSnapshot, PathBuf),
    /// A picture, to be copied.
    Clipboard(SceneSnapshot),
    /// A film of the frames at these T.
    Film(SceneSnapshot, Vec<f64>, FilmKind, PathBuf),
    /// The numbers of a fit, as JSON.
    Fit(Box<FitKey>, PathBuf),
    /// The scene in which the model in the first file rides.
    Scene(PathBuf, PathBuf),
    /// Report of a lesson, whose states build on these settings; with a fit, and the name of the pupil.
    Report(Box<Course>, #[serde(with = "message::all")] Box<Settings>, Option<Box<FitKey>>, String, PathBuf),
    /// The class's page of these lessons, with the answers in the links of a text.
    Class(Vec<Lesson>, String, PathBuf),
    /// A sheet of a lesson, to print.
    Sheet(Box<Lesson>, SheetKind, PathBuf),
}

/// The outcome of a job.
#[derive(Debug, Serialize, Deserialize)]
pub enum SaveOutcome {
    /// A file, and a message about it.
    File(PathBuf, String),
    /// A picture to be copied.
    Picture(Picture),
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

/// The making of a file, in one step.
pub struct SavingStep(Option<SaveJob>);

impl Work for SavingStep {
    const NAME: &'static str = "saving";
    /// Files that only the asking instance of the program has.
    type Base = Sent;
    type Job = SaveJob;
    /// The outcome, and the files that the asking instance is to hand out.
    type Result = (SaveOutcome, Sent);
    type Tools = Reporter;

    fn begin(given: Sent, job: SaveJob) -> Self {
        files::take_in_all(given);
        Self(Some(job))
    }

    fn take_note(reporter: &Reporter, note: &[u8]) {
        reporter.report_note(note);
    }

    fn step(&mut self, reporter: &mut Reporter, wanted: &Wanted) -> StepOutcome<Self::Result> {
        let Some(job) = self.0.take() else { return StepOutcome::Last(None) };
        let path = job.path().to_owned();
        let made = job.made(|written| {
            reporter.report(written);
            wanted.holds()
        });
        StepOutcome::Last(outcome(path, made).map(|made| (made, files::take_undelivered())))
    }
}

/// Returns the outcome of a job whose file is to be at `path`; `None` if it was stopped.
fn outcome(path: PathBuf, made: anyhow::Result<SaveOutcome>) -> Option<SaveOutcome> {
    match made {
        Err(error) if error.is::<Stopped>() => None,
        Err(error) => Some(SaveOutcome::Nothing(path, format!("{error:#}"))),
        Ok(made) => Some(made),
    }
}

/// Returns the outcome of a file at `path`, which was saved.
fn saved(path: PathBuf) -> SaveOutcome {
    let text = format!("Saved {}.", name_of(&path));
    SaveOutcome::File(path, text)
}

impl SaveJob {
    /// Returns the path of its file; empty if it has none.
    fn path(&self) -> &Path {
        match self {
            Self::Picture(_, path)
            | Self::Film(.., path)
            | Self::Fit(_, path)
            | Self::Scene(_, path)
            | Self::Report(.., path)
            | Self::Class(.., path)
            | Self::Sheet(.., path) => path,
            Self::Clipboard(_) => Path::new(""),
        }
    }

    /// Does the job; `goes_on` is called before each frame of a film, with what is written.
    fn made(self, goes_on: impl FnMut(Written) -> bool) -> anyhow::Result<SaveOutcome> {
        match self {
            Self::Picture(drawn, path) => {
                let mut studio = drawn.studio()?;
                let frame = studio.frame(None)?;
                studio.make_file(&frame, FileKind::Png, &path)?;
                Ok(saved(path))
            }
            Self::Clipboard(drawn) => {
                let mut studio = drawn.studio()?;
                let frame = studio.frame(None)?;
                Ok(SaveOutcome::Picture(studio.still(&frame)?.frames.swap_remove(0)))
            }
            Self::Film(drawn, times, kind, path) => {
                let bytes = drawn.studio()?.make_film(&times, kind, &path, goes_on)?;
                let seconds = times.len() as f64 / f64::from(FRAMES_PER_SECOND);
                let size = number_text::bytes(bytes, 2);
                let text =
                    format!("Saved {}: {} frames, {seconds:.1} s, {size}.", name_of(&path), times.len());
                Ok(SaveOutcome::File(path, text))
            }
            Self::Fit(key, path) => {
                let (report, remark) = fitted(&key)?;
                write_whole(&path, |file| write_json(&report, file))?;
                let text = format!("Saved {}.{remark}", name_of(&path));
                Ok(SaveOutcome::File(path, text))
            }
            Self::Scene(model, path) => {
                let text = scene_text(&model, files::folder_of(&path)).map_err(anyhow::Error::msg)?;
                written(path, &text)
            }
            Self::Report(course, base, key, pupil, path) => {
                // Of what cannot be fitted there is no table.
                let fit = key.and_then(|key| fitted(&key).ok()).map(|(report, _)| report.to_string());
                written(path, &report::page(&course, &base, fit.as_deref(), &pupil)?)
            }
            Self::Class(lessons, text, path) => {
                let lessons: Vec<&Lesson> = lessons.iter().collect();
                written(path, &class::page(&lessons, &Collected::from_text(&text), || {})?)
            }
            Self::Sheet(lesson, sheet, path) => written(path, &worksheet::page(&lesson, sheet, || {})?),
        }
    }
}

/// Writes the text at `path`.
fn written(path: PathBuf, text: &str) -> anyhow::Result<SaveOutcome> {
    write_whole(&path, |file| Ok(file.write_all(text.as_bytes())?))?;
    Ok(saved(path))
}

/// The numbers of a fit, and a remark on them.
fn fitted(key: &FitKey) -> anyhow::Result<(FitReport, String)> {
    let samples = key.fittable().map_err(anyhow::Error::msg)?;
    let report = |replicates| -> Result<FitReport, FitError> {
        let mut report = FitReport::new(&samples.observations, &samples.options, replicates, key.setup.seed)?;
        outliers::name_lines(&mut report.outliers, &samples.lines);
        report.data = key.file().and_then(DataFile::treatment);
        report.cause = report.warning.as_ref().and_then(|_| key.cause(&samples, report.fit.rms));
        Ok(report)
    };
    // Where the replicates cannot be fitted, the numbers are those that stand in the tab.
    Ok(match report(DEFAULT_REPLICATES) {
        Ok(report) => (report, String::new()),
        Err(problem) => (report(0)?, format!(" Without a bootstrap: {problem}.")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::tools::worker::sent;
    use crate::flags::choices::Size;
    use crate::lesson::Library;

    fn snapshot(scene: &str) -> SceneSnapshot {
        let mut settings = Settings::default().with_scene(scene.to_owned());
        settings.picture.size = Size([24, 18]);
        let scene = settings.opened_scene().expect("it is a preset");
        let tracked = settings.track(&scene);
        SceneSnapshot { settings, scene, tracked }
    }

    #[test]
    fn a_picture_is_the_same_where_it_was_sent() {
        for scene in ["rods", "wheel", "globe"] {
            let drawn = snapshot(scene);
            let there = sent(&drawn);
            let bytes = |snapshot: SceneSnapshot| {
                let mut studio = snapshot.studio().expect("it can be drawn");
                let frame = studio.frame(None).expect("T is in the domain");
                studio.png(&frame, Path::new("picture.png")).expect("it is drawn")
            };
            assert!(bytes(drawn) == bytes(there), "{scene}");
        }
    }

    #[test]
    fn every_lesson_is_the_same_where_it_was_sent() {
        for lesson in Library::own().all() {
            assert_eq!(sent(lesson.as_ref()), **lesson, "{}", lesson.name);
        }
        let lesson = Library::own().open("rods").expect("it is one of the program's own");
        let course = Course::new(&lesson).expect("it can be worked out");
        assert_eq!(sent(&course), course);
    }

    #[test]
    fn a_file_is_written_and_a_failure_names_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let made = |path: PathBuf| {
            let wanted = Wanted::new(1, std::sync::Arc::new(1.into()), std::sync::Arc::default());
            let mut step = SavingStep::begin(Vec::new(), SaveJob::Picture(snapshot("rods"), path));
            match step.step(&mut Reporter::default(), &wanted) {
                StepOutcome::Last(Some((made, files))) if files.is_empty() => made,
                _ => panic!("nothing was made"),
            }
        };
        let path = folder.path().join("rods.png");
        assert!(matches!(made(path.clone()), SaveOutcome::File(file, _) if file == path));
        assert!(path.is_file());
        let nowhere = folder.path().join("nowhere").join("rods.png");
        assert!(matches!(made(nowhere.clone()), SaveOutcome::Nothing(file, _) if file == nowhere));
    }
}
