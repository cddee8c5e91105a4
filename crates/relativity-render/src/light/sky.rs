//! The street's daylight as matt surfaces reflect it that move through it: a table.
//!
//! What smooth paint sends of the light of a hemisphere is a function of three numbers: how fast it moves and
//! how it faces its motion ([`Facing`]), and the Doppler factor on the way to the eye. The table holds it for
//! red, green and blue paint, over log2 D head-on, over the angle between the surface's normal and its motion
//! as its [`turn`](Facing::turn), and over log2 of the Doppler factor of the light's
//! [mean](Facing::mean_octaves), times that on the way to the eye. In these coordinates it is smooth: so it
//! may be read between its entries.
//!
//! # Accuracy
//!
//! A test below holds it against sums over the whole hemisphere, in levels of 255, for all faces that can be
//! seen of bodies that pass, and for riders, where at least a hundredth of the light at rest is received and
//! exposed to a middle grey.

use std::array::from_fn;
use std::sync::{LazyLock, OnceLock};

use relativity_core::math::{exp2, log2};
use relativity_core::threads::prelude::*;

use super::daylight::Facing;
use crate::colour::sunlit::{self, FIRST_OCTAVE};
use crate::view::effects::Constant;

/// Speeds: of the Doppler factors head-on from 1 to 16, which is 0.992 c. What is faster is lit as at the
/// last of them, but for the Doppler factor of the mean.
pub const SPEEDS: usize = 33;
/// Speeds per octave of the Doppler factor head-on.
pub const SPEEDS_PER_OCTAVE: f64 = 8.0;
/// Turns of the normal, from backwards to ahead.
pub const TURNS: usize = 25;
/// Entries of a row, over the Doppler factor: from 0.35 to 358, as much as the last speed seen head-on.
pub const ENTRIES: usize = 640;
/// Entries of a row per octave of the Doppler factor.
pub const PER_OCTAVE: f64 = 64.0;
/// Entries of a speed and turn: a row for red, green and blue paint each.
pub const WIDTH: usize = 3 * ENTRIES;

/// The farthest that the light of a hemisphere is from its mean, entries.
const REACH: usize = 520;
/// Samples of the light within an entry.
const SAMPLES: u32 = 4;
/// Numbers of a cell of light: three components for each of three paints, and the level of white.
const NUMBERS: usize = 10;

/// Daylight, as it is mixed into all entries.
static CELLS: LazyLock<Vec<[f32; NUMBERS]>> = LazyLock::new(|| (0..ENTRIES + 2 * REACH).map(cell).collect());
/// The entries of each speed, from when they are first needed: most scenes have few speeds, and each takes a
/// fiftieth of a second.
static OF_SPEEDS: [OnceLock<Vec<[f32; 4]>>; SPEEDS] = [const { OnceLock::new() }; SPEEDS];

/// Light that smooth paint reflects.
#[derive(Debug, Clone, Copy)]
pub struct Reflected {
    /// Linear sRGB of red, green and blue paint, over the level of white paint.
    pub primaries: [[f64; 3]; 3],
    /// log2 of the level of white paint, beside that at rest.
    pub log2_level: f64,
}

/// Returns the entries of the speed with this number, a row of [`WIDTH`] for each turn: linear sRGB over the
/// level of white paint, and log2 of that.
pub fn at_speed(speed: usize) -> &'static [[f32; 4]] {
    OF_SPEEDS[speed].get_or_init(|| (0..TURNS).flat_map(|turn| entries(&CELLS, speed, turn)).collect())
}

/// Returns the entries of all speeds, for the shaders.
pub fn table() -> Vec<[f32; 4]> {
    (0..SPEEDS).into_par_iter().flat_map_iter(|speed| at_speed(speed).iter().copied()).collect()
}

/// Returns the constants of the shaders.
pub fn constants() -> [Constant; 5] {
    [
        ("SKY_SPEEDS", SPEEDS as f64),
        ("SKY_SPEEDS_PER_OCTAVE", SPEEDS_PER_OCTAVE),
        ("SKY_TURNS", TURNS as f64),
        ("SKY_ENTRIES", ENTRIES as f64),
        ("SKY_PER_OCTAVE", PER_OCTAVE),
    ]
}

