//! The ruler for angles, as it lies in a view.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Color32, Painter, Pos2, Rect, Sense, Shape, Stroke, TextStyle, Ui, WidgetInfo, vec2,
};
use glam::DVec3;

use crate::app::state::State;
use crate::app::state::measuring::angle_ruler::{AngleRuler, PARTS};
use crate::app::views::panes::EyePane;

/// Returns the hint in the views while a drag would lay it.
pub(in crate::app) fn hint(state: &State) -> Option<String> {
    let is_armed = state.scratch.angle_ruler == AngleRuler::Armed;
    is_armed.then(|| "Drag from one place to another to measure the angle between them.".to_owned())
}

/// Half the length of the bars at both ends, points.
const BAR: f32 = 7.0;
/// Strokes of it, above what sets them off from the picture.
const STROKES: [(f32, Color32); 2] = [(4.5, Color32::from_black_alpha(190)), (2.0, Color32::WHITE)];
const TIP: &str = "The angle between the lines of sight to both ends. The error is half a pixel at each end, as it was when the ruler was \
    laid.";

/// Draws it into `pane`, if it is there.
pub(in crate::app) fn paint(ui: &Ui, painter: &Painter, state: &State, pane: EyePane) {
    let AngleRuler::Laid(laid) = state.scratch.angle_ruler else { return };
    if (laid.eye, laid.is_second) != (pane.eye, pane.is_second) {
        return;
    }
    let camera = state.view(pane.eye, pane.size).camera;
    let place =
        |direction: DVec3| Some(pane.place(camera.pixel(direction)?)).filter(|place| place.is_finite());
    let line: Vec<_> = (0..=PARTS).map(|part| place(laid.along(part))).collect();
    for (width, colour) in STROKES {
        let stroke = Stroke::new(width, colour);
        // What is behind the camera parts the line.
        for shown in line.split(Option::is_none) {
            let shown: Vec<Pos2> = shown.iter().copied().flatten().collect();
            for end in bars(&line, &shown) {
                painter.line_segment(end, stroke);
            }
            painter.add(Shape::line(shown, stroke));
        }
    }
    tell(ui, painter, pane, &line, &laid.text());
}

/// The bars across both ends of the whole `line` that are among the `shown` places.
fn bars(line: &[Option<Pos2>], shown: &[Pos2]) -> Vec<[Pos2; 2]> {
    let [first, .., before, last] = shown else { return Vec::new() };
    let second = shown[1];
    let bar = |end: Pos2, next: Pos2| {
        let across = BAR * (next - end).normalized().rot90();
        [end - across, end + across]
    };
    let is_end = |end: &Pos2, of: Option<&Option<Pos2>>| of == Some(&Some(*end));
    let ends = [(is_end(first, line.first()), *first, second), (is_end(last, line.last()), *last, *before)];
    ends.into_iter().filter(|(is_end, ..)| *is_end).map(|(_, end, next)| bar(end, next)).collect()
}

/// Writes `text` beside the middle of what of the `line` is in sight.
fn tell(ui: &Ui, painter: &Painter, pane: EyePane, line: &[Option<Pos2>], text: &str) {
    let inside: Vec<_> = line.iter().flatten().filter(|place| pane.rect.contains(**place)).collect();
    let Some(middle) = inside.get(inside.len() / 2).map(|place| **place) else { return };
    let galley = painter.layout_no_wrap(text.to_owned(), TextStyle::Body.resolve(ui.style()), Color32::WHITE);
    let room = pane.rect.shrink(6.0);
    let place = Align2::CENTER_TOP.anchor_size(middle + vec2(0.0, BAR + 4.0), galley.size());
    let corner = place.min.clamp(room.min, (room.max - galley.size()).max(room.min));
    let place = Rect::from_min_size(corner, galley.size()).expand2(vec2(5.0, 1.0));
    painter.rect_filled(place, 3.0, Color32::from_black_alpha(190));
    painter.galley(corner, galley, Color32::WHITE);
    let name = format!("Ruler, {}: {text}", pane.eye.name());
    let response = ui.interact(place.intersect(pane.rect), ui.scope_id().with("angle ruler"), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &name));
    response.on_hover_text(TIP);
}
