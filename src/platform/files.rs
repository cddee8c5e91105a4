//! The file system.
#![expect(clippy::disallowed_methods, clippy::disallowed_types, reason = "this is where files are reached")]

use std::io;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

pub use std::fs::File;

/// The file at `path`, to be read.
///
/// # Errors
///
/// Those of the file system, as everywhere here.
pub fn open(path: &Path) -> io::Result<File> {
    File::open(path)
}

/// The file at `path`, to be written; what it held is lost.
pub fn create(path: &Path) -> io::Result<File> {
    File::create(path)
}

/// The bytes of the file at `path`.
pub fn read(path: &Path) -> io::Result<Vec<u8>> {
    std::fs::read(path)
}

/// The text in the file at `path`.
pub fn read_to_string(path: &Path) -> io::Result<String> {
    std::fs::read_to_string(path)
}

/// Makes the folder `path` and those around it, unless they are there.
pub fn create_folder(path: &Path) -> io::Result<()> {
    std::fs::create_dir_all(path)
}

/// What is in the folder `path`, in alphabetical order.
pub fn list_folder(path: &Path) -> io::Result<Vec<PathBuf>> {
    let mut inside =
        std::fs::read_dir(path)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    inside.sort();
    Ok(inside)
}

/// Whether there is a folder at `path`.
#[must_use]
pub fn is_folder(path: &Path) -> bool {
    path.is_dir()
}

/// Whether there is a regular file at `path`.
#[must_use]
pub fn is_file(path: &Path) -> bool {
    path.is_file()
}

/// Whether there is anything at `path`.
#[must_use]
pub fn is_there(path: &Path) -> bool {
    path.exists()
}

/// Whether there is something at `path` that is no regular file, such as a device or a named pipe.
#[must_use]
pub fn is_special(path: &Path) -> bool {
    path.metadata().is_ok_and(|found| !found.is_file())
}

/// Length of the file at `path`, bytes.
pub fn size(path: &Path) -> io::Result<u64> {
    Ok(path.metadata()?.len())
}

/// What tells that a file has changed: when it was written, and how long it is.
pub type Stamp = (std::time::SystemTime, u64);

/// The stamp of the file at `path`; none if it cannot be had.
#[must_use]
pub fn stamp(path: &Path) -> Option<Stamp> {
    let found = path.metadata().ok()?;
    Some((found.modified().ok()?, found.len()))
}

/// `path` without links in it.
pub fn canonical(path: &Path) -> io::Result<PathBuf> {
    path.canonicalize()
}

/// Removes the file at `path`.
pub fn remove(path: &Path) -> io::Result<()> {
    std::fs::remove_file(path)
}

/// A new file of this program in `folder`, which goes when it is dropped. It has the permissions that any new file
/// would have.
pub fn temporary_in(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".gamow-").suffix(".tmp");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        builder.permissions(std::fs::Permissions::from_mode(0o666)); // less the umask
    }
    builder.tempfile_in(folder)
}
