//! Files that are shown: opened, and read again when they change.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use gamow_platform::files;

use crate::app::commands::class::answers_in;
use crate::app::state::State;
use crate::app::state::document::report;
use crate::app::state::files::purpose::Purpose;
use crate::app::state::files::reader::{Contents, Errand, ReadFile, ReadyScene, Use};
use crate::app::state::notice::Notice;
use crate::app::state::orders::{Copied, Order, Saving};
use crate::flags::choices::FileKind;
use crate::settings::{PlotTab, Settings, is_link};

/// A command about files and the clipboard.
#[derive(Debug, Clone, PartialEq)]
pub enum FileCommand {
    /// Shows what is in a file: a scene, settings, or a picture with which settings it was made.
    Open(PathBuf),
    /// Fits the measured disparities in a file.
    OpenData(PathBuf),
    /// Leaves a reading of the file that is fitted out, or takes it back.
    LeaveOut {
        /// Number of the reading's sample, from 0.
        sample: usize,
        /// Number of the reading's curve: 0 for dphi, 1 for dtheta.
        curve: usize,
    },
    /// Fits simulated disparities again.
    Simulate,
    /// Shows the present contents of a file that is shown.
    Reload(PathBuf),
    /// Shows a file that was read.
    Show(Box<ReadFile>),
    /// Gives up the file that is being read.
    StopReading,
    /// Asks which file to open or to write.
    Choose(Purpose),
    /// Writes a file.
    Save(Saving),
    /// Copies something to the clipboard.
    Copy(Copied),
    /// Gives up what is being saved.
    StopSaving,
}

impl State {
    /// Performs a command about files.
    pub(super) fn perform_file(&mut self, command: FileCommand) {
        match command {
            FileCommand::Open(ref path) if let Some(token) = answers_in(path) => {
                self.scratch.chooser = None;
                self.follow_answers(token);
            }
            FileCommand::Open(_) | FileCommand::OpenData(_) | FileCommand::Reload(_) => {
                // Nothing else is waiting, as without a window.
                if let Some(errand) = self.errand(&command) {
                    self.show_file(errand.read());
                }
            }
            FileCommand::LeaveOut { sample, curve } => {
                let baseline = self.document.settings.baseline();
                if let Some(file) = &mut self.session.data {
                    Arc::make_mut(file).leave_out_or_take_back(sample, curve, baseline);
                }
            }
            FileCommand::Simulate => self.session.data = None,
            FileCommand::Show(file) => self.show_file(*file),
            // Who reads gives up.
            FileCommand::StopReading => {}
            FileCommand::Choose(purpose) => self.scratch.chooser = Some(purpose),
            FileCommand::Save(saving) => {
                self.scratch.chooser = None;
                self.session.orders.push(Order::Save(saving));
            }
            FileCommand::Copy(copied) => self.session.orders.push(Order::Copy(copied)),
            FileCommand::StopSaving => self.session.orders.push(Order::Stop),
        }
    }

    /// The files that are shown, which are read again when they change: those of the scene, of
    /// the settings and of the lesson.
    #[must_use]
    pub fn shown_files(&self) -> Vec<PathBuf> {
        let scene = self.scene_file().map(Path::to_owned);
        let lesson = self.course().and_then(|course| course.lesson().path.clone());
        self.document.opened.clone().into_iter().chain(scene).chain(lesson).collect()
    }

    /// The file that has to be read before `command` can be done.
    #[must_use]
    pub fn errand(&self, command: &FileCommand) -> Option<Errand> {
        let (path, purpose) = match command {
            FileCommand::Open(path) if answers_in(path).is_some() => return None,
            FileCommand::Open(path) => (path, Use::Show),
            FileCommand::OpenData(path) => (path, Use::Fit),
            FileCommand::Reload(path) if self.scene_file() == Some(path) => (path, Use::RenewScene),
            FileCommand::Reload(path) if self.document.opened.as_ref() == Some(path) => {
                (path, Use::RenewSettings)
            }
            FileCommand::Reload(path) => (path, Use::RenewLesson),
            _ => return None,
        };
        let settings = Settings::clone(&self.document.settings);
        Some(Errand { path: path.clone(), purpose, settings, library: self.library() })
    }

    /// Whether `command` is about the scene's file, which has changed.
    pub(super) fn renews_the_scene(&self, command: &FileCommand) -> bool {
        match command {
            FileCommand::Show(file) => file.purpose == Use::RenewScene,
            command => self.errand(command).is_some_and(|errand| errand.purpose == Use::RenewScene),
        }
    }

    /// Shows a file that was read. An error becomes a notice, and the picture stays as it is.
    fn show_file(&mut self, file: ReadFile) {
        let ReadFile { path, purpose, contents } = file;
        if !self.still_shows(&path, purpose) {
            return;
        }
        self.scratch.chooser = None;
        if purpose != Use::Fit {
            self.scratch.notice = None;
        }
        match contents {
            Ok(Contents::Settings { settings, scene, .. }) if purpose == Use::RenewSettings => {
                self.show_again(*settings, *scene, path);
            }
            Ok(Contents::Settings { settings, scene, is_scene }) => {
                self.show_in(*settings, *scene);
                if is_link(&path) {
                    return;
                }
                self.session.recent.add(&path);
                self.document.opened = (!is_scene && FileKind::from_path(&path).is_none()).then_some(path);
            }
            Ok(Contents::Scene(scene, surroundings)) => {
                let is_current = surroundings == self.document.settings.light.surroundings;
                if is_current && scene.scene != self.document.scene {
                    self.scratch.notice = report(&scene.scene);
                    self.show_scene(*scene);
                }
            }
            Ok(Contents::Lesson(lesson)) if purpose == Use::RenewLesson => self.renew_lesson(&lesson, &path),
            Ok(Contents::Lesson(lesson)) => self.open_lesson(&lesson, &path),
            Ok(Contents::Sequence(sequence)) => {
                self.session.recent.add(&path);
                self.begin_sequence(sequence);
            }
            Ok(Contents::Data(file)) => {
                self.session.data = Some(Arc::new(file));
                self.document.settings.plots.plot = PlotTab::Fit;
                self.document.settings.window.plots = true;
            }
            Err(error) => {
                self.tell(Notice::error(error).about(&path));
                if purpose == Use::Show && !files::is_file(&path) {
                    self.session.recent.remove(&path);
                }
            }
        }
    }

    /// Whether what `purpose` is about is still in the file at `path`.
    fn still_shows(&self, path: &Path, purpose: Use) -> bool {
        match purpose {
            Use::Show | Use::Fit => true,
            Use::RenewScene => self.scene_file() == Some(path),
            Use::RenewSettings => self.document.opened.as_deref() == Some(path),
            Use::RenewLesson => {
                self.course().is_some_and(|course| course.lesson().path.as_deref() == Some(path))
            }
        }
    }

    /// Shows `settings` that the file at `path` now contains, at the present T and with the points that still
    /// exist, unless it says which.
    fn show_again(&mut self, settings: Settings, scene: ReadyScene, path: PathBuf) {
        let (points, before) = (self.document.points.clone(), self.document.scene.clone());
        let gives_a_point = settings.point.is_some() || settings.points.is_some();
        let playing = self.scratch.playing;
        self.show_in(Settings { time: settings.time.or(Some(self.document.time)), ..settings }, scene);
        self.scratch.playing = playing;
        self.document.opened = Some(path);
        if !gives_a_point {
            self.document.points = points.carried(&before, &self.document.scene);
        }
    }
}
