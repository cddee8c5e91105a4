//! Sheets: the places of the two eyes' pictures in a file. A letter above each and a bar between them, which
//! distinguish them, lie outside of them, so that every pixel of theirs stays as it was drawn and can be
//! measured.

use relativity_render::Picture;

use super::writing;
use crate::eye_colours;
use crate::flags::choices::Form;
use crate::settings::PictureSettings as Settings;

/// Height of the strip of letters in parts of the pictures', and at least, pixels.
const STRIP: (f64, u32) = (1.0 / 15.0, 12);
/// Width of the bar between the pictures in parts of one, and at least, pixels.
const BAR: (f64, u32) = (1.0 / 160.0, 2);
/// Height of a letter in parts of the strip's.
const LETTER: f64 = 0.6;

/// The ink of the strip and the bar, sRGB-encoded.
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

/// The writing above pictures.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Labels {
    /// The colours of that writing.
    pub ink: Ink,
    /// Names of two pictures of one eye, in place of the eyes' letters.
    pub compared: Option<[String; 2]>,
}

impl Default for Labels {
    fn default() -> Self {
        Self { ink: Ink::DARK, compared: None }
    }
}

/// The division of a file among the pictures in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sheet {
    /// Width and height of the file, pixels.
    pub size: [u32; 2],
    eye_size: [u32; 2],
    /// Height of the strip of letters, 0 without.
    strip: u32,
    /// The pictures in the sheet.
    parts: Vec<SheetPicture>,
}

/// A picture in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct SheetPicture {
    /// Eye of the picture (0 left, 1 right).
    eye: usize,
    /// Number of the frame in the file.
    frame: usize,
    /// Place of its corner there, from the left and from the top.
    corner: [u32; 2],
}

impl Sheet {
    /// The sheet of `picture` for pictures of `eye_size`; with `labels` where it shows them beside or above
    /// each other. Where they are composed pixel by pixel none of them is in it.
    #[must_use]
    pub fn new(picture: &Settings, eye_size: [u32; 2], labels: bool) -> Self {
        let [width, height] = eye_size;
        let part =
            |side: u32, (part, least): (f64, u32)| ((f64::from(side) * part).round() as u32).max(least);
        let form = picture.layout.form();
        let is_labelled = labels && matches!(form, Form::Beside | Form::Above);
        let (strip, bar) = if is_labelled { (part(height, STRIP), part(width, BAR)) } else { (0, 0) };
        let places = match form {
            Form::One(_) => vec![(0, [0, 0])],
            Form::Beside => vec![(0, [0, strip]), (0, [width + bar, strip])],
            Form::Above => vec![(0, [0, strip]), (0, [0, height + 2 * strip])],
            Form::InTurn => vec![(0, [0, 0]), (1, [0, 0])],
            Form::Composed(_) => Vec::new(),
        };
        let parts: Vec<_> = places
            .into_iter()
            .zip(picture.eyes())
            .map(|((frame, corner), &eye)| SheetPicture { eye, frame, corner })
            .collect();
        let size = match (form, parts.last()) {
            (Form::Composed(composition), _) => composition.size(eye_size),
            (_, last) => {
                let [x, y] = last.map_or([0, 0], |part| part.corner);
                [x + width, y + height]
            }
        };
        Self { size, eye_size, strip, parts }
    }

    /// The sheet of a file that has this `size`, be it labelled or not; `None` if it has another than both.
    #[must_use]
    pub fn of_file(picture: &Settings, eye_size: [u32; 2], size: [u32; 2]) -> Option<Self> {
        [true, false]
            .map(|labels| Self::new(picture, eye_size, labels))
            .into_iter()
            .find(|sheet| sheet.size == size)
    }

    /// Returns the pixels per metre at which the middles of pictures beside each other are `millimetres`
    /// (above 0) apart, or hardly less.
    #[must_use]
    pub fn pixels_per_metre(&self, millimetres: f64) -> u32 {
        let apart = self.parts.last().map_or(0, |part| part.corner[0]);
        (f64::from(apart) / (1e-3 * millimetres)).ceil() as u32
    }

    /// The frames of the file that holds `pictures`, those of the eyes in the order of the layout.
    #[must_use]
    pub fn composed(&self, pictures: &[Picture], labels: &Labels) -> Vec<Picture> {
        let [r, g, b] = labels.ink.paper;
        let pixels = self.size.map(|side| side as usize).iter().product();
        let blank = Picture { size: self.size, rgba: vec![[r, g, b, u8::MAX]; pixels] };
        let last = self.parts.last().map_or(0, |part| part.frame);
        let mut frames = vec![blank; last + 1];
        for (&SheetPicture { eye, frame, corner: [x, y] }, picture) in self.parts.iter().zip(pictures) {
            let sheet = &mut frames[frame];
            for (row, pixels) in (y..).zip(picture.rgba.chunks(self.eye_size[0] as usize)) {
                let first = (row * self.size[0] + x) as usize;
                sheet.rgba[first..first + pixels.len()].copy_from_slice(pixels);
            }
            self.label(sheet, eye, [x, y], labels);
        }
        frames
    }

