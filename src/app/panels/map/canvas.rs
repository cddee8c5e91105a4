//! The canvas of both faces: the mouse in a chart, places on screen, and names for assistive technology.

use eframe::egui::{self, CursorIcon, Pos2, Rect, Response, Sense, Ui, Vec2, accesskit::Role, pos2};
use relativity_core::math;

use crate::app::commands::Command;
use crate::app::panels::{Commands, on_change};
use crate::app::state::State;
use crate::map::{Chart, Viewpoint};

/// Zoom per point of scrolling.
const ZOOM_PER_SCROLL: f64 = 0.002;
/// Side of the square by which a mark is found.
const MARK_SIDE: f32 = 8.0;

/// Returns the place on screen of a place of the chart.
pub fn place(chart: &Chart, world: [f64; 2]) -> Pos2 {
    let [x, y] = chart.screen(world);
    pos2(x as f32, y as f32)
}

/// The rectangle of a chart.
pub fn rect(chart: &Chart) -> Rect {
    let [x, y] = chart.middle.map(|middle| middle as f32);
    let [width, height] = chart.half.map(|half| 2.0 * half as f32);
    Rect::from_center_size(pos2(x, y), Vec2::new(width, height))
}

/// Reads the mouse in a `chart` whose axes are these of the world (0 is x): the wheel zooms at the pointer, a
/// drag moves the chart, a double click fits it again.
pub fn look_around(
    ui: &Ui,
    state: &State,
    name: &str,
    chart: &Chart,
    axes: [usize; 2],
    commands: &mut Commands,
) -> Response {
    let id = ui.scope_id().with(name);
    let response =
        ui.interact(rect(chart), id, Sense::click_and_drag()).on_hover_cursor(CursorIcon::Crosshair);
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Image, true, name));
    let before = state.scratch.map_view;
    let mut viewpoint = before;
    if response.double_clicked() {
        viewpoint = Viewpoint::default();
    } else if response.dragged() {
        let moved = response.drag_delta();
        viewpoint.shift[axes[0]] -= f64::from(moved.x) / chart.scale;
        viewpoint.shift[axes[1]] += f64::from(moved.y) / chart.scale;
    }
    if let (true, Some(pointer)) = (response.contains_pointer(), response.hover_pos()) {
        viewpoint = zoomed(ui, viewpoint, chart, axes, pointer);
    }
    on_change(commands, &before, viewpoint, Command::MapView);
    response
}

/// `viewpoint` after what the wheel did at the `pointer`: what is there stays there.
fn zoomed(ui: &Ui, viewpoint: Viewpoint, chart: &Chart, axes: [usize; 2], pointer: Pos2) -> Viewpoint {
    let scroll = f64::from(ui.input(|input| input.smooth_scroll_delta().y));
    let factor = math::exp(scroll * ZOOM_PER_SCROLL) * f64::from(ui.input(egui::InputState::zoom_delta));
    let [least, greatest] = Viewpoint::ZOOM;
    let zoom = (viewpoint.zoom * factor).clamp(least, greatest);
    if zoom == viewpoint.zoom || !zoom.is_finite() {
        return viewpoint;
    }
    let there = chart.world([f64::from(pointer.x), f64::from(pointer.y)]);
    let mut zoomed = Viewpoint { zoom, ..viewpoint };
    for (axis, (there, centre)) in axes.into_iter().zip(there.into_iter().zip(chart.centre)) {
        zoomed.shift[axis] += (there - centre) * (1.0 - viewpoint.zoom / zoom);
    }
    zoomed
}

/// Gives the `place` a `name` for assistive technology, where it is inside `room`.
pub fn name_place(ui: &Ui, room: Rect, place: Pos2, name: &str) {
    if room.contains(place) {
        let rect = Rect::from_center_size(place, Vec2::splat(MARK_SIDE));
        let response = ui.interact(rect, ui.scope_id().with(name), Sense::hover());
        response.widget_info(|| egui::WidgetInfo::labeled(Role::Label, true, name));
    }
}
