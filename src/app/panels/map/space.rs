//! Space: the plan above, and below it the view from the side.

use eframe::egui::{Color32, Painter, Rect, Shape, Stroke, Ui, pos2};

use super::canvas;
use crate::app::observer::Eye;
use crate::app::panels::Asks;
use crate::app::state::State;
use crate::app::theme;
use crate::map::{Chart, Extent, Instant, Line, Lines, Picture, View, plan_and_side};

/// Thinnest line, points. What is thinner is drawn so, and fainter.
const THINNEST: f32 = 1.0;
/// Faintest of these.
const FAINTEST: f32 = 0.3;

/// A chart of the face.
#[derive(Debug, Clone, Copy)]
struct Sheet {
    view: View,
    chart: Chart,
}

impl Sheet {
    const fn name(&self) -> &'static str {
        match self.view {
            View::Plan => "Map, from above",
            View::Side => "Map, from the side",
        }
    }
}

/// Shows it in `rect`.
pub fn show(ui: &mut Ui, state: &State, rect: Rect, asks: &mut Asks) {
    let charts = charts(state, rect);
    let instant = Instant::new(&state.settings, state.session.time);
    let lines = Lines::new(&instant, &state.session.scene, &charts);
    for (view, chart) in View::BOTH.into_iter().zip(charts) {
        let sheet = Sheet { view, chart };
        let room = canvas::rect(&chart);
        canvas::look_around(ui, state, sheet.name(), &chart, view.axes(), asks);
        let painter = ui.painter().with_clip_rect(room.intersect(ui.clip_rect()));
        painter.rect_filled(room, 0.0, ui.visuals().extreme_bg_color);
        draw_lines(ui, &painter, state, &lines, &sheet);
        marks(ui, &painter, state, &instant, &sheet);
    }
}

fn charts(state: &State, rect: Rect) -> [Chart; 2] {
    let extent = Extent::of_space(&state.settings, &state.session.scene);
    let area = [rect.min.x, rect.min.y, rect.width(), rect.height()].map(f64::from);
    plan_and_side(area, &extent, &state.session.map_view)
}

fn draw_lines(ui: &Ui, painter: &Painter, state: &State, lines: &Lines, sheet: &Sheet) {
    let Sheet { view, chart } = *sheet;
    let mut shapes = Vec::with_capacity(lines.all.len());
    for line in lines.all.iter().filter(|line| line.only.is_none_or(|only| only == view)) {
        let stroke = stroke(ui, state, line, &chart);
        let places = lines.vertices(line).iter().map(|vertex| view.flat(vertex.place));
        chart.clipped(places, f64::from(stroke.width), |run| {
            let points = run.iter().map(|&[x, y]| pos2(x as f32, y as f32)).collect();
            shapes.push(Shape::line(points, stroke));
        });
    }
    painter.extend(shapes);
}

fn stroke(ui: &Ui, state: &State, line: &Line, chart: &Chart) -> Stroke {
    let width = (2.0 * line.radius * chart.scale) as f32;
    let faint = if line.radius > 0.0 { (width / THINNEST).clamp(FAINTEST, 1.0) } else { 1.0 };
    let group = &state.session.scene.groups[line.group];
    let rests = state.settings.velocity(group.motion) == relativity_render::Velocity::REST;
    let colour = if rests { ui.visuals().weak_text_color() } else { colour(ui, line.picture) };
    Stroke::new(width.max(THINNEST), colour.gamma_multiply(faint))
}

fn marks(ui: &Ui, painter: &Painter, state: &State, instant: &Instant, sheet: &Sheet) {
    let room = canvas::rect(&sheet.chart);
    for (eye, at) in Eye::BOTH.into_iter().zip(instant.eyes()) {
        let place = canvas::place(&sheet.chart, sheet.view.flat(at));
        painter.circle_filled(place, 4.0, theme::eye_colour(eye, ui.visuals()));
        canvas::name_place(ui, room, place, &format!("{}: {}", sheet.name(), eye.name()));
    }
    let point = state.session.points.selected();
    for picture in Picture::ALL {
        let Some(at) = instant.place(&point.track, picture) else { continue };
        let place = canvas::place(&sheet.chart, sheet.view.flat(at));
        painter.circle_stroke(place, 4.0, Stroke::new(1.5, colour(ui, picture)));
        let name = point.name(&state.session.scene);
        canvas::name_place(ui, room, place, &format!("{}: {name} {}", sheet.name(), picture.words()));
    }
}

fn colour(ui: &Ui, picture: Picture) -> Color32 {
    match picture {
        Picture::Measured => theme::measured_colour(ui.visuals()),
        Picture::Seen(eye) => theme::eye_colour(Eye::BOTH[eye], ui.visuals()),
        Picture::Stereo => theme::stereo_colour(ui.visuals()),
    }
}
