//! No default view crops what it is about: points all over the surfaces of what moves with the scene, each by
//! its own light cone, lie inside the picture.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::LazyLock;

use gamow::app::state::State;
use gamow::flags::choices::ProjectionChoice;
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::scene::{PRESETS, Scene};
use gamow::settings::{Settings, Subject};
use glam::DVec3;
use relativity_core::{Aperture, Speed};
use relativity_render::{Camera, Gaze, Geometry, Hit, MaterialPoint, Motion, PreparedScene, View};

use crate::support::sweep;

const BETAS: [f64; 6] = [0.0, 0.3, 0.6, 0.9, 0.99, 0.9999];
const SIZES: [[u32; 2]; 3] = [[480, 540], [960, 720], [300, 700]];
/// Times of the loop.
const TIMES: u32 = 40;
/// Part of the picture that stays free on each side at least.
const LEAST_MARGIN: f64 = 0.05;
/// Points of each scene at least.
const LEAST_POINTS: usize = 200;

/// The presets in which something passes, as the window opens them at this beta.
fn states(beta: f64) -> impl Iterator<Item = State> {
    let all = PRESETS.into_iter().map(move |name| {
        let mut settings = Settings { scene: name.to_owned(), ..Settings::default() };
        settings.motion.speed = SpeedSetting::new(SpeedParameter::Beta, beta).expect("a speed");
        State::open(settings).expect("a preset")
    });
    all.filter(|state| state.document.scene.groups.iter().any(|group| group.motion == Motion::Scene))
}

/// Moments of the range over which a state is played, evenly spread.
fn times(state: &State) -> impl Iterator<Item = f64> + use<> {
    let [from, to] = state.time_range();
    (0..TIMES).map(move |i| from + (to - from) * f64::from(i) / f64::from(TIMES - 1))
}

/// The points of each preset in which something passes.
static SURFACES: LazyLock<BTreeMap<String, Vec<MaterialPoint>>> = LazyLock::new(|| {
    states(0.0).map(|state| (state.document.settings.scene.clone(), surface(&state.document.scene))).collect()
});

/// Points on the surfaces of the bodies that move with the scene, as cameras all around see them at rest.
fn surface(scene: &Scene) -> Vec<MaterialPoint> {
    let moving = scene.groups.iter().filter(|group| group.motion == Motion::Scene);
    let bodies: Vec<_> = moving.flat_map(|group| &scene.bodies[group.bodies()]).cloned().collect();
    let scene = PreparedScene::moving(&bodies);
    let extent = scene.groups()[0].extent;
    let directions = (0..8).map(|i| (TAU * f64::from(i) / 8.0, 0.0)).chain([(0.3, 1.5), (0.3, -1.5)]);
    let tilted = (0..4).flat_map(|i| [0.7, -0.7].map(|tilt| (TAU * f64::from(i) / 4.0, tilt)));
    let gazes: Vec<_> = directions.chain(tilted).collect();
    let points = |side: u32| -> Vec<MaterialPoint> {
        let cameras = gazes.iter().map(|&(azimuth, elevation)| {
            let gaze = Gaze { azimuth, elevation };
            let place = extent.middle - gaze.axes().forward * (20.0 * extent.reach);
            let aperture = Aperture { x: place.x, y: place.y, z: place.z };
            Camera::new(aperture, gaze, 0.101, [side, side])
        });
        let hits = cameras.flat_map(|camera| {
            let (speed, geometry) = (Speed::REST, Geometry::Seen);
            scene.hit_image(&View { camera, speed, observation_time: 0.0, geometry }).hits
        });
        let point = |hit: Hit| MaterialPoint { rest: hit.material_position, spin: bodies[hit.body].spin };
        hits.flatten().map(point).collect()
    };
    // A thin rod is seldom hit in a coarse picture.
    let coarse = points(40);
    if coarse.len() > LEAST_POINTS { coarse } else { points(160) }
}

/// Directions from an eye to what it is shown of `points`.
fn directions(view: &View, points: &[MaterialPoint]) -> Vec<DVec3> {
    points.iter().filter_map(|&point| view.apparent_position(point)).collect()
}

