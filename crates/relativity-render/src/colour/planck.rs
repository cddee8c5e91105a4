//! The colour and the luminance of what glows, by Planck's law.
//!
//! Sums over the visible part of the CIE table, in steps of 1 nm, made once in f64 and looked up over a
//! logarithm. References: M. Planck, *Ann. Phys.* 309, 553 (1901); CIE 015:2018.

use std::sync::LazyLock;

use relativity_core::math::{exp, exp_m1, exp2, ln, log2};

use super::ipt;
use super::spectrum::VISIBLE_NM;
use super::{colour_matching, luminance, mix};

/// hc/k, nm K: the second radiation constant (CODATA 2018, exact).
const SECOND_RADIATION_NM_K: f64 = 1.438_776_877e7;
/// Wavelengths of the sums, nm: those that eyes see.
const SUMMED_NM: std::ops::RangeInclusive<u32> = VISIBLE_NM[0] as u32..=VISIBLE_NM[1] as u32;
/// Entries of a table per octave.
const PER_OCTAVE: f64 = 64.0;
/// log2 of the temperatures of the table, K: from 16 K to 17 million.
const LOG2_KELVIN: [f64; 2] = [4.0, 24.0];

/// Light of a broad spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Broad {
    /// Linear sRGB, the largest component 1. Where a screen cannot show it, the purest colour shown of its
    /// hue.
    pub hue: [f64; 3],
    /// log2 of the largest component, in units in which the luminance of a spectrum is a plain sum over nm.
    pub log2_level: f64,
}

impl Broad {
    /// Returns the stimulus of a spectrum whose natural logarithm at a wavelength (nm) is `ln_power`: summed
    /// relative to the largest, so that nothing overflows or is lost.
    fn new(ln_power: impl Fn(f64) -> f64) -> Self {
        let powers = || SUMMED_NM.map(f64::from).map(|nm| (nm, ln_power(nm)));
        let largest = powers().map(|(_, power)| power).fold(f64::NEG_INFINITY, f64::max);
        let xyz = powers().fold([0.0; 3], |sum: [f64; 3], (nm, power)| {
            let matching = colour_matching(nm).expect("inside the table");
            let share = exp(power - largest);
            std::array::from_fn(|i| sum[i] + share * matching[i])
        });
        let hue = ipt::in_gamut(xyz);
        Self { hue, log2_level: log2(xyz[1] / luminance(hue)) + largest / std::f64::consts::LN_2 }
    }

    fn between(self, next: Self, t: f64) -> Self {
        let hue = mix(self.hue, next.hue, t);
        Self { hue, log2_level: self.log2_level + (next.log2_level - self.log2_level) * t }
    }
}

/// A black body at the temperature 2^`log2_kelvin`.
///
/// # Accuracy
///
/// `tests/reference_planck.rs`: from 250 K to a million the luminance is within 0.2 % of the sum. Below 16 K
/// it goes on by Wien's law at the red end of what eyes see, above 17 million K by Rayleigh's and Jeans's.
#[must_use]
pub fn black_body(log2_kelvin: f64) -> Broad {
    static TABLE: LazyLock<Vec<Broad>> = LazyLock::new(|| table(LOG2_KELVIN, glowing));
    let [first, last] = LOG2_KELVIN;
    let inside = looked_up(&TABLE, first, log2_kelvin);
    // Wien: ln L falls by hc/(k lambda) times the change of 1/T. Rayleigh and Jeans: L rises as T.
    let colder = (exp2(-first) - exp2(-log2_kelvin.min(first))) * SECOND_RADIATION_NM_K
        / f64::from(*SUMMED_NM.end())
        / std::f64::consts::LN_2;
    let hotter = (log2_kelvin - last).max(0.0);
    Broad { log2_level: inside.log2_level + colder.max(-1e9) + hotter, ..inside }
}

/// The radiance per wavelength of a black body at `nm`, in units of 2hc²/nm⁵.
#[must_use]
pub fn radiance(nm: f64, kelvin: f64) -> f64 {
    exp(ln_radiance(nm, kelvin))
}

fn ln_radiance(nm: f64, kelvin: f64) -> f64 {
    let x = SECOND_RADIATION_NM_K / (nm * kelvin);
    // ln(nm^-5/(e^x - 1)), where e^x would overflow as well as where it is near 1.
    let ln_denominator = if x > 30.0 { x } else { ln(exp_m1(x)) };
    -5.0 * ln(nm) - ln_denominator
}

fn glowing(log2_kelvin: f64) -> Broad {
    let kelvin = exp2(log2_kelvin);
    Broad::new(|nm| ln_radiance(nm, kelvin))
}

fn table([first, last]: [f64; 2], value: impl Fn(f64) -> Broad) -> Vec<Broad> {
    let steps = ((last - first) * PER_OCTAVE) as u32;
    (0..=steps).map(|i| value(first + f64::from(i) / PER_OCTAVE)).collect()
}

fn looked_up(table: &[Broad], first: f64, place: f64) -> Broad {
    let last = table.len() - 1;
    let place = ((place - first) * PER_OCTAVE).clamp(0.0, last as f64);
    let below = (place as usize).min(last - 1);
    table[below].between(table[below + 1], place - below as f64)
}
