//! The words for an audience, below the picture, so large that the last row reads them: the speed and the
//! title, beside them what is seen and why, and the keys that show more.

use eframe::egui::{
    Align, Color32, Context, CursorIcon, FontId, Label, Layout, Rect, RichText, Sense, TextStyle, Ui,
    UiBuilder, vec2,
};

use super::{BETWEEN_NOTES, Commands, OnClick as _};
use crate::app::commands::actions::keys_of;
use crate::app::commands::choice_keys;
use crate::app::commands::{Command, FileCommand, SettingsCommand, Switch};
use crate::app::state::State;
use crate::app::state::files::purpose::{Product, Purpose};
use crate::app::state::stage::SidePanel;
use crate::app::widgets::fitted;
use crate::app::widgets::theme;
use crate::caption::beginnings;

/// Least size of writing before an audience, as a part of the window's height.
pub const LEAST_SHARE: f32 = 0.03;
/// Largest and smallest sizes of a lesson's words, as parts of the same height. The smallest is for windows
/// that nobody presents in: in those of usual shapes all that comes with the program stays above
/// [`LEAST_SHARE`].
const LESSON_SIZES: [f32; 2] = [0.042, 0.018];
/// Sizes of a caption, as multiples of the least: it gets as many sentences as have room at the middle one,
/// and the largest at which they have it.
const CAPTION_SIZES: [f32; 4] = [1.4, 1.27, 1.13, 1.0];
/// Greatest number of lines of a caption.
const CAPTION_LINES: usize = 3;
/// Bounds of how much larger than usual writing is for an audience, for windows of any size.
const SCALES: [f32; 2] = [0.8, 12.0];
/// Size of the speed, relative to the other words.
const SPEED: f32 = 1.6;
/// Height of the smallest writing in a window of this height that is less wide than high, in widths.
const LEAST_ASPECT: f32 = 0.75;
/// Share of the width that the speed and the title have, and of the height that the keys have.
const HEADING_WIDTH: f32 = 0.2;
const KEYS_HEIGHT: f32 = 1.3;

/// Written between two keys.
const APART: &str = "·";

/// Returns the magnification of writing for an audience in a window with this inner `area`: the smallest is
/// as high as the last row needs, and larger with the window's zoom.
#[must_use]
pub fn scale(ctx: &Context, area: Rect) -> f32 {
    let height = area.height().min(LEAST_ASPECT * area.width()) * ctx.zoom_factor();
    let [least, most] = SCALES;
    (LEAST_SHARE * height / theme::SMALL_SIZE).clamp(least, most)
}

/// Shows the words: the heading on the left, beside it the `lesson` or the caption of the preset. The
/// `notes` say where the picture is not what an eye would see.
pub fn show(
    ui: &mut Ui,
    state: &State,
    notes: &str,
    lesson: Option<(String, impl FnOnce(&mut Ui, &State, &mut Commands))>,
    commands: &mut Commands,
) {
    let rect = ui.max_rect();
    let least = TextStyle::Small.resolve(ui.style()).size;
    let (heading_room, words) = rect.split_left_right_at_fraction(HEADING_WIDTH);
    let words = words.with_min_x(words.min.x + least);
    let keys = keys(state);
    if let Some((key, lesson)) = lesson {
        let keys: Vec<_> = keys.into_iter().map(|(text, _)| text).collect();
        heading(ui, state, heading_room, [notes, &keys.join(" · ")]);
        ui.scope_builder(UiBuilder::new().id_salt("words").max_rect(words), |ui| {
            fitting(ui, key, |ui| lesson(ui, state, commands));
        });
    } else {
        heading(ui, state, heading_room, [""; 2]);
        let share = (1.0 - KEYS_HEIGHT * least / words.height().max(1.0)).clamp(0.0, 1.0);
        let (words, foot) = words.split_top_bottom_at_fraction(share);
        caption(ui, state, words, least);
        line(ui, foot, notes, keys, commands);
    }
}

/// Shows `contents` of a lesson as large as fits into the room of `ui`; `key` identifies them.
pub fn fitting(ui: &mut Ui, key: String, contents: impl FnOnce(&mut Ui)) {
    let height = theme::text_scale(ui.style()) * theme::SMALL_SIZE / LEAST_SHARE;
    fitted::show(ui, key, LESSON_SIZES.map(|share| share * height), |ui| {
        ui.spacing_mut().item_spacing.y = 0.25 * TextStyle::Body.resolve(ui.style()).size;
        contents(ui);
    });
}

/// Writes the speed and the title into `rect`, and at its bottom those of the `others` that have room.
fn heading(ui: &mut Ui, state: &State, rect: Rect, others: [&str; 2]) {
    ui.scope_builder(UiBuilder::new().id_salt("heading").max_rect(rect), |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        let strong = ui.visuals().strong_text_color();
        let least = TextStyle::Small.resolve(ui.style()).size;
        let write = |ui: &mut Ui, text: RichText| ui.add(Label::new(text).selectable(false));
        write(ui, RichText::new(state.told_speed_text()).size(SPEED * least).color(strong));
        if let Some(others) = state.others_speed_text() {
            write(ui, RichText::new(others).size(least));
        }
        write(ui, RichText::new(title(state)).size(least).weak());
        let free = ui.available_rect_before_wrap().intersect(rect);
        let font = FontId::proportional(least);
        let mut room = free;
        for text in others.into_iter().rev().filter(|text| !text.is_empty()) {
            let galley = ui.painter().layout(text.to_owned(), font.clone(), strong, room.width().max(1.0));
            if galley.size().y > room.height() {
                continue;
            }
            let place = Rect::from_min_max(room.left_bottom() - vec2(0.0, galley.size().y), room.max);
            room.max.y = place.min.y;
            ui.scope_builder(UiBuilder::new().id_salt(text).max_rect(place), |ui| {
                write(ui, RichText::new(text).size(least).weak());
            });
        }
    });
}

