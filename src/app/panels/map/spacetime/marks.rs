//! The marked events: received, happened, measured now.

use eframe::egui::{Color32, Pos2, Stroke, TextStyle, vec2};

use super::sheet::{HANDLE, Sheet};
use super::{lines, words};
use crate::app::observer::Eye;
use crate::app::panels::map::labels::Labels;
use crate::app::theme;

/// Radius of a mark, points.
const RADIUS: f32 = 4.0;
/// Marks that are nearer than this to each other share a label, points.
const APART: f32 = 26.0;

/// An event that is marked.
pub struct Mark {
    /// Where.
    pub place: Pos2,
    /// What it is called.
    pub name: String,
    /// What stands beside it.
    label: String,
    /// What is said of it on hover.
    pub words: String,
    colour: Color32,
    is_hollow: bool,
}

/// All that are in sight or not: of each eye, of the light that it receives, and of the point now.
pub fn of(sheet: &Sheet<'_>) -> Vec<Mark> {
    let diagram = &sheet.diagram;
    let visuals = sheet.ui.visuals();
    let mut marks = Vec::new();
    let happened = diagram.rays.map(|ray| sheet.place(ray.left));
    let are_apart = happened[0].distance(happened[1]) > APART;
    for (eye, ray) in Eye::BOTH.into_iter().zip(diagram.rays) {
        let colour = theme::eye_colour(eye, visuals);
        marks.push(Mark {
            place: sheet.place(ray.received),
            name: format!("received, {}", eye.name()),
            label: String::new(),
            words: words::of_eyes(sheet, diagram.time),
            colour,
            is_hollow: false,
        });
        let label = match (are_apart, eye) {
            (true, Eye::Left) => "happened (L)",
            (true, Eye::Right) => "happened (R)",
            (false, Eye::Left) => "happened",
            (false, Eye::Right) => "",
        };
        marks.push(Mark {
            place: sheet.place(ray.left),
            name: format!("happened, {}", eye.name()),
            label: label.to_owned(),
            words: words::of_ray(sheet, eye, &ray),
            colour,
            is_hollow: false,
        });
    }
    let now = |name: &str, label: &str, happened, is_hollow, colour| Mark {
        place: sheet.place(diagram.point.at(happened)),
        name: name.to_owned(),
        label: label.to_owned(),
        words: words::of_point(sheet, happened, &format!(", {name}")),
        colour,
        is_hollow,
    };
    if diagram.scene.beta() != 0.0 {
        let colour = lines::now_colours(sheet)[1];
        marks.push(now("now on the bicycle's clocks", "", diagram.scene_now(), true, colour));
    }
    let measured = theme::measured_colour(visuals);
    marks.push(now("measured now", "measured now", diagram.time, false, measured));
    marks
}

/// Draws them with their labels.
pub fn paint(sheet: &Sheet<'_>, marks: &[Mark], labels: &mut Labels) {
    let shown = || marks.iter().filter(|mark| sheet.room().contains(mark.place));
    for mark in shown() {
        let halo = theme::halo_colour(sheet.ui.visuals());
        sheet.painter.circle_filled(mark.place, RADIUS + 1.5, halo);
        if mark.is_hollow {
            sheet.painter.circle_stroke(mark.place, RADIUS, Stroke::new(1.5, mark.colour));
        } else {
            sheet.painter.circle_filled(mark.place, RADIUS, mark.colour);
        }
        labels.keep_clear_of(mark.place, RADIUS);
    }
    let font = TextStyle::Small.resolve(sheet.ui.style());
    let strong = sheet.ui.visuals().strong_text_color();
    let present = sheet.place(sheet.diagram.present);
    if sheet.room().contains(present) {
        let text = format!("received T {}", sheet.state.measures().time.text(sheet.diagram.time, 2));
        labels.keep_clear_of(present, HANDLE);
        labels.write(&sheet.painter, (present, HANDLE), &text, font.clone(), strong);
    }
    for mark in shown().filter(|mark| !mark.label.is_empty()) {
        labels.write(&sheet.painter, (mark.place, RADIUS), &mark.label, font.clone(), strong);
    }
}

/// Draws the handle by which the present is dragged.
pub fn paint_handle(sheet: &Sheet<'_>, place: Pos2, is_hot: bool) {
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
