//! Locks between copies of the program: a browser has none for pages, so each gets one.

use std::io;
use std::path::Path;
use std::time::Duration;

/// A lock that is held until it is dropped.
#[derive(Debug)]
pub struct Lock(());

/// Takes a lock, which nobody else can hold.
///
/// # Errors
/// None.
pub fn try_lock(_: &Path) -> io::Result<Option<Lock>> {
    Ok(Some(Lock(())))
}

/// Takes a lock at once, since nobody else can hold it.
///
/// # Errors
/// None.
pub fn lock(_: &Path, _: Duration) -> io::Result<Lock> {
    Ok(Lock(()))
}
