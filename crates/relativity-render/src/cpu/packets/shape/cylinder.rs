//! Rays against cylinders with flat ends: `shaders/cylinder.wgsl`.

use super::super::body::{Limits, PacketBody, PacketGroup, RestRays, Surface, own_ray};
use super::super::edge::share_of_other;
use super::pattern::chart::{OffAxis, SurfacePlaces, along_axis, angle_to};
use crate::scene::pattern::NUDGE;
use crate::simd::lanes::{F, Mask, Simd, SimdFloat, V2, V3, all, clamp, select, sign_of};

/// Returns the surface of the body where rays meet it.
#[inline(always)]
pub fn surface<S: Simd>(
    simd: S,
    group: &PacketGroup,
    body: &PacketBody<S>,
    ray: &RestRays<S>,
    limits: Option<&Limits<S>>,
) -> Surface<S> {
    let (zero, one) = (all(simd, 0.0), all(simd, 1.0));
    let own = own_ray(simd, body, ray);
    let n = own.direction;
    let half = body.halves();
    let radius = half.x;
    let extent = half.z;
    // Across the axis. A ray along it is treated as turned by a millionth.
    let across_squared = n.x * n.x + n.y * n.y;
    let is_along = across_squared.simd_lt(1e-12);
    let sine = select(is_along, all(simd, 1e-6), across_squared.sqrt());
    let cosine = n.z.abs();
    let flat = V2::select(is_along, V2::new(one, zero), V2::new(n.x / sine, n.y / sine));
    // As seen along the ray: off the axis, and along its image.
    let towards = flat.dot(V2::new(own.nearest.x, own.nearest.y));
    let x = flat.x * own.nearest.y - flat.y * own.nearest.x;
    let y = sine * own.nearest.z - n.z * towards;
    let off_axis = V3::new(-flat.y, flat.x, zero);
    let along_axis = V3::new(-n.z * flat.x, -n.z * flat.y, sine);
    let chord = ((radius - x) * (radius + x)).max(0.0).sqrt();
    let image = CylinderImage { radius, extent, sine, cosine, x, y, chord, off_axis, along_axis };
    let CylinderOutline { clearance, outward } = image.outline();

    let rise = sign_of(n.z);
    let slope = cosine.max(1e-12);
    let enters_side = (-towards - chord) / sine;
    let enters_end = -(extent + rise * own.nearest.z) / slope;
    let leaves = ((chord - towards) / sine).min((extent - rise * own.nearest.z) / slope);
    let s = enters_side.max(enters_end).min(leaves);
    // A ray that misses has its place where it comes close.
    let reached = own.nearest + n * s;
    let shrunk = radius / V2::new(reached.x, reached.y).length().max(radius);
    let place = V3::new(reached.x * shrunk, reached.y * shrunk, clamp(reached.z, -extent, extent));
    let beyond = body.place.dot(ray.direction) + place.dot(n);
    if let Some(limits) = limits
        && limits.exclude(ray, clearance, beyond)
    {
        return Surface::excluded(simd);
    }

    let normal = if limits.is_some() {
        ray.direction
    } else {
        let faces = CylinderFaces { image, is_side: enters_side.simd_gt(enters_end), rise, place };
        body.rest_from_body(faces.normal(group, body, ray, beyond))
    };

    Surface {
        clearance,
        half_width: radius.min(extent * sine + radius * cosine),
        outward: body.rest_from_body(outward),
        beyond,
        place: body.rest_from_body(place),
        normal,
    }
}

/// A cylinder as it is seen along rays.
#[derive(Clone, Copy)]
struct CylinderImage<S: Simd> {
    radius: F<S>,
    extent: F<S>,
    /// Sine and cosine of the angle between ray and axis.
    sine: F<S>,
    cosine: F<S>,
    /// Place of the ray, off the image of the axis and along it.
    x: F<S>,
    y: F<S>,
    /// Half the chord of an end at that x.
    chord: F<S>,
    off_axis: V3<S>,
    along_axis: V3<S>,
}

/// The side of a cylinder and the end in sight of rays, in its own axes.
struct CylinderFaces<S: Simd> {
    image: CylinderImage<S>,
    /// Whether the ray meets the side.
    is_side: Mask<S>,
    /// Sign of the ray's direction along the axis.
    rise: F<S>,
    place: V3<S>,
}

