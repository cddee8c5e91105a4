//! What the shaders know of one aperture's picture: the uniform block, rounded once from f64.

use bytemuck::{Pod, Zeroable};
use glam::{DVec2, DVec3};

use crate::camera::{Axes, Camera};
use crate::palette;
use crate::view::{Appearance, View};

/// Mirror of the shaders' `Frame`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Frame {
    base: [f32; 4],
    right: [f32; 4],
    down: [f32; 4],
    pole: [f32; 4],
    speed: [f32; 4],
    light: [f32; 4],
    ground: [f32; 4],
}

impl Frame {
    pub fn new(view: &View, appearance: &Appearance) -> Self {
        let camera = &view.camera;
        let Axes { right, up, .. } = camera.gaze.axes();
        let per_px = 1.0 / camera.focal_length_px();
        let (pole, base) = pole(camera);
        let speed = &view.speed;
        let [first, per_octave] = palette::scale(appearance.colour);
        let exposure = appearance.exposure_ev.exp2();
        let exponent = appearance.intensity_exponent.unwrap_or(0.0);
        let aperture = camera.aperture;
        let has_ground = f64::from(u8::from(appearance.ground_z.is_some()));
        let ground = appearance.ground_z.unwrap_or(0.0) - aperture.z;
        let coarse = pole.as_vec2();
        let fine = (pole - coarse.as_dvec2()).as_vec2();
        Self {
            base: vector(base),
            right: vector(right * per_px),
            down: vector(-up * per_px),
            pole: [coarse.x, coarse.y, fine.x, fine.y],
            speed: [speed.beta(), speed.one_minus_beta(), 1.0 / speed.gamma(), speed.gamma()]
                .map(|v| v as f32),
            light: [exposure, exponent, first, per_octave].map(|v| v as f32),
            ground: [aperture.x, aperture.y, ground, has_ground].map(|v| v as f32),
        }
    }
}

fn vector(v: DVec3) -> [f32; 4] {
    v.as_vec3().extend(0.0).to_array()
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
