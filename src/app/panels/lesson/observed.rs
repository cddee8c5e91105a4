//! The question about what was seen, after the reveal: one observation in five contradicts what was shown.

use eframe::egui::{RichText, Ui};

use super::cards::{self, Room};
use crate::app::panels::{Commands, OnClick as _};
use crate::app::state::lesson::LessonCommand;
use crate::lesson::{Choices, Course, Record, Text};

/// Shows the question, and what is to say to its answer.
pub fn show(ui: &mut Ui, room: Room, course: &Course, asked: &Choices, commands: &mut Commands) {
    cards::question(ui, &asked.question);
    let observed = course.record().and_then(|record: &Record| record.observed);
    let mut card = |ui: &mut Ui, number: usize, text: &Text| {
        let is_chosen = observed == Some(number);
        cards::choice(ui, text, number, is_chosen).on_click(commands, LessonCommand::Observe(number));
    };
    let texts = &asked.options.texts;
    match observed.and_then(|chosen| Some((chosen, texts.get(chosen)?))) {
        // The truth stands beside it, and the words are to stay large.
        Some((chosen, text)) if room == Room::Audience => card(ui, chosen, text),
        _ => cards::each(ui, room, texts, card),
    }
    match observed {
        Some(observed) if observed == asked.options.right => {
            ui.label(RichText::new("Yes, that is what happened.").color(cards::right_colour(ui)));
        }
        Some(_) => {
            ui.label("Something else happened. It is easily missed: look again.");
            // Before an audience the key that goes back does it.
            if room == Room::Panel {
                ui.button("Look again")
                    .on_hover_text("Shows it again from the beginning")
                    .on_click(commands, LessonCommand::SetUp);
            }
        }
        None => {}
    }
}
