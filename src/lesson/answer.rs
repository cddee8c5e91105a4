//! An answer to a question: the prediction, and its outcome.

use relativity_render::Gaze;
use serde::{Deserialize, Serialize};

use super::plan::{AnswerKind, Number};

/// A prediction of any kind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Answer {
    /// Index of a choice, from 0.
    Choice(usize),
    /// Number of raised hands for each choice.
    Votes(Vec<u32>),
    /// A number in the unit of the question; not finite while none is entered.
    Number(f64),
    /// A direction in which the left eye would look there.
    Direction(Gaze),
    /// A curve: T and value of its points, T rising.
    Curve(Vec<[f64; 2]>),
}

impl Answer {
    /// Returns whether anything has been entered.
    #[must_use]
    pub fn is_entered(&self) -> bool {
        match self {
            Self::Choice(_) | Self::Direction(_) => true,
            Self::Votes(votes) => votes.iter().any(|votes| *votes > 0),
            Self::Number(number) => number.is_finite(),
            Self::Curve(points) => points.len() >= 2,
        }
    }

    /// Whether the answer is right, where that is known without what is seen.
    #[must_use]
    pub fn is_right(&self, kind: &AnswerKind) -> Option<bool> {
        match (self, kind) {
            (Self::Choice(choice), AnswerKind::Choice(options)) => Some(*choice == options.right),
            (Self::Number(number), AnswerKind::Number(asked)) => asked.is_met_by(*number),
            _ => None,
        }
    }

    /// Returns whether the answer suits a question of this kind.
    #[must_use]
    pub fn fits(&self, kind: &AnswerKind) -> bool {
        match (self, kind) {
            (Self::Choice(choice), AnswerKind::Choice(options)) => *choice < options.texts.len(),
            (Self::Votes(votes), AnswerKind::Choice(options)) => votes.len() == options.texts.len(),
            (Self::Number(_), AnswerKind::Number(_))
            | (Self::Direction(_), AnswerKind::Point(_))
            | (Self::Curve(_), AnswerKind::Curve(_)) => true,
            _ => false,
        }
    }
}

impl Number {
    /// Whether `number` is near enough to the truth, once that is worked out.
    #[must_use]
    pub fn is_met_by(&self, number: f64) -> Option<bool> {
        Some((number - self.truth?).abs() <= self.within * self.truth?.abs())
    }
}

/// The outcome of a prediction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Outcome {
    /// No prediction was made.
    Skipped,
    /// A prediction was made.
    Made {
        /// Prediction that was made.
        answer: Answer,
        /// Confidence in the answer, if given.
        confidence: Option<Confidence>,
    },
}

/// Degree of confidence in a prediction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "u8", into = "u8")]
pub enum Confidence {
    /// A guess, the lowest degree.
    Guess,
    /// Fairly sure, the middle degree.
    FairlySure,
    /// Sure, the highest degree.
    Sure,
}

impl Confidence {
    /// The three degrees, lowest first.
    pub const ALL: [Self; 3] = [Self::Guess, Self::FairlySure, Self::Sure];

    /// Returns the degree's name on its button and in a report.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Guess => "a guess",
            Self::FairlySure => "fairly sure",
            Self::Sure => "sure",
        }
    }
}

/// Files of answers have a scale from 1 to 5, of which earlier versions offered every number.
impl From<u8> for Confidence {
    fn from(number: u8) -> Self {
        match number {
            0..=2 => Self::Guess,
            3 => Self::FairlySure,
            4.. => Self::Sure,
        }
    }
}

impl From<Confidence> for u8 {
    fn from(confidence: Confidence) -> Self {
        match confidence {
            Confidence::Guess => 1,
            Confidence::FairlySure => 3,
            Confidence::Sure => 5,
        }
    }
}

/// The record of a step.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Outcome of the prediction, once the reveal has been opened.
    pub outcome: Option<Outcome>,
    /// The number of the answer to what was seen.
    pub observed: Option<usize>,
}

impl Record {
    /// The prediction that was made, if one was.
    #[must_use]
    pub const fn answer(&self) -> Option<&Answer> {
        match &self.outcome {
            Some(Outcome::Made { answer, .. }) => Some(answer),
            Some(Outcome::Skipped) | None => None,
        }
    }
}
