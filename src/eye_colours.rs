//! Colours of the eyes: left is blue and right is orange wherever colour distinguishes them, a pair that
//! stays distinct for colour-blind eyes, from M. Okabe and K. Ito, *Color universal design* (2008).

/// The colours of the left and the right eye on a dark background, sRGB-encoded.
pub const ON_DARK: [[u8; 3]; 2] = [[0x56, 0xB4, 0xE9], [0xE6, 0x9F, 0x00]];
/// The colours of the left and the right eye on a light background, dark enough for text.
pub const ON_LIGHT: [[u8; 3]; 2] = [[0x00, 0x6B, 0xA8], [0xB0, 0x4A, 0x00]];
