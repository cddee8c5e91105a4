//! Lessons: predict, see, compare, explain. What a lesson consists of, how it is read from a Markdown file
//! (`assets/lessons/README.md` describes it), and how somebody goes through it. No window is known here.
//!
//! A lesson is read ([`Lesson::read`]), then worked out ([`Lesson::worked_out`]): the values that its texts
//! ask for are put in their places. A [`Course`] is somebody's way through it.

mod answer;
mod answers;
pub mod card;
pub mod class;
mod course;
mod curve_plot;
mod error;
mod library;
mod picture;
mod place;
mod plan;
mod read;
pub mod report;
mod score;
mod seen_place;
mod sequence;
pub mod sketch;
pub mod truth;
pub mod values;
mod verdict;
pub mod worksheet;

pub use answer::{Answer, Confidence, Outcome, Record};
pub use answers::{Answers, LessonProgress};
pub use course::Course;
pub use error::LessonError;
pub use library::{Chapter, Library, Refused};
pub use place::{Phase, Place};
pub use plan::{
    Animated, Animation, AnswerKind, Choices, CurveAnswer, Lab, Lesson, Number, Options, PointAt, Prediction,
    Reveal, StateBlock, Step, Text,
};
pub use score::Score;
pub use sequence::{Sequence, SequenceEntry};
pub use truth::Sight;
pub use verdict::{Verdict, difference, verdict};
