//! Output files of the file system, and standard output as the alternative.

use std::collections::BTreeSet;
use std::fmt;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use anyhow::Context as _;
use clap::Args;
use gamow_platform::files::{self, File, Rights, TempPath};
use gamow_platform::progress::Count;
use gamow_platform::{closed, interrupt, messages};
use serde::Serialize;

use super::json::write_json;
use crate::files::csv_out::CsvWriter;
use crate::files::table_out::{JsonRows, TableWriter, UnitOf};
use crate::files::watched::{Named, write_named};

/// The output of a command.
#[derive(Debug, Clone, Args)]
pub struct OutArgs {
    /// Write here, whole or not at all, instead of to standard output.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl OutArgs {
    /// Hands a writer for the file, or for standard output if there is none or it is called `-`, to `write`.
    ///
    /// # Errors
    ///
    /// Those of `write`, and of the file system. A file is then left as it was; standard output keeps what
    /// reached it before.
    pub fn write(&self, write: impl FnOnce(&mut dyn Write) -> anyhow::Result<()>) -> anyhow::Result<()> {
        match &self.out {
            Some(path) if path != Path::new("-") => write_whole(path, |file| write(file)),
            _ => write_out(write),
        }
    }
}

/// Hands a writer for standard output to `write`.
///
/// # Errors
///
/// Those of `write`, and of standard output, which keeps what reached it before. One that is closed is
/// remarked on.
pub fn write_out(write: impl FnOnce(&mut dyn Write) -> anyhow::Result<()>) -> anyhow::Result<()> {
    if closed::is_stdout_closed() {
        messages::remark(format_args!("gamow: {STDOUT} is closed or discarded: this output is lost"));
    }
    say(write)
}

/// Writes a message beside the requested output; it may be lost with a standard output that is closed.
///
/// # Errors
///
/// Those of `write`, and of standard output.
pub fn say(write: impl FnOnce(&mut dyn Write) -> anyhow::Result<()>) -> anyhow::Result<()> {
    write_named(messages::stdout(), || STDOUT.to_owned(), |out| write(out)).map(drop)
}

/// Name of standard output in messages.
const STDOUT: &str = "standard output";

/// The format and the output of a command's report.
#[derive(Debug, Clone, Args)]
pub struct ReportArgs {
    /// Write JSON instead of a table.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    out: OutArgs,
}

impl ReportArgs {
    /// Writes the `report`.
    ///
    /// # Errors
    ///
    /// As [`OutArgs::write`].
    pub fn write(&self, report: &(impl fmt::Display + Serialize)) -> anyhow::Result<()> {
        self.out.write(|out| write_report(report, self.json, out))
    }

    /// Hands a writer of tables to `write`; `unit` knows the units of its columns.
    ///
    /// # Errors
    ///
    /// As [`OutArgs::write`].
    pub fn write_table(
        &self,
        unit: UnitOf,
        write: impl FnOnce(&mut TableWriter<&mut dyn Write>) -> anyhow::Result<()>,
    ) -> anyhow::Result<()> {
        self.out.write(|out| {
            let mut table = if self.json {
                TableWriter::Json(JsonRows::new(out, unit))
            } else {
                TableWriter::Csv(Box::new(CsvWriter::new(out)))
            };
            write(&mut table)?;
            Ok(table.finish()?)
        })
    }

    /// Returns a count of rows as they are written, which a terminal that shows them does without.
    #[must_use]
    pub fn count_of_rows(&self) -> Count {
        Count::new("rows", self.out.out.is_some() || !messages::is_stdout_a_terminal())
    }
}

/// Writes `report` as JSON or as text.
///
/// # Errors
///
/// Those of `out`.
pub fn write_report(
    report: &(impl fmt::Display + Serialize),
    is_json: bool,
    mut out: impl Write,
) -> anyhow::Result<()> {
    if is_json { write_json(report, out) } else { Ok(write!(out, "{report}")?) }
}

/// Hands `write` a temporary file beside `path`, which takes the place of `path` once all is written, with
/// the access rights of the file that was there. An interrupt (Ctrl-C) removes it; only a program that is
/// killed outright leaves it, under a name that begins with `.gamow-`.
///
/// A `path` that is there but is no regular file, such as /dev/null or a named pipe, is written to directly,
/// once there is a reader: to replace it would not be what was asked for. Where that is not asked for,
/// [`files::check_replaceable`] says so before.
///
/// # Errors
///
/// Those of `write`, and of the file system, the latter with `path`, which is then left as it was.
pub fn write_whole(
    path: &Path,
    write: impl FnOnce(&mut Named<File>) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    write_whole_through(path, |file| file, write)
}

/// Writes a file whole or not at all, through the writer that `through` makes of it.
fn write_whole_through<W: Write>(
    path: &Path,
    through: impl FnOnce(File) -> W,
    write: impl FnOnce(&mut Named<W>) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    let name = || files::shown(path);
    if files::is_special(path) {
        let device = files::open_special(path).with_context(name)?;
        return write_named(through(device), name, write).map(drop);
    }
    // A link stays a link: what it points to is replaced.
    let target = files::behind_links(path).with_context(name)?;
    let (file, unfinished) = Unfinished::beside(&target).with_context(name)?;
    // Nobody misses a new file after a power cut as they would an old one, and a sequence of many small
    // frames would wait for a busy disc at each.
    let replacing = files::is_there(&target).then(|| file.try_clone()).transpose().with_context(name)?;
    drop(write_named(through(file), name, write)?);
    unfinished.take_the_place_of(&target, replacing).with_context(name)
}

/// Temporary files that are being written.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// A temporary file, which goes when it is dropped, and when the program is interrupted.
struct Unfinished(Option<TempPath>);

impl Unfinished {
    /// Returns a temporary file to take the place of `target`.
    fn beside(target: &Path) -> io::Result<(File, Self)> {
        interrupt::end_after(remove_unfinished);
        let rights = Rights::from_file(target)?;
        // Interrupts wait for the lock: there is no moment at which it is there and they do not know it.
        let mut all = unfinished();
        let (file, path) = files::temporary_in(files::folder_of(target), rights.as_ref())?.into_parts();
        all.insert(path.to_path_buf());
        Ok((file, Self(Some(path))))
    }

    /// Has the file take the place of `target`. If it is `replacing` what is there, one or the other is there
    /// after a power cut, whole.
    fn take_the_place_of(mut self, target: &Path, replacing: Option<File>) -> io::Result<()> {
        let is_replacing = replacing.is_some();
        if let Some(file) = replacing {
            file.sync_all()?;
        }
        let mut all = unfinished();
        let Some(path) = self.0.take() else { return Ok(()) };
        all.remove(&path.to_path_buf());
        path.persist(target).map_err(|error| error.error)?;
        if is_replacing {
            files::sync_folder(files::folder_of(target));
        }
        Ok(())
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        if let Some(path) = self.0.take() {
            let mut all = unfinished();
            all.remove(&path.to_path_buf());
            drop(path);
        }
    }
}

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes them all; there are no new ones while the guard that it gives is held.
fn remove_unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    let all = unfinished();
    for path in all.iter() {
        // What cannot be removed is not missed by an output file.
        let _ = files::remove(path);
    }
    all
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
