//! What the shaders know of one aperture's picture and of one group in it: the uniform block, rounded once from f64.

use bytemuck::{Pod, Zeroable};
use glam::{DVec2, DVec3};

use crate::backdrop::{Backdrop, Floor};
use crate::camera::{Camera, Gauge};
use crate::group_view::{GroupView, reference_of_depths};
use crate::prepared_body::{Extent, packed};
use crate::scene::{PreparedGroup, PreparedScene};
use crate::street::{HOUSES, OPENINGS};
use crate::velocity::Velocity;
use crate::view::{Appearance, Geometry};

/// Mirror of the shaders' `Frame`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Frame {
    /// Line of sight through the pole, unnormalised: its part along the optical axis is 1.
    pub base: [f32; 4],
    /// By how much it changes from one pixel to the next on the right.
    pub right: [f32; 4],
    /// From one pixel to the next below.
    pub down: [f32; 4],
    /// The pole, from which pixels are counted: u and v, px, and what f32 loses of them. It is the pixel towards where
    /// the group comes from, if that is in front, where the last digits of a line of sight matter most; else the middle
    /// of the picture.
    pub pole: [f32; 4],
    /// Of the group against the camera: beta, 1 - beta, 1/gamma, gamma.
    pub speed: [f32; 4],
    /// -1 if the group moves towards -x, else 1; the same of the reference of depths.
    pub motion: [f32; 4],
    /// Where the camera is from the middle between the eyes, where these have one light cone, else 0; reflected so that
    /// the group moves along +x; and 1 if it is not in the middle.
    pub eye: [f32; 4],
    /// `eye` of the reference.
    pub reference_eye: [f32; 4],
    /// `speed` of the reference.
    pub reference_speed: [f32; 4],
    /// `middle` of the reference.
    pub reference_middle: [f32; 4],
    /// Middle of the group from the camera's event, rest frame; and half the reciprocal of its reach.
    pub middle: [f32; 4],
    /// What f32 loses of the middle.
    pub middle_fine: [f32; 4],
    /// Camera x and y, height of the ground above the camera (`f32::MIN` for none), and the published model's aperture
    /// separation.
    pub ground: [f32; 4],
    /// y of the near and the far kerb of a road, equal where there is none; y of house fronts from the camera, 0 where
    /// there are none; 0.
    pub road: [f32; 4],
    /// Height of houses, and shade of their walls.
    pub houses: [[f32; 4]; 4],
    /// What is let into these: from where, how long, and between which heights.
    pub openings: [[f32; 4]; 4],
    /// Linear sRGB of the horizon, the zenith, the ground, its grid's lines, the paint on it, a road; walls, frames, glass,
    /// doors, shops.
    pub backdrop: [[f32; 4]; 11],
    /// Its product with an apparent position is the clip coordinate x.
    pub clip_right: [f32; 4],
    /// y.
    pub clip_up: [f32; 4],
    /// w: the depth along the optical axis.
    pub forward: [f32; 4],
}

impl Frame {
    /// One for each group of `scene`, which its `views` show.
    ///
    pub fn of_groups(scene: &PreparedScene, views: &[GroupView], appearance: &Appearance) -> Vec<Self> {
        let frame = |(view, group): (_, &PreparedGroup)| Self::new(view, appearance, &group.extent);
        let mut frames: Vec<_> = views.iter().zip(scene.groups()).map(frame).collect();
        let reference = frames[reference_of_depths(views)];
        for frame in &mut frames {
            frame.refer_to(&reference);
        }
        frames
    }

    /// Has depths told among the bodies of the group of `reference`.
    fn refer_to(&mut self, reference: &Self) {
        self.motion[1] = reference.motion[0];
        self.reference_eye = reference.eye;
        self.reference_speed = reference.speed;
        self.reference_middle = reference.middle;
    }

    /// That of a group which is its own reference.
    fn new(view: &GroupView, appearance: &Appearance, extent: &Extent) -> Self {
        let camera = &view.camera;
        let (axes, gauge) = (camera.axes(), camera.gauge());
        let [width, height] = camera.size.map(f64::from);
        let to_clip = 2.0 * camera.focal_length_px();
        let per_px = 1.0 / camera.focal_length_px();
        let (pole, base) = pole(camera, &gauge, -view.velocity.direction());
        let aperture = camera.aperture;
        let backdrop = Backdrop::new(camera, appearance);
        let [near_kerb, far_kerb, fronts] = backdrop.street();
        let ground = backdrop.ground_height().unwrap_or(f64::from(f32::MIN));
        let coarse = pole.as_vec2();
        let fine = (pole - coarse.as_dvec2()).as_vec2();
        let from_camera = extent.middle - view.origin;
        let middle = packed(from_camera, 0.5 / extent.reach);
        let [x, y, z, _] = middle;
        let Velocity { speed, .. } = view.velocity;
        let speed =
            [speed.beta(), speed.one_minus_beta(), 1.0 / speed.gamma(), speed.gamma()].map(|v| v as f32);
        let reflection = view.velocity.direction() as f32;
        let is_one_cone = view.geometry == Geometry::OneCone;
        let eye = if is_one_cone { view.velocity.reflected(camera.off_middle) } else { DVec3::ZERO };
        let eye = packed(eye, if eye == DVec3::ZERO { 0.0 } else { 1.0 });
        Self {
            base: vector(base),
            right: vector(axes.right * per_px),
            down: vector(-axes.up * per_px),
            pole: [coarse.x, coarse.y, fine.x, fine.y],
            speed,
            motion: [reflection, reflection, 0.0, 0.0],
            eye,
            reference_eye: eye,
            reference_speed: speed,
            reference_middle: middle,
            middle,
            middle_fine: vector(from_camera - DVec3::new(x.into(), y.into(), z.into())),
            ground: [aperture.x, aperture.y, ground, view.published_separation()].map(|v| v as f32),
            road: [near_kerb, far_kerb, fronts, 0.0].map(|v| v as f32),
            houses: HOUSES.map(|[height, shade]| [height as f32, shade as f32, 0.0, 0.0]),
            openings: OPENINGS.map(|opening| opening.map(|v| v as f32)),
            backdrop: backdrop.colours().map(|colour| vector(colour.into())),
            clip_right: vector(gauge.right * (to_clip / width)),
            clip_up: vector(gauge.up * (to_clip / height)),
            forward: vector(gauge.forward),
        }
    }

    /// What is to be seen below the horizon.
    pub fn floor(&self) -> Floor {
        match (self.ground[2] > f32::MIN, self.road[0] < self.road[1]) {
            (false, _) => Floor::Open,
            (true, false) => Floor::Grid,
            (true, true) if self.road[2] > 0.0 => Floor::Street,
            (true, true) => Floor::Road,
        }
    }
}

fn vector(v: DVec3) -> [f32; 4] {
    packed(v, 0.0)
}

/// The pixel towards the end of the x axis with this sign and its (unnormalised) line of sight, if it is well in
/// front of the camera; else the middle of the picture and what is seen there.
fn pole(camera: &Camera, gauge: &Gauge, sign: f64) -> (DVec2, DVec3) {
    let Gauge { right, up, forward, .. } = *gauge;
    let middle = DVec2::from(camera.size.map(f64::from)) * 0.5;
    let depth = sign * forward.x;
    if depth < 0.05 {
        return (middle, camera.centre());
    }
    let scale = sign * camera.focal_length_px() / depth;
    let pole = middle + DVec2::new(right.x, -up.x) * scale;
    (pole, DVec3::X * (sign / depth))
}
