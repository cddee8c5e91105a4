//! How many of somebody's predictions were right.

use super::answer::Outcome;
use super::course::Course;

/// What became of the predictions of a lesson that are right or wrong: choices and numbers.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Score {
    /// How many were asked for and made or skipped.
    pub asked: usize,
    /// How many were right.
    pub right: usize,
    /// How many were skipped.
    pub skipped: usize,
}

impl Course {
    /// How many of the predictions so far were right. Hands that were counted, places and curves are neither.
    #[must_use]
    pub fn score(&self) -> Score {
        let mut score = Score::default();
        for (step, record) in self.lesson().steps.iter().zip(self.records()) {
            let Some((prediction, outcome)) = step.prediction.as_ref().zip(record.outcome.as_ref()) else {
                continue;
            };
            let is_right = match outcome {
                Outcome::Skipped => None,
                Outcome::Made { answer, .. } => match answer.is_right(&prediction.kind) {
                    Some(is_right) => Some(is_right),
                    None => continue,
                },
            };
            score.asked += 1;
            score.right += usize::from(is_right == Some(true));
            score.skipped += usize::from(is_right.is_none());
        }
        score
    }
}
