//! From a Doppler factor to linear sRGB, the same way as `shaders/colour.wgsl`.

use std::array::from_fn;

use super::daylight::{Facings, of_street_daylight};
use super::tables::{LightKind, ScreenLights, Tables, on_screen, shown};
use crate::cpu::packets::logarithm::{log2, power_of_two};
use crate::cpu::packets::places::pixel_of_lane;
use crate::light::hatch::Hatch;
use crate::light::palette::{FIRST_SUNLIT, Row};
use crate::light::shade::FORM;
use crate::simd::lanes::{F, LANES, Simd, SimdFrom as _, V3, all};
use crate::view::effects::{Effects, Spectrum};

#[inline(always)]
fn of_place<S: Simd>(
    effects: Effects,
    tables: &Tables,
    light: [f32; 4],
    kind: LightKind<S>,
    [octaves, shift]: [F<S>; 2],
    paint: Option<V3<S>>,
) -> ScreenLights<S> {
    let [_, at_rest, exponent, exposure] = light;
    let (row, place, (colour, level)) = match kind {
        LightKind::InRow(row) => {
            let place = shift * tables.per_octave(row) + at_rest;
            (row, place, tables.colour(row, place))
        }
        LightKind::Smooth(shares) => {
            let place = shift * tables.sunlit_per_octave + tables.sunlit_at_rest;
            (FIRST_SUNLIT, place, tables.smooth(FIRST_SUNLIT, shares, place))
        }
    };
    let mut light = colour * power_of_two(level + octaves * exponent + exposure);
    if row >= FIRST_SUNLIT {
        light = on_screen(light);
    } else if let Some(paint) = paint {
        light = light.times(paint);
    }
    shown(
        effects,
        light,
        #[inline(always)]
        || tables.unseen(row, place),
    )
}

#[inline(always)]
fn colour_of<S: Simd>(
    simd: S,
    effects: Effects,
    tables: &Tables,
    light: [f32; 4],
    doppler: F<S>,
    facing: Option<Facings<S>>,
    paint: Option<V3<S>>,
) -> ScreenLights<S> {
    if effects.spectrum() == Spectrum::AtRest {
        let colour = V3::of_four(simd, light);
        let colour = paint.map_or(colour, |paint| colour.times(paint));
        return shown(effects, colour, || all(simd, light[3]));
    }
    let octaves = log2(doppler);
    if effects.spectrum() == Spectrum::Map {
        let place = octaves * tables.map_per_octave + tables.map_middle;
        let colour = tables.looked_up(Row::Map.number(), place).0;
        let dimmed = |paint: V3<S>| colour * (paint.x * 0.2126 + paint.y * 0.7152 + paint.z * 0.0722);
        return ScreenLights { colour: paint.map_or(colour, dimmed), unseen: None };
    }
    let shift = if effects.doppler_shift { octaves } else { all(simd, 0.0) };
    let kind = LightKind::new(simd, light, paint);
    match facing {
        Some(facing) if kind.is_daylight() => {
            of_street_daylight(effects, tables, light[3], kind, shift, facing)
        }
        _ => of_place(effects, tables, light, kind, [octaves, shift], paint),
    }
}

/// The hatch in the pixels of a packet.
#[derive(Debug, Clone, Copy)]
pub struct Hatched<'a> {
    pub hatch: &'a Hatch,
    /// The pixel at the top left.
    pub corner: [u32; 2],
}

impl Hatched<'_> {
    /// Linear sRGB of light with this unseen share.
    #[inline(always)]
    fn colour<S: Simd>(self, unseen: F<S>) -> V3<S> {
        let shares: [f32; LANES] = unseen.into();
        let colours: [[f64; 3]; LANES] = from_fn(|lane| {
            let place = pixel_of_lane(self.corner, lane).map(f64::from);
            self.hatch.colour(shares[lane].into(), place)
        });
        let [red, green, blue] =
            [0, 1, 2].map(|part| F::simd_from(unseen.simd, from_fn(|lane| colours[lane][part] as f32)));
        V3::new(red, green, blue)
    }
}

