//! Errors of lessons, each in one line.

use gamow_platform::messages;
use thiserror::Error;

/// A lesson, or a sequence of lessons and states, that cannot be had.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum LessonError {
    /// The file, or the folder, could not be read.
    #[error("{source_name}: cannot read this {what}: {reason}")]
    Read {
        /// The file, as it was named.
        source_name: String,
        /// The contents that it should have.
        what: &'static str,
        /// Reason why it cannot be read.
        reason: String,
    },
    /// Neither the name of a lesson nor a path.
    #[error(
        "no lesson is called `{}`{meant}: there are {known}; for a file, give its name with its ending",
        messages::excerpt(name)
    )]
    Unknown {
        /// Name that was given.
        name: String,
        /// The question for the lesson or preset of nearly this name, if there is one.
        meant: String,
        /// The names of all lessons.
        known: String,
    },
    /// A problem in the lesson's text.
    #[error("{source_name}:{line}: {problem}")]
    Content {
        /// The file, as it was named.
        source_name: String,
        /// The line in the file, from 1.
        line: usize,
        /// Problem in that line, and its correction.
        problem: String,
    },
    /// Settings in it that cannot be had; they name file and line.
    #[error("{0}")]
    Settings(String),
}
