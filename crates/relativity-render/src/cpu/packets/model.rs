//! Rays against models of triangles: each lane looks through the hierarchy for itself, in each sample of its
//! pixel.
//!
//! The ray is that of the other bodies, in f32; from there on places are in f64. Of a model that turns, each
//! lane asks the reference.

use glam::DVec3;

use super::body::{PacketBody, PacketGroup, RestRays, own_ray};
use super::light::colour::Hatched;
use super::light::received::{Element, PaintThere};
use super::light::tables::Tables;
use super::look::{Look, Seen};
use super::ray::height_on_ground;
use super::shape::pattern::shifts;
use super::wheel::turning::TurningBody;
use crate::geometry::intersect::Entry;
use crate::geometry::ray::Ray as Near;
use crate::geometry::triangles::Triangles;
use crate::scene::pattern::SampleShifts;
use crate::scene::wheel::solid::TurningSolid;
use crate::simd::lanes::{F, LANES, Mask, Simd, SimdFloat, SimdFrom, V3};
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

/// The meeting of one ray with a model.
struct ModelMeeting {
    /// Along the ray; the point and the unit normal there.
    distance: f64,
    place: DVec3,
    normal: DVec3,
    paint: [f64; 3],
    triangle: u32,
}

/// The meetings of eight rays, as each was found.
struct FoundMeetings<S: Simd> {
    holds: Mask<S>,
    distance: F<S>,
    place: V3<S>,
    normal: V3<S>,
    paint: V3<S>,
    triangle: F<S>,
}

impl<S: Simd> FoundMeetings<S> {
    /// Finds them lane by lane.
    #[inline(always)]
    fn new(simd: S, mut meeting: impl FnMut(usize) -> Option<ModelMeeting>) -> Self {
        let mut holds = [0_i32; LANES];
        let mut distances = [0.0; LANES];
        let mut numbers = [0.0; LANES];
        let [mut places, mut normals, mut paints] = [[[0.0; LANES]; 3]; 3];
        for lane in 0..LANES {
            let Some(ModelMeeting { distance, place, normal, paint, triangle }) = meeting(lane) else {
                continue;
            };
            holds[lane] = -1;
            distances[lane] = distance as f32;
            numbers[lane] = triangle as f32;
            put(&mut places, lane, place.to_array());
            put(&mut normals, lane, normal.to_array());
            put(&mut paints, lane, paint);
        }
        Self {
            holds: Mask::simd_from(simd, holds),
            distance: F::simd_from(simd, distances),
            place: vectors(simd, places),
            normal: vectors(simd, normals),
            paint: vectors(simd, paints),
            triangle: F::simd_from(simd, numbers),
        }
    }
}

impl<S: Simd> Meetings<S> {
    /// Returns the meetings of these rays with `triangles` in the box that is `body`: of `side` times `side`
    /// samples to a pixel.
    #[inline(always)]
    pub fn new(
        simd: S,
        triangles: &Triangles,
        group: &PacketGroup<'_>,
        body: &PacketBody<S>,
        ray: &RestRays<S>,
        side: f64,
    ) -> Self {
        let own = own_ray(simd, body, ray);
        let along = body.place.dot(ray.direction);
        let to_middle = ray.to_centre + along;
        let [right, down] = shifts(group, ray);
        let shifts = [
            body.body_from_rest(right * ray.ground_per_rest),
            body.body_from_rest(down * ray.ground_per_rest),
        ];
        let found = FoundMeetings::new(simd, |lane| {
            let start = vector(own.nearest, lane);
            let direction = vector(own.direction, lane).normalize_or_zero();
            let is_off = start.length_squared() >= triangles.half().length_squared();
            if is_off || !start.is_finite() || direction == DVec3::ZERO {
                return None;
            }
            let behind = -f64::from(to_middle[lane]);
            let crossing = triangles.crossing(start, direction, behind)?;
            let covered = || {
                let distance = (f64::from(to_middle[lane]) + crossing.distance) / side;
                SampleShifts::new(
                    direction,
                    crossing.normal,
                    shifts.map(|shift| vector(shift, lane) * distance),
                )
            };
            Some(ModelMeeting {
                distance: crossing.distance,
                place: start + direction * crossing.distance,
                normal: crossing.normal,
                paint: triangles.paint_over(crossing.point, |gradient| covered().range(gradient)),
                triangle: crossing.point.triangle,
            })
        });
        Self {
            holds: found.holds,
            beyond: along + found.distance,
            place: body.rest_from_body(found.place),
            normal: body.rest_from_body(found.normal),
            paint: found.paint,
            triangle: found.triangle,
            doppler: ray.doppler,
            distance: (to_middle + found.distance) * ray.ground_per_rest,
        }
    }

