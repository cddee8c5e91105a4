//! The tables that the shaders read: colours over a logarithm, made in f64.

use relativity_core::math::exp2;

use super::daylight::MOST_RAPID;
use crate::colour::planck::{Broad, black_body};
use crate::colour::sunlit::{self, FIRST_OCTAVE, PER_OCTAVE};
use crate::colour::{false_colour, linear_srgb, unseen_daylight, unseen_glow, unseen_line};
use crate::view::effects::Constant;

/// Entries of a table.
pub const ENTRIES: u32 = sunlit::ENTRIES as u32;
/// Tables: the rows of [`Row`] with those of unseen shares; at the end those of [`sunlit::rows`].
pub const ROWS: u32 = (FIRST_SUNLIT + 2 * sunlit::PAINTS + 3) as u32;
/// The first row of colours in daylight: [`sunlit::rows`] in their order.
pub const FIRST_SUNLIT: usize = 8;
/// The row of unseen shares of daylight.
pub const UNSEEN_DAYLIGHT: usize = 6;

/// A row of colours, whose last component is log2 of what they are multiplied by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Row {
    /// Light of one wavelength over log2 of that, nm.
    Line,
    /// Black bodies over log2 of the temperature, K.
    Glow,
    /// False colours over log2 of the Doppler factor.
    Map,
    /// The street's grey in false colours, over the same.
    FalseGrey,
    /// The sky's light beside that of smooth paint, over the same.
    Sky,
    /// Paint in daylight, over the same: the number among [`sunlit::rows`].
    Sunlit(usize),
}

impl Row {
    /// Returns the number of the row. Unseen shares of light of one wavelength, of black bodies and of
    /// daylight are the first components of the rows 2, 3 and [`UNSEEN_DAYLIGHT`].
    pub const fn number(self) -> usize {
        match self {
            Self::Line => 0,
            Self::Glow => 1,
            Self::Map => 4,
            Self::FalseGrey => 5,
            Self::Sky => 7,
            Self::Sunlit(number) => FIRST_SUNLIT + number,
        }
    }

    /// Returns the range of the row.
    pub const fn range(self) -> TableRange {
        match self {
            Self::Line => LINE,
            Self::Glow => GLOW,
            Self::Map | Self::FalseGrey => MAP,
            Self::Sky | Self::Sunlit(_) => SUNLIT,
        }
    }
}

/// The range of a table: outside, its ends hold.
#[derive(Debug, Clone, Copy)]
pub struct TableRange {
    first: f64,
    last: f64,
}

/// Octaves for light of one wavelength: 338 nm to 861 nm.
const LINE: TableRange = TableRange { first: 8.4, last: 9.75 };
/// Octaves for black bodies: 32 K to 17 million K.
const GLOW: TableRange = TableRange { first: 5.0, last: 24.0 };
/// Octaves of the Doppler factor, for false colours: D from 1/256 to 256.
const MAP: TableRange = TableRange { first: -8.0, last: 8.0 };
/// Octaves of the Doppler factor, for daylight: D from 0.35 to 90.
const SUNLIT: TableRange =
    TableRange { first: FIRST_OCTAVE, last: FIRST_OCTAVE + (ENTRIES - 1) as f64 / PER_OCTAVE };

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
pub fn constants() -> [Constant; 4] {
    [
        ("LINE_PER_OCTAVE", LINE.per_octave()),
        ("GLOW_PER_OCTAVE", GLOW.per_octave()),
        ("MOST_RAPID", MOST_RAPID),
        ("PAINTS", sunlit::PAINTS as f64),
    ]
}

/// Returns the constants of the shaders that show light of any body, and of the street.
pub fn places() -> [Constant; 4] {
    [
        ("MAP_MIDDLE", MAP.place(0.0)),
        ("MAP_PER_OCTAVE", MAP.per_octave()),
        ("SUNLIT_AT_REST", SUNLIT.place(0.0)),
        ("SUNLIT_PER_OCTAVE", SUNLIT.per_octave()),
    ]
}

/// The tables, RGBA, a row each.
pub fn tables() -> Vec<[f32; 4]> {
    let plain = |[red, green, blue]: [f64; 3]| [red, green, blue, 0.0];
    let share = |share: f64| [share, 0.0, 0.0, 0.0];
    let broad = |Broad { hue: [red, green, blue], log2_level }| [red, green, blue, log2_level];
    let line = LINE.table(|log2_nm| plain(linear_srgb(exp2(log2_nm))));
    let glow = GLOW.table(|log2_kelvin| broad(black_body(log2_kelvin)));
    let unseen_line = LINE.table(|log2_nm| share(unseen_line(exp2(log2_nm))));
    let unseen_glow = GLOW.table(|log2_kelvin| share(unseen_glow(log2_kelvin)));
    let map = MAP.table(|octaves| plain(false_colour(octaves)));
    let falsely = MAP.table(coloured_false);
    let unseen_daylight = SUNLIT.table(|octaves| share(unseen_daylight(octaves)));
    let lights = line.chain(glow).chain(unseen_line).chain(unseen_glow).chain(map).chain(falsely);
    let sky = SUNLIT.table(|octaves| plain(sunlit::sky_beside_paint(octaves)));
    let daylight = unseen_daylight.chain(sky);
    lights.chain(daylight).chain(sunlit::rows().map(|entry| entry.map(|part| part as f32))).collect()
}

/// Linear sRGB of grey in the false colour of a Doppler factor of 2^`octaves`; and 0.
pub fn coloured_false(octaves: f64) -> [f64; 4] {
    let [grey, shown] = [0.0, octaves].map(false_colour);
    [shown[0] / grey[0], shown[1] / grey[1], shown[2] / grey[2], 0.0]
}
