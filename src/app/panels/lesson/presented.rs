//! What an audience is told in a lesson: the question and its choices, then what is so, then why.

use eframe::egui::{RichText, Ui, UiBuilder};

use super::{cards, end, form, observed, page, shown};
use crate::app::panels::Asks;
use crate::app::running::Running;
use crate::app::state::State;
use crate::app::theme;
use crate::app::widgets::fitted;
use crate::figures;
use crate::lesson::{Kind, Phase, Step};

/// Largest and smallest sizes of most writing, points: as large as fits.
const SIZES: [f32; 2] = [30.0, 11.0];

/// Height of the writing in the line above, as a part of all the room.
const LINE_SHARE: f32 = 0.05;

/// Shows it.
pub fn show(ui: &mut Ui, state: &State, asks: &mut Asks) {
    let Some(running) = &state.session.lesson else { return };
    where_it_is(ui, state, running);
    let rest = ui.available_rect_before_wrap();
    ui.scope_builder(UiBuilder::new().max_rect(rest), |ui| {
        fitted::show(ui, page::what_is_shown(running), SIZES, |ui| {
            ui.spacing_mut().item_spacing.y = 5.0;
            match running.course.step() {
                Some(step) => words(ui, state, running, step, asks),
                None => end::sentence(ui, &running.course),
            }
        });
    });
}

/// The lesson, the step and the speed, in a line.
fn where_it_is(ui: &mut Ui, state: &State, running: &Running) {
    let course = &running.course;
    let (lesson, place) = (course.lesson(), course.place().step);
    let count = lesson.steps.len();
    let step = if count > 1 && place < count { format!("{} of {count}", place + 1) } else { String::new() };
    let beta = format!("β\u{a0}=\u{a0}{}", figures::beta(&state.speed()));
    let parts = [lesson.title.as_str(), &step, &beta];
    let told = parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join("  ·  ");
    let size = (LINE_SHARE * ui.max_rect().height()).max(theme::BODY_SIZE);
    ui.label(RichText::new(told).size(size).weak());
}

fn words(ui: &mut Ui, state: &State, running: &Running, step: &Step, asks: &mut Asks) {
    let course = &running.course;
    let prediction = step.prediction.as_ref();
    match (course.place().phase, prediction) {
        (Phase::Ask, Some(prediction)) => {
            // Choices need the room, and who presents tells the rest.
            if !matches!(prediction.kind, Kind::Choice(_)) {
                page::text(ui, &step.text);
            }
            cards::question(ui, &prediction.question);
            match &prediction.kind {
                Kind::Choice(options) if course.counts_hands() => form::votes(ui, course, options, asks),
                Kind::Choice(options) => form::choices(ui, course, options, asks),
                Kind::Point(_) | Kind::Curve(_) => form::hint(ui, state, course),
                Kind::Number(_) if course.is_answered() => shown::said(ui, state, step, course),
                Kind::Number(_) => {}
            }
        }
        (Phase::Ask, None) => page::text(ui, &step.text),
        (Phase::Shown, Some(_)) if !running.is_running() && !course.tells_truth() => {
            page::said_to_reveal(ui, step);
            step.observation.iter().for_each(|asked| observed::show(ui, course, asked, asks));
        }
        (Phase::Shown, Some(prediction)) if !running.is_running() => {
            cards::question(ui, &prediction.question);
            shown::compared(ui, state, step, course);
            page::said_to_reveal(ui, step);
        }
        (Phase::Shown, _) => {
            page::said_to_reveal(ui, step);
        }
        (Phase::Explained, _) => page::text(ui, &step.explanation),
    }
}
