//! What can be wrong in a file.

/// The line in which it is, from 1, and what it is.
pub type Wrong = (usize, String);
