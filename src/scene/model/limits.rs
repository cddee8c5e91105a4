//! Limits of a model that is being read, and of all models of a scene together.

use std::cell::Cell;

use gamow_platform::sizes;
use relativity_render::geometry::triangles::{MOST_TEXELS, MOST_TRIANGLES};

/// Refuses more triangles than are drawn, before they take memory.
pub fn check_count(triangles: usize) -> Result<(), String> {
    if triangles <= MOST_TRIANGLES {
        return Ok(());
    }
    Err(format!("it has more than {MOST_TRIANGLES} triangles, the most of a model"))
}

/// The room that is left for the models of a scene: together they have the limits of one.
#[derive(Debug)]
pub struct Room {
    /// Number of texels that the scene may still have.
    pub texels: Cell<u64>,
    bytes: Cell<u64>,
    triangles: Cell<usize>,
}

impl Default for Room {
    fn default() -> Self {
        Self {
            texels: Cell::new(MOST_TEXELS),
            bytes: Cell::new(sizes::MODEL_BYTES),
            triangles: Cell::new(MOST_TRIANGLES),
        }
    }
}

impl Room {
    /// Takes the room for a file of `bytes`.
    pub fn take_bytes(&self, bytes: u64) -> Result<(), String> {
        let left = self.bytes.get().checked_sub(bytes);
        self.bytes.set(left.ok_or_else(|| {
            format!("the models of the scene have files of more than {} bytes together", sizes::MODEL_BYTES)
        })?);
        Ok(())
    }

    /// Takes the room for this number of `triangles`.
    pub fn take_triangles(&self, triangles: usize) -> Result<(), String> {
        let left = self.triangles.get().checked_sub(triangles);
        self.triangles.set(left.ok_or_else(|| {
            format!("the models of the scene have more than {MOST_TRIANGLES} triangles together")
        })?);
        Ok(())
    }
}
