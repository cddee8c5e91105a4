//! Spacetime: x against t, in which light runs at 45 degrees. Dragging the present along the eyes' worldline
//! goes to another T, and so does a click on a worldline.

mod lines;
mod marks;
mod sheet;
mod words;

use std::sync::Arc;

use eframe::egui::{
    Align2, CursorIcon, Galley, Pos2, Rect, Response, Sense, TextStyle, Ui, Vec2, accesskit::Role, vec2,
};
use relativity_core::{Event, ObserverVelocity};

use self::sheet::{DiagramSheet, HANDLE, NEAR};
use super::axes::{self, AxisQuantity};
use super::canvas;
use super::labels::MapLabels;
use crate::app::commands::PlaybackCommand;
use crate::app::panels::{Commands, OnClick as _};
use crate::app::state::State;
use crate::app::state::points::Point;
use crate::map::{Diagram, around_now, chart, home};
use crate::settings::{MapFrame, MapFraming};

/// Name of the diagram for assistive technology.
const NAME: &str = "Map, x against t";
/// From the corner to the title, beside the name of the axis, points.
const TITLE: Vec2 = vec2(44.0, 3.0);

/// Shows it in `rect`.
pub fn show(ui: &mut Ui, state: &State, rect: Rect, commands: &mut Commands) {
    let (settings, time) = (&state.document.settings, state.document.time);
    let (track, frame) = (state.document.points.selected().track, settings.frame(time));
    ui.painter().rect_filled(rect, 0.0, ui.visuals().extreme_bg_color);
    // Outside the domain of the core there is nothing to draw.
    let Ok(diagram) = Diagram::new(settings, &track, time, frame) else { return };
    let others = others(state, time, frame);
    let Ok(home) = home(settings, &track, time, frame) else { return };
    let home = close_up(state, &diagram, &others).unwrap_or(home);
    let area = [rect.min.x, rect.min.y, rect.width(), rect.height()].map(f64::from);
    let chart = chart(area, home, &state.scratch.map_view);
    let response = canvas::look_around(ui, state, NAME, &chart, [0, 1], commands);
    let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
    let sheet = DiagramSheet { ui, painter, chart, state, diagram, others };
    let mut labels = MapLabels::new(ui, &sheet.painter, rect);
    let title = Title::new(&sheet);
    labels.places.keep_free(title.rect);
    axes::paint(ui, &sheet.painter, &sheet.chart, axes_of(state), &mut labels);
    lines::paint(&sheet, &mut labels);
    let marks = marks::all(&sheet);
    marks::paint(&sheet, &marks, &mut labels);
    lines::name(&sheet, &mut labels);
    title.paint(&sheet);
    point_at(&sheet, &response, &marks, commands);
    handle(&sheet, commands);
}

/// The followed points beside the selected one, with their diagrams at `time` in `frame`.
fn others(state: &State, time: f64, frame: ObserverVelocity) -> Vec<(&Point, Diagram)> {
    let points = &state.document.points;
    let others = points.all().iter().enumerate().filter(|(index, _)| *index != points.selected_index());
    let diagram = |point: &Point| Diagram::new(&state.document.settings, &point.track, time, frame).ok();
    others.filter_map(|(_, point)| Some((point, diagram(point)?))).collect()
}

/// The events that a close-up frames: what is now of all followed points.
fn close_up(state: &State, selected: &Diagram, others: &[(&Point, Diagram)]) -> Option<[Event; 2]> {
    if state.document.settings.map.framing == MapFraming::Passage {
        return None;
    }
    let all: Vec<Diagram> =
        [*selected].into_iter().chain(others.iter().map(|(_, diagram)| *diagram)).collect();
    around_now(&all)
}

/// Returns the axes along x and along t.
fn axes_of(state: &State) -> [AxisQuantity<'static>; 2] {
    let measures = state.measures();
    let [x, t] = match state.document.settings.map_frame() {
        MapFrame::Ground => ["x", "t"],
        MapFrame::Bicycle | MapFrame::Rider => ["x′", "t′"],
    };
    [(x, measures.length), (t, measures.time)].map(|(symbol, unit)| AxisQuantity {
        symbol,
        unit,
        is_written: true,
    })
}

/// Returns a note on what the diagram draws differently, or leaves out, while the rider does not move along
/// the street.
fn aslant_words(diagram: &Diagram) -> Option<String> {
    let words = match diagram.cones() {
        Some(_) => "now, mine is drawn where the point is, beside me",
        None => "no light cone: by my rulers the point moves aside, too",
    };
    diagram.is_aslant().then(|| words.to_owned())
}

/// In whose frame it is drawn, in the corner beside the name of the axis.
struct Title {
    rect: Rect,
    galley: Arc<Galley>,
}

