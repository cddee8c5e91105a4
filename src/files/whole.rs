//! Output files that are written whole or not at all, and standard output as the alternative.

use std::collections::BTreeSet;
use std::fmt;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use anyhow::Context as _;
use clap::Args;
use serde::Serialize;

use crate::platform::files::{self, File};
use crate::platform::interrupt;

const BUFFER_BYTES: usize = 1 << 16;

/// Where a command writes to.
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
/// Those of `write`, and of standard output, which keeps what reached it before.
pub fn write_out(write: impl FnOnce(&mut dyn Write) -> anyhow::Result<()>) -> anyhow::Result<()> {
    let mut stdout = BufWriter::with_capacity(BUFFER_BYTES, io::stdout().lock());
    write(&mut stdout)?;
    Ok(stdout.flush()?)
}

/// How a command writes its report, and where to.
#[derive(Debug, Clone, Args)]
pub struct ReportArgs {
    /// Write JSON instead of a table.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    out: OutArgs,
}

impl ReportArgs {
    /// Writes `report`.
    ///
    /// # Errors
    ///
    /// As [`OutArgs::write`].
    pub fn write(&self, report: &(impl fmt::Display + Serialize)) -> anyhow::Result<()> {
        self.out.write(|out| if self.json { write_json(report, out) } else { Ok(write!(out, "{report}")?) })
    }
}

/// Refuses a `path`, given by `flag`, whose name does not end in `.ending`, and says which one would be right: its name is
/// to tell what a file holds. Devices are called as they are.
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
    serde_json::to_writer_pretty(&mut out, report)?;
    Ok(writeln!(out)?)
}

/// Hands `write` a temporary file beside `path`, which takes the place of `path` once all is written. An interrupt
/// (Ctrl-C) removes it.
///
/// A `path` that is there but is no regular file, such as /dev/null or a named pipe, is written to
/// directly: to replace it would not be what was asked for.
///
/// # Errors
///
/// Those of `write`, and of the file system; `path` is then left as it was.
pub fn write_whole(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    let name = || files::shown(path);
    if files::is_special(path) {
        let mut device = BufWriter::with_capacity(BUFFER_BYTES, files::create(path).with_context(name)?);
        write(&mut device)?;
        return device.flush().with_context(name);
    }
    // A link stays a link: what it points to is replaced.
    let target = files::canonical(path).unwrap_or_else(|_| path.to_owned());
    interrupt::end_after(remove_unfinished);
    let temporary = files::temporary_in(&folder_of(&target)).with_context(name)?;
    let (file, temporary) = temporary.into_parts();
    let _unfinished = Unfinished::new(&temporary);
    let mut file = BufWriter::with_capacity(BUFFER_BYTES, file);
    write(&mut file)?;
    file.flush().with_context(name)?;
    drop(file);
    temporary.persist(&target).with_context(name)
}

fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// Temporary files that are being written.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// A temporary file that goes when the program is interrupted.
struct Unfinished(PathBuf);

impl Unfinished {
    fn new(path: &Path) -> Self {
        unfinished().insert(path.to_owned());
        Self(path.to_owned())
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        unfinished().remove(&self.0);
    }
}

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

fn remove_unfinished() {
    for path in unfinished().iter() {
        // What cannot be removed is not missed by an output file.
        let _ = files::remove(path);
    }
}
