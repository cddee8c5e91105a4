//! Rays against tori: `shaders/ring.wgsl`, where the method is explained.

use super::super::body::{PacketBody, PacketCapsule, RestRays, Surface};
use super::super::ray::nearest_to;
use super::pattern::chart::{OffAxis, SurfacePlaces, angle_to, arc_to};
use crate::simd::lanes::{F, Mask, Simd, SimdFloat, SimdMask, V3, all, no, select};

/// Reached only where the ray grazes within rounding.
const MAX_STEPS: u32 = 32;
/// Least F'' that the search for the least F goes by.
const LEAST_SECOND: f32 = 0.02;

struct RingCourse<S: Simd> {
    /// rho^2 = a s^2 + 2 b s + c, z = height + s slope.
    a: F<S>,
    b: F<S>,
    c: F<S>,
    height: F<S>,
    slope: F<S>,
}

/// F, F' and F'' at some s.
struct Torus<S: Simd> {
    value: F<S>,
    first: F<S>,
    second: F<S>,
}

#[derive(Clone, Copy)]
struct RootSearch<S: Simd> {
    found: Mask<S>,
    /// Place of the least F so far, and that F.
    s: F<S>,
    value: F<S>,
}

#[inline(always)]
fn torus_at<S: Simd>(course: &RingCourse<S>, body: &PacketBody<S>, s: F<S>) -> Torus<S> {
    let rho = ((course.a * s + 2.0 * course.b) * s + course.c).max(1e-30).sqrt();
    let rho_first = (course.a * s + course.b) / rho;
    let rho_second = (course.a - rho_first * rho_first) / rho;
    let z = course.height + s * course.slope;
    let from_circle = rho - body.form_w;
    Torus {
        value: from_circle * from_circle + z * z - body.radius * body.radius,
        first: 2.0 * (from_circle * rho_first + z * course.slope),
        second: 2.0 - 2.0 * body.form_w * rho_second,
    }
}

/// The first root of F in [start, end], where F'' is at least `curvature`, of the rays that are `active`.
#[inline(always)]
fn entry<S: Simd>(
    body: &PacketBody<S>,
    course: &RingCourse<S>,
    curvature: F<S>,
    [start, end]: [F<S>; 2],
    before: RootSearch<S>,
    active: Mask<S>,
) -> RootSearch<S> {
    let (mut search, mut s, mut active) = (before, start, active);
    for _ in 0..MAX_STEPS {
        active &= !s.simd_gt(end);
        if !active.any_true() {
            break;
        }
        let at = torus_at(course, body, s);
        // F changes by 2 r across the surface, and rho is known to some 1e-7 R: on the surface as f32 sees
        // it.
        let found = active & at.value.simd_le(1e-6 * body.form_w * body.radius);
        active &= !found;
        let nearer = found | active & at.value.simd_lt(search.value);
        search = RootSearch {
            found: search.found | found,
            s: select(nearer, s, search.s),
            value: select(nearer, at.value, search.value),
        };
        let discriminant = at.first * at.first - 2.0 * curvature * at.value;
        let divisor = discriminant.max(0.0).sqrt() - at.first;
        active &= !(discriminant.simd_lt(0.0) | divisor.simd_le(0.0));
        s = select(active, s + 2.0 * at.value / divisor, s);
    }
    search
}

/// Returns the middle of the body.
#[inline(always)]
pub fn middle<S: Simd>(body: &PacketBody<S>) -> V3<S> {
    body.place
}

/// Returns a capsule that contains the body.
#[inline(always)]
pub fn around<S: Simd>(body: &PacketBody<S>) -> PacketCapsule<S> {
    PacketCapsule { place: body.place, end: body.place, radius: body.form_w + body.radius }
}

/// Returns the least distance at which rays pass its surface.
///
/// Where a ray crosses the ring's plane it is |rho - R| from the middle circle. On from there, rho changes by
/// no more than the cosine of its slope and z by the sine, per step: so it comes no nearer than the sine
/// times that.
#[inline(always)]
pub fn least_miss<S: Simd>(body: &PacketBody<S>, ray: &RestRays<S>) -> F<S> {
    let nearest = nearest_to(body.place, ray);
    let (height, slope) = (nearest.dot(body.form), ray.direction.dot(body.form));
    let start = nearest - body.form * height;
    let flat_direction = ray.direction - body.form * slope;
    let times_sine = (start * slope - flat_direction * height).length();
    (times_sine - body.form_w * slope.abs()).abs() - body.radius
}

