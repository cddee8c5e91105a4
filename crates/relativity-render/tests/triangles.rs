//! Models of triangles against what they stand for: our exact box and ball, and every triangle tested one by
//! one.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use relativity_render::geometry::shape::strokes::Onlooker;
use relativity_render::{
    Appearance, Body, Colour, Geometry, HitImage, Method, PreparedScene, RawModel, Renderers, Shape,
    TrianglesError, View,
};

use crate::models::{ball_model, box_model, exact_box, scene_of, soup, view};

const GEOMETRIES: [Geometry; 4] = [Geometry::Seen, Geometry::Contracted, Geometry::Rest, Geometry::OneCone];

fn hits_of(model: RawModel, view: &View) -> HitImage {
    scene_of(model).hit_image(view)
}

#[test]
fn a_box_of_twelve_triangles_is_the_box() {
    let (exact, model) = (PreparedScene::moving(&[Body::white(exact_box())]), scene_of(box_model()));
    for geometry in GEOMETRIES {
        for beta in [0.0, 0.6, 0.93, 0.9999] {
            let view = view(beta, geometry, [64, 48]);
            let (expected, found) = (exact.hit_image(&view).hits, model.hit_image(&view).hits);
            for (expected, found) in expected.iter().zip(&found) {
                let context = format!("{geometry:?} at {beta}: {expected:?} and {found:?}");
                let (Some(expected), Some(found)) = (expected, found) else {
                    assert_eq!(expected.is_some(), found.is_some(), "{context}");
                    continue;
                };
                assert!(expected.rest_position.distance(found.rest_position) < 1e-12, "{context}");
                assert!(expected.rest_normal.distance(found.rest_normal) < 1e-12, "{context}");
                assert!((expected.distance / found.distance - 1.0).abs() < 1e-12, "{context}");
                assert!((expected.doppler_factor / found.doppler_factor - 1.0).abs() < 1e-12, "{context}");
            }
            let appearance = Appearance { colour: Colour::White, ..Appearance::default() };
            let pictures = [&exact, &model].map(|scene| scene.picture(&view, &appearance, 2));
            assert_eq!(pictures[0], pictures[1], "{geometry:?} at {beta}");
        }
    }
}

/// A ray that misses the ball of triangles misses the ball, or passes inside its outline by no more than the
/// sagitta of the triangles, and none that meets it misses the ball.
#[test]
fn a_ball_of_triangles_is_a_ball_within_their_sagitta() {
    let (centre, radius, rings) = ([0.0, 4.0, 0.5], 0.6, 24);
    // The middle of a square's diagonal is farthest inside.
    let sagitta = radius * (1.0 - (0.5 * 2f64.sqrt() * PI / f64::from(rings)).cos());
    let ball = |radius| PreparedScene::moving(&[Body::white(Shape::Sphere { centre, radius })]);
    let model = scene_of(ball_model(centre, radius, rings));
    for beta in [0.0, 0.8, 0.99] {
        let view = view(beta, Geometry::Seen, [96, 72]);
        let [outer, inner] = [ball(radius), ball(radius - sagitta)].map(|scene| scene.hit_image(&view).hits);
        let found = model.hit_image(&view).hits;
        assert!(found.iter().flatten().count() > 300);
        for ((outer, inner), found) in outer.iter().zip(&inner).zip(&found) {
            assert!(found.is_none() || outer.is_some(), "beyond the ball at {beta}");
            assert!(found.is_some() || inner.is_none(), "a hole at {beta}");
            let off = found.map(|hit| radius - hit.rest_position.distance(centre.into()));
            assert!(off.is_none_or(|off| off > -1e-7 && off < sagitta + 1e-7), "{off:?} of {sagitta}");
        }
    }
}

/// Crossing of a ray with a triangle by Cramer's rule, in place of the hierarchy and of its test.
fn crossing(origin: DVec3, direction: DVec3, [a, b, c]: [DVec3; 3]) -> Option<f64> {
    let (u, v, from) = (b - a, c - a, origin - a);
    let determinant = direction.dot(u.cross(v));
    let [s, t] = [direction.dot(from.cross(v)) / determinant, direction.dot(u.cross(from)) / determinant];
    (s >= 0.0 && t >= 0.0 && s + t <= 1.0).then(|| -from.dot(u.cross(v)) / determinant)
}

