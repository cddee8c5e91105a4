//! What the user is told about the last thing that was done, or could not be.

/// A message. It stays until it is closed or another takes its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Notice {
    /// A sentence, without line breaks.
    pub text: String,
    /// Whether something could not be done.
    pub is_error: bool,
}

impl Notice {
    /// That something was done.
    pub fn done(text: impl Into<String>) -> Self {
        Self { text: text.into(), is_error: false }
    }

    /// That something could not be done, and why.
    #[expect(clippy::needless_pass_by_value, reason = "errors are given away as they are")]
    pub fn error(error: impl ToString) -> Self {
        Self { text: error.to_string(), is_error: true }
    }
}
