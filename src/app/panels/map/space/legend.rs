//! The legend of the pictures' colours.

use std::sync::Arc;

use eframe::egui::{Color32, Galley, Rect, TextStyle, Ui, Vec2, pos2, vec2};

use super::sheet::colour;
use crate::app::state::State;
use crate::app::widgets::theme;
use crate::map::BodyPicture;
use crate::settings::MapFrame;

/// Height of a row of the legend, and the most rows that it has.
const HEIGHT: f32 = 18.0;
const ROWS: usize = 2;
/// Height that a map with two rows has at least, in rows.
const LEAST_MAP: f32 = 4.0;
/// Side of a square of colour, and the space after it and after each entry.
const SQUARE: f32 = 9.0;
const AFTER: f32 = 4.0;
const BETWEEN: f32 = 8.0;

/// Each picture in words, and in fewer.
const WORDS: [(BodyPicture, [&str; 2]); 4] = [
    (BodyPicture::Measured, ["measured now", "now"]),
    (BodyPicture::Seen(0), ["left eye sees", "left eye"]),
    (BodyPicture::Seen(1), ["right eye sees", "right eye"]),
    (BodyPicture::Stereo, ["two eyes place it", "two eyes"]),
];
const ON_BOARD: [(BodyPicture, [&str; 2]); 1] =
    [(BodyPicture::Measured, ["measured now: at rest, at its full length", "measured now"])];

/// Shows it at the top of `rect`; what is left below it.
pub(super) fn show(ui: &Ui, state: &State, rect: Rect) -> Rect {
    let entries: &[_] = match state.document.settings.map_frame() {
        // Two eyes that ride place it in their own frame.
        MapFrame::Ground if state.document.settings.ride.is_on() => &WORDS[..3],
        MapFrame::Ground | MapFrame::Rider => &WORDS,
        MapFrame::Bicycle => &ON_BOARD,
    };
    let font = TextStyle::Small.resolve(ui.style());
    let [height, square_side] = [HEIGHT, SQUARE].map(|points| points * theme::text_scale(ui.style()));
    let laid_out = |which: usize| -> Vec<(Color32, Arc<Galley>)> {
        let entry = |(picture, words): &(BodyPicture, [&str; 2])| {
            let text =
                ui.painter().layout_no_wrap(words[which].to_owned(), font.clone(), ui.visuals().text_color());
            (colour(*picture, ui.visuals()), text)
        };
        entries.iter().map(entry).collect()
    };
    let width = |text: &Galley| text.size().x + square_side + AFTER;
    let in_rows = |which: usize| {
        let mut rows: Vec<Vec<(Color32, Arc<Galley>)>> = vec![Vec::new()];
        let mut left = 0.0;
        for (colour, text) in laid_out(which) {
            if left > 0.0 && left + width(&text) > rect.width() {
                rows.push(Vec::new());
                left = 0.0;
            }
            left += width(&text) + BETWEEN;
            if let Some(row) = rows.last_mut() {
                row.push((colour, text));
            }
        }
        rows
    };
    // Fewer words only where the map itself would be lower than the rows.
    let long = in_rows(0);
    let shown = if long.len() <= ROWS && rect.height() > LEAST_MAP * height { long } else { in_rows(1) };
    let mut top = rect.min.y;
    for row in shown {
        let mut left = pos2(rect.min.x, top + height / 2.0);
        for (colour, text) in row {
            let square =
                Rect::from_center_size(left + vec2(square_side / 2.0, 0.0), Vec2::splat(square_side));
            ui.painter().rect_filled(square, 2.0, colour);
            let place = left + vec2(square_side + AFTER, -text.size().y / 2.0);
            left.x += width(&text) + BETWEEN;
            ui.painter().galley(place, text, ui.visuals().text_color());
        }
        top += height;
    }
    rect.with_min_y((top + 2.0).min(rect.max.y))
}
