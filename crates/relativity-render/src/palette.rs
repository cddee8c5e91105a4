//! The colour table the shaders read: linear sRGB over the logarithm of the wavelength.

use crate::colour::linear_srgb;
use crate::view::Colour;
use relativity_core::math;

/// Entries of the table.
pub const ENTRIES: u32 = 1024;

/// The wavelengths the table of `colour` covers, nm; outside, its ends hold.
fn range_nm(colour: Colour) -> [f64; 2] {
    match colour {
        Colour::Visible => [340.0, 860.0],
        Colour::False => [1.0, 1e6],
    }
}

/// log2 of the first wavelength, and entries per octave.
pub fn scale(colour: Colour) -> [f64; 2] {
    let [first, last] = range_nm(colour).map(math::log2);
    [first, f64::from(ENTRIES - 1) / (last - first)]
}

/// The table: RGBA, one row.
pub fn table(colour: Colour) -> Vec<[f32; 4]> {
    let [first, per_octave] = scale(colour);
    let entry = |i: u32| {
        let [r, g, b] = linear_srgb(math::exp2(first + f64::from(i) / per_octave), colour);
        [r as f32, g as f32, b as f32, 1.0]
    };
    (0..ENTRIES).map(entry).collect()
}
