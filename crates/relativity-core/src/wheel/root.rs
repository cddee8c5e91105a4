//! When a point of a wheel is seen, or is somewhere: by how much later than its hub, by the clocks of the
//! rest frame.
//!
//! |P - o| - |C - o| = (2 v.q + q.q)/(|P - o| + |C - o|) with v = C - o and q = P - C: with
//! times from when the hub is seen and distances from its own, nothing cancels however far the camera is.

use crate::math::{self, Elementary};

/// Greatest number of steps by Newton's method.
pub const NEWTON_STEPS: u32 = 20;
/// Greatest number of steps of the search for the root in f64: Newton's, and the bisections after which the
/// bracket is as narrow as a rounding of its first width.
pub const MAX_STEPS: u32 = NEWTON_STEPS + f64::MANTISSA_DIGITS + 1;

/// Returns the delay of the emission that is seen of a point `r` from the hub, after the one seen of the hub,
/// by the clocks of the rest frame: the root in [-r, r].
///
/// `hub` is from the camera's event, in the rest frame; `phase` is the point's angle when the hub is seen,
/// which falls by `omega` per unit of time. |omega r| is below 1.
///
/// # Accuracy
///
/// Within 4 r epsilon/(1 + v.n'), epsilon being 2^-52 or in f32 2^-23, v the point's velocity and n' the unit
/// vector towards it: by so much the root moves as its equation rounds, at most 1/(1 - |omega r|) times as
/// much as at rest. That is for inputs as they are; a rounding of `phase` moves the root by as much again.
///
/// At most [`MAX_STEPS`] steps; measured over all angles, near and far, up to |omega r| = 1 - 1e-9: 5 on
/// average, at most 12 in 99 %, 51 in the worst case.
#[must_use]
pub fn seen_later<F: Elementary>(hub: [F; 3], r: F, phase: F, omega: F) -> F {
    root([-r, r], light_cone(hub, r, phase, omega))
}

/// Returns a function of the point's delay after the hub: by how much its light would arrive too late, and
/// the derivative of that.
fn light_cone<F: Elementary>([x, y, z]: [F; 3], r: F, phase: F, omega: F) -> impl Fn(F) -> (F, F) {
    let far = (x * x + y * y + z * z).sqrt();
    let angle = turning_from(phase, omega);
    move |later| {
        let (sine, cosine) = angle(later);
        let (qx, qz) = (r * cosine, r * sine);
        let (px, pz) = (x + qx, z + qz);
        let distance = (px * px + y * y + pz * pz).sqrt().max(F::min_positive_value());
        let farther = ((x + px) * qx + (z + pz) * qz) / (distance + far);
        // dq/dt' = omega (qz, -qx).
        (later + farther, F::one() + omega * (px * qz - pz * qx) / distance)
    }
}

/// Returns the delay, by the clocks of the rest frame, of a point `r` from the hub after the hub, both at one
/// time of the ground: the root in [-r, r] of later = -`beta q_x`, Kepler's equation. Otherwise as
/// [`seen_later`].
#[must_use]
pub fn measured_later<F: Elementary>(beta: F, r: F, phase: F, omega: F) -> F {
    let angle = turning_from(phase, omega);
    root([-r, r], |later| {
        let (sine, cosine) = angle(later);
        (later + beta * r * cosine, F::one() + beta * r * omega * sine)
    })
}

/// Returns sine and cosine of `phase` - `omega` later; only the small part is rounded afresh each time.
fn turning_from<F: Elementary>(phase: F, omega: F) -> impl Fn(F) -> (F, F) {
    let (sine, cosine) = math::sin_cos(phase);
    move |later| {
        let (s, c) = math::sin_cos(omega * later);
        (sine * c - cosine * s, cosine * c + sine * s)
    }
}

