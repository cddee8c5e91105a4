//! Files of a page: those that the user gave it are in memory, and kept by the browser as far as it has room,
//! those in [`KEPT`] are texts that the browser keeps, and all others that are written are downloads.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io::{self, Cursor, Read};
use std::path::{Path, PathBuf};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use crate::web::{download, instances, storage};

/// Whether there are folders.
pub const HAS_FOLDERS: bool = false;

/// The folder of files that are kept from one visit to the next.
pub const KEPT: &str = "gamow";

thread_local!(static GIVEN: RefCell<BTreeMap<PathBuf, Vec<u8>>> = const { RefCell::new(BTreeMap::new()) });

/// A file that is read.
pub type Regular = Cursor<Vec<u8>>;

/// Beginning of the names of given files in the browser's storage.
const OWN: &str = "own/";
/// Letters that these may have together there: of the five million for which browsers have room.
const MOST_OWN: usize = 3_000_000;

/// Takes in a file that the user gave the page: from now on there is one at `path`, on the next visit too if
/// the browser has room for it.
pub fn take_in(path: &Path, bytes: Vec<u8>) {
    keep(path, &bytes);
    GIVEN.with_borrow_mut(|given| given.insert(path.to_owned(), bytes));
}

/// Has the browser keep a given file. Those that were kept before make room for it.
fn keep(path: &Path, bytes: &[u8]) {
    let (name, text) = (own_name(path), STANDARD.encode(bytes));
    storage::remove(&name);
    if text.len() > MOST_OWN {
        return;
    }
    let others: Vec<String> = storage::names().into_iter().filter(|name| name.starts_with(OWN)).collect();
    let taken: usize = others.iter().filter_map(|name| storage::read(name)).map(|text| text.len()).sum();
    if taken + text.len() > MOST_OWN {
        others.iter().for_each(|name| storage::remove(name));
    }
    // A browser that keeps nothing is no reason not to show a file.
    let _ = storage::write(&name, &text);
}

fn own_name(path: &Path) -> String {
    format!("{OWN}{}", path.display())
}

/// The bytes of a file that the user gave the page, on this visit or an earlier one.
fn given_bytes(path: &Path) -> Option<Vec<u8>> {
    GIVEN.with_borrow_mut(|given| {
        if !given.contains_key(path) {
            let bytes = STANDARD.decode(storage::read(&own_name(path))?).ok()?;
            given.insert(path.to_owned(), bytes);
        }
        given.get(path).cloned()
    })
}

/// Files in a message to another instance of the program: where each was, and its bytes.
pub type Sent = Vec<(PathBuf, Vec<u8>)>;

/// Returns the files that the user gave the page, for another instance.
pub fn given() -> Sent {
    for path in storage::names().iter().filter_map(|name| name.strip_prefix(OWN)) {
        let _ = given_bytes(Path::new(path));
    }
    GIVEN.with_borrow(|given| given.iter().map(|(path, bytes)| (path.clone(), bytes.clone())).collect())
}

/// Takes in the files that the user gave the page; the page itself has them.
pub fn take_in_all(files: Sent) {
    if instances::own_kind().is_some() {
        GIVEN.with_borrow_mut(|given| given.extend(files));
    }
}

thread_local!(static UNDELIVERED: RefCell<Sent> = const { RefCell::new(Vec::new()) });

/// Returns the files that were written since the last call and are nowhere yet: those of an instance beside
/// the page, which alone can hand them out.
pub fn take_undelivered() -> Sent {
    UNDELIVERED.take()
}

/// Writes a whole file: into the browser's storage if it is to be kept, else as a download.
///
/// # Errors
/// Those of the browser.
pub fn deliver(path: &Path, bytes: Vec<u8>) -> io::Result<()> {
    if instances::own_kind().is_some() {
        UNDELIVERED.with_borrow_mut(|files| files.push((path.to_owned(), bytes)));
        return Ok(());
    }
    if let Some(name) = kept_name(path) {
        let text = String::from_utf8(bytes).map_err(|_| io::Error::other("it is not text in UTF-8"))?;
        return storage::write(name, &text);
    }
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    download::deliver(&name, media_type(path), &bytes)
}

