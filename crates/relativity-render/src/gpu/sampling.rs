//! Samples of the pixels of a picture.

use crate::view::effects::Constant;

/// The way in which a device draws the four samples of each pixel of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sampling {
    /// Samples that the hardware keeps of a pixel.
    pub of_hardware: u32,
    /// Samples beside each other that are drawn as pixels of their own, in place of one.
    pub across: u32,
}

impl Sampling {
    /// The shaders choose the samples of a pixel.
    pub const CHOSEN: Self = Self { of_hardware: 4, across: 1 };
    /// Each sample is a pixel of a picture of twice the size.
    pub const AS_PIXELS: Self = Self { of_hardware: 1, across: 2 };
    /// Each pixel has one sample, in its middle: numbers are not averaged.
    pub const MIDDLE: Self = Self { of_hardware: 1, across: 1 };

    /// Returns `constants` of shaders with the one that is this.
    pub fn among(self, mut constants: Vec<Constant>) -> Vec<Constant> {
        constants.push(("ACROSS", self.across.into()));
        constants
    }
}
