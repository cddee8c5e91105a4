//! A camera that rides along the street, against the core's moving observer and against eyes at rest.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;
use relativity_core::{Aperture, Model, Observer, ObserverVelocity, Speed, Turning};
use relativity_render::{
    Appearance, Body, Camera, Gaze, Geometry, Group, MaterialPoint, Motion, PreparedScene, Shape, Spin,
    Velocity, View,
};

fn velocity(beta: f64) -> Velocity {
    Velocity::from_beta(beta).expect("a speed")
}

fn resting(bodies: &[Body], motion: Motion) -> PreparedScene {
    PreparedScene::new([Group { motion, bodies }])
}

/// Bodies of several shapes ahead of the origin and beside it, on a ground at z = -1.
fn street() -> Vec<Body> {
    let shapes = [
        Shape::Sphere { centre: [4.0, 2.0, -0.6], radius: 0.4 },
        Shape::Tube { from: [2.0, 3.0, -1.0], to: [2.0, 3.0, 2.0], radius: 0.06 },
        Shape::Ring { centre: [3.0, 2.5, 0.0], axis: [0.0, 1.0, 0.0], radius: 0.5, tube_radius: 0.05 },
        Shape::Box { centre: [6.0, 4.0, 0.0], half: [0.5, 0.4, 1.0], turn: [0.0, 0.0, 0.0, 1.0] },
        Shape::Cylinder { from: [-2.0, 3.0, -0.5], to: [-2.0, 3.0, 0.5], radius: 0.3 },
    ];
    shapes.into_iter().map(|shape| Body::new(shape, 600.0)).collect()
}

/// A ride at `beta`, at the ground's origin at T = 0, that looks ahead to the left.
fn ride(beta: f64) -> View {
    let gaze = Gaze::along([3.0, 1.5, 0.0]);
    let camera =
        Camera { velocity: velocity(beta).into(), ..Camera::new(Aperture::default(), gaze, 1.6, [96, 64]) };
    View { camera, speed: Speed::REST, observation_time: 0.0, geometry: Geometry::Seen }
}

/// Only relative motion counts.
#[test]
fn a_ride_past_a_street_is_a_street_that_passes_byte_for_byte() {
    for beta in [0.3, 0.9, 0.98, -0.6] {
        for geometry in [Geometry::Seen, Geometry::Contracted] {
            let riding = View { geometry, ..ride(beta) };
            let at_rest =
                View { camera: Camera { velocity: ObserverVelocity::REST, ..riding.camera }, ..riding };
            let bodies = street();
            let passed = resting(&bodies, Motion::Own(Velocity::REST));
            let passing = resting(&bodies, Motion::Own(velocity(-beta)));
            let appearance = Appearance::default();
            let pictures =
                [passed.picture(&riding, &appearance, 1), passing.picture(&at_rest, &appearance, 1)];
            let sky = resting(&[], Motion::Scene).picture(&riding, &appearance, 1);
            // The sky is the street's: what is beside the bodies differs.
            let hits = passed.hit_image(&riding).hits;
            let shown = hits.iter().flatten().count();
            assert!(shown > 20, "{shown} pixels show a body at {beta}");
            let pixels = pictures[0].rgba.iter().zip(&pictures[1].rgba).zip(&sky.rgba).zip(&hits);
            for (((seen, expected), sky), hit) in pixels {
                assert_eq!(seen, if hit.is_some() { expected } else { sky });
            }
        }
    }
}

/// Points of groups and of their wheels appear where the core has them for a moving observer's eyes, each at
/// its own event.
#[test]
fn both_eyes_of_a_rider_see_points_where_the_core_has_them() {
    let pair = Aperture::pair(0.2);
    let (place, time) = ([1.3, 0.2, -0.1], 2.4);
    for (own, beta) in [(0.8, 0.0), (0.8, 0.9), (0.5, -0.7), (0.9, 0.9), (-0.6, 0.4)] {
        let rider = velocity(own);
        let azimuth = if own < 0.0 { PI } else { 0.0 };
        let observer = Observer { velocity: ObserverVelocity::new(rider.speed, azimuth, 0.0), place, time };
        let group = velocity(beta);
        let hub = [0.4, 3.0, 0.5];
        let spin = Spin { hub, radius: 0.5, turning: Turning::Rolling };
        let rest = DVec3::new(0.4 + 0.3, 3.0, 0.5 - 0.2);
        let turning = group.speed.gamma() > 1.0 && beta > 0.0;
        for spin in [None, Some(spin)].into_iter().filter(|spin| spin.is_none() || turning) {
            let point = MaterialPoint { rest, spin };
            // The core's points move along +x.
            let source = group.reflected_source(point);
            let seen = if beta < 0.0 {
                let mirrored = ObserverVelocity::new(rider.speed, PI - azimuth, 0.0);
                let observer = Observer { velocity: mirrored, place: [-place[0], place[1], place[2]], time };
                let pair = pair.map(|eye| Aperture { x: -eye.x, ..eye });
                let both =
                    observer.disparity(Model::Exact, &group.speed, source, pair, 0.0).expect("in range");
                [both.primary, both.secondary].map(|seen| {
                    let [x, y, z] = seen.position;
                    (DVec3::new(-x, y, z), seen)
                })
            } else {
                let both =
                    observer.disparity(Model::Exact, &group.speed, source, pair, 0.0).expect("in range");
                [both.primary, both.secondary].map(|seen| (DVec3::from(seen.position), seen))
            };
            for (eye, (expected, sighting)) in pair.into_iter().zip(seen) {
                let gamma = rider.speed.gamma();
                let aperture = Aperture { x: place[0] + gamma * eye.x, y: place[1], z: place[2] };
                let camera = Camera {
                    velocity: rider.into(),
                    off_middle: DVec3::X * eye.x,
                    ..Camera::new(aperture, Gaze::along(expected.to_array()), 0.1, [9, 9])
                };
                let observation_time = time + gamma * rider.beta() * eye.x;
                let view = View { camera, speed: Speed::REST, observation_time, geometry: Geometry::Seen };
                let group_view = view.of_group(Motion::Own(group));
                let appears = group_view.apparent_position(point).expect("in the domain");
                assert!(appears.distance(expected) < 1e-9 * expected.length(), "{appears} for {expected}");
                let ray = group_view.rest_ray(expected.normalize());
                if spin.is_none() {
                    assert!((ray.doppler_factor / sighting.doppler_factor - 1.0).abs() < 1e-9);
                    // A speck there is hit when its light left.
                    let speck = Shape::Sphere { centre: rest.to_array(), radius: 1e-7 };
                    let scene = resting(&[Body::new(speck, 600.0)], Motion::Own(group));
                    let hit = scene.first_hit(&view, expected.normalize()).expect("it is there");
                    assert!((hit.emission_time - sighting.retarded_time).abs() < 1e-5, "{hit:?}");
                    assert!((hit.proper_time - sighting.proper_time).abs() < 1e-5, "{hit:?} {sighting:?}");
                }
            }
        }
    }
}

