//! A pupil's answers to one lesson.

use crate::lesson::answer::{Answer, Outcome, Record};
use crate::lesson::answers::asked;
use crate::lesson::plan::{Lesson, Step};

/// Greatest number of letters of a pupil's name.
pub const MOST_NAME_LETTERS: usize = 40;

/// A pupil's answers to a lesson, as they are handed in.
#[derive(Debug, Clone, PartialEq)]
pub struct PupilAnswers {
    /// Name of the lesson, without the folder of a file.
    pub lesson: String,
    /// Name or sign of the pupil; empty if none was given.
    pub name: String,
    /// The answers to each step; `None` for a step without any.
    pub(super) steps: Vec<Option<StepAnswers>>,
}

/// The answers to one step.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct StepAnswers {
    /// Mark of the step's questions: a lesson may be rewritten in the meantime.
    pub asked: u16,
    /// The prediction and the observation in this step.
    pub record: Record,
}

impl PupilAnswers {
    /// The `records` of the steps of `lesson`, by somebody called `name`, which may be empty. Answers that
    /// were entered wrongly, such as a number that is none, are left out.
    #[must_use]
    pub fn new(lesson: &Lesson, records: &[Record], name: &str) -> Self {
        let given = |(step, record): (&Step, &Record)| {
            let is_sound = |outcome: &Outcome| match outcome {
                Outcome::Skipped => true,
                Outcome::Made { answer, .. } => is_sound(answer),
            };
            let record = Record { outcome: record.outcome.clone().filter(is_sound), ..record.clone() };
            (record != Record::default()).then(|| StepAnswers { asked: mark(step), record })
        };
        Self {
            lesson: lesson.name.clone(),
            name: pupils_name(name),
            steps: lesson.steps.iter().zip(records).map(given).collect(),
        }
    }

    /// Whether anything was answered or skipped.
    #[must_use]
    pub fn has_any(&self) -> bool {
        self.steps.iter().any(Option::is_some)
    }

    /// Returns the record of each step of `lesson`: empty where it asks something else than was answered.
    #[must_use]
    pub fn records(&self, lesson: &Lesson) -> Vec<Record> {
        let given = self.steps.iter().map(Option::as_ref).chain(std::iter::repeat(None));
        let record = |(step, given): (&Step, Option<&StepAnswers>)| {
            let given = given.filter(|given| given.asked == mark(step) && given.record.fits(step));
            given.map_or_else(Record::default, |given| given.record.clone())
        };
        lesson.steps.iter().zip(given).map(record).collect()
    }

    /// Returns the number of steps whose answers are to other questions than those of `lesson`.
    #[must_use]
    pub fn outdated(&self, lesson: &Lesson) -> usize {
        let given = self.steps.iter().filter(|given| given.is_some()).count();
        given - self.records(lesson).iter().filter(|record| **record != Record::default()).count()
    }
}

/// Returns `text` as a name: one line without control characters, of at most [`MOST_NAME_LETTERS`] letters.
#[must_use]
pub fn pupils_name(text: &str) -> String {
    let letters = |word: &str| word.chars().filter(|c| !c.is_control()).collect::<String>();
    let words: Vec<_> = text.split_whitespace().take(MOST_NAME_LETTERS).map(letters).collect();
    let name: String = words.join(" ").chars().take(MOST_NAME_LETTERS).collect();
    name.trim().to_owned()
}

/// The mark of the questions of `step`: different for most that differ.
fn mark(step: &Step) -> u16 {
    let sum = crc32fast::hash(asked(step).as_bytes());
    (sum ^ (sum >> 16)) as u16
}

/// Whether all numbers of `answer` are finite, and those of a curve go with T.
pub(super) fn is_sound(answer: &Answer) -> bool {
    match answer {
        Answer::Choice(_) | Answer::Votes(_) => true,
        Answer::Number(number) => number.is_finite(),
        Answer::Direction(gaze) => gaze.azimuth.is_finite() && gaze.elevation.is_finite(),
        Answer::Curve(points) => {
            let is_rising = points.is_sorted_by(|a, b| a[0] < b[0]);
            points.len() >= 2 && is_rising && points.iter().flatten().all(|number| number.is_finite())
        }
    }
}
