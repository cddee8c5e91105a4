//! The file system.
#![expect(clippy::disallowed_methods, clippy::disallowed_types, reason = "this is where files are reached")]

use std::error::Error;
use std::io;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

pub use std::fs::File;

/// `path` as messages name it: on one line, with nothing in it that a terminal would obey. What is neither text nor fit
/// to be shown stands as its escape.
#[must_use]
pub fn shown(path: &Path) -> String {
    let mut shown = String::new();
    for chunk in path.as_os_str().as_encoded_bytes().utf8_chunks() {
        chunk.valid().chars().for_each(|c| match c {
            // Marks that turn the direction of text about, or end a line without being control characters.
            '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => {
                shown.extend(c.escape_unicode());
            }
            c if c.is_control() => shown.extend(c.escape_default()),
            c => shown.push(c),
        });
        shown.extend(chunk.invalid().iter().map(|byte| format!("\\x{byte:02x}")));
    }
    shown
}

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

/// Gives what is at `from` the name `to`; what was there is lost.
pub fn rename(from: &Path, to: &Path) -> io::Result<()> {
    std::fs::rename(from, to)
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
    builder.tempfile_in(folder).map_err(without_path)
}

/// What is wrong, without the name of a temporary file: nobody asked for that.
fn without_path(error: io::Error) -> io::Error {
    let cause = error.get_ref().and_then(Error::source).and_then(|cause| cause.downcast_ref::<io::Error>());
    cause.and_then(io::Error::raw_os_error).map_or(error, io::Error::from_raw_os_error)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_shown_on_one_line_without_anything_a_terminal_obeys() {
        for name in ["räder 車輪.toml", r"C:\scenes\a.toml", "it's.csv"] {
            assert_eq!(shown(Path::new(name)), name);
        }
        assert_eq!(shown(Path::new("a\u{1b}[31m\nb\u{202e}.toml")), r"a\u{1b}[31m\nb\u{202e}.toml");
    }

    #[cfg(unix)]
    #[test]
    fn names_that_are_no_text_are_told_by_their_bytes() {
        use std::os::unix::ffi::OsStrExt as _;
        assert_eq!(shown(Path::new(std::ffi::OsStr::from_bytes(b"r\xff.csv"))), r"r\xff.csv");
    }
}
