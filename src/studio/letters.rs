//! The letters L and R, drawn with a round pen at any size: writing in pictures needs no font.

use glam::DVec2;
use relativity_core::math;
use relativity_render::Picture;

/// Half the width of the pen in parts of a letter's height.
const PEN: f64 = 0.085;

/// A letter of height 1, from its top left corner to the right and down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Letter {
    /// Straight strokes of the letter.
    lines: &'static [[DVec2; 2]],
    /// Middle and radius of half circles that are open to the left.
    bowl: Option<(DVec2, f64)>,
    width: f64,
}

/// The letters of the left and the right eye.
pub const OF_EYES: [Letter; 2] = [
    Letter { lines: &[[at(0.0, 0.0), at(0.0, 1.0)], [at(0.0, 1.0), at(0.54, 1.0)]], bowl: None, width: 0.54 },
    Letter {
        lines: &[
            [at(0.0, 0.0), at(0.0, 1.0)],
            [at(0.0, 0.0), at(0.33, 0.0)],
            [at(0.0, 0.54), at(0.33, 0.54)],
            [at(0.3, 0.54), at(0.6, 1.0)],
        ],
        bowl: Some((at(0.33, 0.27), 0.27)),
        width: 0.6,
    },
];

const fn at(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// Draws `letter` of `height` (above 0) about `middle` into `picture`, both in pixels, in an sRGB-encoded `colour`.
pub fn draw(picture: &mut Picture, letter: &Letter, middle: [f64; 2], height: f64, colour: [u8; 3]) {
    let corner = DVec2::from(middle) - 0.5 * height * at(letter.width, 1.0);
    draw_by(picture, |place| letter.distance(place), middle, [corner.x, corner.y, height], colour);
}

/// Draws a shape that is `height` high from a corner `[x, y, height]` on, about `middle`; `distance` gives the distance of a place from its
/// nearest stroke, both in parts of the height.
pub(super) fn draw_by(
    picture: &mut Picture,
    distance: impl Fn(DVec2) -> f64,
    middle: [f64; 2],
    [x, y, height]: [f64; 3],
    colour: [u8; 3],
) {
    let corner = at(x, y);
    let width = picture.size[0] as usize;
    let reach = |side: u32, middle: f64| {
        let [from, to] = [middle - height, middle + height].map(|end| end.clamp(0.0, f64::from(side)) as u32);
        from..to
    };
    for row in reach(picture.size[1], middle[1]) {
        for column in reach(picture.size[0], middle[0]) {
            let place = (at(f64::from(column) + 0.5, f64::from(row) + 0.5) - corner) / height;
            let coverage = (0.5 + (PEN - distance(place)) * height).clamp(0.0, 1.0);
            let pixel = &mut picture.rgba[row as usize * width + column as usize];
            for (part, ink) in pixel.iter_mut().zip(colour) {
                let between = f64::from(*part) + (f64::from(ink) - f64::from(*part)) * coverage;
                *part = between.round() as u8;
            }
        }
    }
}

/// From `place` to the nearest place on the line between two others.
pub(super) fn distance_to_line(place: DVec2, [from, to]: [DVec2; 2]) -> f64 {
    let along = (place - from).dot(to - from) / from.distance_squared(to);
    place.distance(from.lerp(to, along.clamp(0.0, 1.0)))
}

impl Letter {
    /// From `place` to the middle of the nearest stroke.
    fn distance(&self, place: DVec2) -> f64 {
        let to_line = |line: &[DVec2; 2]| distance_to_line(place, *line);
        // Left of its middle the bowl ends where straight strokes begin.
        let to_bowl = |(middle, radius): (DVec2, f64)| {
            let from_middle = place - middle;
            let to_circle = (math::hypot(from_middle.x, from_middle.y) - radius).abs();
            if from_middle.x > 0.0 { to_circle } else { f64::INFINITY }
        };
        self.lines.iter().map(to_line).chain(self.bowl.map(to_bowl)).fold(f64::INFINITY, f64::min)
    }
}
