//! The models that are opened with a scene, and what is said about them.

use std::cell::RefCell;

use serde::{Deserialize, Serialize};

use super::files::ModelFiles;
use super::parts::NamedModel;

/// A model that was opened, and remarks on it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ModelReport {
    /// Path of its file, from the scene.
    pub path: String,
    /// The remarks: what was left out or replaced.
    pub remarks: Vec<String>,
}

impl ModelReport {
    /// Returns the remarks in one line; `None` without any.
    #[must_use]
    pub fn remarks(&self) -> Option<String> {
        (!self.remarks.is_empty()).then(|| format!("{}: {}", self.path, self.remarks.join("; ")))
    }
}

/// The models of a scene that is being read.
#[derive(Debug, Clone, Copy)]
pub(in crate::scene) struct Models<'a> {
    pub files: ModelFiles<'a>,
    pub reports: &'a RefCell<Vec<ModelReport>>,
}

impl Models<'_> {
    /// Reads the model in the file at `path`.
    pub(in crate::scene::model) fn open(&self, path: &str) -> Result<NamedModel, String> {
        let (named, remarks) = super::read(&self.files, path)?;
        let mut reports = self.reports.borrow_mut();
        if reports.iter().all(|report| report.path != path) {
            reports.push(ModelReport { path: path.to_owned(), remarks });
        }
        Ok(named)
    }
}
