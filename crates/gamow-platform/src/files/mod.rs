//! Files, and what may be done with them: those of the file system, or in a browser those that were dropped,
//! written or kept.

#[cfg(feature = "desktop")]
mod native;
mod paths;
#[cfg(not(feature = "desktop"))]
mod web;

use std::io;
use std::path::Path;

#[cfg(feature = "desktop")]
pub use native::*;
pub use paths::{folder_of, shown};
#[cfg(not(feature = "desktop"))]
pub use web::*;

use super::sizes;

/// The text in the file at `path`, of [`sizes::TEXT_BYTES`] at most.
pub fn read_to_string(path: &Path) -> io::Result<String> {
    let not_text = |_| io::Error::new(io::ErrorKind::InvalidData, "it is not text in UTF-8");
    String::from_utf8(read(path, sizes::TEXT_BYTES)?).map_err(not_text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_without_an_end_is_refused() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.toml");
        std::fs::write(&path, "four").expect("it is written");
        assert_eq!(read(&path, 4).expect("it is short enough"), b"four");
        let problem = read(&path, 3).expect_err("it is longer").to_string();
        assert_eq!(problem, "it is longer than 0 MB, the limit for such a file");
        std::fs::write(&path, b"\xff").expect("it is written");
        assert_eq!(read_to_string(&path).expect_err("no text").to_string(), "it is not text in UTF-8");
    }

    /// A file of the kernel's log, which only some users may read, and which gives nothing more once all was
    /// read.
    #[cfg(target_os = "linux")]
    #[test]
    fn what_says_nothing_yet_is_not_waited_for() {
        let (sender, told) = std::sync::mpsc::channel();
        std::thread::spawn(move || sender.send(read_to_string(Path::new("/proc/kmsg"))));
        let problem = told.recv_timeout(std::time::Duration::from_secs(20)).expect("it does not wait");
        let problem = problem.expect_err("it has no end");
        let right = "what it says is yet to come; an ordinary file would be right";
        assert!(problem.to_string() == right || problem.raw_os_error().is_some(), "{problem}");
        assert!(read_to_string(Path::new("/proc/self/status")).expect("it has an end").contains("Name:"));
    }
}
