//! The start page: what this is, all lessons, and all presets, each with a picture of what it shows.

mod card;
mod picture;
#[cfg(not(feature = "desktop"))]
mod program;
mod words;

use std::sync::Arc;

use eframe::egui::{Button, Key, Memory, RichText, ScrollArea, TextStyle, Ui, UiBuilder, Vec2, vec2};
use gamow_platform::messages;

use self::card::{Card, Cards};
use super::Commands;
use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, FileCommand, ShowCommand, WindowCommand};
use crate::app::state::State;
use crate::app::state::lesson::LessonCommand;
use crate::app::state::overlay::Overlay;
use crate::app::views::thumbnails::Thumbnails;
use crate::app::widgets::theme;
use crate::lesson::{Lesson, Refused};
use crate::settings::Preset;

/// The widest that what is on the page becomes, and what stays free at its sides, points.
const WIDEST: f32 = 1720.0;
const SIDES: f32 = 32.0;
/// Greatest width of lines of the introduction, points.
const WIDEST_LINES: f32 = 680.0;
/// Width from which on the eyes' pictures are beside the introduction, points, and the share of the width
/// that they take.
const NARROWEST_WITH_EYES: f32 = 1000.0;
const WORDS: f32 = 0.54;
/// Sizes of the heading, of the headings of sections, and of what is written below the first, in those of
/// most writing.
const HEADING: f32 = 2.0;
const SECTION: f32 = 1.4;
const INTRODUCTION: f32 = 1.1;
/// Maximum number of unreadable lessons listed with the reason.
const MOST_REFUSED: usize = 20;
/// Step of the arrow keys in scrolling, points.
const LINE: f32 = 60.0;

/// Returns whether `command`, from a key, is performed while the page is shown: one that changes nothing
/// behind it.
#[must_use]
pub const fn lets_through(command: &Command) -> bool {
    matches!(
        command,
        Command::Window(
            WindowCommand::Toggle(_)
                | WindowCommand::Close
                | WindowCommand::ToggleFullScreen
                | WindowCommand::TogglePresenting
                | WindowCommand::ToggleProjector
        ) | Command::File(FileCommand::Choose(_))
    )
}

/// Shows the start page.
pub fn show(ui: &mut Ui, state: &State, thumbnails: &mut Thumbnails, commands: &mut Commands) {
    let scale = theme::text_scale(ui.style());
    let area = ScrollArea::vertical().auto_shrink([false, false]);
    area.show(ui, |ui| {
        scroll(ui);
        let room = ui.available_rect_before_wrap();
        let width = (room.width() - 2.0 * SIDES).min(scale * WIDEST).max(1.0);
        let within = room.with_min_x(room.center().x - 0.5 * width).with_max_x(room.center().x + 0.5 * width);
        ui.scope_builder(UiBuilder::new().max_rect(within), |ui| {
            ui.spacing_mut().item_spacing.y = scale * 8.0;
            ui.add_space(scale * 20.0);
            let library = state.library();
            let (presets, lessons): (Vec<_>, Vec<_>) =
                library.all().iter().partition(|lesson| lesson.is_a_preset());
            head(ui, state, &lessons, presets.first().copied(), thumbnails, commands);
            section(ui, "Lessons", &words::extent(&lessons));
            let numbered = lessons.iter().enumerate();
            let cards: Vec<_> = numbered.map(|(number, lesson)| of_lesson(state, number, lesson)).collect();
            Cards::OfLessons.show(ui, &cards, thumbnails, commands);
            refused(ui, library.refused());
            section(ui, "Presets", words::PRESETS);
            let cards: Vec<_> = presets.iter().filter_map(|lesson| of_preset(state, lesson)).collect();
            Cards::OfPresets.show(ui, &cards, thumbnails, commands);
            ui.add_space(scale * 12.0);
            ui.label(RichText::new(words::OWN).weak());
            #[cfg(not(feature = "desktop"))]
            {
                section(ui, "On a desktop", program::INTRODUCTION);
                program::show(ui);
            }
            ui.add_space(scale * 24.0);
        });
    });
}

/// Says which lessons of a folder cannot be read, and why.
fn refused(ui: &mut Ui, refused: &[Refused]) {
    let colour = ui.visuals().error_fg_color;
    for Refused { error, .. } in refused.iter().take(MOST_REFUSED) {
        ui.colored_label(colour, messages::in_short(&messages::shown(&error.to_string())));
    }
    if let Some(more) = refused.len().checked_sub(MOST_REFUSED).filter(|more| *more > 0) {
        ui.colored_label(
            colour,
            format!("{more} more lessons cannot be read: `gamow --lessons DIR --list` names them."),
        );
    }
}

