//! The uniform block: everything that the shaders know of one aperture's picture and of one group in it,
//! rounded once from f64.

use bytemuck::{Pod, Zeroable};
use glam::{DMat3, DVec2, DVec3};
use relativity_core::math::{cosh, exp, sin_cos, sinh};

use crate::camera::mercator::Mercator;
use crate::camera::{Axes, Camera, Gauge};
use crate::geometry::extent::Extent;
use crate::kinematics::relative_velocity::RelativeVelocity;
use crate::light::hatch::Hatch;
use crate::light::screen_light::packed_exposure;
use crate::scene::prepared_body::packed;
use crate::scene::prepared_scene::{PreparedGroup, PreparedScene};
use crate::street::backdrop::{Backdrop, Floor};
use crate::street::contact::{self, Contacts};
use crate::street::house_fronts::{HOUSES, OPENINGS};
use crate::street::sight::{StreetSight, StreetVariant};
use crate::view::group_view::{GroupView, reference_of_depths};
use crate::view::{Appearance, Geometry};

/// Mirror of the shaders' `FrameUniform`.
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct FrameUniform {
    /// Line of sight through the pole, unnormalised: its part along the optical axis is 1. In a conformal
    /// picture cosh u long. w: the size of a pixel in focal lengths, or in u and v.
    pub base: [f32; 4],
    /// Change of that line from one pixel to the next on the right. In a conformal picture only e^u at the
    /// pole.
    pub right: [f32; 4],
    /// From one pixel to the next below. In a conformal picture the unit vector upwards at the pole, and e^-u
    /// there.
    pub down: [f32; 4],
    /// Unit vector from the baseline to the pole, of a conformal picture.
    pub radial: [f32; 4],
    /// The pole, from which pixels are counted: u and v, px, and what f32 loses of them. It is the pixel
    /// towards where the group comes from, if that is in front, where the last digits of a line of sight
    /// matter most; else the middle of the picture.
    pub pole: [f32; 4],
    /// Speed of the group past the camera: beta, 1 - beta, 1/gamma, gamma.
    pub speed: [f32; 4],
    /// -1 if the group moves towards -x past the camera, else 1; the same of the reference of depths; 1 if
    /// the picture is conformal, else 0; -1 if the group moves towards -x on the ground, else 1.
    pub motion: [f32; 4],
    /// 1 if a group of the picture moves past the camera otherwise than along x, else 0; the same of the
    /// street; 0, 0. All vectors before the camera are in the axes along the group's motion then, else in the
    /// camera's.
    pub oblique: [f32; 4],
    /// Unit vectors along the motion, in the group's axes.
    pub group_axes: [[f32; 4]; 3],
    /// The matrix, as columns, from these vectors before the camera to those of the reference.
    pub reference_axes: [[f32; 4]; 3],
    /// The same to axes along the street's motion.
    pub to_street: [[f32; 4]; 3],
    /// Unit vectors along the street's motion, in the ground's axes.
    pub street_axes: [[f32; 4]; 3],
    /// Height on the ground of what rides along otherwise than along the street: the factors of its place
    /// from the camera, and of its distance, in what is added to its height before the camera.
    pub rising: [f32; 4],
    /// Speed of the group on the ground, as `speed`.
    pub on_ground: [f32; 4],
    /// Place of the camera from the middle between the eyes, if these have one light cone, else 0; in axes
    /// along the group's motion.
    pub eye: [f32; 4],
    /// `eye` of the reference.
    pub reference_eye: [f32; 4],
    /// `speed` of the reference.
    pub reference_speed: [f32; 4],
    /// `middle` of the reference; in a picture of oblique motion in axes along that.
    pub reference_middle: [f32; 4],
    /// Middle of the group from the camera's event, rest frame; and half the reciprocal of its reach.
    pub middle: [f32; 4],
    /// Remainder of the middle that f32 loses.
    pub middle_fine: [f32; 4],
    /// Camera x and y, height of the ground above the camera (`f32::MIN` for none), and the published model's
    /// aperture separation.
    pub ground: [f32; 4],
    /// y of the near and the far kerb of a road, equal where there is none; y of house fronts from the
    /// camera, 0 where there are none; 0.
    pub road: [f32; 4],
    /// Speed of the street against the camera: see [`StreetSight::packed_speed`].
    pub street_speed: [f32; 4],
    /// Direction, geometry and colours of that: see [`StreetSight::packed_motion`].
    pub street_motion: [f32; 4],
    /// Shift of the street's light: see
    /// [`StreetLight::packed`](crate::light::street_light::StreetLight::packed).
    pub street_light: [f32; 4],
    /// Exposure of bodies: its log2, and its factor.
    pub exposure: [f32; 4],
    /// From the middle between the eyes to the camera, where these have one light cone, else 0; how many
    /// places there are where bodies touch a road.
    pub contact_eye: [f32; 4],
    /// The places where bodies touch a road: see [`Contacts::packed`].
    pub contacts: [[[f32; 4]; 2]; contact::MOST],
    /// Height of houses, and shade of their walls.
    pub houses: [[f32; 4]; 4],
    /// Openings in the walls: beginning and length along a house, and the heights between which they lie.
    pub openings: [[f32; 4]; 4],
    /// Linear sRGB of the horizon, the zenith, the ground, its grid's lines, the paint on it, a road; walls,
    /// frames, glass, doors, shops.
    pub backdrop: [[f32; 4]; 11],
    /// The hatch of what eyes do not see: see [`Hatch::packed`].
    pub hatch: [[f32; 4]; 2],
    /// Row of the clip coordinate x: its product with an apparent position. In a conformal picture the unit
    /// vector along the baseline. w: the clip coordinates of a focal length, or of a unit of u.
    pub clip_right: [f32; 4],
    /// y. In a conformal picture the unit vector across the baseline and `forward`. w: the clip coordinates
    /// of a focal length, or of a radian of v.
    pub clip_up: [f32; 4],
    /// w: the depth along the optical axis. In a conformal picture also u in the middle of the picture.
    pub forward: [f32; 4],
}

