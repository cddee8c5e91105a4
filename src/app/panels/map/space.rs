//! Space: the plan above, and below it the view from the side.

use eframe::egui::{Color32, Painter, Rect, Stroke, Ui};

use super::canvas;
use crate::app::observer::Eye;
use crate::app::panels::Asks;
use crate::app::state::State;
use crate::app::theme;
use crate::map::{Chart, Extent, Instant, Picture, plan_and_side};

/// A chart of the face: the plan, or the view from the side.
struct Side {
    name: &'static str,
    chart: Chart,
    /// Which axes of the world run right and up.
    axes: [usize; 2],
}

/// Shows it in `rect`.
pub fn show(ui: &mut Ui, state: &State, rect: Rect, asks: &mut Asks) {
    for side in sides(state, rect) {
        canvas::look_around(ui, state, side.name, &side.chart, side.axes, asks);
        let painter = ui.painter().with_clip_rect(canvas::rect(&side.chart).intersect(ui.clip_rect()));
        painter.rect_filled(canvas::rect(&side.chart), 0.0, ui.visuals().extreme_bg_color);
        marks(ui, &painter, state, &side);
    }
}

fn sides(state: &State, rect: Rect) -> [Side; 2] {
    let extent = Extent::of_space(&state.settings, &state.session.scene);
    let area = [rect.min.x, rect.min.y, rect.width(), rect.height()].map(f64::from);
    let [plan, side] = plan_and_side(area, &extent, &state.session.map_view);
    [
        Side { name: "Map, from above", chart: plan, axes: [0, 1] },
        Side { name: "Map, from the side", chart: side, axes: [0, 2] },
    ]
}

fn marks(ui: &Ui, painter: &Painter, state: &State, side: &Side) {
    let instant = Instant::new(&state.settings, state.session.time);
    let room = canvas::rect(&side.chart);
    for (eye, at) in Eye::BOTH.into_iter().zip(instant.eyes()) {
        let place = canvas::place(&side.chart, side.axes.map(|axis| at[axis]));
        painter.circle_filled(place, 4.0, theme::eye_colour(eye, ui.visuals()));
        canvas::name_place(ui, room, place, &format!("{}: {}", side.name, eye.name()));
    }
    let point = state.session.points.selected();
    for picture in Picture::ALL {
        let Some(at) = instant.place(&point.track, picture) else { continue };
        let place = canvas::place(&side.chart, side.axes.map(|axis| at[axis]));
        painter.circle_stroke(place, 4.0, Stroke::new(1.5, colour(ui, picture)));
        let name = point.name(&state.session.scene);
        canvas::name_place(ui, room, place, &format!("{}: {name} {}", side.name, picture.words()));
    }
}

fn colour(ui: &Ui, picture: Picture) -> Color32 {
    match picture {
        Picture::Measured => theme::measured_colour(ui.visuals()),
        Picture::Seen(eye) => theme::eye_colour(Eye::BOTH[eye], ui.visuals()),
        Picture::Stereo => theme::stereo_colour(ui.visuals()),
    }
}
