//! The hatch: light that eyes do not see, drawn dimly, with fine lines.
//!
//! Hardly a colour is left to tell it by, so it cannot be taken for light that is seen, by whatever eyes:
//! infrared is a dim warm grey with lines that rise to the right at 45 degrees, ultraviolet a neutral one
//! with lines that fall at 135 degrees. They stand still in the picture, and only the body's own shade lies
//! over them. `shaders/colour.wgsl` has the same, with the numbers of [`Hatch::packed`].
//!
//! A share of such light is a number from -1 to 1: above 0 of infrared, below 0 of ultraviolet, 0 where all
//! is seen.

use std::f64::consts::FRAC_1_SQRT_2;

/// Distance between lines, as a share of the shorter side of a picture, and the least in px, which keeps
/// lines visibly apart.
const PERIOD: f64 = 1.0 / 80.0;
const LEAST_PERIOD_PX: f64 = 5.0;
/// Width of a line over the period.
const LINE_SHARE: f64 = 0.25;
/// Linear grey between the lines and on them: in a dark window lighter than a street at dusk, in a light one
/// darker than it.
const DARK: [f64; 2] = [0.14, 0.30];
const LIGHT: [f64; 2] = [0.020, 0.090];
/// Between the lines infrared has so much of red, green and blue, which leaves the luminance as it is.
const WARM: [f64; 3] = [1.3, 0.94, 0.72];

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

    /// Returns linear sRGB of light with this `unseen` share in the pixel around `place`, px from the top
    /// left.
    ///
    /// It is that of the pixel's middle, smoothed over its width: all samples of a pixel have the same.
    pub fn colour(&self, unseen: f64, place: [f64; 2]) -> [f64; 3] {
        if unseen == 0.0 {
            return [0.0; 3];
        }
        let [u, v] = place.map(|px| px.floor() + 0.5);
        let periods = (u + v.copysign(unseen)) * FRAC_1_SQRT_2 / self.period;
        let from_line = (periods - periods.floor() - 0.5).abs() * self.period;
        let cover = (self.half_width - from_line + 0.5).clamp(0.0, 1.0);
        let tone = if unseen > 0.0 { WARM } else { [1.0; 3] };
        tone.map(|part| unseen.abs() * (self.grey[0] * part + self.grey[1] * cover))
    }

    /// The numbers that shaders need of it: the period, px, its reciprocal times cos 45 degrees, half the
    /// width of a line, px, and the grey that is added on lines; and the colour between the lines of
    /// infrared, and the grey between those of ultraviolet.
    pub fn packed(&self) -> [[f32; 4]; 2] {
        let per_px = FRAC_1_SQRT_2 / self.period;
        let [between, more] = self.grey;
        let [red, green, blue] = WARM.map(|part| part * between);
        [[self.period, per_px, self.half_width, more], [red, green, blue, between]]
            .map(|numbers| numbers.map(|number| number as f32))
    }
}
