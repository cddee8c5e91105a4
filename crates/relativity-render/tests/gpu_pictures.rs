//! Pictures of both GPU renderers against the reference's, effect by effect.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use relativity_core::{Aperture, ObserverVelocity, Speed, Turning};
use relativity_render::{
    Appearance, Body, Camera, Colour, Emission, Gaze, Geometry, Group, HitImage, Method, Motion, Pattern,
    Picture, PreparedScene, Renderers, Shading, Shape, Spin, StreetColours, Velocity, View,
};

use crate::gpu_support::Test;
use crate::gpu_support::scenes::{
    conformal_views, parallel_views, still_life, swarms, time_seen_at, view_following,
};
use crate::support::{documented, sweep};

pub const TESTS: &[Test] = &[
    ("pictures_are_the_references", pictures_are_the_references),
    ("patterns_are_the_references", patterns_are_the_references),
    ("the_hatch_is_the_references", the_hatch_is_the_references),
    ("contact_shadows_are_the_references", contact_shadows_are_the_references),
    ("rides_are_the_references", rides_are_the_references),
    ("hoops_are_seen_from_within", hoops_are_seen_from_within),
    ("edges_are_the_references_on_average", edges_are_the_references_on_average),
    ("small_bodies_are_seen_behind_thin_ones", small_bodies_are_seen_behind_thin_ones),
    ("long_bodies_narrow_into_the_distance", long_bodies_narrow_into_the_distance),
    ("every_speed_gives_a_picture", every_speed_gives_a_picture),
];

const FOLLOWED: [f64; 3] = [-0.4, 3.0, 0.7];

fn view(speed: Speed) -> View {
    view_following(FOLLOWED, speed, time_seen_at(FOLLOWED, &speed, 0.3), 45.0)
}

fn fast_speed() -> Speed {
    Speed::from_beta(0.9).expect("below 1")
}

fn fast() -> View {
    view(fast_speed())
}

fn appearances() -> Vec<Appearance> {
    let plain = Appearance {
        doppler_shift: false,
        intensity_exponent: None,
        shading: Shading::Emission,
        sky: false,
        ..Appearance::default()
    };
    vec![
        plain,
        Appearance { shading: Shading::Form, ground_z: Some(-0.5), ..plain },
        Appearance { ground_z: Some(0.5), sky: true, light: true, ..plain },
        Appearance { ground_z: Some(-0.5), road: Some([1.0, 3.5]), fronts: Some(6.0), ..plain },
        Appearance { ground_z: Some(-2.5), road: Some([-0.2, 7.0]), light: true, ..plain },
        Appearance { doppler_shift: true, exposure_ev: -1.0, ..plain },
        Appearance { doppler_shift: true, colour: Colour::False, ..plain },
        Appearance { doppler_shift: true, colour: Colour::Glowing, exposure_ev: 5.0, ..plain },
        Appearance { doppler_shift: true, colour: Colour::White, exposure_ev: 2.0, ..plain },
        Appearance { doppler_shift: true, colour: Colour::StreetDaylight, exposure_ev: 1.0, ..plain },
        Appearance { doppler_shift: true, invisible: false, ..plain },
        Appearance { intensity_exponent: Some(2.0), exposure_ev: 1.0, ..plain },
        Appearance { intensity_exponent: Some(3.0), ..plain },
        Appearance { intensity_exponent: Some(4.0), ..plain },
        Appearance { intensity_exponent: Some(2.5), ..Appearance::default() },
    ]
}

const RENDERERS: &str = include_str!("../src/renderers.rs");

fn pictures_are_the_references(renderers: &mut Renderers) {
    let mut bodies = still_life();
    bodies[1].brightness = 0.4;
    bodies[3].emission = Emission::WHITE;
    let reference = PreparedScene::moving(&bodies);
    agree_with_the_reference(renderers, &reference, &appearances(), (0, 8));
}

/// Every pattern, coarse and finer than pixels.
fn patterns_are_the_references(renderers: &mut Renderers) {
    let emission = Appearance { shading: Shading::Emission, sky: false, ..Appearance::default() };
    let appearances = [emission, Appearance { intensity_exponent: None, doppler_shift: false, ..emission }];
    for (seed, pattern) in (0..).step_by(100).zip(PATTERNS) {
        let marked = patterned_life().into_iter().map(|body| Body { pattern, ..body });
        let scene = PreparedScene::moving(&marked.collect::<Vec<_>>());
        agree_with_the_reference(renderers, &scene, &appearances, (seed, 2));
    }
}

