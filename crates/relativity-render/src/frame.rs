//! What the shaders know of one aperture's picture: the uniform block, rounded once from f64.

use bytemuck::{Pod, Zeroable};
use glam::{DVec2, DVec3};
use relativity_core::math;

use crate::backdrop::Backdrop;
use crate::camera::{Axes, Camera};
use crate::palette;
use crate::placed::{Extent, packed};
use crate::view::{Appearance, View};

/// Mirror of the shaders' `Frame`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Frame {
    /// Line of sight through the pole, unnormalised: 1 along the optical axis, or along -x.
    pub base: [f32; 4],
    /// By how much it changes from one pixel to the next on the right.
    pub right: [f32; 4],
    /// From one pixel to the next below.
    pub down: [f32; 4],
    /// The pole, from which pixels are counted: u and v, px, and what f32 loses of them. It is the pixel towards -x if
    /// that is in front, where the last digits of a line of sight matter most; else the middle of the picture.
    pub pole: [f32; 4],
    /// beta, 1 - beta, 1/gamma, gamma.
    pub speed: [f32; 4],
    /// Factor of the exposure, intensity exponent (0 for none), log2 of the colour table's first wavelength (nm), and
    /// its entries per octave.
    pub light: [f32; 4],
    /// Centre of the scene from the camera's event, rest frame; and half the reciprocal of its reach.
    pub scene: [f32; 4],
    /// What f32 loses of the centre.
    pub scene_fine: [f32; 4],
    /// Camera x and y, height of the ground above the camera (`f32::MIN` for none), and the published model's aperture
    /// separation.
    pub ground: [f32; 4],
    /// Linear sRGB of the horizon, the zenith, the ground, the grid's lines and the axes.
    pub backdrop: [[f32; 4]; 5],
    /// Its product with an apparent position is the clip coordinate x.
    pub clip_right: [f32; 4],
    /// y.
    pub clip_up: [f32; 4],
    /// w: the depth along the optical axis.
    pub forward: [f32; 4],
}

impl Frame {
    pub fn new(view: &View, appearance: &Appearance, extent: &Extent) -> Self {
        let camera = &view.camera;
        let Axes { right, up, forward } = camera.gaze.axes();
        let [width, height] = camera.size.map(f64::from);
        let to_clip = 2.0 * camera.focal_length_px();
        let per_px = 1.0 / camera.focal_length_px();
        let (pole, base) = pole(camera);
        let speed = &view.speed;
        let [first, per_octave] = palette::scale(appearance.colour);
        let exposure = math::exp2(appearance.exposure_ev);
        let exponent = appearance.intensity_exponent.unwrap_or(0.0);
        let aperture = camera.aperture;
        let backdrop = Backdrop::new(camera, appearance);
        let ground = backdrop.ground_height().unwrap_or(f64::from(f32::MIN));
        let coarse = pole.as_vec2();
        let fine = (pole - coarse.as_dvec2()).as_vec2();
        let centre = extent.centre - view.rest_origin();
        let coarse_centre = centre.as_vec3();
        Self {
            base: vector(base),
            right: vector(right * per_px),
            down: vector(-up * per_px),
            pole: [coarse.x, coarse.y, fine.x, fine.y],
            speed: [speed.beta(), speed.one_minus_beta(), 1.0 / speed.gamma(), speed.gamma()]
                .map(|v| v as f32),
            light: [exposure, exponent, first, per_octave].map(|v| v as f32),
            scene: coarse_centre.extend((0.5 / extent.reach) as f32).to_array(),
            scene_fine: vector(centre - coarse_centre.as_dvec3()),
            ground: [aperture.x, aperture.y, ground, view.published_separation()].map(|v| v as f32),
            backdrop: backdrop.colours().map(|colour| vector(colour.into())),
            clip_right: vector(right * (to_clip / width)),
            clip_up: vector(up * (to_clip / height)),
            forward: vector(forward),
        }
    }

    /// Whether there is ground to be seen.
    pub fn has_ground(&self) -> bool {
        self.ground[2] > f32::MIN
    }
}

fn vector(v: DVec3) -> [f32; 4] {
    packed(v, 0.0)
}

/// The pixel towards -x and its (unnormalised) line of sight, if it is well in front of the camera; else
/// the middle of the picture and the optical axis.
fn pole(camera: &Camera) -> (DVec2, DVec3) {
    let Axes { right, up, forward } = camera.gaze.axes();
    let middle = DVec2::from(camera.size.map(f64::from)) * 0.5;
    if forward.x > -0.05 {
        return (middle, forward);
    }
    let scale = camera.focal_length_px() / -forward.x;
    let pole = middle + DVec2::new(-right.x, up.x) * scale;
    (pole, DVec3::NEG_X / -forward.x)
}
