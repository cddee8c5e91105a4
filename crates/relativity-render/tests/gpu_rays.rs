//! The rays against the f64 reference and against the light-cone formula of the core.

use std::sync::LazyLock;

use glam::DVec3;
use relativity_core::{SourcePoint, Speed, sighting};
use relativity_render::{
    Body, Geometry, Group, HitImage, Method, Motion, PreparedScene, Projection, Renderers, Shape, Velocity,
    View,
};

use crate::gpu_support::Test;
use crate::gpu_support::scenes::{
    conformal_views, crowd, oblique_views, parallel_views, round_still_life, speeds, still_life, swarms,
    time_seen_at, view_following,
};
use crate::joints::{joints, shared_pixels};
use crate::support::{documented, signed_distance, sweep};

pub const TESTS: &[Test] = &[
    ("hits_agree_with_the_reference", hits_agree_with_the_reference),
    ("groups_agree_with_the_reference", groups_agree_with_the_reference),
    ("oblique_rides_agree_with_the_reference", oblique_rides_agree_with_the_reference),
    (
        "groups_that_fly_apart_agree_up_to_the_documented_gamma",
        groups_that_fly_apart_agree_up_to_the_documented_gamma,
    ),
    ("beyond_it_only_the_fastest_group_keeps_its_digits", beyond_it_only_the_fastest_group_keeps_its_digits),
    ("hits_appear_where_the_light_cone_says", hits_appear_where_the_light_cone_says),
    ("where_surfaces_coincide_the_first_body_is_seen", where_surfaces_coincide_the_first_body_is_seen),
    ("bounds_never_clip", bounds_never_clip),
    ("spheres_keep_a_circular_outline", spheres_keep_a_circular_outline),
    ("a_cube_far_abeam_looks_turned", a_cube_far_abeam_looks_turned),
];

/// The point followed, and how far along its path it is seen, in units of its distance from the path:
/// approaching, abreast, receding.
const FOLLOWED: [f64; 3] = [-0.4, 3.0, 0.7];
const ALONG: [f64; 5] = [-8.0, -1.0, 0.0, 1.0, 4.0];

fn views() -> impl Iterator<Item = View> {
    let parallel = parallel_views(speeds(), FOLLOWED);
    views_across_gaze().chain(parallel).chain(conformal_views(speeds(), FOLLOWED))
}

/// The views in each of these geometries.
fn views_of(geometries: &[Geometry]) -> impl Iterator<Item = View> {
    geometries.iter().flat_map(|&geometry| views().map(move |view| View { geometry, ..view }))
}

const GEOMETRIES: [Geometry; 3] = [Geometry::Seen, Geometry::Contracted, Geometry::Rest];

fn views_across_gaze() -> impl Iterator<Item = View> {
    speeds().into_iter().flat_map(|speed| {
        ALONG.map(|along| {
            let time = time_seen_at(FOLLOWED, &speed, along);
            view_following(FOLLOWED, speed, time, 45.0)
        })
    })
}

/// On the GPU, and on the CPU.
const METHODS: [Method; 2] = [Method::Rays, Method::Packets];

/// The documented bounds of the rays.
struct Promise {
    wrong_percent: f64,
    outline_px: f64,
    doppler_error: f64,
    surface_error: f64,
}

static PROMISE: LazyLock<Promise> = LazyLock::new(|| Promise {
    wrong_percent: documented(RENDERERS, "the body differs at fewer than "),
    outline_px: documented(RENDERERS, "all of them within "),
    doppler_error: documented(RENDERERS, "D is within "),
    surface_error: documented(RENDERERS, "hits lie within "),
});
const RENDERERS: &str = include_str!("../src/renderers.rs");

fn hits_agree_with_the_reference(renderers: &mut Renderers) {
    for view in sweep(0, 12, views_of(&GEOMETRIES)) {
        agrees(renderers, &PreparedScene::moving(&still_life()), &still_life(), &view);
    }
}

