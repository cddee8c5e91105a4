//! Locks on files, by which copies of the program that run at the same time know of each other. The system
//! gives a lock back when its program ends, however it ends.
#![expect(clippy::disallowed_methods, reason = "locks are on files")]

use std::fs::{File, OpenOptions, TryLockError};
use std::io;
use std::path::Path;

/// A lock that is held until it is dropped.
#[derive(Debug)]
pub struct Lock(#[expect(dead_code, reason = "the system ties the lock to the open file")] File);

/// Takes the lock on the file at `path`, which is created if it is missing; `None` if another program holds
/// it. The file system may have no locks: then everybody gets one.
///
/// # Errors
/// A file that cannot be opened.
pub fn try_lock(path: &Path) -> io::Result<Option<Lock>> {
    let file = OpenOptions::new().write(true).create(true).truncate(false).open(path)?;
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => Ok(None),
        Ok(()) | Err(TryLockError::Error(_)) => Ok(Some(Lock(file))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_has_one_holder_and_is_given_back() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.lock");
        let first = try_lock(&path).expect("it can be opened").expect("nobody holds it");
        assert!(try_lock(&path).expect("it can be opened").is_none());
        drop(first);
        assert!(try_lock(&path).expect("it can be opened").is_some());
        assert!(try_lock(&folder.path().join("missing/a.lock")).is_err());
    }
}
