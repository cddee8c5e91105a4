//! The files that were opened: they stay in the list of scenes.

use std::path::{Path, PathBuf};

use gamow_platform::files;

/// Greatest number of files.
const MAX_FILES: usize = 8;

/// The files that were opened, the latest first.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Recent(Vec<PathBuf>);

impl Recent {
    /// Returns all files, the last first.
    #[must_use]
    pub fn all(&self) -> &[PathBuf] {
        &self.0
    }

    /// Puts the file at `path` first.
    pub fn add(&mut self, path: &Path) {
        let path = files::canonical(path).unwrap_or_else(|_| path.to_owned());
        self.remove(&path);
        self.0.insert(0, path);
        self.0.truncate(MAX_FILES);
    }

    /// Removes `path` from the list.
    pub fn remove(&mut self, path: &Path) {
        self.0.retain(|known| known != path);
    }

    /// Adds those of `other` behind.
    pub fn extend(&mut self, other: Self) {
        for path in other.0 {
            if !self.0.contains(&path) {
                self.0.push(path);
            }
        }
        self.0.truncate(MAX_FILES);
    }

    /// Writes the list as text, a line for each file.
    #[must_use]
    pub fn to_text(&self) -> String {
        self.0.iter().filter_map(|path| path.to_str()).collect::<Vec<_>>().join("\n")
    }

    /// Reads the list from such a `text`.
    #[must_use]
    pub fn of_text(text: &str) -> Self {
        Self(text.lines().filter(|line| !line.is_empty()).map(PathBuf::from).take(MAX_FILES).collect())
    }
}

/// The name of the file at `path`, without its folder.
#[must_use]
pub fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(|| files::shown(path), |name| name.to_string_lossy().into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_latest_is_first_and_none_is_there_twice() {
        let mut recent = Recent::default();
        for number in 0..12 {
            recent.add(Path::new(&format!("/nowhere/{number}.toml")));
        }
        recent.add(Path::new("/nowhere/9.toml"));
        assert_eq!(recent.all().len(), MAX_FILES);
        assert_eq!(recent.all()[..2], ["/nowhere/9.toml", "/nowhere/11.toml"].map(PathBuf::from));
        assert_eq!(Recent::of_text(&recent.to_text()), recent);
        recent.remove(Path::new("/nowhere/9.toml"));
        assert_eq!(recent.all()[0], Path::new("/nowhere/11.toml"));
        assert!(Recent::of_text("").all().is_empty());
    }
}
