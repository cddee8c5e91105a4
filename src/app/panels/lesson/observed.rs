//! The question about what was seen, after the reveal: one observation in five contradicts what was shown.

use eframe::egui::{RichText, Ui};

use super::asked::ask;
use super::cards;
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::app::state::lesson::LessonCommand;
use crate::lesson::{Choices, Course, Record};

/// Shows the question, and what is to say to its answer.
pub fn show(ui: &mut Ui, state: &State, course: &Course, asked: &Choices, commands: &mut Commands) {
    cards::question(ui, &asked.question);
    let is_presented = state.session.stage.is_presented();
    let observed = course.record().and_then(|record: &Record| record.observed);
    for (number, text) in asked.options.texts.iter().enumerate() {
        let is_chosen = observed == Some(number);
        if cards::choice(ui, text, number, is_chosen, state.session.stage.has_audience()).clicked() {
            ask(commands, LessonCommand::Observe(number));
        }
    }
    match observed {
        Some(observed) if observed == asked.options.right => {
            ui.label(RichText::new("Yes, that is what happened.").color(cards::right_colour(ui)));
        }
        Some(_) => {
            ui.label("Something else happened. It is easily missed: look again.");
            // Before an audience the key that goes back does it.
            if !is_presented
                && ui.button("Look again").on_hover_text("Shows it again from the beginning").clicked()
            {
                ask(commands, LessonCommand::SetUp);
            }
        }
        None => {}
    }
}
