//! The start page: a moving picture with the ways in, and the chapters; the lessons of a chapter; and all
//! presets.

mod card;
mod head;
mod margins;
mod picture;
#[cfg(not(feature = "desktop"))]
mod program;
mod words;

use std::sync::Arc;

use eframe::egui::style::ScrollStyle;
use eframe::egui::{Button, Key, Memory, RichText, ScrollArea, TextStyle, Ui, UiBuilder, vec2};
use gamow_platform::messages;

use self::card::{Card, Cards};
use super::{Commands, OnClick as _};
use crate::app::commands::actions::with_keys;
use crate::app::commands::{Command, FileCommand, ShowCommand, WindowCommand};
use crate::app::state::State;
use crate::app::state::lesson::LessonCommand;
use crate::app::state::overlay::Overlay;
use crate::app::views::start_picture::StartPicture;
use crate::app::views::thumbnails::Thumbnails;
use crate::app::widgets::theme;
use crate::lesson::{Chapter, Lesson, Library, Refused};
use crate::settings::{Preset, PresetGroup};

/// Sizes of headings of pages and of sections, in those of most writing.
const PAGE: f32 = 2.0;
const SECTION: f32 = 1.2;
/// Maximum number of unreadable lessons listed with the reason.
const MOST_REFUSED: usize = 20;
/// Step of the arrow keys in scrolling, points.
const LINE: f32 = 60.0;

/// The pictures of the page.
pub struct Pictures<'a> {
    /// Moving picture, where there is a device that draws it.
    pub head: Option<&'a mut StartPicture>,
    /// Pictures on cards.
    pub cards: &'a mut Thumbnails,
}

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

/// Shows the page that the state names.
pub fn show(ui: &mut Ui, state: &State, pictures: Pictures<'_>, commands: &mut Commands) {
    let overlay = state.session.overlay;
    let library = state.library();
    let chapters = library.chapters();
    let opened = match overlay {
        Some(Overlay::Chapter(number)) => chapters.get(number),
        _ => None,
    };
    // The picture reaches below it.
    ui.spacing_mut().scroll = ScrollStyle::floating();
    // Each page has a place to which it is scrolled.
    let area = ScrollArea::vertical().id_salt(overlay.as_ref().map(std::mem::discriminant));
    area.auto_shrink([false, false]).show(ui, |ui| {
        scroll(ui);
        ui.spacing_mut().item_spacing.y = theme::text_scale(ui.style()) * 8.0;
        match opened {
            Some(chapter) => within(ui, |ui| lessons(ui, state, chapter, pictures.cards, commands)),
            None if overlay == Some(Overlay::Presets) => {
                within(ui, |ui| presets(ui, state, pictures.cards, commands));
            }
            None => front(ui, state, &library, pictures, commands),
        }
    });
}

/// Shows `contents` between the margins of the page.
fn within(ui: &mut Ui, contents: impl FnOnce(&mut Ui)) {
    let scale = theme::text_scale(ui.style());
    let room = ui.available_rect_before_wrap();
    let width = margins::inner_width(room.width(), scale);
    let within = room.with_min_x(room.center().x - 0.5 * width).with_max_x(room.center().x + 0.5 * width);
    ui.scope_builder(UiBuilder::new().max_rect(within), |ui| {
        ui.add_space(scale * 14.0);
        contents(ui);
        ui.add_space(scale * 24.0);
    });
}

/// Shows the first page.
fn front(ui: &mut Ui, state: &State, library: &Library, pictures: Pictures<'_>, commands: &mut Commands) {
    head::show(ui, state, library, pictures.head, commands);
    within(ui, |ui| {
        let chapters = library.chapters();
        let numbered = chapters.iter().enumerate();
        let cards: Vec<_> =
            numbered.filter_map(|(number, chapter)| of_chapter(state, number, chapter)).collect();
        Cards::Chapters.show(ui, &cards, pictures.cards, commands);
        refused(ui, &library.refused);
        ui.horizontal_wrapped(|ui| {
            let open = Command::Window(WindowCommand::Toggle(Overlay::Presets));
            let tip = with_keys("Shows all presets, in four groups.", std::slice::from_ref(&open));
            ui.button("Presets").on_hover_text(tip).on_click(commands, open);
            ui.label(RichText::new(words::presets()).weak());
        });
        ui.label(RichText::new(words::OWN).weak());
        #[cfg(not(feature = "desktop"))]
        {
            section(ui, "On a desktop");
            ui.label(RichText::new(program::INTRODUCTION).weak());
            program::show(ui);
        }
    });
}