#[test]
fn of_a_thousand_triangles_each_ray_meets_the_first() {
    for is_two_sided in [true, false] {
        let model = soup(is_two_sided);
        let corners: Vec<_> = model.corners.iter().map(|&corner| DVec3::from(corner)).collect();
        let mut seen = 0;
        for beta in [0.3, 0.97] {
            let view = view(beta, Geometry::Seen, [48, 36]);
            let found = hits_of(model.clone(), &view);
            let of_group = view.of_group(relativity_render::Motion::Scene);
            for (i, hit) in found.hits.iter().enumerate() {
                let place = [(i % 48) as f64 + 0.5, (i / 48) as f64 + 0.5];
                let ray = of_group.rest_ray(view.camera.line_of_sight(place));
                let all = model.triangles.iter().enumerate().filter_map(|(number, triangle)| {
                    let corners = triangle.map(|corner| corners[corner as usize]);
                    let [a, b, c] = corners;
                    let is_front = (b - a).cross(c - a).dot(ray.direction) < 0.0;
                    let distance = crossing(ray.origin, ray.direction, corners)?;
                    (distance > 0.0 && (is_two_sided || is_front)).then_some((distance, number))
                });
                let first = all.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, number)| number as u32);
                let triangle = hit.and_then(|hit| hit.triangle).map(|point| point.triangle);
                assert_eq!(triangle, first, "pixel {i} at {beta}");
                seen += u32::from(first.is_some());
            }
        }
        assert!(seen > 800, "{seen}");
    }
}

#[test]
fn paint_is_mixed_between_corners_and_is_no_effect_of_false_colours() {
    let mut model = box_model();
    model.paints =
        model.corners.iter().map(|corner| [if corner[0] > 0.0 { 1.0 } else { 0.0 }, 0.5, 0.0]).collect();
    let triangles = model.clone().prepared().expect("a model");
    let painted = PreparedScene::moving(&[Body::of_triangles(triangles.clone())]);
    let white = scene_of(box_model());
    let view = view(0.6, Geometry::Seen, [64, 48]);
    for hit in painted.hit_image(&view).hits.iter().flatten() {
        let [red, green, blue] = triangles.paint(hit.triangle.expect("of triangles"));
        assert!((red - (0.5 + 0.5 * hit.rest_position.x)).abs() < 1e-6, "{red} at {}", hit.rest_position);
        assert!((green - 0.5).abs() < 1e-6 && blue == 0.0);
    }
    let appearance = Appearance {
        colour: Colour::White,
        doppler_shift: false,
        intensity_exponent: None,
        sky: false,
        ..Appearance::default()
    };
    let [colours, plain] = [&painted, &white].map(|scene| scene.picture(&view, &appearance, 1).rgba);
    let pixels = || colours.iter().zip(&plain).filter(|(painted, white)| painted != white);
    assert!(
        pixels().count() > 300 && pixels().all(|(painted, white)| painted[2] == 0 && painted[1] < white[1])
    );
    let map = Appearance { colour: Colour::False, ..appearance };
    let picture = painted.picture(&view, &map, 1).rgba;
    assert!(picture.iter().zip(&plain).any(|(map, white)| map != white && map[2] > 0));
}

/// Renderers without a device.
fn renderers() -> Renderers {
    Renderers::new(None)
}

