//! The lesson before an audience: the question and its choices, then the truth, then the reason.

use eframe::egui::{Align, Layout, TextStyle, Ui, vec2};

use super::cards::{self, Room};
use super::{end, form, observed, page, shown};
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::app::state::lesson::Running;
use crate::app::widgets;
use crate::lesson::{AnswerKind, Phase, Step};

/// Shows the lesson before an audience, but for its questions where they have room beside the picture.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let Some(running) = &state.session.lesson else { return };
    widgets::read_out(ui.ctx(), ui.unique_id());
    let Some(step) = running.course.step() else { return end::sentence(ui, &running.course) };
    let asks_beside = state.asks_beside_picture();
    match running.course.place().phase {
        Phase::Ask => {
            page::text(ui, &step.text);
            if !asks_beside {
                asked(ui, state, running, step, commands);
            }
        }
        Phase::Shown => revealed(ui, state, running, step, commands),
        Phase::Explained => page::text(ui, &step.explanation),
    }
}

/// Shows the open question in the room that the picture leaves beside it for another phase of the step.
pub fn show_beside(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let Some(running) = &state.session.lesson else { return };
    let Some(step) = running.course.step() else { return };
    match running.course.place().phase {
        Phase::Ask => asked(ui, state, running, step, commands),
        Phase::Shown => observed(ui, running, step, commands),
        Phase::Explained => {}
    }
}

/// Shows the question of `step`, if it has one, and what can be answered.
fn asked(ui: &mut Ui, state: &State, running: &Running, step: &Step, commands: &mut Commands) {
    let (course, Some(prediction)) = (&running.course, &step.prediction) else { return };
    cards::question(ui, &prediction.question);
    match &prediction.kind {
        AnswerKind::Number(_) if course.is_answered() => shown::said(ui, state, step, course),
        AnswerKind::Number(_) => {}
        _ => form::show(ui, state, Room::Audience, (course, prediction), commands),
    }
}

/// Shows the question of what was seen, once the reveal is over.
fn observed(ui: &mut Ui, running: &Running, step: &Step, commands: &mut Commands) {
    if let Some(observation) = step.observation.as_ref().filter(|_| !running.is_running()) {
        observed::show(ui, Room::Audience, &running.course, observation, commands);
    }
}

/// Width from which on the words have two columns, in heights of the writing.
const TWO_COLUMNS: f32 = 36.0;
/// Share of that width that the truth has.
const TRUTH_SHARE: f32 = 0.5;

/// Shows the words of the reveal and the question of what was seen, side by side if they fit. The truth
/// appears once that question is answered.
fn revealed(ui: &mut Ui, state: &State, running: &Running, step: &Step, commands: &mut Commands) {
    let asks = step.observation.is_some() && !running.is_running() && !state.asks_beside_picture();
    let shows_truth = !running.is_running() && running.course.shows_truth();
    let size = TextStyle::Body.resolve(ui.style()).size;
    let is_wide = ui.available_width() > TWO_COLUMNS * size;
    // What was to be looked at was seen once the truth is told.
    if step.observation.is_none() || !shows_truth {
        page::said_to_reveal(ui, step);
    }
    match (asks, shows_truth) {
        (true, true) if is_wide => {
            let [left, right] = [TRUTH_SHARE, 1.0 - TRUTH_SHARE]
                .map(|share| vec2(share * (ui.available_width() - size).max(0.0), 0.0));
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = size;
                let column = Layout::top_down(Align::Min);
                ui.allocate_ui_with_layout(left, column, |ui| compared(ui, state, running, step));
                ui.allocate_ui_with_layout(right, column, |ui| observed(ui, running, step, commands));
            });
        }
        _ => {
            if shows_truth {
                compared(ui, state, running, step);
            }
            if asks {
                observed(ui, running, step, commands);
            }
        }
    }
}

/// Shows the question, the given answer and the true one.
fn compared(ui: &mut Ui, state: &State, running: &Running, step: &Step) {
    if let Some(prediction) = &step.prediction {
        cards::question(ui, &prediction.question);
        shown::compared(ui, state, Room::Audience, step, &running.course);
    }
}
