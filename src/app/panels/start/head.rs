//! The head of the start page: a moving picture across the window, and over it words and the ways in.

use std::sync::Arc;

use eframe::egui::epaint::{Mesh, RectShape};
use eframe::egui::text::{LayoutJob, TextFormat, TextWrapping};
use eframe::egui::{
    Align, Button, Color32, FontId, Galley, Label, Layout, Rect, RichText, Sense, Theme, Ui, UiBuilder, pos2,
    vec2,
};

use super::{margins, words};
use crate::app::commands::{Command, PlaybackCommand, ShowCommand, WindowCommand};
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::app::state::lesson::LessonCommand;
use crate::app::state::overlay::Overlay;
use crate::app::views::start_picture::{ShownStartPicture, StartPicture};
use crate::app::widgets::theme;
use crate::lesson::Library;
use crate::settings::Preset;

/// Height of the picture as a share of the page's, and the least, points.
const SHARE: f32 = 0.53;
const LOWEST: f32 = 220.0;
/// Size of the heading as a share of the page's width, and its bounds, points.
const HEADING: f32 = 0.04;
const HEADINGS: [f32; 2] = [27.0, 52.0];
/// Size of the line below the heading and of the buttons' text as a share of the heading's, and the bounds,
/// points.
const LINE: f32 = 0.42;
const LINES: [f32; 2] = [14.0, 20.0];
/// Width below which the buttons stand one below the other, points.
const NARROWEST_ROW: f32 = 560.0;
/// Space between the words and the buttons, and around them above and below; points.
const BETWEEN: f32 = 12.0;
const MARGIN: f32 = 28.0;
/// Opacity of the shade behind the words, at the lower edge of the picture.
const SHADE: u8 = 215;

/// A way into the program: the words on its button, and the commands that follow.
struct WayIn {
    words: String,
    commands: Vec<Command>,
}

/// Shows the head in the full width of the page.
pub fn show(
    ui: &mut Ui,
    state: &State,
    library: &Library,
    picture: Option<&mut StartPicture>,
    commands: &mut Commands,
) {
    let scale = theme::text_scale(ui.style());
    let (width, page) = (ui.available_width(), ui.clip_rect().height());
    let inner = margins::inner_width(width, scale);
    let size = (HEADING * width).clamp(scale * HEADINGS[0], scale * HEADINGS[1]);
    let line = (LINE * size).clamp(scale * LINES[0], scale * LINES[1]);
    let heading = laid(ui, words::HEADING, size, inner);
    let words = laid(ui, words::LINE, line, inner);
    let is_row = width >= scale * NARROWEST_ROW;
    let between = scale * BETWEEN;
    let button = 2.4 * line;
    let buttons = if is_row { button } else { 3.0 * button + 2.0 * between };
    let height = heading.size().y + words.size().y + buttons + 2.0 * between;
    let room = vec2(width, (height + 2.0 * scale * MARGIN).max(SHARE * page).max(LOWEST));
    let (rect, _) = ui.allocate_exact_size(room, Sense::hover());
    let shown = picture.filter(|_| ui.is_rect_visible(rect)).and_then(|picture| picture.picture(ui, rect));
    paint(ui, rect, shown, height + scale * MARGIN);
    let left = rect.center().x - 0.5 * inner;
    let mut top = rect.max.y - scale * MARGIN - height;
    // They stand on the picture, and the rest of the page below it.
    let ui = &mut ui.new_child(UiBuilder::new().max_rect(rect));
    for (galley, gap) in [(heading, 0.4 * between), (words, 1.6 * between)] {
        let place = Rect::from_min_size(pos2(left, top), galley.size());
        top = place.max.y + gap;
        ui.put(place, Label::new(galley).selectable(false));
    }
    // The picture is dark in either theme.
    *ui.visuals_mut() = ui.ctx().style_of(Theme::Dark).visuals.clone();
    ui.spacing_mut().item_spacing = vec2(between, between);
    ui.spacing_mut().button_padding.x = 1.3 * line;
    let layout = if is_row { Layout::left_to_right(Align::Center) } else { Layout::top_down(Align::Center) };
    let place = Rect::from_min_size(pos2(left, top), vec2(inner, buttons));
    let ui = &mut ui.new_child(UiBuilder::new().max_rect(place).layout(layout));
    let least = vec2(if is_row { 0.0 } else { inner }, button);
    for (number, way) in ways_in(state, library).into_iter().enumerate() {
        let text = RichText::new(way.words).size(line).color(Color32::WHITE);
        let mut shown = Button::new(text).min_size(least).truncate();
        if number == 0 {
            shown = shown.fill(theme::primary_colours(ui.visuals())[0]);
        }
        if ui.add(shown).clicked() {
            commands.extend(way.commands);
        }
    }
}