/// The title of what is shown: of the lesson, with its step, of the preset or of the scene.
fn title(state: &State) -> String {
    if let Some(course) = state.course() {
        let (lesson, step) = (course.lesson(), course.place().step);
        let count = lesson.steps.len();
        let place =
            if count > 1 && step < count { format!("  {} of {count}", step + 1) } else { String::new() };
        return format!("{}{place}", lesson.title);
    }
    let preset = state.told_preset().map(|preset| preset.title.clone());
    preset.unwrap_or_else(|| state.document.scene.name.clone())
}

/// Writes the caption of the preset into `rect`, or the moment in words on request: as many
/// whole sentences as have room.
fn caption(ui: &mut Ui, state: &State, rect: Rect, least: f32) {
    let text = match state.told_preset() {
        Some(preset) if !state.session.stage.audience.tells_moment => preset.caption.clone(),
        None if !state.session.stage.audience.tells_moment => return,
        _ => state.moment().sentence().replace(" nm", "\u{a0}nm").replace(" = ", "\u{a0}=\u{a0}"),
    };
    let colour = ui.visuals().strong_text_color();
    let fits = |text: &str, size: f32| {
        let font = FontId::proportional(size * least);
        let galley = ui.painter().layout(text.to_owned(), font, colour, rect.width().max(1.0));
        galley.rows.len() <= CAPTION_LINES && galley.size().y <= rect.height()
    };
    let beginnings = beginnings(&text);
    let [_, _, usual, smallest] = CAPTION_SIZES;
    let longest = |size: f32| beginnings.iter().rev().find(|text| fits(text, size));
    let shown = longest(usual).or_else(|| longest(smallest)).or(beginnings.first());
    let Some(shown) = shown else { return };
    let size = CAPTION_SIZES.into_iter().find(|size| fits(shown, *size)).unwrap_or(smallest);
    ui.scope_builder(UiBuilder::new().id_salt("caption").max_rect(rect), |ui| {
        ui.set_clip_rect(rect.intersect(ui.clip_rect()));
        ui.add(Label::new(RichText::new(shown.as_str()).size(size * least).color(colour)).selectable(false));
    });
}

/// Writes the notes at the left end of a line and the keys at the right one; a click on a key is as good as a
/// press.
fn line(ui: &mut Ui, rect: Rect, notes: &str, keys: Vec<ShownKey>, commands: &mut Commands) {
    let written = |text: &str| Label::new(RichText::new(text).small().weak()).selectable(false).truncate();
    ui.scope_builder(UiBuilder::new().id_salt("keys").max_rect(rect), |ui| {
        let size = TextStyle::Small.resolve(ui.style()).size;
        ui.spacing_mut().item_spacing.x = 0.3 * size;
        ui.with_layout(Layout::right_to_left(Align::Max), |ui| {
            for (number, (text, command)) in keys.into_iter().rev().enumerate() {
                if number > 0 {
                    ui.add(written(APART));
                }
                let Some(command) = command else {
                    ui.add(written(&text));
                    continue;
                };
                let key = ui.add(written(&text).sense(Sense::click()));
                key.on_hover_cursor(CursorIcon::PointingHand).on_click(commands, command);
            }
            ui.add_space(size);
            let room = ui.available_width();
            let fits = |text: &str| {
                let font = FontId::proportional(size);
                ui.painter().layout_no_wrap(text.to_owned(), font, Color32::WHITE).size().x <= room
            };
            // No note is cut: the last ones give way.
            let parts: Vec<&str> = notes.split(BETWEEN_NOTES).collect();
            let shorter = (1..=parts.len()).rev().map(|count| parts[..count].join(BETWEEN_NOTES));
            let notes = shorter.into_iter().find(|text| fits(text)).unwrap_or_default();
            ui.with_layout(Layout::left_to_right(Align::Max), |ui| ui.add(written(&notes)));
        });
    });
}

/// A key with what it does, and its command if it has a single one.
type ShownKey = (String, Option<Command>);

/// The keys that show an audience more or less, and the one that saves the passage.
fn keys(state: &State) -> Vec<ShownKey> {
    let panel = state.side_panel();
    let is_plot = matches!(panel, SidePanel::Plot | SidePanel::Fit);
    let eyes = if state.has_both_eyes() { "one eye" } else { "two eyes" };
    let shown = [
        (Switch::BothEyes, eyes),
        (Switch::Plots, if is_plot { "no plot" } else { "plot" }),
        (Switch::Map, if panel == SidePanel::Map { "no map" } else { "map" }),
    ];
    let switched = |(switch, shows)| (Command::Settings(SettingsCommand::Switch(switch)), shows);
    // While choices stand there, the letters are theirs.
    let count = choice_keys::count(state);
    // Beside the projector's window the lecturer has controls.
    let is_alone = state.session.stage.is_presented();
    let is_free = |switch: Switch| is_alone && (count < 2 || switch != Switch::BothEyes);
    let free = shown.into_iter().filter(|(switch, _)| is_free(*switch));
    let film = (Command::File(FileCommand::Choose(Purpose::Save(Product::TenSeconds))), "film");
    let film = Some(film).filter(|_| is_alone && state.session.lesson.is_none());
    let keys = free.map(switched).chain(film).map(|(command, does)| {
        let text = format!("{} {does}", keys_of(std::slice::from_ref(&command)));
        (text.replace(' ', "\u{a0}"), Some(command))
    });
    let answers = (count > 0).then(|| (format!("A–{}\u{a0}answer", choice_keys::letter_of(count - 1)), None));
    answers.into_iter().chain(keys).collect()
}
