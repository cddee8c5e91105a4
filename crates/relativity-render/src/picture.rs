//! A finished picture: sRGB-encoded pixels.

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
