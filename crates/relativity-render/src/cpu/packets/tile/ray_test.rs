//! A body's surface in the pixels of a packet.

use super::super::body::{PacketBody, PacketGroup, RestRays, Surface};
use super::super::ray::{height_on_ground, movement};
use super::super::shape;
use crate::geometry::kind::Kind;
use crate::simd::lanes::{F, Mask, Simd, SimdFloat, V2, all};

/// A ray test with what a picture needs of it.
pub struct RayTest<S: Simd> {
    /// From the camera, rest frame.
    pub distance: F<S>,
    /// Depth of the pixel's middle inside the outline, and its change from pixel to pixel.
    clearance: F<S>,
    gradient: V2<S>,
    /// Share of a pixel that it covers, 1 unless it is thinner.
    pub alpha: F<S>,
    /// Whether it is in front of the camera, and above the ground.
    is_there: Mask<S>,
}

impl<S: Simd> RayTest<S> {
    /// Returns the fragment of the `body` whose `surface` was found; in a picture it is drawn at least a
    /// pixel wide.
    #[inline(always)]
    pub fn new(
        simd: S,
        group: &PacketGroup<'_>,
        kind: Kind,
        body: &PacketBody<S>,
        ray: &RestRays<S>,
        surface: Surface<S>,
        is_picture: bool,
    ) -> Self {
        let distance = ray.to_centre + surface.beyond;
        let is_in_front = distance.simd_gt(0.0);
        let zero = all(simd, 0.0);
        let mut test = Self {
            distance,
            clearance: surface.clearance,
            gradient: V2::new(zero, zero),
            alpha: all(simd, 1.0),
            is_there: is_in_front,
        };
        if !is_picture {
            return test;
        }
        let movement = movement(group, ray, surface.outward);
        let least = -distance.max(0.0);
        test.gradient = V2::new(least * movement.x, least * movement.y);
        let half_pixel = test.gradient.length() * 0.5;
        test.alpha = (surface.half_width / half_pixel.max(1e-30)).min(1.0);
        test.clearance += (half_pixel - surface.half_width).max(0.0);
        let height = shape::middle(kind, body).z + surface.place.z + group.frame.middle[2];
        let height = height_on_ground(group, height, shape::middle(kind, body) + surface.place);
        test.is_there = is_in_front & height.simd_ge(group.frame.ground[2]);
        test
    }

    /// Returns the pixels in which the sample this far from the centre is inside.
    #[inline(always)]
    pub(super) fn holds(&self, [right, down]: [f32; 2]) -> Mask<S> {
        let clearance = self.clearance + self.gradient.x * right + self.gradient.y * down;
        clearance.simd_gt(0.0) & self.is_there
    }
}