#[test]
fn packets_meet_the_triangles_that_the_reference_meets() {
    let (model, mut renderers) = (soup(true), renderers());
    let (corners, scene) = (model.corners.clone(), scene_of(model.clone()));
    let (mut covered, mut other) = (0, 0);
    for geometry in [Geometry::Seen, Geometry::Contracted, Geometry::Rest] {
        for beta in [0.0, 0.9, 0.9999] {
            let view = view(beta, geometry, [96, 72]);
            let expected = scene.hit_image(&view).hits;
            {
                let found = renderers.hits(Method::Packets, &scene, &view).expect("it needs no device").hits;
                for (expected, found) in expected.iter().zip(&found) {
                    covered += u32::from(expected.is_some());
                    other += u32::from(expected.is_some() != found.is_some());
                    let Some(found) = found else { continue };
                    let point = found.triangle.expect("of triangles");
                    let [a, b, c] =
                        model.triangles[point.triangle as usize].map(|i| DVec3::from(corners[i as usize]));
                    let [second, third] = point.weights.map(f64::from);
                    let place = a + (b - a) * second + (c - a) * third;
                    assert!(place.distance(found.rest_position) < 2e-6, "{geometry:?} at {beta}: {found:?}");
                    let is_inside = second > -1e-4 && third > -1e-4 && second + third < 1.0001;
                    assert!(is_inside, "{geometry:?} at {beta}: {point:?}");
                    let normal = (b - a).cross(c - a).normalize();
                    assert!((normal.dot(found.rest_normal).abs() - 1.0).abs() < 1e-6);
                }
            }
        }
    }
    assert!(covered > 10_000 && other * 1000 < covered, "{other} of {covered}");
}

/// Away from edges, the faces of a box of triangles have the colours of our own box.
#[test]
fn packets_draw_a_box_of_triangles_as_the_box() {
    let mut renderers = renderers();
    let (exact, model) = (PreparedScene::moving(&[Body::white(exact_box())]), scene_of(box_model()));
    for colour in [Colour::White, Colour::StreetDaylight, Colour::False] {
        let appearance = Appearance { colour, ..Appearance::default() };
        for beta in [0.0, 0.7, 0.99] {
            let view = view(beta, Geometry::Seen, [80, 60]);
            let [expected, found] = [&exact, &model].map(|scene| {
                renderers
                    .picture(Method::Packets, scene, &view, &appearance, 1)
                    .expect("it needs no device")
                    .rgba
            });
            let normals: Vec<_> =
                exact.hit_image(&view).hits.iter().map(|hit| hit.map(|hit| hit.rest_normal)).collect();
            let mut compared = 0;
            for (i, (expected, found)) in expected.iter().zip(&found).enumerate() {
                let (u, v) = (i % 80, i / 80);
                let is_inner = (1..79).contains(&u) && (1..59).contains(&v);
                let around = || [81, 80, 79, 1].into_iter().flat_map(|step| [i - step, i + step]);
                if is_inner && around().all(|other| normals[other] == normals[i]) {
                    let levels = expected.iter().zip(found).map(|(a, b)| a.abs_diff(*b)).max();
                    assert!(levels <= Some(2), "{colour:?} at {beta}, pixel {i}: {found:?} for {expected:?}");
                    compared += usize::from(normals[i].is_some());
                }
            }
            assert!(compared > 200, "{compared}");
        }
    }
}

#[test]
fn what_is_no_model_is_refused() {
    let refused = |change: &dyn Fn(&mut RawModel)| {
        let mut model = box_model();
        change(&mut model);
        model.prepared().expect_err("it is wrong").to_string()
    };
    let texts = [
        (refused(&|model| model.triangles.clear()), "the model has no triangle with an area"),
        (refused(&|model| model.triangles = vec![[1, 1, 2]]), "the model has no triangle with an area"),
        (
            refused(&|model| model.corners[3][1] = f64::NAN),
            "corner 3 of the model is at [1.0, NaN, 0.0], and coordinates must lie between -1e6 and 1e6",
        ),
        (
            refused(&|model| model.corners[0][0] = -2e6),
            "corner 0 of the model is at [-2000000.0, 3.25, 0.0], and coordinates must lie between -1e6 and 1e6",
        ),
        (
            refused(&|model| model.triangles[2][1] = 8),
            "triangle 2 of the model has a corner beyond the last of 8",
        ),
        (refused(&|model| model.paints = vec![[0.5; 3]; 7]), "the model has 8 corners and the colours of 7"),
        (
            refused(&|model| model.paints = vec![[0.5, 0.5, 1.5]; 8]),
            "the colour of corner 0 of the model is [0.5, 0.5, 1.5], and each part must lie between 0 and 1",
        ),
        (
            refused(&|model| model.triangles = vec![[0, 1, 2]; 5_000_001]),
            "the model has 5000001 triangles, and 5000000 are the most",
        ),
    ];
    for (found, expected) in texts {
        assert_eq!(found, expected);
    }
    let tiny = refused(&|model| model.corners.iter_mut().flatten().for_each(|part| *part *= 1e-8));
    assert!(tiny.starts_with("the model is 2e-8 large"), "{tiny}");
    assert_eq!(RawModel::default().prepared().expect_err("it is empty"), TrianglesError::NoArea);
}

