//! The lesson before an audience: the question and its choices, then the truth, then the reason.

use eframe::egui::{Label, RichText, Ui};

use super::{cards, end, form, observed, page, shown};
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::app::state::lesson::Running;
use crate::lesson::{AnswerKind, Phase, Step};

/// Shows the lesson before an audience.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let Some(running) = &state.session.lesson else { return };
    where_it_is(ui, state, running);
    match running.course.step() {
        Some(step) => words(ui, state, running, step, commands),
        None => end::sentence(ui, &running.course),
    }
}

/// The lesson, the step and the speed, in a line.
fn where_it_is(ui: &mut Ui, state: &State, running: &Running) {
    let course = &running.course;
    let (lesson, place) = (course.lesson(), course.place().step);
    let count = lesson.steps.len();
    let step = if count > 1 && place < count { format!("{} of {count}", place + 1) } else { String::new() };
    let (speed, others) = (state.told_speed_text(), state.others_speed_text().unwrap_or_default());
    let parts = [lesson.title.as_str(), &step, &speed, &others];
    let told = parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join("  ·  ");
    ui.add(Label::new(RichText::new(told).weak()).truncate());
}

fn words(ui: &mut Ui, state: &State, running: &Running, step: &Step, commands: &mut Commands) {
    let course = &running.course;
    let prediction = step.prediction.as_ref();
    match (course.place().phase, prediction) {
        (Phase::Ask, Some(prediction)) => {
            page::text(ui, &step.text);
            cards::question(ui, &prediction.question);
            match &prediction.kind {
                AnswerKind::Number(_) if course.is_answered() => shown::said(ui, state, step, course),
                AnswerKind::Number(_) => {}
                _ => form::show(ui, state, course, prediction, commands),
            }
        }
        (Phase::Ask, None) => page::text(ui, &step.text),
        (Phase::Shown, _) => revealed(ui, state, running, step, commands),
        (Phase::Explained, _) => page::text(ui, &step.explanation),
    }
}

/// Part of the window's width from which on the words have two columns.
const TWO_COLUMNS: f32 = 0.8;

/// Shows the words of the reveal and the question of what was seen, side by side if they fit. The truth
/// appears once that question is answered.
fn revealed(ui: &mut Ui, state: &State, running: &Running, step: &Step, commands: &mut Commands) {
    let observation = step.observation.as_ref().filter(|_| !running.is_running());
    let is_wide = ui.available_width() > TWO_COLUMNS * ui.ctx().content_rect().width();
    match observation {
        Some(observation) if is_wide => ui.columns_const(|[left, right]| {
            compared(left, state, running, step);
            observed::show(right, state, &running.course, observation, commands);
        }),
        Some(observation) => {
            compared(ui, state, running, step);
            observed::show(ui, state, &running.course, observation, commands);
        }
        None => compared(ui, state, running, step),
    }
}

fn compared(ui: &mut Ui, state: &State, running: &Running, step: &Step) {
    let shows_truth = !running.is_running() && running.course.shows_truth();
    if let Some(prediction) = step.prediction.as_ref().filter(|_| shows_truth) {
        cards::question(ui, &prediction.question);
        shown::compared(ui, state, step, &running.course);
    }
    page::said_to_reveal(ui, step);
}
