//! The colour of light of one wavelength, and strips of such colours.

use eframe::egui::{Color32, Mesh, Painter, Rect, Shape, pos2};
use relativity_render::colour;

/// Shortest and longest wavelength of scales, nm: of light near the visible.
pub const SCALE_NM: [f64; 2] = [100.0, 3000.0];
/// Points between the places of a strip whose colours are worked out.
const STEP: f32 = 2.0;

/// The colour of light of this wavelength, nm, over `behind`, which shows where eyes see nothing.
pub fn visible_colour(wavelength_nm: f64, behind: Color32) -> Color32 {
    let linear = colour::linear_srgb(wavelength_nm);
    let seen = linear.into_iter().fold(0.0, f64::max).min(1.0);
    let behind = behind.to_array();
    let [r, g, b] = [0, 1, 2].map(|i| {
        let behind = colour::srgb_decoded(f64::from(behind[i]) / 255.0);
        colour::srgb_level(behind * (1.0 - seen) + linear[i])
    });
    Color32::from_rgb(r, g, b)
}

/// Returns the places along `strip` whose colours are worked out, from its left end to its right end.
pub fn places(strip: Rect) -> impl Iterator<Item = f32> {
    let columns = (strip.width() / STEP).ceil().max(1.0) as u32;
    (0..=columns).map(move |column| strip.min.x + strip.width() * column as f32 / columns as f32)
}

/// Fills `strip` with `colours`, each with its place.
pub fn paint_strip(painter: &Painter, strip: Rect, colours: impl Iterator<Item = (f32, Color32)>) {
    let mut mesh = Mesh::default();
    for (column, (x, colour)) in (0..).zip(colours) {
        mesh.colored_vertex(pos2(x, strip.min.y), colour);
        mesh.colored_vertex(pos2(x, strip.max.y), colour);
        if column > 0 {
            let last = 2 * column + 1;
            mesh.add_triangle(last - 3, last - 2, last - 1);
            mesh.add_triangle(last - 2, last - 1, last);
        }
    }
    painter.add(Shape::mesh(mesh));
}
