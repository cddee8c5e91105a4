//! A rolling wheel, corrected to the frame of its hub, against a camera that rides along: there it turns.

use std::f64::consts::TAU;

use glam::DVec3;
use relativity_core::{Aperture, Speed, Turning};
use relativity_render::picture::rectified_hits::Blank;
use relativity_render::picture::rectify::Rectification;
use relativity_render::{
    Appearance, Body, Camera, Gaze, Geometry, Motion, Pattern, PreparedScene, Shading, Shape, Spin, Velocity,
    View,
};

const HUB: DVec3 = DVec3::new(0.0, 3.0, 0.5);
const RADIUS: f64 = 0.6;
const BLANK: Blank = Blank { background: [0.0; 3], outside: [0.5; 3] };

/// A chequered tyre and spokes.
fn wheel() -> PreparedScene {
    let spin = Spin { hub: HUB.to_array(), radius: RADIUS, turning: Turning::Rolling };
    let axis = [0.0, 1.0, 0.0];
    let tyre = Shape::Ring { centre: HUB.to_array(), axis, radius: 0.5, tube_radius: 0.1 };
    let spoke = |i: i32| {
        let (sine, cosine) = (TAU * f64::from(i) / 10.0).sin_cos();
        let to = HUB + 0.45 * DVec3::new(cosine, 0.0, sine);
        Body::new(Shape::Tube { from: HUB.to_array(), to: to.to_array(), radius: 0.02 }, 560.0)
    };
    let tyre = Body { pattern: Pattern::Chequer { step: 0.1 }, ..Body::new(tyre, 600.0) };
    let bodies: Vec<_> =
        [tyre].into_iter().chain((0..10).map(spoke)).map(|body| body.turning(spin)).collect();
    PreparedScene::moving(&bodies)
}

/// On the ground and riding along, at one event, and what leads from the one picture to the other.
fn both(beta: f64, observation_time: f64) -> ([View; 2], Rectification) {
    let camera = Camera::new(Aperture::default(), Gaze::STRAIGHT_AHEAD, 1.0, [240, 180]);
    let speed = Speed::from_beta(beta).expect("below 1");
    let mut view = View { camera, speed, observation_time, geometry: Geometry::Seen };
    let middle = view.apparent_position(HUB).expect("inside the domain");
    view.camera.gaze = Gaze::along(middle.to_array());
    view.camera.horizontal_fov =
        1.5 * view.of_group(Motion::Scene).rest_ray(middle.normalize()).ground_per_rest / middle.length();
    let velocity = Velocity::forward(speed);
    let rest = Rectification::rest_camera(&view.camera, &velocity);
    let riding = View { camera: rest, geometry: Geometry::Rest, ..view };
    ([view, riding], Rectification::new(view.camera, rest, velocity))
}

const CASES: [(f64, f64); 4] = [(0.3, 1.0), (0.6, 3.0), (0.9, 3.4), (0.99, 4.0)];

#[test]
fn corrected_rays_meet_the_point_that_the_camera_that_rides_along_sees() {
    let scene = wheel();
    for (beta, time) in CASES {
        let ([view, riding], rectification) = both(beta, time);
        let mut count = 0;
        for (number, expected) in (0..).zip(scene.hit_image(&riding).hits) {
            let place = [f64::from(number % 240) + 0.5, f64::from(number / 240) + 0.5];
            let Some(ground) = rectification.ground_place(place) else { continue };
            let hit = scene.first_hit(&view, view.camera.line_of_sight(ground));
            let (Some(hit), Some(expected)) = (hit, expected) else {
                assert_eq!(hit.is_some(), expected.is_some());
                continue;
            };
            assert_eq!(hit.body, expected.body);
            assert!(hit.material_position.distance(expected.material_position) < 1e-9);
            assert!((hit.proper_time - expected.proper_time).abs() < 1e-9);
            let left = hit.doppler_factor / rectification.doppler_factor(ground);
            assert!((left / expected.doppler_factor - 1.0).abs() < 1e-9);
            count += 1;
        }
        assert!(count > 3000, "{count} pixels at beta = {beta}");
    }
}

#[test]
fn a_corrected_picture_of_hits_is_that_of_the_camera_that_rides_along() {
    let scene = wheel();
    let appearance = Appearance {
        shading: Shading::Emission,
        intensity_exponent: Some(1.0),
        sky: false,
        light: false,
        ..Appearance::default()
    };
    for &(beta, time) in &CASES[1..3] {
        let ([view, riding], rectification) = both(beta, time);
        let corrected = rectification.picture_of_hits(&scene.hit_image(&view), &scene, &appearance, BLANK);
        let hits = scene.hit_image(&riding).hits;
        let near =
            |i: usize| (0..3).flat_map(move |row| (0..3).map(move |column| i + row * 240 + column - 241));
        // What is behind is not corrected here.
        let is_inside = |i: &usize| {
            let [u, v] = [(i % 240) as f64, (i / 240) as f64];
            let corners = [[u, v], [u + 1.0, v], [u, v + 1.0], [u + 1.0, v + 1.0]];
            (1..239).contains(&(i % 240))
                && corners.iter().all(|&place| rectification.ground_place(place).is_some())
                && near(*i).all(|j| hits[j].is_some())
        };
        let inside: Vec<_> = (240..240 * 179).filter(is_inside).collect();
        assert!(inside.len() > 5000, "{} pixels", inside.len());
        // A pixel from the ground is as large as up to two here: each is as some pixel beside it.
        let differing = |riding: &View| {
            let expected = scene.picture(riding, &appearance, 2);
            let differs = |i: usize| {
                (0..3).any(|part| {
                    let values = || near(i).map(|j| expected.rgba[j][part]);
                    let (least, most) = (values().min().unwrap_or(0), values().max().unwrap_or(255));
                    let value = corrected.rgba[i][part];
                    value < least.saturating_sub(8) || value > most.saturating_add(8)
                })
            };
            inside.iter().filter(|&&i| differs(i)).count()
        };
        let wrong = differing(&riding);
        assert!(wrong * 100 < inside.len(), "{wrong} of {} at beta = {beta}", inside.len());
        // Once it has turned a little it is another picture.
        let later = View { observation_time: time + 0.15, ..riding };
        assert!(differing(&later) * 20 > inside.len());
    }
}
