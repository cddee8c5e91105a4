//! Groups that move differently, against a tracer on the ground that knows no boost, and against what a
//! camera that rides along must receive.

use glam::{DQuat, DVec3};
use relativity_core::{Aperture, Baseline, Model, Speed, Stereo, StereoError, aberration};
use relativity_render::{
    Body, Camera, Gaze, Geometry, Group, Hit, Motion, PreparedScene, Shape, Velocity, View,
};

use crate::support::{centred, mirrored, signed_distance, spread};

/// Beta of each group; the first is the scene's.
const BETAS: [f64; 4] = [0.9, 0.0, -0.6, 0.3];

fn motion(group: usize) -> Motion {
    if group == 0 { Motion::Scene } else { Motion::Own(Velocity::from_beta(BETAS[group]).expect("a speed")) }
}

/// Five bodies of all shapes for each group, so placed that they are seen in front of each other.
fn bodies(group: usize) -> Vec<Body> {
    let body = |i: u32| {
        let [a, b, c, d, e, f, g] = spread(5 * group as u32 + i + 3);
        let middle = DVec3::new(0.0, 3.0 + 0.4 * group as f64, 1.0);
        let (centre, turned) = (middle + 1.3 * centred([a, b, c]), centred([d, e, f]));
        let shape = match i {
            0 => Shape::Sphere { centre: centre.to_array(), radius: 0.2 + 0.2 * g },
            3 => Shape::Box {
                centre: centre.to_array(),
                half: [0.2 + 0.2 * g, 0.1 + 0.1 * a, 0.3],
                turn: DQuat::from_rotation_arc(DVec3::X, turned.normalize()).to_array(),
            },
            4 => Shape::Cylinder {
                from: (centre - 0.3 * turned).to_array(),
                to: (centre + 0.3 * turned).to_array(),
                radius: 0.1 + 0.2 * g,
            },
            1 => Shape::Tube {
                from: (centre - turned).to_array(),
                to: (centre + turned).to_array(),
                radius: 0.05 + 0.05 * g,
            },
            _ => Shape::Ring {
                centre: centre.to_array(),
                axis: turned.normalize().to_array(),
                radius: 0.5 + 0.3 * g,
                tube_radius: 0.06,
            },
        };
        Body::new(shape, 600.0)
    };
    (0..5).map(body).collect()
}

fn scene() -> PreparedScene {
    let groups: Vec<_> = (0..BETAS.len()).map(bodies).collect();
    PreparedScene::new(groups.iter().enumerate().map(|(i, bodies)| Group { motion: motion(i), bodies }))
}

fn view(geometry: Geometry, observation_time: f64) -> View {
    let camera = Camera::new(
        Aperture { x: 0.05, y: 0.0, z: 0.1 },
        Gaze::along([0.2 * (observation_time - 3.0), 3.0, 1.0]),
        1.9,
        [120, 80],
    );
    let speed = Speed::from_beta(BETAS[0]).expect("below 1");
    View { camera, speed, observation_time, geometry }
}

/// A place on the ground at a time, in the coordinates of a group: its bodies are contracted and move.
fn in_group(group: usize, place: DVec3, time: f64) -> DVec3 {
    let beta = BETAS[group];
    DVec3::new((place.x - beta * time) / (1.0 - beta * beta).sqrt(), place.y, place.z)
}

