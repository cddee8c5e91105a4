//! Wheels that roll, on the map.

use glam::DVec3;
use relativity_core::{Event, ObserverVelocity};
use relativity_render::{Spin, Velocity};

use super::{AREA, settings};
use crate::flags::{SpeedParameter, SpeedSetting};
use crate::map::{
    BodyPicture, Diagram, MapInstant, OutlineLines, PointWorldline, Viewpoint, WorldBox, home, plan_and_side,
};
use crate::scene::{Scene, Track};
use crate::settings::MapFrame;

const BETA: f64 = 0.93;

fn gamma() -> f64 {
    1.0 / (1.0 - BETA * BETA).sqrt()
}

/// A wheel that comes the other way.
const ONCOMING: &str = "name = \"x\"\n[[group]]\nname = \"oncoming\"\nbeta = -0.8\n[[group.wheel]]\nhub = [1, 4, 0.5]\n\
                        radius = 0.5\ntyre = 0.03\nrim = 0.02\naxle = 0.2\nhub_radius = 0.05\nspokes = 9\nspoke_radius = 0.01\n\
                        flanges = 0.1\ncrossing = 50\nrolls = true\nvalve = true\n";

fn wheel() -> (Scene, Spin) {
    let scene = Scene::preset("wheel").expect("a preset");
    let spin = scene.bodies[0].spin.expect("it rolls");
    (scene, spin)
}

/// Returns the place of a point that is at `rest` at t' = 0, in the frame of a wheel that rolls at `beta`,
/// when the clocks there show `proper_time`.
fn turned(beta: f64, spin: &Spin, rest: DVec3, proper_time: f64) -> DVec3 {
    let [x, _, z] = spin.hub;
    let (dx, dz) = (rest.x - x, rest.z - z);
    let (sin, cos) = (beta / spin.radius * proper_time).sin_cos();
    DVec3::new(x + dx * cos + dz * sin, rest.y, z + dz * cos - dx * sin)
}

/// Returns the distance of the ground's event at `place` and `t` from the worldline of the point that is at
/// `rest` at t' = 0.
fn off(beta: f64, spin: &Spin, rest: DVec3, place: DVec3, t: f64) -> f64 {
    let gamma = 1.0 / (1.0 - beta * beta).sqrt();
    let proper_time = gamma * (t - beta * place.x);
    let there = DVec3 { x: gamma * (place.x - beta * t), ..place };
    there.distance(turned(beta, spin, rest, proper_time))
}

#[test]
fn what_is_measured_and_what_is_seen_of_a_wheel_lies_on_the_worldlines_of_its_points() {
    let oncoming = Scene::parse(ONCOMING, "x").unwrap_or_else(|error| panic!("{error}"));
    let settings = settings(BETA, MapFrame::Ground);
    for (scene, beta) in [(wheel().0, BETA), (oncoming, -0.8)] {
        let spin = scene.bodies[0].spin.expect("it rolls");
        for time in [-5.0, 0.0, 1.5, 6.0] {
            let charts = plan_and_side(AREA, &WorldBox::of_space(&settings, &scene), &Viewpoint::default());
            let lines = OutlineLines::new(&MapInstant::new(&settings, time), &scene, &charts);
            let mut counts = [0, 0];
            for line in &lines.all {
                for vertex in lines.vertices(line) {
                    let t = match line.picture {
                        BodyPicture::Measured => time,
                        BodyPicture::Seen(eye) => {
                            time - vertex.place.distance(DVec3::new([-0.2, 0.2][eye], 0.0, 0.0))
                        }
                        BodyPicture::Stereo => continue,
                    };
                    let off = off(beta, &spin, vertex.rest, vertex.place, t);
                    assert!(off < 1e-9, "T = {time}: {off} off at {vertex:?} of {line:?}");
                    counts[usize::from(line.picture == BodyPicture::Measured)] += 1;
                }
            }
            assert!(counts.iter().all(|count| *count >= 100), "{counts:?}");
        }
    }
}

