//! Which file to open or to write: asked for in a dialog of the system, or typed.

/// What a file is chosen for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Purpose {
    /// To show what is in it.
    Open,
}
