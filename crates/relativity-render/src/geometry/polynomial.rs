//! First fall of a quartic through zero inside an interval.
//!
//! The roots come from `polycool`, which isolates them between the roots of the derivative: unlike the closed
//! form this never misses a pair of roots through cancellation, however the coefficients are scaled.
//! Reference: C. Yuksel, *High-performance polynomial root finding for graphics* (2022).

use polycool::Quartic;

/// The first place inside `[low, high]` where the polynomial with `coefficients` (constant first) turns
/// from positive to negative.
///
/// # Accuracy
///
/// It is where the polynomial as evaluated changes its sign: within a few units in the last place of the
/// interval's ends for simple roots. A double root that rounding lifts off zero is not one.
#[must_use]
pub fn first_descent(coefficients: &[f64; 5], [low, high]: [f64; 2]) -> Option<f64> {
    let quartic = Quartic::new(*coefficients);
    let error = 0.5 * f64::EPSILON * low.abs().max(high.abs());
    let roots = quartic.roots_between(low, high, error);
    // Each root is a change of sign: from a positive start the first falls, else the second.
    let falls = usize::from(quartic.eval(low) < 0.0);
    roots.get(falls).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coefficients of (x - r0)(x - r1)(x - r2)(x - r3), constant first.
    fn with_roots(roots: [f64; 4]) -> [f64; 5] {
        let mut product = [1.0, 0.0, 0.0, 0.0, 0.0];
        for root in roots {
            let shifted = [0.0, product[0], product[1], product[2], product[3]];
            product = std::array::from_fn(|i| shifted[i] - root * product[i]);
        }
        product
    }

    #[test]
    fn the_first_descent_is_the_first_or_third_of_four_roots() {
        let quartic = with_roots([-2.0, -0.5, 0.25, 3.0]);
        for (interval, expected) in [
            ([-9.0, 9.0], Some(-2.0)),
            ([-1.9, 9.0], Some(0.25)),
            ([-0.4, 0.2], None),
            ([-0.4, 0.3], Some(0.25)),
            ([3.1, 9.0], None),
        ] {
            let found = first_descent(&quartic, interval);
            match expected {
                None => assert_eq!(found, None, "{interval:?}"),
                Some(root) => assert!((found.expect("a root") - root).abs() < 1e-14, "{interval:?}"),
            }
        }
    }

    #[test]
    fn close_pairs_of_roots_are_not_missed() {
        for gap in [1e-3, 1e-5, 1e-7] {
            let quartic = with_roots([0.5, 0.5 + gap, 4.0, 5.0]);
            let found = first_descent(&quartic, [-1.0, 3.0]).expect("a root");
            // The quartic's slope at the root is about 16 gap; its value is good to about 1e-15.
            assert!((found - 0.5).abs() < 1e-15 / gap, "gap {gap:e}: off by {:e}", found - 0.5);
        }
    }

    #[test]
    fn missing_powers_are_no_obstacle() {
        assert_eq!(first_descent(&[1.0, -2.0, 0.0, 0.0, 0.0], [0.0, 1.0]), Some(0.5));
        let root = first_descent(&[1.0, 0.0, -4.0, 0.0, 0.0], [0.0, 1.0]).expect("a root");
        assert!((root - 0.5).abs() < 1e-15);
    }
}
