//! Rays against boxes: `shaders/box.wgsl`.

use super::super::body::{
    Limits, OwnRay, PacketBody, PacketCapsule, PacketGroup, RestRays, Surface, own_ray,
};
use super::super::edge::share_of_other;
use crate::simd::lanes::{F, Mask, Simd, SimdFloat, V3, all, select, sign_of};

/// Below this sine of its angle to the ray the image of an axis is a point.
const LEAST_SINE: f32 = 1e-5;

/// The middle of a body with flat faces.
#[inline(always)]
pub fn middle<S: Simd>(body: &PacketBody<S>) -> V3<S> {
    body.place
}

/// Returns a capsule that contains the body.
#[inline(always)]
pub fn around<S: Simd>(body: &PacketBody<S>) -> PacketCapsule<S> {
    PacketCapsule { place: body.place, end: body.place, radius: body.halves().length() }
}

/// Returns where rays enter the body and leave it if each of its faces is moved outwards by `room`: distances
/// beyond its middle, of which the first is greater where a ray misses it.
#[inline(always)]
pub fn passage<S: Simd>(body: &PacketBody<S>, ray: &RestRays<S>, room: F<S>) -> [F<S>; 2] {
    let own = own_ray(room.simd, body, ray);
    let half = body.halves() + V3::new(room, room, room);
    let offset = own.direction.signs().times(own.nearest);
    let slopes = own.direction.abs().at_least(1e-12);
    [(-(half + offset) / slopes).max_part(), ((half - offset) / slopes).min_part()]
}

/// Returns the surface of the body where rays meet it.
#[inline(always)]
pub fn surface<S: Simd>(
    simd: S,
    group: &PacketGroup,
    body: &PacketBody<S>,
    ray: &RestRays<S>,
    limits: Option<&Limits<S>>,
) -> Surface<S> {
    let own = own_ray(simd, body, ray);
    let n = own.direction;
    let half = body.halves();
    let steep = n.abs();
    // Along the ray the box is a hexagon, inside three pairs of lines along the images of its axes. The image
    // of an axis along the ray is a point, and its lines cut off less than f32 resolves.
    let squares = n.yzx().times(n.yzx()) + n.zxy().times(n.zxy());
    let sines = squares.sqrt();
    let divisors = sines.at_least(LEAST_SINE);
    let spans = half.yzx().times(steep.zxy()) + half.zxy().times(steep.yzx());
    let widths = of_lines(sines, spans / divisors);
    let inside = of_lines(sines, (spans - own.moment.abs()) / divisors);
    let clearance = inside.min_part();
    let towards = n.signs();
    let slopes = steep.at_least(1e-12);
    let enters = -(half + towards.times(own.nearest)) / slopes;
    let leaves = (half - towards.times(own.nearest)) / slopes;
    let last_entry = enters.max_part();
    let s = last_entry.min(leaves.min_part());
    // A ray that misses has its place where it comes close.
    let place = (own.nearest + n * s).clamp(-half, half);
    let beyond = body.place.dot(ray.direction) + place.dot(n);
    if let Some(limits) = limits
        && limits.exclude(ray, clearance, beyond)
    {
        return Surface::excluded(simd);
    }

    let side = first_of(simd, equal_to(inside, clearance));
    let outward = n.cross(side) * (-sign_of(own.moment.dot(side)) / divisors.dot(side).max(LEAST_SINE));

    let normal = if limits.is_some() {
        ray.direction
    } else {
        let faces = Faces { own, towards, half, sines, spans, enters, last_entry };
        body.rest_from_body(faces.normal(simd, group, body, ray, beyond))
    };

    Surface {
        clearance,
        half_width: widths.min_part(),
        outward: body.rest_from_body(outward),
        beyond,
        place: body.rest_from_body(place),
        normal,
    }
}

/// The faces of a box in sight of rays, in its own axes.
struct Faces<S: Simd> {
    own: OwnRay<S>,
    /// Signs of the ray's direction.
    towards: V3<S>,
    half: V3<S>,
    /// Sines of the angles between the ray and the axes.
    sines: V3<S>,
    /// Half of what the images of the other two axes span across that of each.
    spans: V3<S>,
    /// Distances at which the ray enters each pair of faces, and the greatest of these.
    enters: V3<S>,
    last_entry: F<S>,
}

impl<S: Simd> Faces<S> {
    /// Returns the normal of the surface that is met this far `beyond` the middle of the group: the mean of
    /// those in a pixel.
    #[inline(always)]
    fn normal(
        &self,
        simd: S,
        group: &PacketGroup,
        body: &PacketBody<S>,
        ray: &RestRays<S>,
        beyond: F<S>,
    ) -> V3<S> {
        let &Self { own, towards, half, sines, spans, enters, last_entry } = self;
        let n = own.direction;
        // The three faces in sight meet in the nearest corner, from which three edges run along the axes.
        let face = first_of(simd, equal_to(enters, last_entry));
        let before = all(simd, -1e30);
        let others = V3::new(
            select(face.x.simd_gt(0.0), before, enters.x),
            select(face.y.simd_gt(0.0), before, enters.y),
            select(face.z.simd_gt(0.0), before, enters.z),
        );
        let second = first_of(simd, equal_to(others, others.max_part()));
        let edge = V3::all(simd, [1.0; 3]) - face - second;
        let divisor = sines.dot(edge).max(LEAST_SINE);
        let of_edge = towards.times(half).cross(n).dot(edge);
        let from_edge = (own.moment.dot(edge) - of_edge).abs() / divisor;
        let width = (spans.dot(edge) - of_edge.abs()) / divisor;
        let across = body.rest_from_body(n.cross(edge) / divisor);
        let share = share_of_other(group, from_edge, width, across, ray, beyond);
        (-towards).times(V3::mix(face, second, share))
    }
}

/// Returns the three `distances` to pattern lines, 1e30 where a line does not exist.
#[inline(always)]
fn of_lines<S: Simd>(sines: V3<S>, distances: V3<S>) -> V3<S> {
    V3::new(of_line(sines.x, distances.x), of_line(sines.y, distances.y), of_line(sines.z, distances.z))
}

#[inline(always)]
fn of_line<S: Simd>(sine: F<S>, distance: F<S>) -> F<S> {
    select(sine.simd_lt(LEAST_SINE), all(sine.simd, 1e30), distance)
}

/// Returns which parts equal this `value`.
#[inline(always)]
fn equal_to<S: Simd>(v: V3<S>, value: F<S>) -> [Mask<S>; 2] {
    [v.x.simd_eq(value), v.y.simd_eq(value)]
}

/// Returns the first chosen axis, of which x and y are given: z if it is neither.
#[inline(always)]
fn first_of<S: Simd>(simd: S, [is_x, is_y]: [Mask<S>; 2]) -> V3<S> {
    let (zero, one) = (all(simd, 0.0), all(simd, 1.0));
    let neither = !(is_x | is_y);
    V3::new(select(is_x, one, zero), select(is_y & !is_x, one, zero), select(neither, one, zero))
}
