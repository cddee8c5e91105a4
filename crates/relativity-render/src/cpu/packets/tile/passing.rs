//! Packets of a tile, eight of them, in which a body may be seen: a lane is a packet here.

use crate::cpu::packets::body::{PacketBody, PacketGroup, RestRays};
use crate::cpu::packets::places::{PACKETS, packet_places};
use crate::cpu::packets::ray::{corner_sights, line_of_sight, nearest_to, rest_ray};
use crate::cpu::packets::shape::{around, block, ring};
use crate::geometry::kind::Kind;
use crate::simd::lanes::{F, LANES, Mask, Simd, SimdFloat, SimdFrom, V3, all, clamp, select};

/// The ray through the middle of each packet, and how far others of it are off that.
#[derive(Debug, Clone, Copy)]
pub struct Middles<S: Simd> {
    ray: RestRays<S>,
    /// Per distance, with a pixel around the middles of its pixels: no sample is further off them than 0.4
    /// px, and nothing is widened by more than half a pixel. Without an end where its image is not small.
    spread: F<S>,
    /// The spread of half a pixel and 0.4 px.
    pixel: F<S>,
}

impl<S: Simd> Middles<S> {
    /// Returns the rays of the tile with this `corner`.
    #[inline(always)]
    pub fn new(simd: S, group: &PacketGroup<'_>, corner: [u32; 2]) -> Self {
        let places: [[f32; 2]; LANES] = std::array::from_fn(|packet| {
            let [u, v] = packet_places(corner, packet);
            [u as f32 + 2.0, v as f32 + 1.0]
        });
        let u = F::simd_from(simd, places.map(|[u, _]| u));
        let v = F::simd_from(simd, places.map(|[_, v]| v));
        let ray = rest_ray(simd, group, line_of_sight(simd, group.frame, u, v));
        let mut most_squared = all(simd, 0.0);
        let sights = corner_sights(simd, group.frame, [u, v], [2.5, 1.5]);
        let mut corners = [V3::all(simd, [0.0; 3]); 4];
        for (off, sight) in corners.iter_mut().zip(sights) {
            *off = rest_ray(simd, group, sight).direction - ray.direction;
        }
        for off in corners {
            most_squared = most_squared.max(off.dot(off));
        }
        let most = most_squared.sqrt();
        let is_small = most.simd_lt(0.03);
        let endless = all(simd, f32::INFINITY);
        let spread = select(is_small, most * 1.05 + 1e-6, endless);
        // The longest that a step of one pixel becomes, to first order.
        let (right, down) = ((corners[3] + corners[1]) * 0.2, (corners[3] - corners[1]) * (1.0 / 3.0));
        let (a, b, c) = (right.dot(right), right.dot(down), down.dot(down));
        let longest_squared = (a + c) * 0.5 + ((a - c) * (a - c) * 0.25 + b * b).sqrt();
        let pixel = select(is_small, longest_squared.sqrt() * (0.9 * 1.1) + 1e-6, endless);
        Self { ray, spread, pixel }
    }

    /// Returns the distance, per distance from the eye, of a pixel's samples (and of what is widened into it)
    /// from its middle: for the packet at this place, the same for eight pixels.
    #[inline(always)]
    pub fn pixel_of(&self, place: usize) -> F<S> {
        all(self.pixel.simd, self.pixel[place])
    }

    /// Returns those packets that `body` may be seen in, unless all of it is farther from the eye there than
    /// the `farthest` of what covers them.
    #[inline(always)]
    pub fn may_show(&self, kind: Kind, body: &PacketBody<S>, farthest: [f32; PACKETS]) -> Mask<S> {
        let farthest = F::simd_from(self.spread.simd, farthest);
        may_show(kind, body, &self.ray, self.spread, farthest)
    }
}

/// Returns where `body` may be seen within this `spread` of a ray per distance, unless all of it is farther
/// from the eye than this.
#[inline(always)]
pub fn may_show<S: Simd>(
    kind: Kind,
    body: &PacketBody<S>,
    ray: &RestRays<S>,
    spread: F<S>,
    farthest: F<S>,
) -> Mask<S> {
    let n = ray.direction;
    let capsule = around(kind, body);
    let anchor = (capsule.place + capsule.end) * 0.5;
    let half = (capsule.end - capsule.place) * 0.5;
    let extent = half.length();
    let longest = extent + capsule.radius;
    let along = anchor.dot(n);
    let most = (ray.to_centre + along + longest).max(0.0) * spread;
    let rounding = (anchor.length() + longest) * 1e-5;
    let (is_off, begins) = if matches!(kind, Kind::Box | Kind::Model) {
        // Within `most` of the middle ray is what other rays meet, so that it meets a box so much larger.
        let [enters, leaves] = block::passage(body, ray, most + rounding);
        let is_off = (enters - leaves).simd_gt((enters.abs() + leaves.abs()) * 1e-5);
        (is_off, enters)
    } else {
        let axis = half * (1.0 / extent.max(1e-30));
        let nearest = nearest_to(anchor, ray);
        let cosine = axis.dot(n);
        let across: V3<S> = axis.cross(n);
        let sine_squared = across.dot(across).max(1e-12);
        let closest = nearest.dot(axis) / sine_squared;
        let on_segment = clamp(closest, -extent, extent);
        let miss = nearest + (n * cosine - axis) * on_segment;
        // A miss that is no number is none.
        let mut off = miss.length() * (1.0 - 1e-5) - capsule.radius * (1.0 + 1e-5);
        if kind == Kind::Ring {
            off = off.max(ring::least_miss(body, ray) * (1.0 - 1e-5) - longest * 1e-5);
        }
        (off.simd_gt(most), -cosine.abs() * extent - capsule.radius)
    };
    let from_eye = ray.to_centre + along + begins;
    let is_behind = (from_eye - from_eye.abs() * 1e-5 - most - rounding).simd_gt(farthest);
    !(is_off | is_behind)
}
