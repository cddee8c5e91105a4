//! The street's daylight as surfaces receive it: `shaders/daylight.wgsl` on the CPU.
//! [`crate::light::daylight`] derives it.

use std::f32::consts::PI;

use super::tables::{LightKind, ScreenLights, Tables, on_screen, shown};
use crate::colour::sunlit::{FIRST_OCTAVE, PAINTS, WHITE};
use crate::cpu::packets::logarithm::{log2, power_of_two};
use crate::cpu::packets::wheel::spin::velocity_at;
use crate::cpu::packets::wheel::turning::TurningBody;
use crate::light::daylight::MOST_RAPID;
use crate::light::palette::FIRST_SUNLIT;
use crate::light::sky;
use crate::scene::wheel::packed::Turns;
use crate::simd::lanes::{
    F, LANES, Simd, SimdFloat as _, SimdFrom as _, V2, V3, all, clamp, select, sign_of,
};
use crate::view::effects::Effects;

/// The motion of surfaces through the street's light.
#[derive(Debug, Clone, Copy)]
pub struct Facings<S: Simd> {
    /// gamma beta on the street.
    pub rapid: F<S>,
    /// The cosine, in their own frame, of the angle between their normal and their motion.
    pub ahead: F<S>,
}

/// Returns the motion of the surface at `place`, from the body's middle, with this `normal`.
#[inline(always)]
pub fn facing_of<S: Simd>(simd: S, there: &TurningBody<'_, S>, place: V3<S>, normal: V3<S>) -> Facings<S> {
    let [beta, _, _, gamma] = there.group.frame.on_ground;
    let sign = there.group.frame.motion[3];
    let n = normal.reflected(sign);
    let mut own = V3::all(simd, [0.0; 3]);
    if there.turns != Turns::Not {
        own = velocity_at(simd, there.place_from_hub(place), &there.spin).reflected(sign);
    }
    let own_gamma = 1.0 / (1.0 - own.dot(own)).max(1e-30).sqrt();
    let along = (own.x + beta) * own_gamma * gamma;
    let rapid = V2::new(along, own_gamma * own.z).length().min(MOST_RAPID as f32);
    let turning = n.dot(own);
    let scale = (1.0 - turning * turning).max(1e-30).sqrt();
    let time = (turning + n.x * beta) / scale * gamma;
    let one = all(simd, 1.0);
    Facings { rapid, ahead: clamp(time / rapid.max(1e-30), -one, one) }
}

impl<S: Simd> Facings<S> {
    /// log2 of the mean Doppler factor of the light of the hemisphere, as
    /// [`Facing::mean_octaves`](crate::light::daylight::Facing::mean_octaves).
    #[inline(always)]
    fn mean_octaves(self) -> F<S> {
        let time = self.rapid * self.ahead;
        let [across, gamma] = [(time * time + 1.0).sqrt(), (self.rapid * self.rapid + 1.0).sqrt()];
        log2(gamma / across * (1.0 - time / (across * 3.0))) + octaves_of_sinh(time)
    }

    /// The colour of paint with these `shares` of red, green and blue where `octaves` is log2 of the mean
    /// Doppler factor, as [`sky::reflected`]; and log2 of white's level.
    #[inline(always)]
    fn reflected(self, simd: S, octaves: F<S>, shares: V3<S>) -> (V3<S>, F<S>) {
        let (zero, one) = (all(simd, 0.0), all(simd, 1.0));
        let motion = octaves_of_sinh(self.rapid);
        let of_normal = clamp(octaves_of_sinh(self.rapid * self.ahead) / motion.max(1e-30), -one, one);
        let turn = arc_cosine(simd, -of_normal) * ((sky::TURNS - 1) as f32 / PI);
        let place = (octaves - FIRST_OCTAVE as f32) * sky::PER_OCTAVE as f32;
        let last = (sky::ENTRIES - 1) as f32;
        let speed = motion * sky::SPEEDS_PER_OCTAVE as f32;
        let speed: [f32; LANES] = clamp(speed, zero, all(simd, (sky::SPEEDS - 1) as f32)).into();
        let (turn, inside): ([f32; LANES], [f32; LANES]) =
            (turn.into(), clamp(place, zero, all(simd, last)).into());
        let [red, green, blue]: [[f32; LANES]; 3] = [shares.x.into(), shares.y.into(), shares.z.into()];
        let mut parts = [[0.0; LANES]; 4];
        let below = |lane: usize| (speed[lane] as usize).min(sky::SPEEDS - 2);
        let tables_at = |speed: usize| [speed, speed + 1].map(sky::at_speed);
        // Nearly always all lanes see one body, and have one speed.
        let (mut known, mut tables) = (below(0), tables_at(below(0)));
        for lane in 0..LANES {
            if below(lane) != known {
                (known, tables) = (below(lane), tables_at(below(lane)));
            }
            let at = [speed[lane] - known as f32, turn[lane], inside[lane]];
            let found = in_table(tables, at, [red[lane], green[lane], blue[lane]]);
            for part in 0..4 {
                parts[part][lane] = found[part];
            }
        }
        let [red, green, blue, level] = parts.map(|part| F::simd_from(simd, part));
        (V3::new(red, green, blue), level + (place - last).max(0.0) * (sky::PER_OCTAVE as f32).recip())
    }
}

