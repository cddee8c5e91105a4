//! What the C library computes: the one module through which this project reaches it.
//!
//! IEEE 754 fixes the last digit of `+ - * /`, `sqrt` and `mul_add`, which are the same on every platform and are
//! used as the methods they are. The functions here it does not fix: each platform's library rounds them in its own
//! way, so that results may differ in their last digits between platforms (and on one platform never). Whoever wants
//! the same bits everywhere replaces this module.

use num_traits::Float;

macro_rules! functions {
    ($($(#[$doc:meta])+ $name:ident($($argument:ident),+);)+) => {$(
        $(#[$doc])+
        #[must_use]
        #[inline]
        pub fn $name<F: Float>($($argument: F),+) -> F {
            F::$name($($argument),+)
        }
    )+};
}

functions! {
    /// sin(x), x in radians.
    sin(x);
    /// cos(x), x in radians.
    cos(x);
    /// tan(x), x in radians.
    tan(x);
    /// The angle in [-pi/2, pi/2] whose sine is x; NaN outside [-1, 1].
    asin(x);
    /// The angle in [-pi/2, pi/2] whose tangent is x.
    atan(x);
    /// The angle in [-pi, pi] from the x axis to (x, y).
    atan2(y, x);
    /// sqrt(x^2 + y^2), where no square overflows or underflows.
    hypot(x, y);
    /// e^x.
    exp(x);
    /// e^x - 1, without cancellation near 0.
    exp_m1(x);
    /// 2^x.
    exp2(x);
    /// The natural logarithm of x; NaN below 0.
    ln(x);
    /// The logarithm of x to the base 2; NaN below 0.
    log2(x);
    /// The decimal logarithm of x; NaN below 0.
    log10(x);
    /// x^exponent; NaN for x below 0 unless the exponent is whole.
    powf(x, exponent);
    /// The hyperbolic sine of x.
    sinh(x);
    /// The hyperbolic cosine of x.
    cosh(x);
    /// The hyperbolic tangent of x.
    tanh(x);
    /// The number whose hyperbolic sine is x.
    asinh(x);
    /// The number whose hyperbolic tangent is x; NaN outside [-1, 1].
    atanh(x);
}

/// (sin(x), cos(x)), x in radians.
#[must_use]
#[inline]
pub fn sin_cos<F: Float>(x: F) -> (F, F) {
    x.sin_cos()
}