/// Bodies that shine in ultraviolet and infrared of their own, so that the hatch is there with and without a
/// Doppler effect.
fn the_hatch_is_the_references(renderers: &mut Renderers) {
    let bodies = patterned_life().into_iter().zip([300.0, 900.0, 760.0, 5000.0, 100.0]);
    let lit: Vec<_> = bodies.map(|(body, nm)| Body { emission: Emission::Wavelength(nm), ..body }).collect();
    let scene = PreparedScene::moving(&lit);
    let rest = Appearance { intensity_exponent: None, doppler_shift: false, ..Appearance::default() };
    agree_with_the_reference(
        renderers,
        &scene,
        &[rest, Appearance::default(), Appearance { light: true, ..rest }],
        (0, 1),
    );
}

/// A wheel, a ball and a box that touch a road: how the road looks beside them.
fn contact_shadows_are_the_references(renderers: &mut Renderers) {
    let levels = documented(RENDERERS, "away from outlines colours are within ");
    let shapes = [
        Shape::Ring { centre: [-1.0, 3.2, -0.2], axis: [0.0, 1.0, 0.0], radius: 0.28, tube_radius: 0.02 },
        Shape::Sphere { centre: [-0.4, 3.6, -0.3], radius: 0.2 },
        Shape::Box { centre: [0.2, 2.9, -0.4], half: [0.2, 0.1, 0.1], turn: [0.0, 0.0, 0.0, 1.0] },
    ];
    let scene = PreparedScene::moving(&shapes.map(|shape| Body::new(shape, 600.0)));
    let road = Appearance {
        ground_z: Some(-0.5),
        road: Some([1.0, 9.0]),
        light: true,
        sky: false,
        ..Appearance::default()
    };
    let geometries = [Geometry::Seen, Geometry::OneCone, Geometry::Contracted, Geometry::Rest];
    let (speed, on_road) = (fast_speed(), [-0.4, 3.2, -0.5]);
    let flat = view_following(on_road, speed, time_seen_at(on_road, &speed, 0.3), 45.0);
    let conformal = conformal_views([speed], on_road).take(1);
    let flat = geometries.map(|geometry| {
        let mut view = View { geometry, ..flat };
        view.camera.gaze = Gaze::along(view.apparent_position(on_road).expect("in the domain").to_array());
        view
    });
    for view in flat.into_iter().chain(conformal) {
        let hits = scene.hit_image(&view);
        let truth = scene.picture(&view, &road, 1).rgba;
        let bare = PreparedScene::new([]).picture(&view, &road, 1).rgba;
        let dark = levels_off(&bare, &truth, |i| is_free(&hits, i));
        assert!(dark > 10, "{:?}: shadows are {dark} levels dark", view.geometry);
        for method in [Method::Rays, Method::Packets, Method::Mesh] {
            let method = method.of_view(&view);
            let drawn = renderers.picture(method, &scene, &view, &road, 1).expect("device works").rgba;
            let off = levels_off(&drawn, &truth, |i| is_free(&hits, i));
            assert!(f64::from(off) <= levels, "{method}, {:?}: {off} levels off", view.geometry);
        }
    }
}

const PATTERNS: [Pattern; 7] = [
    Pattern::Faces,
    Pattern::Graticule { step_degrees: 30.0 },
    Pattern::Graticule { step_degrees: 5.0 },
    Pattern::Chequer { step: 0.1 },
    Pattern::Chequer { step: 0.01 },
    Pattern::Stripes { step: 0.1 },
    Pattern::Stripes { step: 0.004 },
];

/// Bodies of every shape, large enough to show a pattern.
fn patterned_life() -> Vec<Body> {
    let shapes = [
        Shape::Sphere { centre: [-0.1, 3.1, 0.9], radius: 0.35 },
        Shape::Tube { from: [-1.2, 3.0, 0.2], to: [0.3, 3.3, 0.3], radius: 0.12 },
        Shape::Ring { centre: [-0.9, 3.2, 0.9], axis: [0.36, 0.48, 0.8], radius: 0.3, tube_radius: 0.1 },
        Shape::Box { centre: [0.1, 2.9, 0.1], half: [0.2, 0.25, 0.15], turn: [0.2, 0.4, 0.4, 0.8] },
        Shape::Cylinder { from: [-1.0, 2.9, 0.5], to: [-0.6, 3.0, 0.5], radius: 0.2 },
    ];
    shapes.into_iter().map(|shape| Body::new(shape, 600.0)).collect()
}

