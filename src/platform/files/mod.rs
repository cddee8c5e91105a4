//! Files, and what may be done with them: those of the file system, or in a browser those that were dropped, written or kept.

#[cfg(feature = "desktop")]
mod native;
#[cfg(not(feature = "desktop"))]
mod web;

use std::io;
use std::path::Path;

#[cfg(feature = "desktop")]
pub use native::*;
#[cfg(not(feature = "desktop"))]
pub use web::*;

use super::{messages, sizes};

/// `path` as messages name it: on one line, with nothing in it that a terminal would obey. What is neither text nor fit
/// to be shown stands as its escape.
#[must_use]
pub fn shown(path: &Path) -> String {
    let mut shown = String::new();
    for chunk in path.as_os_str().as_encoded_bytes().utf8_chunks() {
        shown.push_str(&messages::shown(chunk.valid()));
        shown.extend(chunk.invalid().iter().map(|byte| format!("\\x{byte:02x}")));
    }
    shown
}

/// The text in the file at `path`, of [`sizes::TEXT_BYTES`] at most.
pub fn read_to_string(path: &Path) -> io::Result<String> {
    let not_text = |_| io::Error::new(io::ErrorKind::InvalidData, "it is no text in UTF-8");
    String::from_utf8(read(path, sizes::TEXT_BYTES)?).map_err(not_text)
}

/// The folder that `path` is in.
#[must_use]
pub fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."))
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
