//! Output files that are written whole or not at all, and standard output as the alternative.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};

use anyhow::Context as _;

const BUFFER_BYTES: usize = 1 << 16;

/// Hands a writer for `path`, or for standard output if that is `None` or `-`, to `write`.
///
/// # Errors
///
/// Those of `write`, and of the file system. A file is then left as it was; standard output keeps what
/// reached it before.
pub fn write_to(
    path: Option<&Path>,
    write: impl FnOnce(&mut dyn Write) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    match path {
        Some(path) if path != Path::new("-") => write_whole(path, |file| write(file)),
        _ => {
            let mut stdout = BufWriter::with_capacity(BUFFER_BYTES, io::stdout().lock());
            write(&mut stdout)?;
            Ok(stdout.flush()?)
        }
    }
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
    let name = || path.display().to_string();
    if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
        let mut device = BufWriter::with_capacity(BUFFER_BYTES, File::create(path).with_context(name)?);
        write(&mut device)?;
        return device.flush().with_context(name);
    }
    // A link stays a link: what it points to is replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    catch_interrupts();
    let temporary = file_builder().tempfile_in(folder_of(&target)).with_context(name)?;
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

/// Temporary files that get the permissions any new file would.
fn file_builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".gamow-").suffix(".tmp");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        builder.permissions(fs::Permissions::from_mode(0o666)); // less the umask
    }
    builder
}

/// Temporary files that are being written.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Exit status after an interrupt, as shells have it.
const INTERRUPTED: i32 = 130;

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

fn catch_interrupts() {
    static HANDLER: Once = Once::new();
    // Where no handler can be set, an interrupt ends the program as ever.
    HANDLER.call_once(|| drop(ctrlc::set_handler(remove_unfinished)));
}

/// Ends the program without a trace of unfinished files.
fn remove_unfinished() {
    for path in unfinished().iter() {
        // What cannot be removed is not missed by an output file.
        let _ = fs::remove_file(path);
    }
    std::process::exit(INTERRUPTED);
}
