//! Beams: a tile of the picture looks along a cone of rays in the rest frame of a group.

use std::f64::consts::FRAC_PI_2;

use glam::{DVec2, DVec3, Vec3};
use relativity_core::math::hypot;

use super::boxes::{Boxes, BoxesOn};
use crate::geometry::ray::Ray;
use crate::simd::lanes::{F, Simd, SimdFloat, all, select};
use crate::view::Geometry;
use crate::view::cap::Cap;
use crate::view::group_view::GroupView;

/// Squares below this are no longer accurate.
const LEAST_SQUARE: f64 = 1e-280;
/// Relative error of a place and an offset in f32.
pub(super) const ROUNDING: f32 = 1e-6;
/// Greatest spread of a beam for which the entry of its middle ray bounds that of others usefully.
const MOST_SPREAD: f32 = 0.1;
/// Least cosine of a beam for which bounding planes are of use: at smaller ones the planes that touch it are
/// all but one.
const LEAST_COSINE: f64 = 0.07;

/// A cone of rays, inside four planes through its tip that touch it.
#[derive(Debug, Clone, Copy)]
pub struct Beam {
    planes: [Plane; 4],
    /// The middle ray's direction.
    axis: Vec3,
    /// The greatest difference of another ray's direction from the axis.
    spread: f32,
    middle_ray: MiddleRay,
}

/// The middle ray of a beam, for where it enters boxes.
#[derive(Debug, Clone, Copy)]
struct MiddleRay {
    /// The point of the ray nearest to the middle of the group, from there.
    place: Vec3,
    /// The distance of that point from the tip of the beam.
    to_place: f32,
    /// Signs of its direction, and the reciprocals of its parts without these.
    towards: Vec3,
    reciprocals: Vec3,
    /// The greatest difference between other rays' and its own distance to their points nearest to the middle
    /// of the group.
    slack: f32,
}

/// A direction, without and with its signs, and how far along it something passes the middle of the group.
#[derive(Debug, Clone, Copy)]
struct Plane {
    normal: Vec3,
    size: Vec3,
    offset: f32,
}

/// A line, for one ray.
#[derive(Debug, Clone, Copy)]
pub struct BeamLine {
    /// Across it and each other.
    across: [Plane; 2],
    axis: Vec3,
}

/// A search for boxes.
pub trait Looks {
    /// Whether it is worth to look into the nearest of all boxes next, not of those in the last node.
    const IS_IN_ORDER: bool = false;

    /// Returns the least distance beyond the middle of the group at which each of `boxes` is met; infinity if
    /// it is missed.
    fn nearest<S: Simd>(&self, simd: S, boxes: &Boxes) -> F<S>;
}

impl BeamLine {
    /// Returns the line of `ray`, counted from its point nearest to `middle`.
    #[must_use]
    pub fn new(ray: &Ray, middle: DVec3) -> Self {
        let place = ray.start - middle;
        Self {
            across: across(ray.direction).map(|normal| Plane::new(normal, place)),
            axis: ray.direction.as_vec3(),
        }
    }
}

impl Looks for BeamLine {
    #[inline(always)]
    fn nearest<S: Simd>(&self, simd: S, boxes: &Boxes) -> F<S> {
        let boxes = boxes.on(simd);
        let mut excess = all(simd, f32::NEG_INFINITY);
        for plane in &self.across {
            let (middles, sizes) = boxes.along(plane.normal, plane.size);
            excess = excess.max((middles - plane.offset).abs() - ROUNDING * plane.offset.abs() - sizes);
        }
        let (middles, sizes) = boxes.along(self.axis, self.axis.abs() + ROUNDING);
        select(excess.simd_gt(0.0), all(simd, f32::INFINITY), middles - sizes)
    }
}

