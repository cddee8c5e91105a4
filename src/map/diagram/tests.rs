//! The spacetime face, held against light cones and against itself in the other frame.

use relativity_render::Motion;

use super::*;
use crate::flags::{SpeedParameter, SpeedSetting};
use crate::map::fronts;

/// Points that move with the scene, rest on the ground, come the other way, and pass slower.
fn tracks() -> Vec<Track> {
    let own = |beta| Motion::Own(Velocity::from_beta(beta).expect("in range"));
    let motions = [Motion::Scene, Motion::Own(Velocity::REST), own(-0.8), own(0.5)];
    motions.map(|motion| Track { rest: [-0.7, 3.0, 2.0], motion, spin: None }).to_vec()
}

fn settings(parameter: SpeedParameter, value: f64) -> Settings {
    let mut settings = Settings::default();
    settings.motion.speed = SpeedSetting::new(parameter, value).expect("a speed");
    settings
}

/// Returns diagrams at a few T for all kinds of points at a few speeds, on the ground and in the scene's
/// frame.
fn diagrams() -> Vec<[Diagram; 2]> {
    let mut all = Vec::new();
    for beta in [0.0, 0.01, 0.6, 0.9, 0.99] {
        let settings = settings(SpeedParameter::Beta, beta);
        for track in tracks() {
            for time in [-6.0, 1.1, 3.6, 20.0] {
                let frames = [ObserverVelocity::REST, ObserverVelocity::along_street(settings.speed())];
                all.push(
                    frames.map(|frame| Diagram::new(&settings, &track, time, frame).expect("in the domain")),
                );
            }
        }
    }
    all
}

/// The cones, of frames along the street.
fn cones(diagram: &Diagram) -> [PastCone; 2] {
    diagram.cones().expect("it moves along the street")
}

/// Returns the magnitude of its numbers.
fn scale(diagram: &Diagram) -> f64 {
    let [left, right] = diagram.rays;
    let events = [diagram.measured(), left.left, left.received, right.left, right.received];
    events.iter().map(|event| event.x.abs().max(event.t.abs())).fold(cones(diagram)[0].distance, f64::max)
}

#[track_caller]
fn assert_same(a: Event, b: Event, scale: f64) {
    assert!((a.x - b.x).abs() < 1e-12 * scale && (a.t - b.t).abs() < 1e-12 * scale, "{a:?} {b:?}");
}

#[test]
fn light_leaves_the_worldline_where_it_meets_the_cone_and_takes_no_interval_in_both_frames() {
    for diagram in diagrams().iter().flatten() {
        let scale = scale(diagram);
        for (ray, cone) in diagram.rays.iter().zip(cones(diagram)) {
            assert_same(diagram.point.at(ray.happened), ray.left, scale);
            assert!((cone.time(ray.left.x) - ray.left.t).abs() < 1e-12 * scale, "{diagram:?}");
            let [x, t] = [ray.received.x - ray.left.x, ray.received.t - ray.left.t];
            let interval = t * t - x * x - 13.0;
            assert!(t > 0.0 && interval.abs() < 1e-12 * scale * scale, "{interval} {diagram:?}");
        }
    }
}

