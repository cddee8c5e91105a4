//! Words in pictures, in the bold capitals of formulas.

use std::ops::Range;

use glam::DVec2;
use relativity_render::Picture;

use crate::formula::outlines::{CAPITALS, outlines};

/// The part of the room that a word takes at most.
const SHARE: f64 = 0.94;
/// Edges that reach less far to the side, pixels, count as upright.
const UPRIGHT: f64 = 1e-6;

/// Draws `text` about `middle` into `picture`, at most so wide and its capitals so high, pixels, in an
/// sRGB-encoded `colour`.
pub fn draw(picture: &mut Picture, text: &str, middle: [f64; 2], [room, height]: [f64; 2], colour: [u8; 3]) {
    let (outlines, width) = outlines(&text.to_uppercase());
    let em = (height / CAPITALS).min(SHARE * room / width.max(f64::MIN_POSITIVE));
    let start = DVec2::from(middle) + 0.5 * em * DVec2::new(-width, CAPITALS);
    let place = |point: &[f64; 2]| start + em * DVec2::from(*point);
    let outlines: Vec<Vec<DVec2>> = outlines.iter().map(|one| one.iter().map(place).collect()).collect();
    let pixels = |from: f64, to: f64, side: u32| {
        let [from, to] = [from.floor(), to.ceil()].map(|end| end.clamp(0.0, f64::from(side)) as u32);
        from..to
    };
    let [columns, rows] = [
        pixels(start.x, start.x + em * width, picture.size[0]),
        pixels(start.y - em, start.y + em, picture.size[1]),
    ];
    for row in rows {
        for (column, share) in columns.clone().zip(shares(&outlines, row, &columns)) {
            let pixel = &mut picture.rgba[row as usize * picture.size[0] as usize + column as usize];
            for (part, ink) in pixel.iter_mut().zip(colour) {
                let between = f64::from(*part) + share * (f64::from(ink) - f64::from(*part));
                *part = between.round() as u8;
            }
        }
    }
}

/// Returns the part of each pixel in `columns` of a `row` that lies inside the `outlines`.
fn shares(outlines: &[Vec<DVec2>], row: u32, columns: &Range<u32>) -> Vec<f64> {
    let mut shares = vec![0.0; columns.len()];
    let [top, bottom] = [row, row + 1].map(f64::from);
    for (from, to) in outlines.iter().flat_map(|one| one.iter().zip(one.iter().cycle().skip(1))) {
        let ends = [from.y, to.y].map(|y| y.clamp(top, bottom));
        if ends[0] == ends[1] {
            continue;
        }
        let edge = ends.map(|y| from.x + (y - from.y) / (to.y - from.y) * (to.x - from.x));
        for (column, share) in columns.clone().zip(&mut shares) {
            *share += (ends[1] - ends[0]) * part_right_of(edge, column);
        }
    }
    shares.into_iter().map(|share| share.abs().min(1.0)).collect()
}

/// Returns the part of a pixel that lies to the right of an edge, which is at these x at its top and its
/// bottom.
fn part_right_of(edge: [f64; 2], column: u32) -> f64 {
    let [from, to] = edge.map(|x| f64::from(column + 1) - x);
    // The integral of the part to the right of an upright edge, by the place of that.
    let area = |x: f64| 0.5 * x.clamp(0.0, 1.0).powi(2) + (x - 1.0).max(0.0);
    if (from - to).abs() < UPRIGHT {
        return from.clamp(0.0, 1.0);
    }
    (area(from) - area(to)) / (from - to)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_in_their_room_and_differ() {
        let drawn = |text: &str, size: [u32; 2]| {
            let blank = vec![[0, 0, 0, u8::MAX]; (size[0] * size[1]) as usize];
            let mut picture = Picture { size, rgba: blank };
            let [width, height] = size.map(f64::from);
            draw(&mut picture, text, [0.5 * width, 0.5 * height], [width, 0.6 * height], [255; 3]);
            picture
        };
        for size in [[960, 48], [48, 12], [12, 48]] {
            let [seen, rest] = ["as seen", "at rest"].map(|text| drawn(text, size));
            let inked = |[x, y]: [u32; 2]| seen.rgba[(y * size[0] + x) as usize][0] > 0;
            assert!(seen.rgba != rest.rgba && seen.rgba.iter().any(|pixel| pixel[0] > 100), "{size:?}");
            assert!((0..size[0]).all(|x| !inked([x, 0]) && !inked([x, size[1] - 1])), "{size:?}");
        }
    }

    #[test]
    fn a_pixel_is_inked_by_the_part_of_it_that_is_inside() {
        let corner = |x, y| DVec2::new(x, y);
        let square = vec![corner(0.25, 0.5), corner(2.5, 0.5), corner(2.5, 2.0), corner(0.25, 2.0)];
        let triangle = vec![corner(0.0, 1.0), corner(3.0, 1.0), corner(0.0, 0.0)];
        assert_eq!(shares(&[square], 0, &(0..4)), [0.375, 0.5, 0.25, 0.0]);
        let expected = [5.0, 3.0, 1.0, 0.0].map(|sixths| sixths / 6.0);
        let found = shares(&[triangle], 0, &(0..4));
        assert!(found.iter().zip(expected).all(|(share, part)| (share - part).abs() < 1e-12), "{found:?}");
    }
}
