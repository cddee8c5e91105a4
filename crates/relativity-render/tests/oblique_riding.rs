//! A camera that moves in any direction, against the core's moving observer, a turned copy, and a search on
//! the ground.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::{DQuat, DVec3};
use relativity_core::{Aperture, Model, Observer, ObserverVelocity, Speed, Turning};
use relativity_render::{
    Body, Camera, Gaze, Geometry, Group, Hit, MaterialPoint, Motion, PreparedScene, Shape, Spin, Velocity,
    View,
};

fn rider(beta: f64, azimuth: f64, elevation: f64) -> ObserverVelocity {
    ObserverVelocity::new(Speed::from_beta(beta).expect("a speed"), azimuth, elevation)
}

/// The ground event of an eye that is at `off_middle` to an observer at `place` and `time`, by the Lorentz
/// transformation as textbooks have it.
fn event_of_eye(velocity: &ObserverVelocity, place: DVec3, time: f64, off_middle: DVec3) -> (Aperture, f64) {
    let (gamma, beta) = (velocity.speed().gamma(), velocity.speed().beta());
    let direction = DVec3::from(velocity.direction());
    let along = off_middle.dot(direction);
    let DVec3 { x, y, z } = place + off_middle + direction * ((gamma - 1.0) * along);
    (Aperture { x, y, z }, time + gamma * beta * along)
}

/// The view of an eye that is at `off_middle` to an observer at `place` and `time`.
fn view_of_eye(
    velocity: ObserverVelocity,
    place: DVec3,
    time: f64,
    off_middle: DVec3,
    gaze: Gaze,
    geometry: Geometry,
) -> View {
    let (aperture, observation_time) = event_of_eye(&velocity, place, time, off_middle);
    let camera = Camera { velocity, off_middle, ..Camera::new(aperture, gaze, 1.6, [96, 64]) };
    View { camera, speed: Speed::REST, observation_time, geometry }
}

/// Points of groups and of their wheels appear where the core has them for an observer who moves obliquely,
/// each eye at its own event.
#[test]
fn both_eyes_see_points_where_the_core_has_them() {
    let pair = [Aperture { x: -0.08, y: 0.03, z: -0.02 }, Aperture { x: 0.08, y: -0.03, z: 0.02 }];
    let (place, time) = ([1.3, 0.2, -0.1], 2.4);
    for velocity in
        [rider(0.8, FRAC_PI_2, 0.0), rider(0.9, 2.3, 0.4), rider(0.5, -0.7, -1.1), rider(0.99, 0.02, 0.01)]
    {
        let observer = Observer { velocity, place, time };
        for beta in [0.0, 0.9, -0.7, 0.3] {
            let group = Velocity::from_beta(beta).expect("a speed");
            let hub = [0.4, 3.0, 0.5];
            let rolls = Spin { hub, radius: 0.5, turning: Turning::Rolling };
            let rest = DVec3::new(0.7, 3.0, 0.3);
            for spin in [None, Some(rolls)] {
                let point = MaterialPoint { rest, spin };
                let both = group.disparity_before(&observer, Model::Exact, point, pair).expect("in range");
                for (eye, sighting) in pair.into_iter().zip([both.primary, both.secondary]) {
                    let (expected, off_middle) =
                        (DVec3::from(sighting.position), DVec3::new(eye.x, eye.y, eye.z));
                    let gaze = Gaze::along(expected.to_array());
                    let view = view_of_eye(velocity, place.into(), time, off_middle, gaze, Geometry::Seen);
                    let group_view = view.of_group(Motion::Own(group));
                    let appears = group_view.apparent_position(point).expect("in the domain");
                    assert!(
                        appears.distance(expected) < 1e-9 * expected.length(),
                        "{appears} for {expected}"
                    );
                    let [u, v] = view.camera.pixel(appears).expect("ahead");
                    assert!((u - 48.0).abs() < 1e-7 && (v - 32.0).abs() < 1e-7, "{u} {v}");
                    let ray = group_view.rest_ray(expected.normalize());
                    let own = spin.map_or(1.0, |spin| {
                        group_view.own_doppler(&spin, group_view.place_when_shown(point))
                    });
                    let doppler = ray.doppler_factor * own;
                    assert!((doppler / sighting.doppler_factor - 1.0).abs() < 1e-9, "{doppler} {sighting:?}");
                    if spin.is_some() {
                        continue;
                    }
                    // A speck there is hit when its light left.
                    let speck = Body::new(Shape::Sphere { centre: rest.to_array(), radius: 1e-7 }, 600.0);
                    let bodies = [speck];
                    let scene = PreparedScene::new([Group { motion: Motion::Own(group), bodies: &bodies }]);
                    let hit = scene.first_hit(&view, expected.normalize()).expect("it is there");
                    assert!((hit.distance / sighting.distance - 1.0).abs() < 1e-6);
                    assert!(
                        (hit.emission_time - sighting.retarded_time).abs() < 1e-5,
                        "{hit:?} {sighting:?}"
                    );
                    assert!((hit.proper_time - sighting.proper_time).abs() < 1e-5, "{hit:?} {sighting:?}");
                }
            }
        }
    }
}