/// Whether both renderers' pictures of the scene are the reference's, as far as is promised: in each view by
/// one of each `share` of the appearances, drawn from `first_seed` on.
fn agree_with_the_reference(
    renderers: &mut Renderers,
    reference: &PreparedScene,
    appearances: &[Appearance],
    (first_seed, share): (u32, usize),
) {
    let rays_levels = documented(RENDERERS, "away from outlines colours are within ");
    let mesh_levels = documented(RENDERERS, "colours away from outlines are within ");
    let geometries = [Geometry::Seen, Geometry::OneCone, Geometry::Contracted, Geometry::Rest];
    let parallel = parallel_views([fast_speed()], FOLLOWED).skip(3);
    let oblique = parallel
        .chain(conformal_views([fast_speed()], FOLLOWED))
        .flat_map(|view| [Geometry::Seen, Geometry::OneCone].map(|geometry| (geometry, view)));
    let views = geometries.map(|geometry| (geometry, fast())).into_iter().chain(oblique);
    for (seed, (geometry, view)) in (first_seed..).zip(views) {
        let mut view = View { geometry, ..view }.with_size([160, 120]);
        if geometry == Geometry::OneCone {
            (view.camera.aperture.x, view.camera.off_middle.x) = (0.3, 0.3);
        }
        let hits = reference.hit_image(&view);
        for appearance in sweep(seed, share, appearances) {
            let truth = reference.picture(&view, appearance, 1).rgba;
            // A mesh's normals are interpolated between corners.
            let methods =
                [(Method::Rays, rays_levels), (Method::Packets, rays_levels), (Method::Mesh, mesh_levels)];
            for (method, levels) in methods.into_iter().filter(|(method, _)| method.of_view(&view) == *method)
            {
                let drawn = renderers.picture(method, reference, &view, appearance, 1).expect("device works");
                let off = levels_off(&drawn.rgba, &truth, |i| is_inside(&hits, i));
                assert!(f64::from(off) <= levels, "{method}, {geometry:?}, {appearance:?}: {off} levels off");
            }
        }
    }
}

/// Greatest difference of any component where `counts`.
fn levels_off(drawn: &[[u8; 4]], truth: &[[u8; 4]], counts: impl Fn(usize) -> bool) -> i32 {
    let pixels = drawn.iter().zip(truth).enumerate().filter(|(i, _)| counts(*i));
    let difference = |(a, b): (&u8, &u8)| (i32::from(*a) - i32::from(*b)).abs();
    pixels.flat_map(|(_, (drawn, truth))| drawn.iter().zip(truth).map(difference)).max().unwrap_or(0)
}

/// Whether neither a pixel nor any around it shows a body.
fn is_free(hits: &HitImage, i: usize) -> bool {
    let [width, height] = hits.size.map(|v| v as usize);
    if !(1..width - 1).contains(&(i % width)) || !(1..height - 1).contains(&(i / width)) {
        // What is beside the picture may reach into its edge.
        return false;
    }
    let around = |at: usize, end: usize| at.saturating_sub(1)..(at + 2).min(end);
    around(i / width, height).all(|v| around(i % width, width).all(|u| hits.hits[v * width + u].is_none()))
}

/// Whether a pixel and all around it show one body, the same side of it.
fn is_inside(hits: &HitImage, i: usize) -> bool {
    let [width, height] = hits.size.map(|v| v as usize);
    let (u, v) = (i % width, i / width);
    if !(1..width - 1).contains(&u) || !(1..height - 1).contains(&v) {
        return false;
    }
    let Some(here) = hits.hits[i] else { return false };
    [i - width - 1, i - width, i - width + 1, i - 1, i + 1, i + width - 1, i + width, i + width + 1]
        .into_iter()
        .all(|j| {
            hits.hits[j].is_some_and(|there| {
                there.body == here.body && there.rest_normal.distance(here.rest_normal) < 0.5
            })
        })
}

/// Sixteen rays per pixel against four samples, and thin bodies: their light agrees within this share.
const LIGHT_SHARE: f64 = 0.01;

