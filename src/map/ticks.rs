//! Round numbers for the lines of a grid.

use relativity_core::math;

use crate::plot::round_step;

/// The multiples of a round number (1, 2 or 5 times a power of ten) from `low` to `high`, no more than fit with a
/// distance of `least` between them; and how many decimals tell them apart. None of a range that is empty or no number.
#[must_use]
pub fn ticks([low, high]: [f64; 2], least: f64) -> (Vec<f64>, u8) {
    let is_range = low.is_finite() && high.is_finite() && low < high && least > 0.0;
    let Some(step) = is_range.then(|| round_step(least)).filter(|step| step.is_finite()) else {
        return (Vec::new(), 0);
    };
    let [first, last] = [(low / step).ceil(), (high / step).floor()];
    if last - first > 1000.0 || first.abs().max(last.abs()) > 1e15 {
        return (Vec::new(), 0);
    }
    let decimals = (-math::log10(step).floor()).clamp(0.0, 9.0) as u8;
    // Zero is written without a sign.
    ((first as i64..=last as i64).map(|i| i as f64 * step + 0.0).collect(), decimals)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_as_dense_as_allowed() {
        assert_eq!(ticks([-4.5, 4.9], 1.7), (vec![-4.0, -2.0, 0.0, 2.0, 4.0], 0));
        assert_eq!(ticks([0.0, 0.11], 0.03), (vec![0.0, 0.05, 0.1], 2));
        assert_eq!(ticks([0.0, 3e7], 1e7).0, [0.0, 1e7, 2e7, 3e7]);
    }

    #[test]
    fn what_is_no_range_has_none() {
        for range in [[1.0, 1.0], [f64::NAN, 2.0], [0.0, f64::INFINITY], [1e30, 2e30]] {
            assert!(ticks(range, 1e-3).0.is_empty(), "{range:?}");
        }
    }
}
