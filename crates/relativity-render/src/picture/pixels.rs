//! A finished picture, which is sRGB-encoded pixels, and the places in a pixel that are sampled.

use crate::colour::srgb_level;

/// A picture of 8 bits per component, row by row from the top left.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Picture {
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Red, green, blue (sRGB-encoded) and opacity, always 255.
    pub rgba: Vec<[u8; 4]>,
}

/// The opaque pixel of a linear sRGB colour with components in [0, 1].
#[must_use]
pub fn encoded(linear: [f64; 3]) -> [u8; 4] {
    let [r, g, b] = linear.map(srgb_level);
    [r, g, b, u8::MAX]
}

/// The centres of `samples` times `samples` equal parts of a pixel.
pub(crate) fn sample_grid([u, v]: [u32; 2], samples: u32) -> impl Iterator<Item = [f64; 2]> {
    let place = move |pixel, part| f64::from(pixel) + (f64::from(part) + 0.5) / f64::from(samples);
    (0..samples).flat_map(move |j| (0..samples).map(move |i| [place(u, i), place(v, j)]))
}
