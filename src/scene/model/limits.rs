//! Limits of a model that is being read.

use relativity_render::geometry::triangles::MOST_TRIANGLES;

/// Refuses more triangles than are drawn, before they take memory.
pub fn check_count(triangles: usize) -> Result<(), String> {
    if triangles <= MOST_TRIANGLES {
        return Ok(());
    }
    Err(format!("it has more than {MOST_TRIANGLES} triangles, the most of a model"))
}
