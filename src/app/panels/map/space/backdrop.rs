//! What the map is drawn on: a grid, the street, the eyes' fields of view, and the line abreast of the eyes.

use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Shape, Stroke, Ui, pos2, vec2};
use glam::DVec3;

use super::{Sheet, canvas};
use crate::app::observer::Eye;
use crate::app::state::State;
use crate::app::theme;
use crate::map::{Instant, Projection, field_of_view, ticks};
use crate::settings::Frame;

/// Least distance of two lines of the grid, points.
const LEAST: f32 = 58.0;
const FONT: FontId = FontId::proportional(10.5);
/// Size of the words.
const WORDS: FontId = FontId::proportional(11.5);

/// Draws it.
pub(super) fn paint(ui: &Ui, painter: &Painter, state: &State, instant: &Instant, sheet: &Sheet) {
    painter.rect_filled(sheet.room(), 0.0, ui.visuals().extreme_bg_color);
    fields_of_view(ui, painter, state, instant, sheet);
    grid(ui, painter, state, sheet);
    street(ui, painter, state, sheet);
    abreast(ui, painter, instant, sheet);
    let title = match sheet.projection {
        Projection::Plan => "from above",
        Projection::Side => "from the side",
    };
    let corner = sheet.room().left_top() + vec2(5.0, 3.0);
    painter.text(corner, Align2::LEFT_TOP, title, WORDS, ui.visuals().weak_text_color());
}

/// Lines at round numbers of the units that are shown.
fn grid(ui: &Ui, painter: &Painter, state: &State, sheet: &Sheet) {
    let (room, chart, length) = (sheet.room(), sheet.chart, state.measures().length);
    let colour = ui.visuals().weak_text_color();
    let line = Stroke::new(1.0, colour.gamma_multiply(0.22));
    let shown = |range: [f64; 2]| {
        ticks(range.map(|value| length.shown(value)), f64::from(LEAST) * length.factor / chart.scale)
    };
    let [across, up] = chart.range().map(shown);
    let screen = |right: f64, up: f64| canvas::place(&chart, [length.in_scene(right), length.in_scene(up)]);
    for right in across.0 {
        let x = screen(right, 0.0).x;
        painter.vline(x, room.y_range(), line);
        if sheet.projection == Projection::Side && room.max.x - x > 24.0 {
            let text = crate::figures::fixed(right, across.1);
            painter.text(pos2(x + 3.0, room.max.y - 1.0), Align2::LEFT_BOTTOM, text, FONT, colour);
        }
    }
    for value in up.0 {
        painter.hline(room.x_range(), screen(0.0, value).y, line);
    }
    if sheet.projection == Projection::Side {
        let corner = room.right_bottom() - vec2(4.0, 1.0);
        let symbol = if state.settings.map.frame == Frame::Ground { "x" } else { "x′" };
        painter.text(corner, Align2::RIGHT_BOTTOM, length.label(symbol), FONT, colour);
    }
}

/// The kerbs and the house fronts from above, the ground from the side.
fn street(ui: &Ui, painter: &Painter, state: &State, sheet: &Sheet) {
    let scene = &state.session.scene;
    let colour = ui.visuals().weak_text_color();
    let line = |up: f64, width: f32| {
        let y = canvas::place(&sheet.chart, [sheet.chart.center[0], up]).y;
        painter.hline(sheet.room().x_range(), y, Stroke::new(width, colour.gamma_multiply(0.7)));
        y
    };
    match sheet.projection {
        Projection::Plan => {
            for (y, name) in scene.street.into_iter().flatten().zip(["kerb", "kerb", "house fronts"]) {
                let y = line(y + state.settings.motion.depth_shift, 1.5);
                let place = pos2(sheet.room().max.x - 5.0, y - 1.0);
                painter.text(place, Align2::RIGHT_BOTTOM, name, FONT, colour);
            }
        }
        Projection::Side => {
            if let Some(z) = scene.ground_z {
                line(z + state.settings.motion.height_shift, 2.0);
            }
        }
    }
}

/// What each eye has in view. In the frame of who rides past it, that is another angle; it is left out there.
fn fields_of_view(ui: &Ui, painter: &Painter, state: &State, instant: &Instant, sheet: &Sheet) {
    if instant.frame() == Frame::Bicycle {
        return;
    }
    for (eye, at) in Eye::BOTH.into_iter().zip(instant.eyes()) {
        let camera = state.view(eye, state.session.picture_size).camera;
        let Some(edges) = field_of_view(&camera, sheet.projection) else { continue };
        let eye_place = place(sheet, at);
        let reach =
            2.0 * (sheet.room().width() + sheet.room().height()) + eye_place.distance(sheet.room().center());
        let corners = edges.map(|[right, up]| eye_place + reach * vec2(right as f32, -up as f32));
        let colour = theme::eye_colour(eye, ui.visuals());
        let inside = colour.gamma_multiply(0.07);
        painter.add(Shape::convex_polygon(vec![eye_place, corners[0], corners[1]], inside, Stroke::NONE));
        for corner in corners {
            painter.line_segment([eye_place, corner], Stroke::new(1.0, colour.gamma_multiply(0.45)));
        }
    }
}

/// The line that is beside the eyes: x = 0 on the ground.
fn abreast(ui: &Ui, painter: &Painter, instant: &Instant, sheet: &Sheet) {
    let [left, right] = instant.eyes();
    let x = place(sheet, 0.5 * (left + right)).x;
    let room = sheet.room();
    let colour = ui.visuals().text_color().gamma_multiply(0.7);
    dashed(painter, [pos2(x, room.min.y), pos2(x, room.max.y)], colour);
    if sheet.projection == Projection::Plan {
        let text = if instant.frame() == Frame::Ground { "abreast: x = 0" } else { "abreast of the eyes" };
        painter.text(pos2(x + 4.0, room.min.y + 3.0), Align2::LEFT_TOP, text, WORDS, colour);
    }
}

fn dashed(painter: &Painter, ends: [Pos2; 2], colour: Color32) {
    painter.extend(Shape::dashed_line(&ends, Stroke::new(1.0, colour), 4.0, 4.0));
}

fn place(sheet: &Sheet, at: DVec3) -> Pos2 {
    canvas::place(&sheet.chart, sheet.projection.flat(at))
}
