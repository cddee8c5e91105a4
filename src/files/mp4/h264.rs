//! Frames in H.264, in groups that can be decoded by themselves.
//!
//! Recommendation ITU-T H.264 (08/2021).

use relativity_render::Picture;
use rusty_h264_common::nal::split_annex_b;
use rusty_h264_common::{BitWriter, NalUnit, YuvFrame};
use rusty_h264_encoder::{Encoder, EncoderConfig, Pps, Sps};

/// Number of frames of each group but the last: the first is a picture, the others are changes of it.
pub const GROUP: usize = 12;
/// Primaries, transfer function and matrix, as numbers in table E-3 and after it: those of sRGB, and the
/// brightness of BT.709.
pub const COLOURS: [u8; 3] = [1, 13, 1];
/// Step of the coefficients, in sixths of an octave.
const STEP: u8 = 21;
/// Shares of red and blue in the brightness of BT.709.
const RED: f32 = 0.2126;
const BLUE: f32 = 0.0722;
/// Side of a block, pixels.
const BLOCK: usize = 16;
/// Greatest number of blocks in a frame, and along one of its sides: those of level 5.2.
const MOST_BLOCKS: usize = 36_864;
const MOST_ALONG: usize = 543;

/// Returns how frames of this `size` are encoded. A side of an odd number of pixels gets one more.
///
/// # Errors
///
/// A frame larger than those of level 5.2.
pub fn config(size: [u32; 2], [numerator, denominator]: [u16; 2]) -> anyhow::Result<EncoderConfig> {
    let [width, height] = size.map(|side| side.next_multiple_of(2) as usize);
    let blocks = [width, height].map(|side| side.div_ceil(BLOCK));
    anyhow::ensure!(
        blocks[0] * blocks[1] <= MOST_BLOCKS && blocks.iter().all(|&along| along <= MOST_ALONG),
        "an MP4 has at most 9.4 million pixels a frame, such as 4096x2304, and 8688 a side, but this one would \
         have {}x{}: a GIF, an animated PNG and a folder have no such bound",
        size[0],
        size[1]
    );
    let mut config = EncoderConfig::new(width, height);
    config.qp = STEP;
    config.gop_size = GROUP as u32;
    config.scenecut = 0;
    config.framerate = f32::from(denominator) / f32::from(numerator);
    Ok(config)
}

/// Returns the brightness of each pixel of a picture, and the colours of every four.
#[must_use]
pub fn planes(picture: &Picture, config: &EncoderConfig) -> YuvFrame {
    let [width, height] = picture.size.map(|side| side as usize);
    let pixel = |x: usize, y: usize| {
        let [red, green, blue, _] = picture.rgba[y.min(height - 1) * width + x.min(width - 1)].map(f32::from);
        [
            red / 255.0,
            RED * red / 255.0 + (1.0 - RED - BLUE) * green / 255.0 + BLUE * blue / 255.0,
            blue / 255.0,
        ]
    };
    let mut planes = YuvFrame::black(config.width, config.height);
    for (y, row) in planes.y.chunks_exact_mut(config.width).enumerate() {
        for (x, brightness) in row.iter_mut().enumerate() {
            *brightness = (16.0 + 219.0 * pixel(x, y)[1]).round() as u8;
        }
    }
    let half = config.width / 2;
    for (number, (u, v)) in planes.u.iter_mut().zip(&mut planes.v).enumerate() {
        let [x, y] = [2 * (number % half), 2 * (number / half)];
        let four = [pixel(x, y), pixel(x + 1, y), pixel(x, y + 1), pixel(x + 1, y + 1)];
        let [red, brightness, blue] =
            [0, 1, 2].map(|part| four.iter().map(|pixel| pixel[part] / 4.0).sum::<f32>());
        *u = (128.0 + 112.0 * (blue - brightness) / (1.0 - BLUE)).round() as u8;
        *v = (128.0 + 112.0 * (red - brightness) / (1.0 - RED)).round() as u8;
    }
    planes
}

/// Encodes a group of frames, each as a sample of an MP4 file.
///
/// # Errors
///
/// Frames of another size.
pub fn encoded(group: &[YuvFrame], config: &EncoderConfig) -> anyhow::Result<Vec<Vec<u8>>> {
    let frames = Encoder::new(config.clone())?.encode_all(group)?;
    Ok(frames.iter().map(|frame| sample(frame)).collect())
}

