//! Where the pictures of the two eyes lie in a file. What tells them apart, a letter above each and a bar between them,
//! stands outside of them, so that every pixel of theirs stays as it was drawn and can be measured.

use relativity_render::Picture;

use super::letters;
use crate::eye_colours;
use crate::flags::choices::Layout;

/// Height of the strip of letters in parts of the pictures', and at least, pixels.
const STRIP: (f64, u32) = (1.0 / 15.0, 12);
/// Width of the bar between the pictures in parts of one, and at least, pixels.
const BAR: (f64, u32) = (1.0 / 160.0, 2);
/// Height of a letter in parts of the strip's.
const LETTER: f64 = 0.6;

/// What the strip and the bar are drawn with, sRGB-encoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ink {
    /// Behind the letters, and between the pictures.
    paper: [u8; 3],
    /// The letters of the left and the right eye.
    letters: [[u8; 3]; 2],
}

impl Ink {
    /// Beside pictures with a dark background.
    const DARK: Self = Self { paper: [0x2D, 0x32, 0x3C], letters: eye_colours::ON_DARK };
    /// Beside pictures with a light one.
    const LIGHT: Self = Self { paper: [0xD5, 0xD9, 0xE0], letters: eye_colours::ON_LIGHT };

    /// Beside pictures whose background `is_light`.
    #[must_use]
    pub const fn beside(is_light: bool) -> Self {
        if is_light { Self::LIGHT } else { Self::DARK }
    }
}

/// How a file is divided among the pictures in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sheet {
    /// Width and height of the file, pixels.
    pub size: [u32; 2],
    eye_size: [u32; 2],
    /// Height of the strip of letters, 0 without.
    strip: u32,
    /// The eyes side by side (0 left, 1 right), each with where its picture begins from the left.
    columns: Vec<(usize, u32)>,
}

impl Sheet {
    /// The sheet of `layout` for pictures of `eye_size`; with `labels` where it shows one beside the other.
    #[must_use]
    pub fn new(layout: Layout, eye_size: [u32; 2], labels: bool) -> Self {
        let [width, height] = eye_size;
        let part =
            |side: u32, (part, least): (f64, u32)| ((f64::from(side) * part).round() as u32).max(least);
        let eyes = layout.side_by_side();
        let is_labelled = labels && eyes.len() > 1;
        let (strip, bar) = if is_labelled { (part(height, STRIP), part(width, BAR)) } else { (0, 0) };
        let columns: Vec<_> = (0..).zip(eyes).map(|(column, &eye)| (eye, column * (width + bar))).collect();
        let last = columns.last().map_or(0, |(_, x)| *x);
        Self { size: [last + width, strip + height], eye_size, strip, columns }
    }

    /// The sheet of a file that has this `size`, be it labelled or not; `None` if it has another than both.
    #[must_use]
    pub fn of_file(layout: Layout, eye_size: [u32; 2], size: [u32; 2]) -> Option<Self> {
        [true, false]
            .map(|labels| Self::new(layout, eye_size, labels))
            .into_iter()
            .find(|sheet| sheet.size == size)
    }

    /// The file that holds `pictures`, those of the eyes from the left.
    #[must_use]
    pub fn composed(&self, pictures: &[Picture], ink: Ink) -> Picture {
        let [r, g, b] = ink.paper;
        let pixels = self.size.map(|side| side as usize).iter().product();
        let mut sheet = Picture { size: self.size, rgba: vec![[r, g, b, u8::MAX]; pixels] };
        for (&(eye, x), picture) in self.columns.iter().zip(pictures) {
            for (row, pixels) in (self.strip..).zip(picture.rgba.chunks(self.eye_size[0] as usize)) {
                let first = (row * self.size[0] + x) as usize;
                sheet.rgba[first..first + pixels.len()].copy_from_slice(pixels);
            }
            self.label(&mut sheet, eye, x, ink);
        }
        sheet
    }

    /// Writes the letter of `eye` above its picture, which begins at `x`.
    fn label(&self, sheet: &mut Picture, eye: usize, x: u32, ink: Ink) {
        let middle = [f64::from(x) + 0.5 * f64::from(self.eye_size[0]), 0.5 * f64::from(self.strip)];
        let height = LETTER * f64::from(self.strip);
        if self.strip > 0 {
            letters::draw(sheet, &letters::OF_EYES[eye], middle, height, ink.letters[eye]);
        }
    }

    /// The picture of `eye` (0 left, 1 right) in `file`, which has this sheet; `None` if it is not in it.
    #[must_use]
    pub fn picture_of(&self, eye: usize, file: &Picture) -> Option<Picture> {
        let (_, x) = *self.columns.iter().find(|(shown, _)| *shown == eye)?;
        let [first, width] = [x, self.eye_size[0]].map(|side| side as usize);
        let rows = file.rgba.chunks(self.size[0] as usize).skip(self.strip as usize);
        let rgba = rows.flat_map(|row| &row[first..first + width]).copied().collect();
        Some(Picture { size: self.eye_size, rgba })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture in which no two pixels are alike.
    fn picture(size: [u32; 2], eye: u8) -> Picture {
        let pixel = |i: u32| [(i % 251) as u8, (i / 251) as u8, eye, u8::MAX];
        Picture { size, rgba: (0..size[0] * size[1]).map(pixel).collect() }
    }

    #[test]
    fn what_is_put_on_a_sheet_is_found_there_again_to_the_last_pixel() {
        for size in [[1, 1], [48, 36], [160, 120], [400, 300]] {
            let pictures = [picture(size, 0), picture(size, 1)];
            for (layout, order) in [(Layout::SideBySide, [0, 1]), (Layout::CrossEyed, [1, 0])] {
                for labels in [true, false] {
                    let sheet = Sheet::new(layout, size, labels);
                    let shown = order.map(|eye: usize| pictures[eye].clone());
                    let file = sheet.composed(&shown, Ink::beside(labels));
                    assert_eq!(
                        (file.size, file.rgba.len()),
                        (sheet.size, (sheet.size[0] * sheet.size[1]) as usize)
                    );
                    let found = Sheet::of_file(layout, size, file.size).expect("it is one");
                    for eye in [0, 1] {
                        assert_eq!(found.picture_of(eye, &file).as_ref(), Some(&pictures[eye]));
                    }
                }
            }
        }
    }

    #[test]
    fn one_picture_fills_its_file() {
        for layout in [Layout::Left, Layout::Right, Layout::Anaglyph, Layout::Overlay] {
            assert_eq!(Sheet::new(layout, [48, 36], true).size, [48, 36]);
        }
        assert_eq!(Sheet::of_file(Layout::SideBySide, [48, 36], [50, 36]), None);
    }
}
