//! The files that a model may consist of: those in the folder of its scene.

use std::io;
use std::path::{Component, Path};

use gamow_platform::{files, sizes};

use crate::scene::presets;

/// The place of the files of a scene's models.
#[derive(Debug, Clone, Copy)]
pub(in crate::scene) enum ModelFiles<'a> {
    /// Nowhere: the scene is a text without a file.
    Nowhere,
    /// Compiled in, with the scene.
    Preset,
    /// In this folder, that of the scene file.
    Folder(&'a Path),
}

impl ModelFiles<'_> {
    /// Returns the bytes of the file at `path`, from the folder.
    ///
    /// # Errors
    ///
    /// A path that leaves the folder; a file that there is not, that is no regular file, or of more than
    /// [`sizes::MODEL_BYTES`].
    pub fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        let folder = match self {
            Self::Nowhere => return Err("a model needs a scene file, in whose folder it is".to_owned()),
            Self::Preset => {
                let file = presets::model_file(path).ok_or_else(|| format!("there is no {path}"))?;
                return Ok(file.to_vec());
            }
            Self::Folder(folder) => folder,
        };
        let leaves = || format!("{path} must lie in the folder of the scene file, or in a folder there");
        let is_below = |part: Component| matches!(part, Component::Normal(_) | Component::CurDir);
        if path.contains('\\') || !Path::new(path).components().all(is_below) {
            return Err(leaves());
        }
        if !files::HAS_FOLDERS {
            // There are only the files that the user gave.
            return files::read(Path::new(path), sizes::MODEL_BYTES)
                .map_err(|error| format!("cannot read {path}: {error}"));
        }
        let place = folder.join(path);
        let unread = |error: io::Error| format!("cannot read {path}: {error}");
        let (around, place) =
            (files::canonical(folder).map_err(unread)?, files::canonical(&place).map_err(unread)?);
        if !place.starts_with(&around) {
            return Err(leaves());
        }
        files::read(&place, sizes::MODEL_BYTES).map_err(unread)
    }
}