/// The slices of a frame, each after its length. The parameter sets before them stand in the file's header.
fn sample(frame: &[u8]) -> Vec<u8> {
    let slices = split_annex_b(frame).into_iter().filter(|part| matches!(part[0] & 0x1F, 1 | 5));
    slices.flat_map(|part| [&(part.len() as u32).to_be_bytes()[..], part].concat()).collect()
}

/// Returns the parameter sets of the stream: that of the sequence, and that of its pictures.
#[must_use]
pub fn parameters(config: &EncoderConfig, seconds: [u16; 2]) -> [Vec<u8>; 2] {
    let mut sequence = Sps::from_config(config).to_nal();
    sequence.rbsp = with_usability(&sequence.rbsp, config.num_ref_frames, seconds);
    [sequence, Pps::from_config(config).to_nal()].map(|set: NalUnit| set.to_annex_b()[4..].to_vec())
}

/// Adds to a parameter set of a sequence what the encoder leaves out: how its colours are meant, how long a
/// frame is shown, and that no frame waits for a later one. (Annex E.)
fn with_usability(set: &[u8], references: u32, [numerator, denominator]: [u16; 2]) -> Vec<u8> {
    let bit = |at: usize| set[at / 8] >> (7 - at % 8) & 1;
    // The last bit that is set ends the set; the one before it says that there is no such addition.
    let end = (0..8 * set.len()).rfind(|&at| bit(at) == 1).unwrap_or_default();
    let write_all =
        |out: &mut BitWriter, numbers: &[u32]| numbers.iter().for_each(|&number| out.write_ue(number));
    let mut out = BitWriter::new();
    for at in 0..end.saturating_sub(1) {
        // It keeps to no lower profile, against what the encoder says in its second byte.
        out.write_bit(bit(at) == 1 && !(8..16).contains(&at));
    }
    out.write_bits(0b11, 2); // it has an addition; the pixels have a shape:
    out.write_bits(1, 8); // square
    out.write_bits(0b01, 2); // nothing on borders; the signal is described:
    out.write_bits(0b10101, 5); // of no old norm, from 16 to 235, in these colours:
    for kind in COLOURS {
        out.write_bits(kind.into(), 8);
    }
    out.write_bit(true); // colours lie, in both fields,
    write_all(&mut out, &[1, 1]); // amid their four pixels
    out.write_bit(true); // the clock, two ticks a frame:
    out.write_bits(numerator.into(), 32);
    out.write_bits(2 * u32::from(denominator), 32);
    out.write_bits(0b1000, 4); // all frames equally long; no model of buffers, no fields
    out.write_bits(0b11, 2); // bounds: motion may lead out of the picture,
    write_all(&mut out, &[0, 0, 15, 15]); // sizes and motion are free,
    write_all(&mut out, &[0, references]); // no frame is shown later than it comes
    out.rbsp_trailing_bits();
    out.into_bytes()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_primaries_and_grey_have_the_values_of_bt709() {
        // ITU-R BT.709-6, 3: rounded to 8 bits; red, green, blue, white, black, and grey at 128.
        let colours = [[255, 0, 0], [0, 255, 0], [0, 0, 255], [255; 3], [0; 3], [128; 3]];
        let values =
            [[63, 102, 240], [173, 42, 26], [32, 240, 118], [235, 128, 128], [16, 128, 128], [126, 128, 128]];
        for ([red, green, blue], value) in colours.into_iter().zip(values) {
            let picture = Picture { size: [3, 1], rgba: vec![[red, green, blue, 255]; 3] };
            let planes = planes(&picture, &config(picture.size, [1, 25]).expect("it is small"));
            assert_eq!([planes.y.len(), planes.u.len(), planes.v.len()], [8, 2, 2]);
            for (y, (u, v)) in planes.y.iter().zip(planes.u.iter().zip(&planes.v).cycle()) {
                assert_eq!([*y, *u, *v], value, "{red} {green} {blue}");
            }
        }
    }

    #[test]
    fn frames_are_at_most_as_large_as_a_player_must_take() {
        for (size, is_right) in
            [([4096, 2304], true), ([8688, 1000], true), ([8690, 16], false), ([4097, 2304], false)]
        {
            assert_eq!(config(size, [1, 25]).is_ok(), is_right, "{size:?}");
        }
    }
}
