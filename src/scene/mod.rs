//! Scenes: what rides past, and how it is described in a file.
//!
//! A scene is a TOML file (`assets/scenes/README.md` describes it). Those in `assets/scenes` are
//! compiled in as presets.

mod error;
mod file;
mod fingerprint;
mod placement;
mod presets;
mod table;
#[cfg(test)]
mod tests;

use std::ops::Range;
use std::path::Path;

use relativity_render::{Body, Group, Motion, PreparedScene};

use crate::platform::files;
pub use error::{Problem, SceneError};
pub use presets::PRESETS;

/// A scene: groups of bodies, each at rest in a frame of its own, and the ground they pass over. Lengths in the scene's
/// unit, rest-frame coordinates `[x, y, z]` with x along the motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Its name, as shown.
    pub name: String,
    /// The bodies of all groups, numbered from 0; at least one.
    pub bodies: Vec<Body>,
    /// Which of them move alike: one after the other, without gaps.
    pub groups: Vec<SceneGroup>,
    /// The point that is selected and followed at first: the forward-most one (largest x) unless the
    /// file chooses another.
    pub tracked: [f64; 3],
    /// Height of the resting ground (the grid), if there is one.
    pub ground_z: Option<f64>,
}

/// Bodies that move alike.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneGroup {
    /// Its name.
    pub name: String,
    /// How it moves.
    pub motion: Motion,
    /// Number of its first body.
    pub first: usize,
    /// How many it has.
    pub count: usize,
}

impl SceneGroup {
    /// The numbers of its bodies.
    #[must_use]
    pub fn bodies(&self) -> Range<usize> {
        self.first..self.first + self.count
    }
}

impl Scene {
    /// The preset of that name, one of [`PRESETS`].
    #[must_use]
    #[expect(clippy::missing_panics_doc, reason = "it cannot fail: tests read every preset")]
    pub fn preset(name: &str) -> Option<Self> {
        let text = presets::text(name)?;
        Some(Self::parse(text, name).expect("tests read every preset"))
    }

    /// The scene in a file.
    ///
    /// # Errors
    /// One line that names the file, the line in it, what is wrong and what would be right.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let source_name = path.display().to_string();
        match files::read_to_string(path) {
            Ok(text) => Self::parse(&text, &source_name),
            Err(reason) => Err(SceneError::Read { source_name, reason }),
        }
    }

    /// The preset called `preset_or_path`, or else the scene in the file there.
    pub fn open(preset_or_path: &str) -> Result<Self, SceneError> {
        match Self::preset(preset_or_path) {
            Some(scene) => Ok(scene),
            None if presets::looks_like_a_name(preset_or_path) => {
                Err(SceneError::UnknownPreset(preset_or_path.to_owned()))
            }
            None => Self::load(Path::new(preset_or_path)),
        }
    }

    /// It, ready to be drawn.
    #[must_use]
    pub fn prepared(&self) -> PreparedScene {
        let group = |group: &SceneGroup| Group { motion: group.motion, bodies: &self.bodies[group.bodies()] };
        PreparedScene::new(self.groups.iter().map(group))
    }

    /// The bodies, moved by `offset` in the rest frame.
    #[must_use]
    pub fn bodies_moved(&self, offset: [f64; 3]) -> Vec<Body> {
        let moved = |body: &Body| Body { shape: placement::moved(body.shape, offset), ..*body };
        self.bodies.iter().map(moved).collect()
    }

    /// The scene that `text` describes; errors call it `source_name`.
    pub fn parse(text: &str, source_name: &str) -> Result<Self, SceneError> {
        file::scene(text).map_err(|located| located.in_source(text, source_name))
    }
}

impl Default for Scene {
    /// The cyclist of the paper.
    fn default() -> Self {
        Self::preset("cyclist").expect("it is a preset")
    }
}