/// Group, body in it and distance seen along `n`, by walking back along the light (or along a line at the
/// observation time) until a surface is met. A step is what none of the surfaces, as they move, can have
/// crossed.
fn walked(view: &View, n: DVec3) -> Option<(usize, usize, f64)> {
    let light_speed_inverse = if view.geometry == Geometry::Seen { 1.0 } else { 0.0 };
    let Aperture { x, y, z } = view.camera.aperture;
    let place = |group: usize, s: f64| {
        let time = view.observation_time - light_speed_inverse * s;
        in_group(group, DVec3::new(x, y, z) + n * s, time)
    };
    let groups: Vec<_> =
        (0..BETAS.len()).map(|i| (bodies(i), place(i, 1.0).distance(place(i, 0.0)))).collect();
    let mut s = 0.0;
    while s < 60.0 {
        let mut step = f64::INFINITY;
        for (group, (bodies, rate)) in groups.iter().enumerate() {
            for (body, Body { shape, .. }) in bodies.iter().enumerate() {
                let distance = signed_distance(shape, place(group, s));
                if distance < 1e-11 {
                    return Some((group, body, s));
                }
                step = step.min(distance / rate);
            }
        }
        s += step.max(1e-13 * s);
    }
    None
}

fn lines_of_sight(view: &View) -> impl Iterator<Item = DVec3> + use<> {
    let (camera, [width, height]) = (view.camera, view.camera.size);
    (0..height).flat_map(move |v| {
        (0..width).map(move |u| camera.line_of_sight([f64::from(u) + 0.5, f64::from(v) + 0.5]))
    })
}

#[test]
fn the_nearest_by_light_travel_is_seen() {
    let scene = scene();
    let mut groups_seen = [0; BETAS.len()];
    let mut different = 0;
    for geometry in [Geometry::Seen, Geometry::Contracted] {
        for time in [1.0, 3.2, 4.5] {
            let view = view(geometry, time);
            for (n, hit) in lines_of_sight(&view).zip(scene.hit_image(&view).hits) {
                let walked = walked(&view, n);
                let found = hit.map(|hit| (scene.group_of(hit.body), hit.body % 5));
                if walked.map(|(group, body, _)| (group, body)) != found {
                    different += 1;
                } else if let (Some((group, _, distance)), Some(hit)) = (walked, hit) {
                    groups_seen[group] += 1;
                    assert!((hit.distance / distance - 1.0).abs() < 1e-6, "{hit:?} at {distance}");
                }
            }
        }
    }
    assert!(groups_seen.iter().all(|&count| count > 300), "{groups_seen:?} pixels");
    // Grazing rays, which the walk may enter or pass.
    assert!(different * 500 < groups_seen.iter().sum::<usize>(), "{different} of {groups_seen:?}");
}

#[test]
fn a_hit_has_the_group_s_proper_time_and_doppler_factor() {
    let (scene, view) = (scene(), view(Geometry::Seen, 3.2));
    for (n, hit) in lines_of_sight(&view).zip(scene.hit_image(&view).hits) {
        let Some(hit) = hit else { continue };
        let Hit { rest_position, emission_time, distance, .. } = hit;
        let group = scene.group_of(hit.body);
        let beta = BETAS[group];
        let gamma = 1.0 / (1.0 - beta * beta).sqrt();
        assert_eq!(hit.material_position, rest_position);
        // The event of emission, boosted: t' = gamma (t - beta x).
        let event_x = view.camera.aperture.x + distance * n.x;
        let proper_time = gamma * (emission_time - beta * event_x);
        let ray = view.of_group(motion(group)).rest_ray(n);
        let along = (rest_position - ray.origin).dot(ray.direction);
        assert!((ray.time - along - proper_time).abs() < 1e-9, "{hit:?}");
        assert!((along * ray.ground_per_rest / distance - 1.0).abs() < 1e-9);
        assert!((hit.doppler_factor * gamma * (1.0 + beta * n.x) - 1.0).abs() < 1e-9);
        let appears = view.of_group(motion(group)).apparent_position(rest_position).expect("in the domain");
        assert!((appears - n * distance).length() < 1e-9 * distance, "{appears} {}", n * distance);
    }
}