#[test]
fn light_leaves_where_the_space_face_shows_what_each_eye_sees() {
    use crate::map::{BodyPicture, MapInstant};
    for geometry in [relativity_render::Geometry::Seen, relativity_render::Geometry::OneCone] {
        let mut settings = settings(SpeedParameter::Beta, 0.9);
        settings.look.geometry = geometry;
        for track in tracks() {
            let rays = rays(&settings, &track, 1.7, ObserverVelocity::REST).expect("in the domain");
            let instant = MapInstant::new(&settings, 1.7);
            for (eye, ray) in rays.iter().enumerate() {
                let place = instant.place(&track, BodyPicture::Seen(eye)).expect("in the domain");
                let off = place - glam::DVec3::new(ray.left.x, place.y, place.z);
                assert!(off.length() < 1e-9, "{geometry:?} {track:?}: {off}");
                let glam::DVec3 { y, z, .. } =
                    PointWorldline::new(&settings, &track, ObserverVelocity::REST).place(0.0);
                assert!((place.y - y).abs() < 1e-12 && (place.z - z).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn one_cone_for_both_eyes_has_its_apex_between_them() {
    let mut settings = settings(SpeedParameter::Beta, 0.9);
    settings.look.geometry = relativity_render::Geometry::OneCone;
    for frame in [ObserverVelocity::REST, ObserverVelocity::along_street(settings.speed())] {
        let diagram = Diagram::new(&settings, &tracks()[0], 2.0, frame).expect("in the domain");
        let [left, right] = diagram.rays;
        assert_same(left.left, right.left, 10.0);
        for cone in cones(&diagram) {
            assert_eq!(cone.apex, diagram.present);
            assert!((cone.time(left.left.x) - left.left.t).abs() < 1e-12 * 10.0);
        }
    }
}

#[test]
fn the_diagram_of_the_other_frame_is_this_one_transformed() {
    for [ground, scene] in diagrams() {
        let (scale, frame) = (scale(&ground).max(scale(&scene)), scene.frame);
        let there = |event: Event| frame.event_at([event.x, 0.0, 0.0], event.t);
        for (here, seen) in ground.rays.iter().zip(scene.rays) {
            assert_same(there(here.left), seen.left, scale);
            assert_same(there(here.received), seen.received, scale);
            assert_eq!((here.happened, here.proper_time), (seen.happened, seen.proper_time));
        }
        assert_same(there(ground.measured()), scene.measured(), scale);
        let now = ground.other_now();
        assert!((now - scene.other_now()).abs() <= 1e-12 * now.abs());
        assert_same(there(ground.point.at(now)), scene.point.at(now), scale);
        for (here, there_drawn) in ground.nows().iter().zip(scene.nows()) {
            assert_same(there(here.step), there_drawn.step, 1.0);
        }
        for (here, there_drawn) in ground.eyes().iter().zip(scene.eyes()) {
            assert_same(there(here.step), there_drawn.step, 1.0);
        }
    }
}

#[test]
fn each_now_passes_the_point_where_its_clocks_show_the_time_of_the_present() {
    for [ground, scene] in diagrams() {
        assert_eq!(ground.measured().t, ground.present.t);
        let now = scene.point.at(scene.other_now());
        assert!((now.t - scene.present.t).abs() < 1e-12 * scale(&scene), "{scene:?}");
    }
}

#[test]
fn a_front_that_left_for_an_eye_reaches_it_in_plan_and_from_the_side() {
    for diagram in diagrams().iter().flatten() {
        let scale = scale(diagram);
        for ray in diagram.rays {
            let along = ray.received.x - ray.left.x;
            let [y, z] = ray.across;
            for (in_plane, across) in [(y, z), (z, y)] {
                let radius = ray.front().radius_in_plane(across).expect("it has come so far");
                assert!((radius - along.hypot(in_plane)).abs() < 1e-12 * scale * scale, "{diagram:?}");
            }
        }
    }
}

#[test]
fn fronts_grow_with_time_and_arrive_as_often_as_the_doppler_factor_says() {
    let settings = settings(SpeedParameter::Beta, 0.9);
    let track = tracks()[0];
    let at = |time| Diagram::new(&settings, &track, time, ObserverVelocity::REST).expect("in the domain");
    let diagram = at(2.0);
    let [earlier, later] = [2.0, 2.2].map(|now| fronts(&diagram.point, now, 0.75).collect::<Vec<_>>());
    for front in &earlier {
        assert!((0.0..7.5).contains(&front.radius), "{front:?}");
        assert_same(front.left, diagram.point.at(front.happened), 10.0);
        let grown = later.iter().find(|later| later.left == front.left).expect("it goes on");
        assert!((grown.radius - front.radius - 0.2).abs() < 1e-12);
    }
    let [happened, soon] = [-4.0, -4.0 + 1e-6];
    let own = |happened| diagram.point.proper_time(happened);
    let arrival = |happened| diagram.point.received(&settings.ride, happened);
    let rate = (own(soon) - own(happened)) / (arrival(soon) - arrival(happened));
    let both = settings.disparity(&track, arrival(happened)).expect("in the domain");
    let expected = 0.5 * (both.primary.doppler_factor + both.secondary.doppler_factor);
    assert!((rate / expected - 1.0).abs() < 1e-3, "{rate} {expected}");
}

#[test]
fn nothing_that_is_shown_is_beyond_all_numbers_at_the_greatest_speeds() {
    for gamma in [1e9, 1e30] {
        let settings = settings(SpeedParameter::Gamma, gamma);
        for track in tracks() {
            for (time, frame) in [-1e6, 0.0, 4.0].into_iter().flat_map(|time| {
                [ObserverVelocity::REST, ObserverVelocity::along_street(settings.speed())].map(|f| (time, f))
            }) {
                let diagram = Diagram::new(&settings, &track, time, frame).expect("in the domain");
                let [low, high] = home(&settings, &track, time, frame).expect("in the domain");
                let lines = diagram.nows().into_iter().chain(diagram.eyes()).chain([diagram.worldline()]);
                let drawn = lines.filter_map(|line| line.within(low, high)).flatten();
                let curves = cones(&diagram).into_iter().flat_map(|cone| cone.curve([low.x, high.x]));
                let now = diagram.point.at(diagram.other_now());
                if frame == diagram.other && diagram.point.rests {
                    assert!((now.t / diagram.present.t - 1.0).abs() < 1e-12 || time == 0.0, "{diagram:?}");
                }
                for event in drawn.chain(curves).chain([low, high, now]) {
                    assert!(event.x.is_finite() && event.t.is_finite(), "{gamma} {diagram:?}");
                }
                assert!(low.x < high.x && low.t < high.t, "{gamma} {track:?} {low:?} {high:?}");
            }
        }
    }
}

#[test]
fn what_is_shown_at_first_holds_still_while_the_point_passes_grows_and_then_follows() {
    let settings = settings(SpeedParameter::Beta, 0.9);
    let track = Track { rest: [0.0, 3.0, 2.0], motion: Motion::Scene, spin: None };
    let home = |time| home(&settings, &track, time, ObserverVelocity::REST).expect("in the domain");
    let [low, high] = home(3.6);
    assert_eq!(home(1.1), [low, high]);
    assert!((high.t - low.t - (high.x - low.x)).abs() < 5.0, "about square: {low:?} {high:?}");
    for time in [1.1, 3.6, 4.3] {
        let diagram = Diagram::new(&settings, &track, time, ObserverVelocity::REST).expect("in the domain");
        for event in diagram.rays.iter().flat_map(|ray| [ray.left, ray.received]) {
            assert!((low.x..=high.x).contains(&event.x) && (low.t..=high.t).contains(&event.t));
        }
    }
    let [wider, _] = home(-0.2);
    assert!(wider.x < low.x - 3.0 && wider.t < low.t - 3.0, "{wider:?}");
    let [[before, _], [after, _]] = [60.0, 100.0].map(home);
    assert!(before.x == after.x && (after.t - before.t - 40.0).abs() < 1e-12);
}

#[test]
fn a_line_is_cut_at_the_sides_and_nothing_is_left_of_one_that_passes_by() {
    let [low, high] = [Event { x: -1.0, t: 0.0 }, Event { x: 1.0, t: 4.0 }];
    let line = |x, t| StraightLine { through: Event { x: 0.0, t: 2.0 }, step: Event { x, t } };
    assert_eq!(line(0.0, 2.0).within(low, high), Some([Event { x: 0.0, t: 0.0 }, Event { x: 0.0, t: 4.0 }]));
    assert_eq!(line(1.0, 1.0).within(low, high), Some([Event { x: -1.0, t: 1.0 }, Event { x: 1.0, t: 3.0 }]));
    let beside = StraightLine { through: Event { x: 3.0, t: 0.0 }, step: Event { x: 0.0, t: 1.0 } };
    assert_eq!(beside.within(low, high), None);
}

#[test]
fn a_drawn_cone_bends_as_a_hyperbola_and_ends_at_the_sides() {
    let cone = PastCone { apex: Event { x: 1.0, t: 5.0 }, distance: 2.0 };
    let curve = cone.curve([-9.0, 6.0]);
    assert!((curve[0].x + 9.0).abs() < 1e-12 && (curve[curve.len() - 1].x - 6.0).abs() < 1e-12);
    for pair in curve.windows(2) {
        let middle = 0.5 * (pair[0].x + pair[1].x);
        let off = cone.time(middle) - 0.5 * (pair[0].t + pair[1].t);
        assert!(pair[0].x < pair[1].x && (0.0..2e-3).contains(&off), "{off}");
    }
}