    /// Writes the letter of `eye`, or what it is compared by, above its picture, which begins at that corner.
    fn label(&self, sheet: &mut Picture, eye: usize, [x, y]: [u32; 2], labels: &Labels) {
        let half = 0.5 * f64::from(self.strip);
        let middle = [f64::from(x) + 0.5 * f64::from(self.eye_size[0]), f64::from(y) - half];
        let height = LETTER * f64::from(self.strip);
        // Both pictures that are compared are the left eye's.
        let (text, colour) = match &labels.compared {
            None => (["L", "R"][eye], labels.ink.letters[eye]),
            Some(names) => (&*names[eye], labels.ink.letters[0]),
        };
        if self.strip > 0 {
            writing::draw(sheet, text, middle, [f64::from(self.eye_size[0]), height], colour);
        }
    }

    /// The picture of `eye` (0 left, 1 right) in the `frames` of a file that has this sheet; `None` if it is
    /// not in it.
    #[must_use]
    pub fn picture_of(&self, eye: usize, frames: &[Picture]) -> Option<Picture> {
        let SheetPicture { frame, corner, .. } = *self.parts.iter().find(|part| part.eye == eye)?;
        let [x, y] = corner.map(|side| side as usize);
        let [width, height] = self.eye_size.map(|side| side as usize);
        let rows = frames.get(frame)?.rgba.chunks(self.size[0] as usize).skip(y).take(height);
        let rgba = rows.flat_map(|row| &row[x..x + width]).copied().collect();
        Some(Picture { size: self.eye_size, rgba })
    }
}

#[cfg(test)]
mod tests {
    use clap::ValueEnum as _;

    use super::*;
    use crate::flags::choices::{Layout, Swapped};

    /// A picture in which no two pixels are alike.
    fn picture(size: [u32; 2], eye: u8) -> Picture {
        let pixel = |i: u32| [(i % 251) as u8, (i / 251) as u8, eye, u8::MAX];
        Picture { size, rgba: (0..size[0] * size[1]).map(pixel).collect() }
    }

    fn shown(layout: Layout, is_swapped: bool) -> Settings {
        let swapped = if is_swapped { Swapped::default().toggled(layout) } else { Swapped::default() };
        Settings { layout, swapped, ..Settings::default() }
    }

    #[test]
    fn what_is_put_on_a_sheet_is_found_there_again_to_the_last_pixel() {
        let lossless = [
            Layout::SideBySide,
            Layout::FreeViewing,
            Layout::CrossEyed,
            Layout::OverUnder,
            Layout::Flicker,
            Layout::Left,
            Layout::Right,
        ];
        let all: Vec<_> = Layout::value_variants().iter().copied().filter(|l| l.loses_nothing()).collect();
        assert!(all.len() == lossless.len() && all.iter().all(|layout| lossless.contains(layout)));
        for size in [[1, 1], [48, 36], [160, 120], [400, 300]] {
            let pictures = [picture(size, 0), picture(size, 1)];
            for layout in lossless {
                for (labels, is_swapped) in [(true, false), (true, true), (false, false), (false, true)] {
                    let settings = shown(layout, is_swapped);
                    let sheet = Sheet::new(&settings, size, labels);
                    let eyes: Vec<_> = settings.eyes().iter().map(|&eye| pictures[eye].clone()).collect();
                    let written = Labels { ink: Ink::beside(labels), compared: None };
                    let file = sheet.composed(&eyes, &written);
                    for frame in &file {
                        let pixels = (sheet.size[0] * sheet.size[1]) as usize;
                        assert_eq!((frame.size, frame.rgba.len()), (sheet.size, pixels));
                    }
                    let found = Sheet::of_file(&settings, size, file[0].size).expect("it is one");
                    for eye in [0, 1] {
                        let expected = settings.eyes().contains(&eye).then_some(&pictures[eye]);
                        assert_eq!(found.picture_of(eye, &file).as_ref(), expected, "{layout:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn swapped_eyes_change_places() {
        for layout in [Layout::SideBySide, Layout::CrossEyed, Layout::OverUnder, Layout::Flicker] {
            let [with_defaults, swapped] =
                [false, true].map(|is_swapped| Sheet::new(&shown(layout, is_swapped), [48, 36], true));
            assert_eq!(with_defaults.size, swapped.size);
            for (one, other) in with_defaults.parts.iter().zip(&swapped.parts) {
                assert_eq!((one.eye, one.corner, one.frame), (1 - other.eye, other.corner, other.frame));
            }
        }
        assert_eq!(shown(Layout::CrossEyed, false).eyes(), [1, 0]);
    }

    #[test]
    fn one_picture_fills_its_file() {
        for layout in [Layout::Left, Layout::Right, Layout::Anaglyph, Layout::Overlay, Layout::Rows] {
            assert_eq!(Sheet::new(&shown(layout, false), [48, 36], true).size, [48, 36]);
        }
        assert_eq!(Sheet::of_file(&shown(Layout::SideBySide, false), [48, 36], [50, 36]), None);
    }

    #[test]
    fn for_free_viewing_the_middles_of_the_pictures_are_as_far_apart_as_is_asked() {
        for (size, labels, millimetres) in [([960, 720], true, 60.0), ([301, 100], false, 62.5)] {
            let sheet = Sheet::new(&shown(Layout::FreeViewing, false), size, labels);
            let metres = f64::from(sheet.size[0] - size[0]) / f64::from(sheet.pixels_per_metre(millimetres));
            assert!(1e3 * metres <= millimetres && 1e3 * metres > 0.999 * millimetres, "{metres}");
        }
    }
}
