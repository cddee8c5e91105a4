//! The hatch: light that eyes do not see, drawn in neutral grey with fine lines.
//!
//! No colour is left to tell it by, so it cannot be taken for light that is seen, by whatever eyes: lines
//! rise to the right at 45 degrees for infrared and fall at 135 degrees for ultraviolet. They stand still in
//! the picture, and only the body's own shade lies over them. `shaders/colour.wgsl` has the same, with the
//! numbers of [`Hatch::packed`].
//!
//! A share of such light is a number from -1 to 1: above 0 of infrared, below 0 of ultraviolet, 0 where all
//! is seen.

use std::f64::consts::FRAC_1_SQRT_2;

/// Distance between lines, as a share of the shorter side of a picture, and the least in px, which keeps
/// lines visibly apart.
const PERIOD: f64 = 1.0 / 80.0;
const LEAST_PERIOD_PX: f64 = 5.0;
/// Width of a line over the period.
const LINE_SHARE: f64 = 0.4;
/// Linear grey between the lines and on them: in a dark window lighter than a street at dusk, in a light one
/// darker than it.
const DARK: [f64; 2] = [0.15, 0.45];
const LIGHT: [f64; 2] = [0.012, 0.16];

/// The hatch of one picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hatch {
    /// From one line to the next, px.
    period: f64,
    /// Half the width of a line, px.
    half_width: f64,
    /// Linear grey between the lines, and how much is added on them.
    grey: [f64; 2],
}

impl Hatch {
    /// Returns that of a picture of `size`, pixels, for a light window or a dark one.
    pub fn new(size: [u32; 2], light: bool) -> Self {
        let period = (PERIOD * f64::from(size[0].min(size[1]))).max(LEAST_PERIOD_PX);
        let [between, on_line] = if light { LIGHT } else { DARK };
        Self { period, half_width: 0.5 * LINE_SHARE * period, grey: [between, on_line - between] }
    }

    /// Returns the linear grey of light with this `unseen` share in the pixel around `place`, px from the top
    /// left.
    ///
    /// The grey is that of the pixel's middle, smoothed over its width: all samples of a pixel have the same.
    pub fn grey(&self, unseen: f64, place: [f64; 2]) -> f64 {
        if unseen == 0.0 {
            return 0.0;
        }
        let [u, v] = place.map(|px| px.floor() + 0.5);
        let periods = (u + v.copysign(unseen)) * FRAC_1_SQRT_2 / self.period;
        let from_line = (periods - periods.floor() - 0.5).abs() * self.period;
        let cover = (self.half_width - from_line + 0.5).clamp(0.0, 1.0);
        unseen.abs() * (self.grey[0] + self.grey[1] * cover)
    }

    /// The numbers that shaders need of it: the period, px, its reciprocal times cos 45 degrees, half the
    /// width of a line, px, and 0; and the grey between the lines, what is added on them, 0 and 0.
    pub fn packed(&self) -> [[f32; 4]; 2] {
        let per_px = FRAC_1_SQRT_2 / self.period;
        [[self.period, per_px, self.half_width, 0.0], [self.grey[0], self.grey[1], 0.0, 0.0]]
            .map(|numbers| numbers.map(|number| number as f32))
    }
}
