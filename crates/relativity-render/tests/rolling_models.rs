//! Models of triangles that roll, held against our exact wheel, a search in small steps along the light, and
//! the same model at rest.

use std::f64::consts::TAU;

use glam::{DQuat, DVec3};
use relativity_render::{
    Appearance, Body, Colour, Geometry, GroupView, HitImage, Method, Motion, PreparedScene, RawModel,
    Renderers, Shape, Spin, View,
};

use crate::models::{HUB, box_model, rolling, spin, view, wheel_model};
use crate::support::{centred, spread};

const GEOMETRIES: [Geometry; 4] = [Geometry::Seen, Geometry::Contracted, Geometry::Rest, Geometry::OneCone];

/// The triangle that light along a line of sight comes from, and its distance at rest, by a search in small
/// steps: where the sign of the volume between the ray's place and a triangle changes, the place is found by
/// halving.
fn stepped(model: &RawModel, spin: &Spin, of_group: &GroupView, sight: DVec3) -> Option<(f64, u32)> {
    const STEPS: u32 = 4000;
    let ray = of_group.rest_ray(sight);
    let middle = (DVec3::from(HUB) - ray.origin).dot(ray.direction);
    let reach = 1.7;
    let at = |s: f64| {
        let place = ray.origin + ray.direction * s;
        let angle = of_group.turn_at(spin, place);
        DVec3::from(HUB) + DQuat::from_rotation_y(-angle) * (place - DVec3::from(HUB))
    };
    let places: Vec<_> = (0..=STEPS)
        .map(|i| middle - reach + 2.0 * reach * f64::from(i) / f64::from(STEPS))
        .map(|s| (s, at(s)))
        .collect();
    let mut first: Option<(f64, u32)> = None;
    for (number, triangle) in (0..).zip(&model.triangles) {
        let [a, b, c] = triangle.map(|corner| DVec3::from(model.corners[corner as usize]));
        let across = (b - a).cross(c - a);
        let off = |place: DVec3| across.dot(place - a);
        for step in places.array_windows::<2>() {
            let [(mut low, from), (mut high, to)] = *step;
            if first.is_some_and(|(nearest, _)| low > nearest) {
                break;
            }
            if (off(from) > 0.0) == (off(to) > 0.0) {
                continue;
            }
            for _ in 0..60 {
                let half = 0.5 * (low + high);
                if (off(at(half)) > 0.0) == (off(from) > 0.0) { low = half } else { high = half }
            }
            let place = at(low);
            let inside =
                [(a, b), (b, c), (c, a)].iter().all(|(p, q)| (*q - *p).cross(place - *p).dot(across) >= 0.0);
            if inside && first.is_none_or(|(nearest, _)| low < nearest) {
                first = Some((low, number));
            }
        }
    }
    first
}

fn line_of_sight(view: &View, i: usize) -> DVec3 {
    let width = view.camera.size[0] as usize;
    view.camera.line_of_sight([(i % width) as f64 + 0.5, (i / width) as f64 + 0.5])
}

/// Triangles anyhow in a ball about the hub.
fn soup() -> RawModel {
    let corner = |i: u32| {
        let middle = 0.45 * centred(spread(i / 3));
        (DVec3::from(HUB) + middle + 0.25 * centred(spread(i + 7))).to_array()
    };
    RawModel {
        corners: (0..120).map(corner).collect(),
        triangles: (0..40).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
        is_two_sided: true,
        ..RawModel::default()
    }
}

#[test]
fn each_ray_meets_the_triangle_that_small_steps_along_the_light_meet_first() {
    for (model, radius) in [(box_model(), 1.2), (soup(), 1.25)] {
        let model = RawModel { is_two_sided: true, ..model };
        let (scene, spin) = (rolling(model.clone(), radius), spin(radius));
        for (beta, geometry) in [(0.93, Geometry::Seen), (0.6, Geometry::Contracted), (0.99, Geometry::Seen)]
        {
            let view = view(beta, geometry, [24, 18]);
            let of_group = view.of_group(Motion::Scene);
            let mut seen = 0;
            for (i, hit) in scene.hit_image(&view).hits.iter().enumerate() {
                let sight = line_of_sight(&view, i);
                let expected = stepped(&model, &spin, &of_group, sight);
                let found = hit.and_then(|hit| hit.triangle).map(|point| point.triangle);
                let Some((distance, triangle)) = expected else {
                    assert_eq!(found, None, "pixel {i} at {beta}");
                    continue;
                };
                let hit = hit.expect("it meets one");
                let ray = of_group.rest_ray(sight);
                let off = hit.rest_position.distance(ray.origin + ray.direction * distance);
                // Where two triangles of the box have a corner in common either may be met.
                assert!(off < 1e-6, "pixel {i} at {beta}: {off}, {found:?} for {triangle}");
                let material = DVec3::from(HUB)
                    + DQuat::from_rotation_y(-of_group.turn_at(&spin, hit.rest_position))
                        * (hit.rest_position - DVec3::from(HUB));
                assert!(material.distance(hit.material_position) < 1e-12);
                let point = hit.triangle.expect("of triangles");
                let [a, b, c] =
                    model.triangles[point.triangle as usize].map(|i| DVec3::from(model.corners[i as usize]));
                let normal = (b - a).cross(c - a).normalize();
                // Corners are rounded to f32.
                assert!(normal.dot(material - a).abs() < 3e-7, "{}", normal.dot(material - a));
                seen += 1;
            }
            assert!(seen > 30, "{seen} at {beta}");
        }
    }
}

