//! Writing of reports as JSON.

use std::io::{self, Write};

use serde::Serialize;

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
