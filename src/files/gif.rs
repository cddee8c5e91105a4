//! Animated pictures in GIF files, in one set of colours.
//!
//! `CompuServe`, *Graphics Interchange Format, Version 89a* (1990).

use std::io::Write;
use std::ops::Range;

use anyhow::Context as _;
use color_quant::NeuQuant;
use gamow_platform::threads::prelude::*;
use gif::{DisposalMethod, Encoder, Frame, Repeat};
use relativity_render::Picture;

/// Care with which the colours are chosen, from 1 (best) to 30 (fastest).
const CARE: i32 = 10;
/// Number of colours of a film. The number after the last marks pixels that have not changed.
const COLOURS: usize = 255;
/// Number of a pixel that has not changed.
const UNCHANGED: u8 = COLOURS as u8;
/// Bits of each primary by which the nearest colour is looked up.
const BITS: usize = 6;

/// The colours of a film. A colour of a picture is always shown as the same one of these, so that what rests
/// does not flicker.
pub struct Palette {
    /// Red, green and blue of each.
    rgb: Vec<u8>,
    /// The number of the one that is nearest to each cell of colours.
    nearest: Vec<u8>,
}

impl Palette {
    /// The colours that suit these pictures best.
    #[must_use]
    pub fn new<'a>(pictures: impl IntoIterator<Item = &'a Picture>) -> Self {
        let pixels: Vec<u8> =
            pictures.into_iter().flat_map(|picture| picture.rgba.as_flattened()).copied().collect();
        let learned = NeuQuant::new(CARE, COLOURS, &pixels);
        let middle = |cell: usize, primary: usize| {
            let bits = cell >> (BITS * primary) & ((1 << BITS) - 1);
            (((2 * bits + 1) << (8 - BITS)) / 2) as u8
        };
        let nearest =
            |cell| learned.index_of(&[middle(cell, 0), middle(cell, 1), middle(cell, 2), u8::MAX]) as u8;
        let cells = 0..1_usize << (3 * BITS);
        Self { rgb: learned.color_map_rgb(), nearest: cells.into_par_iter().map(nearest).collect() }
    }

    /// The numbers of the colours of a picture.
    fn numbers(&self, picture: &Picture) -> Vec<u8> {
        let number = |[red, green, blue, _]: &[u8; 4]| {
            let [red, green, blue] = [*red, *green, *blue].map(|part| usize::from(part) >> (8 - BITS));
            self.nearest[red | green << BITS | blue << (2 * BITS)]
        };
        picture.rgba.iter().map(number).collect()
    }
}

/// A file of frames that follow each other without an end, written a few frames at a time.
pub struct GifWriter<W: Write> {
    encoder: Encoder<W>,
    palette: Palette,
    width: usize,
    hundredths: u16,
    /// The colours of the last frame that was written; none before the first.
    shown: Vec<u8>,
}

impl<W: Write> GifWriter<W> {
    /// Begins a file of frames of this `size`, pixels, each of which is shown for this number of `hundredths`
    /// of a second, in the colours of `palette`.
    ///
    /// # Errors
    ///
    /// Those of `out`; a picture larger than such a file can hold.
    pub fn new(size: [u32; 2], hundredths: u16, palette: Palette, out: W) -> anyhow::Result<Self> {
        let side = |side| u16::try_from(side).context("a GIF has no more than 65535 pixels a side");
        let [width, height] = size;
        let mut encoder = Encoder::new(out, side(width)?, side(height)?, &palette.rgb)?;
        encoder.set_repeat(Repeat::Infinite)?;
        Ok(Self { encoder, palette, width: width as usize, hundredths, shown: Vec::new() })
    }

    /// Adds frames of the file's size, which are encoded beside each other.
    ///
    /// # Errors
    ///
    /// Those of the file.
    pub fn write(&mut self, frames: &[Picture]) -> anyhow::Result<()> {
        let Self { encoder, palette, width, hundredths, shown } = self;
        let numbers: Vec<_> = frames.par_iter().map(|frame| palette.numbers(frame)).collect();
        let encoded = |number: usize| {
            let before = if number == 0 { &*shown } else { &numbers[number - 1] };
            let mut frame = changes(before, &numbers[number], *width);
            frame.delay = *hundredths;
            frame.make_lzw_pre_encoded();
            frame
        };
        let encoded: Vec<_> = (0..frames.len()).into_par_iter().map(encoded).collect();
        for frame in &encoded {
            encoder.write_lzw_pre_encoded_frame(frame)?;
        }
        *shown = numbers.into_iter().next_back().unwrap_or_default();
        Ok(())
    }

    /// Finishes the file.
    ///
    /// # Errors
    ///
    /// Those of the file.
    pub fn finish(self) -> anyhow::Result<()> {
        self.encoder.into_inner()?;
        Ok(())
    }
}

/// The smallest rectangle around all that changes, with at least one pixel.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Changed {
    columns: Range<usize>,
    rows: Range<usize>,
}

