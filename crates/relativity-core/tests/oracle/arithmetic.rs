//! An independent oracle: the physics from its definitions, in 115-digit arithmetic.
//!
//! The light cone is the textbook quadratic for the retarded time, with nothing rearranged: the digits that
//! cancel are simply carried. Errors are measured in units of
//! `2^-53 (|f| + sum |x_i df/dx_i|)`: what rounding the result once and each input once does.

use dashu_float::FBig;
use dashu_float::ops::Abs;
use dashu_float::round::mode::HalfEven;

/// A number with 384 bits of significand. At gamma = 1e13 the quadratic loses 170 of them, and the
/// difference quotients 100 more.
pub type Big = FBig<HalfEven, 2>;

const BITS: usize = 384;

/// An f64, exactly.
pub fn big(value: f64) -> Big {
    Big::try_from(value).expect("inputs are finite").with_precision(BITS).value()
}

pub fn square(x: &Big) -> Big {
    x * x
}

pub fn sqrt(x: &Big) -> Big {
    x.sqrt()
}

/// atan2 with the convention of IEEE 754 that atan2(0, 0) = 0.
pub fn atan2(y: &Big, x: &Big) -> Big {
    if *y == Big::ZERO && *x == Big::ZERO { big(0.0) } else { y.atan2(x) }
}

/// A quantity's true value, and the size of one unit of error for it.
#[derive(Debug)]
struct Truth {
    value: Big,
    unit: f64,
}

impl Truth {
    /// Returns the error of `computed`, in units.
    fn error_units(&self, computed: f64) -> f64 {
        if !computed.is_finite() {
            return f64::INFINITY;
        }
        let error = (big(computed) - &self.value).abs().to_f64().value();
        if error == 0.0 { 0.0 } else { error / self.unit }
    }
}

/// Errors of `computed` in units of `f` at `inputs`, for arithmetic with the given unit roundoff.
///
/// The unit's derivatives are those at the inputs. Where a value is further off than `bound`, the slopes of
/// the chords over `bound` roundings of each input count too: near a jump (of phi, say, where a point passes
/// through X = 0 close to the x-z plane) the derivative says nothing about what roundings do.
pub fn error_units<const N: usize>(
    f: impl Fn(&[Big]) -> [Big; N],
    inputs: &[f64],
    computed: [f64; N],
    unit_roundoff: f64,
    bound: f64,
) -> [f64; N] {
    let tangent = truths(&f, inputs, unit_roundoff, &[STEP]);
    let errors: [f64; N] = std::array::from_fn(|k| tangent[k].error_units(computed[k]));
    if errors.iter().all(|&error| error <= bound) {
        return errors;
    }
    let reach = bound * unit_roundoff;
    let chord = truths(&f, inputs, unit_roundoff, &[reach, -reach]);
    std::array::from_fn(|k| errors[k].min(chord[k].error_units(computed[k])))
}

/// True values and units, from the steepest of the chords from each input to `1 + step` of it.
fn truths<const N: usize>(
    f: impl Fn(&[Big]) -> [Big; N],
    inputs: &[f64],
    unit_roundoff: f64,
    steps: &[f64],
) -> [Truth; N] {
    let exact: Vec<Big> = inputs.iter().map(|&x| big(x)).collect();
    let values = f(&exact);
    let mut sums: [f64; N] = std::array::from_fn(|k| values[k].clone().abs().to_f64().value());
    for i in 0..inputs.len() {
        if inputs[i] == 0.0 {
            continue;
        }
        let mut steepest = [0.0_f64; N];
        for &step in steps {
            let mut moved = exact.clone();
            moved[i] = &moved[i] * (big(1.0) + big(step));
            let ends = f(&moved);
            for (k, slope) in steepest.iter_mut().enumerate() {
                *slope = slope.max(((&ends[k] - &values[k]) / big(step)).abs().to_f64().value());
            }
        }
        for (sum, slope) in sums.iter_mut().zip(steepest) {
            *sum += slope;
        }
    }
    let mut sums = sums.into_iter();
    values.map(|value| Truth { value, unit: unit_roundoff * sums.next().expect("one sum per value") })
}

/// Relative step of the difference quotients, 2^-100.
const STEP: f64 = f64::from_bits((1023 - 100) << 52);

/// Unit roundoff of f64.
pub const UNIT_F64: f64 = f64::EPSILON / 2.0;
/// Unit roundoff of f32.
pub const UNIT_F32: f64 = f32::EPSILON as f64 / 2.0;
