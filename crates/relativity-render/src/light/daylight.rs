//! The street's daylight as what moves receives it.
//!
//! It rests on the street and comes equally from all sides there, as under an overcast sky above pale ground:
//! so what rests is lit as by a lamp of its own. A body that moves at beta receives it from the direction w',
//! in its own frame, with D = 1/(gamma (1 - beta w'_x)), as [`sunlit`](crate::colour::sunlit) has it, crowded
//! and blue ahead. What a surface with the normal n' reflects of it, as a matt one does, is the mean over its
//! hemisphere, weighted by the cosine: a sum of shifted daylight over w'_x, of which the weight follows from the
//! angle between n' and the motion alone.
//!
//! # An approximation, and its name: daylight in six parts
//!
//! That sum is taken at six places, those of Gauss and Legendre over ln D between the coldest and the hottest
//! light of the hemisphere, with weights that add up to 1. A test below holds it against sums over the whole
//! hemisphere: where at least a hundredth of the light at rest is received, the light from 450 to 620 nm is
//! off by at most 0.006 factors of 2 at 0.5 c, 0.021 at 0.9 c, 0.039 at 0.99 c and 0.09 at 0.999 c.
//!
//! A point that turns is lit as what it is, a surface with its own velocity: where a wheel touches the road,
//! it is lit as the road is.

use glam::DVec3;
use relativity_core::math::{atan2, exp2, hypot, log2};

use crate::kinematics::spin::Spin;
use crate::view::group_view::GroupView;

/// Places of Gauss and Legendre in [0, 1], and their weights.
pub const PARTS: [[f64; 2]; 6] = [
    [0.033_765_242_898_423_99, 0.085_662_246_189_585_17],
    [0.169_395_306_766_867_74, 0.180_380_786_524_069_3],
    [0.380_690_406_958_401_56, 0.233_956_967_286_345_52],
    [0.619_309_593_041_598_4, 0.233_956_967_286_345_52],
    [0.830_604_693_233_132_3, 0.180_380_786_524_069_3],
    [0.966_234_757_101_576, 0.085_662_246_189_585_17],
];
/// Below this speed the parts are weighted as at it: they differ by less than can be seen, and none is the
/// difference of two that are nearly equal.
pub const LEAST_BETA: f64 = 1e-3;
/// The largest gamma beta that a surface is lit with: its square is a number in f32, and light of one that is
/// faster is not told from that by any table.
pub const MOST_RAPID: f64 = 1e15;

/// The motion of a surface through the street's light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facing {
    /// gamma beta on the street.
    pub rapid: f64,
    /// The cosine of the angle between the surface's normal and its motion, in its own frame.
    pub ahead: f64,
}

/// A part of the light that a surface receives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DaylightPart {
    /// The share of it in the sum.
    pub share: f64,
    /// log2 of the Doppler factor with which it is received.
    pub log2_doppler: f64,
}

impl DaylightPart {
    /// The whole light of a lamp that rides along.
    pub const OWN: Self = Self { share: 1.0, log2_doppler: 0.0 };
}

impl Facing {
    /// Takes the surface at `place` with `rest_normal`, which may turn about `spin`, in the frame of the
    /// group of `view`.
    pub fn new(view: &GroupView, spin: Option<&Spin>, place: DVec3, rest_normal: DVec3) -> Self {
        let (on_ground, normal) = (view.on_ground, view.on_ground.reflected(rest_normal));
        let speed = on_ground.speed;
        let own = spin.map_or(DVec3::ZERO, |spin| {
            let omega = spin.omega(on_ground.beta());
            on_ground.reflected(DVec3::Y.cross(spin.off_axle(place)) * omega)
        });
        // The normal of what moves is a four-vector: (n.v, n), scaled to the length 1.
        let turning = normal.dot(own);
        let own_gamma = 1.0 / (1.0 - own.length_squared()).max(f64::MIN_POSITIVE).sqrt();
        let along = speed.gamma() * own_gamma * (speed.beta() + own.x);
        let rapid = hypot(along, own_gamma * own.z).min(MOST_RAPID);
        let scale = (1.0 - turning * turning).max(f64::MIN_POSITIVE).sqrt();
        let time = speed.gamma() * ((turning + speed.beta() * normal.x) / scale);
        Self { rapid, ahead: (time / rapid.max(f64::MIN_POSITIVE)).clamp(-1.0, 1.0) }
    }

