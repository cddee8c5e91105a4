//! Scenes: what rides past, and how it is described in a file.
//!
//! A scene is a TOML file (`assets/scenes/README.md` describes it). Those in `assets/scenes` are
//! compiled in as presets.

mod content;
mod convex_hull;
mod error;
mod file;
mod fingerprint;
mod light;
mod model;
mod names;
mod object;
mod presets;
mod table;
#[cfg(test)]
mod tests;
mod wheel;

use std::io;
use std::path::Path;

use gamow_platform::files;

pub use content::{Scene, SceneGroup, Track};
pub use convex_hull::convex_hull;
pub use error::{SceneError, SceneProblem};
pub use model::ridden::text as scene_text;
pub use model::{ModelReport, is_model, read_model};
pub use presets::{PRESETS, looks_like_a_name};

impl Scene {
    /// The preset of that name, one of [`PRESETS`].
    #[must_use]
    pub fn preset(name: &str) -> Option<Self> {
        file::preset(name)
    }

    /// Returns the scene with the bicycle of who rides through it, whose bodies come last.
    #[must_use]
    pub fn with_own_bicycle(self) -> Self {
        self.with_riding_along(file::own_bicycle())
    }

    /// The scene in a file: of a model, the one in which it rides on Gamow's street.
    ///
    /// # Errors
    /// One line that names the file, the line in it, what is wrong and what would be right.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let source_name = files::shown(path);
        if is_model(path) {
            return file::scene_of_model(path).map_err(|reason| SceneError::Model { source_name, reason });
        }
        let no_scene =
            |path: &Path| path.extension().is_some_and(|ending| !ending.eq_ignore_ascii_case("toml"));
        match files::read_to_string(path) {
            Ok(text) => {
                file::scene_in(&text, files::folder_of(path)).map_err(|located| match located.problem {
                    SceneProblem::Syntax { .. } if no_scene(path) => SceneError::Other { source_name },
                    _ => located.in_source(&text, &source_name),
                })
            }
            Err(reason) if reason.kind() == io::ErrorKind::InvalidData && no_scene(path) => {
                Err(SceneError::Other { source_name })
            }
            Err(reason) => Err(SceneError::Read { source_name, reason }),
        }
    }

    /// The preset called `preset_or_path`, or else the scene in the file there.
    pub fn open(preset_or_path: &str) -> Result<Self, SceneError> {
        match Self::preset(preset_or_path) {
            Some(scene) => Ok(scene),
            None if looks_like_a_name(preset_or_path) => {
                Err(SceneError::UnknownPreset(preset_or_path.to_owned()))
            }
            None => Self::load(Path::new(preset_or_path)),
        }
    }

    /// The scene that `text` describes; errors call it `source_name`. It has no folder, and so no models from
    /// files.
    pub fn parse(text: &str, source_name: &str) -> Result<Self, SceneError> {
        file::scene(text).map_err(|located| located.in_source(text, source_name))
    }
}

impl Default for Scene {
    /// Opens Gamow's street.
    fn default() -> Self {
        Self::preset(PRESETS[0]).expect("it is a preset")
    }
}
