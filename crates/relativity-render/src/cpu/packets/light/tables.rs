//! The tables that colours are found in, and how a screen shows what is found there.

use std::sync::LazyLock;

use fearless_simd::i32x8;

use crate::colour::sunlit::WHITE;
use crate::light::palette::{self, ENTRIES, FIRST_SUNLIT, Row, UNSEEN_DAYLIGHT};
use crate::light::shade::LIGHT;
use crate::light::tone::{BRIGHTEST, KNEE};
use crate::simd::lanes::{F, LANES, Simd, SimdFloat as _, SimdFrom as _, V3, all, clamp, select};
use crate::view::effects::Effects;

const LENGTH: usize = ENTRIES as usize;
pub const LAST: f32 = (ENTRIES - 1) as f32;

/// Light as the formulas take it.
#[derive(Clone, Copy)]
pub enum LightKind<S: Simd> {
    /// Light of a row of the tables.
    InRow(usize),
    /// Daylight that smooth paint reflects, with these shares of red, green and blue.
    Smooth(V3<S>),
}

impl<S: Simd> LightKind<S> {
    /// Returns the kind of this [`Light::packed`](crate::light::screen_light::Light::packed), on the paint of
    /// a model if there is any.
    #[inline(always)]
    pub fn new(simd: S, light: [f32; 4], paint: Option<V3<S>>) -> Self {
        let [first, second, ..] = light;
        if first >= 0.0 {
            return Self::Smooth(V3::all(simd, [first, second, 1.0 - first - second]));
        }
        let row = -first as usize - 1;
        match paint {
            Some(paint) if row == FIRST_SUNLIT + WHITE => Self::Smooth(paint),
            _ => Self::InRow(row),
        }
    }

    /// Whether it is daylight.
    #[inline(always)]
    pub fn is_daylight(self) -> bool {
        matches!(self, Self::Smooth(_) | Self::InRow(FIRST_SUNLIT..))
    }
}

/// The tables that colours are found in, and where in them.
#[derive(Debug)]
pub struct Tables {
    rows: Vec<[[f32; 4]; LENGTH]>,
    line_per_octave: f32,
    glow_per_octave: f32,
    pub sunlit_at_rest: f32,
    pub sunlit_per_octave: f32,
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
            line_per_octave: Row::Line.range().per_octave() as f32,
            glow_per_octave: Row::Glow.range().per_octave() as f32,
            sunlit_at_rest: Row::Sunlit(0).range().place(0.0) as f32,
            sunlit_per_octave: Row::Sunlit(0).range().per_octave() as f32,
            map_middle: Row::Map.range().place(0.0) as f32,
            map_per_octave: Row::Map.range().per_octave() as f32,
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

    /// Returns how far a place in this row moves per octave of the Doppler factor: back in that of light of
    /// one wavelength.
    #[inline(always)]
    pub fn per_octave(&self, row: usize) -> f32 {
        match row {
            FIRST_SUNLIT.. => self.sunlit_per_octave,
            _ if row == Row::Line.number() => -self.line_per_octave,
            _ => self.glow_per_octave,
        }
    }

    /// The colours there and log2 of what they are multiplied by, which rises on beyond the end.
    #[inline(always)]
    pub fn colour<S: Simd>(&self, row: usize, place: F<S>) -> (V3<S>, F<S>) {
        let (colour, level) = self.looked_up(row, place);
        (colour, level + (place - LAST).max(0.0) * self.per_octave(row).abs().recip())
    }

    /// The sum of the colours there of red, green and blue paint in daylight with these shares, and log2 of
    /// what they are multiplied by.
    #[inline(always)]
    pub fn smooth<S: Simd>(&self, first: usize, shares: V3<S>, place: F<S>) -> (V3<S>, F<S>) {
        let (red, level) = self.colour(first, place);
        let (green, blue) = (self.looked_up(first + 1, place).0, self.looked_up(first + 2, place).0);
        (red * shares.x + green * shares.y + blue * shares.z, level)
    }

    /// Returns the unseen share of the light of this row.
    #[inline(always)]
    pub fn unseen<S: Simd>(&self, row: usize, place: F<S>) -> F<S> {
        let simd = place.simd;
        let table = &self.rows[if row >= FIRST_SUNLIT { UNSEEN_DAYLIGHT } else { row + 2 }];
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

/// Returns how many times as bright as `colour` the light is that a screen shows so: see
/// [`crate::light::tone::untoned`].
#[inline(always)]
pub fn untoning<S: Simd>(colour: V3<S>) -> F<S> {
    const ABOVE: f32 = (1.0 - KNEE) as f32;
    let largest = colour.x.max(colour.y).max(colour.z);
    let left = (1.0 - largest.min(BRIGHTEST as f32)) / ABOVE;
    let light = (1.0 / left - 1.0) * ABOVE + KNEE as f32;
    let is_above = largest.simd_gt(KNEE as f32);
    select(is_above, light / largest, all(largest.simd, 1.0))
}

/// `light` where it has components below 0 as a screen can show it: see
/// [`on_screen`](crate::colour::sunlit::on_screen).
#[inline(always)]
pub fn on_screen<S: Simd>(light: V3<S>) -> V3<S> {
    let least = light.x.min(light.y).min(light.z).min(0.0);
    let grey = (light.x * 0.2126 + light.y * 0.7152 + light.z * 0.0722).max(0.0);
    let share = grey / (grey - least).max(1e-30);
    let grey = V3::new(grey, grey, grey);
    let paler = ((light - grey) * share + grey).at_least(0.0);
    V3::select(least.simd_lt(0.0), paler, light)
}

/// `light` as a screen shows it, where it is all but black with this unseen share.
#[inline(always)]
pub fn shown<S: Simd>(effects: Effects, light: V3<S>, unseen: impl FnOnce() -> F<S>) -> ScreenLights<S> {
    let largest = light.x.max(light.y).max(light.z);
    let toned = shoulder(largest);
    let colour = light * (toned / largest.max(1e-30));
    if !effects.invisible {
        return ScreenLights { colour, unseen: None };
    }
    let left = 1.0 - toned;
    let square = left * left;
    ScreenLights { colour, unseen: Some(unseen() * (square * square)) }
}
