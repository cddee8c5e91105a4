//! Labels of the map: written where they cover neither marks nor each other, on a little of the background.

use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, TextStyle, Ui};

use crate::plot::{Area, LabelPlaces};

/// The labels of a chart.
pub struct MapLabels {
    /// Places of the labels, and what they avoid.
    pub places: LabelPlaces,
    painter: Painter,
    font: FontId,
    background: Color32,
}

impl MapLabels {
    /// Nothing yet in `room`, which no label leaves; `painter` will write them.
    pub fn new(ui: &Ui, painter: &Painter, room: Rect) -> Self {
        Self {
            places: LabelPlaces::new(room.shrink(2.0), 0.0),
            painter: painter.clone(),
            font: TextStyle::Small.resolve(ui.style()),
            background: ui.visuals().extreme_bg_color,
        }
    }

    /// Writes `text` beside a mark of this `radius` at `place`, on the side where it covers least; not at all
    /// where it would cover another label or leave the room. Returns whether it was written.
    pub fn write(&mut self, (place, radius): (Pos2, f32), text: &str, colour: Color32) -> bool {
        let galley = self.painter.layout_no_wrap(text.to_owned(), self.font.clone(), colour);
        let beside = Area::beside(place, radius, galley.size());
        let Some(rect) = self.places.take_free(beside).map(Rect::from) else { return false };
        self.painter.rect_filled(rect, 2.0, self.background.gamma_multiply(0.6));
        self.painter.galley(rect.min, galley, colour);
        true
    }

    /// Writes `text` at `place` and nowhere else, where it is free.
    pub fn write_at(&mut self, (place, align): (Pos2, Align2), text: &str, colour: Color32) {
        let galley = self.painter.layout_no_wrap(text.to_owned(), self.font.clone(), colour);
        let rect = align.anchor_size(place, galley.size());
        if self.places.take_free([rect]).is_some() {
            self.painter.galley(rect.min, galley, colour);
        }
    }
}
