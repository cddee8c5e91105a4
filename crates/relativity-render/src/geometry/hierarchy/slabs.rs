//! A ray against boxes, between their pairs of planes: half the operations of a
//! [`BeamLine`](super::BeamLine), and the distance at which it enters.

use glam::{DVec3, Vec3};

use super::beam::{Looks, ROUNDING};
use super::boxes::Boxes;
use crate::geometry::ray::Ray;
use crate::simd::lanes::{F, Simd, SimdFloat, all, select};

/// The least part of a direction along an axis, so that its reciprocal is a number: what it turns a ray by is
/// below its rounding.
const LEAST_SLOPE: f32 = 1e-12;

/// A ray, or a part of one, for the planes of boxes.
#[derive(Debug, Clone, Copy)]
pub struct Slabs {
    start: Vec3,
    reciprocal: Vec3,
    /// Rounding of f32 across the ray, and what boxes are larger by.
    room: f32,
    /// Distances along the ray between which boxes are met.
    reach: [f32; 2],
}

impl Slabs {
    /// Returns the slabs of `ray`, which counts from its point nearest to `middle`.
    #[must_use]
    pub fn new(ray: &Ray, middle: DVec3) -> Self {
        Self::along(ray.start - middle, ray.direction)
    }

    /// Returns the slabs of the line between two places, for boxes that are larger by `room` on all sides.
    /// Distances count from the first.
    #[must_use]
    pub fn of_chord([from, to]: [DVec3; 2], room: f64) -> Self {
        let slabs = Self::along(from, (to - from).normalize_or(DVec3::X));
        let room = slabs.room + room as f32;
        Self { room, reach: [-room, from.distance(to) as f32 + room], ..slabs }
    }

    fn along(start: DVec3, direction: DVec3) -> Self {
        let start = start.as_vec3();
        let slope = |part: f64| (part as f32).abs().max(LEAST_SLOPE).copysign(part as f32);
        let [x, y, z] = direction.to_array().map(slope);
        Self {
            start,
            reciprocal: Vec3::new(x, y, z).recip(),
            room: ROUNDING * start.length(),
            reach: [f32::NEG_INFINITY, f32::INFINITY],
        }
    }
}

impl Looks for Slabs {
    #[inline(always)]
    fn nearest<S: Simd>(&self, simd: S, boxes: &Boxes) -> F<S> {
        let [mut enters, mut leaves] = self.reach.map(|end| all(simd, end));
        let boxes = boxes.on(simd);
        for axis in 0..3 {
            let (centre, half) = boxes.across(axis);
            let middle = (centre - self.start[axis]) * self.reciprocal[axis];
            let reach = (half + self.room) * self.reciprocal[axis].abs();
            enters = enters.max(middle - reach);
            leaves = leaves.min(middle + reach);
        }
        select(enters.simd_gt(leaves), all(simd, f32::INFINITY), enters)
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::super::boxes::WIDTH;
    use super::super::testing::{inside, looks, place};
    use super::*;

    #[test]
    fn a_ray_meets_the_boxes_that_it_meets_and_hardly_others() {
        let middle = DVec3::new(3.0, -2.0, 1.0);
        let along_axes = DVec3::AXES.map(|axis| Ray::new(middle - axis * 3.0, axis).counted_from(middle));
        for rays in looks(middle).chain([along_axes.to_vec()]) {
            let (mut met, mut found) = (0, 0);
            for number in 0..4000 {
                let ray = &rays[number as usize % rays.len()];
                let (centre, half) = (place(number, 1.5), 0.5 * place(number + 7, 1.0).abs());
                let parts = |v: DVec3| v.as_vec3().to_array().map(|part| [part; WIDTH]);
                let boxes = Boxes { centre: parts(centre), half: parts(half) };
                let slabs = Slabs::new(ray, middle);
                let nearest = dispatch!(Level::new(), simd => slabs.nearest(simd, &boxes)[0]);
                if let Some([entry, _]) = inside(ray, middle + centre, half - 1e-6) {
                    assert!(f64::from(nearest) < entry + 1e-5, "{nearest} for {entry}");
                    met += 1;
                }
                found += u32::from(nearest < f32::INFINITY);
            }
            // Rays along the axes are only three, and meet few boxes.
            assert!(met > 50 && found < met + met / 50 + 5, "{found} for {met}");
        }
    }
}
