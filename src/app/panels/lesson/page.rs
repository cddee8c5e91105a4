//! The page of a place in a lesson: its text and its question.

use eframe::egui::{RichText, Ui};

use super::cards::{self, Room};
use super::{end, form, observed, shown};
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::app::state::lesson::Running;
use crate::app::widgets::markdown;
use crate::lesson::{AnswerKind, Course, Phase, Step, Text};

/// Shows the page of the present place.
pub fn show(ui: &mut Ui, state: &State, running: &Running, commands: &mut Commands) {
    let course = &running.course;
    let Some(step) = course.step() else { return end::show(ui, running, commands) };
    ui.spacing_mut().item_spacing.y = 6.0;
    if step.title != course.lesson().title {
        ui.label(RichText::new(&step.title).heading().strong());
        ui.add_space(4.0);
    }
    match course.place().phase {
        Phase::Ask => asked(ui, state, course, step, commands),
        Phase::Shown => revealed(ui, state, running, step, commands),
        Phase::Explained => text(ui, &step.explanation),
    }
}

fn asked(ui: &mut Ui, state: &State, course: &Course, step: &Step, commands: &mut Commands) {
    text(ui, &step.text);
    let Some(prediction) = &step.prediction else { return };
    apart(ui, !step.text.is_empty());
    cards::question(ui, &prediction.question);
    form::show(ui, state, Room::Panel, (course, prediction), commands);
    if let AnswerKind::Choice(options) = &prediction.kind
        && !course.counts_hands()
    {
        cards::quiet(ui, &format!("Press {}.", cards::keys_text(options.texts.len())));
    }
    form::confidence(ui, course, commands);
    if course.is_answered() {
        cards::quiet(ui, "This is what you said. You can change it.");
    }
}

fn revealed(ui: &mut Ui, state: &State, running: &Running, step: &Step, commands: &mut Commands) {
    let has_text = said_to_reveal(ui, step);
    if running.is_running() {
        if !has_text {
            cards::quiet(ui, "Watch.");
        }
        return;
    }
    // What was seen comes first: with the truth beside it, that question would only be copied from.
    if let Some(observation) = &step.observation {
        apart(ui, has_text);
        observed::show(ui, Room::Panel, &running.course, observation, commands);
    }
    if let Some(prediction) = step.prediction.as_ref().filter(|_| running.course.shows_truth()) {
        apart(ui, step.observation.is_some() || has_text);
        cards::question(ui, &prediction.question);
        shown::compared(ui, state, Room::Panel, step, &running.course);
    }
}

/// Shows the text of the reveal; returns whether there is any.
pub fn said_to_reveal(ui: &mut Ui, step: &Step) -> bool {
    let said = step.reveal.as_ref().map(|reveal| &reveal.text).filter(|text| !text.is_empty());
    said.inspect(|said| text(ui, said)).is_some()
}

/// Shows `text`, if there is one.
pub fn text(ui: &mut Ui, text: &Text) {
    if !text.is_empty() {
        markdown::show(ui, &text.markdown);
    }
}

/// Space between what came before, if anything did, and what follows.
fn apart(ui: &mut Ui, is_between: bool) {
    if is_between {
        ui.add_space(cards::APART);
    }
}

/// Returns what the page shows, as far as its height depends on it.
pub fn what_is_shown(running: &Running) -> String {
    let course = &running.course;
    let (lesson, place, record) = (course.lesson(), course.place(), course.record());
    let is_running = running.is_running();
    let (is_class, shows_truth) = (course.counts_hands(), course.shows_truth());
    format!("{} {place:?} {record:?} {is_class} {shows_truth} {is_running} {:?}", lesson.name, course.step())
}
