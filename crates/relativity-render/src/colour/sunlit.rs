//! The colours of paint in daylight, over the Doppler factor with which it is received.
//!
//! Light of the Doppler factor D (received over emitted frequency) has the radiance `D^5 L(lambda D)` per
//! wavelength. Paint of the reflectance R in daylight E sends `R E / pi`, so its tristimulus values are those
//! of `D^5 E(lambda D) R(lambda D)`. They are balanced to D65 for white paint at rest (Bradford), once for
//! all D. Here they stand beside the *level* of white paint at the same D, its brightest primary, or 1/8192
//! of that at rest where sunlight has all but ended: so colours are contrasts with white, and the level is
//! how bright light has become.
//!
//! # The sky
//!
//! The sky shines with a spectrum of its own: daylight less what comes from the sun. As much of it as there
//! is in a colour of the backdrop ([`share_of_sky`]) counts as that light, the rest, the white of haze, as
//! smooth paint: so the sky's light stands here as what it has beside smooth paint of its colour,
//! [`sky_beside_paint`].
//!
//! # Paint in light that is shifted otherwise
//!
//! What moves through the street's daylight reflects what it receives with a Doppler factor of its own. There
//! the paint's reflectance, shifted by the way to the eye, is taken for that of smooth paint, which has its
//! colour in unshifted daylight: [`in_daylight`]. What is left of its colour where both ways are one is added
//! as white's light is: so it is exact for white and grey paint, and for what rests on the street.
//!
//! # Accuracy
//!
//! `tests/sunlight.rs`: colours are within 1 of 255 levels of sums over other wavelengths.

use std::array::from_fn;
use std::f64::consts::LN_2;
use std::sync::LazyLock;

use glam::DMat3;
use relativity_core::math::{exp2, log2};

use super::paint::{Material, Paint};
use super::spectra::{daylight, reflectance, skylight};
use super::spectrum::VISIBLE_NM;
use super::{colour_matching, ipt, luminance};

/// Entries of a row.
pub const ENTRIES: usize = 2048;
/// Entries per octave of the Doppler factor.
pub const PER_OCTAVE: f64 = 256.0;
/// log2 of the Doppler factor of the first entry: 0.35, where white is dark.
pub const FIRST_OCTAVE: f64 = -1.5;
/// The entry of light at rest.
const AT_REST: usize = 384;
/// Rows of colours: of red, green and blue smooth paint, of white, and of the measured materials.
pub const PAINTS: usize = 4 + Material::COUNT;
/// The row of white paint.
pub const WHITE: usize = 3;
/// Linear sRGB of the sky's light at rest, over its brightest component. A number, as a street at rest needs
/// no table.
const SKY: [f64; 3] = [0.556, 0.668, 1.0];
/// log2 of the least level, beside that at rest: 13 stops are what a good camera has in one picture. Where
/// daylight is fainter, white is dark beside it.
const LEAST_LEVEL: f64 = -13.0;
/// Samples of a spectrum in each cell of wavelengths.
const SAMPLES: u32 = 8;
/// The Bradford transform: to responses of cones that adapt on their own.
const BRADFORD: [[f64; 3]; 3] =
    [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]];
/// Its inverse.
const FROM_BRADFORD: [[f64; 3]; 3] = [
    [0.986_992_9, -0.147_054_3, 0.159_962_7],
    [0.432_305_3, 0.518_360_3, 0.049_291_2],
    [-0.008_528_7, 0.040_042_8, 0.968_486_7],
];
/// CIE XYZ of the white of sRGB, D65.
const D65: [f64; 3] = [0.950_47, 1.0, 1.088_83];

static TABLE: LazyLock<SunlitTable> = LazyLock::new(SunlitTable::new);

/// Colours of paints over log2 D.
struct SunlitTable {
    /// log2 of white's level, beside that at rest.
    levels: Vec<f64>,
    /// Linear sRGB over white's level, which may lie outside what a screen shows.
    colours: Vec<Vec<[f64; 3]>>,
    /// Linear sRGB, in daylight at rest, of the reflectances as they are shifted.
    in_daylight: Vec<Vec<[f64; 3]>>,
    /// Linear sRGB over white's level, in shifted daylight, of red, green and blue smooth paint at rest.
    lights: Vec<Vec<[f64; 3]>>,
    /// Linear sRGB over white's level of the sky's light, less that of smooth paint of its colour at rest.
    sky: Vec<[f64; 3]>,
}

