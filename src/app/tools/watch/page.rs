//! The files that are shown: those of a page never change.

use std::path::PathBuf;

use eframe::egui::Context;

/// The paths that would be watched.
#[derive(Debug)]
pub struct Watch(Vec<PathBuf>);

impl Watch {
    /// Keeps `paths`, which never change in a page.
    #[must_use]
    pub fn new(_: Context, paths: Vec<PathBuf>) -> Self {
        Self(paths)
    }

    /// Returns the paths that would be watched.
    #[must_use]
    pub fn paths(&self) -> &[PathBuf] {
        &self.0
    }

    /// Returns the files that have changed: none.
    #[must_use]
    pub const fn changed(&self) -> Vec<PathBuf> {
        Vec::new()
    }
}