#[test]
fn a_flat_model_is_seen_and_one_of_one_side_only_from_there() {
    let corners = vec![[-1.0, 4.0, 0.0], [1.0, 4.0, 0.0], [0.0, 4.0, 1.5]];
    let view = view(0.5, Geometry::Seen, [32, 24]);
    let seen = |triangle, is_two_sided| {
        let model = RawModel {
            corners: corners.clone(),
            triangles: vec![triangle],
            is_two_sided,
            ..RawModel::default()
        };
        hits_of(model, &view).hits.iter().flatten().count()
    };
    let count = seen([0, 1, 2], true);
    assert!(count > 50);
    assert_eq!([seen([0, 1, 2], false), seen([0, 2, 1], true), seen([0, 2, 1], false)], [count, count, 0]);
}

/// Seen from anywhere a ball turns away along a great circle across the line of sight, however fine it is.
#[test]
fn a_ball_turns_away_along_a_great_circle() {
    for rings in [24, 120] {
        let ball = ball_model([0.0; 3], 1.0, rings).prepared().expect("a model");
        assert_eq!(ball.sharp_edges().count(), 0, "{rings}");
        for direction in [DVec3::Z, DVec3::X, DVec3::new(0.6, -0.48, 0.64)] {
            let edges: Vec<_> = ball.turning_edges(Onlooker::Afar(direction)).collect();
            let length: f64 = edges.iter().map(|[from, to]| (*to - *from).length()).sum();
            // It goes around once, in steps along the net of the corners.
            assert!((0.9..1.5).contains(&(length / TAU)), "{rings}, {direction}: {length}");
            for end in edges.as_flattened() {
                assert!(end.dot(direction).abs() < 0.15, "{rings}, {direction}: {end}");
            }
        }
    }
}

/// The silhouette of a model of a ball, as a near eye sees it, is the ball's: a circle around less than half
/// of its surface.
#[test]
fn a_model_of_a_ball_turns_away_where_a_ball_does() {
    let offset = [1.0, -2.0, 0.5];
    let model = ball_model([0.0; 3], 1.0, 120).prepared().expect("a model");
    let model = Body::of_triangles(model).moved(offset);
    assert!(model.strokes().is_empty());
    let ball = Shape::Sphere { centre: offset, radius: 1.0 };
    for eye in [[1.0, -0.5, 0.5], [-2.0, -2.0, 3.5]].map(DVec3::from) {
        let onlooker = Onlooker::At(eye);
        let around = ball.silhouette(|_| onlooker).expect("a ball has one");
        let near = |place: DVec3| {
            (0..2000).map(|i| place.distance(around.at(f64::from(i) / 2000.0))).fold(9.0, f64::min)
        };
        let edges = model.silhouette(|_| onlooker);
        let ends = edges.iter().flat_map(|edge| [0.0, 1.0].map(|s| edge.path.at(s)));
        let farthest = ends.map(near).fold(0.0, f64::max);
        // Edges run along the net of the corners, which of so many triangles are in a grid of 40 cells each
        // way.
        let diagonal = 2.0_f64.sqrt() * 2.0 / 40.0;
        assert!(edges.len() > 100 && farthest < diagonal, "{eye}: {} edges, {farthest}", edges.len());
    }
}
