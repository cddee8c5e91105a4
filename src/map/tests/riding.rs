//! Maps of rides that do not lead along the street, held against events on the ground and a Lorentz matrix
//! written down here.

use glam::DVec3;
use relativity_core::{Event, ObserverVelocity};
use relativity_render::{Geometry, MaterialPoint, Motion, Velocity};

use super::super::*;
use crate::scene::{Scene, Track};
use crate::settings::{MapFace, MapFrame, Preset, Settings};

/// An event: t, x, y, z.
type Four = [f64; 4];

/// A ride: legs, azimuth and elevation in degrees, and the time on the rider's clock.
type Case = (&'static str, f64, f64, f64);
const RIDES: [Case; 6] = [
    ("2@0.8,6@0", 90.0, 0.0, 5.0),
    ("2@0.8,6@0", 30.0, 0.0, 4.0),
    ("1@1,3@0", -120.0, 25.0, 3.0),
    ("2@0.7,3@0", 0.0, 90.0, 4.0),
    // Pushed aside: the way bends, and the head turns.
    ("2@0.8,2@0:0.9,1@-0.5:-1", 0.0, 0.0, 4.6),
    ("1@0:1,2@1:0:0.7", 70.0, 0.0, 2.5),
];

fn settings(&(legs, azimuth, elevation, _): &Case, frame: MapFrame) -> Settings {
    let mut settings = Preset::named("ride-lamps").expect("a preset").settings.clone();
    settings.ride.ride = legs.parse().expect("legs");
    settings.ride.ride_speed = "0.3".parse().expect("a velocity");
    (settings.ride.ride_azimuth, settings.ride.ride_elevation) = (azimuth, elevation);
    (settings.ride.ride_from, settings.motion.d) = (-3.0, 0.4);
    (settings.motion.roll, settings.motion.turn) = (10.0, -50.0);
    settings.motion.speed =
        crate::flags::SpeedSetting::new(crate::flags::SpeedParameter::Beta, 0.6).expect("a speed");
    settings.map.frame = frame;
    settings
}

/// Points that rest on the ground, move with the scene, and come the other way.
fn tracks() -> [Track; 3] {
    let back = Motion::Own(Velocity::from_beta(-0.8).expect("in range"));
    let motions = [Motion::Own(Velocity::REST), Motion::Scene, back];
    motions.map(|motion| Track { rest: [4.0, 3.0, 2.0], motion, spin: None })
}

/// The event of `point` at the ground's time `t`, from the middle between eyes that rest.
fn event_at(settings: &Settings, point: &Track, t: f64) -> Four {
    let beta = settings.velocity(point.motion).beta();
    let [x, y, z] = point.rest;
    let (behind, below) = (settings.motion.depth_shift, settings.motion.height_shift);
    [t, x * (1.0 - beta * beta).sqrt() + beta * t, y + behind, z + below]
}

/// The boost without turning into the frame that moves with this proper velocity.
fn boost(proper: [f64; 3]) -> [Four; 4] {
    let gamma = (1.0 + proper.iter().map(|part| part * part).sum::<f64>()).sqrt();
    std::array::from_fn(|i| {
        std::array::from_fn(|j| match (i, j) {
            (0, 0) => gamma,
            (0, k) | (k, 0) => -proper[k - 1],
            (i, j) => f64::from(u8::from(i == j)) + proper[i - 1] * proper[j - 1] / (gamma + 1.0),
        })
    })
}

fn applied(matrix: &[Four; 4], event: Four) -> Four {
    matrix.map(|row| row.iter().zip(event).map(|(a, b)| a * b).sum())
}

/// The root of `f`, which falls from above 0 at `low` to below 0 at `high`.
fn bisected(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// The events of both eyes on the ground: by the matrix the other way, from the observer's axes, in which the
/// head may have turned.
fn eyes(settings: &Settings, time: f64) -> [Four; 2] {
    let rider = settings.rider(time);
    let observer = rider.observer();
    let back = boost(observer.velocity.proper().map(|part| -part));
    let (roll, turn) = (settings.motion.roll.to_radians(), settings.motion.turn.to_radians());
    let along = DVec3::new(roll.cos() * turn.cos(), roll.cos() * turn.sin(), roll.sin());
    let DVec3 { x, y, z } = 0.5 * settings.motion.d * rider.from_head(along);
    [-1.0, 1.0].map(|side| {
        let offset = applied(&back, [0.0, side * x, side * y, side * z]);
        let [x, y, z] = observer.place;
        let here = [observer.time, x, y, z];
        std::array::from_fn(|i| here[i] + offset[i])
    })
}

fn distance(a: Four, b: Four) -> f64 {
    (1..4).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

/// When light left `point` that arrives at the event `eye`: where the past light cone is met, found by
/// halves.
fn left_at(settings: &Settings, point: &Track, eye: Four) -> f64 {
    bisected(eye[0] - 1e4, eye[0], |t| eye[0] - t - distance(event_at(settings, point, t), eye))
}

fn place([_, x, y, z]: Four) -> DVec3 {
    DVec3::new(x, y, z)
}

#[test]
fn rays_on_the_ground_run_from_where_light_left_to_each_eye() {
    for case in &RIDES {
        let settings = settings(case, MapFrame::Ground);
        let time = case.3;
        let (instant, there) = (MapInstant::new(&settings, time), eyes(&settings, time));
        for track in tracks() {
            let rays = rays(&settings, &track, time, settings.frame(time)).expect("in the domain");
            let diagram = Diagram::new(&settings, &track, time, settings.frame(time)).expect("in the domain");
            let cones = diagram.cones().expect("it is the ground's frame");
            for (eye, (ray, cone)) in rays.into_iter().zip(cones).enumerate() {
                let expected = event_at(&settings, &track, left_at(&settings, &track, there[eye]));
                let left = DVec3::new(ray.left.x, ray.across[0], ray.across[1]);
                assert!(left.distance(place(expected)) < 1e-9, "{case:?}: {ray:?} {expected:?}");
                assert!((ray.left.t - expected[0]).abs() < 1e-9);
                let received = DVec3::new(ray.received.x, ray.eye[0], ray.eye[1]);
                assert!(received.distance(place(there[eye])) < 1e-12, "{case:?}: {ray:?} {:?}", there[eye]);
                assert!((ray.received.t - there[eye][0]).abs() < 1e-12);
                assert!((cone.time(ray.left.x) - ray.left.t).abs() < 1e-9, "it is on the eye's cone");
                // The space face shows the same.
                assert!(instant.eyes()[eye].distance(received) < 1e-12);
                let seen = instant.place(&track, BodyPicture::Seen(eye)).expect("in the domain");
                assert!(seen.distance(left) < 1e-9, "{case:?}: {seen} {left}");
            }
        }
    }
}

#[test]
fn my_own_frame_is_the_grounds_by_a_lorentz_matrix() {
    for case in &RIDES {
        let settings = settings(case, MapFrame::Rider);
        let time = case.3;
        let observer = settings.rider(time).observer();
        let there = boost(observer.velocity.proper());
        let [x, y, z] = observer.place;
        let here = [observer.time, x, y, z];
        let mine = |event: Four| applied(&there, std::array::from_fn(|i| event[i] - here[i]));
        let instant = MapInstant::new(&settings, time);
        for (event, eye) in eyes(&settings, time).into_iter().zip(instant.eyes()) {
            let [t, ..] = mine(event);
            assert!(t.abs() < 1e-12 && place(mine(event)).distance(eye) < 1e-12, "both are at one time");
        }
        for track in tracks() {
            // When it is now, by my clock.
            let now = bisected(-1e4, 1e4, |t| -mine(event_at(&settings, &track, t))[0]);
            let expected = place(mine(event_at(&settings, &track, now)));
            let measured = instant.place(&track, BodyPicture::Measured).expect("it is somewhere");
            assert!(measured.distance(expected) < 1e-9, "{case:?}: {measured} {expected}");
            for (eye, event) in eyes(&settings, time).into_iter().enumerate() {
                let left = mine(event_at(&settings, &track, left_at(&settings, &track, event)));
                let seen = instant.place(&track, BodyPicture::Seen(eye)).expect("in the domain");
                assert!(seen.distance(place(left)) < 1e-8, "{case:?}: {seen} {left:?}");
            }
            // The same in spacetime, whose origin is the ground's.
            let diagram = Diagram::new(&settings, &track, time, settings.frame(time)).expect("in the domain");
            assert!((diagram.other_now() - now).abs() < 1e-9, "{} {now}", diagram.other_now());
            let event = applied(&there, event_at(&settings, &track, now));
            let drawn = diagram.point.at(diagram.other_now());
            assert!((drawn.x - event[1]).abs() < 1e-9 && (drawn.t - event[0]).abs() < 1e-9);
            assert!((drawn.t - diagram.present.t).abs() < 1e-9, "now, mine is level");
            assert_eq!(diagram.nows()[1].step, Event { x: 1.0, t: 0.0 });
        }
    }
}

#[test]
fn where_i_am_is_where_the_rider_is() {
    for case in &RIDES {
        for frame in [MapFrame::Ground, MapFrame::Bicycle] {
            let settings = settings(case, frame);
            let speed = if frame == MapFrame::Ground { 0.0 } else { 0.6 };
            let there = boost([speed / (1.0f64 - speed * speed).sqrt(), 0.0, 0.0]);
            let time = case.3;
            for (eye, at) in eyes(&settings, time).into_iter().zip(MapInstant::new(&settings, time).eyes()) {
                assert!(at.distance(place(applied(&there, eye))) < 1e-12, "{case:?}");
            }
            let range = [0.0, 2.0 * time];
            let way = way_of_rider(&settings, time, range);
            let ([x, y, z], middle) = (settings.rider(time).observer().place, way[way.len() / 2]);
            let here = applied(&there, [settings.rider(time).street_time, x, y, z]);
            assert!(middle.distance(place(here)) < 1e-12, "{case:?}: {middle} {here:?}");
        }
    }
}

#[test]
fn both_nows_pass_the_point_where_it_is_now_in_each_frame() {
    for case in &RIDES {
        for frame in [MapFrame::Ground, MapFrame::Bicycle, MapFrame::Rider] {
            let settings = settings(case, frame);
            let time = case.3;
            for track in tracks() {
                let diagram =
                    Diagram::new(&settings, &track, time, settings.frame(time)).expect("in the domain");
                let [ground, mine] = diagram.nows();
                for (line, event) in
                    [(ground, diagram.measured()), (mine, diagram.point.at(diagram.other_now()))]
                {
                    let Event { x, t } = Event { x: event.x - line.through.x, t: event.t - line.through.t };
                    let off = x * line.step.t - t * line.step.x;
                    let length = line.step.x.hypot(line.step.t);
                    assert!(off.abs() < 1e-9 * length, "{case:?} {frame:?}: {off} off {line:?}");
                }
                let [low, high] = home(&settings, &track, time, settings.frame(time)).expect("it is shown");
                let now = diagram.point.at(diagram.other_now());
                let shown = diagram.rays.iter().flat_map(|ray| [ray.left, ray.received]);
                for Event { x, t } in shown.chain([now, diagram.measured()]) {
                    assert!((low.x..=high.x).contains(&x) && (low.t..=high.t).contains(&t), "{case:?}");
                }
            }
        }
    }
}

#[test]
fn the_present_of_who_rides_across_is_level_and_displaced() {
    let case = ("coast", 90.0, 0.0, 0.0);
    let mut settings = settings(&case, MapFrame::Ground);
    (settings.ride.ride_speed, settings.ride.ride_from) = ("0.8".parse().expect("a velocity"), 0.0);
    (settings.motion.depth_shift, settings.motion.height_shift) = (0.0, 0.0);
    let diagram = Diagram::new(&settings, &tracks()[0], 0.0, ObserverVelocity::REST).expect("in the domain");
    let [_, mine] = diagram.nows();
    // T + V y, of what is at y = 3.
    assert!(mine.step.t == 0.0 && (mine.through.t - 2.4).abs() < 1e-15, "{mine:?}");
}

/// A point of a wheel that rolls, where it is at one time of mine: by its angle on its own clock.
#[test]
fn a_wheel_is_measured_as_it_has_turned_by_my_clock() {
    let scene = Scene::preset("wheel").expect("a preset");
    let wheel = scene.bodies.iter().find_map(|body| body.spin).expect("it has wheels");
    let hub = DVec3::from(wheel.hub);
    let rest = hub + 0.7 * wheel.radius * DVec3::new(0.6, 0.0, 0.8);
    for case in &RIDES {
        let settings = settings(case, MapFrame::Rider);
        let time = case.3;
        let instant = MapInstant::new(&settings, time);
        let observer = settings.rider(time).observer();
        let there = boost(observer.velocity.proper());
        let [x, y, z] = observer.place;
        let here = [observer.time, x, y, z];
        let (beta, gamma) = (0.6, 1.25);
        let point = MaterialPoint { rest, spin: Some(wheel) };
        let at = |own: f64| {
            let (sin, cos) = (beta / wheel.radius * own).sin_cos();
            let off = rest - hub;
            let turned = hub + DVec3::new(off.x * cos + off.z * sin, off.y, off.z * cos - off.x * sin);
            let place = DVec3::from(settings.rest_place(turned.to_array()));
            let event = [gamma * (own + beta * place.x), gamma * (place.x + beta * own), place.y, place.z];
            applied(&there, std::array::from_fn(|i| event[i] - here[i]))
        };
        let own = bisected(-1e3, 1e3, |own| -at(own)[0]);
        let shown =
            instant.places(Motion::Scene).place(BodyPicture::Measured, point).expect("it is somewhere");
        assert!(shown.distance(place(at(own))) < 1e-9, "{case:?}: {shown} {:?}", at(own));
    }
}

#[test]
fn the_kerbs_are_where_their_stones_are_measured() {
    for case in &RIDES {
        for frame in [MapFrame::Ground, MapFrame::Rider] {
            let settings = settings(case, frame);
            let scene = Scene::preset("street").expect("a preset");
            let instant = MapInstant::new(&settings, case.3);
            let places = instant.places(Motion::Own(Velocity::REST));
            let ground = scene.ground_z.expect("it has a ground");
            let kerbs = street_lines(&instant, &scene, MapProjection::Plan);
            assert_eq!(kerbs.len(), 3);
            for (([from, to], _), y) in kerbs.into_iter().zip(scene.street.expect("it has kerbs")) {
                let stone = places.measured(DVec3::new(77.0, y, ground));
                let off = (stone.x - from[0]) * (to[1] - from[1]) - (stone.y - from[1]) * (to[0] - from[0]);
                assert!(
                    off.abs() < 1e-9 * (to[0] - from[0]).hypot(to[1] - from[1]) * 77.0,
                    "{case:?}: {off}"
                );
            }
            // Below the eyes.
            let (([from, to], _), eyes) =
                (street_lines(&instant, &scene, MapProjection::Side)[0], instant.middle());
            for x in [-5.0, 60.0] {
                let y = bisected(-1e4, 1e4, |y| eyes.y - places.measured(DVec3::new(x, y, ground)).y);
                let below = places.measured(DVec3::new(x, y, ground));
                let off = (below.x - from[0]) * (to[1] - from[1]) - (below.z - from[1]) * (to[0] - from[0]);
                assert!(off.abs() < 1e-6 * (to[0] - from[0]).hypot(to[1] - from[1]), "{case:?}: {off}");
            }
        }
    }
}

#[test]
fn the_map_holds_the_rider_and_what_is_seen() {
    for case in &RIDES {
        for frame in [MapFrame::Ground, MapFrame::Bicycle, MapFrame::Rider] {
            let settings = Settings {
                map: crate::settings::MapSettings {
                    face: MapFace::Space,
                    frame,
                    ..settings(case, frame).map
                },
                ..settings(case, frame)
            };
            let instant = MapInstant::new(&settings, case.3);
            let seen = [0, 1].map(|eye| instant.place(&tracks()[0], BodyPicture::Seen(eye)));
            let seen: Vec<DVec3> = seen.into_iter().flatten().collect();
            let velocity = instant.observer().velocity;
            let beta = velocity.speed().beta() * DVec3::from(velocity.direction());
            let WorldBox(extent) = WorldBox::of_ride_aslant(instant.middle(), beta, seen.iter().copied());
            for place in instant.eyes().into_iter().chain(seen) {
                for axis in 0..3 {
                    let [low, high] = extent[axis];
                    assert!((low..=high).contains(&place[axis]), "{case:?} {frame:?}: {place} {extent:?}");
                }
            }
        }
    }
}

#[test]
fn one_cone_for_both_eyes_has_its_apex_between_them_on_a_ride_too() {
    let mut settings = settings(&RIDES[1], MapFrame::Ground);
    settings.look.geometry = Geometry::OneCone;
    let time = RIDES[1].3;
    let rider = settings.rider(time).observer();
    let [x, y, z] = rider.place;
    for track in tracks() {
        let rays = rays(&settings, &track, time, settings.frame(time)).expect("in the domain");
        let left = left_at(&settings, &track, [rider.time, x, y, z]);
        for ray in rays {
            assert!((ray.left.t - left).abs() < 1e-9 && ray.apex == Event { x, t: rider.time }, "{ray:?}");
        }
    }
}