/// Two still lifes that fly apart as fast.
fn pair_apart(speed: Speed) -> (PreparedScene, Vec<Body>) {
    let apart = Velocity { speed, is_backward: true };
    let second: Vec<_> = round_still_life().into_iter().map(|body| body.moved([0.3, 0.05, 0.1])).collect();
    let scene = PreparedScene::new([
        Group { motion: Motion::Scene, bodies: &round_still_life() },
        Group { motion: Motion::Own(apart), bodies: &second },
    ]);
    (scene, [round_still_life(), second].concat())
}

fn groups_that_fly_apart_agree_up_to_the_documented_gamma(renderers: &mut Renderers) {
    for gamma in [100.0, 1e3, documented(RENDERERS, "still told apart up to gamma = ")] {
        let speed = Speed::from_gamma(gamma).expect("in range");
        let (scene, bodies) = pair_apart(speed);
        for along in [-0.1, 0.0, 0.1] {
            let view = view_following(FOLLOWED, speed, time_seen_at(FOLLOWED, &speed, along), 60.0);
            agrees(renderers, &scene, &bodies, &view);
        }
    }
}

fn beyond_it_only_the_fastest_group_keeps_its_digits(renderers: &mut Renderers) {
    let speed = Speed::from_gamma(documented(RENDERERS, "1e5; at ")).expect("in range");
    let most_percent = documented(RENDERERS, "one body for another at up to ");
    let (scene, _) = pair_apart(speed);
    let mut confused_anywhere = 0;
    for along in [-0.1, 0.0, 0.1] {
        let view = view_following(FOLLOWED, speed, time_seen_at(FOLLOWED, &speed, along), 60.0);
        let image = renderers.hits(Method::Rays, &scene, &view).expect("device works");
        let ([mut shown, mut confused], truth) = ([0; 2], scene.hit_image(&view));
        for (i, (hit, true_hit)) in image.hits.iter().zip(&truth.hits).enumerate() {
            let body = hit.map(|hit| hit.body);
            shown += usize::from(true_hit.is_some_and(|hit| scene.group_of(hit.body) == 1));
            let is_right = body == true_hit.map(|hit| hit.body);
            if !is_right && !bodies_around(&scene, &view, pixel(&image, i)).contains(&body) {
                let groups = [*hit, *true_hit].map(|hit| hit.map(|hit| scene.group_of(hit.body)));
                assert_eq!(groups, [Some(1); 2], "along {along}: {hit:?} for {true_hit:?}");
                confused += 1;
            }
        }
        assert!(confused as f64 <= 0.01 * most_percent * shown as f64, "{confused} of {shown}");
        confused_anywhere += confused;
    }
    assert!(confused_anywhere > 0, "the documentation is too modest");
}

/// Groups of all motions, through each other: still lifes that ride past, rest and come the other way.
fn groups_agree_with_the_reference(renderers: &mut Renderers) {
    let [ground, oncoming] = [0.0, -0.6].map(|beta| Velocity::from_beta(beta).expect("a speed"));
    let moved = |body: Body, offset: DVec3| body.moved(offset.to_array());
    let behind = crowd(60).into_iter().map(|body| moved(body, DVec3::new(0.0, 5.0, 0.0)));
    let other = still_life().into_iter().map(|body| moved(body, DVec3::new(0.3, 0.05, 0.1)));
    let groups = [
        (Motion::Scene, still_life()),
        (Motion::Own(ground), behind.collect::<Vec<_>>()),
        (Motion::Own(oncoming), other.collect()),
    ];
    let bodies: Vec<_> = groups.iter().flat_map(|(_, bodies)| bodies.clone()).collect();
    let scene = PreparedScene::new(groups.iter().map(|(motion, bodies)| Group { motion: *motion, bodies }));
    for view in sweep(0, 18, views_of(&GEOMETRIES)) {
        agrees(renderers, &scene, &bodies, &view);
    }
}