/// The smallest part of the picture between an edge and a place where something is seen along `directions`;
/// below 0 where it is cropped.
fn margin(camera: &Camera, directions: &[DVec3]) -> f64 {
    let [width, height] = camera.size.map(f64::from);
    let place = |&direction: &DVec3| {
        let Some([u, v]) = camera.pixel(direction) else { return f64::NEG_INFINITY };
        (u / width).min(1.0 - u / width).min(v / height).min(1.0 - v / height)
    };
    directions.iter().map(place).fold(f64::INFINITY, f64::min)
}

/// What both eyes are shown at `time`.
fn views(state: &State, time: f64, size: [u32; 2]) -> [View; 2] {
    let subject = Subject { scene: &state.document.prepared, tracked: state.document.scene.track(None) };
    state.document.settings.views(subject, time, size)
}

/// Checks that no picture of `state` in this `geometry`, over the loop and all sizes, crops what moves: at
/// one of each `share` times, drawn from `seed` on.
fn assert_whole(state: &State, geometry: Geometry, (seed, share): (u32, usize)) {
    let mut state = state.clone();
    state.document.settings.look.geometry = geometry;
    let points = &SURFACES[&state.document.settings.scene];
    assert!(points.len() > LEAST_POINTS, "{}: {} points", state.document.settings.scene, points.len());
    for time in sweep(seed, share, times(&state)) {
        let seen = views(&state, time, SIZES[0]).map(|view| directions(&view, points));
        for size in SIZES {
            let cameras = views(&state, time, size).map(|view| view.camera);
            let least = margin(&cameras[0], &seen[0]).min(margin(&cameras[1], &seen[1]));
            let beta = state.speed().beta();
            let scene = &state.document.settings.scene;
            assert!(least > LEAST_MARGIN, "{scene}, {geometry:?}, beta {beta}, T {time}, {size:?}: {least}");
        }
    }
}

#[test]
fn no_default_view_crops_what_moves() {
    for (seed, state) in (0..).zip(BETAS.into_iter().flat_map(states)) {
        assert_whole(&state, Geometry::Seen, (seed, 3));
    }
}

#[test]
fn no_other_geometry_crops_it_either() {
    let geometries = [Geometry::Contracted, Geometry::Rest, Geometry::Published, Geometry::OneCone];
    let states = [0.3, 0.9, 0.9999].into_iter().flat_map(states);
    let cases = states.flat_map(|state| geometries.map(|geometry| (state.clone(), geometry)));
    for (seed, (state, geometry)) in (0..).zip(cases) {
        assert_whole(&state, geometry, (seed, 6));
    }
}

/// Returns where an eye at (`eye`, 0, 0) sees a place of a group that moves at `beta` along x, by the light
/// cone's quadratic equation.
fn seen([x, y, z]: [f64; 3], beta: f64, eye: f64, time: f64) -> DVec3 {
    let rest = 1.0 - beta * beta;
    let present = x * rest.sqrt() - eye + beta * time;
    let distance = ((beta * present).powi(2) + rest * (present * present + y * y + z * z)).sqrt();
    DVec3::new(present - beta * (distance - beta * present) / rest, y, z)
}

#[test]
fn what_comes_the_other_way_is_in_the_whole_too() {
    let mut settings = Settings { scene: "tests/groups.toml".to_owned(), ..Settings::default() };
    settings.motion.speed = SpeedSetting::new(SpeedParameter::Beta, 0.5).expect("a speed");
    let state = State::open(settings).expect("a scene");
    let balls = [([0.0, 3.0, 1.0], 0.5, 0.5), ([1.5, 5.0, 1.5], 0.8, -0.6)];
    for time in [-2.0, 0.0, 3.0, 8.0] {
        for (view, eye) in views(&state, time, SIZES[1]).iter().zip([-0.5, 0.5]) {
            let eye = eye * state.document.settings.motion.d;
            for (centre, radius, beta) in balls {
                let ends = [DVec3::X, -DVec3::X, DVec3::Z, -DVec3::Z, -DVec3::Y].map(|towards| {
                    seen((DVec3::from(centre) + radius * towards).to_array(), beta, eye, time)
                });
                let least = margin(&view.camera, &ends);
                assert!(least > LEAST_MARGIN, "T {time}, beta {beta}: {least}");
            }
        }
    }
}