    /// Returns the meetings of these rays with the model that is `seen`, and turns: from their lines of sight
    /// on in f64, as the reference has them, for `triangles` that stand nowhere.
    #[inline(always)]
    pub fn with_turning(
        simd: S,
        look: &Look<'_>,
        seen: &Seen<'_>,
        turning: &TurningSolid,
        triangles: &Triangles,
        ray: &RestRays<S>,
        side: f64,
    ) -> Self {
        let (number, there) = (seen.number, TurningBody::new(simd, look.group(seen.body.group), seen));
        let (view, solid) = (&look.views[seen.body.group], look.scene.solid(number));
        let middle = look.scene.groups()[seen.body.group].extent.middle;
        let sight_axes = view.velocity.sight_axes();
        let [right, down] = shifts(&there.group, ray);
        let shifts = [right * ray.ground_per_rest, down * ray.ground_per_rest];
        let found = FoundMeetings::new(simd, |lane| {
            let sight = sight_axes * vector(ray.sight, lane);
            let rest = view.rest_ray(sight.try_normalize()?);
            let near = Near::new(rest.origin, rest.direction).counted_from(middle);
            let entry = look.scene.turning_entry(number, turning, &near, view, None).0?;
            let Entry { distance, position, normal, triangle } = entry;
            let covered = || {
                let distance = (near.from_camera + distance) / side;
                let shifts = shifts.map(|shift| vector(shift, lane) * distance);
                let covered = SampleShifts::new(rest.direction, normal, shifts);
                let turn = view.turn_at(&seen.body.spin?, position);
                Some(covered.turned_back(turn))
            };
            let range =
                |gradient| covered().map_or(0.0, |covered| covered.range(solid.rest_from_box(gradient)));
            Some(ModelMeeting {
                distance,
                place: position - middle - vector(there.body.place, lane),
                normal,
                paint: triangles.paint_over(triangle?, range),
                triangle: triangle?.triangle,
            })
        });
        let FoundMeetings { holds, distance: beyond, place, normal, paint, triangle } = found;
        let doppler = there.doppler(place, normal, ray);
        let distance = (ray.to_centre + beyond) * ray.ground_per_rest;
        Self { holds, beyond, place, normal, paint, triangle, doppler, distance }
    }

    /// Returns where they meet it and not below the ground.
    #[inline(always)]
    pub fn above_ground(&self, group: &PacketGroup<'_>, body: &PacketBody<S>) -> Mask<S> {
        let height = body.place.z + self.place.z + group.frame.middle[2];
        let height = height_on_ground(group, height, body.place + self.place);
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
        let seen = look.seen(number);
        let turning = TurningBody::new(simd, look.group(look.scene.group_of(number)), &seen);
        let Self { place, normal, doppler, .. } = *self;
        let there = Element { seen: &seen, turning: &turning, place, normal, doppler };
        let on = |paint| there.colour(simd, look, appearance, tables, Some(paint), hatched);
        let mut colour = on(PaintThere::Smooth(self.paint));
        let Some(triangles) = &seen.body.triangles else { return colour };
        let numbers: [f32; LANES] = self.triangle.into();
        let materials = numbers.map(|number| triangles.material(number as u32));
        let mut drawn = None;
        for material in materials.into_iter().flatten() {
            if drawn.replace(material) != Some(material) {
                let of = materials.map(|other| -i32::from(other == Some(material)));
                let measured = on(PaintThere::Measured(material, self.paint));
                colour = V3::select(Mask::simd_from(simd, of), measured, colour);
            }
        }
        colour
    }
}

/// The vector in a lane.
fn vector<S: Simd>(v: V3<S>, lane: usize) -> DVec3 {
    DVec3::from(v.lane(lane).map(f64::from))
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
