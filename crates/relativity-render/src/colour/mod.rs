//! The colour of monochromatic light: linear sRGB of a wavelength.
//!
//! # A choice, and its name: spectral hue at equal brightness
//!
//! Monochromatic light lies outside sRGB. It moves towards neutral at its hue (in IPT, see `ipt.rs`), until a
//! screen can show it, and its largest component is 1. So the wavelength decides the hue alone, while
//! brightness comes from D^n and the exposure: through the luminous efficiency 700 nm would be all but black
//! beside 550 nm, and the paper's red cyclist with it. Towards the ends of the visible range the colour
//! fades, to exactly black at `VISIBLE_NM`. From one nanometre to the next no component changes by more than
//! 10 of 255 levels (`tests/reference_colour.rs`), so that no seam shows where none is in the light.
//!
//! References: CIE 015:2018, *Colorimetry*; CIE 018:2019 (the table, its source and licence:
//! `assets/README.md`); IEC 61966-2-1:1999 (sRGB).

pub(crate) mod ipt;
pub mod paint;
pub mod planck;
pub mod spectra;
pub mod spectrum;
pub mod sunlit;

use std::array::from_fn;
use std::sync::LazyLock;

use relativity_core::math::{atan, log2, powf};

use spectrum::VISIBLE_NM;

/// Visible light fades in from black at the first of these to full at the second, nm, smoothly as a screen
/// shows it.
const VIOLET_END_NM: [f64; 2] = [VISIBLE_NM[0], 420.0];
/// Visible light fades from full at the first of these to black at the second, nm. The paper's 700 nm
/// is full red.
const RED_END_NM: [f64; 2] = [710.0, VISIBLE_NM[1]];
/// Between these a smaller and smaller share of a glow is shown as infrared, K.
const UNSEEN_GLOW_KELVIN: [f64; 2] = [1000.0, 3500.0];
/// Doppler factors between which a smaller and smaller share of daylight is shown as infrared.
const UNSEEN_DAYLIGHT: [f64; 2] = [0.4, 0.6];
/// False colours for D far below 1, at 1 and far above, linear sRGB.
const FALSE_COLOURS: [[f64; 3]; 3] = [[0.60, 0.03, 0.01], [0.72, 0.72, 0.68], [0.02, 0.10, 0.80]];

const CIE_1931_CSV: &str = include_str!("../../assets/cie-1931-2deg.csv");
/// Wavelength of the table's first row, nm; a row follows every nm.
const FIRST_NM: f64 = 360.0;

static CIE_1931: LazyLock<Vec<[f64; 3]>> = LazyLock::new(|| CIE_1931_CSV.lines().skip(1).map(row).collect());

fn row(line: &str) -> [f64; 3] {
    let mut values = line.split(',').skip(1).map(|value| value.parse().expect("the table holds numbers"));
    std::array::from_fn(|_| values.next().expect("a row holds three functions"))
}

/// Colours at full brightness per nm, of which the nearest is taken.
const HUES_PER_NM: u32 = 16;
/// The colours of the table's wavelengths at full brightness.
static HUES: LazyLock<Vec<[f64; 3]>> = LazyLock::new(|| {
    let steps = (CIE_1931.len() as u32 - 1) * HUES_PER_NM;
    let nm = |step| FIRST_NM + f64::from(step) / f64::from(HUES_PER_NM);
    (0..=steps).filter_map(|step| Some(ipt::in_gamut(colour_matching(nm(step))?))).collect()
});

/// The CIE 1931 colour-matching functions (x, y, z) at `wavelength_nm`, linear between the table's
/// rows; `None` outside 360 nm to 830 nm.
#[must_use]
pub fn colour_matching(wavelength_nm: f64) -> Option<[f64; 3]> {
    let position = wavelength_nm - FIRST_NM;
    let last = CIE_1931.len() - 1;
    if !(0.0..=last as f64).contains(&position) {
        return None;
    }
    let index = (position as usize).min(last - 1);
    Some(mix(CIE_1931[index], CIE_1931[index + 1], position - index as f64))
}

/// Linear sRGB (each component in [0, 1]) of light of `wavelength_nm` (above 0), as bright as can be; black
/// outside 380 nm to 780 nm.
#[must_use]
pub fn linear_srgb(wavelength_nm: f64) -> [f64; 3] {
    let brightness = srgb_decoded(visibility(wavelength_nm));
    spectral_hue(wavelength_nm).map(|part| part * brightness)
}

