//! A row of house fronts beside a road: an upright plane, painted, at rest with the aperture.
//!
//! A plane costs less than a hundredth of what as many bodies would, and is exact too, as it rests.
//! `shaders/street.wgsl` draws the same, with the same numbers.

use glam::DVec2;

use super::cover::{band_cover, repeated_cover};
use crate::colour::mix;

/// Width of a house.
pub(crate) const HOUSE_WIDTH: f64 = 8.0;
/// Houses take turns at these heights (the highest first, then the lowest) and shades of their walls; the
/// means of both, for where they are finer than pixels.
pub(crate) const HOUSES: [[f64; 2]; 4] = [[10.8, 0.78], [9.7, 1.0], [10.3, 0.6], [10.27, 0.79]];
/// Openings in the walls: beginning along a house, length, and the heights between which each lies. The
/// windows of the first and of the second floor, twice in a house; the door, and the window of the shop.
pub(crate) const OPENINGS: [[f64; 4]; 4] =
    [[1.25, 1.5, 4.6, 6.6], [1.25, 1.5, 7.7, 9.0], [1.2, 1.6, 0.0, 3.1], [3.9, 3.0, 1.0, 3.1]];
/// Width of the frames around them.
pub(crate) const FRAME: f64 = 0.14;
/// Heights between which a course of stone runs above the shops.
pub(crate) const COURSE: [f64; 2] = [3.7, 3.95];
/// Height of the cornice under the roofs.
pub(crate) const CORNICE: f64 = 0.3;

/// Constants of the shader.
pub(crate) const CONSTANTS: [(&str, f64); 5] = [
    ("HOUSE_WIDTH", HOUSE_WIDTH),
    ("FRAME_WIDTH", FRAME),
    ("COURSE_FROM", COURSE[0]),
    ("COURSE_TO", COURSE[1]),
    ("CORNICE", CORNICE),
];

/// Linear sRGB colours of the fronts: walls, frames and courses, upper windows, doors, and the windows of
/// shops.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Paints {
    pub wall: [f64; 3],
    pub frame: [f64; 3],
    pub glass: [f64; 3],
    pub door: [f64; 3],
    pub shop: [f64; 3],
}

/// A pixel of the fronts.
pub(crate) struct FrontPixel {
    pub colour: [f64; 3],
    /// Share of the pixel that they cover.
    pub cover: f64,
}

impl Paints {
    /// Returns what a pixel shows of the fronts, if anything: `place` is x along them and height above the
    /// ground at its middle, `pixel` its width and height there.
    pub fn front(&self, place: DVec2, pixel: DVec2) -> Option<FrontPixel> {
        let [[highest, _], ..] = HOUSES;
        if band_cover(place.y, [0.0, highest], pixel.y) == 0.0 {
            return None;
        }
        let House { shade, cover, cornice } = house(place, pixel);
        let openings: [_; 4] = std::array::from_fn(|number| opening_cover(number, 0.0, place, pixel));
        let frames = (0..4).map(|number| opening_cover(number, FRAME, place, pixel)).sum::<f64>();
        let stone = (frames + band_cover(place.y, COURSE, pixel.y) + cornice).min(1.0);
        let framed = mix(self.wall.map(|part| part * shade), self.frame, stone);
        let glazed = mix(framed, self.glass, openings[0] + openings[1]);
        Some(FrontPixel { colour: mix(mix(glazed, self.door, openings[2]), self.shop, openings[3]), cover })
    }
}

/// The part of a house that a pixel shows.
struct House {
    shade: f64,
    /// Share of the pixel below the roof, and within the cornice.
    cover: f64,
    cornice: f64,
}

/// The houses in a pixel: that at its right end, and as far as it reaches there the one at its left end; all
/// of them where they are finer than pixels.
fn house(place: DVec2, pixel: DVec2) -> House {
    let end = place.x + 0.5 * pixel.x;
    let right = (end / HOUSE_WIDTH).floor();
    let left = ((place.x - 0.5 * pixel.x) / HOUSE_WIDTH).floor();
    let share = ((end - right * HOUSE_WIDTH) / pixel.x.max(1e-6)).clamp(0.0, 1.0);
    let fine = (pixel.x / HOUSE_WIDTH - 0.5).clamp(0.0, 1.0);
    let of = |[height, shade]: [f64; 2]| {
        let cover = band_cover(place.y, [0.0, height], pixel.y);
        [shade, cover, band_cover(place.y, [height - CORNICE, height], pixel.y)]
    };
    let turn = |number: f64| HOUSES[(number - 3.0 * (number / 3.0).floor()) as usize];
    let coarse = mix(of(turn(left)), of(turn(right)), share);
    let [shade, cover, cornice] = mix(coarse, of(HOUSES[3]), fine);
    House { shade, cover, cornice }
}

/// Share of a pixel that an opening covers, with a `margin` around it.
fn opening_cover(number: usize, margin: f64, place: DVec2, pixel: DVec2) -> f64 {
    let [from, length, lowest, highest] = OPENINGS[number];
    let upright = band_cover(place.y, [lowest - margin, highest + margin], pixel.y);
    if upright == 0.0 {
        return 0.0;
    }
    let period = if number < 2 { 0.5 * HOUSE_WIDTH } else { HOUSE_WIDTH };
    let along = repeated_cover(place.x - from + margin, length + 2.0 * margin, period, pixel.x);
    along * upright
}
