//! The header of an MP4 file: nested boxes, each with its length and its kind before it.
//!
//! ISO/IEC 14496-12 (the boxes) and 14496-15 (H.264 in them).

use super::h264::{COLOURS, GROUP};

/// Number by which the file's clock is finer than frames need: some players take no coarse one.
const TICKS: u32 = 1000;
/// The matrix that leaves a picture as it is.
const UPRIGHT: [u32; 9] = [0x0001_0000, 0, 0, 0, 0x0001_0000, 0, 0, 0, 0x4000_0000];
/// The language of a film without words.
const UNDETERMINED: u32 = 0x55C4_0000;
/// 72 pixels an inch, as all such files say.
const RESOLUTION: u32 = 0x0048_0000;

/// The one track of a film.
pub struct Track {
    /// Width and height, pixels, both even.
    pub size: [u32; 2],
    /// Time for which each frame is shown, seconds as a fraction.
    pub seconds: [u32; 2],
    /// Parameter sets of the stream: that of the sequence, and that of its pictures.
    pub parameters: [Vec<u8>; 2],
}

impl Track {
    /// Returns all that stands before the frames, whose sizes these are, bytes. Its length depends on the
    /// number of the frames alone.
    #[must_use]
    pub fn header(&self, sizes: &[u32]) -> Vec<u8> {
        let brands = boxed("ftyp", &[b"isom", &numbers(&[0x200]), b"isomiso2avc1mp41"]);
        let bytes: u64 = sizes.iter().copied().map(u64::from).sum();
        // The length in 64 bits, as a long film needs it: the box's own begins with 16 bytes.
        let data = [&numbers(&[1])[..], b"mdat", &(bytes + 16).to_be_bytes()].concat();
        let header = |start: usize| [&brands[..], &self.movie(sizes, start as u32), &data].concat();
        header(header(0).len())
    }

    /// The description of the film, whose frames begin at byte `start` of the file.
    fn movie(&self, sizes: &[u32], start: u32) -> Vec<u8> {
        let [numerator, denominator] = self.seconds;
        let (scale, length) = (TICKS * denominator, TICKS * numerator * sizes.len() as u32);
        let [width, height] = self.size;
        let matrix = numbers(&UPRIGHT);
        let times = numbers(&[0, 0, 0, scale, length, 0x0001_0000, 0x0100_0000, 0, 0]);
        let movie = boxed("mvhd", &[&times, &matrix, &numbers(&[0, 0, 0, 0, 0, 0, 2])]);
        let times = numbers(&[7, 0, 0, 1, 0, length, 0, 0, 0, 0]);
        let track = boxed("tkhd", &[&times, &matrix, &numbers(&[width << 16, height << 16])]);
        let media = boxed("mdhd", &[&numbers(&[0, 0, 0, scale, length, UNDETERMINED])]);
        let kind = boxed("hdlr", &[&numbers(&[0, 0]), b"vide", &numbers(&[0, 0, 0]), b"\0"]);
        let video = boxed("vmhd", &[&numbers(&[1, 0, 0])]);
        let here = boxed("dref", &[&numbers(&[0, 1]), &boxed("url ", &[&numbers(&[1])])]);
        let table = self.table(sizes, start);
        let data = boxed("minf", &[&video, &boxed("dinf", &[&here]), &table]);
        boxed("moov", &[&movie, &boxed("trak", &[&track, &boxed("mdia", &[&media, &kind, &data])])])
    }

    /// The table of the frames, which follow each other from byte `start` of the file on.
    fn table(&self, sizes: &[u32], start: u32) -> Vec<u8> {
        let frames = sizes.len() as u32;
        let firsts: Vec<u32> = (1..=frames).step_by(GROUP).collect();
        let list = |kind, head: &[u32], all: &[u32]| boxed(kind, &[&numbers(head), &numbers(all)]);
        let format = boxed("stsd", &[&numbers(&[0, 1]), &self.format()]);
        let times = list("stts", &[0, 1], &[frames, TICKS * self.seconds[0]]);
        let keys = list("stss", &[0, firsts.len() as u32], &firsts);
        let chunks = list("stsc", &[0, 1], &[1, frames, 1]);
        let lengths = list("stsz", &[0, 0, frames], sizes);
        boxed("stbl", &[&format, &times, &keys, &chunks, &lengths, &list("stco", &[0, 1], &[start])])
    }

    /// The format of the frames.
    fn format(&self) -> Vec<u8> {
        let [sequence, pictures] = &self.parameters;
        let length = |set: &[u8]| (set.len() as u16).to_be_bytes();
        // Lengths of four bytes before each part of a frame, one set of each sort, brightness and colours of
        // eight bits with a colour for four pixels.
        let decoder = boxed(
            "avcC",
            &[
                &[1],
                &sequence[1..4],
                &[0xFF, 0xE1],
                &length(sequence),
                sequence,
                &[1],
                &length(pictures),
                pictures,
                &[0xFD, 0xF8, 0xF8, 0],
            ],
        );
        let colours = boxed("colr", &[b"nclx", &COLOURS.map(|kind| [0, kind]).concat(), &[0]]);
        let [width, height] = self.size;
        let picture = numbers(&[0, 1, 0, 0, 0, 0, width << 16 | height, RESOLUTION, RESOLUTION, 0]);
        boxed("avc1", &[&picture, &[0, 1], &[0; 32], &[0, 24, 0xFF, 0xFF], &decoder, &colours])
    }
}

/// A box of this `kind` around `parts`.
fn boxed(kind: &str, parts: &[&[u8]]) -> Vec<u8> {
    let inside = parts.concat();
    [&numbers(&[inside.len() as u32 + 8])[..], kind.as_bytes(), &inside].concat()
}

/// The bytes of `numbers`.
fn numbers(numbers: &[u32]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_be_bytes()).collect()
}