/// Returns the share of light of `wavelength_nm` that eyes do not see, with the sign of `light/hatch.rs`: 1
/// above [`VISIBLE_NM`] (infrared), -1 below (ultraviolet); none from 420 nm to 710 nm.
#[must_use]
pub fn unseen_line(wavelength_nm: f64) -> f64 {
    let is_long = wavelength_nm > 0.5 * (VIOLET_END_NM[1] + RED_END_NM[0]);
    let share = 1.0 - visibility(wavelength_nm);
    if is_long { share } else { -share }
}

/// Returns the share of the light of a body that glows at 2^`log2_kelvin` that eyes do not see, with the sign
/// of `light/hatch.rs`: 1 (infrared) up to 1000 K, 0 from 3500 K.
#[must_use]
pub fn unseen_glow(log2_kelvin: f64) -> f64 {
    1.0 - smoothstep(UNSEEN_GLOW_KELVIN.map(log2), log2_kelvin)
}

/// Returns the share of daylight received 2^`octaves` times as fast that eyes do not see, with the sign of
/// `light/hatch.rs`: 1 (infrared) up to D = 0.4, 0 from 0.6. Sunlight ends at 300 nm.
#[must_use]
pub fn unseen_daylight(octaves: f64) -> f64 {
    1.0 - smoothstep(UNSEEN_DAYLIGHT.map(log2), octaves)
}

/// The false colour of light shifted by `octaves` (log2 D), linear sRGB: grey at D = 1, bluer above, redder
/// below, and the more so the farther.
#[must_use]
pub fn false_colour(octaves: f64) -> [f64; 3] {
    let [low, middle, high] = FALSE_COLOURS;
    let end = if octaves < 0.0 { low } else { high };
    mix(middle, end, atan(1.2 * octaves.abs()) / std::f64::consts::FRAC_PI_2)
}

/// The sRGB-encoded value of a linear one, both in [0, 1].
#[must_use]
pub fn srgb_encoded(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * powf(linear, 1.0 / 2.4) - 0.055 }
}

/// Returns the byte, 0 to 255, of a linear value in sRGB: the one nearest to its encoding.
#[must_use]
pub fn srgb_level(linear: f64) -> u8 {
    LEAST.partition_point(|least| *least <= linear) as u8
}

/// The least linear value of each level above 0.
pub(crate) static LEAST: LazyLock<[f64; 255]> =
    LazyLock::new(|| from_fn(|below| srgb_decoded((below as f64 + 0.5) / 255.0)));

/// The linear value of an sRGB-encoded one, both in [0, 1].
#[must_use]
pub fn srgb_decoded(encoded: f64) -> f64 {
    if encoded <= 0.040_45 { encoded / 12.92 } else { powf((encoded + 0.055) / 1.055, 2.4) }
}

/// `linear` (components 0 or more) brought into [0, 1] by scaling all components alike, which keeps
/// the hue.
#[must_use]
pub fn hue_preserving_clip(linear: [f64; 3]) -> [f64; 3] {
    let largest = linear.into_iter().fold(1.0, f64::max);
    linear.map(|part| part / largest)
}

/// Relative luminance Y of a linear sRGB colour.
#[must_use]
pub fn luminance([red, green, blue]: [f64; 3]) -> f64 {
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

/// Between the colours `a` (at `t` = 0) and `b` (at `t` = 1).
pub(crate) fn mix<const N: usize>(a: [f64; N], b: [f64; N], t: f64) -> [f64; N] {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * t)
}

/// The hue of a wavelength at full brightness; black where the table ends.
fn spectral_hue(wavelength_nm: f64) -> [f64; 3] {
    let place = ((wavelength_nm - FIRST_NM) * f64::from(HUES_PER_NM)).round();
    if place < 0.0 { [0.0; 3] } else { HUES.get(place as usize).copied().unwrap_or_default() }
}

/// Share of the full colour left at the ends of the visible range, as a screen's levels go, 0 to 1.
fn visibility(wavelength_nm: f64) -> f64 {
    smoothstep(VIOLET_END_NM, wavelength_nm) * (1.0 - smoothstep(RED_END_NM, wavelength_nm))
}

fn smoothstep([start, end]: [f64; 2], x: f64) -> f64 {
    let t = ((x - start) / (end - start)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
