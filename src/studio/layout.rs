//! One picture from the pictures of the two eyes.

use relativity_render::Picture;
use relativity_render::colour::{hue_preserving_clip, srgb_decoded};
use relativity_render::picture::encoded;

use crate::flags::choices::Layout;

/// The left eye's colour wherever eyes are told apart by colour, sRGB-encoded; with the right eye's a
/// pair that colour-blind eyes tell apart (M. Okabe and K. Ito, *Color universal design*, 2008).
const LEFT_COLOUR: [u8; 3] = [0x56, 0xB4, 0xE9];
/// The right eye's.
const RIGHT_COLOUR: [u8; 3] = [0xE6, 0x9F, 0x00];

impl Layout {
    /// The eyes it shows (0 left, 1 right), in the order in which [`Self::composed`] wants them.
    #[must_use]
    pub const fn eyes(self) -> &'static [usize] {
        match self {
            Self::SideBySide | Self::Anaglyph | Self::Overlay => &[0, 1],
            Self::CrossEyed => &[1, 0],
            Self::Left => &[0],
            Self::Right => &[1],
        }
    }

    /// The picture that shows those of [`Self::eyes`], all of one size.
    #[must_use]
    pub fn composed(self, mut eyes: Vec<Picture>) -> Picture {
        match (self, eyes.as_slice()) {
            (Self::SideBySide | Self::CrossEyed, [first, second]) => beside(first, second),
            (Self::Anaglyph, [left, right]) => blended(left, right, anaglyph),
            (Self::Overlay, [left, right]) => blended(left, right, overlay),
            _ => eyes.swap_remove(0),
        }
    }
}

fn beside(first: &Picture, second: &Picture) -> Picture {
    let [width, height] = first.size;
    let [first, second] = [first, second].map(|picture| picture.rgba.chunks(width as usize));
    let rgba = first.zip(second).flat_map(|(a, b)| [a, b].concat()).collect();
    Picture { size: [2 * width, height], rgba }
}

fn blended(left: &Picture, right: &Picture, blend: impl Fn([u8; 4], [u8; 4]) -> [u8; 4]) -> Picture {
    let rgba = left.rgba.iter().zip(&right.rgba).map(|(&l, &r)| blend(l, r)).collect();
    Picture { size: left.size, rgba }
}

/// Red from the left, green and blue from the right eye. The largest component counts, not the luminance:
/// it is what stands for brightness where one wavelength fills the picture.
fn anaglyph(left: [u8; 4], right: [u8; 4]) -> [u8; 4] {
    let [left, right] = [largest(left), largest(right)];
    [left, right, right, u8::MAX]
}

fn overlay(left: [u8; 4], right: [u8; 4]) -> [u8; 4] {
    let linear = |encoded: u8| srgb_decoded(f64::from(encoded) / 255.0);
    let [left, right] = [left, right].map(|pixel| linear(largest(pixel)));
    let part = |i: usize| left * linear(LEFT_COLOUR[i]) + right * linear(RIGHT_COLOUR[i]);
    encoded(hue_preserving_clip([part(0), part(1), part(2)]))
}

fn largest([r, g, b, _]: [u8; 4]) -> u8 {
    r.max(g).max(b)
}
