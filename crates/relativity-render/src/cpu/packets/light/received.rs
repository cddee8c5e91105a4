//! The light that is received from where rays meet a body.

use super::colour::{Hatched, received_colour};
use super::daylight::facing_of;
use super::tables::Tables;
use crate::cpu::packets::look::{Look, Seen};
use crate::cpu::packets::wheel::turning::TurningBody;
use crate::simd::lanes::{F, Simd, V3};
use crate::view::Appearance;
use crate::view::effects::Spectrum;

/// A surface element where eight rays meet a body, and the Doppler factor of the light from there.
pub struct Element<'a, S: Simd> {
    pub seen: &'a Seen<'a>,
    pub turning: &'a TurningBody<'a, S>,
    /// From the middle of the body.
    pub place: V3<S>,
    pub normal: V3<S>,
    pub doppler: F<S>,
}

impl<S: Simd> Element<'_, S> {
    /// Linear sRGB of the light that is received from there, without pattern and paint.
    #[inline(always)]
    pub fn colour(
        &self,
        simd: S,
        look: &Look<'_>,
        appearance: &Appearance,
        tables: &Tables,
        hatched: Hatched<'_>,
    ) -> V3<S> {
        let &Self { seen, turning, place, normal, doppler } = self;
        let effects = look.effects(seen.body.group, seen.turns, appearance);
        let light = look.light(seen.body, seen.turns, appearance);
        let is_lit_by_the_street = effects.spectrum() == Spectrum::StreetDaylight;
        let facing = if is_lit_by_the_street { Some(facing_of(simd, turning, place, normal)) } else { None };
        let colour = received_colour(effects, tables, light, doppler, normal, facing, hatched);
        colour * (seen.body.brightness as f32)
    }
}