/// Shows the lessons of `chapter`.
fn lessons(
    ui: &mut Ui,
    state: &State,
    chapter: &Chapter<'_>,
    thumbnails: &mut Thumbnails,
    commands: &mut Commands,
) {
    let remark = format!("{}. {}", words::chapter(chapter, &state.session.answers), words::LESSON);
    title(ui, chapter.title, &remark, commands);
    let cards: Vec<_> =
        chapter.lessons.iter().map(|(number, lesson)| of_lesson(state, *number, lesson)).collect();
    Cards::Lessons.show(ui, &cards, thumbnails, commands);
}

/// Shows all presets, by group.
fn presets(ui: &mut Ui, state: &State, thumbnails: &mut Thumbnails, commands: &mut Commands) {
    title(ui, "Presets", words::PRESETS, commands);
    let library = state.library();
    for group in PresetGroup::ALL {
        section(ui, group.title());
        let of_group = |lesson: &&Arc<Lesson>| {
            lesson.is_a_preset() && Preset::named(&lesson.name).is_some_and(|preset| preset.group == group)
        };
        let cards: Vec<_> =
            library.all().iter().filter(of_group).filter_map(|lesson| of_preset(state, lesson)).collect();
        Cards::Presets.show(ui, &cards, thumbnails, commands);
    }
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

/// Shows the title of a page below the first, with the way back.
fn title(ui: &mut Ui, title: &str, remark: &str, commands: &mut Commands) {
    let body = TextStyle::Body.resolve(ui.style()).size;
    let back = Command::Window(WindowCommand::Toggle(Overlay::Start));
    let tip = with_keys("Returns to the start page.", std::slice::from_ref(&back));
    ui.add(Button::new("← Start page").frame(false)).on_hover_text(tip).on_click(commands, back);
    ui.label(RichText::new(title).size(PAGE * body).strong());
    ui.label(RichText::new(remark).weak());
    ui.add_space(0.5 * body);
}

fn section(ui: &mut Ui, title: &str) {
    let body = TextStyle::Body.resolve(ui.style()).size;
    ui.add_space(0.6 * body);
    ui.label(RichText::new(title).size(SECTION * body).strong());
}

/// Returns the card of the chapter with this number, from 0.
fn of_chapter<'a>(state: &State, number: usize, chapter: &Chapter<'a>) -> Option<Card<'a>> {
    let (_, first) = chapter.lessons.first()?;
    let is_open = state
        .course()
        .is_some_and(|course| chapter.lessons.iter().any(|(_, lesson)| lesson.name == course.lesson().name));
    Some(Card {
        lesson: first,
        title: chapter.title,
        number: None,
        details: words::chapter(chapter, &state.session.answers),
        text: String::new(),
        tip: words::titles(chapter),
        state: is_open.then(|| "Open".to_owned()),
        command: Command::Window(WindowCommand::Toggle(Overlay::Chapter(number))),
    })
}

fn of_lesson<'a>(state: &State, number: usize, lesson: &'a Arc<Lesson>) -> Card<'a> {
    let open = state.course().filter(|course| course.lesson().name == lesson.name);
    let command = match (open, state.session.overlay) {
        (Some(_), Some(page)) => Command::Window(WindowCommand::Toggle(page)),
        _ => Command::Lesson(LessonCommand::Open(lesson.name.clone())),
    };
    Card {
        lesson,
        title: &lesson.title,
        number: Some(number),
        details: words::details(lesson, &state.session.answers),
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
        title: &lesson.title,
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
