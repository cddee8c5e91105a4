//! What a tile of the picture looks along: a cone of rays in the rest frame of a group.

use std::f64::consts::PI;

use glam::{DVec3, Vec3};
use relativity_core::Speed;
use relativity_core::math::{atan, atan2, hypot, sin_cos, tan};

use crate::cone::Cone;
use crate::group_view::GroupView;
use crate::ray::Ray;
use crate::view::Geometry;

/// What f32 loses of a place and an offset, in parts of them.
const ROUNDING: f32 = 1e-6;

/// A cone of rays, inside four planes through its tip that touch it.
#[derive(Debug, Clone, Copy)]
pub struct Beam {
    /// The parts of the planes' normals, outwards.
    normals: [[f32; 4]; 3],
    /// Their sizes.
    sizes: [[f32; 4]; 3],
    /// How far outside of the middle of the group they are, less room for rounding.
    offsets: [f32; 4],
    /// The middle ray's direction.
    axis: Vec3,
    /// By how much other rays' differ from that at most.
    spread: f32,
}

impl Beam {
    /// The rays of the lines of sight within the ground's `cone`, as `view` has them in its group, from near `middle`.
    /// `None` where they are too wide, or curved, to be told so.
    #[must_use]
    pub fn new(view: &GroupView, cone: &Cone, middle: DVec3) -> Option<Self> {
        let Cone { axis, half_angle } = cone.in_rest_frame(view)?;
        let (sine, cosine) = sin_cos(half_angle);
        let [u, v] = across(axis);
        let aside = [u, -u, v, -v];
        let planes = aside.map(|aside| {
            let along = axis * cosine + aside * sine;
            let (place, _) = Ray::new(view.origin, along).nearest_to(middle);
            let normal = aside * cosine - axis * sine;
            (normal.as_vec3(), normal.dot(place) as f32)
        });
        Some(Self::within(planes, axis, half_angle))
    }

    /// One `ray`, counted from its point nearest to `middle`.
    #[must_use]
    pub fn of_ray(ray: &Ray, middle: DVec3) -> Self {
        let [u, v] = across(ray.direction);
        let place = ray.start - middle;
        let planes = [u, -u, v, -v].map(|normal| (normal.as_vec3(), normal.dot(place) as f32));
        Self::within(planes, ray.direction, 0.0)
    }

    fn within(planes: [(Vec3, f32); 4], axis: DVec3, half_angle: f64) -> Self {
        let part = |axis: usize| planes.map(|(normal, _)| normal[axis]);
        let normals = [part(0), part(1), part(2)];
        Self {
            normals,
            sizes: normals.map(|parts| parts.map(|part| part.abs() + ROUNDING)),
            offsets: planes.map(|(_, offset)| offset + ROUNDING * offset.abs()),
            axis: axis.as_vec3(),
            spread: (half_angle * 1.01) as f32 + ROUNDING,
        }
    }

    /// How far beyond the middle of the group it meets a box at least, both told from there; `None` if it passes.
    #[inline]
    #[must_use]
    pub fn nearest(&self, center: Vec3, half: Vec3) -> Option<f32> {
        let reach = half + ROUNDING * center.abs();
        let mut is_outside = false;
        for i in 0..4 {
            let off =
                self.normals[0][i] * center.x + self.normals[1][i] * center.y + self.normals[2][i] * center.z;
            let room = self.sizes[0][i] * reach.x + self.sizes[1][i] * reach.y + self.sizes[2][i] * reach.z;
            is_outside |= off - room > self.offsets[i];
        }
        if is_outside {
            return None;
        }
        let along = self.axis.dot(center) - self.axis.abs().dot(reach);
        Some(along - self.spread * (center.abs() + reach).length())
    }
}

/// Two unit vectors across `axis` and each other, each part of them as accurate as those of `axis`: rays of a camera 1e30
/// away are turned from x by 1e-30.
fn across(axis: DVec3) -> [DVec3; 2] {
    let off_x = hypot(axis.y, axis.z);
    if off_x == 0.0 {
        return [DVec3::Y, DVec3::Z];
    }
    let (y, z) = (axis.y / off_x, axis.z / off_x);
    [DVec3::new(-off_x, axis.x * y, axis.x * z), DVec3::new(0.0, -z, y)]
}

impl Cone {
    /// The rays in the rest frame of the group that `view` shows, whose lines of sight are in this cone on the ground;
    /// `None` where they curve, or reach further than to all sides.
    fn in_rest_frame(&self, view: &GroupView) -> Option<Self> {
        let cone = match view.geometry {
            Geometry::Rest => *self,
            Geometry::Seen => {
                let reflected = Self { axis: view.velocity.reflected(self.axis), ..*self };
                let cone = reflected.aberrated(&view.velocity.speed)?;
                Self { axis: view.velocity.reflected(cone.axis), ..cone }
            }
            Geometry::Contracted => self.stretched(view)?,
            Geometry::OneCone | Geometry::Published => return None,
        };
        // Beyond this planes that touch it are all but one.
        (cone.half_angle < 1.5).then_some(cone)
    }

    /// The rest-frame cone of this one on the ground, for motion along +x; `None` if it holds -x, from where light comes from
    /// all sides.
    ///
    /// In the plane through `axis` and x it ends at the angles psi +- `half_angle` from x, and aberration scales tan(psi/2).
    fn aberrated(&self, speed: &Speed) -> Option<Self> {
        let (x, off_x) = (self.axis.x, hypot(self.axis.y, self.axis.z));
        let middle = if x > 0.0 { off_x / (1.0 + x) } else { (1.0 - x) / off_x };
        let half = tan(0.5 * self.half_angle);
        if middle * half >= 1.0 - 1e-9 || self.half_angle >= PI {
            return None;
        }
        let seen = |tangent: f64| 2.0 * atan(tangent / speed.head_on_doppler_factor());
        let [low, high] =
            [(middle - half) / (1.0 + middle * half), (middle + half) / (1.0 - middle * half)].map(seen);
        let (sine, cosine) = sin_cos(0.5 * (low + high));
        let across = DVec3::new(0.0, self.axis.y, self.axis.z).normalize_or_zero();
        let half_angle = 0.5 * (high - low) * (1.0 + 1e-12);
        Some(Self { axis: DVec3::X * cosine + across * sine, half_angle })
    }

    /// The cone around what becomes of this one where x is gamma times as long: of the four corners of a pyramid around
    /// it, between which straight lines stay straight.
    fn stretched(&self, view: &GroupView) -> Option<Self> {
        if self.half_angle > 1.0 {
            return None;
        }
        let stretched = |direction: DVec3| view.rest_ray(direction.normalize()).direction;
        let [u, v] = across(self.axis).map(|aside| aside * tan(self.half_angle));
        let axis = stretched(self.axis);
        let corners = [u + v, u - v, v - u, -u - v].map(|corner| stretched(self.axis + corner));
        let half_angle =
            corners.into_iter().map(|corner| atan2(axis.cross(corner).length(), axis.dot(corner)));
        let half_angle = half_angle.fold(0.0, f64::max);
        Some(Self { axis, half_angle: half_angle * (1.0 + 1e-12) })
    }
}
