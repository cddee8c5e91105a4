//! Straight rays against triangles.
//!
//! Reference: S. Woop, C. Benthin, I. Wald, *Watertight ray/triangle intersection*, Journal of Computer
//! Graphics Techniques 2 (2013), in f64: the corners are sheared so that the ray runs along an axis, and both
//! triangles at an edge decide by the same product on which side of it the ray passes.

use glam::DVec3;

use super::{TrianglePoint, Triangles, facing};
use crate::geometry::hierarchy::Slabs;
use crate::geometry::ray::Ray;

/// The place where a ray meets a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Crossing {
    /// Along the ray, from its start.
    pub distance: f64,
    pub point: TrianglePoint,
    /// Unit normal of the triangle, on the side from which the ray comes.
    pub normal: DVec3,
}

/// A ray, prepared for triangles.
struct ShearedRay {
    start: DVec3,
    direction: DVec3,
    /// Numbers of the axes across the ray, and of the one that is most along it.
    axes: [usize; 3],
    /// Shear across these axes, and scale along the last.
    shear: [f64; 3],
}

impl Triangles {
    /// Returns the first crossing of a ray with them, beyond the parameter `behind`: both from the middle of
    /// the box, along its axes. Of equally near ones that of the lowest number.
    pub(crate) fn crossing(&self, start: DVec3, direction: DVec3, behind: f64) -> Option<Crossing> {
        let ray = Ray::new(start, direction).counted_from(DVec3::ZERO);
        let sheared = ShearedRay::new(ray.start, direction);
        let behind = behind - ray.from_camera;
        // What f32 may be off by along the ray, of boxes beside triangles.
        let room = 1e-6 * self.half.length();
        let mut first: Option<(f64, u32, [f64; 2])> = None;
        self.hierarchy.along(&Slabs::new(&ray, DVec3::ZERO), |candidate| {
            let triangle = candidate.body;
            if let Some((distance, weights)) = self.met(&sheared, triangle)
                && distance > behind
                && first.is_none_or(|(nearest, number, _)| (distance, triangle) < (nearest, number))
            {
                first = Some((distance, triangle, weights));
            }
            first.map_or(f32::INFINITY, |(nearest, ..)| (nearest + room + 1e-6 * nearest.abs()) as f32)
        });
        let (distance, triangle, weights) = first?;
        let [a, b, c] = self.corners_of(triangle);
        let normal = facing((b - a).cross(c - a), direction);
        let point = TrianglePoint { triangle, weights: weights.map(|weight| weight as f32) };
        Some(Crossing { distance: ray.from_camera + distance, point, normal })
    }

    /// Returns the distance at which `ray` meets the triangle of this number, and the weights of its second
    /// and third corner there; `None` where it passes through a hole in it.
    fn met(&self, ray: &ShearedRay, triangle: u32) -> Option<(f64, [f64; 2])> {
        let corners = self.corners_of(triangle);
        let met = ray.met(corners)?;
        let [a, b, c] = corners;
        let is_front = || (b - a).cross(c - a).dot(ray.direction) < 0.0;
        ((self.is_two_sided || is_front()) && self.is_solid(triangle, met.1)).then_some(met)
    }
}

impl ShearedRay {
    fn new(start: DVec3, direction: DVec3) -> Self {
        let along = direction.abs().max_position();
        let [u, v] = [(along + 1) % 3, (along + 2) % 3];
        let scale = 1.0 / direction[along];
        let shear = [direction[u] * scale, direction[v] * scale, scale];
        Self { start, direction, axes: [u, v, along], shear }
    }

    fn met(&self, corners: [DVec3; 3]) -> Option<(f64, [f64; 2])> {
        let [u, v, along] = self.axes;
        let [shear_u, shear_v, scale] = self.shear;
        let sheared = corners.map(|corner| {
            let from_start = corner - self.start;
            [
                from_start[u] - shear_u * from_start[along],
                from_start[v] - shear_v * from_start[along],
                scale * from_start[along],
            ]
        });
        let [a, b, c] = sheared;
        let side = |from: [f64; 3], to: [f64; 3]| to[0] * from[1] - to[1] * from[0];
        let sides = [side(b, c), side(c, a), side(a, b)];
        if sides.iter().any(|&side| side < 0.0) && sides.iter().any(|&side| side > 0.0) {
            return None;
        }
        let sum: f64 = sides.iter().sum();
        if sum == 0.0 {
            return None;
        }
        let distance = (sides[0] * a[2] + sides[1] * b[2] + sides[2] * c[2]) / sum;
        Some((distance, [sides[1] / sum, sides[2] / sum]))
    }
}
