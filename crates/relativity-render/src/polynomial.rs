//! Real roots of a polynomial of degree up to 4 inside an interval, by bracketing.
//!
//! Between two neighbouring extrema a polynomial is monotone, so it has at most one root there and a
//! sign change proves it. The extrema are the roots of the derivative, found the same way. Unlike the
//! closed forms this never misses a pair of roots through cancellation, however the coefficients
//! are scaled. Reference: G. E. Collins and R. Loos, *Polynomial real root isolation by
//! differentiation* (1976).

/// At most four roots, ascending.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Roots {
    values: [f64; 4],
    count: usize,
}

impl Roots {
    /// The roots.
    #[must_use]
    pub fn as_slice(&self) -> &[f64] {
        &self.values[..self.count]
    }

    fn push(&mut self, root: f64) {
        self.values[self.count] = root;
        self.count += 1;
    }
}

/// Where the polynomial with `coefficients` (constant first, degree 1 to 4) changes its sign inside
/// `(low, high)`.
///
/// # Accuracy
///
/// A root is where the polynomial as evaluated changes its sign: within a few units in the last place for
/// simple roots. A double root that rounding lifts off zero is not one.
#[must_use]
pub fn sign_changes(coefficients: &[f64], [low, high]: [f64; 2]) -> Roots {
    let mut roots = Roots::default();
    let mut start = low;
    let extrema = if coefficients.len() > 2 { extrema(coefficients, [low, high]) } else { Roots::default() };
    for &end in extrema.as_slice().iter().chain([&high]) {
        if let Some(root) = bracketed_root(coefficients, [start, end]) {
            roots.push(root);
        }
        start = end;
    }
    roots
}

fn extrema(coefficients: &[f64], interval: [f64; 2]) -> Roots {
    let mut derivative = [0.0; 4];
    for (power, coefficient) in coefficients.iter().enumerate().skip(1) {
        derivative[power - 1] = power as f64 * coefficient;
    }
    sign_changes(&derivative[..coefficients.len() - 1], interval)
}

/// Newton's method, kept inside a bracket: it is halved instead whenever a step would leave it or is
/// not half the one before. Ends when a step is lost in the rounding of the bracket's own ends.
fn bracketed_root(coefficients: &[f64], [mut low, mut high]: [f64; 2]) -> Option<f64> {
    let rising = value_and_slope(coefficients, low).0 < 0.0;
    if rising == (value_and_slope(coefficients, high).0 < 0.0) {
        return None;
    }
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
        last_step = (next - x).abs().min(0.5 * last_step.max(high - low));
        x = next;
    }
    Some(x)
}

fn value_and_slope(coefficients: &[f64], x: f64) -> (f64, f64) {
    coefficients.iter().rev().fold((0.0, 0.0), |(value, slope), c| (value * x + c, slope * x + value))
}