/// Spectra in cells of the logarithm of the wavelength, as wide as an entry of the table.
struct Cells {
    /// Colour-matching functions times the width of a cell, of those that eyes see.
    matching: Vec<[f64; 3]>,
    /// Daylight from the shortest wavelength that is seen at the first entry to the longest at the last.
    daylight: Vec<f64>,
    /// The sky's part of that.
    skylight: Vec<f64>,
}

impl Cells {
    fn nm(cell: f64) -> f64 {
        VISIBLE_NM[0] * exp2(cell / PER_OCTAVE)
    }

    /// Averages a spectrum over the cells around those with which the first entry begins.
    fn averaged(count: usize, first: f64, spectrum: impl Fn(f64) -> f64) -> Vec<f64> {
        let samples = || (0..SAMPLES).map(|sample| (f64::from(sample) + 0.5) / f64::from(SAMPLES) - 0.5);
        let mean = |cell: f64| samples().map(|off| spectrum(Self::nm(cell + off))).sum::<f64>();
        (0..count).map(|cell| mean(cell as f64 + first) / f64::from(SAMPLES)).collect()
    }

    fn new() -> Self {
        let seen = (log2(VISIBLE_NM[1] / VISIBLE_NM[0]) * PER_OCTAVE) as usize + 1;
        let weight = |nm: f64, part: usize| colour_matching(nm).map_or(0.0, |of| of[part]) * nm;
        let width = LN_2 / PER_OCTAVE;
        let [x, y, z] = [0, 1, 2].map(|part| Self::averaged(seen, 0.0, |nm| weight(nm, part) * width));
        let [daylight, skylight] =
            [daylight, skylight].map(|light| Self::averaged(seen + ENTRIES, -(AT_REST as f64), light));
        Self { matching: (0..seen).map(|cell| [x[cell], y[cell], z[cell]]).collect(), daylight, skylight }
    }

    /// CIE XYZ of `light`, as far as eyes see it: its first cell is the shortest wavelength that they do.
    fn stimulus(&self, light: impl Iterator<Item = f64>) -> [f64; 3] {
        self.matching
            .iter()
            .zip(light)
            .fold([0.0; 3], |sum, (matching, power)| from_fn(|part| sum[part] + matching[part] * power))
    }
}

impl SunlitTable {
    fn new() -> Self {
        let cells = Cells::new();
        let count = cells.daylight.len();
        let light = |entry: usize| &cells.daylight[entry..];
        let power = |entry: usize| exp2(5.0 * octaves_at(entry));
        let white_at_rest = cells.stimulus(light(AT_REST).iter().copied());
        let linear = |xyz: [f64; 3]| balanced(xyz, white_at_rest);
        let whites: Vec<_> = (0..ENTRIES)
            .map(|entry| {
                let linear = linear(cells.stimulus(light(entry).iter().copied()));
                let largest = on_screen(linear).into_iter().fold(0.0, f64::max);
                largest.max(exp2(LEAST_LEVEL) / power(entry))
            })
            .collect();
        let mut reflectances: Vec<_> = paints()
            .map(|paint| Cells::averaged(count, -(AT_REST as f64), |nm| reflectance(paint, nm)))
            .collect();
        let seen = |reflectance: &[f64], [lit, paint]: [usize; 2]| {
            let of_cell = light(lit).iter().zip(&reflectance[paint..]).map(|(e, r)| e * r);
            linear(cells.stimulus(of_cell))
        };
        make_exact(&mut reflectances, |reflectance| seen(reflectance, [AT_REST; 2]));
        let rows = |count: usize, places: fn(usize) -> [usize; 2], is_beside_white: bool| {
            let row = |reflectance: &Vec<f64>| {
                let over = |entry: usize| if is_beside_white { whites[entry] } else { 1.0 };
                let colour = |entry| seen(reflectance, places(entry)).map(|part| part / over(entry));
                (0..ENTRIES).map(colour).collect()
            };
            reflectances[..count].iter().map(row).collect()
        };
        let colours: Vec<Vec<[f64; 3]>> = rows(PAINTS, |entry| [entry; 2], true);
        let skies: Vec<_> = (0..ENTRIES)
            .map(|entry| linear(cells.stimulus(cells.skylight[entry..].iter().copied())))
            .collect();
        let brightest = skies[AT_REST].into_iter().fold(0.0, f64::max);
        let beside_paint = |entry: usize| {
            let paint = mixed(skies[AT_REST], from_fn(|primary| colours[primary][entry]));
            from_fn(|part| (skies[entry][part] / whites[entry] - paint[part]) / brightest)
        };
        Self {
            sky: (0..ENTRIES).map(beside_paint).collect(),
            colours,
            in_daylight: rows(PAINTS, |entry| [AT_REST, entry], false),
            lights: rows(WHITE, |entry| [entry, AT_REST], true),
            levels: whites.iter().enumerate().map(|(entry, white)| log2(white * power(entry))).collect(),
        }
    }
}

