//! The end of a lesson: the sentence to take away, and how well it was predicted.

use eframe::egui::{TextStyle, Ui};

use super::cards;
use crate::app::commands::{FileCommand, WindowCommand};
use crate::app::panels::{Commands, OnClick as _};
use crate::app::state::files::purpose::{Product, Purpose};
use crate::app::state::lesson::{LessonCommand, Running};
use crate::app::state::overlay::Overlay;
use crate::app::widgets::theme;
use crate::lesson::{Course, Place, Score};

/// The pages to print: each button's name, and its page.
const PAGES: [(&str, Product); 4] = [
    ("Report…", Product::Report),
    ("Worksheet…", Product::Worksheet),
    ("Lab…", Product::LabSheet),
    ("Teacher’s page…", Product::TeachersPage),
];

/// Magnification of the sentence.
const LARGER: f32 = 1.4;

/// Shows both, and where to go from here.
pub fn show(ui: &mut Ui, running: &Running, commands: &mut Commands) {
    let course = &running.course;
    cards::quiet(ui, "In a sentence");
    sentence(ui, course);
    ui.add_space(cards::APART);
    if let Some(score) = &running.score {
        let lines = score_lines(score);
        let are_any = !lines.is_empty();
        for line in lines {
            ui.label(line);
        }
        ui.add_space(if are_any { cards::APART } else { 0.0 });
    }
    ui.horizontal_wrapped(|ui| {
        ui.button("Again")
            .on_hover_text("Starts at its first step")
            .on_click(commands, LessonCommand::GoTo(Place::START));
        let anew = "Starts at its first step without the answers so far; a report keeps them";
        ui.button("Start over").on_hover_text(anew).on_click(commands, LessonCommand::BeginAnew);
        let mine = "Shows your answers as a link and a code, to hand them in";
        ui.button("My answers…")
            .on_hover_text(mine)
            .on_click(commands, WindowCommand::Toggle(Overlay::Answers));
        for (name, product) in PAGES {
            let is_there = product != Product::LabSheet || course.lesson().lab.is_some();
            if is_there && ui.button(name).on_hover_text(product.tip()).clicked() {
                commands.push(FileCommand::Choose(Purpose::Save(product)).into());
            }
        }
        let of_class = "Takes the links with your pupils’ answers, and shows how they have answered";
        ui.button("Class…").on_hover_text(of_class).on_click(commands, WindowCommand::Toggle(Overlay::Class));
        ui.button("All lessons").on_click(commands, WindowCommand::Toggle(Overlay::Start));
    });
}

/// Shows the lesson's sentence, large.
pub fn sentence(ui: &mut Ui, course: &Course) {
    ui.scope(|ui| {
        let size = TextStyle::Body.resolve(ui.style()).size;
        theme::set_body_size(ui.style_mut(), LARGER * size);
        cards::question(ui, &course.lesson().sentence);
    });
}

/// Sums up the score in lines; none if nothing was predicted or skipped.
pub fn score_lines(score: &Score) -> Vec<String> {
    let Score { asked, right, skipped, others } = score;
    let skipped = if *skipped == 0 { String::new() } else { format!(", {skipped} skipped") };
    let counted = (*asked > 0).then(|| format!("Predicted: {right} of {asked} right{skipped}."));
    counted.into_iter().chain(others.iter().cloned()).collect()
}