impl<S: Simd> CylinderFaces<S> {
    /// Returns the normal of the surface that is met this far `beyond` the middle of the group: the mean of
    /// those in a pixel.
    #[inline(always)]
    fn normal(&self, group: &PacketGroup, body: &PacketBody<S>, ray: &RestRays<S>, beyond: F<S>) -> V3<S> {
        let &Self { image, is_side, rise, place } = self;
        let CylinderImage { radius, extent, sine, cosine, x, y, chord, off_axis, along_axis } = image;
        let zero = all(beyond.simd, 0.0);
        // The rim of the end in sight, as an ellipse about that end's middle. Where it is no outline, the
        // side adjoins.
        let from_end = y + rise * extent * sine;
        let rim = ellipse(x, from_end, radius, cosine);
        let across = body.rest_from_body(off_axis * rim.outward.x + along_axis * rim.outward.y);
        let width = select(is_side, cosine * chord, extent * sine) * 2.0 * rim.outward.y.abs();
        let adjoins = is_side | (from_end * rise).simd_gt(0.0);
        let other = share_of_other(group, rim.inside.abs(), width, across, ray, beyond);
        let share = select(adjoins, other, zero);
        let off_axis_length = V2::new(place.x, place.y).length().max(1e-30);
        let side_normal = V3::new(place.x / off_axis_length, place.y / off_axis_length, zero);
        let end_normal = V3::new(zero, zero, -rise);
        V3::mix(end_normal, side_normal, select(is_side, 1.0 - share, share))
    }
}

struct CylinderOutline<S: Simd> {
    /// Depth inside the outline.
    clearance: F<S>,
    /// Unit vector across it.
    outward: V3<S>,
}

impl<S: Simd> CylinderImage<S> {
    /// The outline: the ends are ellipses, and between their middles are two straight lines.
    #[inline(always)]
    fn outline(&self) -> CylinderOutline<S> {
        let Self { radius, extent, sine, cosine, x, y, chord, off_axis, along_axis } = *self;
        let beyond_end = y.abs() - extent * sine;
        let end = ellipse(x, beyond_end, radius, cosine);
        // Seen from the side an end is a line.
        let slant_length = V2::new(cosine * x, chord).length().max(1e-30);
        let slant = V2::new(cosine * x / slant_length, chord / slant_length);
        let to_end = (cosine * chord - beyond_end) * slant.y;
        let to_side = radius - x.abs();
        let is_end = beyond_end.simd_gt(0.0);
        let is_slant = to_end.simd_lt(to_side);
        let at_end = off_axis * end.outward.x + along_axis * (end.outward.y * sign_of(y));
        let at_slant = off_axis * slant.x + along_axis * (slant.y * sign_of(y));
        let between = V3::select(is_slant, at_slant, off_axis * sign_of(x));
        CylinderOutline {
            clearance: select(is_end, end.inside, select(is_slant, to_end, to_side)),
            outward: V3::select(is_end, at_end, between),
        }
    }
}

struct Ellipse<S: Simd> {
    /// Depth inside the ellipse, to first order near the outline.
    inside: F<S>,
    /// Unit vector across the outline.
    outward: V2<S>,
}

/// Returns the place of (x, y) in an ellipse with the half axes `radius` and `radius` times `cosine`.
#[inline(always)]
fn ellipse<S: Simd>(x: F<S>, y: F<S>, radius: F<S>, cosine: F<S>) -> Ellipse<S> {
    let level = V2::new(cosine * x, y).length();
    let gradient = V2::new(cosine * cosine * x, y);
    let steepness = gradient.length().max(1e-30);
    Ellipse {
        inside: level * (radius * cosine - level) / steepness,
        outward: V2::new(gradient.x / steepness, gradient.y / steepness),
    }
}

/// Returns the normal of the side or of an end, in the body's own axes: never a mean of both, where a pixel
/// shows both.
#[inline(always)]
pub fn pattern_normal<S: Simd>(body: &PacketBody<S>, place: V3<S>) -> V3<S> {
    let half = body.halves();
    let zero = all(half.x.simd, 0.0);
    let off = OffAxis::new(place);
    let is_end = (half.z - place.z.abs()).simd_lt(half.x - off.distance);
    let side = V3::new(off.outward.x, off.outward.y, zero);
    V3::select(is_end, V3::new(zero, zero, sign_of(place.z)), side)
}

/// Returns the chart of a place on the body, in its own axes. `shaders/cylinder.wgsl` computes the same.
#[inline(always)]
pub fn chart<S: Simd>(
    body: &PacketBody<S>,
    pattern: [f32; 3],
    place: V3<S>,
    normal: V3<S>,
) -> SurfacePlaces<S> {
    let half = body.halves();
    let simd = half.x.simd;
    let off = OffAxis::new(place);
    let is_side = normal.z.simd_eq(0.0);
    let on_end = half.z + normal.z * (half.z + half.x - off.distance);
    let inward = V3::new(-normal.z * off.outward.x, -normal.z * off.outward.y, all(simd, 0.0));
    SurfacePlaces {
        along: select(is_side, place.z + half.z, on_end),
        along_gradient: V3::select(is_side, along_axis(simd), inward),
        around: angle_to(place.y, place.x),
        around_gradient: off.around_gradient(),
        off_axis: off.distance,
        level: place.z - normal.z * (NUDGE as f32 * pattern[1]) + half.z,
        level_gradient: along_axis(simd),
    }
}
