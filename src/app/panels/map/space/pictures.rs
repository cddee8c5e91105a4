//! The pictures of all bodies, each in its colour.

use eframe::egui::{Painter, Rect, Shape, Stroke, Ui, pos2};

use super::{Sheet, colour};
use crate::map::{Line, Lines, Picture};

/// Thinnest line, points. What is thinner is drawn so, and fainter.
const THINNEST: f32 = 1.0;
/// Faintest of these.
const FAINTEST: f32 = 0.35;
/// Balls are filled as long as they are smaller than this, points: the bends of what is seen of larger ones show.
const LARGEST_FILLED: f32 = 40.0;
/// How strongly the street is drawn, behind what the map is about.
const STREET: f32 = 0.45;
/// How strongly what is seen is drawn: what one eye sees does not hide what the other sees.
const SEEN: f32 = 0.8;

/// Draws them.
pub(super) fn paint(ui: &Ui, painter: &Painter, lines: &Lines, sheet: &Sheet) {
    let Sheet { projection, chart } = *sheet;
    let mut shapes = Vec::with_capacity(lines.all.len());
    for line in lines.all.iter().filter(|line| line.is_in(projection)) {
        let stroke = stroke(ui, line, chart.scale);
        let places = lines.vertices(line).iter().map(|vertex| projection.flat(vertex.place));
        chart.clipped(places, f64::from(stroke.width), |run| {
            let points: Vec<_> = run.iter().map(|&[x, y]| pos2(x as f32, y as f32)).collect();
            // A ball, which looks hollow otherwise.
            if line.only.is_some() && Rect::from_points(&points).size().max_elem() < LARGEST_FILLED {
                shapes.push(Shape::convex_polygon(points.clone(), stroke.color, Stroke::NONE));
            }
            shapes.push(Shape::line(points, stroke));
        });
    }
    painter.extend(shapes);
}

fn stroke(ui: &Ui, line: &Line, scale: f64) -> Stroke {
    let width = (2.0 * line.radius * scale) as f32;
    let faint = if line.radius > 0.0 { (width / THINNEST).clamp(FAINTEST, 1.0) } else { 1.0 };
    let (colour, strength) = match line.picture {
        _ if line.rests => (ui.visuals().weak_text_color(), STREET),
        Picture::Measured => (colour(line.picture, ui.visuals()), 1.0),
        picture => (colour(picture, ui.visuals()), SEEN),
    };
    Stroke::new(width.max(THINNEST), colour.gamma_multiply(faint * strength))
}
