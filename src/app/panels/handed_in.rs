//! The two windows of answers that are handed in: a pupil's own as a link and a code, and the links of a
//! class.

use std::sync::Arc;

use eframe::egui::{Button, Context, RichText, ScrollArea, TextEdit, TextStyle, Ui};

use super::{Commands, OnClick as _, show_overlay};
use crate::app::commands::FileCommand;
use crate::app::state::State;
use crate::app::state::class::ClassCommand;
use crate::app::state::files::purpose::{Product, Purpose};
use crate::app::state::orders::Copied;
use crate::app::state::overlay::Overlay;
use crate::app::tools::page_link::{self, link_to};
use crate::app::widgets::{focus, qr_code, theme};
use crate::caption::capitalised;
use crate::lesson::Lesson;
use crate::lesson::class::Collected;

/// Width of both, and room around them, points.
const WIDTH: f32 = 460.0;
const AROUND: f32 = 60.0;
/// Side of the code, points.
const CODE: f32 = 280.0;
/// Width of the name, points.
const NAME: f32 = 200.0;
/// Lines of the text with links, and height that it may take, points.
const LINES: usize = 7;
const TEXT_HEIGHT: f32 = 150.0;
/// An example of such a text, shown while it is empty.
const HINT: &str = "Ada gamow:?answers=…\nBen;gamow:?answers=…;12:01";
/// Links that cannot be read and are named.
const MOST_NAMED: usize = 3;

/// Shows the one that is open.
pub fn show(ctx: &Context, state: &State, commands: &mut Commands) {
    match state.session.overlay {
        Some(Overlay::Answers) => {
            show_overlay(ctx, "My answers", Overlay::Answers, commands, |ui, commands| {
                scrolled(ui, |ui| own(ui, state, commands));
            });
        }
        Some(Overlay::Class) => {
            show_overlay(ctx, "Answers of a class", Overlay::Class, commands, |ui, commands| {
                scrolled(ui, |ui| class(ui, state, commands));
            });
        }
        _ => {}
    }
}

/// Shows `contents` as wide and as high as there is room for.
fn scrolled(ui: &mut Ui, contents: impl FnOnce(&mut Ui)) {
    let room = ui.ctx().content_rect().size();
    ui.set_width(WIDTH.min(room.x - AROUND).max(1.0));
    let height = (room.y - 2.0 * AROUND).max(1.0);
    // It scrolls where the room ends, and not where the window did before its contents grew.
    ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, contents);
}

/// The answers in the open lesson, to be handed in.
fn own(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let Some(pairs) = state.own_answers() else {
        ui.label("Nothing was answered yet: open a lesson, and predict.");
        return;
    };
    let ground = ui.visuals().widgets.inactive.weak_bg_fill;
    ui.label("This link holds your answers to the lesson. Send it to your teacher, or have its code scanned: the program itself sends nothing.");
    ui.add_space(theme::GAP);
    ui.horizontal(|ui| {
        let label = ui.label("Name");
        let mut name = state.session.class.name.clone();
        let field = TextEdit::singleline(&mut name)
            .desired_width(NAME)
            .background_color(ground)
            .hint_text("or a sign; may stay empty");
        let field = ui.add(field).labelled_by(label.id);
        focus::note_words(&field);
        if field.changed() {
            commands.push(ClassCommand::Name(name).into());
        }
    });
    let link = link_to(&pairs);
    ui.add_space(theme::GAP);
    ui.vertical_centered(|ui| {
        let side = CODE.min(ui.available_width());
        if qr_code::show(ui, &link, side, "QR code of the link").is_none() {
            ui.label(RichText::new("The link is too long for a code.").weak());
        }
    });
    ui.add_space(theme::GAP);
    ui.horizontal(|ui| {
        ui.button(RichText::new(page_link::copying()).strong())
            .on_click(commands, FileCommand::Copy(Copied::Answers));
        let mut shown = link.as_str();
        let field = TextEdit::singleline(&mut shown).font(TextStyle::Monospace).desired_width(f32::INFINITY);
        ui.add(field).accessible_name("Link");
    });
}

/// The links of a class.
fn class(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let answers = &state.session.class;
    ui.label("Paste your pupils’ links: messages, the column of a table, the text of reports. They are read here, and sent nowhere.");
    ui.add_space(theme::GAP);
    let mut text = answers.text.clone();
    let ground = ui.visuals().widgets.inactive.weak_bg_fill;
    ScrollArea::vertical().id_salt("links").max_height(TEXT_HEIGHT).show(ui, |ui| {
        let field = TextEdit::multiline(&mut text)
            .background_color(ground)
            .hint_text(HINT)
            .desired_rows(LINES)
            .desired_width(f32::INFINITY);
        let field = ui.add(field.font(TextStyle::Monospace)).accessible_name("Links");
        focus::note_words(&field);
        if field.changed() {
            commands.push(ClassCommand::Text(text.clone()).into());
        }
    });
    ui.add_space(theme::GAP);
    let lessons = state.answered_lessons();
    for line in counts(&answers.collected, &lessons) {
        ui.label(line);
    }
    for unread in answers.collected.unread.iter().take(MOST_NAMED) {
        ui.colored_label(ui.visuals().error_fg_color, capitalised(&unread.to_string()));
    }
    if let Some(more) = answers.collected.unread.len().checked_sub(MOST_NAMED).filter(|more| *more > 0) {
        ui.colored_label(ui.visuals().error_fg_color, format!("And {more} more that cannot be read."));
    }
    ui.add_space(theme::GAP);
    ui.horizontal(|ui| {
        let save = RichText::new("Save the class’s page…").strong();
        ui.add_enabled_ui(!lessons.is_empty(), |ui| {
            ui.button(save)
                .on_hover_text(Product::ClassPage.tip())
                .on_click(commands, FileCommand::Choose(Purpose::Save(Product::ClassPage)));
        });
        ui.add_enabled(!answers.text.is_empty(), Button::new("Clear"))
            .on_click(commands, ClassCommand::Text(String::new()));
    });
}

/// Returns the numbers of pupils whose answers were `collected`, a line for each of these `lessons`.
fn counts(collected: &Collected, lessons: &[Arc<Lesson>]) -> Vec<String> {
    let pupils = |count: usize| format!("{count} {}", if count == 1 { "pupil" } else { "pupils" });
    let of = |lesson: &Arc<Lesson>| (lesson.title.clone(), collected.of(&lesson.name).count());
    let here: Vec<_> = lessons.iter().map(of).collect();
    let elsewhere = collected.answers.len() - here.iter().map(|(_, count)| count).sum::<usize>();
    let mut lines: Vec<_> =
        here.into_iter().map(|(title, count)| format!("{title}: {}", pupils(count))).collect();
    if elsewhere > 0 {
        lines.push(format!("Lessons that are not here: {}", pupils(elsewhere)));
    }
    if collected.replaced > 0 {
        lines.push(format!("Handed in again: {}. The last ones count.", collected.replaced));
    }
    if lines.is_empty() {
        lines.push("No answers yet.".to_owned());
    }
    lines
}
