//! Logarithms and powers of two, by sums and products alone: so they have the same digits on every processor.

use std::f64::consts::{LN_2, SQRT_2};

use fearless_simd::{Bytes as _, i32x8};

use crate::simd::lanes::{F, Simd, SimdFloat as _, SimdInt as _, all, clamp, select};

/// Digits of a float after the point, and what is added to its exponent.
const DIGITS: u32 = 23;
const BIAS: i32 = 127;

/// log2 of `x`, a normal number above 0: within 2e-7 of its own size.
#[inline(always)]
pub fn log2<S: Simd>(x: F<S>) -> F<S> {
    // log2 m = 2/ln 2 artanh s, with s = (m - 1)/(m + 1).
    const fn term(power: f64) -> f32 {
        (2.0 / LN_2 / power) as f32
    }
    let simd = x.simd;
    let bits = simd.reinterpret_i32_f32x8(x);
    let mantissa = float((bits & ((1 << DIGITS) - 1)) | (BIAS << DIGITS));
    let exponent: F<S> = ((bits >> DIGITS) - BIAS).to_float();
    let is_above = mantissa.simd_gt(SQRT_2 as f32);
    let near_one = select(is_above, mantissa * 0.5, mantissa);
    let s = (near_one - 1.0) / (near_one + 1.0);
    let square = s * s;
    let high = square * (square * term(9.0) + term(7.0)) + term(5.0);
    let part = s * (square * (square * high + term(3.0)) + term(1.0));
    select(is_above, exponent + 1.0, exponent) + part
}

/// The largest power of two that [`power_of_two`] gives; the least is its inverse.
const MOST_POWER: f32 = 100.0;

/// 2^`x`, `x` held between -100 and 100: within 2e-7 of its own size.
#[inline(always)]
pub fn power_of_two<S: Simd>(x: F<S>) -> F<S> {
    // e^(f ln 2), up to the seventh power.
    const TERMS: [f32; 8] = {
        let mut terms = [1.0; 8];
        let (mut term, mut power) = (1.0, 1);
        while power < 8 {
            term *= LN_2 / power as f64;
            terms[power] = term as f32;
            power += 1;
        }
        terms
    };
    let simd = x.simd;
    let inside = clamp(x, all(simd, -MOST_POWER), all(simd, MOST_POWER));
    let whole = inside.round_ties_even();
    let f = inside - whole;
    let high = f * (f * (f * TERMS[7] + TERMS[6]) + TERMS[5]) + TERMS[4];
    let part = f * (f * (f * (f * high + TERMS[3]) + TERMS[2]) + TERMS[1]) + TERMS[0];
    let exponent: i32x8<S> = whole.to_int();
    part * float((exponent + BIAS) << DIGITS)
}

#[inline(always)]
fn float<S: Simd>(bits: i32x8<S>) -> F<S> {
    F::from_bytes(bits.to_bytes())
}

#[cfg(test)]
mod tests {
    use relativity_core::math;

    use super::*;
    use crate::cpu::packets::testing::at_every_level;
    use crate::simd::lanes::{LANES, SimdFrom as _};

    #[test]
    fn both_have_all_digits_of_floats() {
        let values: Vec<f32> = (0..4000).map(|i| (f32::from(i as i16) - 2000.0) * 0.0499 + 1e-3).collect();
        at_every_level!(simd => {
            let mut worst: f64 = 0.0;
            for x in values.as_chunks::<LANES>().0 {
                let power = power_of_two(F::simd_from(simd, *x));
                let back = log2(power);
                let near_one = power_of_two(F::simd_from(simd, *x) * 1e-3);
                let small = log2(near_one);
                for lane in 0..LANES {
                    let [x, power, back, near_one, small] =
                        [x[lane], power[lane], back[lane], near_one[lane], small[lane]].map(f64::from);
                    let off = [power / math::exp2(x) - 1.0, back / math::log2(power) - 1.0, small / math::log2(near_one) - 1.0];
                    worst = off.into_iter().map(f64::abs).fold(worst, f64::max);
                }
            }
            assert!(worst < 2e-7, "{worst}");
        });
    }
}
