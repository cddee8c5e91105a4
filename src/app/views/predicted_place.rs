//! The place in the views where somebody expects a body to be seen; after the reveal that where it is, too.

use eframe::egui::accesskit::Role;
use eframe::egui::{Color32, Painter, Pos2, Rect, Sense, Stroke, TextStyle, Ui, Vec2, WidgetInfo, vec2};
use relativity_render::Gaze;

use crate::app::state::State;
use crate::app::views::panes::EyePane;
use crate::app::widgets::label_below;
use crate::eye::Eye;
use crate::lesson::{Answer, AnswerKind, Course, PointAt, truth};
use crate::number_text;

/// Half the size of the cross, and the radius of the ring, points.
const CROSS: f32 = 9.0;
const RING: f32 = 9.0;
/// Number of places on the line between the two at which visibility is tested.
const LOOKS: u16 = 50;
/// Strokes of both, above what sets them off from the picture.
const WIDTHS: [(f32, Color32); 2] = [(4.5, Color32::from_black_alpha(190)), (2.0, Color32::WHITE)];

/// Returns the body that the present step of the lesson asks for, if it asks for one.
fn body(state: &State) -> Option<&str> {
    match &state.course()?.step()?.prediction.as_ref()?.kind {
        AnswerKind::Point(PointAt { body, .. }) => Some(body),
        _ => None,
    }
}

/// Returns the hint in the views while a place is requested.
pub(in crate::app) fn hint(state: &State) -> Option<String> {
    let body = body(state).filter(|_| state.course().is_some_and(|course| course.asked().is_some()))?;
    Some(format!("Click where you expect the {body} to be seen."))
}

/// The direction that was clicked.
fn clicked(state: &State) -> Option<Gaze> {
    let course = state.course()?;
    let record = course.record()?;
    let made = if course.asked().is_some() { course.draft.as_ref() } else { record.answer() };
    match made {
        Some(Answer::Direction(direction)) => Some(*direction),
        _ => None,
    }
}

/// Marks both in `pane`.
pub(in crate::app) fn paint(ui: &Ui, painter: &Painter, state: &State, pane: EyePane) {
    let Some(body) = body(state) else { return };
    let camera = state.view(pane.eye, pane.size).camera;
    let place = |direction: [f64; 3]| Some(pane.place(camera.pixel(direction.into())?));
    let clicked = clicked(state);
    let cross = clicked.and_then(|gaze| place(gaze.axes().forward.to_array()));
    let is_revealed = state.course().is_some_and(Course::is_revealed);
    let sight = state.sight();
    let seen = is_revealed.then(|| sight.directions(body)).flatten();
    let ring = seen.and_then(|seen| place(seen[pane.eye.index()]?.to_array()));
    for (width, colour) in WIDTHS {
        let stroke = Stroke::new(width, colour);
        if let Some((from, to)) = cross.zip(ring).and_then(|(cross, ring)| between(cross, ring)) {
            painter.line_segment([from, to], Stroke::new(0.6 * width, colour));
        }
        if let Some(at) = cross {
            for side in [vec2(CROSS, CROSS), vec2(CROSS, -CROSS)] {
                painter.line_segment([at - 0.7 * side, at + 0.7 * side], stroke);
            }
        }
        if let Some(at) = ring {
            painter.circle_stroke(at, RING, stroke);
        }
    }
    let view = pane.eye.name();
    name(ui, pane, cross, &format!("Predicted place, {view}"));
    name(ui, pane, ring, &format!("Where the {body} is seen, {view}"));
    if let (Some(cross), Some(ring), Some(clicked), Some(seen)) =
        (cross, ring, clicked, is_revealed.then(|| sight.direction(body)).flatten())
    {
        // The angle is that of the left eye.
        if !pane.is_second && pane.eye == Eye::Left || state.document.settings.picture.eyes().len() == 1 {
            draw_label(
                ui,
                painter,
                [cross, ring],
                pane,
                &format!("{} apart", number_text::degrees(truth::angle_between(clicked, seen))),
            );
        }
    }
}

/// The line between both, which touches neither; none where they are near.
fn between(cross: Pos2, ring: Pos2) -> Option<(Pos2, Pos2)> {
    let way = ring - cross;
    let free = way.length() - CROSS - RING;
    (free > 0.0).then(|| (cross + CROSS * way.normalized(), ring - RING * way.normalized()))
}

/// Tells the angle beside the middle of what of the line is in sight.
fn draw_label(ui: &Ui, painter: &Painter, [cross, ring]: [Pos2; 2], pane: EyePane, text: &str) {
    let font = TextStyle::Small.resolve(ui.style());
    let galley = painter.layout_no_wrap(text.to_owned(), font, Color32::WHITE);
    let mut parts = (1..=LOOKS).rev().map(|part| ring + f32::from(part) / f32::from(LOOKS) * (cross - ring));
    let end = parts.find(|end| pane.rect.contains(*end)).unwrap_or(ring);
    let middle = ring + 0.5 * (end - ring) + vec2(0.0, RING + 6.0);
    label_below(painter, middle, galley, pane.rect.shrink(8.0));
}

/// Names what is marked at a place for assistive technology.
fn name(ui: &Ui, pane: EyePane, place: Option<Pos2>, name: &str) {
    let Some(place) = place.filter(|place| pane.rect.contains(*place)) else { return };
    let area = Rect::from_center_size(place, Vec2::splat(2.0 * CROSS));
    let response = ui.interact(area, ui.scope_id().with(name), Sense::empty());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, name));
}
