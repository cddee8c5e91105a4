//! The end of a lesson: the sentence to take away, and how well it was predicted.

use eframe::egui::{TextStyle, Ui};

use super::asked::ask;
use super::cards;
use crate::app::chooser::{Product, Purpose};
use crate::app::command::Command;
use crate::app::overlay::Overlay;
use crate::app::panels::Asks;
use crate::app::running::LessonCommand;
use crate::app::theme;
use crate::lesson::{Course, Place, Score};

/// How much larger than other writing the sentence is.
const LARGER: f32 = 1.4;

/// Shows both, and where to go from here.
pub fn show(ui: &mut Ui, course: &Course, asks: &mut Asks) {
    cards::quiet(ui, "In a sentence");
    sentence(ui, course);
    ui.add_space(cards::APART);
    if let Some(told) = told(course.score()) {
        ui.label(told);
        ui.add_space(cards::APART);
    }
    ui.horizontal_wrapped(|ui| {
        if ui.button("Again").on_hover_text("From its first step").clicked() {
            ask(asks, LessonCommand::GoTo(Place::START));
        }
        let anew = "From its first step, without the answers that were given: a report keeps these";
        if ui.button("Begin anew").on_hover_text(anew).clicked() {
            ask(asks, LessonCommand::BeginAnew);
        }
        let report = "What was predicted and seen in each step, as a page to keep or to print";
        if ui.button("Report…").on_hover_text(report).clicked() {
            asks.push(Command::Choose(Purpose::Save(Product::Report)));
        }
        if ui.button("All lessons").clicked() {
            asks.push(Command::Toggle(Overlay::Start));
        }
    });
}

/// The sentence, large.
pub fn sentence(ui: &mut Ui, course: &Course) {
    ui.scope(|ui| {
        let size = TextStyle::Body.resolve(ui.style()).size;
        theme::set_body_size(ui.style_mut(), LARGER * size);
        cards::question(ui, &course.lesson().sentence);
    });
}

/// How well it was predicted; nothing where nothing was asked.
pub fn told(score: Score) -> Option<String> {
    let Score { asked, right, skipped } = score;
    let skipped = if skipped == 0 { String::new() } else { format!(", {skipped} skipped") };
    (asked > 0).then(|| format!("Predicted: {right} of {asked} right{skipped}."))
}
