//! Formulas in the window: their glyphs as text of their own fonts, at the places where TeX puts them.

use eframe::egui::{
    Color32, FontData, FontDefinitions, FontFamily, FontId, Mesh, Pos2, Rect, Shape, TextFormat,
    epaint::text::{FontTweak, FontsView, LayoutJob},
    pos2, vec2,
};

use crate::formula::{FontFace, Formula, Mark};

/// Adds the fonts of formulas.
pub fn add_fonts(fonts: &mut FontDefinitions) {
    for face in FontFace::ALL {
        let tweak = FontTweak { hinting: Some(false), ..FontTweak::default() };
        let data = FontData::from_static(face.file()).tweak(tweak);
        fonts.font_data.insert(face.name().to_owned(), data.into());
        fonts.families.insert(family(face), vec![face.name().to_owned()]);
    }
}

fn family(face: FontFace) -> FontFamily {
    FontFamily::Name(face.name().into())
}

/// Pixels, as they lie on the screen.
#[derive(Debug, Clone, Copy)]
pub struct Pixels {
    /// Pixels in a point.
    pub per_point: f32,
}

impl Pixels {
    /// The nearest whole number of pixels, points.
    #[must_use]
    pub fn nearest(self, length: f32) -> f32 {
        (length * self.per_point).round() / self.per_point
    }

    /// The next whole number of pixels, points.
    #[must_use]
    pub fn at_least(self, length: f32) -> f32 {
        (length * self.per_point - 1e-3).ceil() / self.per_point
    }

    /// The last whole number of pixels, points.
    #[must_use]
    pub fn at_most(self, length: f32) -> f32 {
        (length * self.per_point + 1e-3).floor() / self.per_point
    }
}

/// Adds to `shapes` what `formula` is drawn with where an em is `em` points and its baseline starts at `at`.
pub fn draw(
    fonts: &mut FontsView<'_>,
    pixels: Pixels,
    formula: &Formula,
    [em, x, y]: [f32; 3],
    colour: Color32,
    shapes: &mut Vec<Shape>,
) {
    for mark in &formula.marks {
        match mark {
            Mark::Glyph { face, character, at, size } => {
                let font = FontId::new(em * size, family(*face));
                let start = pos2(x + em * at[0], y + em * at[1]);
                shapes.extend(text(
                    fonts,
                    pixels,
                    &character.to_string(),
                    start,
                    TextFormat::simple(font, colour),
                ));
            }
            Mark::Rule { min, size } => {
                // A rule is a whole number of pixels thick, about where TeX has its middle.
                let thickness = pixels.nearest(em * size[1]).max(1.0 / pixels.per_point);
                let top = pixels.nearest(y + em * (min[1] + size[1] / 2.0) - thickness / 2.0);
                let rect = Rect::from_min_size(pos2(x + em * min[0], top), vec2(em * size[0], thickness));
                let mut mesh = Mesh::default();
                mesh.add_colored_rect(rect, colour);
                shapes.push(Shape::mesh(mesh));
            }
            Mark::Area(contours) => {
                let place = |point: &[f32; 2]| pos2(x + em * point[0], y + em * point[1]);
                let contours: Vec<Vec<Pos2>> =
                    contours.iter().map(|contour| contour.iter().map(place).collect()).collect();
                shapes.push(Shape::mesh(filled(&contours, colour)));
                // Its edge is smooth.
                let edge = (0.5 / pixels.per_point, colour.gamma_multiply(0.5));
                shapes.extend(contours.into_iter().map(|contour| Shape::closed_line(contour, edge)));
            }
        }
    }
}

