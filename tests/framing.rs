//! No default view crops what it is about: points all over the surfaces of what moves with the scene, each by its own
//! light cone, lie inside the picture.

use std::f64::consts::TAU;

use gamow::app::state::State;
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::scene::{PRESETS, Scene};
use gamow::settings::{Settings, Subject};
use glam::DVec3;
use relativity_core::{Aperture, Speed};
use relativity_render::{Camera, Gaze, Geometry, Motion, PreparedScene, View};

const BETAS: [f64; 6] = [0.0, 0.3, 0.6, 0.9, 0.99, 0.9999];
const SIZES: [[u32; 2]; 3] = [[480, 540], [960, 720], [300, 700]];
/// Times of the loop.
const TIMES: u32 = 40;
/// Part of the picture that stays free on each side at least.
const LEAST_MARGIN: f64 = 0.05;

/// The presets as the window opens them at this beta.
fn states(beta: f64) -> impl Iterator<Item = State> {
    PRESETS.into_iter().map(move |name| {
        let mut settings = Settings { scene: name.to_owned(), ..Settings::default() };
        settings.motion.speed = SpeedSetting::new(SpeedParameter::Beta, beta).expect("a speed");
        State::open(settings).expect("a preset")
    })
}

/// Moments of the range over which a state is played, evenly spread.
fn times(state: &State) -> impl Iterator<Item = f64> + use<> {
    let [from, to] = state.time_range();
    (0..TIMES).map(move |i| from + (to - from) * f64::from(i) / f64::from(TIMES - 1))
}

/// Points on the surfaces of the bodies that move with the scene, as cameras all around see them at rest.
fn surface(scene: &Scene) -> Vec<DVec3> {
    let moving = scene.groups.iter().filter(|group| group.motion == Motion::Scene);
    let bodies: Vec<_> = moving.flat_map(|group| &scene.bodies[group.bodies()]).copied().collect();
    let scene = PreparedScene::moving(&bodies);
    let extent = scene.groups()[0].extent;
    let directions = (0..8).map(|i| (TAU * f64::from(i) / 8.0, 0.0)).chain([(0.3, 1.5), (0.3, -1.5)]);
    let tilted = (0..4).flat_map(|i| [0.7, -0.7].map(|tilt| (TAU * f64::from(i) / 4.0, tilt)));
    let cameras = directions.chain(tilted).map(|(azimuth, elevation)| {
        let gaze = Gaze { azimuth, elevation };
        let place = extent.middle - gaze.axes().forward * (20.0 * extent.reach);
        let aperture = Aperture { x: place.x, y: place.y, z: place.z };
        Camera { aperture, gaze, horizontal_fov: 0.101, size: [90, 90] }
    });
    let hits = cameras.flat_map(|camera| {
        let (speed, geometry) = (Speed::REST, Geometry::Seen);
        scene.hit_image(&View { camera, speed, observation_time: 0.0, geometry }).hits
    });
    hits.flatten().map(|hit| hit.rest_position).collect()
}

/// Directions from an eye to what it is shown of `points`.
fn directions(view: &View, points: &[DVec3]) -> Vec<DVec3> {
    points.iter().filter_map(|&point| view.apparent_position(point)).collect()
}

/// The smallest part of the picture between an edge and a place where something is seen along `directions`; below 0
/// where it is cropped.
fn margin(camera: &Camera, directions: &[DVec3]) -> f64 {
    let [width, height] = camera.size.map(f64::from);
    let place = |&direction: &DVec3| {
        let Some([u, v]) = camera.pixel(direction) else { return f64::NEG_INFINITY };
        (u / width).min(1.0 - u / width).min(v / height).min(1.0 - v / height)
    };
    directions.iter().map(place).fold(f64::INFINITY, f64::min)
}

/// The smallest margin of both eyes' pictures of `size`.
fn least_margin(state: &State, points: &[DVec3], time: f64, size: [u32; 2]) -> f64 {
    let subject = Subject { scene: &state.session.prepared, tracked: state.session.scene.track(None) };
    let views = state.settings.views(subject, time, size);
    views.iter().map(|view| margin(&view.camera, &directions(view, points))).fold(f64::INFINITY, f64::min)
}

/// The smallest margin of all pictures of `state` in this `geometry`, over the loop and all sizes.
fn assert_whole(state: &State, geometry: Geometry) {
    let mut state = state.clone();
    state.settings.look.geometry = geometry;
    let points = surface(&state.session.scene);
    assert!(points.len() > 1000, "{}: {} points", state.settings.scene, points.len());
    for time in times(&state) {
        for size in SIZES {
            let least = least_margin(&state, &points, time, size);
            let beta = state.speed().beta();
            let scene = &state.settings.scene;
            assert!(least > LEAST_MARGIN, "{scene}, {geometry:?}, beta {beta}, T {time}, {size:?}: {least}");
        }
    }
}

#[test]
fn no_default_view_crops_what_moves() {
    for beta in BETAS {
        states(beta).for_each(|state| assert_whole(&state, Geometry::Seen));
    }
}

#[test]
fn no_other_geometry_crops_it_either() {
    for beta in [0.3, 0.9, 0.99] {
        for state in states(beta) {
            for geometry in [Geometry::Contracted, Geometry::Rest, Geometry::Published] {
                assert_whole(&state, geometry);
            }
        }
    }
}
