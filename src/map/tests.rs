//! The map, held against formulas written down here.

mod riding;
mod wheels;

use std::time::{Duration, Instant as Clock};

use glam::DVec3;
use relativity_core::{Aperture, ObserverVelocity, SourcePoint, Speed, sighting};
use relativity_render::{Geometry, Motion, Shape};

use super::*;
use crate::flags::{SpeedParameter, SpeedSetting};
use crate::scene::{Scene, Track};
use crate::settings::{MapFrame, MapSettings, Settings};

const AREA: [f64; 4] = [0.0, 0.0, 900.0, 600.0];

fn settings(beta: f64, frame: MapFrame) -> Settings {
    let mut settings = Settings { scene: "cyclist".to_owned(), ..Settings::default() };
    settings.motion.speed = SpeedSetting::new(SpeedParameter::Beta, beta).expect("a speed");
    settings.motion.d = 0.4;
    settings.map = MapSettings { frame, ..MapSettings::default() };
    settings
}

fn cyclist() -> Scene {
    Scene::preset("cyclist").expect("a preset")
}

fn lines(settings: &Settings, scene: &Scene, time: f64) -> (OutlineLines, [Chart; 2]) {
    let extent = WorldBox::of_space(settings, scene);
    let charts = plan_and_side(AREA, &extent, &Viewpoint::default());
    (OutlineLines::new(&MapInstant::new(settings, time), scene, &charts), charts)
}

#[test]
fn what_is_measured_is_contracted_and_as_far_as_it_has_come() {
    for beta in [0.0, 0.3, 0.9, 0.999] {
        let gamma = 1.0 / (1.0f64 - beta * beta).sqrt();
        let (lines, _) = lines(&settings(beta, MapFrame::Ground), &cyclist(), 2.5);
        let measured = lines.all.iter().filter(|line| line.picture == BodyPicture::Measured);
        let mut count = 0;
        for vertex in measured.flat_map(|line| lines.vertices(line)) {
            let DVec3 { x, y, z } = vertex.rest;
            let expected = DVec3::new(x / gamma + beta * 2.5, y, z);
            assert!(vertex.place.distance(expected) < 1e-12, "beta = {beta}: {vertex:?}");
            count += 1;
        }
        assert!(count > 300, "{count}");
    }
}

#[test]
fn what_an_eye_sees_left_on_its_past_light_cone() {
    // No formula of the program: where the light left, it was at the time it then had to travel.
    for beta in [0.5, 0.9, 0.99] {
        let gamma = 1.0 / (1.0f64 - beta * beta).sqrt();
        for time in [-4.0, 1.0, 6.0] {
            let (lines, _) = lines(&settings(beta, MapFrame::Ground), &cyclist(), time);
            for line in &lines.all {
                let BodyPicture::Seen(eye) = line.picture else { continue };
                for vertex in lines.vertices(line) {
                    let eye = DVec3::new([-0.2, 0.2][eye], 0.0, 0.0);
                    let left_at = time - vertex.place.distance(eye);
                    let x = vertex.rest.x / gamma + beta * left_at;
                    let off = (vertex.place - DVec3 { x, ..vertex.rest }).length();
                    assert!(off < 1e-9, "beta = {beta}, T = {time}: {off} off at {vertex:?}");
                }
            }
        }
    }
}

#[test]
fn two_eyes_take_it_to_be_where_their_lines_of_sight_cross() {
    let settings = settings(0.9, MapFrame::Ground);
    let instant = MapInstant::new(&settings, 1.5);
    let speed = Speed::from_beta(0.9).expect("a speed");
    for rest in [[0.0, 3.0, 2.0], [-1.6, 2.9, 1.4], [-0.5, 3.2, 3.0]] {
        let point = SourcePoint::from_rest(rest, &speed);
        let see = |aperture| sighting(&speed, point, aperture, 1.5).expect("in the domain").position;
        let [left, right] = Aperture::pair(0.4).map(see);
        let reach = 0.4 / (left[0] - right[0]);
        let expected = DVec3::new(-0.2 + reach * left[0], reach * left[1], reach * left[2]);
        let places = instant.places(Motion::Scene);
        let shown = places.place(BodyPicture::Stereo, rest).expect("in the domain");
        assert!(shown.distance(expected) < 1e-12, "{shown} for {expected}");
    }
}