/// Lines h, i and l of the table that was worked out in 60 digits beforehand, read off pictures of both eyes.
#[test]
fn points_are_in_the_pictures_where_a_table_has_them() {
    struct Line {
        beta: f64,
        point: [f64; 3],
        own: Speed,
        heading: [f64; 2],
        place: [f64; 3],
        time: f64,
        head: [f64; 2],
        expected: [f64; 6],
    }
    let (beta, gamma) = (Speed::from_beta(0.8).expect("a speed"), Speed::from_gamma(1000.0).expect("one"));
    let lines = [
        Line {
            beta: 0.0,
            point: [5.0, 3.0, 2.0],
            own: beta,
            heading: [0.5, 0.0],
            place: [1.0, 0.5, 0.0],
            time: 1.0,
            head: [0.0, 0.0],
            expected: [
                2.895_296_476,
                0.516_942_128_2,
                0.133_505_211_8,
                15.025_283_01,
                -0.003_803_198_701,
                -0.003_813_489_843,
            ],
        },
        Line {
            beta: 0.6,
            point: [5.0, 3.0, 2.0],
            own: beta,
            heading: [0.5, 0.4],
            place: [1.0, 0.5, 0.0],
            time: 1.0,
            head: [0.2, -1.5],
            expected: [
                1.737_938_467,
                0.603_225_538_9,
                0.452_002_864_1,
                11.420_142_04,
                -0.010_028_367_91,
                0.002_319_790_223,
            ],
        },
        Line {
            beta: 0.0,
            point: [-540.0, -838.0, 2.0],
            own: gamma,
            heading: [1.0, 0.0],
            place: [0.0; 3],
            time: 0.0,
            head: [0.2, 0.3],
            expected: [
                0.004_066_517_228,
                1.495_310_985,
                0.541_193_372_8,
                3.901_577_414,
                -0.051_104_328_81,
                -0.017_944_815_35,
            ],
        },
    ];
    for Line { beta, point, own, heading: [azimuth, elevation], place, time, head: [roll, turn], expected } in
        lines
    {
        let velocity = ObserverVelocity::new(own, azimuth, elevation);
        let group = Velocity::from_beta(beta).expect("a speed");
        let rest = DVec3::new(point[0] * group.speed.gamma(), point[1], point[2]);
        let baseline = DVec3::new(roll.cos() * turn.cos(), roll.cos() * turn.sin(), roll.sin());
        let [left, right] = [-0.05, 0.05].map(|side| {
            let gaze = Gaze::STRAIGHT_AHEAD;
            let view = view_of_eye(velocity, place.into(), time, baseline * side, gaze, Geometry::Seen);
            let seen = view.of_group(Motion::Own(group));
            let appears = seen.apparent_position(rest).expect("in the domain");
            // By the picture alone.
            let gaze = Gaze { azimuth: appears.y.atan2(appears.x) + 0.2, elevation: 0.3 };
            let camera = Camera { gaze, ..view.camera };
            let line = camera.line_of_sight(camera.pixel(appears).expect("ahead"));
            let doppler = seen.rest_ray(line).doppler_factor;
            [doppler, line.y.atan2(line.x), line.z.atan2(line.x.hypot(line.y)), appears.length()]
        });
        let found = [left[0], left[1], left[2], left[3], left[1] - right[1], left[2] - right[2]];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < 2e-9 * expected.abs().max(1e-1), "{found} for {expected}");
        }
    }
}

