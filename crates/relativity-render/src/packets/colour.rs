//! From a Doppler factor to linear sRGB, as `shaders/colour.wgsl` has it.

use std::sync::LazyLock;

use fearless_simd::i32x8;
use relativity_core::math;

use super::daylight::{Facing, of_street_daylight};
use super::logarithm::{MOST_POWER, log2, power_of_two};
use crate::effects::{Effects, Spectrum};
use crate::lanes::{F, LANES, Simd, SimdFloat as _, SimdFrom as _, V3, all, clamp};
use crate::palette::{self, BAND, ENTRIES, GLOW, MAP};
use crate::planck::DAYLIGHT_KELVIN;
use crate::shade::{FORM, LIGHT};
use crate::tone::KNEE;

/// The tables' rows. What eyes do not see of a light stands in the row after it.
const LINE_ROW: usize = 0;
pub(super) const GLOW_ROW: usize = 2;
pub(super) const BAND_ROW: usize = 4;
const MAP_ROW: usize = 5;

const LENGTH: usize = ENTRIES as usize;
pub(super) const LAST: f32 = (ENTRIES - 1) as f32;

/// The tables that colours are found in, and where in them.
#[derive(Debug)]
pub struct Tables {
    rows: Vec<[[f32; 4]; LENGTH]>,
    pub(super) glow_per_octave: f32,
    pub(super) band_per_octave: f32,
    pub(super) daylight_place: f32,
    pub(super) daylight_quanta: f32,
    map_middle: f32,
    map_per_octave: f32,
    /// Unit vector towards the light of the shading, in the rest frame.
    light: [f32; 3],
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
    pub(super) fn looked_up<S: Simd>(&self, row: usize, place: F<S>) -> (V3<S>, F<S>) {
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

    /// What eyes do not see of the light of this row.
    #[inline(always)]
    fn dark<S: Simd>(&self, row: usize, place: F<S>) -> V3<S> {
        let simd = place.simd;
        let table = &self.rows[row + 1];
        let entries = entries(clamp(place, all(simd, 0.0), all(simd, LAST)) + 0.5);
        let mut parts = [[0.0; LANES]; 3];
        for lane in 0..LANES {
            let entry = table[entries[lane]];
            for part in 0..3 {
                parts[part][lane] = entry[part];
            }
        }
        let [red, green, blue] = parts;
        V3::new(F::simd_from(simd, red), F::simd_from(simd, green), F::simd_from(simd, blue))
    }
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

/// `light` as a screen shows it, with what eyes do not see of it under it, where it is all but black.
#[inline(always)]
pub(super) fn shown<S: Simd>(
    effects: Effects,
    tables: &Tables,
    light: V3<S>,
    row: usize,
    place: F<S>,
) -> V3<S> {
    let largest = light.x.max(light.y).max(light.z);
    let toned = shoulder(largest);
    let colour = light * (toned / largest.max(1e-30));
    if !effects.invisible {
        return colour;
    }
    let left = 1.0 - toned;
    let square = left * left;
    colour + tables.dark(row, place) * (square * square)
}

#[inline(always)]
fn of_one_place<S: Simd>(
    effects: Effects,
    tables: &Tables,
    light: [f32; 4],
    octaves: F<S>,
    shift: F<S>,
) -> V3<S> {
    let [at_rest, per_octave, exponent, exposure] = light;
    let row = if per_octave < 0.0 { LINE_ROW } else { GLOW_ROW };
    let place = shift * per_octave + at_rest;
    let (entry, level) = tables.looked_up(row, place);
    let power = power_of_two(level + octaves * exponent + exposure);
    shown(effects, tables, entry * power, row, place)
}

#[inline(always)]
fn of_daylight<S: Simd>(
    effects: Effects,
    tables: &Tables,
    light: [f32; 4],
    octaves: F<S>,
    shift: F<S>,
) -> V3<S> {
    let [band, band_exposure, exposure, band_exponent] = light;
    let place = shift * tables.glow_per_octave + tables.daylight_place;
    let (white, white_level) = tables.looked_up(GLOW_ROW, place);
    let (own, own_level) = tables.looked_up(BAND_ROW, shift * -tables.band_per_octave + band);
    let exponent = if effects.doppler_shift { 0.0 } else { band_exponent };
    let white_power = white_level + octaves * exponent + exposure;
    let own_power = own_level + octaves * band_exponent + band_exposure;
    // Beyond what floats hold both are held back alike: so their mixture keeps its hue.
    let beyond = (white_power.max(own_power) - MOST_POWER).max(0.0);
    let sum = white * power_of_two(white_power - beyond) + own * power_of_two(own_power - beyond);
    shown(effects, tables, sum, GLOW_ROW, place)
}

#[inline(always)]
fn colour_of<S: Simd>(
    simd: S,
    effects: Effects,
    tables: &Tables,
    light: [f32; 4],
    doppler: F<S>,
    facing: Option<Facing<S>>,
) -> V3<S> {
    if effects.spectrum() == Spectrum::AtRest {
        return V3::of_four(simd, light);
    }
    let octaves = log2(doppler);
    let shift = if effects.doppler_shift { octaves } else { all(simd, 0.0) };
    match effects.spectrum() {
        Spectrum::AtRest | Spectrum::OnePlace => of_one_place(effects, tables, light, octaves, shift),
        Spectrum::Daylight => of_daylight(effects, tables, light, octaves, shift),
        Spectrum::StreetDaylight => {
            let facing = facing.expect("it is known where the street's daylight is shown");
            of_street_daylight(effects, tables, light, shift, facing)
        }
        Spectrum::Map => tables.looked_up(MAP_ROW, octaves * tables.map_per_octave + tables.map_middle).0,
    }
}

/// Linear sRGB of a body with this [`Light::packed`](crate::light::Light::packed) where it is received with this Doppler
/// factor, before its brightness; and `facing` the street's daylight, where that lights it.
#[inline(always)]
pub fn received_colour<S: Simd>(
    simd: S,
    effects: Effects,
    tables: &Tables,
    light: [f32; 4],
    doppler: F<S>,
    normal: V3<S>,
    facing: Option<Facing<S>>,
) -> V3<S> {
    let colour = colour_of(simd, effects, tables, light, doppler, facing);
    if !effects.form {
        return colour;
    }
    let [across, towards] = FORM;
    colour * (normal.dot(V3::all(simd, tables.light)) * towards as f32 + across as f32)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::body::Emission;
    use crate::colour::srgb_encoded;
    use crate::daylight;
    use crate::light::Light;
    use crate::packets::testing::at_every_level;
    use crate::shade::form;
    use crate::view::{Appearance, Colour, Shading};

    fn appearances() -> Vec<Appearance> {
        let colours = [Colour::OneWavelength, Colour::Glowing, Colour::White, Colour::False];
        let mut appearances = Vec::new();
        for colour in colours {
            for doppler_shift in [true, false] {
                for intensity_exponent in [None, Some(2.5), Some(4.0)] {
                    for (exposure_ev, invisible) in [
                        (0.0, true),
                        (-6.0, false),
                        (6.0, true),
                        (81.0, true),
                        (100.0, false),
                        (-100.0, true),
                    ] {
                        let shading = if invisible { Shading::Form } else { Shading::Emission };
                        appearances.push(Appearance {
                            colour,
                            doppler_shift,
                            intensity_exponent,
                            exposure_ev,
                            invisible,
                            shading,
                            ..Appearance::default()
                        });
                    }
                }
            }
        }
        appearances
    }

    /// D from 1e-6 to 1e6.
    fn doppler_factors() -> Vec<[f32; LANES]> {
        let factors: Vec<_> =
            (0..800).map(|i| math::exp2((f64::from(i) / 400.0 - 1.0) * 19.93) as f32).collect();
        factors.as_chunks().0.to_vec()
    }

    #[test]
    fn received_light_is_the_references() {
        let emissions = [
            Emission::White,
            Emission::Wavelength(450.0),
            Emission::Wavelength(550.0),
            Emission::Wavelength(700.0),
        ];
        let normal = DVec3::new(0.48, -0.6, 0.64);
        let mut worst: f64 = 0.0;
        for appearance in appearances() {
            let effects = Effects::new(true, &appearance);
            for emission in emissions {
                let light = Light::new(emission, &appearance);
                let packed = light.packed(&appearance, effects).map(|part| part as f32);
                let mut first: Option<Vec<_>> = None;
                at_every_level!(simd => {
                    let mut bits = Vec::new();
                    for factors in doppler_factors() {
                        let toward = V3::all(simd, normal.as_vec3().to_array());
                        let doppler = F::simd_from(simd, factors);
                        let found = received_colour(simd, effects, Tables::shared(), packed, doppler, toward, None);
                        for (lane, factor) in factors.into_iter().enumerate() {
                            bits.extend(found.lane(lane).map(f32::to_bits));
                            let shading = if effects.form { form(normal) } else { 1.0 };
                            // That table ends there.
                            let ends = if light == Light::Map { 256.0 } else { 1e9 };
                            let told = f64::from(factor).clamp(1.0 / ends, ends);
                            let expected = light.shown(&appearance, told).map(|part| part * shading);
                            for (found, expected) in found.lane(lane).into_iter().zip(expected) {
                                let off = 255.0 * (srgb_encoded(found.into()) - srgb_encoded(expected)).abs();
                                worst = worst.max(off);
                                assert!(off < 2.0, "{appearance:?} {emission:?} D = {factor}: {found} for {expected}");
                            }
                        }
                    }
                    assert!(bits == *first.get_or_insert_with(|| bits.clone()), "{appearance:?} {emission:?}");
                });
            }
        }
        println!("at most {worst} levels off");
    }

    #[test]
    fn street_daylight_is_the_references() {
        let appearance = |exposure_ev| {
            let (colour, shading) = (Colour::StreetDaylight, Shading::Emission);
            Appearance { colour, exposure_ev, shading, ..Appearance::default() }
        };
        let mut worst: f64 = 0.0;
        for (rapid, ahead, exposure_ev) in [
            (0.0, 0.3, 0.0),
            (1e-6, -0.7, 1.0),
            (0.1, 0.9, 0.0),
            (0.75, -1.0, 2.0),
            (2.0647, 1.0, -2.0),
            (2.0647, 0.0, 1.0),
            (2.0647, -0.4, 5.0),
            (7.0, -0.95, 8.0),
            (22.4, 0.2, -4.0),
            (1e6, 1.0, 100.0),
        ] {
            let appearance = appearance(exposure_ev);
            let effects = Effects::new(true, &appearance).in_street_daylight();
            for emission in [Emission::White, Emission::Wavelength(450.0), Emission::Wavelength(640.0)] {
                let light = Light::new(emission, &appearance);
                let packed = light.packed(&appearance, effects).map(|part| part as f32);
                at_every_level!(simd => {
                    let facing = Facing { rapid: all(simd, rapid as f32), ahead: all(simd, ahead as f32) };
                    for factors in doppler_factors() {
                        let (doppler, toward) = (F::simd_from(simd, factors), V3::all(simd, [0.0, 0.0, 1.0]));
                        let found =
                            received_colour(simd, effects, Tables::shared(), packed, doppler, toward, Some(facing));
                        let parts = daylight::Facing { rapid, ahead }.parts();
                        for (lane, factor) in factors.into_iter().enumerate() {
                            let expected = light.shown_in_parts(&appearance, factor.into(), &parts);
                            for (found, expected) in found.lane(lane).into_iter().zip(expected) {
                                let off = 255.0 * (srgb_encoded(found.into()) - srgb_encoded(expected)).abs();
                                worst = worst.max(off);
                                assert!(off < 2.0, "{rapid} {ahead} {emission:?} D = {factor}: {found} {expected}");
                            }
                        }
                    }
                });
            }
        }
        println!("at most {worst} levels off");
    }
}
