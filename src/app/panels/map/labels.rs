//! Labels that stay clear of marks, of lines, and of each other.

use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Vec2, vec2};

/// Space between a mark and its label, points.
const GAP: f32 = 3.0;
/// Between places at which a line is noted, points.
const STEP: f32 = 4.0;
/// Sides that differ by fewer of these places count as alike, so that a label holds still while things move.
const ALIKE: usize = 2;
/// The sides of a mark at which its label may stand: where its middle lies from there.
const SIDES: [Vec2; 8] = [
    vec2(1.0, 0.0),
    vec2(-1.0, 0.0),
    vec2(1.0, 1.0),
    vec2(-1.0, -1.0),
    vec2(1.0, -1.0),
    vec2(-1.0, 1.0),
    vec2(0.0, 1.0),
    vec2(0.0, -1.0),
];

/// The places of labels, and places that they should avoid.
#[derive(Debug, Clone)]
pub struct LabelPlaces {
    room: Rect,
    background: Color32,
    taken: Vec<Rect>,
    marks: Vec<(Pos2, f32)>,
    lines: Vec<Pos2>,
}

impl LabelPlaces {
    /// Nothing yet in `room`, which no label leaves, on this `background`.
    pub fn new(room: Rect, background: Color32) -> Self {
        Self { room: room.shrink(2.0), background, taken: Vec::new(), marks: Vec::new(), lines: Vec::new() }
    }

    /// No label covers `rect`.
    pub fn keep_free(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// No label covers a mark of this `radius`.
    pub fn keep_clear_of(&mut self, place: Pos2, radius: f32) {
        self.marks.push((place, radius));
    }

    /// Labels stand beside the line through `places` where they can.
    pub fn avoid(&mut self, places: &[Pos2]) {
        for pair in places.windows(2) {
            let way = pair[1] - pair[0];
            let pieces = (way.length() / STEP).clamp(1.0, 1000.0).ceil();
            self.lines.extend((0..pieces as u32).map(|piece| pair[0] + way * (piece as f32 / pieces)));
        }
    }

    /// Writes `text` beside a mark of this `radius` at `place`, on the side where it covers least; not at all where it
    /// would cover another label or leave the room.
    pub fn write(
        &mut self,
        painter: &Painter,
        (place, radius): (Pos2, f32),
        text: &str,
        font: FontId,
        colour: Color32,
    ) {
        let galley = painter.layout_no_wrap(text.to_owned(), font, colour);
        let Some(rect) = self.free_beside(place, radius, galley.size()) else { return };
        painter.rect_filled(rect, 2.0, self.background.gamma_multiply(0.6));
        painter.galley(rect.min, galley, colour);
        self.taken.push(rect);
    }

    /// Returns the place of a label of this `size` that covers least beside a mark of this `radius` at `place`; `None` where it has no room.
    fn free_beside(&self, place: Pos2, radius: f32, size: Vec2) -> Option<Rect> {
        let rects = SIDES.map(|side| beside(place, side, radius + GAP, size));
        let free = rects.into_iter().filter(|rect| self.is_free(*rect));
        free.min_by_key(|rect| self.covered(*rect) / ALIKE)
    }

    /// Whether a label may stand in `rect`.
    pub fn is_free(&self, rect: Rect) -> bool {
        let covers = |(place, radius): &(Pos2, f32)| rect.distance_to_pos(*place) < *radius;
        self.room.contains_rect(rect)
            && !self.taken.iter().any(|taken| taken.intersects(rect))
            && !self.marks.iter().any(covers)
    }

    fn covered(&self, rect: Rect) -> usize {
        self.lines.iter().filter(|place| rect.contains(**place)).count()
    }
}

/// Returns the place of a label of this `size` at a `distance` on that `side` of `place`.
fn beside(place: Pos2, side: Vec2, distance: f32, size: Vec2) -> Rect {
    let is_diagonal = side.x * side.y != 0.0;
    let distance = if is_diagonal { 0.6 * distance } else { distance };
    Align2::CENTER_CENTER.anchor_size(place + side * (0.5 * size + Vec2::splat(distance)), size)
}

#[cfg(test)]
mod tests {
    use eframe::egui::pos2;

    use super::*;

    const SIZE: Vec2 = vec2(60.0, 14.0);

    fn labels() -> LabelPlaces {
        let room = Rect::from_min_size(pos2(0.0, 0.0), vec2(300.0, 200.0));
        LabelPlaces::new(room, Color32::BLACK)
    }

    #[test]
    fn a_label_stands_beside_its_mark_away_from_lines() {
        let mut labels = labels();
        let mark = pos2(150.0, 100.0);
        let first = labels.free_beside(mark, 4.0, SIZE).expect("there is room");
        assert!(first.min.x > mark.x + 4.0 && first.center().y == mark.y, "{first:?}");
        labels.avoid(&[mark, pos2(300.0, 100.0)]);
        let second = labels.free_beside(mark, 4.0, SIZE).expect("there is room");
        assert!(!second.intersects(first) && second.distance_to_pos(mark) >= 4.0, "{second:?}");
    }

    #[test]
    fn labels_cover_neither_marks_nor_each_other_and_stay_in_the_room() {
        let mut labels = labels();
        let marks: Vec<Pos2> = (0..30).map(|i| pos2(10.0 * i as f32, (37 * i % 200) as f32)).collect();
        for mark in &marks {
            labels.keep_clear_of(*mark, 4.0);
        }
        let mut taken: Vec<Rect> = Vec::new();
        for mark in &marks {
            let Some(rect) = labels.free_beside(*mark, 4.0, SIZE) else { continue };
            assert!(labels.room.contains_rect(rect) && taken.iter().all(|other| !other.intersects(rect)));
            assert!(marks.iter().all(|mark| rect.distance_to_pos(*mark) >= 4.0), "{rect:?}");
            labels.keep_free(rect);
            taken.push(rect);
        }
        assert!(taken.len() > 10, "{}", taken.len());
    }

    #[test]
    fn a_mark_outside_or_nowhere_has_no_label() {
        for mark in [pos2(-500.0, 10.0), pos2(f32::NAN, 10.0), pos2(f32::INFINITY, 10.0)] {
            assert_eq!(labels().free_beside(mark, 4.0, SIZE), None);
        }
    }
}
