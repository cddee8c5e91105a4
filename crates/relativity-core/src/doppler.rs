//! Received wavelength and intensity, from the Doppler factor.
//!
//! References: the paper, section 2(b) (exponent 2); D. Weiskopf, *Visualization of four-dimensional
//! spacetimes*, dissertation, Tuebingen 2001 (exponents 3 and 4); U. Kraus, *Brightness and color of
//! rapidly moving objects*, Am. J. Phys. 68 (2000).

use crate::math;

/// Exponent of the paper's received intensity.
pub const PAPER_INTENSITY_EXPONENT: f64 = 2.0;
/// Exponent of the specific intensity (spectral radiance, `I_nu`) of a surface: `I_nu / nu^3` is
/// invariant.
pub const SPECIFIC_INTENSITY_EXPONENT: f64 = 3.0;
/// Exponent of the bolometric radiance of a surface, the specific intensity integrated over frequency.
pub const BOLOMETRIC_INTENSITY_EXPONENT: f64 = 4.0;

/// Received over rest intensity, D^`exponent`.
///
/// # Domain
///
/// Any finite exponent; the result overflows to inf or underflows to 0 as D^n does.
///
/// # Accuracy
///
/// As [`crate::sighting`], whose D it takes, with the factor n that its error gets. Measured up to the fourth
/// power (`tests/oracle`, 15,000 inputs): median 0.2, 99 % 4, worst 5 units.
///
/// # Examples
///
/// ```
/// use relativity_core::doppler::{BOLOMETRIC_INTENSITY_EXPONENT, intensity_factor};
///
/// assert_eq!(intensity_factor(2.0, BOLOMETRIC_INTENSITY_EXPONENT), 16.0);
/// ```
#[must_use]
pub fn intensity_factor(doppler_factor: f64, exponent: f64) -> f64 {
    if exponent == PAPER_INTENSITY_EXPONENT {
        doppler_factor * doppler_factor
    } else {
        math::powf(doppler_factor, exponent)
    }
}

/// Wavelength received, from the wavelength at rest (same unit) and the Doppler factor.
///
/// # Examples
///
/// ```
/// use relativity_core::doppler::received_wavelength;
///
/// assert_eq!(received_wavelength(700.0, 2.0), 350.0);
/// ```
#[must_use]
pub fn received_wavelength(rest_wavelength: f64, doppler_factor: f64) -> f64 {
    rest_wavelength / doppler_factor
}
