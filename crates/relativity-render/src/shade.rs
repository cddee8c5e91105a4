//! Light and shade: what a hit looks like.

use glam::DVec3;
use relativity_core::doppler::{intensity_factor, received_wavelength};
use relativity_core::math;

use crate::colour::linear_srgb;
use crate::effects::Constant;
use crate::prepared_body::PreparedBody;
use crate::view::{Appearance, Shading};

/// Direction to the light of [`form`], before normalising: over the viewer's left shoulder.
pub const LIGHT: DVec3 = DVec3::new(-0.35, -0.55, 0.76);
/// Brightness of a surface at right angles to the light, and how much turning towards it adds.
pub const FORM: [f64; 2] = [0.62, 0.38];

/// The shaders' constants of [`form`].
pub(crate) fn constants() -> [Constant; 5] {
    let [x, y, z] = LIGHT.normalize().to_array();
    [("LIGHT_X", x), ("LIGHT_Y", y), ("LIGHT_Z", z), ("FORM_ACROSS", FORM[0]), ("FORM_TOWARDS", FORM[1])]
}

/// Gentle shading that shows form, 0.24 to 1: fixed to the rest frame, so that it moves with the body
/// and is no effect of relativity. `rest_normal` is the outward unit normal in the rest frame.
#[must_use]
pub fn form(rest_normal: DVec3) -> f64 {
    FORM[0] + FORM[1] * rest_normal.dot(LIGHT.normalize())
}

/// Linear sRGB (0 or more, may exceed 1) of the surface of `body` with `rest_normal`, received at `doppler_factor`.
#[must_use]
pub fn surface_colour(
    appearance: &Appearance,
    body: &PreparedBody,
    rest_normal: DVec3,
    doppler_factor: f64,
) -> [f64; 3] {
    let colour = body.emission.wavelength_nm().map_or([1.0; 3], |rest_nm| {
        let nm =
            if appearance.doppler_shift { received_wavelength(rest_nm, doppler_factor) } else { rest_nm };
        linear_srgb(nm, appearance.colour)
    });
    let intensity = appearance.intensity_exponent.map_or(1.0, |n| intensity_factor(doppler_factor, n));
    let shading = match appearance.shading {
        Shading::Emission => 1.0,
        Shading::Form => form(rest_normal),
    };
    // A product that overflows is as bright as can be, not infinite: black times infinity is no number.
    let brightness =
        (intensity * shading * body.brightness * math::exp2(appearance.exposure_ev)).min(f64::MAX);
    colour.map(|part| part * brightness)
}