/// The root in a bracket of a function that rises there, from its value and slope: by Newton's method from
/// the middle as long as that stays inside and its steps shrink, else by bisection.
pub(crate) fn root<F: Elementary>([mut low, mut high]: [F; 2], function: impl Fn(F) -> (F, F)) -> F {
    let half = F::one() / (F::one() + F::one());
    let resolution = half * half * F::epsilon() * (high - low);
    let noise = F::epsilon() * (high - low);
    let mut at = half * (low + high);
    let mut last = high - low;
    for step in 0..MAX_STEPS {
        let (value, slope) = function(at);
        if value > F::zero() {
            high = at;
        } else {
            low = at;
        }
        let newton = at - value / slope;
        let is_inside = newton >= low && newton <= high;
        if value.abs() <= noise {
            return if is_inside { newton } else { at };
        }
        let shrinks = (newton - at).abs() <= half * last;
        let next = if step < NEWTON_STEPS && shrinks && is_inside { newton } else { half * (low + high) };
        last = (next - at).abs();
        at = next;
        if last <= resolution {
            break;
        }
    }
    at
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::f64::consts::TAU;

    use super::*;

    /// v, and hubs before the camera's event: far, near, beside the wheel and nearly in it.
    const SPEEDS: [f64; 7] = [0.0, 0.1, 0.5, 0.9, 0.99, 0.9999, 1.0 - 1e-9];
    const HUBS: [[f64; 3]; 6] = [
        [30.0, 3.0, 2.0],
        [-30.0, 3.0, 2.0],
        [0.125, 3.0, 0.25],
        [-200.0, 0.5, 0.125],
        [0.25, 0.0625, 0.375],
        [1e6, 1.0, 1.0],
    ];
    const R: f64 = 0.525;
    const PHASES: u32 = 1000;

    fn phases() -> impl Iterator<Item = f64> {
        (0..PHASES).map(|i| TAU * f64::from(i) / f64::from(PHASES))
    }

    #[test]
    fn few_steps_lead_to_the_root() {
        let mut counts = Vec::new();
        for v in SPEEDS {
            for (hub, phase) in HUBS.into_iter().flat_map(|hub| phases().map(move |phase| (hub, phase))) {
                let (function, steps) = (light_cone(hub, R, phase, v / R), Cell::new(0));
                let later = root([-R, R], |at| {
                    steps.set(steps.get() + 1);
                    function(at)
                });
                assert!(function(later).0.abs() <= 4.0 * f64::EPSILON * R, "{v} {hub:?} {phase}");
                counts.push(steps.get());
            }
        }
        counts.sort_unstable();
        let mean = f64::from(counts.iter().sum::<u32>()) / counts.len() as f64;
        let most = counts[counts.len() * 99 / 100];
        assert!(mean < 5.5 && most <= 12, "{mean} on average, {most} in 99 %");
        assert!(counts.last() <= Some(&MAX_STEPS), "{:?}", counts.last());
    }

    /// Rounded like a shader's input: from what both hold exactly.
    #[test]
    fn in_single_precision_it_is_as_accurate_as_its_equation() {
        let single = |value: f64| value as f32;
        let r = single(R);
        let mut worst = 0.0_f64;
        for v in SPEEDS {
            let omega = single(v / R);
            for (hub, phase) in HUBS.into_iter().flat_map(|hub| phases().map(move |phase| (hub, phase))) {
                let phase = single(phase);
                let later = f64::from(seen_later(hub.map(single), r, phase, omega));
                let hub = hub.map(single).map(f64::from);
                let function = light_cone(hub, r.into(), phase.into(), omega.into());
                worst = worst.max(function(later).0.abs() / f64::from(f32::EPSILON * r));
            }
        }
        assert!(worst < 4.0, "{worst} r epsilon");
    }

    #[test]
    fn a_wheel_at_one_time_of_the_ground_obeys_keplers_equation() {
        for beta in SPEEDS {
            for phase in phases() {
                let later = measured_later(beta, R, phase, beta / R);
                let x = R * math::cos(phase - beta / R * later);
                assert!((later + beta * x).abs() <= 4.0 * f64::EPSILON * R, "{beta} {phase}");
            }
        }
    }
}
