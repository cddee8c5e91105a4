//! Whether standard output leads anywhere.
//!
//! The language opens `/dev/null`, for reading and writing, in place of a standard stream that is closed at
//! the start, so that all that is written there seems to succeed. Some programs open it in the same way to
//! throw away what another says; a shell opens it for writing alone. So one that leads nowhere is remarked
//! on, and is no failure.
#![expect(clippy::disallowed_methods, reason = "what the system tells of a process is in files")]

use std::path::Path;

/// Whether standard output was closed when the program started, or is thrown away in the same way. Where the
/// system does not tell, it was not.
#[must_use]
pub fn is_stdout_closed() -> bool {
    /// Bits that describe what a file is open for, and those of both.
    const FOR: [u32; 2] = [0o3, 0o2];
    let told = std::fs::read_to_string("/proc/self/fdinfo/1").unwrap_or_default();
    let flags = told.lines().find_map(|line| line.strip_prefix("flags:"));
    let flags = flags.and_then(|flags| u32::from_str_radix(flags.trim(), 8).ok());
    flags.is_some_and(|flags| flags & FOR[0] == FOR[1])
        && std::fs::read_link("/proc/self/fd/1").is_ok_and(|file| file == Path::new("/dev/null"))
}