#[test]
fn each_eye_sees_from_where_it_is_whatever_the_views_show() {
    let exact = settings(0.9, MapFrame::Ground);
    for geometry in [Geometry::Contracted, Geometry::Rest, Geometry::Published] {
        let mut other = exact.clone();
        other.look.geometry = geometry;
        let [there, here] = [&exact, &other].map(|settings| {
            let places = MapInstant::new(settings, 1.5).places(Motion::Scene);
            [BodyPicture::Seen(0), BodyPicture::Seen(1)]
                .map(|picture| places.place(picture, DVec3::new(0.0, 3.0, 2.0)))
        });
        assert_eq!(there, here, "{geometry:?}");
    }
}

#[test]
fn with_one_light_cone_both_eyes_see_one_place() {
    let mut settings = settings(0.9, MapFrame::Ground);
    settings.look.geometry = Geometry::OneCone;
    let places = MapInstant::new(&settings, 1.5).places(Motion::Scene);
    let place = |picture| places.place(picture, DVec3::new(-0.3, 3.0, 2.0)).expect("in the domain");
    for picture in [BodyPicture::Seen(1), BodyPicture::Stereo] {
        assert!(place(picture).distance(place(BodyPicture::Seen(0))) < 1e-12, "{picture:?}");
    }
}

#[test]
fn in_the_bicycles_frame_it_rests_and_the_street_is_contracted() {
    let mut settings = settings(0.8, MapFrame::Bicycle);
    settings.scene = "street".to_owned();
    let scene = Scene::preset("street").expect("a preset");
    let (lines, _) = lines(&settings, &scene, 3.0);
    let gamma = 1.0 / 0.6;
    // Wheels turn.
    let stays = |line: &&OutlineLine| scene.bodies[line.body].spin.is_none();
    for line in lines.all.iter().filter(stays) {
        for vertex in lines.vertices(line) {
            let DVec3 { x, y, z } = vertex.rest;
            // Its clocks show gamma T when the eyes' show T, and they ride back at 0.8.
            let x = if line.rests { x / gamma - 0.8 * gamma * 3.0 } else { x };
            assert!(vertex.place.distance(DVec3::new(x, y, z)) < 1e-12, "{line:?}: {vertex:?}");
        }
    }
    assert!(lines.all.iter().any(|line| line.rests) && lines.all.iter().any(|line| !line.rests));
}

