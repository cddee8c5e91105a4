//! Whether standard output was closed by who started this program.
//!
//! The language opens `/dev/null`, for reading and writing, in place of a standard stream that is closed at the start, so that
//! all that is written there would seem to succeed. Others open it in the same way to throw away what is said: these have it
//! open themselves, then, or had it thrown away themselves.
#![expect(clippy::disallowed_methods, reason = "what the system tells of processes is in files")]

use std::path::Path;

/// Whether it was closed. Where the system does not tell, it was not.
#[must_use]
pub fn is_stdout_closed() -> bool {
    #[cfg(unix)]
    {
        let starter = format!("/proc/{}", std::os::unix::process::parent_id());
        has_opened_null(Path::new("/proc/self"), "1")
            && std::fs::read_dir(Path::new(&starter).join("fd")).is_ok_and(|open| {
                let mut names = open.flatten().filter_map(|entry| entry.file_name().into_string().ok());
                // Its own input says nothing of what becomes of output.
                !names.any(|name| name != "0" && has_opened_null(Path::new(&starter), &name))
            })
    }
    #[cfg(not(unix))]
    false
}

/// Whether a `process` has `/dev/null` open for reading and writing under this number.
#[cfg(unix)]
fn has_opened_null(process: &Path, number: &str) -> bool {
    /// The bits that tell what it is open for, and those of both.
    const FOR: [u32; 2] = [0o3, 0o2];
    let told = std::fs::read_to_string(process.join("fdinfo").join(number)).unwrap_or_default();
    let flags = told.lines().find_map(|line| line.strip_prefix("flags:"));
    let flags = flags.and_then(|flags| u32::from_str_radix(flags.trim(), 8).ok());
    flags.is_some_and(|flags| flags & FOR[0] == FOR[1])
        && std::fs::read_link(process.join("fd").join(number))
            .is_ok_and(|file| file == Path::new("/dev/null"))
}