/// Returns what red, green and blue paint send of the street's daylight, where their surface faces it so, and
/// is seen with 2^`shift` times the frequency.
pub fn reflected(facing: Facing, shift: f64) -> Reflected {
    let octaves = shift + facing.mean_octaves();
    let [speed, turn, place] = [
        (facing.head_on_octaves() * SPEEDS_PER_OCTAVE, SPEEDS),
        (facing.turn() * (TURNS - 1) as f64, TURNS),
        ((octaves - FIRST_OCTAVE) * PER_OCTAVE, ENTRIES),
    ]
    .map(|(place, count)| {
        let inside = place.clamp(0.0, (count - 1) as f64);
        let below = (inside as usize).min(count - 2);
        [(below, 1.0 - (inside - below as f64)), (below + 1, inside - below as f64)]
    });
    let mut found = [[0.0; 4]; 3];
    for (speed, of_speed) in speed {
        for (turn, of_turn) in turn {
            let row = &at_speed(speed)[turn * WIDTH..][..WIDTH];
            for (place, of_place) in place {
                for (primary, found) in found.iter_mut().enumerate() {
                    let entry = row[primary * ENTRIES + place];
                    let share = of_speed * of_turn * of_place;
                    *found = from_fn(|part| found[part] + share * f64::from(entry[part]));
                }
            }
        }
    }
    let last = FIRST_OCTAVE + (ENTRIES - 1) as f64 / PER_OCTAVE;
    let log2_level = found[0][3] + (octaves - last).max(0.0);
    Reflected { primaries: found.map(|[red, green, blue, _]| [red, green, blue]), log2_level }
}

/// Light around an entry of the rows, on average: the first of these is `REACH` entries below their first.
fn cell(number: usize) -> [f32; NUMBERS] {
    let entry = number as f64 - REACH as f64;
    let mut sum = [0.0; NUMBERS];
    for sample in 0..SAMPLES {
        let off = (f64::from(sample) + 0.5) / f64::from(SAMPLES) - 0.5;
        let octaves = FIRST_OCTAVE + (entry + off) / PER_OCTAVE;
        let level = exp2(sunlit::log2_level(octaves)) / f64::from(SAMPLES);
        let primaries: [[f64; 3]; 3] = from_fn(|primary| {
            sunlit::lit_by_shifted(from_fn(|other| f64::from(u8::from(other == primary))), octaves)
        });
        for (sum, part) in sum.iter_mut().zip(primaries.as_flattened().iter().chain(&[1.0_f64])) {
            *sum += level * part;
        }
    }
    sum.map(|part| part as f32)
}

