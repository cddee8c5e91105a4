//! The street's daylight as surfaces receive it: `shaders/daylight.wgsl` on the CPU.
//! [`crate::light::daylight`] derives it.

use super::colour::LightKind;
use super::tables::{ScreenLights, Tables, on_screen, shown};
use crate::colour::sunlit::{PAINTS, WHITE};
use crate::cpu::packets::logarithm::{MOST_POWER, log2, power_of_two};
use crate::cpu::packets::wheel::spin::velocity_at;
use crate::cpu::packets::wheel::turning::TurningBody;
use crate::light::daylight::{LEAST_BETA, MOST_RAPID, PARTS};
use crate::light::palette::FIRST_SUNLIT;
use crate::scene::wheel::packed::Turns;
use crate::simd::lanes::{F, Simd, SimdFloat as _, V2, V3, all, clamp, select};
use crate::view::effects::Effects;

/// The motion of surfaces through the street's light.
#[derive(Debug, Clone, Copy)]
pub struct Facings<S: Simd> {
    /// gamma beta on the street.
    pub rapid: F<S>,
    /// The cosine, in their own frame, of the angle between their normal and their motion.
    pub ahead: F<S>,
}

/// The numbers that all parts of the received light share.
#[derive(Clone, Copy)]
struct SharedNumbers<S: Simd> {
    gamma: F<S>,
    beta: F<S>,
    /// 1 - beta, to the last digit near the speed of light.
    below_light: F<S>,
    /// beta as parts are weighted by it, and 1 less that.
    weighed: F<S>,
    beside: F<S>,
    ahead: F<S>,
    /// The sine to `ahead`.
    across: F<S>,
}

/// A part of the light that surfaces receive.
#[derive(Clone, Copy)]
struct LightPart<S: Simd> {
    /// The share of it, but for a factor.
    share: F<S>,
    log2_doppler: F<S>,
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

impl<S: Simd> SharedNumbers<S> {
    #[inline(always)]
    fn new(simd: S, Facings { rapid, ahead }: Facings<S>) -> Self {
        const LEAST: f32 = LEAST_BETA as f32;
        let gamma = (rapid * rapid + 1.0).sqrt();
        let beta = rapid / gamma;
        let below_light = 1.0 / (gamma * gamma * (beta + 1.0));
        let is_slow = beta.simd_lt(LEAST);
        let weighed = beta.max(LEAST);
        let beside = select(is_slow, all(simd, 1.0 - LEAST), below_light);
        let across = (1.0 - ahead * ahead).max(0.0).sqrt();
        Self { gamma, beta, below_light, weighed, beside, ahead, across }
    }

    /// log2 of 1 - beta w of the hottest light, and of the coldest over that.
    #[inline(always)]
    fn ends(self, simd: S) -> [F<S>; 2] {
        let Self { weighed, beside, ahead, across, .. } = self;
        let (zero, one) = (all(simd, 0.0), all(simd, 1.0));
        let faces_back = ahead.simd_lt(0.0);
        let hottest = beside + select(faces_back, weighed * ahead * ahead / (across + 1.0), zero);
        let coldest = weighed * select(faces_back, one, across) + 1.0;
        [log2(hottest), log2(coldest / hottest)]
    }

    /// The part at this `place`, from the hottest to the coldest, with this `weight`.
    #[inline(always)]
    fn part(self, simd: S, [first, octaves]: [F<S>; 2], [place, weight]: [f64; 2]) -> LightPart<S> {
        let Self { gamma, beta, below_light, weighed, beside, ahead, across } = self;
        let slowed = power_of_two(octaves * (place as f32) + first);
        let aside = clamp((slowed - beside) / weighed, all(simd, 0.0), all(simd, 2.0));
        let along = ahead * (1.0 - aside);
        let sideways = across * (aside * (2.0 - aside)).max(0.0).sqrt();
        let one = all(simd, 1.0);
        let half_turn = arc_cosine(simd, clamp(-along / sideways.max(1e-9), -one, one));
        let seen = along * half_turn + (sideways * sideways - along * along).max(0.0).sqrt();
        let log2_doppler = -log2(gamma * (below_light + beta * aside));
        LightPart { share: slowed * seen * (weight as f32), log2_doppler }
    }
}

/// The angle with this cosine, within 7e-5: M. Abramowitz, I. A. Stegun, *Handbook of Mathematical
/// Functions*, 4.4.45.
#[inline(always)]
fn arc_cosine<S: Simd>(simd: S, cosine: F<S>) -> F<S> {
    let x = cosine.abs();
    let sum = x * (x * (x * -0.018_729_3 + 0.074_261) - 0.212_114_4) + 1.570_728_8;
    let angle = (1.0 - x).max(0.0).sqrt() * sum;
    select(cosine.simd_lt(all(simd, 0.0)), std::f32::consts::PI - angle, angle)
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
    let course = SharedNumbers::new(simd, facing);
    let ends = course.ends(simd);
    let seen = shift * tables.sunlit_per_octave + tables.sunlit_at_rest;
    // The shares of the smooth paint that stands for it, and what is left of its colour.
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
    let paint = stand_in.map(|(shares, colour)| {
        let smooth = tables.smooth(FIRST_LIGHT, shares, seen).0;
        (shares, colour - smooth)
    });
    let mut sum = V3::all(simd, [0.0; 3]);
    let (mut shares, mut beyond, mut hottest) = (all(simd, 0.0), all(simd, 0.0), all(simd, 0.0));
    for (i, node) in PARTS.into_iter().enumerate() {
        let LightPart { share, log2_doppler } = course.part(simd, ends, node);
        let place = (shift + log2_doppler) * tables.sunlit_per_octave + tables.sunlit_at_rest;
        let (colour, level) = match paint {
            None => tables.colour(WHITE_ROW, place),
            Some((paint, rest)) => {
                let (smooth, level) = tables.smooth(FIRST_LIGHT, paint, place);
                (smooth + rest, level)
            }
        };
        let power = level + exposure;
        if i == 0 {
            // Beyond what floats hold all are held back alike: so their mixture keeps its hue.
            beyond = (power - MOST_POWER).max(0.0);
            hottest = place;
        }
        sum += colour * (power_of_two(power - beyond) * share);
        shares += share;
    }
    let light = on_screen(sum * (1.0 / shares.max(1e-30)));
    shown(effects, light, || tables.unseen(FIRST_SUNLIT, hottest))
}

/// The row of red paint at rest in shifted daylight, before those of green and of blue paint.
const FIRST_LIGHT: usize = FIRST_SUNLIT + 2 * PAINTS;
/// The row of white paint in the tables.
const WHITE_ROW: usize = FIRST_SUNLIT + WHITE;
