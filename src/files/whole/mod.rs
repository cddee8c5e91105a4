//! Output files that are written whole or not at all.

#[cfg(feature = "desktop")]
mod native;
#[cfg(not(feature = "desktop"))]
mod web;

use std::io::{self, Write};
use std::path::Path;

use serde::Serialize;

#[cfg(feature = "desktop")]
pub use native::*;
#[cfg(not(feature = "desktop"))]
pub use web::write_whole;

use crate::platform::files;

/// Refuses a `path`, given by `flag`, whose name does not end in `.ending`, and gives the one that would be right: the name should
/// tell what a file holds. Devices are called as they are.
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

/// Writes `report` as JSON.
///
/// # Errors
///
/// Those of `out`.
pub fn write_json(report: &impl Serialize, mut out: impl Write) -> anyhow::Result<()> {
    // An error of JSON would hide the kind of that of `out`.
    serde_json::to_writer_pretty(&mut out, report).map_err(io::Error::from)?;
    Ok(writeln!(out)?)
}
