//! Pictures on the cards of the start page.

use eframe::egui::epaint::{CornerRadius, RectShape};
use eframe::egui::{Color32, Rect, TextStyle, TextureHandle, Ui, pos2, vec2};

use crate::lesson::card;

/// Height of a picture in its widths.
pub const ASPECT: f32 = card::SIZE[1] as f32 / card::SIZE[0] as f32;
/// Radius of its corners, points.
pub const RADIUS: u8 = 9;

/// Draws `picture` into `rect`; a quiet place until there is one.
pub fn paint(ui: &Ui, rect: Rect, corners: CornerRadius, picture: Option<&TextureHandle>) {
    let shape = match picture {
        Some(picture) => {
            let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            RectShape::filled(rect, corners, Color32::WHITE).with_texture(picture.id(), whole)
        }
        None => RectShape::filled(rect, corners, ui.visuals().faint_bg_color),
    };
    ui.painter().add(shape);
}

/// Writes `text` into the corner of a picture in `rect`.
pub fn tag(ui: &Ui, rect: Rect, text: &str, [ground, ink]: [Color32; 2]) {
    let font = TextStyle::Small.resolve(ui.style());
    let galley = ui.painter().layout_no_wrap(text.to_owned(), font, ink);
    let around = vec2(7.0, 3.0);
    let tag = Rect::from_min_size(rect.min + vec2(8.0, 8.0), galley.size() + 2.0 * around);
    ui.painter().rect_filled(tag, 6.0, ground);
    ui.painter().galley(tag.min + around, galley, ink);
}
