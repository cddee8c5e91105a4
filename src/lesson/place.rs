//! A place in a lesson.

use serde::{Deserialize, Serialize};

/// How far somebody is in a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Phase {
    /// Its text is read, and its prediction is made.
    Ask,
    /// What was predicted is shown, and compared.
    Shown,
    /// It is explained.
    Explained,
}

/// A place in a lesson. After its last step comes the sentence to take away.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Place {
    /// The number of the step.
    pub step: usize,
    /// How far in it.
    pub phase: Phase,
}

impl Place {
    /// The beginning.
    pub const START: Self = Self { step: 0, phase: Phase::Ask };
}
