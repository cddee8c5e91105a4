//! The tables that the shaders read: colours over a logarithm, made in f64.

use relativity_core::math::{exp2, log2};

use super::daylight::{LEAST_BETA, MOST_RAPID, log2_quantum_nm};
use super::street_light::{coloured_false, daylit};
use crate::colour::planck::{Broad, DAYLIGHT_KELVIN, band, black_body};
use crate::colour::{false_colour, linear_srgb, unseen_glow, unseen_line};
use crate::view::effects::Constant;

/// Entries of a table.
pub const ENTRIES: u32 = 2048;
/// Tables: the light of one wavelength over log2 of that, nm, and its unseen share; of black bodies over log2
/// of the temperature, K, and their unseen share; of bands over log2 of their middle, nm; the false colours
/// over log2 D; and what becomes of the street's grey over log2 D, in daylight and in false colours.
pub const ROWS: u32 = 8;

/// The range of a table: outside, its ends hold.
#[derive(Debug, Clone, Copy)]
pub struct TableRange {
    first: f64,
    last: f64,
}

/// Octaves for light of one wavelength: 338 nm to 861 nm.
pub const LINE: TableRange = TableRange { first: 8.4, last: 9.75 };
/// Octaves for black bodies: 32 K to 17 million K.
pub const GLOW: TableRange = TableRange { first: 5.0, last: 24.0 };
/// Octaves for bands: 97 nm to 3100 nm.
pub const BAND: TableRange = TableRange { first: 6.6, last: 11.6 };
/// Octaves of the Doppler factor, for false colours and for the street: D from 1/256 to 256.
pub const MAP: TableRange = TableRange { first: -8.0, last: 8.0 };

impl TableRange {
    /// Returns the number of entries per octave.
    pub fn per_octave(self) -> f64 {
        f64::from(ENTRIES - 1) / (self.last - self.first)
    }

    /// The place of `log2` in the table, entries.
    pub fn place(self, log2: f64) -> f64 {
        (log2 - self.first) * self.per_octave()
    }

    /// The entries of a table of `colour`.
    fn table(self, colour: impl Fn(f64) -> [f64; 4]) -> impl Iterator<Item = [f32; 4]> {
        let entry = move |i| colour(self.first + f64::from(i) / self.per_octave()).map(|part| part as f32);
        (0..ENTRIES).map(entry)
    }
}

/// Returns the constants of the shader.
pub fn constants() -> [Constant; 8] {
    [
        ("GLOW_PER_OCTAVE", GLOW.per_octave()),
        ("BAND_PER_OCTAVE", BAND.per_octave()),
        ("DAYLIGHT_PLACE", GLOW.place(log2(DAYLIGHT_KELVIN))),
        ("DAYLIGHT_QUANTA", daylight_quanta()),
        ("LEAST_BETA", LEAST_BETA),
        ("MOST_RAPID", MOST_RAPID),
        ("MAP_MIDDLE", MAP.place(0.0)),
        ("MAP_PER_OCTAVE", MAP.per_octave()),
    ]
}

/// log2 of the quanta of [`crate::light::daylight`] at the beginning of the table of bands.
pub fn daylight_quanta() -> f64 {
    log2_quantum_nm() - BAND.first
}

/// The tables, RGBA, a row each. The last component is log2 of what the colour is multiplied by. Unseen
/// shares are the first component of theirs.
pub fn tables() -> Vec<[f32; 4]> {
    let plain = |[red, green, blue]: [f64; 3]| [red, green, blue, 0.0];
    let share = |share: f64| [share, 0.0, 0.0, 0.0];
    let broad = |Broad { hue: [red, green, blue], log2_level }| [red, green, blue, log2_level];
    let line = LINE.table(|log2_nm| plain(linear_srgb(exp2(log2_nm))));
    let unseen_line = LINE.table(|log2_nm| share(unseen_line(exp2(log2_nm))));
    let glow = GLOW.table(|log2_kelvin| broad(black_body(log2_kelvin)));
    let unseen_glow = GLOW.table(|log2_kelvin| share(unseen_glow(log2_kelvin)));
    let band = BAND.table(|log2_nm| broad(band(log2_nm)));
    let map = MAP.table(|octaves| plain(false_colour(octaves)));
    let daylit = MAP.table(daylit);
    let falsely = MAP.table(coloured_false);
    let lights = line.chain(unseen_line).chain(glow).chain(unseen_glow).chain(band);
    lights.chain(map).chain(daylit).chain(falsely).collect()
}
