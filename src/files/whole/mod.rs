//! Output files that are written whole or not at all.

mod json;
#[cfg(feature = "desktop")]
mod native;
#[cfg(not(feature = "desktop"))]
mod web;

use std::path::Path;

use gamow_platform::files;

pub use json::write_json;
#[cfg(feature = "desktop")]
pub use native::*;
#[cfg(not(feature = "desktop"))]
pub use web::write_whole;

/// Refuses a `path`, given by `flag`, whose name does not end in `.ending`, and gives the one that would be
/// right: the name should tell what a file holds. Devices are called as they are.
///
/// # Errors
///
/// Another ending.
pub fn ensure_ending(flag: &str, path: &Path, ending: &str) -> anyhow::Result<()> {
    let is_right = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(ending));
    anyhow::ensure!(
        is_right || files::is_special(path),
        "{flag} {}: it writes .{ending} files only; {} would be right",
        files::shown(path),
        files::shown(&path.with_extension(ending))
    );
    Ok(())
}
