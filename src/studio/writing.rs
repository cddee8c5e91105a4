//! Words in pictures, in capitals of straight strokes, drawn with the same pen as the letters of the eyes.

use glam::DVec2;
use relativity_render::Picture;

use super::letters::{distance_to_line, draw_by};

/// Rows of a letter's height.
const ROWS: f64 = 6.0;
/// Free space between letters, and the width of a blank, in widths of a column.
const BETWEEN: f64 = 1.7;
const BLANK: f64 = 2.0;
/// Width of a column in parts of that of a row.
const COLUMN: f64 = 0.85;
/// The size of a raised digit, in parts of a letter's.
const RAISED: f64 = 0.6;
/// The part of the room that a word takes at most.
const SHARE: f64 = 0.94;

/// Returns the width of a letter in columns, and its strokes: between bars the column and the row of each end and corner,
/// from the top left.
const fn strokes(letter: char) -> (f64, &'static str) {
    match letter {
        'A' => (4.0, "06 20 46|14 34"),
        'C' => (4.0, "41 30 10 01 05 16 36 45"),
        'D' => (4.0, "00 20 42 44 26 06 00"),
        'E' => (3.0, "30 00 06 36|03 23"),
        'F' => (3.0, "30 00 06|03 23"),
        'G' => (4.0, "41 30 10 01 05 16 36 45 43 23"),
        'H' => (4.0, "00 06|40 46|03 43"),
        'I' => (0.0, "00 06"),
        'L' => (3.0, "00 06 36"),
        'N' => (4.0, "06 00 46 40"),
        'O' | '0' => (4.0, "10 30 41 45 36 16 05 01 10"),
        'P' => (4.0, "06 00 30 41 42 33 03"),
        'R' => (4.0, "06 00 30 41 42 33 03|23 46"),
        'S' => (4.0, "41 30 10 01 02 13 33 44 45 36 16 05"),
        'T' => (4.0, "00 40|20 26"),
        'U' => (4.0, "00 05 16 36 45 40"),
        'Y' => (4.0, "00 23 40|23 26"),
        '1' => (2.0, "01 20 26"),
        '2' => (4.0, "01 10 30 41 42 06 46"),
        '3' => (4.0, "01 10 30 41 42 33 13|33 44 45 36 16 05"),
        '4' => (4.0, "36 30 04 44"),
        '5' => (4.0, "40 00 02 32 43 45 36 16 05"),
        '6' => (4.0, "30 10 01 05 16 36 45 44 33 03"),
        '7' => (4.0, "00 40 16"),
        '8' => (4.0, "13 02 01 10 30 41 42 33 13 04 05 16 36 45 44 33"),
        '9' => (4.0, "43 13 02 01 10 30 41 45 36 16"),
        '.' => (0.0, "05 06"),
        '−' => (3.0, "03 33"),
        _ => (BLANK, ""),
    }
}

/// A digit that is raised, as it is on the line.
const fn lowered(letter: char) -> Option<char> {
    match letter {
        '²' => Some('2'),
        '³' => Some('3'),
        '⁴' => Some('4'),
        _ => None,
    }
}

/// A letter of a line of height 1.
struct PlacedLetter {
    /// The distance of the text's beginning from the left.
    x: f64,
    /// The height of the writing.
    scale: f64,
    /// The width of the writing.
    width: f64,
    /// The ends of its strokes from its top left corner, in parts of its height.
    lines: Vec<[DVec2; 2]>,
}

/// The letters of `text` in a line of height 1, and the width of that.
fn laid_out(text: &str) -> (Vec<PlacedLetter>, f64) {
    let (mut placed, mut end) = (Vec::new(), 0.0);
    for letter in text.to_uppercase().chars() {
        let raised = lowered(letter);
        let scale = if raised.is_some() { RAISED } else { 1.0 };
        let (columns, told) = strokes(raised.unwrap_or(letter));
        let x = if end > 0.0 { end + BETWEEN * COLUMN / ROWS } else { 0.0 };
        let width = scale * columns * COLUMN / ROWS;
        placed.push(PlacedLetter { x, scale, width, lines: told.split('|').flat_map(lines).collect() });
        end = x + width;
    }
    (placed, end)
}

/// The lines of a stroke.
fn lines(stroke: &str) -> Vec<[DVec2; 2]> {
    let place = |pair: &str| {
        let digit = |at: usize| pair.as_bytes().get(at).map_or(0.0, |digit| f64::from(digit - b'0'));
        DVec2::new(COLUMN * digit(0), digit(1)) / ROWS
    };
    let places: Vec<_> = stroke.split_whitespace().map(place).collect();
    places.windows(2).map(|ends| [ends[0], ends[1]]).collect()
}

/// Draws `text` about `middle` into `picture`, at most so wide and so high, pixels, in an sRGB-encoded `colour`.
pub fn draw(picture: &mut Picture, text: &str, middle: [f64; 2], [room, height]: [f64; 2], colour: [u8; 3]) {
    let (placed, width) = laid_out(text);
    let height = height.min(SHARE * room / width.max(f64::MIN_POSITIVE));
    let corner = DVec2::from(middle) - 0.5 * height * DVec2::new(width, 1.0);
    for PlacedLetter { x, scale, width, lines } in placed {
        let from = corner + height * DVec2::new(x, 0.0);
        let middle = from + 0.5 * height * DVec2::new(width, scale);
        let distance =
            |place| lines.iter().map(|line| distance_to_line(place, *line)).fold(f64::INFINITY, f64::min);
        draw_by(picture, distance, middle.into(), [from.x, from.y, scale * height], colour);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_of_a_picture_can_be_written() {
        let names = [
            "as seen",
            "contracted only",
            "at rest",
            "one light cone",
            "D² paper",
            "D³ photons",
            "D⁴ surface",
            "no D",
            "D to −2.5",
            "D to 0136789",
        ];
        for letter in names.iter().flat_map(|name| name.to_uppercase().chars().collect::<Vec<_>>()) {
            let drawn = strokes(lowered(letter).unwrap_or(letter)).1;
            assert_eq!(drawn.is_empty(), letter == ' ', "{letter}");
        }
    }

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
}