/// The vectors from which shaders find lines of sight and clip coordinates.
struct Sights {
    pole: DVec2,
    base: [f32; 4],
    right: [f32; 4],
    down: [f32; 4],
    radial: [f32; 4],
    clip_right: [f32; 4],
    clip_up: [f32; 4],
    forward: [f32; 4],
}

impl Sights {
    /// Returns the vectors of `camera`, in the axes of the shaders for a group with this `velocity`.
    fn new(camera: &Camera, velocity: &RelativeVelocity) -> Self {
        let turned = velocity.sight_axes().transpose();
        // The group comes from this end of the x axis.
        let sign = -velocity.sign();
        match camera.mercator() {
            Some(mercator) => Self::conformal(&mercator.turned(|v| turned * v), camera, turned, sign),
            None => Self::flat(camera, turned, sign),
        }
    }

    fn flat(camera: &Camera, turned: DMat3, sign: f64) -> Self {
        let Axes { right, up, .. } = camera.axes();
        let axes = [right, up].map(|v| turned * v);
        let gauge = camera.gauge().turned(|v| turned * v);
        let [width, height] = camera.size.map(f64::from);
        let to_clip = 2.0 * camera.focal_length_px();
        let per_px = 1.0 / camera.focal_length_px();
        let (pole, base) = pole(camera, &gauge, turned, sign);
        Self {
            pole,
            base: packed(base, per_px),
            right: vector(axes[0] * per_px),
            down: vector(-axes[1] * per_px),
            radial: [0.0; 4],
            clip_right: packed(gauge.right * (to_clip / width), to_clip / width),
            clip_up: packed(gauge.up * (to_clip / height), to_clip / height),
            forward: vector(gauge.forward),
        }
    }

    fn conformal(mercator: &Mercator, camera: &Camera, turned: DMat3, sign: f64) -> Self {
        let Axes { right, up, forward } = mercator.axes;
        let [width, height] = camera.size.map(f64::from);
        let per_px = 1.0 / mercator.px_per_unit;
        let (pole, line) = conformal_pole(mercator, camera, turned, DVec3::X * sign);
        let (sine, cosine) = sin_cos(pole.y);
        let radial = forward * cosine + up * sine;
        let middle = mercator.coordinates_at([0.5 * width, 0.5 * height]).x;
        Self {
            pole: DVec2::from(mercator.place_of(pole)),
            base: packed(line, per_px),
            right: packed(DVec3::ZERO, exp(pole.x)),
            down: packed(up * cosine - forward * sine, exp(-pole.x)),
            radial: vector(radial),
            clip_right: packed(right, 2.0 * mercator.px_per_unit / width),
            clip_up: packed(up, 2.0 * mercator.px_per_unit / height),
            forward: packed(forward, middle),
        }
    }
}

/// The farthest that the pole of a conformal picture can be aside, as |u|, to be the place that pixels are
/// counted from: further on, e^-|u| of a rounding is left of what would be lost.
const FARTHEST_POLE: f64 = 5.0;

