//! Errors in the file of a lesson.

/// The line in which it is, from 1, and what it is.
pub type Wrong = (usize, String);