/// A line of text whose baseline starts at `at`, to a part of a pixel along it; `None` if there is nothing to
/// draw.
pub fn text(
    fonts: &mut FontsView<'_>,
    pixels: Pixels,
    text: &str,
    at: Pos2,
    format: TextFormat,
) -> Option<Shape> {
    let left = pixels.at_most(at.x);
    let colour = format.color;
    let mut job = LayoutJob::single_section(text.to_owned(), format);
    job.break_on_newline = false;
    job.sections[0].leading_space = (at.x - left).max(0.0);
    let galley = fonts.layout_job(job);
    let row = galley.rows.first()?;
    let glyph = row.glyphs.first()?;
    let ascent = glyph.font_ascent + row.size.y - glyph.line_height;
    let top = pixels.nearest(at.y) - pixels.nearest(ascent);
    Some(Shape::galley(pos2(left, top), galley, colour))
}

/// Fills the polygons, by the nonzero rule: between two heights at which none has a corner, the inside is
/// trapezoids.
fn filled(contours: &[Vec<Pos2>], colour: Color32) -> Mesh {
    let edges: Vec<[Pos2; 2]> = contours
        .iter()
        .flat_map(|contour| {
            contour.iter().zip(contour.iter().cycle().skip(1)).map(|(&one, &other)| [one, other])
        })
        .filter(|[one, other]| one.y != other.y)
        .collect();
    let mut heights: Vec<f32> = edges.iter().flatten().map(|point| point.y).collect();
    heights.sort_by(f32::total_cmp);
    heights.dedup();
    let mut mesh = Mesh::default();
    for pair in heights.windows(2) {
        let (top, bottom) = (pair[0], pair[1]);
        let mut crossed: Vec<([f32; 2], i32)> = Vec::new();
        for &[one, other] in &edges {
            if one.y.min(other.y) <= top && one.y.max(other.y) >= bottom {
                let at = |y: f32| one.x + (y - one.y) / (other.y - one.y) * (other.x - one.x);
                crossed.push(([at(top), at(bottom)], if one.y < other.y { 1 } else { -1 }));
            }
        }
        crossed.sort_by(|(one, _), (other, _)| (one[0] + one[1]).total_cmp(&(other[0] + other[1])));
        let mut winding = 0;
        for sides in crossed.windows(2) {
            winding += sides[0].1;
            if winding != 0 {
                let ([a, b], [c, d]) = (sides[0].0, sides[1].0);
                let first = mesh.vertices.len() as u32;
                for corner in [pos2(a, top), pos2(c, top), pos2(d, bottom), pos2(b, bottom)] {
                    mesh.colored_vertex(corner, colour);
                }
                mesh.add_triangle(first, first + 1, first + 2);
                mesh.add_triangle(first, first + 2, first + 3);
            }
        }
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The area of a mesh's triangles.
    fn area(mesh: &Mesh) -> f32 {
        let corner = |index: u32| mesh.vertices[index as usize].pos;
        let triangle = |three: &[u32]| {
            let (u, v) = (corner(three[1]) - corner(three[0]), corner(three[2]) - corner(three[0]));
            0.5 * (u.x * v.y - u.y * v.x).abs()
        };
        mesh.indices.chunks(3).map(triangle).sum()
    }

    #[test]
    fn polygons_are_filled_where_they_wind() {
        let square =
            |side: f32| vec![pos2(-side, -side), pos2(side, -side), pos2(side, side), pos2(-side, side)];
        let reversed = |mut points: Vec<Pos2>| {
            points.reverse();
            points
        };
        let filled = |contours: &[Vec<Pos2>]| area(&super::filled(contours, Color32::WHITE));
        assert!((filled(&[square(2.0)]) - 16.0).abs() < 1e-4);
        assert!((filled(&[square(2.0), square(1.0)]) - 16.0).abs() < 1e-4, "both wind the same way");
        assert!((filled(&[square(2.0), reversed(square(1.0))]) - 12.0).abs() < 1e-4, "a hole");
        let arrow = vec![pos2(0.0, 0.0), pos2(4.0, 2.0), pos2(0.0, 4.0), pos2(1.0, 2.0)];
        assert!((filled(&[arrow]) - 6.0).abs() < 1e-4, "what is not convex");
    }
}