/// Linear sRGB of a body with this [`exposed`](crate::light::screen_light::exposed) light where it is
/// received with this Doppler factor, before its brightness; `facing` the street's daylight, where that
/// lights it, on the smooth `paint` of a model, and `hatched` in these pixels.
#[expect(clippy::too_many_arguments, reason = "light, what it falls on, and how pictures look")]
#[inline(always)]
pub fn received_colour<S: Simd>(
    effects: Effects,
    tables: &Tables,
    light: [f32; 4],
    doppler: F<S>,
    normal: V3<S>,
    facing: Option<Facings<S>>,
    paint: Option<V3<S>>,
    hatched: Hatched<'_>,
) -> V3<S> {
    let simd = doppler.simd;
    let ScreenLights { mut colour, unseen } = colour_of(simd, effects, tables, light, doppler, facing, paint);
    if let Some(unseen) = unseen {
        colour += hatched.colour(unseen);
    }
    if !effects.form {
        return colour;
    }
    let [across, towards] = FORM;
    colour * (normal.dot(V3::all(simd, tables.light)) * towards as f32 + across as f32)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use relativity_core::math;

    use super::*;
    use crate::colour::paint::{Material, Paint};
    use crate::colour::srgb_encoded;
    use crate::cpu::packets::testing::at_every_level;
    use crate::light::daylight;
    use crate::light::screen_light::{Light, ScreenLight, exposed, packed_exposure};
    use crate::light::shade::form;
    use crate::scene::body::Emission;
    use crate::view::{Appearance, Colour, Shading};

    const CORNER: [u32; 2] = [40, 14];

    /// The reference's colour in the pixel of this lane.
    fn expected(shown: ScreenLight, hatch: &Hatch, lane: usize) -> [f64; 3] {
        let hatched = hatch.colour(shown.unseen, pixel_of_lane(CORNER, lane).map(f64::from));
        from_fn(|i| shown.colour[i] + hatched[i])
    }

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

    /// The exposed light for the formulas.
    fn packed(light: Light, appearance: &Appearance, effects: Effects) -> [f32; 4] {
        let is_looked_up = effects.spectrum() != Spectrum::AtRest;
        exposed(light.packed(appearance, effects), packed_exposure(appearance), is_looked_up)
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
            Emission::WHITE,
            Emission::Painted(Paint::Smooth([0.5, 0.2, 0.0])),
            Emission::Painted(Paint::Measured(Material::ALL[10])),
            Emission::Glowing(2700.0),
            Emission::Wavelength(450.0),
            Emission::Wavelength(550.0),
            Emission::Wavelength(700.0),
        ];
        let normal = DVec3::new(0.48, -0.6, 0.64);
        let hatch = Hatch::new([640, 480], false);
        let hatched = Hatched { hatch: &hatch, corner: CORNER };
        let mut worst: f64 = 0.0;
        for appearance in appearances() {
            let effects = Effects::new(true, &appearance);
            for emission in emissions {
                let light = Light::new(emission, &appearance);
                let packed = packed(light, &appearance, effects);
                let mut first: Option<Vec<_>> = None;
                at_every_level!(simd => {
                    let mut bits = Vec::new();
                    for factors in doppler_factors() {
                        let toward = V3::all(simd, normal.as_vec3().to_array());
                        let doppler = F::simd_from(simd, factors);
                        let found = received_colour(effects, Tables::shared(), packed, doppler, toward, None, None, hatched);
                        for (lane, factor) in factors.into_iter().enumerate() {
                            bits.extend(found.lane(lane).map(f32::to_bits));
                            let shading = if effects.form { form(normal) } else { 1.0 };
                            // That table ends there.
                            let ends = if light == Light::Map { 256.0 } else { 1e9 };
                            let told = f64::from(factor).clamp(1.0 / ends, ends);
                            let shown = light.shown(&appearance, told);
                            let expected = expected(shown, &hatch, lane).map(|part| part * shading);
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
        let hatch = Hatch::new([640, 480], false);
        let hatched = Hatched { hatch: &hatch, corner: CORNER };
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
            for emission in [
                Emission::WHITE,
                Emission::Painted(Paint::Measured(Material::ALL[10])),
                Emission::Glowing(2700.0),
                Emission::Wavelength(640.0),
            ] {
                let light = Light::new(emission, &appearance);
                let packed = packed(light, &appearance, effects);
                at_every_level!(simd => {
                    let facing = Facings { rapid: all(simd, rapid as f32), ahead: all(simd, ahead as f32) };
                    for factors in doppler_factors() {
                        let (doppler, toward) = (F::simd_from(simd, factors), V3::all(simd, [0.0, 0.0, 1.0]));
                        let found =
                            received_colour(effects, Tables::shared(), packed, doppler, toward, Some(facing), None, hatched);
                        let facing = Some(daylight::Facing { rapid, ahead });
                        for (lane, factor) in factors.into_iter().enumerate() {
                            let shown = light.shown_facing(&appearance, factor.into(), facing, Paint::WHITE);
                            let expected = expected(shown, &hatch, lane);
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