/// Eyes a whole unit apart. What narrower pictures would show as well is framed with what is around it.
#[test]
fn one_light_cone_is_framed_closely_where_eyes_are_far_apart() {
    let mut framed = 0;
    for beta in [0.3, 0.9, 0.99] {
        let mut state = states(beta).next().expect("there are scenes");
        state.document.settings.motion.d = 1.0;
        assert_whole(&state, Geometry::OneCone, (0, 1));
        // On a plane along the line between the eyes what lies apart in depth is far apart.
        state.document.settings.look.projection = ProjectionChoice::Gaze;
        assert_whole(&state, Geometry::OneCone, (0, 1));
        state.document.settings.look.geometry = Geometry::OneCone;
        let points = &SURFACES[&state.document.settings.scene];
        for time in times(&state) {
            let views = views(&state, time, SIZES[0]);
            let margins = views.iter().map(|view| margin(&view.camera, &directions(view, points)));
            let least = margins.fold(f64::INFINITY, f64::min);
            if views[0].camera.horizontal_fov.to_degrees() > 42.5 {
                assert!(least < 0.13, "beta {beta}, T {time}: {least} of the picture is free on every side");
                framed += 1;
            }
        }
    }
    assert!(framed > 10, "{framed} pictures");
}

/// The angle by which the gaze turns, and that by which the field of view changes, from `a` to `b`, degrees.
fn change([a, b]: [&View; 2]) -> [f64; 2] {
    let axis = |view: &View| view.camera.gaze.axes().forward;
    let fov = |view: &View| view.camera.horizontal_fov;
    [axis(a).angle_between(axis(b)), (fov(b) - fov(a)).abs()].map(f64::to_degrees)
}

/// The left eye's views at the ends of `count` equal steps through the loop.
fn shown(state: &State, count: u32) -> Vec<View> {
    let [from, to] = state.time_range();
    let time = |i: u32| from + (to - from) * f64::from(i) / f64::from(count);
    (0..=count).map(|i| views(state, time(i), SIZES[1])[0]).collect()
}

/// The greatest changes from each of these views to the one `step` later.
fn greatest_changes(shown: &[View], step: usize) -> [f64; 2] {
    let steps: Vec<&View> = shown.iter().step_by(step).collect();
    let changes = steps.windows(2).map(|pair| change([pair[0], pair[1]]));
    changes.fold([0.0, 0.0], |[turn, zoom], [a, b]| [turn.max(a), zoom.max(b)])
}

#[test]
fn gaze_and_field_run_smoothly_while_time_does() {
    let cases = [0.3, 0.9, 0.9999].into_iter().flat_map(|beta| states(beta).map(move |state| (beta, state)));
    for (beta, state) in sweep(0, 4, cases) {
        // What passes within a few steps is looked at in finer ones. A jump stays as large in any.
        let views = shown(&state, 4000);
        let [coarse, fine] = [4, 1].map(|step| greatest_changes(&views, step));
        if !is_about_a_quarter(coarse, fine) {
            let finest = greatest_changes(&shown(&state, 16000), 1);
            let scene = &state.document.settings.scene;
            assert!(is_about_a_quarter(fine, finest), "{scene} at {beta}: {fine:?} to {finest:?} degrees");
        }
    }
}

/// Whether changes in steps a quarter as long are about a quarter of those in long ones, degrees.
fn is_about_a_quarter(long: [f64; 2], short: [f64; 2]) -> bool {
    long.into_iter().zip(short).all(|(long, short)| short < 0.5 * long + 0.02)
}

#[test]
fn while_the_start_is_played_no_frame_turns_by_more_than_four_degrees() {
    let state = State::open(Settings::default()).expect("the start");
    let [from, to] = state.time_range();
    let frames = 60.0 * (to - from) / state.document.settings.playback.rate;
    let [turn, zoom] = greatest_changes(&shown(&state, frames as u32), 1);
    assert!(turn < 4.0 && zoom < 4.0, "{turn}, {zoom} degrees a frame");
}
