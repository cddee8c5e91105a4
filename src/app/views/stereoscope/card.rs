//! The size of a screen, found by a card of known size that is laid onto it.

use eframe::egui::{Color32, CursorIcon, Id, Rect, Sense, Stroke, StrokeKind, Ui, UiBuilder, pos2, vec2};

/// Long and short side of a bank card, mm (ISO/IEC 7810, ID-1).
pub const CARD_MM: [f64; 2] = [85.60, 53.98];
/// Least length that the side of a card is drawn with, points.
const LEAST: f32 = 120.0;
/// Height of a button with its margin, points.
const BUTTON: f32 = 40.0;
/// Margin around the card, and between its outline and the words in it, points.
const MARGIN: f32 = 12.0;

/// The outline of a card on the screen, whose right edge is dragged until it matches the card.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CardOutline {
    /// Size of a millimetre, points.
    points_per_mm: f32,
}

/// The answer to whether the outline matches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Match {
    /// Not yet.
    Open,
    /// The outline matches: a millimetre has this many points.
    Found(f64),
    /// The screen stays as it is.
    GivenUp,
}

/// Returns the side of a card that lies level in this `area`: the long one where that is wider than high.
fn level_side(area: Rect) -> f64 {
    CARD_MM[usize::from(area.width() < area.height())]
}

/// Returns the room that a card on this `outline` leaves in `area`: to its right, else below it.
fn beside(outline: Rect, area: Rect) -> Rect {
    let right = Rect::from_min_max(pos2(outline.max.x + 2.0 * MARGIN, outline.min.y), area.max);
    let below = Rect::from_min_max(pos2(outline.min.x, outline.max.y + 2.0 * MARGIN), area.max);
    if right.width() >= LEAST || below.height() < BUTTON {
        right.with_min_x(right.min.x.min(area.max.x - LEAST))
    } else {
        below
    }
}

impl CardOutline {
    /// The outline where a millimetre is believed to have this many points.
    #[must_use]
    pub const fn new(points_per_mm: f64) -> Self {
        Self { points_per_mm: points_per_mm as f32 }
    }

    /// Returns the outline in `area`.
    fn outline(self, area: Rect) -> Rect {
        let side = level_side(area) as f32;
        let [long, short] = CARD_MM.map(|side| side as f32);
        let length = (self.points_per_mm * side).clamp(LEAST, (area.width() - 2.0 * MARGIN).max(LEAST));
        let height = (length * long * short / (side * side)).min(area.height());
        Rect::from_min_size(pos2(area.min.x + MARGIN, area.center().y - 0.5 * height), vec2(length, height))
    }

    /// Shows the card in `area`, and reads its edge and its buttons.
    pub fn show(&mut self, ui: &mut Ui, area: Rect) -> Match {
        let outline = self.outline(area);
        let side = level_side(area) as f32;
        self.points_per_mm = outline.width() / side;
        let edge = ui.interact(area, Id::unique("edge of the card"), Sense::drag());
        let edge = edge.on_hover_cursor(CursorIcon::ResizeHorizontal);
        if edge.dragged() {
            self.points_per_mm = ((outline.width() + edge.drag_delta().x) / side).max(LEAST / side);
        }
        let painter = ui.painter();
        painter.rect_stroke(outline, 10.0, Stroke::new(1.5, Color32::GRAY), StrokeKind::Inside);
        let ends = [outline.right_top(), outline.right_bottom()];
        painter.line_segment(ends, Stroke::new(4.0, Color32::WHITE));
        let within = UiBuilder::new().id_salt("card").max_rect(outline.shrink(MARGIN));
        ui.scope_builder(within, |ui| {
            ui.label("Lay a bank card onto this outline, with its left edge on the left one.");
            ui.label("Drag the white edge until the card just fits: it is 85.60 mm by 53.98 mm.");
        });
        let within = UiBuilder::new().id_salt("beside the card").max_rect(beside(outline, area));
        ui.scope_builder(within, |ui| self.buttons(ui)).inner
    }

    fn buttons(self, ui: &mut Ui) -> Match {
        let mut answer = Match::Open;
        ui.horizontal_wrapped(|ui| {
            if ui.button("It matches").clicked() {
                answer = Match::Found(self.points_per_mm.into());
            }
            if ui.button("Leave it").clicked() {
                answer = Match::GivenUp;
            }
        });
        answer
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_outline_has_the_shape_of_a_card_and_fits_both_ways_of_a_phone() {
        for (size, side) in [(vec2(740.0, 360.0), 85.60), (vec2(360.0, 740.0), 53.98)] {
            let area = Rect::from_min_size(pos2(0.0, 0.0), size);
            // 160 points to an inch, as many phones have.
            let outline = CardOutline::new(160.0 / 25.4).outline(area);
            assert!(area.contains_rect(outline));
            let points: f64 = side * 160.0 / 25.4;
            assert!(
                (f64::from(outline.width()) - points.min(f64::from(size.x) - 24.0)).abs() < 1e-3,
                "{}",
                outline.width()
            );
            let room = beside(outline, area);
            assert!(!room.intersects(outline) && room.width() >= LEAST && room.height() >= BUTTON, "{room}");
            let aspect = f64::from(outline.height() / outline.width());
            let [long, short] = CARD_MM;
            let expected = if side == long { short / long } else { long / short };
            assert!((aspect - expected).abs() < 1e-3, "{aspect}");
        }
    }
}
