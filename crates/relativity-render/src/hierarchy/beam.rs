//! What a tile of the picture looks along: a cone of rays in the rest frame of a group.

use std::f64::consts::FRAC_PI_2;

use glam::{DVec3, Vec3};
use relativity_core::math::hypot;

use crate::cap::Cap;
use crate::group_view::GroupView;
use crate::ray::Ray;
use crate::view::Geometry;

/// Squares below this are no longer accurate.
const LEAST_SQUARE: f64 = 1e-280;
/// What f32 loses of a place and an offset, in parts of them.
pub(super) const ROUNDING: f32 = 1e-6;
/// Of beams of a smaller one the planes that touch them are all but one.
const LEAST_COSINE: f64 = 0.07;

/// A cone of rays, inside four planes through its tip that touch it.
#[derive(Debug, Clone, Copy)]
pub struct Beam {
    /// The parts of the planes' normals, outwards; all planes are there twice, for two boxes at once.
    normals: [[f32; 8]; 3],
    /// Their sizes.
    sizes: [[f32; 8]; 3],
    /// How far outside of the middle of the group they are, less room for rounding.
    offsets: [f32; 8],
    /// The middle ray's direction.
    axis: Vec3,
    /// By how much other rays' differ from that at most.
    spread: f32,
}

/// One ray.
#[derive(Debug, Clone, Copy)]
pub struct Line {
    /// Two directions across it and each other, without and with their signs, and how far along them it passes the middle
    /// of the group.
    across: [(Vec3, Vec3, f32); 2],
    axis: Vec3,
}

/// What looks for boxes, told by their middles and the halves of their sides.
pub trait Looks {
    /// How far beyond the middle of the group it meets each of two boxes at least, both told from there; `None` if it
    /// passes.
    fn nearest(&self, boxes: [[Vec3; 2]; 2]) -> [Option<f32>; 2];
}

impl Line {
    /// Of `ray`, counted from its point nearest to `middle`.
    #[must_use]
    pub fn new(ray: &Ray, middle: DVec3) -> Self {
        let place = ray.start - middle;
        let side = |normal: DVec3| {
            let side = normal.as_vec3();
            (side, side.abs() + ROUNDING, normal.dot(place) as f32)
        };
        Self { across: across(ray.direction).map(side), axis: ray.direction.as_vec3() }
    }
}

impl Looks for Line {
    #[inline(always)]
    fn nearest(&self, boxes: [[Vec3; 2]; 2]) -> [Option<f32>; 2] {
        boxes.map(
            #[inline(always)]
            |[center, half]| {
                let reach = half + ROUNDING * center.abs();
                let [(u, u_size, u_offset), (v, v_size, v_offset)] = self.across;
                let off_u = (u.dot(center) - u_offset).abs() - ROUNDING * u_offset.abs();
                let off_v = (v.dot(center) - v_offset).abs() - ROUNDING * v_offset.abs();
                if off_u > u_size.dot(reach) || off_v > v_size.dot(reach) {
                    return None;
                }
                Some(self.axis.dot(center) - (self.axis.abs() + ROUNDING).dot(reach))
            },
        )
    }
}

impl Beam {
    /// The rays of the lines of sight within the ground's `cap`, as `view` has them in its group, from near `middle`.
    /// `None` where they are too wide, or curved, to be told so.
    #[must_use]
    pub fn new(view: &GroupView, cap: &Cap, middle: DVec3) -> Option<Self> {
        let Cap { axis, sine, cosine } = in_rest_frame(cap, view)?;
        let [u, v] = across(axis);
        let planes = [u, -u, v, -v].map(|aside| {
            let along = axis * cosine + aside * sine;
            let (place, _) = Ray::new(view.origin, along).nearest_to(middle);
            let normal = aside * cosine - axis * sine;
            (normal.as_vec3(), normal.dot(place) as f32)
        });
        // An angle is no more than pi/2 times its sine.
        Some(Self::within(planes, axis, FRAC_PI_2 * sine))
    }

