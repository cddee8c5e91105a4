//! Somebody's way through one lesson as it is stored: each answer with its date, so that two windows can be merged.

use serde::{Deserialize, Serialize};

use super::dated::{Dated, Timestamp, merged};
use crate::lesson::answer::{Answer, Confidence, Outcome, Record};
use crate::lesson::place::Place;
use crate::lesson::plan::{AnswerKind, Choices, Lesson, Options, Prediction, Step};

/// A way through a lesson: the answers, the place, and the answer that is being entered. Each is replaced on its own by a later one.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct LessonProgress {
    /// The last time that the lesson was begun from its start without answers: nothing older counts.
    pub(super) cleared: Timestamp,
    pub(super) place: Option<Dated<Place>>,
    pub(super) draft: Option<Dated<Draft>>,
    /// By number, then by question.
    pub(super) steps: Vec<KeptStep>,
}

/// An answer that is being entered.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Draft {
    pub(super) place: Place,
    pub(super) answer: Option<Answer>,
    pub(super) confidence: Option<Confidence>,
}

/// A step's answers, with their questions: a lesson may be rewritten in the meantime.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct KeptStep {
    number: usize,
    asked: String,
    pub(super) outcome: Option<Dated<Outcome>>,
    pub(super) observed: Option<Dated<usize>>,
}

impl KeptStep {
    fn key(&self) -> (usize, &str) {
        (self.number, &self.asked)
    }
}

impl LessonProgress {
    /// Returns whether anything was done in the lesson progress.
    #[must_use]
    pub fn is_begun(&self) -> bool {
        let is_under_way = self.place.as_ref().is_some_and(|place| place.value != Place::START);
        let is_entered = self.draft.as_ref().is_some_and(|draft| draft.value.answer.is_some());
        is_under_way || is_entered || !self.steps.is_empty()
    }

    /// Returns the place that was reached.
    #[must_use]
    pub fn place(&self) -> Place {
        self.place.as_ref().map_or(Place::START, |place| place.value)
    }

    /// Returns the answers given in the step of this `number`, if `lesson` still has the same question there.
    #[must_use]
    pub fn record(&self, lesson: &Lesson, number: usize) -> Record {
        let Some(step) = lesson.steps.get(number) else { return Record::default() };
        let asked = asked(step);
        let Some(kept) = self.steps.iter().find(|kept| kept.key() == (number, &*asked)) else {
            return Record::default();
        };
        let outcome = kept.outcome.as_ref().map(|outcome| outcome.value.clone());
        let observed = kept.observed.as_ref().map(|observed| observed.value);
        Some(Record { outcome, observed }).filter(|record| record.fits(step)).unwrap_or_default()
    }

    /// Returns the answer that was being entered and its confidence, if `place` still has the same question.
    #[must_use]
    pub fn draft(&self, lesson: &Lesson, place: Place) -> (Option<Answer>, Option<Confidence>) {
        let draft = self.draft.as_ref().map(|draft| &draft.value).filter(|draft| draft.place == place);
        let step = lesson.steps.get(place.step);
        let prediction = step.and_then(|step| step.prediction.as_ref());
        let Some((draft, asked)) = draft.zip(prediction) else { return (None, None) };
        (draft.answer.clone().filter(|answer| answer.fits(&asked.kind)), draft.confidence)
    }

    /// Returns the stored step of this `number` in `lesson`, a new one if there is none.
    pub(super) fn step(&mut self, lesson: &Lesson, number: usize) -> Option<&mut KeptStep> {
        let asked = asked(lesson.steps.get(number)?);
        let found = self.steps.binary_search_by(|kept| kept.key().cmp(&(number, &asked)));
        let index = found.unwrap_or_else(|index| {
            self.steps.insert(index, KeptStep { number, asked, outcome: None, observed: None });
            index
        });
        self.steps.get_mut(index)
    }

    /// Merges `other` into it: of each answer the later one stays, and none that is older than the last clearing.
    pub(super) fn merge(&mut self, other: &Self) {
        self.cleared = self.cleared.max(other.cleared);
        self.place = merged(self.place.take(), other.place.as_ref());
        self.draft = merged(self.draft.take(), other.draft.as_ref());
        for step in &other.steps {
            match self.steps.binary_search_by(|kept| kept.key().cmp(&step.key())) {
                Ok(index) => {
                    let kept = &mut self.steps[index];
                    kept.outcome = merged(kept.outcome.take(), step.outcome.as_ref());
                    kept.observed = merged(kept.observed.take(), step.observed.as_ref());
                }
                Err(index) => self.steps.insert(index, step.clone()),
            }
        }
        self.drop_cleared();
    }

    /// Forgets everything that is older than the last clearing.
    pub(super) fn drop_cleared(&mut self) {
        let cleared = self.cleared;
        self.place.take_if(|place| place.at <= cleared);
        self.draft.take_if(|draft| draft.at <= cleared);
        for step in &mut self.steps {
            step.outcome.take_if(|outcome| outcome.at <= cleared);
            step.observed.take_if(|observed| observed.at <= cleared);
        }
        self.steps.retain(|step| step.outcome.is_some() || step.observed.is_some());
    }

    /// Returns the date of its latest change; without drafts, which change with every stroke of a key.
    pub(super) fn latest_answer(&self) -> Timestamp {
        let steps = self.steps.iter().flat_map(|step| {
            [
                step.outcome.as_ref().map(|outcome| outcome.at),
                step.observed.as_ref().map(|observed| observed.at),
            ]
        });
        let place = self.place.as_ref().map(|place| place.at);
        steps.flatten().chain(place).fold(self.cleared, Timestamp::max)
    }

    /// Returns the date of the lesson progress's latest change, drafts included.
    pub(super) fn latest(&self) -> Timestamp {
        self.draft.as_ref().map_or(0, |draft| draft.at).max(self.latest_answer())
    }

    /// Restores the order of its steps, which a file may have lost, and returns whether each step occurs only once.
    pub(super) fn put_in_order(&mut self) -> bool {
        self.steps.sort_by(|a, b| a.key().cmp(&b.key()));
        self.drop_cleared();
        self.steps.windows(2).all(|pair| pair[0].key() != pair[1].key())
    }
}

impl Record {
    /// Whether the record can belong to `step`.
    fn fits(&self, step: &Step) -> bool {
        let is_answer = match (&self.outcome, &step.prediction) {
            (Some(Outcome::Made { answer, .. }), Some(asked)) => answer.fits(&asked.kind),
            (Some(_), None) => false,
            (Some(Outcome::Skipped) | None, _) => true,
        };
        let count = step.observation.as_ref().map_or(0, |asked| asked.options.texts.len());
        is_answer && self.observed.is_none_or(|observed| observed < count)
    }
}

/// Returns the key of a lesson: its file, if it was read from one, else its name.
pub(super) fn named(lesson: &Lesson) -> String {
    lesson.path.as_ref().map_or_else(|| lesson.name.clone(), |path| path.to_string_lossy().into_owned())
}

/// Returns all questions of `step`.
fn asked(step: &Step) -> String {
    let mut asked = String::new();
    let mut add = |question: &str, options: Option<&Options>| {
        asked += question;
        for text in options.into_iter().flat_map(|options| &options.texts) {
            asked.push('\n');
            asked += text.markdown.source();
        }
        asked.push('\n');
    };
    if let Some(Prediction { question, kind }) = &step.prediction {
        let options = if let AnswerKind::Choice(options) = kind { Some(options) } else { None };
        add(question.markdown.source(), options);
    }
    if let Some(Choices { question, options }) = &step.observation {
        add(question.markdown.source(), Some(options));
    }
    asked
}
