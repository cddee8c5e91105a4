//! The sequence that a presenter goes through.

use std::sync::Arc;

use crate::lesson::{Sequence, SequenceEntry};

/// A sequence, and the entry that is shown.
#[derive(Debug, Clone, PartialEq)]
pub struct RunningSequence {
    /// The sequence as it was read.
    pub sequence: Arc<Sequence>,
    /// Number of the present entry, from 0.
    pub at: usize,
}

impl RunningSequence {
    /// Returns the present entry.
    #[must_use]
    pub fn entry(&self) -> Option<&SequenceEntry> {
        self.sequence.entry(self.at)
    }

    /// Says which entry of how many is shown.
    #[must_use]
    pub fn place(&self) -> String {
        format!("{} of {}", self.at + 1, self.sequence.count())
    }
}
