//! A place in a lesson.

use serde::{Deserialize, Serialize};

/// The phase of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Phase {
    /// The text is read, and the prediction is made.
    Ask,
    /// The outcome is shown, and compared.
    Shown,
    /// What was said and seen is compared with the truth, and explained.
    Explained,
}

/// A place in a lesson. After its last step comes the sentence to take away.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Place {
    /// Index of the step, from 0; the number of steps after the last.
    pub step: usize,
    /// How far the step has gone.
    pub phase: Phase,
}

impl Place {
    /// The beginning of a lesson.
    pub const START: Self = Self { step: 0, phase: Phase::Ask };
}
