//! The shoulder: how light brighter than a screen is shown without being cut off.
//!
//! On the largest component x of a linear colour: s(x) = x up to the knee k, and above it s(x) = k + (1 - k)
//! u/(1 + u) with u = (x - k)/(1 - k). So s rises everywhere, with a slope that has no jump, and reaches 1
//! nowhere. All components are scaled alike, which keeps hue and saturation. `shaders/colour.wgsl` has the
//! same.

use crate::view::effects::Constant;

/// Up to here light is shown as it is.
pub const KNEE: f64 = 0.6;
/// Brightest value whose byte differs from that of 1.
pub(crate) const BRIGHTEST: f64 = 0.998;

/// Returns the constant of the shader.
pub(crate) fn constants() -> [Constant; 1] {
    [("KNEE", KNEE)]
}

/// s(`x`), for `x` of 0 or more.
#[must_use]
pub fn shoulder(x: f64) -> f64 {
    if x <= KNEE {
        return x;
    }
    let above = (x - KNEE) / (1.0 - KNEE);
    KNEE + (1.0 - KNEE) * (1.0 - 1.0 / (1.0 + above))
}

/// `linear` (components 0 or more) as a screen shows it, in [0, 1].
#[must_use]
pub fn toned(linear: [f64; 3]) -> [f64; 3] {
    scaled(linear, shoulder)
}

/// Returns the value that [`toned`] turned into `shown`; values shown as 1 and more are taken for a little
/// less.
///
/// Further components, no larger than the colour's, are scaled with it.
#[must_use]
pub fn untoned<const N: usize>(shown: [f64; N]) -> [f64; N] {
    scaled(shown, |y| {
        if y <= KNEE {
            return y;
        }
        let left = (1.0 - y.min(BRIGHTEST)) / (1.0 - KNEE);
        KNEE + (1.0 - KNEE) * (1.0 / left - 1.0)
    })
}

fn scaled<const N: usize>(linear: [f64; N], curve: impl Fn(f64) -> f64) -> [f64; N] {
    let largest = linear.into_iter().fold(0.0, f64::max);
    if largest <= KNEE {
        return linear;
    }
    let factor = curve(largest) / largest;
    linear.map(|part| part * factor)
}
