//! The report on a model that was opened: its contents, and what was left out of it or replaced.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::parts::NamedModel;

/// A model that was opened.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ModelReport {
    /// Path of its file, from the scene.
    pub path: String,
    /// Number of its triangles.
    pub triangles: usize,
    /// Size along the axes of its file, in the units of that.
    pub size: [f64; 3],
    /// Number of its materials.
    pub materials: usize,
    /// Number of its textures.
    pub textures: usize,
    /// The remarks: what was left out or replaced.
    pub remarks: Vec<String>,
}

impl ModelReport {
    /// Returns the report on the model `named`, of the file at `path`, with these remarks.
    pub(super) fn new(path: &str, named: &NamedModel, remarks: Vec<String>) -> Self {
        let model = &named.model;
        let used = model.triangles.iter().flatten().filter_map(|&corner| model.corners.get(corner as usize));
        let none = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let [low, high] = used
            .fold(none, |[low, high], &corner| [low.min(DVec3::from(corner)), high.max(DVec3::from(corner))]);
        Self {
            path: path.to_owned(),
            triangles: model.triangles.len(),
            size: (high - low).max(DVec3::ZERO).to_array(),
            materials: named.materials,
            textures: model.textures.len(),
            remarks,
        }
    }

    /// Returns the report in one line.
    #[must_use]
    pub fn line(&self) -> String {
        let [length, width, height] = self.size.map(rounded);
        let counts = [
            counted(self.triangles, "triangle", "triangles"),
            format!("{length} by {width} by {height}"),
            counted(self.materials, "material", "materials"),
            counted(self.textures, "texture", "textures"),
        ];
        let parts = std::iter::once(counts.join(", ")).chain(self.remarks.iter().cloned());
        format!("{}: {}", self.path, parts.collect::<Vec<_>>().join("; "))
    }
}

/// Returns a number with what is counted.
pub(super) fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// Returns a size with four digits.
fn rounded(size: f64) -> f64 {
    format!("{size:.3e}").parse().unwrap_or(size)
}