/// Before a camera that moves in any direction, alone and among other groups.
fn oblique_rides_agree_with_the_reference(renderers: &mut Renderers) {
    let ground = Motion::Own(Velocity::REST);
    let other: Vec<_> = still_life().into_iter().map(|body| body.moved([0.0, 1.5, 0.3])).collect();
    let both = [still_life(), other.clone()].concat();
    let scene = PreparedScene::new([
        Group { motion: Motion::Scene, bodies: &still_life() },
        Group { motion: ground, bodies: &other },
    ]);
    let geometries = [Geometry::Seen, Geometry::Contracted];
    let views = oblique_views(FOLLOWED).into_iter();
    for view in sweep(0, 4, views.flat_map(|view| geometries.map(|geometry| View { geometry, ..view }))) {
        agrees(renderers, &PreparedScene::moving(&still_life()), &still_life(), &view);
        if view.speed.gamma() <= 100.0 && view.camera.velocity.speed().gamma() <= 100.0 {
            agrees(renderers, &scene, &both, &view);
        }
    }
}

fn agrees(renderers: &mut Renderers, reference: &PreparedScene, bodies: &[Body], view: &View) {
    let truth = reference.hit_image(view);
    for method in METHODS {
        let image = renderers.hits(method, reference, view).expect("device works");
        let context =
            format!("{method}, {:?} gamma {} T {}", view.geometry, view.speed.gamma(), view.observation_time);
        agree(&image, &truth, &context, reference, bodies, view);
    }
}

fn agree(
    image: &HitImage,
    truth: &HitImage,
    context: &str,
    reference: &PreparedScene,
    bodies: &[Body],
    view: &View,
) {
    let mut wrong = 0;
    for (i, (hit, true_hit)) in image.hits.iter().zip(&truth.hits).enumerate() {
        if let (Some(hit), Some(true_hit)) = (hit, true_hit) {
            let error = (hit.doppler_factor / true_hit.doppler_factor - 1.0).abs();
            assert!(error < PROMISE.doppler_error, "{context}: D off by {error:e}");
        }
        if let Some(hit) = hit {
            let off_surface = signed_distance(&bodies[hit.body].shape, hit.rest_position).abs();
            assert!(
                off_surface < PROMISE.surface_error,
                "{context}: {off_surface:e} off {:?}",
                bodies[hit.body].shape
            );
        }
        let body = hit.map(|hit| hit.body);
        if body != true_hit.map(|hit| hit.body) {
            wrong += 1;
            let nearby = bodies_around(reference, view, pixel(image, i));
            assert!(
                nearby.contains(&body),
                "{context}: pixel {:?} is wrong inside: {hit:?} for {true_hit:?}",
                pixel(image, i)
            );
        } else if let (Some(hit), Some(true_hit)) = (hit, true_hit)
            && hit.rest_normal.distance(true_hit.rest_normal) > 0.5
        {
            // The wrong side of the right body.
            wrong += 1;
        }
    }
    let covered = truth.hits.iter().flatten().count();
    // One pixel is none where few are covered.
    let most = (0.01 * PROMISE.wrong_percent * covered as f64).max(1.0);
    assert!(f64::from(wrong) <= most, "{context}: {wrong} of {covered} pixels are wrong");
}

/// The pixel's centre.
fn pixel(image: &HitImage, i: usize) -> [f64; 2] {
    let width = image.size[0] as usize;
    [(i % width) as f64 + 0.5, (i / width) as f64 + 0.5]
}

/// Returns the bodies at `place`, and around it as far away as an outline may be off.
fn bodies_around(scene: &PreparedScene, view: &View, place: [f64; 2]) -> [Option<usize>; 17] {
    let places = around(place);
    std::array::from_fn(|k| {
        let line_of_sight = view.camera.line_of_sight(*places.get(k).unwrap_or(&place));
        scene.first_hit(view, line_of_sight).map(|hit| hit.body)
    })
}

/// Places as far from `place` as an outline may be off.
fn around([u, v]: [f64; 2]) -> [[f64; 2]; 16] {
    std::array::from_fn(|k| {
        let (sine, cosine) = (std::f64::consts::TAU * k as f64 / 16.0).sin_cos();
        [u + PROMISE.outline_px * cosine, v + PROMISE.outline_px * sine]
    })
}

