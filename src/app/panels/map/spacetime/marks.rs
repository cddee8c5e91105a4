//! The marked events: received, happened, measured now.

use eframe::egui::{Color32, Pos2, Stroke, vec2};

use super::sheet::{DiagramSheet, HANDLE};
use super::{lines, words};
use crate::app::panels::map::labels::MapLabels;
use crate::app::panels::map::times::labelled;
use crate::app::widgets::theme;
use crate::eye::Eye;
use crate::map::{Diagram, ReceivedRay};

/// Radius of a mark, points.
const RADIUS: f32 = 4.0;
/// Marks that are nearer than this to each other share a label, points.
const APART: f32 = 26.0;

/// An event that is marked.
pub struct EventMark {
    /// Place on screen.
    pub place: Pos2,
    /// Name of the event.
    pub name: String,
    /// Label beside the mark.
    label: String,
    /// Description for hovering.
    pub words: String,
    colour: Color32,
    is_hollow: bool,
}

/// Returns all marks, in sight or not: each eye, the light that it receives, and the point now.
pub fn all(sheet: &DiagramSheet<'_>) -> Vec<EventMark> {
    let diagram = &sheet.diagram;
    let [left, right] = diagram.rays;
    let are_apart = sheet.place(left.left).distance(sheet.place(right.left)) > APART;
    let labels = if are_apart { ["happened (L)", "happened (R)"] } else { ["happened", ""] };
    let eyes = Eye::BOTH.into_iter().zip(diagram.rays).zip(labels);
    let mut marks: Vec<EventMark> =
        eyes.flat_map(|((eye, ray), label)| of_light(sheet, eye, &ray, label)).collect();
    if !diagram.other.is_rest() {
        let colour = lines::now_colours(sheet)[1];
        let name = format!("now on {} clocks", lines::whose(sheet));
        let mark = of_point(sheet, diagram.other_now(), &name, "", colour);
        marks.push(EventMark { is_hollow: true, ..mark });
    }
    let measured = theme::measured_colour(sheet.ui.visuals());
    let label = if sheet.others.is_empty() { "measured now".to_owned() } else { clock(sheet, diagram) };
    marks.push(of_point(sheet, diagram.time, "measured now", &label, measured));
    marks.extend(sheet.others.iter().map(|(point, diagram)| {
        let name = format!("{}, measured now", sheet.state.name_of(point));
        EventMark {
            place: sheet.place(diagram.measured()),
            label: clock(sheet, diagram),
            words: words::of_other(sheet, diagram, &name),
            name,
            colour: measured,
            is_hollow: false,
        }
    }));
    marks
}

/// The proper time of a point that is measured now.
fn clock(sheet: &DiagramSheet<'_>, diagram: &Diagram) -> String {
    let time = labelled(sheet.state, diagram.point.proper_time(diagram.time));
    format!("clock {time}{}", sheet.state.measures().time.suffix())
}

/// Returns the marks where `eye` receives light, and where that left.
fn of_light(sheet: &DiagramSheet<'_>, eye: Eye, ray: &ReceivedRay, label: &str) -> [EventMark; 2] {
    let mark = |event, name: &str, label: &str, words| EventMark {
        place: sheet.place(event),
        name: format!("{name}, {}", eye.name()),
        label: label.to_owned(),
        words,
        colour: theme::eye_colour(eye, sheet.ui.visuals()),
        is_hollow: false,
    };
    [
        mark(ray.received, "received", "", words::of_eyes(sheet, sheet.diagram.clock)),
        mark(ray.left, "happened", label, words::of_ray(sheet, eye, ray)),
    ]
}

/// The point at the ground's time `happened`.
fn of_point(sheet: &DiagramSheet<'_>, happened: f64, name: &str, label: &str, colour: Color32) -> EventMark {
    EventMark {
        place: sheet.place(sheet.diagram.point.at(happened)),
        name: name.to_owned(),
        label: label.to_owned(),
        words: words::of_point(sheet, happened, &format!(", {name}")),
        colour,
        is_hollow: false,
    }
}

/// Draws them with their labels.
pub fn paint(sheet: &DiagramSheet<'_>, marks: &[EventMark], labels: &mut MapLabels) {
    let shown = || marks.iter().filter(|mark| sheet.room().contains(mark.place));
    for mark in shown() {
        let halo = theme::halo_colour(sheet.ui.visuals());
        sheet.painter.circle_filled(mark.place, RADIUS + 1.5, halo);
        if mark.is_hollow {
            sheet.painter.circle_stroke(mark.place, RADIUS, Stroke::new(1.5, mark.colour));
        } else {
            sheet.painter.circle_filled(mark.place, RADIUS, mark.colour);
        }
        labels.places.keep_clear_of(mark.place, RADIUS);
    }
    let strong = sheet.ui.visuals().strong_text_color();
    let present = sheet.place(sheet.diagram.present);
    if sheet.room().contains(present) {
        let time = labelled(sheet.state, sheet.diagram.clock);
        let text =
            format!("{} {time}{}", sheet.state.clock().received.name, sheet.state.measures().time.suffix());
        labels.places.keep_clear_of(present, HANDLE);
        labels.write((present, HANDLE), &text, strong);
    }
    for mark in shown().filter(|mark| !mark.label.is_empty()) {
        labels.write((mark.place, RADIUS), &mark.label, strong);
    }
}

/// Draws the handle by which the present is dragged.
pub fn paint_handle(sheet: &DiagramSheet<'_>, place: Pos2, is_hot: bool) {
    let colour = theme::now_colour(sheet.ui.visuals());
    let width = if is_hot { 2.5 } else { 1.5 };
    sheet.painter.circle_stroke(place, HANDLE, Stroke::new(width, colour));
    for up in [-1.0, 1.0] {
        let tip = place + vec2(0.0, up * (HANDLE + 5.0));
        let back = place + vec2(0.0, up * (HANDLE + 1.0));
        let aside = vec2(3.5, 0.0);
        let points = vec![tip, back + aside, back - aside];
        sheet.painter.add(eframe::egui::Shape::convex_polygon(points, colour, Stroke::NONE));
    }
}
