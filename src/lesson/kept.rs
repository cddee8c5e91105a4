//! What is kept of somebody's way through a lesson while that is closed, in the window and from one window to the next.

use serde::{Deserialize, Serialize};

use super::answer::{Answer, Outcome, Record};
use super::place::Place;
use super::plan::{Choices, Kind, Lesson, Options, Prediction, Step};

/// A way through a lesson: the answers, what is being entered, and the place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct KeptCourse {
    lesson: String,
    place: Place,
    steps: Vec<KeptStep>,
    draft: Option<Answer>,
    confidence: Option<u8>,
}

/// What was done in a step, and what was asked there: a lesson may be written anew in the meantime.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct KeptStep {
    asked: String,
    record: Record,
}

impl KeptCourse {
    /// What is to be kept of a way through `lesson`: the place, what was done in each step, and what is being entered.
    #[must_use]
    pub fn of(
        lesson: &Lesson,
        place: Place,
        records: &[Record],
        (draft, confidence): (Option<Answer>, Option<u8>),
    ) -> Self {
        let steps = lesson.steps.iter().zip(records);
        let steps = steps.map(|(step, record)| KeptStep { asked: asked(step), record: record.clone() });
        Self { lesson: named(lesson), place, steps: steps.collect(), draft, confidence }
    }

    /// Whether it leads through `lesson`.
    #[must_use]
    pub fn is_of(&self, lesson: &Lesson) -> bool {
        self.lesson == named(lesson)
    }

    /// Where it was.
    #[must_use]
    pub const fn place(&self) -> Place {
        self.place
    }

    /// What was done in the step of this `number`, if `lesson` asks there what it asked then.
    #[must_use]
    pub fn record(&self, lesson: &Lesson, number: usize) -> Record {
        let kept = self.steps.get(number).zip(lesson.steps.get(number));
        let kept = kept.filter(|(kept, step)| kept.asked == asked(step) && kept.record.fits(step));
        kept.map(|(kept, _)| kept.record.clone()).unwrap_or_default()
    }

    /// What was being entered, and how sure of it, if that is still asked at `place`.
    #[must_use]
    pub fn draft(&self, lesson: &Lesson, place: Place) -> (Option<Answer>, Option<u8>) {
        let step = lesson.steps.get(place.step).filter(|_| place == self.place);
        let prediction = step.and_then(|step| step.prediction.as_ref());
        let draft = prediction.and_then(|asked| self.draft.clone().filter(|draft| draft.fits(&asked.kind)));
        (draft, self.confidence.filter(|_| prediction.is_some()))
    }
}

impl Record {
    /// Whether it can be of `step`.
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

/// What tells lessons apart: the file of one that is read from a file, else its name.
fn named(lesson: &Lesson) -> String {
    lesson.path.as_ref().map_or_else(|| lesson.name.clone(), |path| path.to_string_lossy().into_owned())
}

/// All that `step` asks.
fn asked(step: &Step) -> String {
    let mut asked = String::new();
    let mut add = |question: &str, options: Option<&Options>| {
        asked += question;
        for text in options.into_iter().flat_map(|options| &options.texts) {
            asked.push('\n');
            asked += &text.markdown;
        }
        asked.push('\n');
    };
    if let Some(Prediction { question, kind }) = &step.prediction {
        let options = if let Kind::Choice(options) = kind { Some(options) } else { None };
        add(&question.markdown, options);
    }
    if let Some(Choices { question, options }) = &step.observation {
        add(&question.markdown, Some(options));
    }
    asked
}
