//! When a point of a wheel is seen, or is somewhere: by how much later than its hub, by the clocks of the rest frame.
//!
//! |P - o| - |C - o| = (2 v.q + q.q)/(|P - o| + |C - o|) with v = C - o and q = P - C: with times from when the hub is
//! seen and distances from its own, nothing cancels however far the camera is.

use num_traits::Float;

use crate::math;

/// Most steps by Newton's method.
pub const NEWTON_STEPS: u32 = 20;
/// Most steps of the root's search in f64: those, and the bisections after which the bracket is as narrow as a rounding of
/// its first width.
pub const MAX_STEPS: u32 = NEWTON_STEPS + f64::MANTISSA_DIGITS + 1;

/// By how much later than the hub a point `r` from it is seen, by the clocks of the rest frame: the root in [-r, r].
///
/// `hub` is from the camera's event, in the rest frame; `phase` is the point's angle when the hub is seen, which falls by
/// `omega` per unit of time. |omega r| is below 1.
///
/// # Accuracy
///
/// To a rounding or two of r over 1 + v.n', v being the point's velocity and n' the unit vector towards it, which is at
/// least 1 - |omega r|: by so much the root moves as its equation does.
///
/// At most [`MAX_STEPS`]. Measured
#[must_use]
pub fn seen_later<F: Float>(hub: [F; 3], r: F, phase: F, omega: F) -> F {
    let [x, y, z] = hub;
    let far = (x * x + y * y + z * z).sqrt();
    root([-r, r], |later| {
        let (sine, cosine) = math::sin_cos(phase - omega * later);
        let (qx, qz) = (r * cosine, r * sine);
        let (px, pz) = (x + qx, z + qz);
        let distance = (px * px + y * y + pz * pz).sqrt().max(F::min_positive_value());
        let farther = ((x + px) * qx + (z + pz) * qz) / (distance + far);
        // dq/dt' = omega (qz, -qx).
        (later + farther, F::one() + omega * (px * qz - pz * qx) / distance)
    })
}

/// By how much later than the hub a point `r` from it is where it is at one time of the ground, by the clocks of the rest
/// frame: the root in [-r, r] of later = -`beta q_x`, Kepler's equation. Otherwise as [`seen_later`].
#[must_use]
pub fn measured_later<F: Float>(beta: F, r: F, phase: F, omega: F) -> F {
    root([-r, r], |later| {
        let (sine, cosine) = math::sin_cos(phase - omega * later);
        (later + beta * r * cosine, F::one() + beta * r * omega * sine)
    })
}

/// The root in a bracket of a function that rises there, from its value and slope: by Newton's method from the middle as long
/// as that stays inside and its steps shrink, else by bisection.
pub(crate) fn root<F: Float>([mut low, mut high]: [F; 2], function: impl Fn(F) -> (F, F)) -> F {
    let half = F::one() / (F::one() + F::one());
    let resolution = half * half * F::epsilon() * (high - low);
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
        let shrinks = (newton - at).abs() <= half * last;
        let is_newton = step < NEWTON_STEPS && shrinks && newton >= low && newton <= high;
        let next = if is_newton { newton } else { half * (low + high) };
        last = (next - at).abs();
        at = next;
        if last <= resolution || value.abs() <= resolution {
            break;
        }
    }
    at
}