fn edges_are_the_references_on_average(renderers: &mut Renderers) {
    let appearance = Appearance { intensity_exponent: None, sky: false, ..Appearance::default() };
    for bodies in [still_life(), swarms(100)] {
        let scene = PreparedScene::moving(&bodies);
        let [expected, rays, packets] = [Method::Reference, Method::Rays, Method::Packets].map(|method| {
            light(&renderers.picture(method, &scene, &fast(), &appearance, 4).expect("device works"))
        });
        for found in [rays, packets] {
            assert!((found / expected - 1.0).abs() < LIGHT_SHARE, "{found} for {expected}");
        }
    }
}

/// Threads thinner than a pixel, each before a small ball, and drawn before it if both are drawn together:
/// what the threads leave free shows the balls.
fn small_bodies_are_seen_behind_thin_ones(renderers: &mut Renderers) {
    let place = |i: u32| DVec3::new(0.04 * f64::from(i % 50) - 1.0, 4.0, 0.04 * f64::from(i / 50) - 0.6);
    let ball = |i| Body::white(Shape::Sphere { centre: place(i).to_array(), radius: 0.018 });
    let thread = |i: u32| {
        let [from, to] = [-0.008, 0.008].map(|x| (0.7 * place(i) + DVec3::new(x, 0.0, 0.0)).to_array());
        Body::white(Shape::Tube { from, to, radius: 0.001 })
    };
    let bodies: Vec<_> = (0..1500).map(thread).chain((0..1500).map(ball)).collect();
    let scene = PreparedScene::moving(&bodies);
    let look = Appearance { shading: Shading::Emission, sky: false, ..Appearance::default() };
    let camera = Camera::new(Aperture::default(), Gaze::along([0.0, 1.0, 0.0]), 0.4, [160, 96]);
    let view = View { camera, speed: Speed::REST, observation_time: 0.0, geometry: Geometry::Seen };
    let mut squares = |method, rays| {
        light_in_squares(&renderers.picture(method, &scene, &view, &look, rays).expect("device works"))
    };
    let truth = squares(Method::Packets, 1);
    let drawn = squares(Method::Rays, 1);
    let off = most_off(&drawn, &truth);
    assert!(off < LIGHT_OFF, "{off} pixels' light is off");
}

/// Side of the squares in which light is summed, px; and the most light by which they may differ, in pixels
/// that are lit in full: of long bodies, which four samples a pixel meet as chance has it.
const SQUARE: usize = 8;
const LIGHT_OFF: f64 = 1.0;

/// Bodies several pixels wide at one end, and thinner than a pixel at the other: a rail, a plank, and hoops
/// seen from within.
fn long_bodies_narrow_into_the_distance(renderers: &mut Renderers) {
    let shapes = [
        Shape::Tube { from: [-1.0, 1.5, -1.0], to: [-1.0, 20.0, -1.0], radius: 0.05 },
        Shape::Cylinder { from: [1.0, 1.5, -1.0], to: [1.0, 20.0, -1.0], radius: 0.05 },
        Shape::Box { centre: [0.0, 11.0, -0.9], half: [0.04, 9.0, 0.05], turn: [0.0, 0.0, 0.0, 1.0] },
        Shape::Ring { centre: [0.0, 21.0, 1.5], axis: [0.0, 0.0, 1.0], radius: 19.0, tube_radius: 0.05 },
    ];
    let bodies = shapes.map(|shape| Body::new(shape, 600.0));
    let scene = PreparedScene::new([Group { motion: Motion::Own(Velocity::REST), bodies: &bodies }]);
    let look = Appearance {
        intensity_exponent: None,
        doppler_shift: false,
        shading: Shading::Emission,
        sky: false,
        ..Appearance::default()
    };
    for beta in [0.0, 0.6, -0.6] {
        let camera = Camera::new(Aperture::default(), Gaze::along([0.0, 1.0, 0.0]), 1.6, [160, 120]);
        let camera = Camera { velocity: Velocity::from_beta(beta).expect("a speed").into(), ..camera };
        let view = View { camera, speed: Speed::REST, observation_time: 0.0, geometry: Geometry::Seen };
        let mut squares = |method, rays| {
            light_in_squares(&renderers.picture(method, &scene, &view, &look, rays).expect("device works"))
        };
        let truth = squares(Method::Reference, 4);
        for method in [Method::Rays, Method::Packets, Method::Mesh] {
            let drawn = squares(method, 1);
            let off = most_off(&drawn, &truth);
            assert!(off <= LIGHT_OFF, "{method} at {beta}: {off} pixels' light off in a square");
        }
    }
}