/// Returns the surface of the body where rays meet it.
#[inline(always)]
pub fn surface<S: Simd>(simd: S, body: &PacketBody<S>, ray: &RestRays<S>) -> Surface<S> {
    let n = ray.direction;
    let nearest = nearest_to(body.place, ray);
    let height = nearest.dot(body.form);
    let slope = n.dot(body.form);
    let start = nearest - body.form * height;
    let flat_direction = n - body.form * slope;
    // A ray along the axis, or one across it (below), is treated as turned by a millionth.
    let a = flat_direction.dot(flat_direction).max(1e-12);
    let course = RingCourse { a, b: start.dot(flat_direction), c: start.dot(start), height, slope };
    let lateral = start.cross(flat_direction);
    let closest_squared = lateral.dot(lateral) / a;

    // The torus lies between two cylinders and two planes.
    let outer = body.form_w + body.radius;
    let inner = body.form_w - body.radius;
    let outer_half = ((outer * outer - closest_squared).max(0.0) / a).sqrt();
    let inner_half = ((inner * inner - closest_squared).max(0.0) / a).sqrt();
    let turn = -course.b / a;
    let steep = select(slope.simd_ge(0.0), all(simd, 1.0), all(simd, -1.0)) / slope.abs().max(1e-12);
    let level = -height * steep;
    // From the camera on: one in the hole has a part of the torus behind it.
    let here = -(ray.to_centre + body.place.dot(n));
    let first = (turn - outer_half).max(level - body.radius * steep.abs()).max(here);
    let last = (turn + outer_half).min(level + body.radius * steep.abs());

    let mut search = RootSearch { found: no(simd), s: turn, value: torus_at(&course, body, turn).value };
    let is_near = (outer * outer).simd_gt(closest_squared) & first.simd_lt(last);
    if is_near.any_true() {
        // rho'' = a rho_closest^2/rho^3, at most this where the torus is.
        let least = closest_squared.sqrt().max(inner);
        let curvature = 2.0 - 2.0 * body.form_w * a * closest_squared / (least * least * least);
        let before_hole = [first, last.min(turn - inner_half)];
        search = entry(body, &course, curvature, before_hole, search, is_near);
        // Nothing is in the hole, and the bound on rho'' does not hold there.
        let after_hole = [first.max(turn + inner_half), last];
        search = entry(body, &course, curvature, after_hole, search, is_near & !search.found);
    }
    if !search.found.all_true() {
        let at_level = nearer(&search, level, torus_at(&course, body, level).value);
        search.s = select(search.found, search.s, at_level.s);
        search.value = select(search.found, search.value, at_level.value);
    }
    let deepest = deepest(&course, body, search);
    let miss = (deepest.value + body.radius * body.radius).max(0.0).sqrt();
    // What was entered is inside, whatever rounding makes of a graze.
    let inside = body.radius - miss;
    let clearance = select(search.found, inside.max(1e-6 * body.radius), inside.min(0.0));
    let place = nearest + n * search.s;
    Surface {
        clearance,
        half_width: body.radius,
        outward: torus_normal(nearest + n * deepest.s, body),
        beyond: body.place.dot(n) + search.s,
        place,
        normal: torus_normal(place, body),
    }
}

/// Returns how deep inside the outline rays come: the least F of this passage, by Newton's method.
#[inline(always)]
fn deepest<S: Simd>(course: &RingCourse<S>, body: &PacketBody<S>, search: RootSearch<S>) -> RootSearch<S> {
    let (mut deepest, mut s) = (search, search.s);
    for _ in 0..4 {
        let at = torus_at(course, body, s);
        deepest = nearer(&deepest, s, at.value);
        s -= at.first / at.second.max(LEAST_SECOND);
    }
    deepest
}

#[inline(always)]
fn nearer<S: Simd>(search: &RootSearch<S>, s: F<S>, value: F<S>) -> RootSearch<S> {
    let is_nearer = value.simd_lt(search.value);
    RootSearch {
        found: search.found,
        s: select(is_nearer, s, search.s),
        value: select(is_nearer, value, search.value),
    }
}

/// From the nearest point of the middle circle, towards `place`.
#[inline(always)]
fn torus_normal<S: Simd>(place: V3<S>, body: &PacketBody<S>) -> V3<S> {
    let height = place.dot(body.form);
    let from_axis = place - body.form * height;
    let rho = from_axis.length().max(1e-30);
    let outward = place - from_axis * (body.form_w / rho);
    outward / outward.length().max(1e-30)
}

/// Returns the chart of a place on the body, in its own axes. `shaders/ring.wgsl` computes the same.
#[inline(always)]
pub fn chart<S: Simd>(body: &PacketBody<S>, place: V3<S>) -> SurfacePlaces<S> {
    let off = OffAxis::new(place);
    let (along, along_gradient) = arc_to(off.distance - body.form_w, off.outward, place.z, body.radius);
    let around = angle_to(place.y, place.x);
    let around_gradient = off.around_gradient();
    SurfacePlaces {
        along,
        along_gradient,
        around,
        around_gradient,
        off_axis: off.distance,
        level: body.form_w * around,
        level_gradient: around_gradient * body.form_w,
    }
}