impl Beam {
    /// The rays of the lines of sight within the ground's `cap`, as `view` has them in its group, from near
    /// `middle`. `None` where they are too wide, or curved, to be told so.
    #[must_use]
    pub fn new(view: &GroupView, cap: &Cap, middle: DVec3) -> Option<Self> {
        let Cap { axis, sine, cosine } = in_rest_frame(cap, view)?;
        let [u, v] = across(axis);
        let planes = [u, -u, v, -v].map(|aside| {
            let along = axis * cosine + aside * sine;
            let (place, _) = Ray::new(view.origin, along).nearest_to(middle);
            Plane::new(aside * cosine - axis * sine, place)
        });
        // An angle is no more than pi/2 times its sine.
        let spread = (FRAC_PI_2 * sine * 1.01) as f32 + ROUNDING;
        let middle_ray = MiddleRay::new(&Ray::new(view.origin, axis), middle, spread);
        Some(Self { planes, axis: axis.as_vec3(), spread, middle_ray })
    }

    /// Returns the beam made no wider than `rays` in it, the first and the last of which are in opposite
    /// corners of about a square; they are counted from their points nearest to `middle`.
    #[must_use]
    pub fn around(&self, rays: &[Ray], middle: DVec3) -> Self {
        let [first, .., last] = rays else { return *self };
        let axis = rays[rays.len() / 2].direction;
        let [u, v] = across(axis);
        let off = |direction: DVec3| DVec2::new(u.dot(direction), v.dot(direction));
        // The sides of a square are half a right angle off its diagonal.
        let diagonal = off(last.direction) - off(first.direction);
        let Some(DVec2 { x, y }) = (diagonal + diagonal.perp()).try_normalize() else { return *self };
        let asides = [u * x + v * y, v * x - u * y];
        let mut extremes = [(f64::NEG_INFINITY, first); 4];
        for ray in rays {
            let ahead = axis.dot(ray.direction);
            if ahead < LEAST_COSINE {
                return *self;
            }
            let [right, down] = asides.map(|aside| aside.dot(ray.direction) / ahead);
            for (extreme, slope) in extremes.iter_mut().zip([right, -right, down, -down]) {
                if slope > extreme.0 {
                    *extreme = (slope, ray);
                }
            }
        }
        let plane = |i: usize, sign: f64| {
            let (_, Ray { direction, start, .. }) = extremes[i];
            let aside = asides[i / 2] * sign;
            Plane::new(aside * axis.dot(*direction) - axis * aside.dot(*direction), start - middle)
        };
        Self { planes: [plane(0, 1.0), plane(1, -1.0), plane(2, 1.0), plane(3, -1.0)], ..*self }
    }
}

impl MiddleRay {
    /// Takes the ray of a beam with this `spread`, in a group with this `middle`.
    fn new(ray: &Ray, middle: DVec3, spread: f32) -> Self {
        let (place, from_start) = ray.nearest_to(middle);
        let direction = ray.direction.as_vec3();
        let far = Vec3::splat(1e15);
        let place = place.as_vec3().clamp(-far, far);
        let to_place = (ray.from_camera + from_start) as f32;
        Self {
            place,
            to_place,
            towards: Vec3::ONE.copysign(direction),
            reciprocals: direction.abs().max(Vec3::splat(1e-12)).recip(),
            slack: (spread + ROUNDING) * (place.length() + to_place.abs()),
        }
    }

    /// Returns the least distance beyond the middle of the group at which a ray of a beam with this `spread`
    /// meets each of `boxes`: what it meets, as far from the tip as `most` beyond the middle, the middle ray
    /// has so near beside it that it is in a larger box.
    #[inline(always)]
    fn nearest<S: Simd>(&self, boxes: &BoxesOn<S>, spread: f32, most: F<S>) -> F<S> {
        let room = (most + self.to_place).max(0.0) * (spread * 1.2) + boxes.farthest() * ROUNDING;
        let mut entry = all(most.simd, f32::NEG_INFINITY);
        for axis in 0..3 {
            let (middles, halves) = boxes.across(axis);
            let offset = (middles - self.place[axis]) * self.towards[axis];
            entry = entry.max((offset - halves - room) * self.reciprocals[axis]);
        }
        entry - entry.abs() * 1e-5 - self.slack
    }
}

