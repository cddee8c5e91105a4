//! Rays against cylinders with rounded ends, and balls: `shaders/tube.wgsl`.

use super::super::body::{Limits, PacketBody, PacketCapsule, RestRays, Surface};
use super::super::ray::nearest_to;
use super::pattern::chart::{OffAxis, SurfacePlaces, along_axis, angle_to, arc_to};
use crate::scene::pattern::NUDGE;
use crate::simd::lanes::{Simd, SimdFloat, SimdMask, V3, clamp, select};

/// Margin beside the ends, in radii.
const BESIDE: f32 = 0.02;

/// Returns the middle of the body.
#[inline(always)]
pub fn middle<S: Simd>(body: &PacketBody<S>) -> V3<S> {
    (body.place + body.form) * 0.5
}

/// Returns a capsule that contains the body.
#[inline(always)]
pub fn around<S: Simd>(body: &PacketBody<S>) -> PacketCapsule<S> {
    PacketCapsule { place: body.place, end: body.form, radius: body.radius }
}

/// Returns the surface of the body where rays meet it.
#[inline(always)]
pub fn surface<S: Simd>(body: &PacketBody<S>, ray: &RestRays<S>, limits: Option<&Limits<S>>) -> Surface<S> {
    let n = ray.direction;
    let anchor = middle(body);
    let half = (body.form - body.place) * 0.5;
    let extent = half.length();
    let axis = half / extent.max(1e-30);
    // The ray is nearest + s n, from the middle, with nearest perpendicular to n.
    let nearest = nearest_to(anchor, ray);
    let cosine = axis.dot(n);
    let across = axis.cross(n);
    let sine = across.length().max(1e-9);
    let nearest_along = nearest.dot(axis);
    // Where on the axis (as a line) the ray comes closest.
    let closest = nearest_along / (sine * sine);

    let on_segment = clamp(closest, -extent, extent);
    let miss_vector = nearest + (n * cosine - axis) * on_segment;
    let miss = miss_vector.length();
    let outward = miss_vector / miss.max(1e-30);

    let line_miss = nearest.dot(across).abs() / sine;
    let half_chord = ((body.radius - line_miss) * (body.radius + line_miss)).max(0.0).sqrt() / sine;
    let s = closest * cosine - half_chord;
    let mut beyond = anchor.dot(n) + s;
    let mut place = nearest + n * s;
    let along = nearest_along + s * cosine;
    // Beside an end the side is as near as the end is, but for rounding: what shares the end must not come
    // before it there.
    let is_near_cap = along.abs().simd_ge(extent - body.radius * BESIDE);
    if is_near_cap.any_true() {
        // From the end itself: tubes that share a rounded end get the same depth there to the bit.
        let end = V3::select(along.simd_lt(0.0), body.place, body.form);
        let from_end = nearest_to(end, ray);
        let depth_squared = body.radius * body.radius - from_end.dot(from_end);
        let half_cap = depth_squared.max(0.0).sqrt();
        let beyond_cap = end.dot(n) - half_cap;
        let is_first = is_near_cap & depth_squared.simd_gt(0.0) & beyond_cap.simd_lt(beyond);
        let is_cap = is_first | along.abs().simd_ge(extent);
        beyond = select(is_cap, beyond_cap, beyond);
        place = V3::select(is_cap, (end - anchor) + (from_end - n * half_cap), place);
    }
    let clearance = body.radius - miss;
    if let Some(limits) = limits
        && limits.exclude(ray, clearance, beyond)
    {
        return Surface::excluded(miss.simd);
    }
    let mut normal = outward;
    let is_hit = miss.simd_lt(body.radius);
    if limits.is_none() && is_hit.any_true() {
        let from_axis = place - axis * clamp(place.dot(axis), -extent, extent);
        normal = V3::select(is_hit, from_axis / from_axis.length().max(1e-30), normal);
    }
    Surface { clearance, half_width: body.radius, outward, beyond, place, normal }
}

/// Returns the chart of a place on the body, in its own axes. `shaders/tube.wgsl` computes the same.
#[inline(always)]
pub fn chart<S: Simd>(
    body: &PacketBody<S>,
    pattern: [f32; 3],
    place: V3<S>,
    normal: V3<S>,
) -> SurfacePlaces<S> {
    let half = (body.form - body.place).length() * 0.5;
    let off = OffAxis::new(place);
    let beyond = place.z - clamp(place.z, -half, half);
    let (arc, along_gradient) = arc_to(off.distance, off.outward, beyond, body.radius);
    SurfacePlaces {
        along: half + (place.z - beyond) + arc,
        along_gradient,
        around: angle_to(place.y, place.x),
        around_gradient: off.around_gradient(),
        off_axis: off.distance,
        level: place.z - normal.z * (NUDGE as f32 * pattern[1]) + half,
        level_gradient: along_axis(half.simd),
    }
}