fn hits_appear_where_the_light_cone_says(renderers: &mut Renderers) {
    let cases = views().flat_map(|view| METHODS.map(|method| (view, method)));
    for (view, method) in sweep(0, 9, cases) {
        let image =
            renderers.hits(method, &PreparedScene::moving(&still_life()), &view).expect("device works");
        for (i, hit) in image.hits.iter().enumerate().filter_map(|(i, hit)| Some((i, (*hit)?))) {
            let point = SourcePoint::from_rest(hit.rest_position.to_array(), &view.speed);
            let seen = sighting(&view.speed, point, view.camera.aperture, view.observation_time);
            let seen = seen.expect("inside the domain");
            let place = view.camera.pixel(seen.position.into()).expect("in front");
            let off = (DVec3::new(place[0], place[1], 0.0)
                - DVec3::new(pixel(&image, i)[0], pixel(&image, i)[1], 0.0))
            .length();
            assert!(off < 0.05, "gamma {}: {off} px off", view.speed.gamma());
            let distance_error = (hit.distance / seen.distance - 1.0).abs();
            assert!(distance_error < 1e-5, "gamma {}: distance {distance_error:e}", view.speed.gamma());
        }
    }
}

fn where_surfaces_coincide_the_first_body_is_seen(renderers: &mut Renderers) {
    let mut bodies = joints();
    for seed in 0..2 {
        for view in sweep(seed, 7, views_across_gaze()) {
            for method in METHODS {
                let image =
                    renderers.hits(method, &PreparedScene::moving(&bodies), &view).expect("device works");
                let [shared, not_first] = shared_pixels(&image, &bodies, &view);
                assert!(
                    not_first * 1000 <= shared.max(1000),
                    "{method}, gamma {}: {not_first} of {shared} pixels show the other body",
                    view.speed.gamma()
                );
            }
            agrees(renderers, &PreparedScene::moving(&bodies), &bodies, &view);
        }
        bodies.reverse();
    }
}

fn bounds_never_clip(renderers: &mut Renderers) {
    let mut unbounded = Renderers::brute_force(renderers.gpu().expect("a device").clone());
    let (crowd, swarms) = (PreparedScene::moving(&crowd(150)), PreparedScene::moving(&swarms(10)));
    let right = DVec3::new(0.96, 0.0, 0.28);
    let projections = [
        Projection::Gaze,
        Projection::Parallel { right, shift: 0.1 },
        Projection::Mercator { right, shift: 0.1 },
        Projection::Mercator { right: DVec3::X, shift: 0.1 },
    ];
    let cases = GEOMETRIES.into_iter().flat_map(|geometry| speeds().map(|speed| (geometry, speed)));
    let cases = cases.flat_map(|case| {
        [([2.0, 1.0, 0.5], 50.0), ([-3.0, 0.5, -1.0], 120.0)].map(|followed| (case, followed))
    });
    let cases = cases.flat_map(|case| projections.map(|projection| (case, projection)));
    let cases = cases.flat_map(|case| [(case, &crowd), (case, &swarms)]);
    for ((((geometry, speed), (rest, fov)), projection), scene) in sweep(0, 10, cases) {
        let mut view = View { geometry, ..view_following(rest, speed, 0.3, fov) };
        view.camera.projection = projection;
        let [found, expected] = [&mut *renderers, &mut unbounded]
            .map(|renderers| renderers.hits(Method::Rays, scene, &view).expect("device works"));
        let differing = found.hits.iter().zip(&expected.hits).filter(|(a, b)| a != b).count();
        assert_eq!(differing, 0, "{geometry:?} gamma {} fov {fov} {projection:?}", speed.gamma());
    }
}

