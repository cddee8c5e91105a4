//! The pictures of all bodies, each in its colour.

use eframe::egui::{Color32, Painter, Shape, Stroke, Ui, pos2};
use glam::DVec2;

use super::sheet::{SpaceSheet, colour};
use crate::map::{BodyPicture, OutlineLine, OutlineLines};
use crate::scene::convex_hull;

/// Thinnest line, points. What is thinner is drawn so, and fainter.
const THINNEST: f32 = 1.0;
/// Width below which nothing is drawn: the spokes of a small wheel, which would fill it.
const LEAST_WIDTH: f32 = 0.25;
/// Width of an edge.
const EDGE: f32 = 1.2;
/// Opacity of the faintest of these.
const FAINTEST: f32 = 0.35;
/// Balls are filled as long as they are smaller than this at rest, points: the bends of what is seen of
/// larger ones show.
const LARGEST_FILLED: f64 = 60.0;
/// Opacity of the street, behind the subject of the map.
const STREET: f32 = 0.45;
/// Opacity of what is seen: one eye's picture does not hide the other's.
const SEEN: f32 = 0.8;

/// Width at most of where two eyes place a body, points: a line that does not hide what it lies on.
const OUTLINE: f32 = 2.0;

/// Parts of a line are drawn as one while their widths differ by no more than this, points.
const SAME_WIDTH: f32 = 0.5;

/// The ratio of the size at which two eyes place a body to that which one eye sees, from which its outline is
/// drawn alone: its lines would be a scribble.
const SCRIBBLE: f64 = 1.5;

/// Draws where each eye, and both, see the bodies.
pub(super) fn paint(ui: &Ui, painter: &Painter, lines: &OutlineLines, sheet: &SpaceSheet) {
    let mut shapes = Vec::with_capacity(lines.all.len());
    let [seen, placed] = [BodyPicture::Seen(0), BodyPicture::Stereo].map(|of| places(lines, sheet, of));
    let is_scribble = extent(&placed) > SCRIBBLE * extent(&seen);
    let drawn = |line: &&OutlineLine| !(is_scribble && line.picture == BodyPicture::Stereo);
    for line in lines.all.iter().filter(|line| line.is_in(sheet.projection)).filter(drawn) {
        let colour = line_colour(ui, line);
        let places: Vec<_> =
            lines.vertices(line).iter().map(|vertex| sheet.projection.flat(vertex.place)).collect();
        let is_outline = line.picture == BodyPicture::Stereo;
        for (part, width) in parts(line, &places, sheet) {
            let fills =
                !is_outline && line.only.is_some() && 2.0 * line.reach * sheet.chart.scale < LARGEST_FILLED;
            let part = (part, if is_outline { width.min(OUTLINE) } else { width });
            add(part, fills, colour, sheet, &mut shapes);
        }
    }
    if is_scribble {
        let colour = colour(BodyPicture::Stereo, ui.visuals());
        add((&hull(placed), OUTLINE), false, colour, sheet, &mut shapes);
    }
    painter.extend(shapes);
}

/// Returns the vertices of a picture of what moves on the sheet.
fn places(lines: &OutlineLines, sheet: &SpaceSheet, picture: BodyPicture) -> Vec<[f64; 2]> {
    let of_it = |line: &&OutlineLine| line.picture == picture && !line.rests && line.is_in(sheet.projection);
    let vertices = lines.all.iter().filter(of_it).flat_map(|line| lines.vertices(line));
    vertices.map(|vertex| sheet.projection.flat(vertex.place)).collect()
}

/// Returns the longer side of the box around `places`.
fn extent(places: &[[f64; 2]]) -> f64 {
    let along = |axis: usize| {
        let values = || places.iter().map(|place| place[axis]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    along(0).max(along(1)).max(0.0)
}

/// Returns the convex outline of `places`, closed.
fn hull(places: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let corners = convex_hull(places.into_iter().map(DVec2::from).collect());
    let first = corners.first().copied();
    corners.into_iter().chain(first).map(Into::into).collect()
}

/// Parts of a line that are everywhere as wide, and how wide, points.
fn parts<'a>(line: &OutlineLine, places: &'a [[f64; 2]], sheet: &SpaceSheet) -> Vec<(&'a [[f64; 2]], f32)> {
    if line.ball.is_none() {
        return vec![(places, EDGE)];
    }
    let width = |ends: &[[f64; 2]]| {
        (2.0 * sheet.chart.scale * line.half_width(sheet.projection, [ends[0], ends[1]])) as f32
    };
    let mut parts: Vec<(&[[f64; 2]], f32)> = Vec::new();
    let mut first = 0;
    for (i, width) in places.windows(2).map(width).enumerate() {
        match parts.last_mut() {
            Some((part, wide)) if (width - *wide).abs() <= SAME_WIDTH => *part = &places[first..i + 2],
            _ => {
                first = i;
                parts.push((&places[i..i + 2], width));
            }
        }
    }
    parts
}

/// Adds a part of a line, and what it encloses where it is a ball's, which looks hollow otherwise.
fn add(
    (places, width): (&[[f64; 2]], f32),
    fills: bool,
    colour: Color32,
    sheet: &SpaceSheet,
    shapes: &mut Vec<Shape>,
) {
    if width < LEAST_WIDTH {
        return;
    }
    let faint = (width / THINNEST).clamp(FAINTEST, 1.0);
    let stroke = Stroke::new(width.max(THINNEST), colour.gamma_multiply(faint));
    sheet.chart.clipped(places.iter().copied(), f64::from(stroke.width), |run| {
        let points: Vec<_> = run.iter().map(|&[x, y]| pos2(x as f32, y as f32)).collect();
        if fills {
            shapes.push(Shape::convex_polygon(points.clone(), colour, Stroke::NONE));
        }
        shapes.push(Shape::line(points, stroke));
    });
}

fn line_colour(ui: &Ui, line: &OutlineLine) -> Color32 {
    let (colour, strength) = match line.picture {
        _ if line.rests => (ui.visuals().weak_text_color(), STREET),
        BodyPicture::Measured | BodyPicture::Stereo => (colour(line.picture, ui.visuals()), 1.0),
        BodyPicture::Seen(_) => (colour(line.picture, ui.visuals()), SEEN),
    };
    colour.gamma_multiply(strength)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outline_goes_round_all_places_and_ends_where_it_began() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let inside = [[0.5, 0.5], [0.1, 0.9], [0.5, 0.0]];
        let around = hull([&square[..], &inside[..]].concat());
        assert_eq!(around, [square[0], square[1], square[2], square[3], square[0]]);
        assert_eq!((hull(Vec::new()).len(), extent(&[])), (0, 0.0));
        assert_eq!(extent(&inside), 0.9);
    }
}
