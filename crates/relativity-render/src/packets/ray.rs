//! The rest-frame rays of pixels, and where along them things lie: `line_of_sight` of `shaders/frame.wgsl`, and
//! `shaders/rest_ray.wgsl`.

use super::body::{Group, Ray};
use super::mercator::conformal_line;
use crate::frame::Frame;
use crate::lanes::{F, Simd, SimdFloat, V2, V3, all, select};
use crate::pipelines::AmongOthers;
use crate::view::Geometry;

/// What is seen in a pixel's middle.
#[derive(Debug, Clone, Copy)]
pub struct Sight<S: Simd> {
    /// Unit vector towards the source, in the ground frame.
    pub n: V3<S>,
    /// 1/length of the unnormalised line of sight, by which steps to the next pixels are multiplied; those of a conformal
    /// picture are not.
    pub scale: F<S>,
}

/// How lines of sight pass a group.
#[derive(Debug, Clone, Copy)]
struct Passage<S: Simd> {
    /// Unit vector towards the source in the rest frame.
    direction: V3<S>,
    /// Ground distance per rest-frame distance.
    ground_per_rest: F<S>,
    doppler: F<S>,
}

/// Of the places `u` and `v` in the picture, px.
#[inline(always)]
pub fn line_of_sight<S: Simd>(simd: S, frame: &Frame, u: F<S>, v: F<S>) -> Sight<S> {
    let [pole_u, pole_v, fine_u, fine_v] = frame.pole;
    let offset = V2::new((u - pole_u) - fine_u, (v - pole_v) - fine_v);
    if frame.is_conformal() {
        let per_px = frame.base[3];
        let line = conformal_line(simd, frame, offset.x * per_px, offset.y * -per_px);
        return Sight { n: line / line.length(), scale: all(simd, 1.0) };
    }
    let right = V3::of_four(simd, frame.right) * offset.x;
    let down = V3::of_four(simd, frame.down) * offset.y;
    let unnormalised = V3::of_four(simd, frame.base) + right + down;
    let scale = 1.0 / unnormalised.length();
    Sight { n: unnormalised * scale, scale }
}

/// Returns the steps of the line of sight `sight` (unit vector) to the next pixel on the right, and to the one below. In a flat
/// picture, what is along it does not count.
#[inline(always)]
pub fn steps<S: Simd>(frame: &Frame, sight: V3<S>) -> [V3<S>; 2] {
    let simd = sight.x.simd;
    if !frame.is_conformal() {
        return [V3::of_four(simd, frame.right), V3::of_four(simd, frame.down)];
    }
    let along = V3::of_four(simd, frame.clip_right);
    let cosine = sight.dot(along);
    let across = sight - along * cosine;
    let right = along * across.dot(across) - across * cosine;
    [right * frame.base[3], across.cross(along) * frame.base[3]]
}

/// How the line of sight along the unit vector `sight` passes a group of this `speed`, with the `sign` of its motion.
#[inline(always)]
fn passage<S: Simd>(simd: S, sight: V3<S>, geometry: Geometry, speed: [f32; 4], sign: f32) -> Passage<S> {
    let [beta, one_minus_beta, per_gamma, _] = speed;
    let one = all(simd, 1.0);
    match geometry {
        Geometry::Seen | Geometry::Published | Geometry::OneCone => {
            let n = sight.reflected(sign);
            let transverse_squared = n.y * n.y + n.z * n.z;
            let one_plus_x = select(n.x.simd_lt(0.0), transverse_squared / (1.0 - n.x), 1.0 + n.x);
            let reciprocal = 1.0 / (one_minus_beta + beta * one_plus_x);
            let doppler = per_gamma * reciprocal;
            let direction = V3::new((one_plus_x - one_minus_beta) * reciprocal, n.y * doppler, n.z * doppler);
            Passage { direction: direction.reflected(sign), ground_per_rest: doppler, doppler }
        }
        Geometry::Contracted => {
            let flattened = V3::new(sight.x, sight.y * per_gamma, sight.z * per_gamma);
            let largest = flattened.abs().max_part();
            let scaled = flattened / largest;
            let reciprocal = 1.0 / scaled.length();
            Passage {
                direction: scaled * reciprocal,
                ground_per_rest: per_gamma * reciprocal / largest,
                doppler: one,
            }
        }
        Geometry::Rest => Passage { direction: sight, ground_per_rest: one, doppler: one },
    }
}