/// The name under which the browser keeps the file at `path`, if it does.
fn kept_name(path: &Path) -> Option<&str> {
    path.to_str().filter(|_| path.starts_with(KEPT))
}

fn media_type(path: &Path) -> &'static str {
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("png") => "image/png",
        Some("gif") => "image/gif",
        Some("mp4") => "video/mp4",
        Some("svg") => "image/svg+xml",
        Some("csv") => "text/csv",
        Some("html") => "text/html",
        Some("json") => "application/json",
        _ => "application/octet-stream",
    }
}

fn contents(path: &Path) -> Option<Vec<u8>> {
    match kept_name(path) {
        Some(name) => storage::read(name).map(String::into_bytes),
        None => given_bytes(path),
    }
}

/// The file at `path`, to be read.
///
/// # Errors
///
/// There is no such file, as everywhere here.
pub fn open(path: &Path) -> io::Result<Regular> {
    contents(path).map(Cursor::new).ok_or_else(|| io::ErrorKind::NotFound.into())
}

/// Opens `path` for reading from its beginning to its end.
pub fn open_stream(path: &Path) -> io::Result<Box<dyn Read>> {
    Ok(Box::new(open(path)?))
}

/// Refuses no place for a file: a page has no devices.
pub const fn check_replaceable(_: &Path) -> io::Result<()> {
    Ok(())
}

/// The bytes of the file at `path`, of which there must be no more than `most`.
pub fn read(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let bytes = open(path)?.into_inner();
    if bytes.len() as u64 > most {
        let problem = format!("it is longer than {} MB, the limit for such a file", most >> 20);
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, problem));
    }
    Ok(bytes)
}

/// Does nothing: folders are parts of names.
pub const fn create_folder(_: &Path) -> io::Result<()> {
    Ok(())
}

/// Returns the paths in the folder `path`, in alphabetical order.
pub fn list_folder(path: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files: Vec<_> = GIVEN.with_borrow(|given| given.keys().cloned().collect());
    files.extend(storage::names().into_iter().map(PathBuf::from).filter(|file| file.starts_with(KEPT)));
    files.retain(|file| file.parent() == Some(path));
    files.sort();
    Ok(files)
}

/// Whether there is a folder at `path`: never.
#[must_use]
pub const fn is_folder(_: &Path) -> bool {
    false
}

/// Whether there is a file at `path`.
#[must_use]
pub fn is_file(path: &Path) -> bool {
    contents(path).is_some()
}

/// Whether there is anything at `path`.
#[must_use]
pub fn is_there(path: &Path) -> bool {
    is_file(path)
}

/// Whether there is something at `path` that is no regular file: never.
#[must_use]
pub const fn is_special(_: &Path) -> bool {
    false
}

/// Length of the file at `path`, bytes.
pub fn size(path: &Path) -> io::Result<u64> {
    Ok(open(path)?.into_inner().len() as u64)
}

/// `path` as it is. There is no folder that a page is in.
pub fn canonical(path: &Path) -> io::Result<PathBuf> {
    if path == Path::new(".") { Err(io::ErrorKind::NotFound.into()) } else { Ok(path.to_owned()) }
}

/// Gives what is at `from` the name `to`; what was there is lost.
pub fn rename(from: &Path, to: &Path) -> io::Result<()> {
    let bytes = open(from)?.into_inner();
    match kept_name(from) {
        Some(name) => storage::remove(name),
        None => drop(GIVEN.with_borrow_mut(|given| given.remove(from))),
    }
    deliver(to, bytes)
}

/// Returns the name by which a file in some folder calls that at `path`: the name alone.
#[must_use]
pub fn name_from(_: &Path, path: &Path) -> Option<String> {
    path.file_name()?.to_str().map(str::to_owned)
}
