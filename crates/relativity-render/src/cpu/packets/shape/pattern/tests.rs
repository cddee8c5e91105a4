//! Marks by packets, against the reference's at what it hits.

use glam::DVec3;
use relativity_core::{Aperture, Speed};

use super::mark;
use crate::camera::lines_of_sight::LinesOfSight;
use crate::colour::srgb_encoded;
use crate::cpu::packets::body::{PacketBody, PacketGroup};
use crate::cpu::packets::ray::{line_of_sight, rest_ray};
use crate::cpu::packets::testing::at_every_level;
use crate::frame::uniform::FrameUniform;
use crate::picture::hit::Hit;
use crate::scene::pattern::SampleShifts;
use crate::simd::lanes::{F, LANES, Simd, SimdBase as _, SimdFrom as _, V3, all};
use crate::{Appearance, Body, Camera, Gaze, Geometry, GroupView, Pattern, PreparedScene, Shape, View};

const PATTERNS: [Pattern; 7] = [
    Pattern::Faces,
    Pattern::Graticule { step_degrees: 30.0 },
    Pattern::Graticule { step_degrees: 5.0 },
    Pattern::Chequer { step: 0.1 },
    Pattern::Chequer { step: 0.01 },
    Pattern::Stripes { step: 0.1 },
    Pattern::Stripes { step: 0.004 },
];
const SHAPES: [Shape; 5] = [
    Shape::Sphere { centre: [-0.1, 3.1, 0.1], radius: 0.35 },
    Shape::Tube { from: [-0.7, 3.0, 0.0], to: [0.6, 3.3, 0.1], radius: 0.12 },
    Shape::Ring { centre: [-0.1, 3.2, 0.1], axis: [0.36, 0.48, 0.8], radius: 0.3, tube_radius: 0.1 },
    Shape::Box { centre: [0.1, 2.9, 0.1], half: [0.2, 0.25, 0.15], turn: [0.2, 0.4, 0.4, 0.8] },
    Shape::Cylinder { from: [-0.2, 2.9, 0.1], to: [0.2, 3.0, 0.1], radius: 0.2 },
];
const SIZE: u32 = 160;

fn view(geometry: Geometry, beta: f64) -> View {
    let camera = Camera::new(Aperture::default(), Gaze::STRAIGHT_AHEAD, 0.4, [SIZE; 2]);
    let speed = Speed::from_beta(beta).expect("below 1");
    let moment = View { camera, speed, observation_time: 0.0, geometry };
    // Then what passed the origin is seen straight ahead.
    let observation_time = match geometry {
        Geometry::Seen => 3.1,
        _ => 0.0,
    };
    View { observation_time, ..moment }
}

/// A question to a packet: pixels, and the reference's hits there.
struct Asked<'a> {
    scene: &'a PreparedScene,
    view: &'a GroupView,
    frame: &'a FrameUniform,
    u: [f32; LANES],
    v: f32,
    hits: [Hit; LANES],
}

#[inline(always)]
fn found<S: Simd>(simd: S, asked: &Asked) -> [f32; LANES] {
    let body = &asked.scene.bodies()[0];
    let group = PacketGroup { frame: asked.frame, geometry: asked.view.geometry };
    let sight = line_of_sight(simd, asked.frame, F::simd_from(simd, asked.u), all(simd, asked.v));
    let ray = rest_ray(simd, &group, sight);
    let own = PacketBody::new(simd, &body.placement);
    let centre = asked.scene.solid(0).centre();
    let lanes = |part: &dyn Fn(&Hit) -> DVec3| {
        let axis = |axis: usize| F::from_fn(simd, |lane| part(&asked.hits[lane])[axis] as f32);
        V3::new(axis(0), axis(1), axis(2))
    };
    let place = lanes(&|hit| hit.rest_position - centre);
    let normal = lanes(&|hit| hit.rest_normal);
    let distance = F::from_fn(simd, |lane| asked.hits[lane].distance as f32);
    mark(simd, body.kind, &group, &own, body.pattern(), place, normal, &ray, distance).into()
}

fn expected(asked: &Asked, sights: &LinesOfSight, lane: usize) -> f64 {
    let hit = &asked.hits[lane];
    let place = [f64::from(asked.u[lane]), asked.v.into()];
    let ray = asked.view.rest_ray(sights.through(place));
    let shifts = sights.turns(place).map(|turn| asked.view.shift(&ray, turn) * hit.distance);
    asked.scene.mark(hit, SampleShifts::new(ray.direction, hit.rest_normal, shifts))
}

#[test]
fn marks_are_the_references() {
    let geometries =
        [(Geometry::Seen, 0.9), (Geometry::Seen, 0.2), (Geometry::Contracted, 0.9), (Geometry::Rest, 0.6)];
    let (mut worst, mut checked) = (0.0f64, 0);
    for (geometry, beta) in geometries {
        let view = view(geometry, beta);
        let sights = view.camera.lines_of_sight();
        for shape in SHAPES {
            for pattern in PATTERNS {
                let body = Body { pattern, ..Body::new(shape, 600.0) };
                let scene = PreparedScene::moving(&[body]);
                let views = scene.group_views(&view);
                let frame = FrameUniform::of_groups(&scene, &views, &Appearance::default())[0];
                for v in (0..SIZE).step_by(9) {
                    let hit = |u: u32| {
                        let hit = scene
                            .first_hit(&view, sights.through([f64::from(u) + 0.5, f64::from(v) + 0.5]))?;
                        Some((u as f32 + 0.5, hit))
                    };
                    let row: Vec<_> = (0..SIZE).filter_map(hit).collect();
                    for packet in row.as_chunks::<LANES>().0 {
                        let asked = Asked {
                            scene: &scene,
                            view: &views[0],
                            frame: &frame,
                            u: packet.map(|(u, _)| u),
                            v: v as f32 + 0.5,
                            hits: packet.map(|(_, hit)| hit),
                        };
                        let mut first = None;
                        at_every_level!(simd => {
                            let found = found(simd, &asked);
                            assert_eq!(found, *first.get_or_insert(found), "{geometry:?} {shape:?} {pattern:?}");
                            for (lane, found) in found.into_iter().enumerate() {
                                let expected = expected(&asked, &sights, lane);
                                let off = 255.0 * (srgb_encoded(found.into()) - srgb_encoded(expected)).abs();
                                worst = worst.max(off);
                                checked += 1;
                                assert!(off < 2.0, "{geometry:?} {shape:?} {pattern:?} at {:?}: {} for {expected}",
                                    asked.hits[lane], found);
                            }
                        });
                    }
                }
            }
        }
    }
    println!("{checked} marks, at most {worst} levels off");
    assert!(checked > 50_000);
}