/// The rays of what is seen so.
#[inline(always)]
pub fn rest_ray<S: Simd>(simd: S, group: &Group, sight: Sight<S>) -> Ray<S> {
    let Group { frame, geometry } = *group;
    let Sight { n, scale } = sight;
    let Passage { direction, ground_per_rest, doppler } =
        passage(simd, n, geometry, frame.speed, frame.motion[0]);
    let centre = V3::of_four(simd, frame.middle);
    let moment = centre.cross(direction) + V3::of_four(simd, frame.middle_fine).cross(direction);
    let to_centre = centre.dot(direction);
    let steps = steps(frame, n);
    Ray { sight: n, scale, steps, direction, ground_per_rest, doppler, moment, to_centre }
}

/// How far the ray's direction (rest frame) moves along the unit vector `across`, perpendicular to it, from one pixel to
/// the next, to the right and down.
#[inline(always)]
pub fn movement<S: Simd>(group: &Group, ray: &Ray<S>, across: V3<S>) -> V2<S> {
    let Group { frame, geometry } = *group;
    let [beta, _, _, gamma] = frame.speed;
    let ground = match geometry {
        Geometry::Seen | Geometry::Published | Geometry::OneCone => {
            let transverse = across.y * ray.direction.y + across.z * ray.direction.z;
            let along = frame.motion[0] * (beta * gamma * transverse);
            V3::new(ray.doppler * across.x - along, across.y, across.z) * ray.doppler
        }
        Geometry::Contracted => V3::new(across.x * gamma, across.y, across.z) * ray.ground_per_rest,
        Geometry::Rest => across,
    };
    let turned = (ground - ray.sight * ray.sight.dot(ground)) * ray.scale;
    let [right, down] = ray.steps;
    V2::new(turned.dot(right), turned.dot(down))
}

/// Where the ray comes closest to `anchor` (from the group's middle), from there.
#[inline(always)]
pub fn nearest_to<S: Simd>(anchor: V3<S>, ray: &Ray<S>) -> V3<S> {
    -ray.direction.cross(ray.moment + anchor.cross(ray.direction))
}

/// Depth of what lies `beyond` the group's middle along its ray: 1 is nearest, 0 is nothing. Where there are several
/// groups, as `others` says.
#[inline(always)]
pub fn depth<S: Simd>(group: &Group, others: Option<AmongOthers>, ray: &Ray<S>, beyond: F<S>) -> F<S> {
    match others {
        None => 0.5 - beyond * group.frame.middle[3],
        Some(AmongOthers { is_reference: true, .. }) => depth_in_reference(group.frame, beyond),
        Some(AmongOthers { reference, .. }) => depth_of_distance(
            group.frame,
            reference,
            (ray.to_centre + beyond) * ray.ground_per_rest,
            ray.sight,
        ),
    }
}

/// The reference group has the middle half of all depths, from 3/4 to 1/4 over twice its reach.
#[inline(always)]
fn depth_in_reference<S: Simd>(frame: &Frame, beyond: F<S>) -> F<S> {
    0.5 - 0.5 * beyond * frame.reference_middle[3]
}

/// Depth of what is seen at `distance` (ground frame) along `sight`, among that of the reference group, which is seen in
/// this geometry: not that of one light cone for both eyes, whose lines of sight are curves.
#[inline(always)]
pub fn depth_of_distance<S: Simd>(frame: &Frame, reference: Geometry, distance: F<S>, sight: V3<S>) -> F<S> {
    let simd = distance.simd;
    let reference = passage(simd, sight, reference, frame.reference_speed, frame.motion[1]);
    let to_centre = V3::of_four(simd, frame.reference_middle).dot(reference.direction);
    let reach = 0.5 / frame.reference_middle[3];
    let near = (to_centre - reach) * reference.ground_per_rest;
    let far = (to_centre + reach) * reference.ground_per_rest;
    let scale = far.max(1.0);
    let before = 1.0 - 0.25 * distance / near;
    let behind = 0.25 * scale / (scale + (distance - far));
    let among = depth_in_reference(frame, distance / reference.ground_per_rest - to_centre);
    select(distance.simd_lt(near), before, select(distance.simd_gt(far), behind, among))
}