fn inside(hits: &HitImage) -> Vec<bool> {
    hits.hits.iter().map(Option::is_some).collect()
}

/// Between the tori inside and outside which its squares lie, a torus of triangles that rolls is the exact
/// one.
#[test]
fn a_wheel_of_triangles_is_the_exact_wheel_within_their_sagitta() {
    let (radius, tube, around, sides) = (0.5, 0.06, 48, 10);
    let [turn, side] = [TAU / f64::from(around), TAU / f64::from(sides)];
    let sagitta = (radius + tube) * (1.0 - (0.5 * turn).cos()) + tube * (1.0 - (0.5 * side).cos());
    // Towards the axle chords lie outside, but for the rounding to f32.
    let beyond = (radius - tube) * (1.0 - (0.5 * turn).cos()) + 1e-6;
    let exact = |tube_radius| {
        let ring = Shape::Ring { centre: HUB, axis: [0.0, 1.0, 0.0], radius, tube_radius };
        PreparedScene::moving(&[Body::white(ring).turning(spin(radius + tube))])
    };
    let model = rolling(wheel_model(radius, tube, around, sides, 0), radius + tube);
    for beta in [0.5, 0.93, 0.999] {
        let view = view(beta, Geometry::Seen, [64, 48]);
        let [outer, inner] =
            [exact(tube + beyond), exact(tube - sagitta)].map(|scene| scene.hit_image(&view));
        let found = model.hit_image(&view);
        let masks = [&outer, &inner, &found].map(inside);
        for (i, hit) in found.hits.iter().enumerate() {
            assert!(masks[0][i] || !masks[2][i], "pixel {i} at {beta} is beyond the wheel");
            assert!(!masks[1][i] || masks[2][i], "pixel {i} at {beta} is a hole");
            if let Some(hit) = hit {
                let off = hit.material_position - DVec3::from(HUB);
                let from_tube = (off.with_y(0.0).length() - radius).hypot(off.y);
                assert!(from_tube < tube + beyond && from_tube > tube - sagitta, "{from_tube}");
            }
        }
        assert!(found.hits.iter().flatten().count() > 80);
    }
}

#[test]
fn at_rest_a_model_with_a_spin_is_the_model_that_stands() {
    let model = || wheel_model(0.5, 0.06, 16, 6, 5);
    let still = PreparedScene::moving(&[Body::of_triangles(model().prepared().expect("a model"))]);
    let wheel = rolling(model(), 0.6);
    let appearance = Appearance { colour: Colour::White, ..Appearance::default() };
    let mut renderers = Renderers::new(None);
    for geometry in GEOMETRIES {
        let view = view(0.0, geometry, [40, 30]);
        assert_eq!(
            still.picture(&view, &appearance, 2),
            wheel.picture(&view, &appearance, 2),
            "{geometry:?}"
        );
        if geometry == Geometry::OneCone {
            continue;
        }
        let mut picture =
            |scene| renderers.picture(Method::Packets, scene, &view, &appearance, 1).expect("a picture");
        assert_eq!(picture(&still), picture(&wheel), "{geometry:?}");
    }
}

/// The packets ask the reference for each ray, in the direction that f32 has: they may differ at outlines
/// alone.
#[test]
fn packets_show_what_the_reference_shows_of_a_rolling_model() {
    let scene = rolling(wheel_model(0.5, 0.06, 32, 8, 7), 0.6);
    let mut renderers = Renderers::new(None);
    for geometry in [Geometry::Seen, Geometry::Contracted] {
        for beta in [0.3, 0.93, 0.9999] {
            let view = view(beta, geometry, [64, 48]);
            let expected = scene.hit_image(&view).hits;
            let found = renderers.hits(Method::Packets, &scene, &view).expect("hits").hits;
            let mut others = 0;
            for (expected, found) in expected.iter().zip(&found) {
                let (Some(expected), Some(found)) = (expected, found) else {
                    others += u32::from(expected.is_some() != found.is_some());
                    continue;
                };
                let off = expected.rest_position.distance(found.rest_position);
                if expected.triangle.map(|point| point.triangle) != found.triangle.map(|point| point.triangle)
                {
                    others += 1;
                    continue;
                }
                assert!(off < 1e-4 * expected.distance.max(1.0), "{geometry:?} at {beta}: {off}");
                assert!((found.doppler_factor / expected.doppler_factor - 1.0).abs() < 1e-4);
                assert!(found.rest_normal.distance(expected.rest_normal) < 1e-4);
                assert!(
                    found.material_position.distance(expected.material_position)
                        < 1e-4 * expected.distance.max(1.0)
                );
            }
            assert!(others <= 8, "{others} pixels show another triangle: {geometry:?} at {beta}");
        }
    }
}
