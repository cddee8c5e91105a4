//! The file system of the desktop, and what may be done in it.
#![expect(clippy::disallowed_methods, clippy::disallowed_types, reason = "this is where files are reached")]

use std::fs::OpenOptions;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::paths::folder_of;
use crate::names;

pub use std::fs::File;
pub use tempfile::{TempDir, TempPath};

/// Whether there are folders.
pub const HAS_FOLDERS: bool = true;

/// A regular file that is read. To read it never waits for anybody.
#[derive(Debug)]
pub struct Regular(File);

impl Read for Regular {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.0.read(buffer).map_err(|error| match error.kind() {
            // Some that the system calls regular are none, such as /proc/kmsg.
            io::ErrorKind::WouldBlock => irregular("what it says is yet to come"),
            _ => error,
        })
    }
}

impl Seek for Regular {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.0.seek(to)
    }
}

/// The error of what is no regular file, but `what` it is.
fn irregular(what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, format!("{what}; an ordinary file would be right"))
}

/// Refuses what is `found` in place of a regular file. For a folder the system's own error is enough.
fn check_regular(found: &std::fs::Metadata) -> io::Result<()> {
    if found.is_file() || found.is_dir() { Ok(()) } else { Err(irregular("it is a device or a pipe")) }
}

/// Returns options that open a file without waiting for the other end.
#[cfg(unix)]
fn at_once() -> OpenOptions {
    use nix::libc;
    use std::os::unix::fs::OpenOptionsExt as _;
    let mut options = OpenOptions::new();
    options.custom_flags(libc::O_NONBLOCK | libc::O_NOCTTY);
    options
}

/// Returns options that open a file without waiting: only names that [`names::is_device`] knows would be
/// waited for.
#[cfg(not(unix))]
fn at_once() -> OpenOptions {
    OpenOptions::new()
}

/// The regular file at `path`, to be read.
///
/// # Errors
///
/// Those of the file system, as everywhere here. What is no regular file: a device is not even opened, and a
/// pipe is not waited for.
pub fn open(path: &Path) -> io::Result<Regular> {
    if cfg!(windows) && names::is_device(&path.to_string_lossy()) {
        return Err(irregular("it is the name of a device"));
    }
    check_regular(&path.metadata()?)?;
    let file = at_once().read(true).open(path)?;
    // By now there may be something else.
    check_regular(&file.metadata()?)?;
    Ok(Regular(file))
}

/// Opens `path` for reading from its beginning to its end: also a pipe or a terminal, for whose other end it
/// waits, as a reader should.
pub fn open_stream(path: &Path) -> io::Result<Box<dyn Read>> {
    let found = path.metadata()?;
    if found.is_file() || found.is_dir() {
        return Ok(Box::new(open(path)?));
    }
    Ok(Box::new(File::open(path)?))
}

/// Opens what is at `path` and no regular file for writing. A pipe waits for its reader, as in a shell.
pub fn open_special(path: &Path) -> io::Result<File> {
    File::create(path)
}

/// Refuses a place for a file that a device or a pipe takes.
pub fn check_replaceable(path: &Path) -> io::Result<()> {
    path.metadata().map_or(Ok(()), |found| check_regular(&found))
}

/// The bytes of the file at `path`, of which there must be no more than `most`: a longer one is refused, be
/// it one that grows as it is read.
pub fn read(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let mut file = open(path)?;
    let size = file.0.metadata()?.len();
    let mut bytes = Vec::new();
    if size <= most {
        bytes.reserve_exact(size as usize + 1);
        (&mut file).take(most + 1).read_to_end(&mut bytes)?;
    }
    if size.max(bytes.len() as u64) > most {
        let problem = format!("it is longer than {} MB, the limit for such a file", most >> 20);
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, problem));
    }
    Ok(bytes)
}

/// Files in a message to another instance of the program: where each was, and its bytes.
pub type Sent = Vec<(PathBuf, Vec<u8>)>;

/// Returns the files that only this instance has: none.
#[must_use]
pub const fn given() -> Sent {
    Vec::new()
}

/// Takes in the files that only another instance has: there are none.
pub fn take_in_all(_: Sent) {}

/// Returns the files that were written and are nowhere yet: none.
#[must_use]
pub const fn take_undelivered() -> Sent {
    Vec::new()
}

/// Makes the folder `path` and those around it, unless they are there.
pub fn create_folder(path: &Path) -> io::Result<()> {
    std::fs::create_dir_all(path)
}

/// Returns the paths in the folder `path`, in alphabetical order.
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

/// The stamp by which a change of a file is noticed: its time of writing, and its length.
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