/// Bodies around the origin, none of which turning changes.
fn bodies(turn: DQuat) -> Vec<Body> {
    let at = |place: [f64; 3]| (turn * DVec3::from(place)).to_array();
    let shapes = [
        Shape::Sphere { centre: at([4.0, 2.0, -0.6]), radius: 0.4 },
        Shape::Tube { from: at([2.0, 3.0, -1.0]), to: at([2.5, 3.0, 2.0]), radius: 0.06 },
        Shape::Ring {
            centre: at([3.0, 2.5, 0.0]),
            axis: at([0.0, 1.0, 0.0]),
            radius: 0.5,
            tube_radius: 0.05,
        },
        Shape::Box { centre: at([-4.0, 4.0, 0.5]), half: [0.5, 0.4, 1.0], turn: turn.to_array() },
        Shape::Cylinder { from: at([-2.0, 3.0, -0.5]), to: at([-2.0, 3.0, 0.5]), radius: 0.3 },
        Shape::Sphere { centre: at([5.0, -1.0, 1.0]), radius: 0.7 },
        Shape::Sphere { centre: at([-1.0, -3.0, 2.0]), radius: 0.5 },
        Shape::Tube { from: at([-3.0, -2.0, -1.0]), to: at([4.0, -4.0, -1.5]), radius: 0.2 },
    ];
    shapes.into_iter().map(|shape| Body::new(shape, 600.0)).collect()
}

/// Whoever rides any way sees what somebody sees of the turned scene who rides along x.
#[test]
fn a_turned_copy_is_seen_turned() {
    let off_middle = DVec3::new(0.03, 0.05, -0.02);
    let mut shown = 0;
    for (beta, azimuth, elevation) in
        [(0.9, FRAC_PI_2, 0.0), (0.5, 2.2, 0.0), (0.9, 0.7, 0.5), (0.8, -2.0, -0.9), (0.99, 3.0, 0.3)]
    {
        let into_x = DQuat::from_rotation_y(elevation) * DQuat::from_rotation_z(-azimuth);
        let velocity = rider(beta, azimuth, elevation);
        assert!((into_x * DVec3::from(velocity.direction())).distance(DVec3::X) < 1e-15);
        for geometry in [Geometry::Seen, Geometry::Contracted, Geometry::OneCone] {
            // The horizon stays level where it looks ahead or back.
            for (aside, up) in [(0.0, 0.1), (PI, -0.2), (0.0, -0.4)] {
                let gaze = Gaze { azimuth: azimuth + aside, elevation: up };
                let oblique = view_of_eye(velocity, DVec3::ZERO, 0.0, off_middle, gaze, geometry);
                let turned_gaze = Gaze::along((into_x * gaze.axes().forward).to_array());
                let along_x = rider(beta, 0.0, 0.0);
                let along =
                    view_of_eye(along_x, DVec3::ZERO, 0.0, into_x * off_middle, turned_gaze, geometry);
                let hits = |turn: DQuat, view: &View| {
                    let bodies = bodies(turn);
                    let motion = Motion::Own(Velocity::REST);
                    PreparedScene::new([Group { motion, bodies: &bodies }]).hit_image(view).hits
                };
                let [seen, expected] = [hits(DQuat::IDENTITY, &oblique), hits(into_x, &along)];
                for (seen, expected) in seen.iter().zip(&expected) {
                    shown += usize::from(seen.is_some());
                    assert_same(seen.as_ref(), expected.as_ref(), into_x);
                }
            }
        }
    }
    assert!(shown > 10_000, "{shown} pixels show a body");
}

fn assert_same(seen: Option<&Hit>, expected: Option<&Hit>, turn: DQuat) {
    assert_eq!(seen.map(|hit| hit.body), expected.map(|hit| hit.body), "{seen:?} {expected:?}");
    let (Some(seen), Some(expected)) = (seen, expected) else { return };
    let off = (turn * seen.rest_position).distance(expected.rest_position);
    assert!(off < 1e-9, "{seen:?} {expected:?}");
    assert!((seen.distance / expected.distance - 1.0).abs() < 1e-9, "{seen:?} {expected:?}");
    assert!((seen.doppler_factor / expected.doppler_factor - 1.0).abs() < 1e-10);
    assert!((seen.emission_time - expected.emission_time).abs() < 1e-9, "{seen:?} {expected:?}");
}

/// Balls, by centre and radius, each in a group with a velocity of its own.
const BALLS: [([f64; 3], f64, f64); 5] = [
    ([4.0, 2.0, -0.6], 0.8, 0.0),
    ([-3.0, 5.0, 1.0], 1.1, 0.6),
    ([2.0, -3.0, 0.5], 0.7, -0.5),
    ([-4.0, -2.0, -2.0], 0.9, 0.0),
    ([1.0, 1.5, 3.5], 0.6, 0.3),
];