    fn within(planes: [(Vec3, f32); 4], axis: DVec3, half_angle: f64) -> Self {
        let planes = std::array::from_fn::<_, 8, _>(|i| planes[i % 4]);
        let normals = [0, 1, 2].map(|axis: usize| planes.map(|(normal, _)| normal[axis]));
        Self {
            normals,
            sizes: normals.map(|parts| parts.map(|part| part.abs() + ROUNDING)),
            offsets: planes.map(|(_, offset)| offset + ROUNDING * offset.abs()),
            axis: axis.as_vec3(),
            spread: (half_angle * 1.01) as f32 + ROUNDING,
        }
    }
}

impl Looks for Beam {
    #[inline(always)]
    fn nearest(&self, boxes: [[Vec3; 2]; 2]) -> [Option<f32>; 2] {
        let [first, second] = boxes;
        let reach = [first[1] + ROUNDING * first[0].abs(), second[1] + ROUNDING * second[0].abs()];
        let [near, far] = [first[0], second[0]];
        let mut excess = [0.0; 8];
        for (i, excess) in excess.iter_mut().enumerate() {
            let (center, reach) = if i < 4 { (near, reach[0]) } else { (far, reach[1]) };
            let off =
                self.normals[0][i] * center.x + self.normals[1][i] * center.y + self.normals[2][i] * center.z;
            let room = self.sizes[0][i] * reach.x + self.sizes[1][i] * reach.y + self.sizes[2][i] * reach.z;
            *excess = off - room;
        }
        let mut is_outside = [false; 2];
        for i in 0..4 {
            is_outside[0] |= excess[i] > self.offsets[i];
            is_outside[1] |= excess[4 + i] > self.offsets[4 + i];
        }
        let along = |center: Vec3, reach: Vec3| {
            let along = self.axis.dot(center) - self.axis.abs().dot(reach);
            // The sum of its parts is no less than a length.
            along - self.spread * (center.abs() + reach).element_sum()
        };
        [(!is_outside[0]).then(|| along(near, reach[0])), (!is_outside[1]).then(|| along(far, reach[1]))]
    }
}

/// Two unit vectors across `axis` and each other, each part of them as accurate as those of `axis`: rays of a camera 1e30
/// away are turned from x by 1e-30.
pub(super) fn across(axis: DVec3) -> [DVec3; 2] {
    let square = axis.y * axis.y + axis.z * axis.z;
    let off_x = if square > LEAST_SQUARE { square.sqrt() } else { hypot(axis.y, axis.z) };
    if off_x == 0.0 {
        return [DVec3::Y, DVec3::Z];
    }
    let (y, z) = (axis.y / off_x, axis.z / off_x);
    [DVec3::new(-off_x, axis.x * y, axis.x * z), DVec3::new(0.0, -z, y)]
}

/// The rays in the rest frame of the group that `view` shows, whose lines of sight are in this `cap` on the ground; `None`
/// where they curve, or reach almost to a right angle.
fn in_rest_frame(cap: &Cap, view: &GroupView) -> Option<Cap> {
    let cap = match view.geometry {
        Geometry::Rest => *cap,
        Geometry::Seen => {
            let reflected = Cap { axis: view.velocity.reflected(cap.axis), ..*cap };
            let cap = reflected.in_rest_frame(&view.velocity.speed)?;
            Cap { axis: view.velocity.reflected(cap.axis), ..cap }
        }
        Geometry::Contracted => stretched(cap, view)?,
        Geometry::OneCone | Geometry::Published => return None,
    };
    (cap.cosine > LEAST_COSINE).then_some(cap)
}

/// Around what becomes of a cap where x is gamma times as long: of the four corners of a pyramid around it, between which
/// straight lines stay straight.
fn stretched(cap: &Cap, view: &GroupView) -> Option<Cap> {
    if cap.cosine < 0.5 {
        return None;
    }
    let stretched = |direction: DVec3| view.rest_ray(direction.normalize()).direction;
    let [u, v] = across(cap.axis).map(|aside| aside * (cap.sine / cap.cosine));
    let corners = [u + v, u - v, v - u, -u - v].map(|corner| stretched(cap.axis + corner));
    Some(Cap::around(stretched(cap.axis), corners))
}