/// Mixes the first three reflectances so that they are `seen` as red, green and blue: those of the data are,
/// but for rounding.
fn make_exact(reflectances: &mut [Vec<f64>], seen: impl Fn(&[f64]) -> [f64; 3]) {
    let columns = from_fn(|primary| seen(&reflectances[primary]));
    let shares = DMat3::from_cols_array_2d(&columns).inverse().to_cols_array_2d();
    for cell in 0..reflectances[0].len() {
        let data = from_fn(|primary| [reflectances[primary][cell]; 3]);
        for (reflectance, shares) in reflectances.iter_mut().zip(shares) {
            reflectance[cell] = mixed(shares, data)[0];
        }
    }
}

/// Paints in the order of their rows.
fn paints() -> impl Iterator<Item = Paint> {
    let smooth = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0; 3]].map(Paint::Smooth);
    smooth.into_iter().chain(Material::ALL.map(Paint::Measured))
}

/// Returns the row of a measured material.
#[must_use]
pub const fn row_of(material: Material) -> usize {
    WHITE + 1 + material.number()
}

fn octaves_at(entry: usize) -> f64 {
    FIRST_OCTAVE + entry as f64 / PER_OCTAVE
}

/// Linear sRGB of CIE XYZ, for eyes that adapt to this `white`.
fn balanced(xyz: [f64; 3], white: [f64; 3]) -> [f64; 3] {
    let cones = |xyz: [f64; 3]| BRADFORD.map(|row| ipt::dot(row, xyz));
    let [found, of_white, of_screen] = [xyz, white, D65].map(cones);
    let adapted: [f64; 3] = from_fn(|cone| found[cone] / of_white[cone] * of_screen[cone]);
    let [found, white] =
        [adapted, of_screen].map(|cones| ipt::srgb_from_xyz(FROM_BRADFORD.map(|row| ipt::dot(row, cones))));
    // The matrices are rounded: so that white is white, to the last digit.
    from_fn(|part| found[part] / white[part])
}

/// Returns `linear` sRGB as a screen can show it: where a component is below 0 the colour moves towards grey
/// of the same luminance until none is.
#[must_use]
pub fn on_screen(linear: [f64; 3]) -> [f64; 3] {
    let least = linear.into_iter().fold(0.0, f64::min);
    if least == 0.0 {
        return linear;
    }
    let grey = luminance(linear).max(0.0);
    let share = grey / (grey - least);
    linear.map(|part| (grey + (part - grey) * share).max(0.0))
}

fn between<T, const N: usize>(row: &[T], octaves: f64, part: impl Fn(&T) -> [f64; N]) -> [f64; N] {
    let place = ((octaves - FIRST_OCTAVE) * PER_OCTAVE).clamp(0.0, (ENTRIES - 1) as f64);
    let below = (place as usize).min(ENTRIES - 2);
    let ([low, high], share) = ([below, below + 1].map(|entry| part(&row[entry])), place - below as f64);
    from_fn(|i| low[i] + (high[i] - low[i]) * share)
}