/// The number of the ball that is nearest along `line` before an eye at `place` and `time`, by steps back
/// along the light on the ground, from textbook aberration; its distance there.
fn found_on_ground(
    velocity: &ObserverVelocity,
    place: DVec3,
    time: f64,
    line: DVec3,
) -> Option<(usize, f64)> {
    let (speed, direction) = (velocity.speed(), DVec3::from(velocity.direction()));
    let along = line.dot(direction);
    let slowed = 1.0 - speed.beta() * along;
    let n = ((line - direction * along) / speed.gamma() + direction * (along - speed.beta())) / slowed;
    let outside = |number: usize, distance: f64| {
        let (centre, radius, beta) = BALLS[number];
        let event = place + n * distance;
        let gamma = 1.0 / (1.0 - beta * beta).sqrt();
        let x = gamma * (event.x - beta * (time - distance));
        DVec3 { x, ..event }.distance(centre.into()) - radius
    };
    let mut nearest = None;
    for number in 0..BALLS.len() {
        let Some(inside) = (0..3000).map(|i| 0.01 * f64::from(i)).find(|&at| outside(number, at) < 0.0)
        else {
            continue;
        };
        let [mut low, mut high] = [inside - 0.01, inside];
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            *(if outside(number, middle) > 0.0 { &mut low } else { &mut high }) = middle;
        }
        if nearest.is_none_or(|(_, distance)| high < distance) {
            nearest = Some((number, high));
        }
    }
    nearest
}

#[test]
fn a_search_on_the_ground_finds_the_same_bodies() {
    let bodies: Vec<_> = BALLS
        .iter()
        .map(|&(centre, radius, _)| [Body::new(Shape::Sphere { centre, radius }, 600.0)])
        .collect();
    let groups = bodies.iter().zip(BALLS).map(|(bodies, (_, _, beta))| Group {
        motion: Motion::Own(Velocity::from_beta(beta).expect("a speed")),
        bodies,
    });
    let scene = PreparedScene::new(groups);
    let (place, time) = (DVec3::new(0.2, -0.1, 0.1), 0.4);
    let (mut shown, mut at_outlines) = (0, 0);
    for velocity in [rider(0.5, FRAC_PI_2, 0.0), rider(0.9, 2.3, 0.4), rider(0.8, -0.7, -1.2)] {
        for azimuth in [0.3, 2.0, -1.5] {
            let gaze = Gaze { azimuth, elevation: 0.2 };
            let mut view = view_of_eye(velocity, place, time, DVec3::ZERO, gaze, Geometry::Seen);
            view.camera.size = [64, 48];
            let hits = scene.hit_image(&view).hits;
            let lines = view.camera.lines_of_sight();
            for (i, hit) in hits.iter().enumerate() {
                let [u, v] = [i % 64, i / 64].map(|place| place as f64 + 0.5);
                let line = lines.through([u, v]);
                let found = found_on_ground(&velocity, place, time, line);
                shown += usize::from(hit.is_some());
                let is_same = found.map(|(body, _)| body) == hit.as_ref().map(|hit| hit.body);
                if !is_same {
                    at_outlines += 1;
                    continue;
                }
                if let (Some(hit), Some((_, distance))) = (hit, found) {
                    let along = line.dot(velocity.direction().into());
                    let speed = velocity.speed();
                    let on_ground = hit.distance * speed.gamma() * (1.0 - speed.beta() * along);
                    assert!((on_ground - distance).abs() < 1e-9, "{on_ground} {distance}");
                    assert!((hit.emission_time - (time - distance)).abs() < 1e-9);
                }
            }
        }
    }
    println!("{shown} pixels show a body, {at_outlines} differ");
    assert!(shown > 1000 && at_outlines == 0, "{shown} {at_outlines}");
}

/// At 0.9 c a lamp that stands abreast is seen 25.84 degrees from where one rides, whichever way that is.
#[test]
fn what_is_abreast_is_seen_ahead_on_every_side() {
    for (azimuth, elevation) in [(FRAC_PI_2, 0.0), (2.0, 0.7), (0.0, FRAC_PI_2)] {
        let velocity = rider(0.9, azimuth, elevation);
        let direction = DVec3::from(velocity.direction());
        let gaze = Gaze::STRAIGHT_AHEAD;
        let view = view_of_eye(velocity, DVec3::ZERO, 0.0, DVec3::ZERO, gaze, Geometry::Seen);
        for aside in [direction.cross(DVec3::new(0.3, 0.2, 0.9)), direction.cross(DVec3::X)] {
            let street = view.of_group(Motion::Own(Velocity::REST));
            let seen = street.apparent_position(aside.normalize() * 3.0).expect("in the domain");
            assert!((seen.angle_between(direction).to_degrees() - 25.841_932_7).abs() < 1e-6);
        }
    }
}
