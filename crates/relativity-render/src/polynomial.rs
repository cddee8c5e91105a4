//! Where a quartic first falls through zero inside an interval, by bracketing.
//!
//! Between two neighbouring extrema a polynomial is monotone, so it has at most one root there and a
//! sign change proves it. The extrema of the quartic are the roots of its derivative, found the same way
//! between their own extrema, which are those of a quadratic. Unlike the closed form this never misses a
//! pair of roots through cancellation, however the coefficients are scaled.
//! Reference: G. E. Collins and R. Loos, *Polynomial real root isolation by differentiation* (1976).

/// The first place inside `[low, high]` where the polynomial with `coefficients` (constant first) turns
/// from positive to negative.
///
/// # Accuracy
///
/// It is where the polynomial as evaluated changes its sign: within a few units in the last place of the
/// interval's ends for simple roots. A double root that rounding lifts off zero is not one.
#[must_use]
pub fn first_descent(coefficients: &[f64; 5], [low, high]: [f64; 2]) -> Option<f64> {
    let [_, b, c, d, e] = *coefficients;
    let extrema = cubic_roots(&[b, 2.0 * c, 3.0 * d, 4.0 * e], [low, high]);
    let mut start = low;
    for end in extrema.into_iter().flatten().chain([high]) {
        if value(coefficients, start) > 0.0 && value(coefficients, end) <= 0.0 {
            return Some(bracketed_root(coefficients, [start, end]));
        }
        start = end;
    }
    None
}

/// The roots of a cubic inside `[low, high]` at which it changes its sign, ascending.
fn cubic_roots(coefficients: &[f64; 4], [low, high]: [f64; 2]) -> [Option<f64>; 3] {
    let [_, b, c, d] = *coefficients;
    let extrema = quadratic_roots([b, 2.0 * c, 3.0 * d]);
    // Not clamp: no number (from a cubic that is a straight line) becomes an end, too.
    let [first, second] = extrema.map(|extremum| extremum.max(low).min(high));
    [[low, first], [first, second], [second, high]].map(|bracket| {
        let [falls, rises] = bracket.map(|end| value(coefficients, end) < 0.0);
        (falls != rises).then(|| bracketed_root(coefficients, bracket))
    })
}

/// The real roots of a quadratic (constant first), ascending. Both at minus infinity if there are none;
/// infinite, or no number, what a leading coefficient of 0 leaves out.
fn quadratic_roots([c, b, a]: [f64; 3]) -> [f64; 2] {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return [f64::NEG_INFINITY; 2];
    }
    // Terms of one sign: no cancellation.
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    let [m, n] = [q / a, c / q];
    [m.min(n), m.max(n)]
}

/// The root between `low` and `high`, at which the polynomial's signs differ.
///
/// Newton's method, kept inside a bracket: it is halved instead whenever a step would leave it or is
/// not half the one before. So it ends, at the latest after as many halvings as f64 has bits, when a
/// step is lost in the rounding of the bracket's own ends.
fn bracketed_root<const N: usize>(coefficients: &[f64; N], [mut low, mut high]: [f64; 2]) -> f64 {
    let rising = value(coefficients, low) < 0.0;
    let tolerance = 0.5 * f64::EPSILON * low.abs().max(high.abs());
    let mut last_step = high - low;
    let mut x = 0.5 * (low + high);
    while last_step > tolerance {
        let (value, slope) = value_and_slope(coefficients, x);
        if (value < 0.0) == rising {
            low = x;
        } else {
            high = x;
        }
        let newton = x - value / slope;
        let converges = newton >= low && newton <= high && (newton - x).abs() <= 0.5 * last_step;
        let next = if converges { newton } else { 0.5 * (low + high) };
        last_step = (next - x).abs();
        x = next;
    }
    x
}

fn value(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |value, c| value * x + c)
}

fn value_and_slope(coefficients: &[f64], x: f64) -> (f64, f64) {
    coefficients.iter().rev().fold((0.0, 0.0), |(value, slope), c| (value * x + c, slope * x + value))
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