impl Plane {
    /// Through `place`, from the middle of the group.
    fn new(normal: DVec3, place: DVec3) -> Self {
        let offset = normal.dot(place) as f32;
        let normal = normal.as_vec3();
        Self { normal, size: normal.abs() + ROUNDING, offset }
    }
}

impl Looks for Beam {
    const IS_IN_ORDER: bool = true;

    #[inline(always)]
    fn nearest<S: Simd>(&self, simd: S, boxes: &Boxes) -> F<S> {
        let boxes = boxes.on(simd);
        let mut excess = all(simd, f32::NEG_INFINITY);
        for plane in &self.planes {
            let (middles, sizes) = boxes.along(plane.normal, plane.size);
            excess = excess.max(middles - sizes - (plane.offset + ROUNDING * plane.offset.abs()));
        }
        let (middles, sizes) = boxes.along(self.axis, self.axis.abs());
        let (most, room) = (middles + sizes, boxes.farthest() * self.spread);
        let mut nearest = middles - sizes - room;
        if self.spread < MOST_SPREAD {
            nearest = nearest.max(self.middle_ray.nearest(&boxes, self.spread, most));
        }
        let is_behind_tip = (most + room + self.middle_ray.slack + self.middle_ray.to_place).simd_lt(0.0);
        select(is_behind_tip | excess.simd_gt(0.0), all(simd, f32::INFINITY), nearest)
    }
}

/// Two unit vectors across `axis` and each other, each part of them as accurate as those of `axis`: rays of a
/// camera 1e30 away are turned from x by 1e-30.
pub(super) fn across(axis: DVec3) -> [DVec3; 2] {
    let square = axis.y * axis.y + axis.z * axis.z;
    let off_x = if square > LEAST_SQUARE { square.sqrt() } else { hypot(axis.y, axis.z) };
    if off_x == 0.0 {
        return [DVec3::Y, DVec3::Z];
    }
    let (y, z) = (axis.y / off_x, axis.z / off_x);
    [DVec3::new(-off_x, axis.x * y, axis.x * z), DVec3::new(0.0, -z, y)]
}

/// The rays in the rest frame of the group that `view` shows, whose lines of sight are in this `cap` on the
/// ground; `None` where they curve, or reach almost to a right angle.
fn in_rest_frame(cap: &Cap, view: &GroupView) -> Option<Cap> {
    let cap = match view.geometry {
        Geometry::Rest => *cap,
        Geometry::Seen => {
            let along_motion = Cap { axis: view.velocity.motion_from_camera(cap.axis), ..*cap };
            let cap = along_motion.in_rest_frame(&view.velocity.speed)?;
            Cap { axis: view.velocity.group_from_motion(cap.axis), ..cap }
        }
        Geometry::Contracted => stretched(cap, view)?,
        Geometry::OneCone | Geometry::Published => return None,
    };
    (cap.cosine > LEAST_COSINE).then_some(cap)
}