/// Penrose: the outline's lines of sight n satisfy n.a = 1 for some vector a.
fn spheres_keep_a_circular_outline(renderers: &mut Renderers) {
    let centre = [0.0, 3.0, 1.0];
    let body = Body::new(Shape::Sphere { centre, radius: 0.5 }, 600.0);
    for speed in [0.0, 0.5, 0.9, 0.99, 0.9999].map(|beta| Speed::from_beta(beta).expect("below 1")) {
        for along in [-1.5, 0.0, 1.5] {
            let view = view_following(centre, speed, time_seen_at(centre, &speed, along), 40.0);
            let image = renderers
                .hits(Method::Rays, &PreparedScene::moving(std::slice::from_ref(&body)), &view)
                .expect("device works");
            let outline = outline(&image, &view);
            assert!(outline.len() > 20, "too small to judge");
            let residual = circle_residual(&outline) * view.camera.focal_length_px();
            // A place between two pixels is known to half a pixel.
            assert!(residual < 0.75, "beta {} along {along}: {residual} px", speed.beta());
        }
    }
}

/// Terrell: where the line of sight is at right angles to the motion, a small cube looks turned by arcsin
/// beta. At 0.8 c its front is sqrt(1 - beta^2) = 0.6 of its edge wide, and its rear, which no picture at
/// rest would show, beta = 0.8.
fn a_cube_far_abeam_looks_turned(renderers: &mut Renderers) {
    let (centre, speed) = ([0.0, 1000.0, 0.0], Speed::from_beta(0.8).expect("below 1"));
    let cube = Shape::Box { centre, half: [0.5; 3], turn: [0.0, 0.0, 0.0, 1.0] };
    let scene = PreparedScene::moving(&[Body::new(cube, 600.0)]);
    let edge_px = 100.0;
    let focal_length_px = edge_px * centre[1];
    let fov_degrees = 2.0 * f64::atan2(160.0, focal_length_px).to_degrees();
    let view = view_following(centre, speed, time_seen_at(centre, &speed, 0.0), fov_degrees);
    for method in [Method::Reference, Method::Rays, Method::Mesh] {
        let image = renderers.hits(method, &scene, &view).expect("device works");
        let row: Vec<_> = image.hits[120 * 320..121 * 320].to_vec();
        for (normal, along, expected) in [(DVec3::NEG_Y, DVec3::X, 0.6), (DVec3::NEG_X, DVec3::NEG_Y, 0.8)] {
            let face = row.iter().enumerate().filter_map(|(u, hit)| {
                let hit = hit.filter(|hit| hit.rest_normal.distance(normal) < 0.1)?;
                Some((u as f64, hit.rest_position.dot(along)))
            });
            let face: Vec<_> = face.collect();
            let [(first_px, first), .., (last_px, last)] = face[..] else {
                panic!("{method} hides {normal}")
            };
            let pixels = face.len() as f64 / edge_px;
            assert!((pixels - expected).abs() <= 0.01, "{method}, {normal}: {pixels} edges in pixels");
            let width = (last_px - first_px) / (last - first) / edge_px;
            assert!((width / expected - 1.0).abs() < 0.01, "{method}, {normal}: {width} edges wide");
        }
    }
}

/// Lines of sight halfway between pixels that show the body and their neighbours that do not.
fn outline(image: &HitImage, view: &View) -> Vec<DVec3> {
    let [width, height] = image.size.map(|v| v as usize);
    let shows = |u: usize, v: usize| image.hits[v * width + u].is_some();
    let mut outline = Vec::new();
    for v in 0..height - 1 {
        for u in 0..width - 1 {
            let [x, y] = [u as f64 + 0.5, v as f64 + 0.5];
            if shows(u, v) != shows(u + 1, v) {
                outline.push(view.camera.line_of_sight([x + 0.5, y]));
            }
            if shows(u, v) != shows(u, v + 1) {
                outline.push(view.camera.line_of_sight([x, y + 0.5]));
            }
        }
    }
    outline
}

/// Largest angle between the outline and the circle fitted to it, radians.
fn circle_residual(outline: &[DVec3]) -> f64 {
    let mut normal = glam::DMat3::ZERO;
    let mut sum = DVec3::ZERO;
    for n in outline {
        normal += glam::DMat3::from_cols(*n * n.x, *n * n.y, *n * n.z);
        sum += *n;
    }
    let a = normal.inverse() * sum;
    let radius = (1.0 / a.length()).acos();
    let off = |n: &DVec3| (n.angle_between(a) - radius).abs();
    outline.iter().map(off).fold(0.0, f64::max)
}