#[test]
fn on_the_ground_spokes_crowd_at_the_top() {
    let (scene, spin) = wheel();
    let settings = settings(BETA, MapFrame::Ground);
    let places = MapInstant::new(&settings, 0.0).places(scene.groups[0].motion);
    // Two points of the rim close together, at the top or at the bottom at t' = 0, when the hub is abreast.
    let angle = |up: f64, a: f64| {
        let tip = DVec3::from(spin.hub) + spin.radius * DVec3::new(a.sin(), 0.0, up * a.cos());
        let point = relativity_render::MaterialPoint { rest: tip, spin: Some(spin) };
        let DVec3 { x, z, .. } = places.measured(point) - DVec3::from(spin.hub);
        (gamma() * x).atan2(up * z)
    };
    let gap = |up: f64| angle(up, 1e-5) - angle(up, -1e-5);
    let density = gap(-1.0) / gap(1.0);
    let expected = (1.0 + BETA * BETA) / (1.0 - BETA * BETA);
    assert!((density / expected - 1.0).abs() < 1e-6 && (density - 13.8).abs() < 0.05, "{density} {expected}");
}

#[test]
fn in_its_own_frame_a_wheel_is_round_and_even() {
    let (scene, spin) = wheel();
    let settings = settings(BETA, MapFrame::Bicycle);
    let places = MapInstant::new(&settings, 1.5).places(scene.groups[0].motion);
    for body in &scene.bodies {
        let rest = DVec3::from(match body.shape {
            relativity_render::Shape::Ring { centre: [x, y, z], radius, .. } => [x + radius, y, z],
            relativity_render::Shape::Tube { to, .. } => to,
            _ => panic!("no part of a wheel"),
        });
        let found = places.measured(relativity_render::MaterialPoint { rest, spin: Some(spin) });
        let expected = turned(BETA, &spin, rest, gamma() * 1.5);
        assert!(found.distance(expected) < 1e-12, "{found} {expected}");
    }
}

#[test]
fn the_worldline_of_a_point_of_the_rim_rests_on_the_road_and_runs_ahead_at_the_top() {
    let (scene, _) = wheel();
    let settings = settings(BETA, MapFrame::Ground);
    // On the road at t = 0.
    let track = scene.track(Some([0.0, 4.0, -1.25]));
    let worldline = PointWorldline::new(&settings, &track, ObserverVelocity::REST);
    let speed = |t: f64| (worldline.at(t + 1e-5).x - worldline.at(t - 1e-5).x) / 2e-5;
    assert!(worldline.at(0.0).x.abs() < 1e-12 && speed(0.0).abs() < 1e-8, "{}", speed(0.0));
    // Half a turn later: pi W / beta by its own clocks.
    let top = gamma() * std::f64::consts::PI * 1.25 / BETA;
    let expected = 2.0 * BETA / (1.0 + BETA * BETA);
    assert!((speed(top) - expected).abs() < 1e-8, "{} {expected}", speed(top));
    assert!((worldline.place(top).z - 1.25).abs() < 1e-12, "{}", worldline.place(top).z);
}

#[test]
fn the_drawn_worldline_of_a_wheels_point_is_the_real_one() {
    let (scene, spin) = wheel();
    for frame in [MapFrame::Ground, MapFrame::Bicycle] {
        let settings = settings(BETA, frame);
        let track = scene.track(Some([1.25, 4.0, 0.0]));
        assert_eq!(track.spin, Some(spin));
        let diagram = Diagram::new(&settings, &track, 1.0, settings.frame(1.0)).expect("in the domain");
        let [low, high] = [Event { x: -20.0, t: -20.0 }, Event { x: 20.0, t: 20.0 }];
        let times = diagram.times_within(low, high);
        assert!(times.len() > 60 && times.is_sorted_by(|a, b| a < b), "{}", times.len());
        for pair in times.windows(2) {
            let [from, middle, to] =
                [pair[0], 0.5 * (pair[0] + pair[1]), pair[1]].map(|t| diagram.point.at(t));
            // As far as a curve bends that turns by 1/48 of a circle of 1.25: 1.25 (1 - cos(pi/48)).
            let part = (middle.t - from.t) / (to.t - from.t);
            let off = middle.x - (from.x + part * (to.x - from.x));
            assert!(off.abs() < 0.02, "{off}");
        }
        for ray in diagram.rays {
            let event = diagram.point.at(ray.happened);
            assert!((event.x - ray.left.x).abs() < 1e-9 && (event.t - ray.left.t).abs() < 1e-9, "{ray:?}");
        }
        let now = diagram.point.at(diagram.other_now()).in_frame(Velocity::REST);
        let in_scene = if frame == MapFrame::Ground { now.in_frame(settings.speed()) } else { now };
        assert!((in_scene.t - gamma()).abs() < 1e-12, "{in_scene:?}");
    }
}

