//! The reading of one file, for a purpose.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use gamow_platform::files;
use relativity_render::PreparedScene;
use serde::{Deserialize, Serialize};

use crate::estimate::data_file::DataFile;
use crate::flags::choices::FileKind;
use crate::lesson::{Lesson, Library, Sequence};
use crate::scene::Scene;
use crate::settings::{Settings, SettingsError, is_link, looks_like_settings, message};

/// The use that is made of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Use {
    /// The contents are shown, whatever their kind.
    Show,
    /// The measured disparities in the file are fitted.
    Fit,
    /// The file of the scene that is shown has changed on disk.
    RenewScene,
    /// The file of the settings that are shown has changed on disk.
    RenewSettings,
    /// The file of the running lesson has changed on disk.
    RenewLesson,
}

impl Use {
    /// Whether the file replaces what was opened before it.
    #[must_use]
    pub const fn opens(self) -> bool {
        matches!(self, Self::Show | Self::Fit)
    }
}

/// A file to be read.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Errand {
    /// Path of the file to read.
    pub path: PathBuf,
    /// The purpose of reading the file.
    pub purpose: Use,
    /// The window's present settings, which complete the contents of the file.
    #[serde(with = "message::all")]
    pub settings: Settings,
    /// The lessons that there are, which no scene asks for.
    #[serde(skip, default = "Library::own")]
    pub library: Arc<Library>,
}

/// A file that was read, or could not be.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadFile {
    /// Path of the file read.
    pub path: PathBuf,
    /// The purpose of reading the file.
    pub purpose: Use,
    /// The contents, or a one-line error message.
    pub contents: Result<Contents, String>,
}

/// The contents of a file.
#[derive(Debug, Clone, PartialEq)]
pub enum Contents {
    /// A scene, a state, or a picture that records one.
    Settings {
        /// The settings that the file leads to.
        settings: Box<Settings>,
        /// The scene of these settings.
        scene: Box<ReadyScene>,
        /// Whether the file is the scene's own.
        is_scene: bool,
    },
    /// The scene of the settings that are shown, and whether with what rests around it.
    Scene(Box<ReadyScene>, bool),
    /// A lesson in Markdown.
    Lesson(Box<Lesson>),
    /// A presenter's own sequence.
    Sequence(Sequence),
    /// A table of measured disparities.
    Data(DataFile),
}

/// A scene and the settings that a file leads to.
#[derive(Debug, Serialize, Deserialize)]
pub struct Shown {
    #[serde(with = "message::all")]
    settings: Box<Settings>,
    scene: Scene,
    is_scene: bool,
}

impl From<Shown> for Contents {
    fn from(Shown { settings, scene, is_scene }: Shown) -> Self {
        Self::Settings { settings, scene: Box::new(scene.into()), is_scene }
    }
}

/// A scene that is ready to be drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadyScene {
    /// The scene at rest, as its file describes it.
    pub scene: Scene,
    /// The scene prepared for drawing and picking.
    pub prepared: PreparedScene,
}

impl From<Scene> for ReadyScene {
    fn from(scene: Scene) -> Self {
        Self { prepared: scene.prepared(), scene }
    }
}

impl Errand {
    /// Reads the file, however long that takes.
    #[must_use]
    pub fn read(self) -> ReadFile {
        let contents = match self.purpose {
            Use::Show => match self.ending().as_deref() {
                Some("csv") => self.data(),
                Some("md") => self.lesson(),
                Some("txt") => self.sequence(),
                _ => self.shown().map(Shown::into),
            },
            Use::Fit => self.data(),
            Use::RenewScene => self.scene(),
            Use::RenewSettings => self.shown().map(Shown::into),
            Use::RenewLesson => self.lesson(),
        };
        ReadFile { path: self.path, purpose: self.purpose, contents }
    }

    /// Whether the file leads to settings, and so to a scene with its models.
    #[cfg(not(feature = "desktop"))]
    pub fn leads_to_scene(&self) -> bool {
        let is_other = |ending: &str| ["csv", "md", "txt"].contains(&ending);
        self.purpose == Use::RenewSettings
            || self.purpose == Use::Show && !self.ending().as_deref().is_some_and(is_other)
    }

    /// The ending of the file's name, in small letters.
    fn ending(&self) -> Option<String> {
        self.path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase())
    }

    fn data(&self) -> Result<Contents, String> {
        let file = DataFile::open(&self.path, self.settings.baseline());
        file.map(Contents::Data).map_err(|error| format!("{error:#}"))
    }

    fn lesson(&self) -> Result<Contents, String> {
        let lesson = Lesson::load(&self.path).map_err(|error| error.to_string())?;
        Ok(Contents::Lesson(Box::new(lesson)))
    }

    fn sequence(&self) -> Result<Contents, String> {
        Sequence::load(&self.path, &self.library).map(Contents::Sequence).map_err(|error| error.to_string())
    }

    fn scene(&self) -> Result<Contents, String> {
        let scene = self.settings.opened_scene().map_err(|error| error.to_string())?;
        Ok(Contents::Scene(Box::new(scene.into()), self.settings.light.surroundings))
    }

    /// Returns the scene that the file leads to, with its settings, or a one-line error message.
    pub fn shown(&self) -> Result<Shown, String> {
        let is_scene = is_scene(&self.path);
        let settings = self.led_to(is_scene).map_err(|error| error.to_string())?;
        let scene = settings.opened_scene().map_err(|error| error.to_string())?;
        Ok(Shown { settings: Box::new(settings), scene, is_scene })
    }

    /// The settings that the file leads to. What it does not say of the window's parts and of the layout
    /// stays as it is, whatever the settings of whoever made a picture; the rest has its defaults.
    fn led_to(&self, is_scene: bool) -> Result<Settings, SettingsError> {
        if is_scene {
            return self.settings.clone().with_scene_file(&self.path);
        }
        let settings = Settings::default().in_place_of(&self.settings).with_file(&self.path)?;
        let is_picture = FileKind::from_path(&self.path).is_some();
        Ok(if is_picture { settings.as_seen_by(&self.settings) } else { settings })
    }
}

/// Whether the file at `path` is a scene's, and none of settings.
fn is_scene(path: &Path) -> bool {
    FileKind::from_path(path).is_none()
        && !is_link(path)
        && !files::read_to_string(path).is_ok_and(|text| looks_like_settings(&text))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A model that is dropped is a scene, and a broken one is named in one line.
    #[test]
    fn a_model_is_shown_as_a_scene() {
        let folder = tempfile::tempdir().expect("there is a place for temporary files");
        let path = folder.path().join("tent.obj");
        let read = |text: &str| {
            std::fs::write(&path, text).expect("it is writable");
            let (settings, library) = (Settings::default(), Library::own());
            Errand { path: path.clone(), purpose: Use::Show, settings, library }.read().contents
        };
        let shown = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("it is right");
        let Contents::Settings { settings, scene, is_scene } = shown else { panic!("{shown:?}") };
        assert_eq!((Path::new(&settings.scene), is_scene), (path.as_path(), true));
        assert_eq!((scene.scene.name.as_str(), scene.scene.groups.len()), ("tent", 2));
        let error = read("v 0 0 0\nf 1 2 3\n").expect_err("it is wrong");
        assert!(
            error.ends_with("tent.obj: line 2 of it: a face names corner 2, and so far there are 1"),
            "{error}"
        );
    }
}