/// Sums of linear light in squares, in pixels of the brightest.
fn light_in_squares(picture: &Picture) -> Vec<f64> {
    let [width, height] = picture.size.map(|v| v as usize);
    let whole = picture.rgba.iter().copied().map(light_of).fold(0.0, f64::max);
    let mut squares = vec![0.0; (width / SQUARE) * (height / SQUARE)];
    for v in 0..height {
        for u in 0..width {
            squares[v / SQUARE * (width / SQUARE) + u / SQUARE] +=
                light_of(picture.rgba[v * width + u]) / whole;
        }
    }
    squares
}

/// The greatest difference of light in one square.
fn most_off(drawn: &[f64], truth: &[f64]) -> f64 {
    drawn.iter().zip(truth).map(|(drawn, truth)| (drawn - truth).abs()).fold(0.0, f64::max)
}

/// Sum of linear light.
fn light(picture: &Picture) -> f64 {
    picture.rgba.iter().copied().map(light_of).sum()
}

/// The linear light of a pixel.
fn light_of(pixel: [u8; 4]) -> f64 {
    pixel[..3].iter().map(|level| (f64::from(*level) / 255.0).powf(2.2)).sum()
}

fn every_speed_gives_a_picture(renderers: &mut Renderers) {
    let scene = PreparedScene::moving(&still_life());
    let speeds = [1.0, 1e3, 1e6, 1e12, 1e30].map(|gamma| Speed::from_gamma(gamma).expect("in range"));
    for speed in speeds {
        let gamma = speed.gamma();
        let conformal = conformal_views([speed], FOLLOWED);
        let flat = [-10.0, 0.0, 5.0].map(|observation_time| View { observation_time, ..view(speed) });
        for view in flat.into_iter().chain(conformal) {
            for method in [Method::Rays, Method::Packets, Method::Mesh] {
                let image = renderers.hits(method, &scene, &view).expect("device works");
                for hit in image.hits.into_iter().flatten() {
                    assert!(
                        hit.distance.is_finite() && hit.rest_position.is_finite(),
                        "gamma {gamma}: {hit:?}"
                    );
                }
            }
        }
    }
}

/// Levels by which house fronts in f32 may be off, as they are for an eye at rest.
const STREET_LEVELS: f64 = 3.0;

/// A camera in the hole of a ring has a part of it behind: the one ahead is seen.
fn hoops_are_seen_from_within(renderers: &mut Renderers) {
    let levels = documented(RENDERERS, "away from outlines colours are within ");
    let plain = Appearance { doppler_shift: false, intensity_exponent: None, ..Appearance::default() };
    let hoops = [0.0, 2.0, 4.0].map(|x| {
        let ring =
            Shape::Ring { centre: [x, 0.0, 0.0], axis: [1.0, 0.0, 0.0], radius: 3.0, tube_radius: 0.4 };
        Body::new(ring, 600.0)
    });
    let scene = PreparedScene::new([Group { motion: Motion::Own(Velocity::REST), bodies: &hoops }]);
    for (beta, x) in [(0.0, 0.0), (0.0, 1.7), (0.9, 0.0), (0.9, 2.1)] {
        let aperture = Aperture { x, y: 0.3, z: -0.2 };
        let camera = Camera::new(aperture, Gaze::along([1.0, 0.9, 0.0]), 1.8, [160, 100]);
        let camera = Camera { velocity: Velocity::from_beta(beta).expect("a speed").into(), ..camera };
        let view = View { camera, speed: Speed::REST, observation_time: 0.0, geometry: Geometry::Seen };
        let (truth, hits) = (scene.picture(&view, &plain, 1).rgba, scene.hit_image(&view));
        assert!(hits.hits.iter().flatten().count() > 300, "hoops are seen from {x} at {beta}");
        for method in [Method::Rays, Method::Packets] {
            let drawn = renderers.picture(method, &scene, &view, &plain, 1).expect("device works").rgba;
            let off = levels_off(&drawn, &truth, |i| is_inside(&hits, i));
            assert!(f64::from(off) <= levels, "{method}, from {x} at {beta}: {off} levels off");
        }
    }
}