#[test]
fn what_is_pointed_at_on_a_tyre_is_a_point_that_turns_with_it() {
    let (scene, spin) = wheel();
    let settings = settings(BETA, MapFrame::Ground);
    let charts = plan_and_side(AREA, &WorldBox::of_space(&settings, &scene), &Viewpoint::default());
    let instant = MapInstant::new(&settings, 2.0);
    let lines = OutlineLines::new(&instant, &scene, &charts);
    let side = (crate::map::MapProjection::Side, &charts[1]);
    for picture in [BodyPicture::Measured, BodyPicture::Seen(0)] {
        // The top of the tyre in this picture, with a point that turns and is there now.
        let line = lines.all.iter().find(|line| line.body == 0 && line.picture == picture);
        let vertices = lines.vertices(line.expect("the tyre is drawn"));
        let top = vertices.iter().max_by(|a, b| a.place.z.total_cmp(&b.place.z)).expect("it has points");
        let pointer = charts[1].screen([top.place.x, top.place.z]);
        let nearest = lines.nearest(side, pointer, 9.0).expect("it is there");
        assert_eq!((nearest.line.body, nearest.line.picture), (0, picture));
        let track: Track = scene.track_at(nearest.surface.to_array(), 0).expect("a body");
        assert_eq!(track.spin, Some(spin));
        let shown = instant.place(&track, picture).expect("it is shown");
        // On the side of the eyes, 0.05 before the middle of the tube: what an eye sees there left up to 0.05
        // later.
        assert!(shown.distance(top.place) < 0.05 * 2.0, "{picture:?}: {shown} {}", top.place);
    }
}

#[test]
fn nothing_of_a_wheel_is_beyond_all_numbers_at_the_greatest_speeds() {
    let (scene, spin) = wheel();
    for (gamma, frame) in
        [1e9, 1e30].into_iter().flat_map(|gamma| [MapFrame::Ground, MapFrame::Bicycle].map(|f| (gamma, f)))
    {
        let mut settings = settings(0.5, frame);
        settings.motion.speed = SpeedSetting::new(SpeedParameter::Gamma, gamma).expect("a speed");
        let track = scene.track(Some([0.0, 4.0, -1.25]));
        assert_eq!(track.spin, Some(spin));
        for time in [-1e6, 0.0, 4.0] {
            let diagram = Diagram::new(&settings, &track, time, settings.frame(time)).expect("in the domain");
            let [low, high] = home(&settings, &track, time, settings.frame(time)).expect("in the domain");
            let drawn = diagram.times_within(low, high).into_iter().map(|t| diagram.point.at(t));
            let left = diagram.rays.map(|ray| ray.left);
            for event in drawn.chain(left).chain([low, high, diagram.point.at(diagram.other_now())]) {
                assert!(event.x.is_finite() && event.t.is_finite(), "{gamma} {time} {diagram:?}");
            }
            let charts = plan_and_side(AREA, &WorldBox::of_space(&settings, &scene), &Viewpoint::default());
            let lines = OutlineLines::new(&MapInstant::new(&settings, time), &scene, &charts);
            for vertex in lines.all.iter().flat_map(|line| lines.vertices(line)) {
                assert!(vertex.place.is_finite() && vertex.rest.is_finite(), "{gamma} {time} {vertex:?}");
            }
        }
    }
}