#[test]
fn a_camera_that_rides_along_receives_the_same_light() {
    let scene = scene();
    let mut shown = 0;
    for time in [1.0, 3.2, 4.5] {
        let riding = view(Geometry::Rest, time);
        let ground = View { geometry: Geometry::Seen, ..riding };
        for (n, hit) in lines_of_sight(&riding).zip(scene.hit_image(&riding).hits) {
            let on_ground = aberration::ground_from_rest(n.to_array(), &riding.speed);
            let expected = scene.first_hit(&ground, on_ground.into());
            assert_eq!(hit.map(|hit| hit.body), expected.map(|hit| hit.body));
            let (Some(hit), Some(expected)) = (hit, expected) else { continue };
            shown += 1;
            assert!(hit.rest_position.distance(expected.rest_position) < 1e-9);
            assert!((hit.emission_time - expected.emission_time).abs() < 1e-9, "{hit:?} {expected:?}");
            let camera = aberration::doppler_factor(on_ground, &riding.speed);
            assert!((hit.doppler_factor * camera / expected.doppler_factor - 1.0).abs() < 1e-9);
        }
    }
    assert!(shown > 500, "{shown}");
}

#[test]
fn a_resting_group_is_traced_as_it_stands() {
    let view = view(Geometry::Seen, 3.2);
    let street = view.of_group(motion(1));
    assert_eq!(street.geometry, Geometry::Rest);
    for n in lines_of_sight(&view).take(100) {
        let ray = street.rest_ray(n);
        assert_eq!((ray.direction, ray.doppler_factor, ray.ground_per_rest), (n, 1.0, 1.0));
        assert_eq!((ray.origin, ray.time), (DVec3::new(0.05, 0.0, 0.1), view.observation_time));
    }
}

/// A resting body is seen the same through one light cone as through two; a moving one is not. And a hit lies
/// where it appears, its light leaving in time to reach the middle.
#[test]
fn one_light_cone_changes_only_what_moves() {
    let scene = scene();
    let mut shown = [0; BETAS.len()];
    for off_middle in [[-0.4, 0.0, 0.0], [0.4, 0.0, 0.0], [0.1, -0.3, 0.2]].map(DVec3::from) {
        let mut seen = view(Geometry::Seen, 3.2);
        let [x, y, z] = off_middle.to_array();
        (seen.camera.aperture, seen.camera.off_middle) = (Aperture { x, y, z }, off_middle);
        let one_cone = View { geometry: Geometry::OneCone, ..seen };
        for n in lines_of_sight(&one_cone) {
            let Some(hit) = scene.first_hit(&one_cone, n) else { continue };
            let group = scene.group_of(hit.body);
            shown[group] += 1;
            let appears = |view: &View| view.of_group(motion(group)).apparent_position(hit.rest_position);
            let [there, in_two] = [&one_cone, &seen].map(|view| appears(view).expect("in the domain"));
            assert!(there.distance(n * hit.distance) < 1e-9 * hit.distance, "{hit:?}");
            assert_eq!(there.distance(in_two) < 1e-9, BETAS[group] == 0.0, "group {group}: {there} {in_two}");
            let event = off_middle + n * hit.distance;
            assert!((hit.emission_time + event.length() - one_cone.observation_time).abs() < 1e-9);
            // As its own clock has it: where the ray touches.
            let gamma = 1.0 / (1.0 - BETAS[group] * BETAS[group]).sqrt();
            let ray = one_cone.of_group(motion(group)).rest_ray_at(n, hit.distance);
            let along = (hit.rest_position - ray.origin).dot(ray.direction);
            let proper_time = gamma * (hit.emission_time - BETAS[group] * event.x);
            if BETAS[group] != 0.0 {
                assert!((ray.time - along - proper_time).abs() < 1e-9, "{hit:?}");
            }
        }
    }
    assert!(shown.iter().all(|&count| count > 100), "{shown:?} pixels");
}