/// The street, its ground and its sky from a ride along it, with a cyclist who is overtaken.
fn rides_are_the_references(renderers: &mut Renderers) {
    let levels = documented(RENDERERS, "away from outlines colours are within ");
    let velocity = |beta: f64| Velocity::from_beta(beta).expect("a speed");
    let road = Appearance {
        ground_z: Some(-1.0),
        road: Some([-1.0, 4.5]),
        fronts: Some(7.0),
        light: true,
        doppler_shift: false,
        intensity_exponent: None,
        shading: Shading::Emission,
        ..Appearance::default()
    };
    let lamp = Shape::Cylinder { from: [4.0, 3.0, -1.0], to: [4.0, 3.0, 2.0], radius: 0.3 };
    let ball = Shape::Sphere { centre: [2.0, 2.0, -0.6], radius: 0.4 };
    // What rides along turns its wheels as far as the street goes by.
    let hub = [1.2, 0.3, -0.5];
    let spoke = Shape::Tube { from: [1.2, 0.3, -0.5], to: [1.2, 0.3, -0.1], radius: 0.08 };
    let spin = Spin { hub, radius: 0.5, turning: Turning::Rolling };
    let own = [Body { spin: Some(spin), ..Body::new(spoke, 550.0) }];
    let [lamp, ball] = [lamp, ball].map(|shape| [Body::new(shape, 600.0)]);
    let scene = PreparedScene::new([
        Group { motion: Motion::Own(Velocity::REST), bodies: &lamp },
        Group { motion: Motion::Own(velocity(0.6)), bodies: &ball },
        Group { motion: Motion::WithEyes, bodies: &own },
    ]);
    let shifted = Appearance { doppler_shift: true, exposure_ev: -2.0, ..road };
    // Exposed light magnifies any difference at edges: its sky has none.
    let open = Appearance { ground_z: None, road: None, fronts: None, ..shifted };
    let looks = [
        (road, STREET_LEVELS),
        (Appearance { colour: Colour::StreetDaylight, ..shifted }, STREET_LEVELS),
        (Appearance { colour: Colour::StreetDaylight, street: StreetColours::Received, ..open }, levels),
        (Appearance { colour: Colour::False, ..open }, levels),
        (
            Appearance {
                intensity_exponent: Some(2.0),
                doppler_shift: false,
                street: StreetColours::Received,
                ..open
            },
            levels,
        ),
    ];
    let along = |beta: f64| ObserverVelocity::from(velocity(beta));
    let aslant = |beta: f64, azimuth: f64, elevation: f64| {
        ObserverVelocity::new(Speed::from_beta(beta).expect("a speed"), azimuth, elevation)
    };
    let cases = [
        (Geometry::Seen, along(0.6)),
        (Geometry::Seen, along(0.95)),
        (Geometry::Seen, along(-0.3)),
        (Geometry::Contracted, along(0.8)),
        (Geometry::Seen, aslant(0.6, FRAC_PI_2, 0.0)),
        (Geometry::Seen, aslant(0.9, 0.7, 0.4)),
        (Geometry::Seen, aslant(0.5, 0.0, FRAC_PI_2)),
        (Geometry::Contracted, aslant(0.8, 2.0, -0.3)),
    ];
    for (seed, (geometry, heading)) in (0..).zip(cases) {
        let beta = heading.speed().beta();
        let camera = Camera::new(Aperture::default(), Gaze::along([3.0, 2.0, 0.0]), 1.6, [160, 100]);
        let camera = Camera { velocity: heading, rolled: 0.3, ..camera };
        let view = View { camera, speed: Speed::REST, observation_time: 0.0, geometry };
        let hits = scene.hit_image(&view);
        assert!(hits.hits.iter().flatten().count() > 30, "bodies are seen at {beta}");
        assert!(
            hits.hits.iter().flatten().filter(|hit| hit.body == 2).count() > 30,
            "what rides along is, too"
        );
        for (look, street_levels) in sweep(seed, 3, &looks) {
            let truth = scene.picture(&view, look, 1).rgba;
            for method in [Method::Rays, Method::Packets, Method::Mesh] {
                let drawn = renderers.picture(method, &scene, &view, look, 1).expect("device works").rgba;
                let named =
                    format!("{method}, {geometry:?} at {beta} along {:?}, {look:?}", heading.direction());
                let off = levels_off(&drawn, &truth, |i| is_inside(&hits, i));
                assert!(f64::from(off) <= levels, "{named}: {off} levels off");
                let off = levels_off(&drawn, &truth, |i| is_free(&hits, i));
                assert!(f64::from(off) <= *street_levels, "{named}: the street is {off} levels off");
            }
        }
    }
}
