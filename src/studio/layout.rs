//! One picture from the pictures of the two eyes.

use relativity_render::Picture;
use relativity_render::colour::{hue_preserving_clip, srgb_decoded};
use relativity_render::picture::encoded;

use super::sheet::{Ink, Sheet};
use crate::eye_colours;
use crate::flags::choices::Layout;

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

    /// The eyes whose pictures stand beside each other, from the left; the first alone where one lies on the other.
    #[must_use]
    pub const fn side_by_side(self) -> &'static [usize] {
        match self {
            Self::Anaglyph | Self::Overlay => &[0],
            _ => self.eyes(),
        }
    }

    /// The picture that shows those of [`Self::eyes`], all of one size, labelled in `labels` where that tells them apart.
    #[must_use]
    pub fn composed(self, mut eyes: Vec<Picture>, labels: Option<Ink>) -> Picture {
        match (self, eyes.as_slice()) {
            (Self::SideBySide | Self::CrossEyed, [first, _]) => {
                let sheet = Sheet::new(self, first.size, labels.is_some());
                sheet.composed(&eyes, labels.unwrap_or(Ink::beside(false)))
            }
            (Self::Anaglyph, [left, right]) => blended(left, right, anaglyph),
            (Self::Overlay, [left, right]) => blended(left, right, overlay),
            _ => eyes.swap_remove(0),
        }
    }
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
    let [left_colour, right_colour] = eye_colours::ON_DARK;
    let part = |i: usize| left * linear(left_colour[i]) + right * linear(right_colour[i]);
    encoded(hue_preserving_clip([part(0), part(1), part(2)]))
}

fn largest([r, g, b, _]: [u8; 4]) -> u8 {
    r.max(g).max(b)
}
