//! The street's daylight as what moves receives it.
//!
//! It rests on the street and comes equally from all sides there, as under an overcast sky above pale ground:
//! so what rests is lit as by a lamp of its own. A body that moves at beta receives it from the direction w',
//! in its own frame, with D = 1/(gamma (1 - beta w'_x)), as [`sunlit`](crate::colour::sunlit) has it, crowded
//! and blue ahead. What a surface with the normal n' reflects of it, as a matt one does, is the mean over its
//! hemisphere, weighted by the cosine: a sum of shifted daylight over w'_x, of which the weight follows from
//! the angle between n' and the motion alone. It is taken from the table of [`sky`](super::sky), whose error
//! is told there.
//!
//! A point that turns is lit as what it is, a surface with its own velocity: where a wheel touches the road,
//! it is lit as the road is.

use std::f64::consts::{LN_2, PI};

use glam::DVec3;
use relativity_core::math::{asinh, atan2, cos, exp2, hypot, log2, sinh};

use crate::kinematics::spin::Spin;
use crate::view::group_view::GroupView;

/// The largest gamma beta that a surface is lit with: its square is a number in f32, and light of one that is
/// faster is not told from that by any table.
pub const MOST_RAPID: f64 = 1e15;

/// Samples of a share.
const SHARE_SAMPLES: u32 = 8;

/// The motion of a surface through the street's light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facing {
    /// gamma beta on the street.
    pub rapid: f64,
    /// The cosine of the angle between the surface's normal and its motion, in its own frame.
    pub ahead: f64,
}

impl Facing {
    /// Takes the surface at `place` with `rest_normal`, which may turn about `spin`, in the frame of the
    /// group of `view`.
    pub(crate) fn new(view: &GroupView, spin: Option<&Spin>, place: DVec3, rest_normal: DVec3) -> Self {
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

    /// Returns the motion with 2^`head_on_octaves` for the Doppler factor of light from ahead, of a surface
    /// whose normal has this [`turn`](Self::turn).
    pub(crate) fn of(head_on_octaves: f64, turn: f64) -> Self {
        let rapid = sinh_of_octaves(head_on_octaves);
        let time = sinh_of_octaves(-cos(PI * turn) * head_on_octaves);
        Self { rapid, ahead: if rapid > 0.0 { (time / rapid).clamp(-1.0, 1.0) } else { -cos(PI * turn) } }
    }

    /// log2 of the Doppler factor of the street's light from straight ahead.
    pub(crate) fn head_on_octaves(self) -> f64 {
        octaves_of_sinh(self.rapid)
    }

    /// The turn of the normal from backwards, 0, to ahead, 1.
    ///
    /// In the frame of the street the normal is a four-vector, whose rapidity lies between those of the
    /// motion and against it: its share is minus the cosine of pi times this. So the cone into which light
    /// crowds ahead has as many turns at any speed, and the edge of the hemisphere moves evenly with them.
    pub(crate) fn turn(self) -> f64 {
        let [of_normal, of_motion] = [self.rapid * self.ahead, self.rapid].map(octaves_of_sinh);
        let share = (of_normal / of_motion.max(f64::MIN_POSITIVE)).clamp(-1.0, 1.0);
        atan2((1.0 - share * share).sqrt(), -share) / PI
    }

    /// log2 of the mean Doppler factor of the photons that it receives, of light that is none the brighter
    /// for it: power over photons. In the frame of the street its hemisphere is a cap of the sky, over which
    /// both are polynomials.
    #[must_use]
    pub fn mean_octaves(self) -> f64 {
        let (gamma, time) = (hypot(self.rapid, 1.0), self.rapid * self.ahead);
        let length = hypot(time, 1.0);
        // gamma (1 + a) (3 - a) / 3 with a = time / length.
        log2(gamma / length * (1.0 - time / (3.0 * length))) + octaves_of_sinh(time)
    }

    /// The share of the light that is received with 2^`octaves` times the frequency, per octave, but for a
    /// factor, for what moves.
    fn share(self, octaves: f64) -> f64 {
        let Self { rapid, ahead } = self;
        let gamma = hypot(rapid, 1.0);
        let beta = rapid / gamma;
        // 1 - beta w, and 1 - w.
        let slowed = exp2(-octaves) / gamma;
        let aside = (slowed - 1.0 / (gamma * gamma * (1.0 + beta))) / beta;
        if (0.0..=2.0).contains(&aside) { slowed * seen_share(ahead, aside) } else { 0.0 }
    }

    /// Returns the shares of the light within each of `count` places, `per_octave` to an octave, the first of
    /// them around 2^`first` times the frequency: they add up to 1. Light that is shifted by less than half a
    /// place is not.
    pub(crate) fn shares(self, first: f64, per_octave: f64, count: usize) -> Vec<f64> {
        let mut shares = vec![0.0; count];
        if self.head_on_octaves() * per_octave < 0.5 {
            shares[(-first * per_octave).round() as usize] = 1.0;
            return shares;
        }
        let offs =
            || (0..SHARE_SAMPLES).map(|sample| (f64::from(sample) + 0.5) / f64::from(SHARE_SAMPLES) - 0.5);
        // No light is shifted by more than that from straight ahead.
        let farthest = self.head_on_octaves() + 1.0 / per_octave;
        let is_reached = |place: &usize| (first + *place as f64 / per_octave).abs() <= farthest;
        for place in (0..count).filter(is_reached) {
            shares[place] = offs().map(|off| self.share(first + (place as f64 + off) / per_octave)).sum();
        }
        let sum: f64 = shares.iter().sum();
        for share in &mut shares {
            *share /= sum;
        }
        shares
    }
}

/// log2 of e to what has this hyperbolic sine.
fn octaves_of_sinh(sinh: f64) -> f64 {
    asinh(sinh) / LN_2
}

fn sinh_of_octaves(octaves: f64) -> f64 {
    sinh(octaves * LN_2)
}

/// The mean, over the directions at an angle to the motion with the cosine 1 - `aside`, of the cosine of
/// their angle to a normal, but for a factor; 0 for those behind the surface. The normal's angle to the
/// motion has the cosine `ahead`.
fn seen_share(ahead: f64, aside: f64) -> f64 {
    let along = ahead * (1.0 - aside);
    let squared = (1.0 - ahead * ahead) * aside * (2.0 - aside) - along * along;
    let root = squared.max(0.0).sqrt();
    along * atan2(root, -along) + root
}

#[cfg(test)]
mod tests {
    use std::array::from_fn;