/// Returns the file that writing to `path` replaces: the file there, or behind the links there, even if it is
/// not there yet.
pub fn behind_links(path: &Path) -> io::Result<PathBuf> {
    match path.canonicalize() {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {}
        found => return found,
    }
    // The system has refused links that lead in a circle already.
    let mut place = path.to_owned();
    while let Ok(next) = std::fs::read_link(&place) {
        place = folder_of(&place).join(next);
    }
    Ok(place)
}

/// The name by which a file in `folder` calls that at `path`, for whoever has both: the way down from the
/// folder, or from the one around it to itself or the folders in it. A longer way would tell where the files
/// of their owner lie: then it is the name alone, and so it is where there is no such file. `None` if it is
/// not UTF-8.
#[must_use]
pub fn name_from(folder: &Path, path: &Path) -> Option<String> {
    let near = || {
        let (folder, path) = (folder.canonicalize().ok()?, path.canonicalize().ok()?);
        if let Ok(below) = path.strip_prefix(&folder) {
            return Some(below.to_owned());
        }
        let beside = path.strip_prefix(folder.parent()?).ok()?;
        (beside.components().count() <= 2).then(|| Path::new("..").join(beside))
    };
    let name = near().or_else(|| path.file_name().map(PathBuf::from))?;
    let parts: Option<Vec<_>> = name.components().map(|part| part.as_os_str().to_str()).collect();
    // So that every system can read it.
    Some(parts?.join("/"))
}

/// Flushes the names in the folder `path` to the disc, where the system can. Where it cannot, the old name of
/// a file may come back after a power cut, and the file behind it is whole all the same.
pub fn sync_folder(path: &Path) {
    if cfg!(unix) {
        let _ = File::open(path).and_then(|folder| folder.sync_all());
    }
}

/// The access rights of a file, and its owner.
#[derive(Debug, Clone)]
pub struct Rights(std::fs::Metadata);

impl Rights {
    /// Returns the rights of the file at `path`, `None` if there is no file.
    ///
    /// # Errors
    ///
    /// A file that may not be written to.
    pub fn from_file(path: &Path) -> io::Result<Option<Self>> {
        match at_once().write(true).open(path) {
            Ok(file) => Ok(Some(Self(file.metadata()?))),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Gives them to `file`, as far as the system lets this program: not everybody may give a file away.
    fn give_to(&self, file: &File) -> io::Result<()> {
        #[cfg(unix)]
        {
            use std::os::unix::fs::{MetadataExt as _, fchown};
            let _ = fchown(file, Some(self.0.uid()), Some(self.0.gid()))
                .or_else(|_| fchown(file, None, Some(self.0.gid())));
        }
        file.set_permissions(self.0.permissions())
    }
}

/// A new file of this program in `folder`, which goes when it is dropped. It has these `rights`, or else
/// those that any new file would have.
pub fn temporary_in(folder: &Path, rights: Option<&Rights>) -> io::Result<NamedTempFile> {
    let create = |path: &Path| {
        let mut options = OpenOptions::new();
        options.read(true).write(true).create_new(true);
        #[cfg(unix)]
        if rights.is_some() {
            use std::os::unix::fs::OpenOptionsExt as _;
            options.mode(0o600); // nobody else's until it is known whose it is
        }
        let file = options.open(path)?;
        rights.map_or(Ok(()), |rights| rights.give_to(&file)).map(|()| file)
    };
    tempfile::Builder::new().prefix(".gamow-").suffix(".tmp").make_in(folder, create)
}

/// A new folder among the system's temporary files, which goes with all that is in it when it is dropped.
pub fn temporary_folder() -> io::Result<TempDir> {
    tempfile::Builder::new().prefix("gamow-").tempdir()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn devices_and_pipes_are_no_files_and_are_not_waited_for() {
        let folder = tempfile::tempdir().expect("a folder");
        let pipe = folder.path().join("pipe.toml");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.expect("there is mkfifo").success());
        let link = folder.path().join("link.toml");
        std::os::unix::fs::symlink(&pipe, &link).expect("links work here");
        let (sender, told) = std::sync::mpsc::channel();
        let paths = [pipe, link, "/dev/zero".into(), "/dev/null".into(), "/dev/tty".into()];
        std::thread::spawn(move || {
            for path in paths {
                let problems = [open(&path).map(drop), read(&path, 9).map(drop), check_replaceable(&path)];
                let problems = problems.map(|read| read.expect_err("it is no file").to_string());
                sender.send((path, problems)).expect("it is waited for");
            }
        });
        for _ in 0..5 {
            let (path, problems) =
                told.recv_timeout(std::time::Duration::from_secs(20)).expect("nothing waits");
            for problem in problems {
                assert_eq!(problem, "it is a device or a pipe; an ordinary file would be right", "{path:?}");
            }
        }
    }
}