impl Title {
    fn new(sheet: &DiagramSheet<'_>) -> Self {
        let whose = match sheet.state.document.settings.map_frame() {
            MapFrame::Ground => "on the ground's",
            MapFrame::Bicycle => &format!("on the {}'s", sheet.state.document.scene.rider),
            MapFrame::Rider => "on my own",
        };
        let text = [format!("{whose} clocks and rulers")].into_iter().chain(aslant_words(&sheet.diagram));
        let text = text.collect::<Vec<_>>().join("\n");
        let font = TextStyle::Small.resolve(sheet.ui.style());
        let galley = sheet.painter.layout_no_wrap(text, font, sheet.ui.visuals().text_color());
        Self { rect: Align2::LEFT_TOP.anchor_size(sheet.room().min + TITLE, galley.size()), galley }
    }

    fn paint(self, sheet: &DiagramSheet<'_>) {
        let colour = sheet.ui.visuals().extreme_bg_color;
        sheet.painter.rect_filled(self.rect.expand(2.0), 2.0, colour.gamma_multiply(0.7));
        sheet.painter.galley(self.rect.min, self.galley, sheet.ui.visuals().text_color());
    }
}

/// Tells what is under the pointer, and goes where a worldline is clicked.
fn point_at(
    sheet: &DiagramSheet<'_>,
    response: &Response,
    marks: &[marks::EventMark],
    commands: &mut Commands,
) {
    for mark in marks {
        canvas::name_place(sheet.ui, sheet.room(), mark.place, &format!("{NAME}: {}", mark.name));
    }
    let Some(pointer) = response.hover_pos() else { return };
    let near = |mark: &&marks::EventMark| mark.place.distance(pointer) < NEAR;
    let nearer = |a: &&marks::EventMark, b: &&marks::EventMark| {
        a.place.distance(pointer).total_cmp(&b.place.distance(pointer))
    };
    let aimed = aimed_at(sheet, pointer);
    let mark = marks.iter().filter(near).min_by(nearer).map(|mark| mark.words.clone());
    let text = mark.or_else(|| aimed.as_ref().map(|aimed| aimed.words.clone()));
    let text = text.or_else(|| lines::hover_text(sheet, pointer));
    if let Some(aimed) = aimed {
        response.clone().on_hover_cursor(CursorIcon::PointingHand);
        response.on_click(commands, PlaybackCommand::GoTo(aimed.time));
    }
    if let Some(text) = text {
        response.clone().on_hover_text_at_pointer(text);
    }
}

/// An event of a worldline under the pointer.
struct Aimed {
    /// Description of the event.
    words: String,
    /// The T at which an eye receives light from there, or is there itself.
    time: f64,
}

fn aimed_at(sheet: &DiagramSheet<'_>, pointer: Pos2) -> Option<Aimed> {
    if let Some((happened, _)) = sheet.nearest_of_worldline(pointer).filter(|(_, off)| *off < NEAR) {
        let words = words::of_point(sheet, happened, "");
        let time = sheet.diagram.point.received(&sheet.state.document.settings.ride, happened);
        return Some(Aimed { words, time });
    }
    let eyes = sheet.diagram.eyes().map(|eye| sheet.nearest(eye, pointer));
    let (steps, off) = if eyes[0].1 < eyes[1].1 { eyes[0] } else { eyes[1] };
    let time = sheet.diagram.clock + steps;
    (off < NEAR).then(|| Aimed { words: words::of_eyes(sheet, time), time })
}

/// The present, which can be dragged along the eyes' worldline.
fn handle(sheet: &DiagramSheet<'_>, commands: &mut Commands) {
    let present = sheet.place(sheet.diagram.present);
    if !sheet.room().contains(present) {
        return;
    }
    let rect = Rect::from_center_size(present, Vec2::splat(2.0 * HANDLE));
    let id = sheet.ui.scope_id().with("present");
    let response = sheet.ui.interact(rect, id, Sense::click_and_drag()).on_hover_cursor(CursorIcon::Grab);
    response.widget_info(|| {
        eframe::egui::WidgetInfo::labeled(Role::Slider, true, format!("{NAME}: the present T"))
    });
    marks::paint_handle(sheet, present, response.hovered() || response.dragged());
    let moved = response.drag_delta();
    if response.dragged() && moved != Vec2::ZERO {
        let [x, t] = [f64::from(moved.x), -f64::from(moved.y)].map(|points| points / sheet.chart.scale);
        let Event { x: dx, t: dt } = sheet.diagram.eyes()[0].step;
        commands.push(
            PlaybackCommand::GoTo(sheet.diagram.clock + (x * dx + t * dt) / (dx * dx + dt * dt)).into(),
        );
    }
    response.on_hover_text(words::of_eyes(sheet, sheet.diagram.clock));
}