/// Returns a cap around the image of a cap when it is stretched by gamma along the motion: that of the four
/// corners of a pyramid around it, between which straight lines stay straight.
fn stretched(cap: &Cap, view: &GroupView) -> Option<Cap> {
    if cap.cosine < 0.5 {
        return None;
    }
    let stretched = |direction: DVec3| view.rest_ray(direction.normalize()).direction;
    let [u, v] = across(cap.axis).map(|aside| aside * (cap.sine / cap.cosine));
    let corners = [u + v, u - v, v - u, -u - v].map(|corner| stretched(cap.axis + corner));
    Some(Cap::around(stretched(cap.axis), corners))
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::super::testing::{inside, place};
    use super::*;
    use crate::geometry::hierarchy::boxes::WIDTH;

    /// `side` times as many, of a square this wide per distance, which is turned and looks at `middle`.
    fn rays(middle: DVec3, distance: f64, width: f64, side: u32) -> Vec<Ray> {
        let axis = DVec3::new(0.3, -1.0, 0.2).normalize();
        let (camera, [u, v]) = (middle - axis * distance, across(axis));
        let (right, down) = (u * 0.8 + v * 0.6, v * 0.8 - u * 0.6);
        let off = |i: u32| (f64::from(i) / f64::from(side - 1) - 0.5) * width;
        let one = |i: u32| axis + right * off(i % side) + down * off(i / side);
        (0..side * side).map(|i| Ray::new(camera, one(i).normalize()).counted_from(middle)).collect()
    }

    fn of_one(centre: Vec3, half: Vec3) -> Boxes {
        let all = |v: Vec3| v.to_array().map(|part| [part; WIDTH]);
        Boxes { centre: all(centre), half: all(half) }
    }

    /// Rays that look from this `distance` at the `middle` of many boxes, and the beam around them.
    fn beam_of(middle: DVec3, distance: f64, width: f64) -> (Vec<Ray>, Beam) {
        let (some, many) = (rays(middle, distance, width, 8), rays(middle, distance, width, 32));
        let (axis, spread) = (some[some.len() / 2].direction.as_vec3(), width as f32);
        let nothing = Plane { normal: Vec3::ZERO, size: Vec3::ZERO, offset: 1.0 };
        let middle_ray = MiddleRay::new(&some[some.len() / 2], middle, spread);
        let wide = Beam { planes: [nothing; 4], axis, spread, middle_ray };
        (many, wide.around(&some, middle))
    }

    fn box_of(number: u32) -> [DVec3; 2] {
        [place(number, 1.0), 0.1 * place(number + 7, 1.0).abs()]
    }

    /// Returns where `beam` meets the box of this `number` first, and where the first of `rays` does.
    fn first(number: u32, middle: DVec3, rays: &[Ray], beam: &Beam) -> (f32, Option<f64>) {
        let [centre, half] = box_of(number);
        let entries = rays.iter().filter_map(|ray| {
            let [from, until] = inside(ray, middle + centre, half)?;
            (until > -ray.from_camera).then_some(from.max(-ray.from_camera))
        });
        let boxes = of_one(centre.as_vec3(), half.as_vec3());
        (dispatch!(Level::new(), simd => beam.nearest(simd, &boxes)[0]), entries.reduce(f64::min))
    }

    #[test]
    fn around_rays_it_meets_what_they_meet_and_hardly_more() {
        let middle = DVec3::new(3.0, -2.0, 1.0);
        for (distance, width) in [(2.0, 0.4), (5.0, 0.1), (1e6, 5e-7), (1e12, 5e-13)] {
            let (rays, beam) = beam_of(middle, distance, width);
            let (mut met, mut told) = (0, 0);
            for number in 0..4000 {
                let (nearest, first) = first(number, middle, &rays, &beam);
                if let Some(first) = first {
                    assert!(f64::from(nearest) < first + 1e-5, "{nearest} for {first} from {distance}");
                    met += 1;
                }
                told += u32::from(nearest < f32::INFINITY);
            }
            assert!(met > 100 && told < met + met / 4, "{told} for {met} from {distance}");
        }
    }

    #[test]
    fn boxes_behind_the_camera_are_left_out() {
        let middle = DVec3::new(3.0, -2.0, 1.0);
        let (mut met, mut behind) = (0, 0);
        for (distance, width) in [(0.1, 0.05), (-0.4, 0.02), (0.6, 0.09)] {
            let (rays, beam) = beam_of(middle, distance, width);
            for number in 0..4000 {
                let (nearest, first) = first(number, middle, &rays, &beam);
                if let Some(first) = first {
                    assert!(f64::from(nearest) < first + 1e-5, "{nearest} for {first} from {distance}");
                    met += 1;
                }
                let [centre, half] = box_of(number);
                let axis = beam.axis.as_dvec3();
                if centre.dot(axis) + half.dot(axis.abs()) + distance < -0.4 {
                    assert_eq!(nearest, f32::INFINITY, "{number} from {distance}");
                    behind += 1;
                }
            }
        }
        assert!(met > 30 && behind > 1000, "{met} {behind}");
    }
}