    use super::*;

    const BETAS: [f64; 4] = [0.1, 0.5, 0.9, 0.99];
    const AHEAD: [f64; 9] = [-1.0, -0.9, -0.6, -0.3, 0.0, 0.3, 0.6, 0.9, 1.0];

    fn facing(beta: f64, ahead: f64) -> Facing {
        Facing { rapid: beta / (1.0 - beta * beta).sqrt(), ahead }
    }

    /// The number of photons and the power that a matt face receives, in closed form.
    #[test]
    fn photons_and_power_are_those_of_the_closed_forms() {
        const STEPS: i32 = 40_000;
        for beta in BETAS {
            for ahead in AHEAD {
                let gamma = 1.0 / (1.0_f64 - beta * beta).sqrt();
                let time = gamma * beta * ahead;
                let length = (1.0 + time * time).sqrt();
                let a = time / length;
                let facing = facing(beta, ahead);
                let (mut sums, reach) = ([0.0; 3], facing.head_on_octaves());
                for step in 0..STEPS {
                    let octaves = reach * (f64::from(2 * step + 1) / f64::from(STEPS) - 1.0);
                    let share = facing.share(octaves);
                    sums = from_fn(|i| sums[i] + share * exp2([0.0, 3.0, 4.0][i] * octaves));
                }
                let photons = length * (1.0 + a).powi(2);
                let power = gamma * length * (1.0 + a).powi(3) * (3.0 - a) / 3.0;
                let found = [sums[1] / sums[0], sums[2] / sums[0]];
                for (found, closed) in found.into_iter().zip([photons, power]) {
                    assert!((found / closed - 1.0).abs() < 1e-3, "{beta}, {ahead}: {found} {closed}");
                }
                let mean = (power / photons).log2();
                assert!((facing.mean_octaves() - mean).abs() < 1e-9, "{beta}, {ahead}: {mean}");
            }
        }
    }

    #[test]
    fn a_motion_is_found_from_its_octaves_and_turn() {
        for beta in BETAS {
            for ahead in AHEAD {
                let known = facing(beta, ahead);
                let found = Facing::of(known.head_on_octaves(), known.turn());
                assert!((found.rapid / known.rapid - 1.0).abs() < 1e-9, "{known:?} {found:?}");
                assert!((found.ahead - known.ahead).abs() < 1e-7, "{known:?} {found:?}");
            }
            let head_on = 0.5 * ((1.0 + beta) / (1.0 - beta)).log2();
            assert!((facing(beta, 0.0).head_on_octaves() - head_on).abs() < 1e-9);
        }
        assert_eq!([-1.0, 1.0].map(|ahead| facing(0.6, ahead).turn()), [0.0, 1.0]);
    }

    #[test]
    fn no_speed_gives_a_place_that_is_no_number() {
        for exponent in -320..=40 {
            for ahead in AHEAD {
                let facing = Facing { rapid: 10.0_f64.powi(exponent).min(MOST_RAPID), ahead };
                let [head_on, mean] = [facing.head_on_octaves(), facing.mean_octaves()];
                assert!(head_on.is_finite() && mean.is_finite(), "1e{exponent}, {ahead}: {mean}");
                assert!((0.0..=1.0).contains(&facing.turn()), "1e{exponent}, {ahead}: {}", facing.turn());
            }
        }
    }
}
