//! The tables that colours are found in, and how a screen shows what is found there.

use std::sync::LazyLock;

use fearless_simd::i32x8;
use relativity_core::math;

use crate::colour::planck::DAYLIGHT_KELVIN;
use crate::light::palette::{self, BAND, ENTRIES, GLOW, MAP};
use crate::light::shade::LIGHT;
use crate::light::tone::{BRIGHTEST, KNEE};
use crate::simd::lanes::{F, LANES, Simd, SimdFloat as _, SimdFrom as _, V3, all, clamp, select};
use crate::view::effects::Effects;

/// The rows of the tables. The row after a light's own has its unseen share.
pub const LINE_ROW: usize = 0;
pub const GLOW_ROW: usize = 2;
pub const BAND_ROW: usize = 4;
pub const MAP_ROW: usize = 5;

const LENGTH: usize = ENTRIES as usize;
pub const LAST: f32 = (ENTRIES - 1) as f32;

/// The tables that colours are found in, and where in them.
#[derive(Debug)]
pub struct Tables {
    rows: Vec<[[f32; 4]; LENGTH]>,
    pub glow_per_octave: f32,
    pub band_per_octave: f32,
    pub daylight_place: f32,
    pub daylight_quanta: f32,
    pub map_middle: f32,
    pub map_per_octave: f32,
    /// Unit vector towards the light of the shading, in the rest frame.
    pub light: [f32; 3],
}

impl Tables {
    /// Made at the first call.
    pub fn shared() -> &'static Self {
        static TABLES: LazyLock<Tables> = LazyLock::new(|| Tables {
            rows: palette::tables().as_chunks().0.to_vec(),
            glow_per_octave: GLOW.per_octave() as f32,
            band_per_octave: BAND.per_octave() as f32,
            daylight_place: GLOW.place(math::log2(DAYLIGHT_KELVIN)) as f32,
            daylight_quanta: palette::daylight_quanta() as f32,
            map_middle: MAP.place(0.0) as f32,
            map_per_octave: MAP.per_octave() as f32,
            light: LIGHT.normalize().as_vec3().to_array(),
        });
        &TABLES
    }

    /// The colours there, and log2 of what they are multiplied by.
    #[inline(always)]
    pub fn looked_up<S: Simd>(&self, row: usize, place: F<S>) -> (V3<S>, F<S>) {
        let simd = place.simd;
        let inside = clamp(place, all(simd, 0.0), all(simd, LAST));
        let below = inside.floor().min(LAST - 1.0);
        let share: [f32; LANES] = (inside - below).into();
        let table = &self.rows[row];
        let entries = entries(below);
        let mut parts = [[0.0; LANES]; 4];
        for lane in 0..LANES {
            let (low, high) = (table[entries[lane]], table[(entries[lane] + 1) % LENGTH]);
            for part in 0..4 {
                parts[part][lane] = low[part] * (1.0 - share[lane]) + high[part] * share[lane];
            }
        }
        let [red, green, blue, log2] = parts;
        (
            V3::new(F::simd_from(simd, red), F::simd_from(simd, green), F::simd_from(simd, blue)),
            F::simd_from(simd, log2),
        )
    }

    /// Returns the unseen share of the light of this row.
    #[inline(always)]
    fn unseen<S: Simd>(&self, row: usize, place: F<S>) -> F<S> {
        let simd = place.simd;
        let table = &self.rows[row + 1];
        let entries = entries(clamp(place, all(simd, 0.0), all(simd, LAST)) + 0.5);
        F::simd_from(simd, entries.map(|entry| table[entry][0]))
    }
}

/// Light as a screen shows it, as [`crate::light::screen_light::ScreenLight`].
#[derive(Debug, Clone, Copy)]
pub struct ScreenLights<S: Simd> {
    pub colour: V3<S>,
    /// The unseen share; `None` where it is 0 everywhere.
    pub unseen: Option<F<S>>,
}

/// The whole parts of numbers within a table.
#[inline(always)]
fn entries<S: Simd>(place: F<S>) -> [usize; LANES] {
    let whole: i32x8<S> = place.to_int();
    let whole: [i32; LANES] = whole.into();
    whole.map(|whole| whole as usize % LENGTH)
}

#[inline(always)]
fn shoulder<S: Simd>(x: F<S>) -> F<S> {
    const ABOVE: f32 = (1.0 - KNEE) as f32;
    let above = (x - KNEE as f32).max(0.0) / ABOVE;
    x.min(KNEE as f32) + above / (above + 1.0) * ABOVE
}

/// `light` as a screen shows it.
#[inline(always)]
pub fn toned<S: Simd>(light: V3<S>) -> V3<S> {
    let largest = light.x.max(light.y).max(light.z);
    light * (shoulder(largest) / largest.max(1e-30))
}

/// The light that a screen shows as `colour`, as [`crate::light::tone::untoned`].
#[inline(always)]
pub fn untoned<S: Simd>(colour: V3<S>) -> V3<S> {
    const ABOVE: f32 = (1.0 - KNEE) as f32;
    let largest = colour.x.max(colour.y).max(colour.z);
    let left = (1.0 - largest.min(BRIGHTEST as f32)) / ABOVE;
    let light = (1.0 / left - 1.0) * ABOVE + KNEE as f32;
    let is_above = largest.simd_gt(KNEE as f32);
    colour * select(is_above, light / largest, all(largest.simd, 1.0))
}

/// `light` as a screen shows it, with its unseen share, where it is all but black.
#[inline(always)]
pub fn shown<S: Simd>(
    effects: Effects,
    tables: &Tables,
    light: V3<S>,
    row: usize,
    place: F<S>,
) -> ScreenLights<S> {
    let largest = light.x.max(light.y).max(light.z);
    let toned = shoulder(largest);
    let colour = light * (toned / largest.max(1e-30));
    if !effects.invisible {
        return ScreenLights { colour, unseen: None };
    }
    let left = 1.0 - toned;
    let square = left * left;
    ScreenLights { colour, unseen: Some(tables.unseen(row, place) * (square * square)) }
}