/// Shows the introduction, and, where there is room, both eyes' pictures of the `start`.
fn head(
    ui: &mut Ui,
    state: &State,
    lessons: &[&Arc<Lesson>],
    start: Option<&Arc<Lesson>>,
    thumbnails: &mut Thumbnails,
    commands: &mut Commands,
) {
    let room = ui.available_rect_before_wrap();
    let is_wide = room.width() >= theme::text_scale(ui.style()) * NARROWEST_WITH_EYES;
    let end = if is_wide { room.min.x + WORDS * room.width() } else { room.max.x };
    let words = UiBuilder::new().max_rect(room.with_max_x(end));
    let words = ui.scope_builder(words, |ui| introduction(ui, state, lessons, commands)).response.rect;
    if let Some(start) = start.filter(|_| is_wide) {
        let beside = words.with_min_x(end + SIDES).with_max_x(room.max.x);
        let pictures = picture::both_eyes(ui, beside, start, thumbnails);
        ui.add_space((pictures.max.y - words.max.y).max(0.0));
    }
}

/// Shows the introduction, and the way in.
fn introduction(ui: &mut Ui, state: &State, lessons: &[&Arc<Lesson>], commands: &mut Commands) {
    let body = TextStyle::Body.resolve(ui.style()).size;
    let scale = theme::text_scale(ui.style());
    ui.set_max_width(ui.available_width().min(scale * WIDEST_LINES));
    ui.label(RichText::new(words::HEADING).size(HEADING * body).strong());
    ui.label(RichText::new(words::INTRODUCTION).size(INTRODUCTION * body));
    ui.add_space(4.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().button_padding = Vec2::new(1.1, 0.6) * body;
        if let Some((words, command)) = way_in(state, lessons) {
            let [ground, ink] = theme::primary_colours(ui.visuals());
            let words = RichText::new(words).size(INTRODUCTION * body).strong().color(ink);
            if ui.add(Button::new(words).fill(ground)).clicked() {
                commands.push(command);
            }
        }
        let around = Button::new(RichText::new("Look around").size(INTRODUCTION * body));
        let tip = with_keys(
            "Closes this page. Lessons, above, brings it back.",
            &[Command::Window(WindowCommand::Toggle(Overlay::Start))],
        );
        if ui.add(around).on_hover_text(tip).clicked() {
            commands.push(WindowCommand::Toggle(Overlay::Start).into());
        }
    });
}

/// Returns the way in: the lesson that is open, else the one that comes next.
fn way_in(state: &State, lessons: &[&Arc<Lesson>]) -> Option<(String, Command)> {
    if let Some(course) = state.course() {
        return Some((
            format!("Go on: {}", course.lesson().title),
            Command::Window(WindowCommand::Toggle(Overlay::Start)),
        ));
    }
    let next = lessons.iter().find(|lesson| state.session.next_lesson.as_ref() == Some(&lesson.name));
    let next = next.or(lessons.first())?;
    let command = Command::Lesson(LessonCommand::Open(next.name.clone()));
    let word = if state.session.answers.progress(next).is_some() { "Go on" } else { "Begin" };
    Some((format!("{word}: {}", next.title), command))
}

fn section(ui: &mut Ui, title: &str, remark: &str) {
    let body = TextStyle::Body.resolve(ui.style()).size;
    ui.add_space(1.3 * body);
    ui.label(RichText::new(title).size(SECTION * body).strong());
    ui.label(RichText::new(remark).weak());
    ui.add_space(0.2 * body);
}

fn of_lesson<'a>(state: &State, number: usize, lesson: &'a Arc<Lesson>) -> Card<'a> {
    let open = state.course().filter(|course| course.lesson().name == lesson.name);
    let command = match open {
        Some(_) => Command::Window(WindowCommand::Toggle(Overlay::Start)),
        None => Command::Lesson(LessonCommand::Open(lesson.name.clone())),
    };
    Card {
        lesson,
        number: Some(number + 1),
        details: words::details(lesson),
        text: words::summary(&lesson.introduction.markdown),
        tip: words::plain(&lesson.introduction.markdown, usize::MAX),
        state: open.map(words::place),
        command,
    }
}

fn of_preset<'a>(state: &State, lesson: &'a Arc<Lesson>) -> Option<Card<'a>> {
    let preset = Preset::named(&lesson.name)?;
    let is_shown = state.document.preset == Some(preset) && state.course().is_none();
    Some(Card {
        lesson,
        number: None,
        details: String::new(),
        text: String::new(),
        tip: preset.caption.clone(),
        state: is_shown.then(|| "Shown".to_owned()),
        command: Command::Show(ShowCommand::Preset(preset)),
    })
}

/// Scrolls by the keys. The arrows go from card to card instead once one has the keyboard.
fn scroll(ui: &Ui) {
    let page = 0.9 * ui.clip_rect().height();
    let is_at_a_card = ui.memory(Memory::focused).is_some();
    let line = if is_at_a_card { 0.0 } else { LINE };
    let all = 1e6;
    let keys = [
        (Key::ArrowDown, line),
        (Key::ArrowUp, -line),
        (Key::PageDown, page),
        (Key::PageUp, -page),
        (Key::End, all),
        (Key::Home, -all),
    ];
    let down: f32 = keys
        .into_iter()
        .filter(|(key, _)| ui.input(|input| input.key_pressed(*key)))
        .map(|(_, down)| down)
        .sum();
    if down != 0.0 {
        ui.scroll_with_delta(vec2(0.0, -down));
    }
}