/// log2 of the level of white paint in daylight that is received 2^`octaves` times as fast, beside that at
/// rest. Above the table it rises as `octaves`, below it stays, all but black.
#[must_use]
pub fn log2_level(octaves: f64) -> f64 {
    let [level] = between(&TABLE.levels, octaves, |level| [*level]);
    level + (octaves - octaves_at(ENTRIES - 1)).max(0.0)
}

/// Linear sRGB of `paint` in daylight that is received 2^`octaves` times as fast, over the level of white
/// paint; components may be negative.
#[must_use]
pub fn colour(paint: Paint, octaves: f64) -> [f64; 3] {
    of_rows(&TABLE.colours, paint, octaves)
}

/// Linear sRGB, in daylight at rest, of the smooth paint that stands for `paint` whose reflectance is shifted
/// by `octaves`.
#[must_use]
pub fn in_daylight(paint: Paint, octaves: f64) -> [f64; 3] {
    of_rows(&TABLE.in_daylight, paint, octaves)
}

/// Linear sRGB of smooth paint with these `shares` of red, green and blue, in daylight that it receives
/// shifted by `octaves`, over the level of white paint.
#[must_use]
pub fn lit_by_shifted(shares: [f64; 3], octaves: f64) -> [f64; 3] {
    mixed(shares, from_fn(|primary| between(&TABLE.lights[primary], octaves, |entry| *entry)))
}

/// Returns how much of the sky's light, over its brightest component at rest, is taken to be in a colour at
/// rest (linear sRGB): as much as makes what is left, the white of haze, no bluer than red, and no component
/// of it less than 0.
#[must_use]
pub fn share_of_sky(colour: [f64; 3]) -> f64 {
    let most = colour.into_iter().zip(SKY).map(|(of, sky)| of / sky).fold(f64::INFINITY, f64::min);
    let [[red, _, blue], [red_of_sky, _, blue_of_sky]] = [colour, SKY];
    ((blue - red) / (blue_of_sky - red_of_sky)).max(0.0).min(most)
}

/// Linear sRGB of the sky's light, over its brightest component at rest, that is received 2^`octaves` times
/// as fast, less that of smooth paint of its colour at rest; over the level of white paint.
#[must_use]
pub fn sky_beside_paint(octaves: f64) -> [f64; 3] {
    between(&TABLE.sky, octaves, |entry| *entry)
}

fn of_rows(rows: &[Vec<[f64; 3]>], paint: Paint, octaves: f64) -> [f64; 3] {
    let at = |row: usize| between(&rows[row], octaves, |entry| *entry);
    match paint {
        Paint::Measured(material) => at(row_of(material)),
        Paint::Smooth(paint) => mixed(paint, [at(0), at(1), at(2)]),
    }
}

/// Returns the sum of the colours of red, green and blue paint with these shares.
pub(crate) fn mixed(shares: [f64; 3], [red, green, blue]: [[f64; 3]; 3]) -> [f64; 3] {
    from_fn(|part| shares[0] * red[part] + shares[1] * green[part] + shares[2] * blue[part])
}

/// Returns the entries of all rows for the shaders: colours with log2 of the level; those in daylight; and
/// the colours in shifted light of red, green and blue paint, with log2 of the level.
pub(crate) fn rows() -> impl Iterator<Item = [f64; 4]> {
    let with = |row: &'static Vec<[f64; 3]>, levels: Option<&'static Vec<f64>>| {
        row.iter().enumerate().map(move |(entry, [red, green, blue])| {
            [*red, *green, *blue, levels.map_or(0.0, |levels| levels[entry])]
        })
    };
    let colours = TABLE.colours.iter().flat_map(move |row| with(row, Some(&TABLE.levels)));
    let in_daylight = TABLE.in_daylight.iter().flat_map(move |row| with(row, None));
    colours.chain(in_daylight).chain(TABLE.lights.iter().flat_map(move |row| with(row, Some(&TABLE.levels))))
}
