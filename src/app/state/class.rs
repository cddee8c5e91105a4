//! The answers of a class in the window: the links that were pasted or followed, and the name of the pupil
//! at this window.

use crate::lesson::class::Collected;

/// A command about answers that are handed in.
#[derive(Debug, Clone, PartialEq)]
pub enum ClassCommand {
    /// Sets the name or sign of the pupil at this window.
    Name(String),
    /// Sets the text whose links are read.
    Text(String),
}

/// Answers that are handed in. They last as long as the window: names of pupils are kept nowhere.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ClassAnswers {
    /// Name or sign of the pupil at this window; may be empty.
    pub name: String,
    /// The text whose links are read.
    pub(in crate::app) text: String,
    /// The answers in that text.
    pub(in crate::app) collected: Collected,
    /// The token of the link that was followed last.
    pub(in crate::app) followed: Option<String>,
}
