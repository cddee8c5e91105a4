//! The lecturer's notes while the audience looks at the projector: right and wrong answers, why, and the
//! minutes left.

use eframe::egui::{RichText, Ui};

use super::cards;
use super::page;
use crate::app::state::lesson::Running;
use crate::lesson::{AnswerKind, Course, Options, Phase};

/// Shows the notes for the present place.
pub fn show(ui: &mut Ui, running: &Running) {
    let course = &running.course;
    ui.separator();
    ui.label(RichText::new(format!("Notes, for you alone: {}", minutes_left(course))).strong());
    let Some(step) = course.step() else { return };
    if let Some(prediction) = &step.prediction {
        match &prediction.kind {
            AnswerKind::Choice(options) => answers(ui, options),
            AnswerKind::Number(asked) => {
                if let Some(truth) = asked.truth {
                    ui.label(format!("Answer: {}", asked.text(truth)));
                }
            }
            AnswerKind::Point(_) | AnswerKind::Curve(_) => {
                cards::quiet(ui, "The answer is shown by the next press.");
            }
        }
    }
    if course.place().phase != Phase::Explained {
        page::text(ui, &step.explanation);
    }
}

/// The right answer, then those that are usually given instead.
fn answers(ui: &mut Ui, options: &Options) {
    for (number, text) in options.texts.iter().enumerate() {
        if number == options.right {
            cards::quiet(ui, "Answer");
            cards::show(ui, text, true);
        }
    }
    cards::quiet(ui, "Wrong");
    for (number, text) in options.texts.iter().enumerate() {
        if number != options.right {
            cards::text_behind(ui, text, cards::Sign::Letter(number, false));
        }
    }
}

/// Formats the minutes left of the lesson, with all steps taken as equally long.
fn minutes_left(course: &Course) -> String {
    let (steps, minutes) = (course.lesson().steps.len().max(1), f64::from(course.lesson().minutes));
    let done = match course.place().phase {
        Phase::Ask => 0.0,
        Phase::Shown => 0.4,
        Phase::Explained => 0.8,
    };
    let done = ((course.place().step as f64 + done) / steps as f64).min(1.0);
    format!("about {:.0} of {minutes:.0} minutes left", (minutes * (1.0 - done)).ceil())
}
