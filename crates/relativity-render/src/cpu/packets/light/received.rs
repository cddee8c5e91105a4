//! The light that is received from where rays meet a body.

use super::colour::{Hatched, received_colour};
use super::daylight::facing_of;
use super::tables::Tables;
use crate::colour::paint::Material;
use crate::colour::sunlit::WHITE;
use crate::cpu::packets::look::{Look, Seen};
use crate::cpu::packets::wheel::turning::TurningBody;
use crate::light::palette::FIRST_SUNLIT;
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

/// The paint of a model where rays meet it.
#[derive(Clone, Copy)]
pub enum PaintThere<S: Simd> {
    /// Smooth paint.
    Smooth(V3<S>),
    /// A measured material, with the colour of all paint at rest.
    Measured(Material, V3<S>),
}

/// The first number of the packed light of white paint: the rows of measured materials follow.
const ROW_OF_WHITE: f32 = -1.0 - (FIRST_SUNLIT + WHITE) as f32;

impl<S: Simd> Element<'_, S> {
    /// Linear sRGB of the light that is received from there, without pattern.
    #[inline(always)]
    pub fn colour(
        &self,
        simd: S,
        look: &Look<'_>,
        appearance: &Appearance,
        tables: &Tables,
        paint: Option<PaintThere<S>>,
        hatched: Hatched<'_>,
    ) -> V3<S> {
        let &Self { seen, turning, place, normal, doppler } = self;
        let effects = look.effects(seen.body.group, seen.turns, appearance);
        let mut light = look.light(seen.body, seen.turns, appearance);
        let smooth = match paint {
            Some(PaintThere::Measured(material, _)) if light[0] == ROW_OF_WHITE => {
                light[0] = ROW_OF_WHITE - 1.0 - material.number() as f32;
                None
            }
            Some(PaintThere::Smooth(colour) | PaintThere::Measured(_, colour)) => Some(colour),
            None => None,
        };
        let is_lit_by_the_street = effects.spectrum() == Spectrum::StreetDaylight;
        let facing = if is_lit_by_the_street { Some(facing_of(simd, turning, place, normal)) } else { None };
        let colour = received_colour(effects, tables, light, doppler, normal, facing, smooth, hatched);
        colour * (seen.body.brightness as f32)
    }
}