impl FrameUniform {
    /// Returns one frame for each group of `scene`, as its `views` show them.
    ///
    pub fn of_groups(scene: &PreparedScene, views: &[GroupView], appearance: &Appearance) -> Vec<Self> {
        let frame = |(view, group): (_, &PreparedGroup)| Self::new(view, appearance, &group.extent);
        let mut frames: Vec<_> = views.iter().zip(scene.groups()).map(frame).collect();
        let number = reference_of_depths(views);
        let (reference, to_reference) = (frames[number], views[number].velocity.sight_axes().transpose());
        let is_oblique = views.iter().any(|view| view.velocity.oblique_axes().is_some());
        let contacts = Contacts::new(scene, views, appearance);
        for (frame, view) in frames.iter_mut().zip(views) {
            frame.oblique[0] = f32::from(u8::from(is_oblique));
            frame.refer_to(&reference);
            frame.reference_axes = columns(to_reference * view.velocity.sight_axes());
            if is_oblique {
                let middle = views[number].velocity.motion_from_group(middle_of(&reference));
                frame.reference_middle = packed(middle, reference.middle[3].into());
            }
            (frame.contact_eye, frame.contacts) = (contacts.packed_eye(), contacts.packed());
        }
        frames
    }

    /// Makes depths comparable with those of the group of `reference`.
    fn refer_to(&mut self, reference: &Self) {
        self.motion[1] = reference.motion[0];
        self.reference_eye = reference.eye;
        self.reference_speed = reference.speed;
        self.reference_middle = reference.middle;
    }

    /// Returns the frame of a group that is its own reference.
    fn new(view: &GroupView, appearance: &Appearance, extent: &Extent) -> Self {
        let camera = &view.camera;
        let velocity = &view.velocity;
        let sights = Sights::new(camera, velocity);
        let Sights { pole, base, right, down, radial, clip_right, clip_up, forward } = sights;
        let aperture = camera.aperture;
        let backdrop = Backdrop::new(camera, view.view_geometry, appearance);
        let [near_kerb, far_kerb, fronts] = backdrop.places();
        let street = StreetSight::new(camera, view.view_geometry);
        let street_light = street.light(appearance);
        let ground = backdrop.ground_height().unwrap_or(f64::from(f32::MIN));
        let from_camera = extent.middle - view.origin;
        let middle = packed(from_camera, 0.5 / extent.reach);
        let [x, y, z, _] = middle;
        let speed = velocity.packed_speed();
        let reflection = velocity.sign() as f32;
        let to_street = street.sight_axes().transpose() * velocity.sight_axes();
        let eye = eye(view);
        Self {
            base,
            right,
            down,
            radial,
            pole: coarse_and_fine(pole),
            speed,
            motion: [
                reflection,
                reflection,
                f32::from(u8::from(camera.mercator().is_some())),
                view.on_ground.direction() as f32,
            ],
            oblique: [0.0, f32::from(u8::from(street.is_oblique())), 0.0, 0.0],
            group_axes: columns(velocity.oblique_axes().unwrap_or(DMat3::IDENTITY)),
            reference_axes: columns(DMat3::IDENTITY),
            to_street: columns(to_street),
            street_axes: columns(street.ground_axes()),
            rising: rising(view),
            on_ground: view.on_ground.packed_speed(),
            eye,
            reference_eye: eye,
            reference_speed: speed,
            reference_middle: middle,
            middle,
            middle_fine: vector(from_camera - DVec3::new(x.into(), y.into(), z.into())),
            ground: [aperture.x, aperture.y, ground, view.published_separation()].map(|v| v as f32),
            road: [near_kerb, far_kerb, fronts, 0.0].map(|v| v as f32),
            street_speed: street.packed_speed(),
            street_motion: street.packed_motion(&street_light),
            street_light: street_light.packed(),
            exposure: packed_exposure(appearance),
            contact_eye: [0.0; 4],
            contacts: [[[0.0; 4]; 2]; contact::MOST],
            houses: HOUSES.map(|[height, shade]| [height as f32, shade as f32, 0.0, 0.0]),
            openings: OPENINGS.map(|opening| opening.map(|v| v as f32)),
            backdrop: backdrop.colours().map(|colour| colour.map(|part| part as f32)),
            hatch: Hatch::new(camera.size, appearance.light).packed(),
            clip_right,
            clip_up,
            forward,
        }
    }

    /// Whether the picture is conformal.
    pub fn is_conformal(&self) -> bool {
        self.motion[2] != 0.0
    }

    /// Whether groups of the picture move past the camera otherwise than along x.
    pub fn is_oblique(&self) -> bool {
        self.oblique[0] != 0.0
    }