#[test]
fn motion_towards_minus_x_is_motion_towards_plus_x_in_a_mirror() {
    let (forward, backward) = (bodies(0), bodies(0));
    let mirror = |body: &Body| Body { shape: mirrored(&body.shape), ..body.clone() };
    let backward: Vec<_> = backward.iter().map(mirror).collect();
    let scenes = [(0.95, forward), (-0.95, backward)].map(|(beta, bodies)| {
        let motion = Motion::Own(Velocity::from_beta(beta).expect("a speed"));
        PreparedScene::new([Group { motion, bodies: &bodies }])
    });
    let view = view(Geometry::Seen, 3.0);
    let aperture = Aperture { x: -0.05, y: 0.0, z: 0.1 };
    let there =
        View { camera: Camera { aperture, off_middle: DVec3::X * aperture.x, ..view.camera }, ..view };
    let mut shown = 0;
    for n in lines_of_sight(&view) {
        let hits = [scenes[0].first_hit(&view, n), scenes[1].first_hit(&there, DVec3 { x: -n.x, ..n })];
        assert_eq!(hits[0].map(|hit| (hit.body, hit.distance)), hits[1].map(|hit| (hit.body, hit.distance)));
        shown += usize::from(hits[0].is_some());
    }
    assert!(shown > 200, "{shown}");
    let seen_from_both = scenes[1].hit_image(&view).hits;
    let alone = lines_of_sight(&view).map(|n| scenes[1].first_hit(&view, n));
    assert!(seen_from_both.into_iter().eq(alone), "the cones of directions leave nothing out");
}

/// Holds where two eyes take a point to be against the lines of sight to where each sees it.
fn assert_meets(fused: Result<Stereo, StereoError>, pair: [Aperture; 2], [left, right]: [DVec3; 2]) {
    let baseline = DVec3::new(pair[1].x - pair[0].x, pair[1].y - pair[0].y, pair[1].z - pair[0].z);
    let normal = left.cross(right);
    let [l, r] = [right, left].map(|other| baseline.cross(other).dot(normal) / normal.length_squared());
    let Ok(fused) = fused else { return assert!(l <= 0.0 || r <= 0.0) };
    let middle = 0.5 * (l * left + r * right);
    assert!(middle.distance(fused.position.into()) < 1e-10 * middle.length(), "{middle} {fused:?}");
    assert!((baseline.dot(normal.normalize()).abs() - fused.miss).abs() < 1e-10, "{fused:?}");
}

#[test]
fn both_eyes_see_a_point_of_any_group_where_their_views_show_it() {
    let models = [(Geometry::Seen, Model::Exact), (Geometry::OneCone, Model::OneCone)];
    let cases = BETAS.into_iter().enumerate().flat_map(|case| models.map(|model| (case, model)));
    for ((group, beta), (geometry, model)) in cases {
        let velocity = Velocity::from_beta(beta).expect("a speed");
        let turned = Baseline { separation: 0.3, roll: 0.4, turn: -0.7 }.apertures();
        let rests = [[0.2, 3.0, 1.0], [-0.7, 0.8, -0.5]];
        for (rest, pair) in
            rests.into_iter().flat_map(|rest| [Aperture::pair(0.3), turned].map(|pair| (rest, pair)))
        {
            let both = velocity.disparity(model, rest, pair, 2.1).expect("in the domain");
            let places = pair.map(|aperture| {
                let view = view(geometry, 2.1);
                let off_middle = DVec3::new(aperture.x, aperture.y, aperture.z);
                let camera = Camera { aperture, off_middle, ..view.camera };
                View { camera, ..view }.of_group(motion(group)).apparent_position(rest).expect("there")
            });
            for (place, sighting) in places.into_iter().zip([both.primary, both.secondary]) {
                assert!(place.distance(sighting.position.into()) < 1e-12 * place.length());
            }
            let [left, right] = places.map(|place| place.y.atan2(place.x));
            assert!((both.dphi - (left - right)).abs() < 1e-12, "{} {}", both.dphi, left - right);
            let [left, right] = places.map(|place| place.z.atan2(place.x.hypot(place.y)));
            assert!((both.dtheta - (left - right)).abs() < 1e-12);
            assert_meets(velocity.stereo(model, rest, pair, 2.1), pair, places);
        }
    }
}