/// A tunnel's mouth is still seen ahead when one is in it: tan(theta'/2) = tan(theta/2) sqrt((1 - V)/(1 +
/// V)).
#[test]
fn what_is_abreast_is_seen_ahead() {
    let view = ride(0.9);
    let street = view.of_group(Motion::Own(Velocity::REST));
    let seen = street.apparent_position(DVec3::Y * 3.0).expect("in the domain");
    let angle = seen.y.atan2(seen.x);
    let expected = 2.0 * ((FRAC_PI_2 / 2.0).tan() * (0.1_f64 / 1.9).sqrt()).atan();
    assert!((angle - expected).abs() < 1e-12);
    assert!((angle.to_degrees() - 25.84).abs() < 0.005, "{angle}");
}

/// The bicycle of whoever rides looks as it does at rest, however fast the street passes, and its wheels have
/// turned by the street that has passed.
#[test]
fn what_rides_along_is_seen_as_at_rest() {
    let hub = [2.0, 1.0, -0.4];
    let spoke = Shape::Cylinder { from: hub, to: [2.0, 1.0, 0.1], radius: 0.06 };
    let spin = Spin { hub, radius: 0.5, turning: Turning::Rolling };
    let bar = Body::new(Shape::Tube { from: [1.5, 0.2, 0.3], to: [1.5, 1.4, 0.3], radius: 0.05 }, 600.0);
    let own = [bar.clone(), Body { spin: Some(spin), ..Body::new(spoke, 500.0) }];
    let with_eyes = resting(&own, Motion::WithEyes);
    let rolled = 0.4;
    let angle = rolled / 0.5;
    // The spoke stood upright, and turns forwards where the street goes by backwards.
    let turned = [hub[0] + 0.5 * f64::sin(angle), hub[1], hub[2] + 0.5 * f64::cos(angle)];
    let at_rest = [bar, Body::new(Shape::Cylinder { from: hub, to: turned, radius: 0.06 }, 500.0)];
    let still = resting(&at_rest, Motion::Own(Velocity::REST));
    let appearance = Appearance::default();
    let off_middle = DVec3::new(0.03, 0.2, 0.0);
    for beta in [0.0, 0.6, 0.9999] {
        let mut riding = ride(beta);
        riding.camera.off_middle = off_middle;
        (riding.camera.rolled, riding.camera.aperture) = (rolled, Aperture { x: 7.0, y: 3.0, z: 1.0 });
        riding.observation_time = 5.0;
        let hits = with_eyes.hit_image(&riding).hits;
        let aperture = Aperture { x: off_middle.x, y: off_middle.y, z: off_middle.z };
        let camera = Camera { velocity: ObserverVelocity::REST, aperture, ..riding.camera };
        let resting = View { camera, observation_time: 0.0, ..riding };
        let expected = still.hit_image(&resting).hits;
        // The light of what is further away left when the wheel had turned less: by V R/W.
        let differ = hits.iter().zip(&expected).filter(|(a, b)| {
            let of_bar = |hit: &Option<relativity_render::Hit>| hit.as_ref().is_some_and(|hit| hit.body == 0);
            of_bar(a) != of_bar(b)
        });
        assert_eq!(differ.count(), 0, "at {beta}");
        let spokes = |hits: &[Option<relativity_render::Hit>]| {
            hits.iter().flatten().filter(|hit| hit.body == 1).count()
        };
        assert!(spokes(&hits) > 10 && spokes(&expected) > 10, "at {beta}");
        if beta == 0.0 {
            let pictures = [(&with_eyes, &riding), (&still, &resting)]
                .map(|(scene, view)| scene.picture(view, &appearance, 1).rgba);
            assert_eq!(pictures[0], pictures[1]);
        }
    }
}