    /// The parts of the light that it receives, the hottest first.
    pub fn parts(self) -> [DaylightPart; 6] {
        let Self { rapid, ahead } = self;
        let gamma = hypot(rapid, 1.0);
        let beta = rapid / gamma;
        let below_light = 1.0 / (gamma * gamma * (1.0 + beta));
        // As of which speed they are weighted.
        let (weighed, beside) =
            if beta < LEAST_BETA { (LEAST_BETA, 1.0 - LEAST_BETA) } else { (beta, below_light) };
        let across = (1.0 - ahead * ahead).max(0.0).sqrt();
        // 1 - beta w of the hottest and of the coldest light in the hemisphere.
        let hottest = beside + if ahead < 0.0 { weighed * ahead * ahead / (1.0 + across) } else { 0.0 };
        let coldest = 1.0 + weighed * if ahead < 0.0 { 1.0 } else { across };
        let (first, octaves) = (log2(hottest), log2(coldest / hottest));
        let parts = PARTS.map(|[place, weight]| {
            let slowed = exp2(first + octaves * place);
            // 1 - w.
            let aside = ((slowed - beside) / weighed).clamp(0.0, 2.0);
            let log2_doppler = -log2(gamma * (below_light + beta * aside));
            DaylightPart { share: weight * slowed * seen_share(ahead, across, aside), log2_doppler }
        });
        let sum: f64 = parts.iter().map(|part| part.share).sum();
        parts.map(|part| DaylightPart { share: part.share / sum, ..part })
    }
}