/// The entries of a speed and turn: the sums of the light, by how much of it is received from where.
fn entries(cells: &[[f32; NUMBERS]], speed: usize, turn: usize) -> Vec<[f32; 4]> {
    let facing = Facing::of(speed as f64 / SPEEDS_PER_OCTAVE, turn as f64 / (TURNS - 1) as f64);
    let mut sums = vec![[0.0_f32; NUMBERS]; ENTRIES];
    // From `REACH` entries below the mean to as many above.
    let first = facing.mean_octaves() - REACH as f64 / PER_OCTAVE;
    let shares = facing.shares(first, PER_OCTAVE, 2 * REACH + 1).into_iter().map(|share| share as f32);
    for (first, share) in shares.enumerate().filter(|(_, share)| *share > 0.0) {
        let light = cells[first..].as_flattened();
        for (sum, light) in sums.as_flattened_mut().iter_mut().zip(light) {
            *sum += share * light;
        }
    }
    let level = |sum: &[f32; NUMBERS]| sum[NUMBERS - 1].max(f32::MIN_POSITIVE);
    let log2_levels: Vec<_> = sums.iter().map(|sum| log2(f64::from(level(sum))) as f32).collect();
    let entry = |primary: usize, number: usize| {
        let sum = &sums[number];
        let [red, green, blue] = from_fn(|part| sum[3 * primary + part] / level(sum));
        [red, green, blue, log2_levels[number]]
    };
    let places = (0..3).flat_map(|primary| (0..ENTRIES).map(move |number| (primary, number)));
    places.map(|(primary, number)| entry(primary, number)).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;
    use crate::colour::sunlit::{lit_by_shifted, log2_level, mixed, on_screen};
    use crate::colour::{luminance, srgb_encoded};
    use crate::light::tone::toned;

    const BETAS: [f64; 7] = [0.003, 0.05, 0.3, 0.5, 0.8, 0.9, 0.99];
    const AHEAD: [f64; 11] = [-1.0, -0.95, -0.8, -0.5, -0.3, -0.1, 0.0, 0.3, 0.6, 0.9, 1.0];
    /// White, and colours that are lit as other light is.
    const PAINTS: [[f64; 3]; 3] = [[1.0; 3], [0.7, 0.1, 0.1], [0.1, 0.3, 0.6]];

    /// Samples the hemisphere about a normal: share and log2 of the Doppler factor of the light from each
    /// ring about the motion, finer where the light is crowded.
    fn hemisphere(beta: f64, ahead: f64) -> Vec<[f64; 2]> {
        let gamma = 1.0 / (1.0 - beta * beta).sqrt();
        let across = (1.0 - ahead * ahead).sqrt();
        let (rings, turns) = (1500, 400);
        let ring = |ring: i32| {
            let edge = |i: i32| PI * (f64::from(i) / f64::from(rings)).powi(3);
            let [near, far] = [ring, ring + 1].map(edge);
            let middle = 0.5 * (near + far);
            let solid = (near.cos() - far.cos()) * TAU / f64::from(turns);
            let of_turn = |turn: i32| {
                let phi = TAU * (f64::from(turn) + 0.5) / f64::from(turns);
                (ahead * middle.cos() + across * middle.sin() * phi.cos()).max(0.0) * solid / PI
            };
            [(0..turns).map(of_turn).sum(), -(gamma * (1.0 - beta * middle.cos())).log2()]
        };
        (0..rings).map(ring).collect()
    }

    fn shown(light: [f64; 3], exposure: f64) -> [f64; 3] {
        toned(on_screen(light).map(|part| part * exposure)).map(|part| 255.0 * srgb_encoded(part))
    }

    /// The levels by which the table is off the sky of a face, seen at 2^`shift`, at most.
    fn levels_off(facing: Facing, sky: &[[f64; 2]], shift: f64) -> f64 {
        let found = reflected(facing, shift);
        let mut worst: f64 = 0.0;
        for paint in PAINTS {
            let sum = sky.iter().fold([0.0; 3], |sum, [share, octaves]| {
                let light = lit_by_shifted(paint, octaves + shift);
                let level = share * log2_level(octaves + shift).exp2();
                from_fn(|part| sum[part] + level * light[part])
            });
            let level = found.log2_level.exp2();
            let of_table = mixed(paint, found.primaries).map(|part| part * level);
            if luminance(on_screen(sum)) > 0.01 {
                let exposure = 0.5 / on_screen(sum).into_iter().fold(0.0, f64::max);
                let [a, b] = [sum, of_table].map(|light| shown(light, exposure));
                worst = a.into_iter().zip(b).map(|(a, b)| (a - b).abs()).fold(worst, f64::max);
            }
        }
        worst
    }

    #[test]
    fn the_table_is_the_sky_within_what_is_promised() {
        let worst = BETAS.map(|beta| {
            let (gamma, mut worst) = (1.0 / (1.0_f64 - beta * beta).sqrt(), 0.0_f64);
            for ahead in AHEAD {
                let across = (1.0_f64 - ahead * ahead).sqrt();
                let (sky, facing) = (hemisphere(beta, ahead), Facing { rapid: gamma * beta, ahead });
                for step in 0..13 {
                    let eye =
                        gamma * (1.0 - beta) * ((1.0 + beta) / (1.0 - beta)).powf(f64::from(step) / 12.0);
                    let from = (1.0 - eye / gamma) / beta;
                    if ahead * from - across * (1.0 - from * from).max(0.0).sqrt() < 0.0 {
                        worst = worst.max(levels_off(facing, &sky, eye.log2()));
                    }
                }
                worst = worst.max(levels_off(facing, &sky, 0.0));
            }
            worst
        });
        println!("off by at most {worst:.2?} of 255 levels at {BETAS:?}");
        for (worst, promised) in worst.into_iter().zip([1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 4.0]) {
            assert!(worst < promised, "{worst} at most {promised}");
        }
    }

    #[test]
    fn what_rests_reflects_daylight_as_it_is() {
        for ahead in AHEAD {
            for octave in [-1.0, -0.3, 0.0, 0.41, 1.3, 5.0] {
                let off = levels_off(Facing { rapid: 0.0, ahead }, &[[1.0, 0.0]], octave);
                assert!(off < 1.0, "{off} levels at {octave}");
            }
        }
    }
}
