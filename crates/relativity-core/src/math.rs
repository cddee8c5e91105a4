//! Functions whose last digit IEEE 754 leaves to whoever computes them: the one module through which this
//! project reaches them.
//!
//! `+ - * /`, `sqrt` and `mul_add` are the same on every platform and are used as the methods they are. These
//! here each platform's C library rounds in its own way. So none of those is asked: all are computed by
//! `libm`, a translation of musl's, which is the same everywhere. Its errors are below one unit in the last
//! place for most, at most a few for the hyperbolic ones. It takes 0.6 times as long as glibc for `atan2` and
//! `sin_cos`, 1.6 times for `exp` and `ln`, 3.4 times for `powf` (x86-64).

use num_traits::Float;

macro_rules! functions {
    ($($(#[$doc:meta])+ $name:ident = $single:ident, $double:ident($($argument:ident),+);)+) => {
        /// A number that has the functions of this module: `f32` or `f64`.
        pub trait Elementary: Float {
            $(
                #[doc(hidden)]
                fn $name($($argument: Self),+) -> Self;
            )+
            #[doc(hidden)]
            fn sin_cos(x: Self) -> (Self, Self);
        }

        functions!(f32, libm::sincosf, $($name = $single($($argument),+);)+);
        functions!(f64, libm::sincos, $($name = $double($($argument),+);)+);

        $(
            $(#[$doc])+
            #[must_use]
            #[inline]
            pub fn $name<F: Elementary>($($argument: F),+) -> F {
                <F as Elementary>::$name($($argument),+)
            }
        )+
    };
    ($number:ident, $sin_cos:path, $($name:ident = $function:ident($($argument:ident),+);)+) => {
        impl Elementary for $number {
            $(
                #[inline]
                fn $name($($argument: Self),+) -> Self {
                    libm::$function($($argument),+)
                }
            )+
            #[inline]
            fn sin_cos(x: Self) -> (Self, Self) {
                $sin_cos(x)
            }
        }
    };
}

functions! {
    /// sin(x), x in radians.
    sin = sinf, sin(x);
    /// cos(x), x in radians.
    cos = cosf, cos(x);
    /// tan(x), x in radians.
    tan = tanf, tan(x);
    /// The angle in [-pi/2, pi/2] whose sine is x; NaN outside [-1, 1].
    asin = asinf, asin(x);
    /// The angle in [-pi/2, pi/2] whose tangent is x.
    atan = atanf, atan(x);
    /// The angle in [-pi, pi] from the x axis to (x, y).
    atan2 = atan2f, atan2(y, x);
    /// sqrt(x^2 + y^2), where no square overflows or underflows.
    hypot = hypotf, hypot(x, y);
    /// Returns e^x.
    exp = expf, exp(x);
    /// e^x - 1, without cancellation near 0.
    exp_m1 = expm1f, expm1(x);
    /// Returns 2^x.
    exp2 = exp2f, exp2(x);
    /// The natural logarithm of x; NaN below 0.
    ln = logf, log(x);
    /// ln(1 + x), without cancellation near 0; NaN below -1.
    ln_1p = log1pf, log1p(x);
    /// The logarithm of x to the base 2; NaN below 0.
    log2 = log2f, log2(x);
    /// The decimal logarithm of x; NaN below 0.
    log10 = log10f, log10(x);
    /// x^exponent; NaN for x below 0 unless the exponent is whole.
    powf = powf, pow(x, exponent);
    /// The hyperbolic sine of x.
    sinh = sinhf, sinh(x);
    /// The hyperbolic cosine of x.
    cosh = coshf, cosh(x);
    /// The hyperbolic tangent of x.
    tanh = tanhf, tanh(x);
    /// The natural logarithm of the magnitude of the gamma function of x.
    ln_gamma = lgammaf, lgamma(x);
    /// The number whose hyperbolic sine is x.
    asinh = asinhf, asinh(x);
    /// The number whose hyperbolic tangent is x; NaN outside [-1, 1].
    atanh = atanhf, atanh(x);
}

/// (sin(x), cos(x)), x in radians.
#[must_use]
#[inline]
pub fn sin_cos<F: Elementary>(x: F) -> (F, F) {
    <F as Elementary>::sin_cos(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By how many units in the last place the larger of two numbers differs from the other.
    fn units(a: f64, b: f64) -> f64 {
        let size = a.abs().max(b.abs()).max(f64::MIN_POSITIVE);
        (a - b).abs() / size / (0.5 * f64::EPSILON)
    }

    #[test]
    fn another_library_computes_nearly_the_same() {
        type Pair = (fn(f64) -> f64, fn(f64) -> f64, [f64; 2]);
        let pairs: [Pair; 18] = [
            (sin, f64::sin, [-30.0, 30.0]),
            (cos, f64::cos, [-30.0, 30.0]),
            (tan, f64::tan, [-1.5, 1.5]),
            (asin, f64::asin, [-1.0, 1.0]),
            (atan, f64::atan, [-30.0, 30.0]),
            (|x| atan2(x, -1.3), |x| x.atan2(-1.3), [-30.0, 30.0]),
            (|x| hypot(x, 1.3), |x| x.hypot(1.3), [-30.0, 30.0]),
            (exp, f64::exp, [-30.0, 30.0]),
            (exp_m1, f64::exp_m1, [-3.0, 3.0]),
            (exp2, f64::exp2, [-30.0, 30.0]),
            (ln, f64::ln, [1e-9, 30.0]),
            (log2, f64::log2, [1e-9, 30.0]),
            (log10, f64::log10, [1e-9, 30.0]),
            (|x| powf(x, 2.4), |x| x.powf(2.4), [0.0, 30.0]),
            (sinh, f64::sinh, [-30.0, 30.0]),
            (cosh, f64::cosh, [-30.0, 30.0]),
            (tanh, f64::tanh, [-3.0, 3.0]),
            (|x| sin_cos(x).0 + sin_cos(x).1, |x| x.sin() + x.cos(), [0.0, 1.5]),
        ];
        for (place, (ours, theirs, [low, high])) in pairs.into_iter().enumerate() {
            for step in 0..10_000 {
                let x = low + (high - low) * f64::from(step) / 9_999.0;
                let apart = units(ours(x), theirs(x));
                assert!(apart <= 4.0, "function {place} at {x}: {apart} units");
            }
        }
    }

    #[test]
    fn what_is_undone_comes_back() {
        for step in -4_000..4_000 {
            let x = f64::from(step) / 100.0;
            assert!(units(x, asinh(sinh(x))) <= 8.0, "{x}");
            // A relative error of e^x is an absolute one of x.
            assert!(units(x, ln(exp(x))) <= 4.0 + 4.0 / x.abs(), "{x}");
        }
        for step in -99..100 {
            let x = f64::from(step) / 100.0;
            assert!(units(x, tanh(atanh(x))) <= 8.0);
        }
    }
}