/// Returns the ways in: a ride, a passage, and the lesson that is open or comes next.
fn ways_in(state: &State, library: &Library) -> Vec<WayIn> {
    let ride = vec![ShowCommand::Ride.into()];
    let mut watch = vec![ShowCommand::Preset(Preset::start()).into(), PlaybackCommand::GoToPart(0.0).into()];
    if !state.scratch.playing {
        watch.push(PlaybackCommand::Toggle.into());
    }
    let ways = [("Get on and ride".to_owned(), ride), ("Watch a cyclist pass".to_owned(), watch)];
    let ways = ways.into_iter().chain(lesson(state, library));
    ways.map(|(words, commands)| WayIn { words, commands }).collect()
}

/// Returns the words and the commands of the lesson that is open, else of the one that comes next.
fn lesson(state: &State, library: &Library) -> Option<(String, Vec<Command>)> {
    if let Some(course) = state.course() {
        let back = WindowCommand::Toggle(Overlay::Start).into();
        return Some((format!("Go on: {}", course.lesson().title), vec![back]));
    }
    let mut lessons = library.all().iter().filter(|lesson| !lesson.is_a_preset());
    let first = lessons.next()?;
    let next = lessons.find(|lesson| state.session.next_lesson.as_ref() == Some(&lesson.name));
    let next = next.unwrap_or(first);
    let words = if state.session.answers.progress(next).is_some() {
        format!("Go on: {}", next.title)
    } else if next.name == first.name {
        format!("First lesson, {} min", next.minutes)
    } else {
        format!("Next lesson: {}", next.title)
    };
    Some((words, vec![LessonCommand::Open(next.name.clone()).into()]))
}

/// Lays out `text` in white, no wider than `width`.
fn laid(ui: &Ui, text: &str, size: f32, width: f32) -> Arc<Galley> {
    let format = TextFormat::simple(FontId::proportional(size), Color32::WHITE);
    let mut job = LayoutJob::single_section(text.to_owned(), format);
    job.wrap = TextWrapping::wrap_at_width(width);
    ui.painter().layout_job(job)
}

/// Draws the picture into `rect`, and a shade over the lowest `words` points of it.
fn paint(ui: &Ui, rect: Rect, shown: Option<ShownStartPicture>, words: f32) {
    let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
    painter.rect_filled(rect, 0.0, Color32::from_rgb(0x17, 0x20, 0x33));
    if let Some(ShownStartPicture { texture, dimmed }) = shown {
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        painter.add(RectShape::filled(rect, 0.0, Color32::WHITE).with_texture(texture, whole));
        painter.rect_filled(rect, 0.0, Color32::from_black_alpha((255.0 * dimmed) as u8));
    }
    let top = (rect.max.y - 1.6 * words).max(rect.min.y);
    let mut shade = Mesh::default();
    for (y, alpha) in [(top, 0), (rect.max.y, SHADE)] {
        for x in [rect.min.x, rect.max.x] {
            shade.colored_vertex(pos2(x, y), Color32::from_black_alpha(alpha));
        }
    }
    shade.add_triangle(0, 1, 2);
    shade.add_triangle(1, 2, 3);
    painter.add(shade);
}
