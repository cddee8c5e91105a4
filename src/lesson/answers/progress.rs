//! Somebody's way through one lesson as it is stored.

use serde::{Deserialize, Serialize};

use crate::lesson::answer::{Answer, Confidence, Outcome, Record};
use crate::lesson::place::Place;
use crate::lesson::plan::{AnswerKind, Choices, Lesson, Options, Prediction, Step};

/// A way through a lesson: the answers, the place, and the answer that is being entered there.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LessonProgress {
    lesson: String,
    place: Place,
    draft: Option<Answer>,
    confidence: Option<Confidence>,
    /// By number.
    steps: Vec<KeptStep>,
}

/// A step's answers, with their questions: a lesson may be rewritten in the meantime.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct KeptStep {
    asked: String,
    record: Record,
}

impl LessonProgress {
    /// The way through `lesson` to `place`, with the `records` of its steps and the answer that is being
    /// entered.
    pub(in crate::lesson) fn new(
        lesson: &Lesson,
        records: &[Record],
        place: Place,
        (draft, confidence): (Option<&Answer>, Option<Confidence>),
    ) -> Self {
        let kept = |(step, record): (&Step, &Record)| KeptStep {
            asked: asked(step),
            record: Record { outcome: record.outcome.clone().filter(can_be_read_again), ..*record },
        };
        Self {
            lesson: key(lesson),
            place,
            draft: draft.cloned().filter(can_be_read_again),
            confidence,
            steps: lesson.steps.iter().zip(records).map(kept).collect(),
        }
    }

    /// Returns what names the lesson: its file, if it was read from one, else its name.
    #[must_use]
    pub fn key(&self) -> &str {
        &self.lesson
    }

    /// Returns whether anything was done in the lesson.
    #[must_use]
    pub fn is_begun(&self) -> bool {
        self.draft.is_some() || self.is_further_than(None)
    }

    /// Returns whether the answers or the place are others than those `known`, whatever is being entered.
    #[must_use]
    pub fn is_further_than(&self, known: Option<&Self>) -> bool {
        match known {
            Some(known) => (self.place, &self.steps) != (known.place, &known.steps),
            None => {
                self.place != Place::START || self.steps.iter().any(|step| step.record != Record::default())
            }
        }
    }

    /// Returns the place that was reached.
    #[must_use]
    pub const fn place(&self) -> Place {
        self.place
    }

    /// Returns the answers given in the step of this `number`, if `lesson` still has the same question there.
    #[must_use]
    pub fn record(&self, lesson: &Lesson, number: usize) -> Record {
        let kept = lesson.steps.get(number).zip(self.steps.get(number));
        kept.filter(|(step, kept)| kept.asked == asked(step) && kept.record.fits(step))
            .map_or_else(Record::default, |(_, kept)| kept.record.clone())
    }

    /// Returns the answer that was being entered and its confidence, if `place` still has the same question.
    #[must_use]
    pub fn draft(&self, lesson: &Lesson, place: Place) -> (Option<Answer>, Option<Confidence>) {
        let step = lesson.steps.get(place.step).filter(|_| place == self.place);
        let Some(asked) = step.and_then(|step| step.prediction.as_ref()) else { return (None, None) };
        (self.draft.clone().filter(|answer| answer.fits(&asked.kind)), self.confidence)
    }
}

impl Record {
    /// Whether the record can belong to `step`.
    pub(in crate::lesson) fn fits(&self, step: &Step) -> bool {
        let is_answer = match (&self.outcome, &step.prediction) {
            (Some(Outcome::Made { answer, .. }), Some(asked)) => answer.fits(&asked.kind),
            (Some(_), None) => false,
            (Some(Outcome::Skipped) | None, _) => true,
        };
        let count = step.observation.as_ref().map_or(0, |asked| asked.options.texts.len());
        is_answer && self.observed.is_none_or(|observed| observed < count)
    }
}

/// Whether a file gives `value` back as it was written. Numbers that are none are not kept, which would spoil
/// the whole file.
fn can_be_read_again<T: Serialize + for<'de> Deserialize<'de> + PartialEq>(value: &T) -> bool {
    let text = serde_json::to_string(value);
    text.is_ok_and(|text| serde_json::from_str::<T>(&text).is_ok_and(|read| read == *value))
}

/// Returns the key of a lesson: its file, if it was read from one, else its name.
pub(super) fn key(lesson: &Lesson) -> String {
    lesson.path.as_ref().map_or_else(|| lesson.name.clone(), |path| path.to_string_lossy().into_owned())
}

/// Returns all questions of `step`.
pub(in crate::lesson) fn asked(step: &Step) -> String {
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
