//! Counts of the right predictions of one question, by the confidence of the pupils.

use std::fmt::Write as _;

use crate::lesson::answer::{Answer, Confidence, Outcome, Record};
use crate::lesson::plan::{AnswerKind, Prediction, Step};
use crate::lesson::truth::Sight;
use crate::lesson::verdict::verdict;

/// The judgement of one pupil's prediction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Judgement {
    /// No prediction: none was asked for, or the question was not reached.
    Missing,
    /// The prediction was skipped.
    Skipped,
    /// The prediction is right.
    Right,
    /// The prediction is not right.
    Wrong,
    /// A prediction that is neither right nor wrong, as a curve or raised hands.
    Neither,
}

impl Judgement {
    /// The judgement of the prediction of `step` in its `record`. Of a place it takes what is seen after the
    /// reveal.
    pub fn new(step: &Step, record: &Record, sight: Option<&Sight<'_>>) -> Self {
        let Some((Prediction { kind, .. }, outcome)) = step.prediction.as_ref().zip(record.outcome.as_ref())
        else {
            return Self::Missing;
        };
        let Outcome::Made { answer, .. } = outcome else { return Self::Skipped };
        let right = match (kind, sight) {
            (AnswerKind::Point(_), Some(sight)) => {
                verdict(step, record, sight).and_then(|verdict| verdict.right)
            }
            _ => answer.is_right(kind),
        };
        match right {
            Some(true) => Self::Right,
            Some(false) => Self::Wrong,
            None => Self::Neither,
        }
    }

    /// Returns the mark in the table of pupils.
    pub const fn mark(self) -> &'static str {
        match self {
            Self::Missing => "",
            Self::Skipped => "–",
            Self::Right => "✓",
            Self::Wrong => "✗",
            Self::Neither => "·",
        }
    }
}

/// The count of the predictions of one question.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Tally {
    /// Number of predictions that are right or wrong.
    pub judged: usize,
    /// Number of right ones.
    pub right: usize,
    /// Number of predictions that were skipped.
    pub skipped: usize,
    /// Number of right ones and of all, by the degree of confidence, lowest first.
    by_confidence: [[usize; 2]; Confidence::ALL.len()],
}

impl Tally {
    /// Adds the prediction in `record`, with its `judgement`.
    pub fn add(&mut self, record: &Record, judgement: Judgement) {
        let right = match judgement {
            Judgement::Right => 1,
            Judgement::Wrong => 0,
            Judgement::Skipped => {
                self.skipped += 1;
                return;
            }
            Judgement::Missing | Judgement::Neither => return,
        };
        self.judged += 1;
        self.right += right;
        if let Some(degree) = degree(record) {
            self.by_confidence[degree][0] += right;
            self.by_confidence[degree][1] += 1;
        }
    }

    /// Returns the count in sentences; empty if nothing was judged or skipped.
    pub fn text(&self) -> String {
        let Self { judged, right, skipped, by_confidence } = self;
        let mut text = String::new();
        if *judged > 0 {
            let _ = write!(text, "{right} of {judged} right");
            let words = ["who guessed", "who were fairly sure", "who were sure"];
            let told = by_confidence.iter().zip(words).rev().filter(|([_, all], _)| *all > 0);
            let told: Vec<_> = told.map(|([right, all], who)| format!("{right} of {all} {who}")).collect();
            if !told.is_empty() {
                let _ = write!(text, ": {}", told.join(", "));
            }
            text.push('.');
        }
        if *skipped > 0 {
            let _ = write!(text, "{}Skipped: {skipped}.", if text.is_empty() { "" } else { " " });
        }
        text
    }
}

/// Returns the number of the degree of confidence in the prediction, lowest first.
fn degree(record: &Record) -> Option<usize> {
    let Some(Outcome::Made { confidence, .. }) = record.outcome else { return None };
    Confidence::ALL.iter().position(|degree| Some(*degree) == confidence)
}

/// The numbers of those who chose each of several answers, by confidence: sure, fairly sure, a guess, not
/// given.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Chosen(Vec<[usize; Self::PARTS]>);

impl Chosen {
    /// Number of degrees of confidence, with that of none.
    pub const PARTS: usize = Confidence::ALL.len() + 1;

    /// None of `count` answers was chosen yet.
    pub fn new(count: usize) -> Self {
        Self(vec![[0; Self::PARTS]; count])
    }

    /// Adds the prediction in `record`: a choice, or the raised hands of a class.
    pub fn add_prediction(&mut self, record: &Record) {
        let last = Self::PARTS - 1;
        match record.answer() {
            Some(Answer::Choice(choice)) => {
                let part = degree(record).map_or(last, |degree| last - 1 - degree);
                self.add(*choice, part, 1);
            }
            Some(Answer::Votes(votes)) => {
                votes.iter().enumerate().for_each(|(choice, hands)| self.add(choice, last, *hands as usize));
            }
            _ => {}
        }
    }

    /// Adds the answer of this number to a question that asks for no confidence.
    pub fn add_observation(&mut self, choice: usize) {
        self.add(choice, Self::PARTS - 1, 1);
    }

    fn add(&mut self, choice: usize, part: usize, count: usize) {
        if let Some(parts) = self.0.get_mut(choice) {
            parts[part] = parts[part].saturating_add(count);
        }
    }

    /// Returns the counts of each answer, by confidence.
    pub fn parts(&self) -> &[[usize; Self::PARTS]] {
        &self.0
    }

    /// Returns the count of the answer of this number, in all.
    pub fn count(&self, choice: usize) -> usize {
        self.0
            .get(choice)
            .map_or(0, |parts| parts.iter().fold(0, |sum: usize, part| sum.saturating_add(*part)))
    }

    /// Returns the count of all answers.
    pub fn all(&self) -> usize {
        (0..self.0.len()).fold(0, |sum: usize, choice| sum.saturating_add(self.count(choice)))
    }
}