/// The mean, over the directions at an angle to the motion with the cosine 1 - `aside`, of the cosine of
/// their angle to a normal, but for a factor; 0 for those behind the surface. The normal's angle to the
/// motion has the cosine `ahead` and the sine `across`.
fn seen_share(ahead: f64, across: f64, aside: f64) -> f64 {
    let along = ahead * (1.0 - aside);
    let squared = across * across * aside * (2.0 - aside) - along * along;
    let root = squared.max(0.0).sqrt();
    along * atan2(root, -along) + root
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;
    use crate::colour::sunlit;

    const BETAS: [f64; 5] = [0.1, 0.5, 0.9, 0.99, 0.999];
    const AHEAD: [f64; 9] = [-1.0, -0.9, -0.6, -0.3, 0.0, 0.3, 0.6, 0.9, 1.0];

    fn facing(beta: f64, ahead: f64) -> Facing {
        Facing { rapid: beta / (1.0 - beta * beta).sqrt(), ahead }
    }

    /// The factors of 2 by which the parts are off a sum over all directions of the hemisphere, at most, for
    /// what can be seen of such faces and is received at least a hundredth as bright as at rest.
    fn worst_error(beta: f64) -> f64 {
        let gamma = 1.0 / (1.0 - beta * beta).sqrt();
        let mut worst: f64 = 0.0;
        for ahead in AHEAD {
            let across = (1.0 - ahead * ahead).sqrt();
            let sky = hemisphere(beta, ahead);
            for step in 0..13 {
                let eye = gamma * (1.0 - beta) * ((1.0 + beta) / (1.0 - beta)).powf(f64::from(step) / 12.0);
                let from = (1.0 - eye / gamma) / beta;
                if ahead * from - across * (1.0 - from * from).max(0.0).sqrt() >= 0.0 {
                    continue;
                }
                let light = |doppler: f64| sunlit::log2_level(doppler.log2()).exp2();
                let truth: f64 = sky.iter().map(|(share, doppler)| share * light(doppler * eye)).sum();
                if truth > 0.01 {
                    let parts = facing(beta, ahead).parts();
                    let found: f64 =
                        parts.iter().map(|part| part.share * light(part.log2_doppler.exp2() * eye)).sum();
                    worst = worst.max((found / truth).log2().abs());
                }
            }
        }
        worst
    }

    /// Samples the hemisphere about a normal: share and Doppler factor of the light from each direction,
    /// evenly over the disc below the hemisphere, which has the cosine in it, and finer where the light is
    /// crowded.
    fn hemisphere(beta: f64, ahead: f64) -> Vec<(f64, f64)> {
        let gamma = 1.0 / (1.0 - beta * beta).sqrt();
        let across = (1.0 - ahead * ahead).sqrt();
        let (rings, turns) = (1500, 400);
        let mut sky = Vec::new();
        for ring in 0..rings {
            // The angle from the motion, finer ahead.
            let edge = |i: i32| PI * (f64::from(i) / f64::from(rings)).powi(3);
            let [near, far] = [ring, ring + 1].map(edge);
            let middle = 0.5 * (near + far);
            let solid = (near.cos() - far.cos()) * TAU / f64::from(turns);
            let doppler = 1.0 / (gamma * (1.0 - beta * middle.cos()));
            let mut share = 0.0;
            for turn in 0..turns {
                let phi = TAU * (f64::from(turn) + 0.5) / f64::from(turns);
                share += (ahead * middle.cos() + across * middle.sin() * phi.cos()).max(0.0) * solid / PI;
            }
            sky.push((share, doppler));
        }
        sky
    }

    #[test]
    fn six_parts_are_the_sky_within_what_is_promised() {
        let errors = BETAS.map(worst_error);
        println!("off by at most {errors:.4?} factors of 2 at {BETAS:?}");
        for (error, promised) in errors.into_iter().zip([0.001, 0.006, 0.021, 0.039, 0.09]) {
            assert!(error < promised, "{errors:?}");
        }
    }

    /// The number of photons and the power that a matt face receives, in closed form: in the street's frame
    /// its hemisphere is a cap of the sky, over which both are polynomials.
    #[test]
    fn photons_and_power_are_those_of_the_closed_forms() {
        for beta in [0.1, 0.5, 0.9, 0.99] {
            for ahead in AHEAD {
                let gamma = 1.0 / (1.0_f64 - beta * beta).sqrt();
                let time = gamma * beta * ahead;
                let length = (1.0 + time * time).sqrt();
                let a = time / length;
                let closed =
                    [length * (1.0 + a).powi(2), gamma * length * (1.0 + a).powi(3) * (3.0 - a) / 3.0];
                for (power, closed) in [3, 4].into_iter().zip(closed) {
                    let parts = facing(beta, ahead).parts();
                    let sum: f64 =
                        parts.iter().map(|part| part.share * part.log2_doppler.exp2().powi(power)).sum();
                    assert!(
                        (sum / closed - 1.0).abs() < 0.05,
                        "beta {beta}, {ahead}, D^{power}: {sum} {closed}"
                    );
                }
            }
        }
    }

    /// ln D is counted evenly between the ends.
    #[test]
    fn a_face_that_looks_ahead_is_lit_head_on_with_the_greatest_doppler_factor() {
        for beta in BETAS {
            let [hottest, .., coldest] = facing(beta, 1.0).parts();
            let per_place = (coldest.log2_doppler - hottest.log2_doppler) / (PARTS[5][0] - PARTS[0][0]);
            let head_on = hottest.log2_doppler - per_place * PARTS[0][0];
            let expected = 0.5 * ((1.0 + beta) / (1.0 - beta)).log2();
            assert!((head_on - expected).abs() < 1e-9, "{beta}: {head_on} for {expected}");
        }
    }

    #[test]
    fn what_rests_receives_daylight_as_it_is() {
        for ahead in AHEAD {
            let parts = facing(0.0, ahead).parts();
            assert!(parts.iter().all(|part| part.log2_doppler == 0.0), "{parts:?}");
            assert!((parts.iter().map(|part| part.share).sum::<f64>() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn no_speed_gives_a_part_that_is_no_number() {
        for exponent in -30..=40 {
            for ahead in AHEAD {
                let rapid = 10.0_f64.powi(exponent).min(MOST_RAPID);
                let parts = Facing { rapid, ahead }.parts();
                let are_numbers = parts.iter().all(|part| part.share >= 0.0 && part.log2_doppler.is_finite());
                assert!(are_numbers, "1e{exponent}, {ahead}: {parts:?}");
            }
        }
    }
}
