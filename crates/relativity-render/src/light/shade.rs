//! Light and shade: what a hit looks like.

use glam::DVec3;

use super::daylight::Facing;
use super::hatch::Hatch;
use super::screen_light::{Light, ScreenLight};
use crate::colour::paint::Paint;
use crate::scene::prepared_body::PreparedBody;
use crate::view::effects::Constant;
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

/// Light that arrives from a surface: of one with the outward unit normal `rest_normal` in the rest frame.
#[derive(Debug, Clone, Copy)]
pub struct Received {
    /// The outward unit normal of the surface, rest frame.
    pub rest_normal: DVec3,
    /// The Doppler factor of its light.
    pub doppler_factor: f64,
    /// The motion of the surface through the street's daylight, if that lights it.
    pub facing: Option<Facing>,
    /// Paint of a model there, white of other bodies.
    pub paint: Paint,
    /// Position in the picture, px.
    pub place: [f64; 2],
}

/// Linear sRGB, in [0, 1], of the surface of `body` with `rest_normal`, received at `doppler_factor` in
/// the pixel around `place`, px; `facing` the street's daylight, if that lights it.
///
/// Form and the body's brightness come after the shoulder: so they show in what is very bright, and in what
/// is all but black.
#[must_use]
pub fn surface_colour(
    appearance: &Appearance,
    body: &PreparedBody,
    Received { rest_normal, doppler_factor, facing, paint, place }: Received,
    hatch: &Hatch,
) -> [f64; 3] {
    let shading = match appearance.shading {
        Shading::Emission => 1.0,
        Shading::Form => form(rest_normal),
    };
    let light = Light::new(body.emission, appearance);
    let ScreenLight { colour, unseen } = light.shown_facing(appearance, doppler_factor, facing, paint);
    let hatched = hatch.colour(unseen, place);
    std::array::from_fn(|i| (colour[i] + hatched[i]) * shading * body.brightness)
}