    /// Whether the street does.
    pub fn is_street_oblique(&self) -> bool {
        self.oblique[1] != 0.0
    }

    /// Variant of the street that the picture shows.
    pub fn street(&self) -> StreetVariant {
        StreetVariant::new(self.street_motion[1] as usize, self.street_motion[2] as usize)
    }

    /// Returns the floor below the horizon.
    pub fn floor(&self) -> Floor {
        match (self.ground[2] > f32::MIN, self.road[0] < self.road[1]) {
            (false, _) => Floor::Open,
            (true, false) => Floor::Grid,
            (true, true) if self.road[2] > 0.0 => Floor::Street,
            (true, true) => Floor::Road,
        }
    }
}

/// Returns the offset of the camera from the middle between the eyes, for [`FrameUniform::eye`].
fn eye(view: &GroupView) -> [f32; 4] {
    let is_one_cone = view.geometry == Geometry::OneCone;
    vector(if is_one_cone { view.velocity.motion_from_camera(view.camera.off_middle) } else { DVec3::ZERO })
}

/// Returns both coordinates, and what f32 loses of them.
fn coarse_and_fine(place: DVec2) -> [f32; 4] {
    let coarse = place.as_vec2();
    let fine = (place - coarse.as_dvec2()).as_vec2();
    [coarse.x, coarse.y, fine.x, fine.y]
}

/// Returns [`FrameUniform::rising`]: on the ground z is z + [(Gamma - 1) p - Gamma V R] `v_z` of what is seen
/// at the distance R, and p along the unit vector v of the motion.
fn rising(view: &GroupView) -> [f32; 4] {
    if !view.rides_aside() {
        return [0.0; 4];
    }
    let (speed, direction) = (view.camera.velocity.speed(), DVec3::from(view.camera.velocity.direction()));
    let along = direction * (speed.gamma_minus_one() * direction.z);
    packed(along, -speed.proper() * direction.z)
}

fn middle_of(frame: &FrameUniform) -> DVec3 {
    let [coarse, fine] =
        [frame.middle, frame.middle_fine].map(|[x, y, z, _]| DVec3::new(x.into(), y.into(), z.into()));
    coarse + fine
}

fn columns(matrix: DMat3) -> [[f32; 4]; 3] {
    [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(vector)
}

fn vector(v: DVec3) -> [f32; 4] {
    packed(v, 0.0)
}

/// Well in front is what is this much along the gaze.
const LEAST_DEPTH: f64 = 0.05;

/// u and v from which those of a conformal picture's pixels are counted, and cosh u times the line of sight
/// there.
///
/// They are those of the direction `towards` an end of the x axis, where that is well in front; else those of
/// the middle of the picture. Where the baseline is along x, parts across it are products: nothing is lost
/// there, and they are u = 0, v = 0, for what is abreast to keep the digits of `n_x`, unless that is too far
/// from the picture.
fn conformal_pole(mercator: &Mercator, camera: &Camera, turned: DMat3, towards: DVec3) -> (DVec2, DVec3) {
    let Axes { right, forward, .. } = mercator.axes;
    let u = mercator.coordinates_at(camera.size.map(|side| 0.5 * f64::from(side))).x;
    let middle = (DVec2::new(u, 0.0), forward + right * sinh(u));
    match mercator.coordinates(towards).filter(|pole| pole.x.abs() <= FARTHEST_POLE) {
        Some(pole) if towards.dot(turned * camera.gaze.axes().forward) >= LEAST_DEPTH => {
            (pole, towards * cosh(pole.x))
        }
        None if u.abs() <= FARTHEST_ABREAST => (DVec2::ZERO, forward),
        _ => middle,
    }
}

/// The farthest that the middle of a picture is aside whose pixels are counted from what is abreast, as |u|.
const FARTHEST_ABREAST: f64 = 3.0;

/// The pixel towards the end of the x axis with this sign and its (unnormalised) line of sight, if it is well
/// in front of the camera; else the middle of the picture and what is seen there.
fn pole(camera: &Camera, gauge: &Gauge, turned: DMat3, sign: f64) -> (DVec2, DVec3) {
    let Gauge { right, up, forward, .. } = *gauge;
    let middle = DVec2::from(camera.size.map(f64::from)) * 0.5;
    let depth = sign * forward.x;
    if depth < LEAST_DEPTH {
        return (middle, turned * camera.through_middle());
    }
    let scale = sign * camera.focal_length_px() / depth;
    let pole = middle + DVec2::new(right.x, -up.x) * scale;
    (pole, DVec3::X * (sign / depth))
}