/// The entry of the table of the sky at this turn and place, so far between two speeds, of which these are
/// the `tables`, and of paint with these shares.
#[inline(always)]
fn in_table(tables: [&[[f32; 4]]; 2], at: [f32; 3], shares: [f32; 3]) -> [f32; 4] {
    let below = |of: usize, count: usize| (at[of] as usize).min(count - 2);
    let [turn, place] = [below(1, sky::TURNS), below(2, sky::ENTRIES)];
    let past = [at[0], at[1] - turn as f32, at[2] - place as f32];
    let mut found = [0.0; 4];
    for corner in 0..4 {
        let [faster, ahead] = [corner / 2, corner % 2];
        let weight = |of: usize, past_it: usize| if past_it == 1 { past[of] } else { 1.0 - past[of] };
        let weight = weight(0, faster) * weight(1, ahead);
        let row = &tables[faster][(turn + ahead) * sky::WIDTH..][..sky::WIDTH];
        for (primary, share) in shares.into_iter().enumerate() {
            let [low, high] = [row[primary * sky::ENTRIES + place], row[primary * sky::ENTRIES + place + 1]];
            for part in 0..3 {
                let entry = low[part] * (1.0 - past[2]) + high[part] * past[2];
                found[part] += weight * share * entry;
            }
        }
        found[3] += weight * (row[place][3] * (1.0 - past[2]) + row[place + 1][3] * past[2]);
    }
    found
}

/// log2 of e to what has this hyperbolic sine.
#[inline(always)]
fn octaves_of_sinh<S: Simd>(x: F<S>) -> F<S> {
    sign_of(x) * log2(x.abs() + (x * x + 1.0).sqrt())
}

/// The angle with this cosine, within 7e-5: M. Abramowitz, I. A. Stegun, *Handbook of Mathematical
/// Functions*, 4.4.45.
#[inline(always)]
fn arc_cosine<S: Simd>(simd: S, cosine: F<S>) -> F<S> {
    let x = cosine.abs();
    let sum = x * (x * (x * -0.018_729_3 + 0.074_261) - 0.212_114_4) + 1.570_728_8;
    let angle = (1.0 - x).max(0.0).sqrt() * sum;
    select(cosine.simd_lt(all(simd, 0.0)), PI - angle, angle)
}

/// Linear sRGB of what reflects the street's daylight, for this log2 of the exposure: see
/// [`crate::colour::sunlit`].
#[inline(always)]
pub fn of_street_daylight<S: Simd>(
    effects: Effects,
    tables: &Tables,
    exposure: f32,
    kind: LightKind<S>,
    shift: F<S>,
    facing: Facings<S>,
) -> ScreenLights<S> {
    let simd = shift.simd;
    let seen = shift * tables.sunlit_per_octave + tables.sunlit_at_rest;
    // The shares of the smooth paint that stands for it, and its colour.
    let stand_in = match kind {
        LightKind::InRow(WHITE_ROW) => None,
        LightKind::InRow(row) => {
            Some((tables.looked_up(row + PAINTS, seen).0, tables.looked_up(row, seen).0))
        }
        LightKind::Smooth(shares) => Some((
            tables.smooth(FIRST_SUNLIT + PAINTS, shares, seen).0,
            tables.smooth(FIRST_SUNLIT, shares, seen).0,
        )),
    };
    let octaves = shift + facing.mean_octaves();
    let (colour, level) = match stand_in {
        None => facing.reflected(simd, octaves, V3::all(simd, [1.0; 3])),
        Some((shares, colour)) => {
            let (seen_in_sky, level) = facing.reflected(simd, octaves, shares);
            (seen_in_sky + colour - tables.smooth(FIRST_LIGHT, shares, seen).0, level)
        }
    };
    let light = on_screen(colour * power_of_two(level + exposure));
    let place = octaves * tables.sunlit_per_octave + tables.sunlit_at_rest;
    shown(
        effects,
        light,
        #[inline(always)]
        || tables.unseen(FIRST_SUNLIT, place),
    )
}

/// The row of red paint at rest in shifted daylight, before those of green and of blue paint.
const FIRST_LIGHT: usize = FIRST_SUNLIT + 2 * PAINTS;
/// The row of white paint in the tables.
const WHITE_ROW: usize = FIRST_SUNLIT + WHITE;
