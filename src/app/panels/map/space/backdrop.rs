//! The backdrop of the map: a grid, the street, the eyes' fields of view, and the line abreast of the eyes.

use eframe::egui::{Align2, Pos2, Shape, Stroke, Vec2, pos2, vec2};
use relativity_core::Event;

use super::sheet::{SheetPainter, SpaceSheet};
use crate::app::panels::map::axes::{self, AxisQuantity};
use crate::app::panels::map::canvas;
use crate::app::state::State;
use crate::app::widgets::theme;
use crate::eye::Eye;
use crate::map::{MapProjection, StraightLine, field_of_view, street_lines, way_of_rider};
use crate::settings::MapFrame;

/// From the corner to the title, beside the symbol of the axis, points.
const TITLE: Vec2 = vec2(44.0, 3.0);
/// Fraction of the length of a slanting street line at which its name is written.
const NAMED_AT: f32 = 0.85;
/// The name of a way is written where this part of it has gone by.
const NAMED_AFTER: usize = 6;

/// Draws fields of view, axes, street and the rider's way behind the rest.
pub(super) fn paint(on: &mut SheetPainter<'_>) {
    on.painter.rect_filled(on.sheet.room(), 0.0, on.ui.visuals().extreme_bg_color);
    fields_of_view(on);
    axes_and_title(on);
    street(on);
    way(on);
    abreast(on);
}

fn axes_and_title(on: &mut SheetPainter<'_>) {
    let SheetPainter { ui, painter, state, sheet, labels, .. } = on;
    axes::paint(ui, painter, &sheet.chart, axes_of(state, sheet.projection), labels);
    let title = match sheet.projection {
        MapProjection::Plan => "from above",
        MapProjection::Side => "from the side",
    };
    let place = sheet.room().min + theme::text_scale(ui.style()) * TITLE;
    labels.write_at((place, Align2::LEFT_TOP), title, ui.visuals().weak_text_color());
}

/// Returns the axes of a chart. Both charts share x, whose numbers are below the lower one.
fn axes_of(state: &State, projection: MapProjection) -> [AxisQuantity<'static>; 2] {
    let unit = state.measures().length;
    let frame = state.document.settings.map_frame();
    let across = if frame == MapFrame::Ground { "x" } else { "x′" };
    let is_aslant = frame == MapFrame::Rider && !state.document.settings.ride.is_along_street();
    let up = match (projection, is_aslant) {
        (MapProjection::Plan, false) => "y",
        (MapProjection::Plan, true) => "y′",
        (MapProjection::Side, false) => "z",
        (MapProjection::Side, true) => "z′",
    };
    [(across, projection == MapProjection::Side), (up, true)].map(|(symbol, is_written)| AxisQuantity {
        symbol,
        unit,
        is_written,
    })
}

/// The kerbs and the house fronts from above, the ground from the side, and their names.
fn street(on: &mut SheetPainter<'_>) {
    let SheetPainter { ui, painter, state, instant, sheet, labels } = on;
    let colour = ui.visuals().weak_text_color();
    let stroke = Stroke::new(1.5, ui.visuals().weak_text_color().gamma_multiply(0.7));
    let room = sheet.room();
    let mut level = Vec::new();
    for ([from, to], name) in street_lines(instant, &state.document.scene, sheet.projection) {
        if from[1] == to[1] {
            let y = canvas::place(&sheet.chart, [sheet.chart.centre[0], from[1]]).y;
            painter.hline(room.x_range(), y, stroke);
            level.push((pos2(room.max.x - 5.0, y - 1.0), name));
        } else if let Some(ends) = across_chart(sheet, [from, to]) {
            painter.line_segment(ends, stroke);
            labels.places.avoid(ends, 1.0);
            labels.write((ends[0].lerp(ends[1], NAMED_AT), 1.0), name, colour);
        }
    }
    for (place, name) in level {
        labels.write_at((place, Align2::RIGHT_BOTTOM), name, colour);
    }
}

/// The part of the straight line through two places that the chart shows, on screen.
fn across_chart(sheet: &SpaceSheet, [from, to]: [[f64; 2]; 2]) -> Option<[Pos2; 2]> {
    let event = |[x, t]: [f64; 2]| Event { x, t };
    let step = Event { x: to[0] - from[0], t: to[1] - from[1] };
    let [[left, right], [low, high]] = sheet.chart.range();
    let ends =
        StraightLine { through: event(from), step }.within(event([left, low]), event([right, high]))?;
    Some(ends.map(|Event { x, t }| canvas::place(&sheet.chart, [x, t])))
}

/// A place on a line in the first part of it, away from the eyes.
fn part_way(places: &[Pos2]) -> Option<Pos2> {
    let piece = places.len() / NAMED_AFTER;
    let ends = places.get(piece).zip(places.get(piece + 1));
    ends.map(|(from, to)| from.lerp(*to, 1.0 / NAMED_AFTER as f32))
}

/// The way of whoever does not ride along the street, and its name.
fn way(on: &mut SheetPainter<'_>) {
    let SheetPainter { ui, painter, state, sheet, labels, .. } = on;
    let (settings, time) = (&state.document.settings, state.document.time);
    let way = way_of_rider(settings, time, state.time_range());
    let colour = ui.visuals().text_color().gamma_multiply(0.5);
    let mut named = None;
    sheet.chart.clipped(way.iter().map(|place| sheet.projection.flat(*place)), 0.0, |run| {
        let places: Vec<Pos2> = run.iter().map(|&[x, y]| pos2(x as f32, y as f32)).collect();
        labels.places.avoid(&places, 1.0);
        named = named.or(part_way(&places));
        painter.line(places, Stroke::new(1.0, colour));
    });
    if let Some(place) = named {
        labels.write((place, 2.0), "my way", colour);
    }
}

/// Draws the field of view of each eye. In a frame in which the eyes move it is another angle; it is left out
/// there.
fn fields_of_view(on: &SheetPainter<'_>) {
    let SheetPainter { ui, painter, state, instant, sheet, .. } = on;
    let frame_of_eyes = if state.document.settings.ride.is_on() { MapFrame::Rider } else { MapFrame::Ground };
    if instant.frame() != frame_of_eyes {
        return;
    }
    for (eye, at) in Eye::BOTH.into_iter().zip(instant.eyes()) {
        let camera = state.view(eye, state.frame.picture.size).camera;
        let Some(edges) = field_of_view(&camera, sheet.projection) else { continue };
        let eye_place = sheet.on_screen(at);
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

/// The line that is beside the eyes: x = 0 on the ground. None of who does not ride along the street.
fn abreast(on: &mut SheetPainter<'_>) {
    let SheetPainter { ui, painter, state, instant, sheet, labels } = on;
    let ride = &state.document.settings.ride;
    if ride.leaves_street() {
        return;
    }
    let x = sheet.on_screen(instant.middle()).x;
    let room = sheet.room();
    let colour = ui.visuals().text_color().gamma_multiply(0.7);
    let ends = [pos2(x, room.min.y), pos2(x, room.max.y)];
    painter.extend(Shape::dashed_line(&ends, Stroke::new(1.0, colour), 4.0, 4.0));
    if sheet.projection == MapProjection::Plan {
        let text = if instant.frame() == MapFrame::Ground && !ride.is_on() {
            "abreast: x = 0"
        } else {
            "abreast of the eyes"
        };
        let place = pos2(x + 4.0, room.min.y + 3.0);
        labels.write_at((place, Align2::LEFT_TOP), text, colour);
    }
}
