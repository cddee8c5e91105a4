//! Paths of files: how messages show them, and the folders they are in.

use std::path::Path;

use crate::messages;

/// `path` as messages name it: on one line, with nothing in it that a terminal would obey. What is neither
/// text nor fit to be shown stands as its escape.
#[must_use]
pub fn shown(path: &Path) -> String {
    let mut shown = String::new();
    for chunk in path.as_os_str().as_encoded_bytes().utf8_chunks() {
        shown.push_str(&messages::shown(chunk.valid()));
        shown.extend(chunk.invalid().iter().map(|byte| format!("\\x{byte:02x}")));
    }
    shown
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
