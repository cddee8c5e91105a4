//! Files that are shown: opened, and read again when they change.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::notice::Notice;
use super::state::State;
use crate::estimate::samples::DataFile;
use crate::flags::choices::FileKind;
use crate::platform::files;
use crate::settings::{PlotTab, Settings, SettingsError, looks_like_settings};

impl State {
    /// The files that are shown, which are read again when they change: those of the scene, of
    /// the settings and of the lesson.
    #[must_use]
    pub fn shown_files(&self) -> Vec<PathBuf> {
        let scene = self.scene_file().map(Path::to_owned);
        let lesson = self.course().and_then(|course| course.lesson().path.clone());
        self.session.opened.clone().into_iter().chain(scene).chain(lesson).collect()
    }

    /// Shows what is in the file at `path`, which stays in the list of scenes; one that is no longer there is dropped
    /// from it.
    pub(super) fn open_file(&mut self, path: PathBuf) {
        match path.extension().map(|extension| extension.to_string_lossy().to_lowercase()).as_deref() {
            Some("csv") => return self.open_data(&path),
            Some("md") => return self.open_lesson_file(&path),
            _ => {}
        }
        self.session.chooser = None;
        let is_scene = is_scene(&path);
        self.session.notice = None;
        match self.settings_in(&path) {
            Ok(settings) => self.show(settings),
            Err(error) => self.session.notice = Some(Notice::error(error).about(&path)),
        }
        if self.session.notice.as_ref().is_none_or(|notice| !notice.is_error) {
            self.session.recent.add(&path);
            self.session.opened = (!is_scene && FileKind::of(&path).is_none()).then_some(path);
        } else if !files::is_file(&path) {
            self.session.recent.remove(&path);
        }
    }

    /// Fits the measured disparities in the file at `path`, in view.
    pub(super) fn open_data(&mut self, path: &Path) {
        self.session.chooser = None;
        match DataFile::open(path, self.settings.baseline()) {
            Ok(file) => {
                self.session.data = Some(Arc::new(file));
                self.settings.plots.plot = PlotTab::Fit;
                self.settings.window.plots = true;
            }
            Err(error) => self.session.notice = Some(Notice::error(format!("{error:#}")).about(path)),
        }
    }

    /// Shows what the file at `path` says by now. What is wrong with it is said, and all stays as it is.
    pub(super) fn reload(&mut self, path: &Path) {
        if self.scene_file() == Some(path) {
            match self.settings.opened_scene() {
                Ok(scene) if scene == self.session.scene => {}
                Ok(scene) => {
                    self.show_scene(scene);
                    self.session.notice = None;
                }
                Err(error) => self.session.notice = Some(Notice::error(error).about(path)),
            }
        } else if self.session.opened.as_deref() == Some(path) {
            match self.settings_in(path) {
                Ok(settings) => self.show_again(settings, path),
                Err(error) => self.session.notice = Some(Notice::error(error).about(path)),
            }
        } else {
            self.reload_lesson(path);
        }
    }

    /// Shows `settings` that the file at `path` says by now, at the present T and with the points that are still there,
    /// unless it says which.
    fn show_again(&mut self, settings: Settings, path: &Path) {
        let (points, scene) = (self.session.points.clone(), self.session.scene.clone());
        let gives_a_point = settings.point.is_some() || settings.points.is_some();
        let playing = self.session.playing;
        self.session.notice = None;
        self.show(Settings { time: settings.time.or(Some(self.session.time)), ..settings });
        self.session.playing = playing;
        self.session.opened = Some(path.to_owned());
        if !gives_a_point {
            self.session.points = points.carried(&scene, &self.session.scene);
        }
    }

    /// The settings that the file at `path` leads to. What it does not say of the window's parts and of the layout stays as
    /// it is; the rest is as usual.
    fn settings_in(&self, path: &Path) -> Result<Settings, SettingsError> {
        if is_scene(path) {
            return self.settings.clone().with_scene_file(path);
        }
        Settings::default().in_place_of(&self.settings).with_file(path)
    }
}

/// Whether the file at `path` is a scene's, and none of settings.
fn is_scene(path: &Path) -> bool {
    FileKind::of(path).is_none() && !files::read_to_string(path).is_ok_and(|text| looks_like_settings(&text))
}
