//! Rays against models of triangles: each lane looks through the hierarchy for itself, in each sample of its pixel.
//!
//! The ray is that of the other bodies, in f32; from there on places are in f64.

use glam::DVec3;

use super::body::{Body, Group, Ray, own_ray};
use super::colour::Hatched;
use super::look::Look;
use super::pattern::shift;
use super::received::Element;
use super::spin::Spin;
use super::tables::Tables;
use crate::lanes::{F, LANES, Mask, Simd, SimdFloat, SimdFrom, V3};
use crate::pattern::Covered;
use crate::triangles::Triangles;
use crate::view::Appearance;

/// The meetings of eight rays with a model.
#[derive(Debug, Clone, Copy)]
pub struct Meetings<S: Simd> {
    /// The rays that meet it, in front of the camera.
    pub holds: Mask<S>,
    /// Rest-frame distance along the ray beyond the middle of its group.
    pub beyond: F<S>,
    /// The point, from the middle of the model's box, and the unit normal there.
    pub place: V3<S>,
    pub normal: V3<S>,
    pub paint: V3<S>,
    /// Number of the triangle.
    pub triangle: F<S>,
    /// Doppler factor of the light from there.
    pub doppler: F<S>,
    /// From the camera, ground frame.
    pub distance: F<S>,
}

/// A model in the samples of a packet.
pub struct ModelPart<S: Simd, const N: usize> {
    /// Place of the packet in the tile.
    pub place: usize,
    /// Place of the model in the list of the tile's bodies.
    pub owner: usize,
    pub samples: [Meetings<S>; N],
}

impl<S: Simd> Meetings<S> {
    /// Returns the meetings of these rays with `triangles` in the box that is `body`: of `side` times `side` samples to a pixel.
    pub fn new(
        simd: S,
        triangles: &Triangles,
        group: &Group<'_>,
        body: &Body<S>,
        ray: &Ray<S>,
        side: f64,
    ) -> Self {
        let own = own_ray(simd, body, ray);
        let along = body.place.dot(ray.direction);
        let to_middle = ray.to_centre + along;
        let shifts = (!triangles.textures().is_empty()).then(|| {
            ray.steps.map(|step| body.body_from_rest(shift(group, ray, step) * ray.ground_per_rest))
        });
        let mut holds = [0_i32; LANES];
        let mut distances = [0.0; LANES];
        let mut numbers = [0.0; LANES];
        let [mut places, mut normals, mut paints] = [[[0.0; LANES]; 3]; 3];
        for lane in 0..LANES {
            let start = DVec3::from(own.nearest.lane(lane).map(f64::from));
            let direction = DVec3::from(own.direction.lane(lane).map(f64::from)).normalize_or_zero();
            let is_off = start.length_squared() >= triangles.half().length_squared();
            if is_off || !start.is_finite() || direction == DVec3::ZERO {
                continue;
            }
            let behind = -f64::from(to_middle[lane]);
            let Some(crossing) = triangles.crossing(start, direction, behind) else { continue };
            holds[lane] = -1;
            distances[lane] = crossing.distance as f32;
            numbers[lane] = crossing.point.triangle as f32;
            let place = start + direction * crossing.distance;
            put(&mut places, lane, place.to_array());
            put(&mut normals, lane, crossing.normal.to_array());
            let covered = || {
                let distance = (f64::from(to_middle[lane]) + crossing.distance) / side;
                let shift = |shift: V3<S>| DVec3::from(shift.lane(lane).map(f64::from)) * distance;
                shifts.map_or(Covered::NOTHING, |shifts| {
                    Covered::new(direction, crossing.normal, shifts.map(shift))
                })
            };
            put(
                &mut paints,
                lane,
                triangles.paint_over(crossing.point, |gradient| covered().range(gradient)),
            );
        }
        let distance = F::simd_from(simd, distances);
        Self {
            holds: Mask::simd_from(simd, holds),
            beyond: along + distance,
            place: body.rest_from_body(vectors(simd, places)),
            normal: body.rest_from_body(vectors(simd, normals)),
            paint: vectors(simd, paints),
            triangle: F::simd_from(simd, numbers),
            doppler: ray.doppler,
            distance: (to_middle + distance) * ray.ground_per_rest,
        }
    }

    /// Returns where they meet it and not below the ground.
    #[inline(always)]
    pub fn above_ground(&self, group: &Group<'_>, body: &Body<S>) -> Mask<S> {
        let height = body.place.z + self.place.z + group.frame.middle[2];
        self.holds & height.simd_ge(group.frame.ground[2])
    }

    /// Linear sRGB of the model that is the body of this `number`, where the rays meet it.
    #[inline(always)]
    pub fn colour(
        &self,
        simd: S,
        look: &Look<'_>,
        appearance: &Appearance,
        tables: &Tables,
        number: usize,
        hatched: Hatched<'_>,
    ) -> V3<S> {
        let (group, seen) = (look.group(look.scene.group_of(number)), look.seen(number));
        let (body, spin) = (Body::new(simd, &seen.shown.placement), Spin::new(simd, &seen.shown));
        let Self { place, normal, doppler, .. } = *self;
        let there = Element { group: &group, seen: &seen, body: &body, spin: &spin, place, normal, doppler };
        let colour = there.colour(simd, look, appearance, tables, hatched);
        let mut factors = [[0.0; LANES]; 3];
        for lane in 0..LANES {
            put(&mut factors, lane, appearance.paint(self.paint.lane(lane).map(f64::from)));
        }
        colour.times(vectors(simd, factors))
    }
}

fn put(parts: &mut [[f32; LANES]; 3], lane: usize, values: [f64; 3]) {
    for (part, value) in parts.iter_mut().zip(values) {
        part[lane] = value as f32;
    }
}

#[inline(always)]
fn vectors<S: Simd>(simd: S, [x, y, z]: [[f32; LANES]; 3]) -> V3<S> {
    V3::new(F::simd_from(simd, x), F::simd_from(simd, y), F::simd_from(simd, z))
}
