//! The files that a model may consist of: those in the folder of its scene.

use std::io;
use std::path::{Component, Path, PathBuf};

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

    /// Returns the path of a file that differs from `path` in the case of letters alone, if there is one.
    pub fn spelt(&self, path: &str) -> Option<String> {
        let Self::Folder(folder) = self else { return None };
        let (mut place, mut spelt) = (folder.to_path_buf(), PathBuf::new());
        for part in Path::new(path).components() {
            let Component::Normal(part) = part else { return None };
            let lower = part.to_str()?.to_lowercase();
            let is_it = |other: &PathBuf| {
                other.file_name().and_then(|name| name.to_str()).is_some_and(|it| it.to_lowercase() == lower)
            };
            let found = files::list_folder(&place).ok()?.into_iter().find(is_it)?;
            spelt.push(found.file_name()?);
            place = found;
        }
        spelt.to_str().filter(|spelt| *spelt != path).map(str::to_owned)
    }
}
