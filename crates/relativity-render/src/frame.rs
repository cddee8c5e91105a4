//! What the shaders know of one aperture's picture: the uniform block, rounded once from f64.

use bytemuck::{Pod, Zeroable};
use glam::{DVec2, DVec3};

use crate::backdrop::Backdrop;
use crate::body::{Body, Shape};
use crate::camera::{Axes, Camera};
use crate::intersect::{Solid, bounding_box};
use crate::palette;
use crate::view::{Appearance, View};

/// Mirror of the shaders' `Frame`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Frame {
    pub base: [f32; 4],
    pub right: [f32; 4],
    pub down: [f32; 4],
    pub pole: [f32; 4],
    pub speed: [f32; 4],
    pub light: [f32; 4],
    pub scene: [f32; 4],
    pub scene_fine: [f32; 4],
    pub ground: [f32; 4],
    pub backdrop: [[f32; 4]; 5],
    pub clip_right: [f32; 4],
    pub clip_up: [f32; 4],
    pub forward: [f32; 4],
}

/// Where the bodies are as a whole, in the rest frame: they are placed from their middle, so that they keep
/// their places among each other however far the camera is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// The middle of a box around the bodies.
    pub centre: DVec3,
    /// From the camera's event to there.
    pub centre_from_camera: DVec3,
    /// Greatest distance of any surface from there, with room for rounding.
    pub reach: f64,
}

impl Extent {
    pub fn new(bodies: &[Body], origin: DVec3) -> Self {
        let solids: Vec<_> = bodies.iter().map(|body| Solid::new(&body.shape)).collect();
        let [low, high] = bounding_box(&solids).unwrap_or([DVec3::ZERO, DVec3::ONE]);
        let centre = 0.5 * (low + high);
        Self { centre, centre_from_camera: centre - origin, reach: 1.001 * low.distance(centre) }
    }
}

/// A shape as the shaders take it: mirror of the start of their `Body`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placed {
    /// From the scene's centre: centre, or one end of a tube; and the radius.
    pub place_radius: [f32; 4],
    /// The other end of a tube, or a ring's unit axis and the radius of its middle circle.
    pub form: [f32; 4],
}

impl Placed {
    /// A ball is a tube whose ends are in one place.
    pub fn new(shape: &Shape, extent: &Extent) -> Self {
        let from_centre = |place: [f64; 3], w: f64| packed(DVec3::from(place) - extent.centre, w);
        let (place_radius, form) = match *shape {
            Shape::Sphere { center, radius } => (from_centre(center, radius), from_centre(center, 0.0)),
            Shape::Tube { from, to, radius } => (from_centre(from, radius), from_centre(to, 0.0)),
            Shape::Ring { center, axis, radius, tube_radius } => {
                (from_centre(center, tube_radius), packed(axis.into(), radius))
            }
        };
        Self { place_radius, form }
    }
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
        let exposure = appearance.exposure_ev.exp2();
        let exponent = appearance.intensity_exponent.unwrap_or(0.0);
        let aperture = camera.aperture;
        let backdrop = Backdrop::new(camera, appearance);
        let ground = backdrop.ground_height().unwrap_or(f64::from(f32::MIN));
        let coarse = pole.as_vec2();
        let fine = (pole - coarse.as_dvec2()).as_vec2();
        let centre = extent.centre_from_camera.as_vec3();
        Self {
            base: vector(base),
            right: vector(right * per_px),
            down: vector(-up * per_px),
            pole: [coarse.x, coarse.y, fine.x, fine.y],
            speed: [speed.beta(), speed.one_minus_beta(), 1.0 / speed.gamma(), speed.gamma()]
                .map(|v| v as f32),
            light: [exposure, exponent, first, per_octave].map(|v| v as f32),
            scene: centre.extend((0.5 / extent.reach) as f32).to_array(),
            scene_fine: vector(extent.centre_from_camera - centre.as_dvec3()),
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

/// For the shaders.
pub fn packed(v: DVec3, w: f64) -> [f32; 4] {
    v.as_vec3().extend(w as f32).to_array()
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