impl Changed {
    /// Finds it for pictures in rows of this `width`; all of `next` where nothing of its size is `before` it.
    fn new(before: &[u8], next: &[u8], width: usize) -> Self {
        let height = next.len() / width;
        if before.len() != next.len() {
            return Self { columns: 0..width, rows: 0..height };
        }
        let row = |row: usize| row * width..(row + 1) * width;
        let differs = |&number: &usize| before[row(number)] != next[row(number)];
        let Some(first) = (0..height).find(differs) else { return Self { columns: 0..1, rows: 0..1 } };
        let last = (0..height).rfind(differs).unwrap_or(first);
        let (mut left, mut right) = (width, 0);
        for number in first..=last {
            let mut pairs = before[row(number)].iter().zip(&next[row(number)]);
            left = pairs.clone().take(left).position(|(a, b)| a != b).unwrap_or(left);
            right = pairs.rposition(|(a, b)| a != b).map_or(right, |at| right.max(at + 1));
        }
        Self { columns: left..right, rows: first..last + 1 }
    }
}

/// The frame that makes `next` of what is shown `before` it, rows of this `width`.
fn changes(before: &[u8], next: &[u8], width: usize) -> Frame<'static> {
    let Changed { columns, rows } = Changed::new(before, next, width);
    let pixels = rows.clone().flat_map(|row| columns.clone().map(move |column| row * width + column));
    let number = |at: usize| if before.get(at) == Some(&next[at]) { UNCHANGED } else { next[at] };
    // What a file holds has at most 65535 pixels a side.
    let [left, top, width, height] =
        [columns.start, rows.start, columns.len(), rows.len()].map(|number| number as u16);
    Frame {
        left,
        top,
        width,
        height,
        transparent: Some(UNCHANGED),
        dispose: DisposalMethod::Keep,
        buffer: pixels.map(number).collect(),
        ..Frame::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Wide and high, pixels.
    const SIZE: [u32; 2] = [60, 40];

    /// A grey ramp that rests, before which a red square moves to the right.
    fn frame(number: u32) -> Picture {
        let pixel = |at: u32| {
            let [x, y] = [at % SIZE[0], at / SIZE[0]];
            let is_red = (10..20).contains(&y) && (5 * number..5 * number + 10).contains(&x);
            if is_red { [200, 20, 30, 255] } else { [4 * x as u8, 4 * x as u8, 4 * x as u8, 255] }
        };
        Picture { size: SIZE, rgba: (0..SIZE[0] * SIZE[1]).map(pixel).collect() }
    }

    fn film(frames: &[Picture], at_once: usize) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut film = GifWriter::new(SIZE, 4, Palette::new(frames), &mut bytes).expect("it begins");
        frames.chunks(at_once).for_each(|frames| film.write(frames).expect("it is written"));
        film.finish().expect("it ends");
        bytes
    }

    /// The pictures that a viewer shows, which lays each frame over those before it.
    fn shown(bytes: &[u8]) -> Vec<Vec<[u8; 3]>> {
        let mut film = gif::DecodeOptions::new().read_info(bytes).expect("a GIF");
        let colours = film.global_palette().expect("it has colours").as_chunks::<3>().0.to_vec();
        let mut screen = vec![[0; 3]; (SIZE[0] * SIZE[1]) as usize];
        let mut all = Vec::new();
        while let Some(frame) = film.read_next_frame().expect("a whole GIF") {
            for (at, &number) in frame.buffer.iter().enumerate() {
                let [x, y] = [at % usize::from(frame.width), at / usize::from(frame.width)];
                let place = (usize::from(frame.top) + y) * SIZE[0] as usize + usize::from(frame.left) + x;
                if frame.transparent != Some(number) {
                    screen[place] = colours[usize::from(number)];
                }
            }
            all.push(screen.clone());
        }
        all
    }

    #[test]
    fn a_film_shows_its_pictures_and_what_rests_does_not_flicker() {
        let frames: Vec<_> = [0, 1, 2, 2, 5].map(frame).into();
        let shown = shown(&film(&frames, 2));
        assert_eq!(shown.len(), frames.len());
        for (shown, frame) in shown.iter().zip(&frames) {
            for (shown, [red, green, blue, _]) in shown.iter().zip(&frame.rgba) {
                let off = shown.iter().zip([red, green, blue]).map(|(a, b)| a.abs_diff(*b)).max();
                assert!(off <= Some(5), "{shown:?} for {:?}", [red, green, blue]);
            }
        }
        let below = (SIZE[0] * 20) as usize;
        assert!(shown.iter().all(|picture| picture[below..] == shown[0][below..]));
    }

    #[test]
    fn a_file_is_the_same_however_many_frames_are_written_at_once() {
        let frames: Vec<_> = (0..5).map(frame).collect();
        assert!(film(&frames, 1) == film(&frames, 5) && film(&frames, 2) == film(&frames, 5));
    }

    #[test]
    fn the_rectangle_holds_every_change_and_touches_one_on_each_side() {
        let before = [0; 30];
        let mut next = before;
        (next[8], next[21]) = (1, 1); // column 2 of row 1 and column 3 of row 3, in rows of 6
        assert_eq!(Changed::new(&before, &next, 6), Changed { columns: 2..4, rows: 1..4 });
        assert_eq!(Changed::new(&before, &before, 6), Changed { columns: 0..1, rows: 0..1 });
        assert_eq!(Changed::new(&[], &next, 6), Changed { columns: 0..6, rows: 0..5 });
    }
}