#[test]
fn lines_are_as_smooth_as_they_promise() {
    for beta in [0.9, 0.9999] {
        let settings = settings(beta, MapFrame::Ground);
        let instant = MapInstant::new(&settings, 0.5);
        let (lines, charts) = lines(&settings, &cyclist(), 0.5);
        let places = instant.places(Motion::Scene);
        for line in &lines.all {
            for pair in lines.vertices(line).windows(2) {
                // Between two vertices of a straight tube: the body's own chord, where its image bends the
                // most.
                let rest = pair[0].rest.lerp(pair[1].rest, 0.5);
                let curve = places.place(line.picture, rest).expect("in the domain");
                let chord = 0.5 * (pair[0].place + pair[1].place);
                for (projection, chart) in MapProjection::BOTH.into_iter().zip(&charts) {
                    let [a, b] = [curve, chord].map(|place| chart.screen(projection.flat(place)));
                    let is_inside = |axis: usize| (a[axis] - chart.middle[axis]).abs() < chart.half[axis];
                    if is_inside(0) && is_inside(1) {
                        let off = (a[0] - b[0]).hypot(a[1] - b[1]);
                        assert!(off < 1.0, "beta = {beta}: {off} points off, {line:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_tube_across_the_motion_is_as_thin_as_it_is_contracted() {
    let gamma = 1.0 / (1.0f64 - 0.81).sqrt();
    let shape = Shape::Tube { from: [0.0, 3.0, 0.0], to: [0.0, 3.0, 2.0], radius: 0.1 };
    let mut scene = cyclist();
    scene.bodies[0].shape = shape;
    let (lines, _) = lines(&settings(0.9, MapFrame::Ground), &scene, 1.0);
    let line = lines.all.iter().find(|line| (line.body, line.picture) == (0, BodyPicture::Measured));
    let line = line.expect("it is drawn");
    let side = line.half_width(MapProjection::Side, [[0.0, 0.0], [0.0, 1.0]]);
    assert!((side - 0.1 / gamma).abs() < 1e-12, "{side}");
    // A line along the motion is as thick as at rest.
    let along = line.half_width(MapProjection::Side, [[0.0, 0.0], [1.0, 0.0]]);
    assert!((along - 0.1).abs() < 1e-12, "{along}");
}

#[test]
fn what_is_fitted_does_not_depend_on_t_nor_on_the_speed() {
    let scene = cyclist();
    let extent = |beta| WorldBox::of_space(&settings(beta, MapFrame::Ground), &scene);
    assert_eq!(extent(0.1), extent(0.99));
    // In the bicycle's frame it has steps.
    let on_board = |beta| WorldBox::of_space(&settings(beta, MapFrame::Bicycle), &scene);
    assert_eq!(on_board(0.5), on_board(0.55));
    assert_eq!(on_board(0.99), on_board(1.0 - 1e-12));
}

#[test]
fn the_nearest_point_is_on_the_body_under_the_pointer() {
    let scene = cyclist();
    let (lines, charts) = lines(&settings(0.9, MapFrame::Ground), &scene, 1.0);
    let mut checked = 0;
    for line in lines.all.iter().filter(|line| line.is_in(MapProjection::Side)).step_by(7) {
        let vertices = lines.vertices(line);
        let vertex = vertices[vertices.len() / 2];
        let pointer = charts[1].screen(MapProjection::Side.flat(vertex.place));
        let nearest = lines.nearest((MapProjection::Side, &charts[1]), pointer, 5.0).expect("it is there");
        let there = charts[1].screen(MapProjection::Side.flat(nearest.vertex.place));
        let reach = nearest.line.ball.map_or(0.0, |ball| ball.radii.map(DVec3::length).into_iter().sum());
        let off = (there[0] - pointer[0]).hypot(there[1] - pointer[1]);
        assert!(off <= 1e-6 + reach * charts[1].scale, "{off} points off");
        checked += 1;
    }
    assert!(checked > 20, "{checked}");
    assert_eq!(lines.nearest((MapProjection::Plan, &charts[0]), [-500.0, -500.0], 9.0), None);
}

#[test]
fn thousands_of_bodies_are_thinned_out() {
    let mut scene = cyclist();
    let body = |i: usize| {
        let centre = [(i % 80) as f64 * 0.2 - 8.0, 3.0, (i / 80) as f64 * 0.1];
        relativity_render::Body::new(Shape::Sphere { centre, radius: 0.09 }, 600.0)
    };
    scene.bodies = (0..6400).map(body).collect();
    scene.names = vec!["ball".to_owned(); 6400];
    scene.groups[0].count = 6400;
    let start = Clock::now();
    let (lines, _) = lines(&settings(0.9, MapFrame::Ground), &scene, 1.0);
    let took = start.elapsed();
    assert!((800..5000).contains(&lines.all.len()), "{}", lines.all.len());
    assert!(took < Duration::from_secs(1), "{took:?}");
}

#[test]
fn the_outline_of_a_ball_holds_all_of_it() {
    let shape = Shape::Sphere { centre: [-0.5, 3.0, 2.0], radius: 0.2 };
    let mut scene = cyclist();
    scene.bodies[0].shape = shape;
    let settings = settings(0.9, MapFrame::Ground);
    let (lines, _) = lines(&settings, &scene, 1.0);
    let places = MapInstant::new(&settings, 1.0).places(Motion::Scene);
    let around = |i: usize| std::f64::consts::TAU * i as f64 / 60.0;
    let surface = (0..60).flat_map(|i| (0..60).map(move |j| (around(i), around(j)))).map(|(a, b)| {
        DVec3::new(-0.5, 3.0, 2.0) + 0.2 * DVec3::new(a.cos() * b.cos(), a.sin() * b.cos(), b.sin())
    });
    let surface: Vec<DVec3> = surface.collect();
    for line in lines.all.iter().filter(|line| line.body == 0) {
        let projection = line.only.expect("each projection has its own");
        for i in 0..60 {
            let towards = glam::DVec2::from_angle(around(i));
            let reach = |place: DVec3| glam::DVec2::from(projection.flat(place)).dot(towards);
            let drawn = lines.vertices(line).iter().map(|vertex| reach(vertex.place)).fold(-1e9, f64::max);
            let image = |rest: &DVec3| reach(places.place(line.picture, *rest).expect("in the domain"));
            let whole = surface.iter().map(image).fold(-1e9, f64::max);
            assert!((drawn - whole).abs() < 0.02, "{:?} {projection:?}: {drawn} for {whole}", line.picture);
        }
    }
}

#[test]
fn a_tilted_and_turned_head_has_its_eyes_and_its_light_where_they_are() {
    let mut settings = settings(0.9, MapFrame::Ground);
    (settings.motion.roll, settings.motion.turn) = (30.0, -60.0);
    let instant = MapInstant::new(&settings, 1.5);
    let (sin, cos) = (0.5, 0.75f64.sqrt());
    let half = 0.2 * DVec3::new(cos * 0.5, -cos * cos, sin);
    let eyes = instant.eyes();
    assert!(eyes[0].distance(-half) < 1e-12 && eyes[1].distance(half) < 1e-12, "{eyes:?}");
    let track = Track { rest: [-0.7, 3.0, 2.0], motion: Motion::Scene, spin: None };
    let diagram = Diagram::new(&settings, &track, 1.5, ObserverVelocity::REST).expect("in the domain");
    for ((eye, ray), cone) in eyes.into_iter().zip(diagram.rays).zip(diagram.cones().expect("of the ground"))
    {
        assert!((ray.received.x - eye.x).abs() < 1e-12);
        assert!((DVec3::new(eye.x, ray.eye[0], ray.eye[1]) - eye).length() < 1e-12);
        let way = DVec3::new(ray.left.x, 3.0, 2.0).distance(eye);
        assert!((1.5 - ray.left.t - way).abs() < 1e-12, "light takes its time");
        assert!((cone.time(ray.left.x) - ray.left.t).abs() < 1e-12, "it is on the eye's cone");
    }
    let fused = instant.place(&track, BodyPicture::Stereo).expect("they meet");
    let stereo = settings.stereo(&track, 1.5).expect("they meet");
    assert_eq!(fused, DVec3::from(stereo.position));
}

/// The close-up of what moves with the scene at `time`.
fn close_up(settings: &Settings, scene: &Scene, time: f64) -> Option<WorldBox> {
    WorldBox::close_up(&MapInstant::new(settings, time), scene, Motion::Scene)
}

#[test]
fn a_close_up_holds_what_is_seen_and_has_little_room_around_it() {
    for scene in ["two-balls", "cyclist", "cube"].map(|name| Scene::preset(name).expect("a preset")) {
        for (beta, time) in [(0.0, 0.0), (0.5, -3.0), (0.8, 6.78), (0.99, 4.0)] {
            let settings = settings(beta, MapFrame::Ground);
            let WorldBox(extent) = close_up(&settings, &scene, time).expect("it is somewhere");
            // The outlines that the map draws, each bent as finely as it takes, not the samples that were
            // framed.
            let (lines, _) = lines(&settings, &scene, time);
            let seen = lines.all.iter().filter(|line| matches!(line.picture, BodyPicture::Seen(_)));
            let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
            for vertex in seen.flat_map(|line| lines.vertices(line)) {
                (low, high) = (low.min(vertex.place), high.max(vertex.place));
            }
            let size = (high - low).max_element();
            for axis in 0..3 {
                let [from, to] = extent[axis];
                assert!(
                    from < low[axis] && high[axis] < to,
                    "{} {beta}: {extent:?} {low} {high}",
                    scene.name
                );
                assert!(to - from < 4.6 * size, "{} {beta}: {extent:?} around {size}", scene.name);
            }
        }
    }
}

#[test]
fn a_close_up_is_finite_or_none_at_the_extremes() {
    let scene = cyclist();
    for gamma in [1.0, 1e3, 1e30] {
        let mut settings = settings(0.5, MapFrame::Ground);
        settings.motion.speed = SpeedSetting::new(SpeedParameter::Gamma, gamma).expect("a speed");
        for time in [-1e9, 0.0, 1e9] {
            for frame in [MapFrame::Ground, MapFrame::Bicycle] {
                settings.map.frame = frame;
                let extent = close_up(&settings, &scene, time);
                let sizes = extent.map(|WorldBox(axes)| axes.map(|[low, high]| high - low));
                assert!(sizes.is_none_or(|sizes| sizes.iter().all(|size| size.is_finite() && *size > 0.0)));
            }
        }
    }
}
