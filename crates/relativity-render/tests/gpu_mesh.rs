//! The mesh renderer keeps its bound, against the f64 reference and the core's published model.

use glam::{DVec2, DVec3};
use relativity_core::{Aperture, MAX_GAMMA, Model, PublishedVariant, SourcePoint, Speed, sighting};
use relativity_render::{
    Body, Camera, Gaze, Geometry, Group, Hit, HitImage, Method, Motion, PreparedScene, Renderers, Shape,
    Velocity, View,
};

use crate::gpu_support::Test;
use crate::gpu_support::scenes::{
    conformal_views, oblique_views, parallel_views, still_life, time_seen_at, view_following,
};
use crate::joints::joints;
use crate::support::sweep;

pub const TESTS: &[Test] = &[
    ("the_picture_keeps_the_bound", the_picture_keeps_the_bound),
    ("groups_keep_the_bound", groups_keep_the_bound),
    ("oblique_rides_keep_the_bound", oblique_rides_keep_the_bound),
    ("long_bodies_keep_the_bound", long_bodies_keep_the_bound),
    ("bodies_that_nearly_touch_are_told_apart", bodies_that_nearly_touch_are_told_apart),
    ("where_surfaces_coincide_the_first_body_is_seen", where_surfaces_coincide_the_first_body_is_seen),
    ("hits_appear_where_the_light_cone_says", hits_appear_where_the_light_cone_says),
    ("with_one_light_cone_pictures_keep_the_bound", with_one_light_cone_pictures_keep_the_bound),
    ("the_published_right_eye_is_the_cores", the_published_right_eye_is_the_cores),
];

const FOLLOWED: [f64; 3] = [-0.4, 3.0, 0.7];

/// Approaching, abreast and receding, up to beta = 0.9999 and at the greatest gamma.
fn views() -> impl Iterator<Item = View> {
    let speeds = [0.0, 0.5, 0.9, 0.99, 0.9999].map(|beta| Speed::from_beta(beta).expect("below 1"));
    let fastest = Speed::from_gamma(MAX_GAMMA).expect("in range");
    let speeds: Vec<_> = speeds.into_iter().chain([fastest]).collect();
    let parallel: Vec<_> = parallel_views(speeds.clone(), FOLLOWED).collect();
    let conformal: Vec<_> = conformal_views(speeds.clone(), FOLLOWED).collect();
    let across_gaze = speeds.into_iter().flat_map(|speed| {
        [-8.0, -1.0, 0.0, 1.0, 4.0]
            .map(|along| view_following(FOLLOWED, speed, time_seen_at(FOLLOWED, &speed, along), 45.0))
    });
    across_gaze.chain(parallel).chain(conformal)
}

/// The views in all geometries whose light comes along straight lines.
fn views_of_all_geometries() -> impl Iterator<Item = View> {
    let geometries = [Geometry::Seen, Geometry::Contracted, Geometry::Rest];
    views().flat_map(move |view| geometries.map(|geometry| View { geometry, ..view }))
}

fn the_picture_keeps_the_bound(renderers: &mut Renderers) {
    let scene = PreparedScene::moving(&still_life());
    for view in sweep(0, 12, views_of_all_geometries()) {
        keep_bound(renderers, &scene, &still_life(), &view);
    }
}

/// Still lifes that ride past, rest and come the other way, through each other.
fn groups() -> (PreparedScene, Vec<Body>) {
    let groups = [(0.0, [0.0, 1.0, 0.0]), (-0.6, [0.3, 0.05, 0.1])].map(|(beta, offset)| {
        let motion = Motion::Own(Velocity::from_beta(beta).expect("a speed"));
        (motion, still_life().into_iter().map(|body| body.moved(offset)).collect::<Vec<_>>())
    });
    let groups: Vec<_> = [(Motion::Scene, still_life())].into_iter().chain(groups).collect();
    let scene = PreparedScene::new(groups.iter().map(|(motion, bodies)| Group { motion: *motion, bodies }));
    (scene, groups.into_iter().flat_map(|(_, bodies)| bodies).collect())
}

fn groups_keep_the_bound(renderers: &mut Renderers) {
    let (scene, bodies) = groups();
    for view in sweep(0, 18, views_of_all_geometries()) {
        keep_bound(renderers, &scene, &bodies, &view);
    }
}

/// Before a camera that moves in any direction.
fn oblique_rides_keep_the_bound(renderers: &mut Renderers) {
    let scene = PreparedScene::moving(&still_life());
    let geometries = [Geometry::Seen, Geometry::Contracted, Geometry::OneCone];
    let views = oblique_views(FOLLOWED).into_iter();
    for view in sweep(0, 5, views.flat_map(|view| geometries.map(|geometry| View { geometry, ..view }))) {
        keep_bound(renderers, &scene, &still_life(), &view);
    }
}

/// Bodies many times as long as they are far.
fn long_bodies_keep_the_bound(renderers: &mut Renderers) {
    let hedge = Shape::Box { centre: [20.0, 1.6, -0.5], half: [45.0, 0.35, 0.5], turn: [0.0, 0.0, 0.0, 1.0] };
    let rail = Shape::Tube { from: [-40.0, 2.1, 1.1], to: [40.0, 2.1, 1.1], radius: 0.05 };
    let rod = Shape::Cylinder { from: [-13.0, 3.0, 0.3], to: [9.0, 3.0, 0.5], radius: 0.1 };
    let bodies = [hedge, rail, rod].map(|shape| Body::new(shape, 600.0));
    let (scene, nearest) = (PreparedScene::moving(&bodies), [0.5, 1.6, 0.2]);
    let speeds = [0.0, 0.5, 0.9, 0.99].map(|beta| Speed::from_beta(beta).expect("below 1"));
    let across = speeds.into_iter().flat_map(|speed| {
        [-3.0, 0.0, 1.0]
            .map(|along| view_following(nearest, speed, time_seen_at(nearest, &speed, along), 80.0))
    });
    let views: Vec<_> = across.chain(conformal_views(speeds, nearest)).collect();
    let geometries = [Geometry::Seen, Geometry::OneCone];
    let views = views.into_iter().flat_map(|view| geometries.map(|geometry| View { geometry, ..view }));
    for view in sweep(0, 4, views) {
        keep_bound(renderers, &scene, &bodies, &view);
    }
}

/// A ball sticks out of a tube, and a ring of a ball, by less than triangles are off their surfaces.
fn bodies_that_nearly_touch_are_told_apart(renderers: &mut Renderers) {
    let centre = FOLLOWED;
    let shapes = [
        Shape::Tube { from: [-0.4, 3.0, 0.2], to: [-0.4, 3.0, 1.2], radius: 0.2 },
        Shape::Sphere { centre, radius: 0.2005 },
        Shape::Ring { centre, axis: [0.6, 0.0, 0.8], radius: 0.11, tube_radius: 0.091 },
    ];
    for (seed, pair) in (0..).zip(shapes.windows(2)) {
        let bodies: Vec<_> = pair.iter().map(|&shape| Body::new(shape, 600.0)).collect();
        let scene = PreparedScene::moving(&bodies);
        for view in sweep(seed, 8, views()) {
            keep_bound(renderers, &scene, &bodies, &view);
        }
    }
}

fn where_surfaces_coincide_the_first_body_is_seen(renderers: &mut Renderers) {
    let mut bodies = joints();
    for seed in 0..2 {
        let scene = PreparedScene::moving(&bodies);
        for view in sweep(seed, 8, views()) {
            keep_bound(renderers, &scene, &bodies, &view);
        }
        bodies.reverse();
    }
}

/// Checks that the drawing of `scene`, which consists of `bodies`, keeps the bound: every pixel shows the
/// body that the reference shows there, and the same side of it, or an outline is within the bound of there,
/// or a place where f32 cannot tell which of two is nearer.
fn keep_bound(renderers: &mut Renderers, scene: &PreparedScene, bodies: &[Body], view: &View) {
    let (truth, bound_px) = (scene.hit_image(view), Method::MESH_ERROR_PX);
    let image = renderers.hits(Method::Mesh, scene, view).expect("device works");
    for (i, (hit, true_hit)) in image.hits.iter().zip(&truth.hits).enumerate() {
        if !is_across_an_outline(*hit, *true_hit) {
            continue;
        }
        let mut nearby = around(pixel(&image, i), bound_px)
            .map(|place| scene.first_hit(view, view.camera.line_of_sight(place.to_array())));
        assert!(
            nearby.any(|found| is_across_an_outline(found, *true_hit))
                || is_a_toss_up(*hit, *true_hit, scene, bodies, view, pixel(&image, i)),
            "{:?} beta {} T {}: {hit:?} at {} is further off than {bound_px} px",
            view.geometry,
            view.speed.beta(),
            view.observation_time,
            pixel(&image, i)
        );
    }
}

/// Whether two hits in the same place or near each other are on different bodies, or on different sides of
/// one.
fn is_across_an_outline(a: Option<Hit>, b: Option<Hit>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.body != b.body || a.rest_position.distance(b.rest_position) > 0.2,
        _ => a.is_some() != b.is_some(),
    }
}

/// Whether, where `pixel` is, the body that was hit is farther than the true one by less than f32 resolves,
/// though not in the same place: so it is where the side of a tube begins to part from a ball at its end.
fn is_a_toss_up(
    hit: Option<Hit>,
    true_hit: Option<Hit>,
    scene: &PreparedScene,
    bodies: &[Body],
    view: &View,
    pixel: DVec2,
) -> bool {
    let (Some(hit), Some(true_hit)) = (hit, true_hit) else { return false };
    let motion = scene.motion_of(hit.body);
    let alone = PreparedScene::new([Group { motion, bodies: &bodies[hit.body..=hit.body] }]);
    let there = alone.first_hit(view, view.camera.line_of_sight(pixel.to_array()));
    there.is_some_and(|there| (1e-11..1e-6).contains(&(there.distance / true_hit.distance - 1.0)))
}

fn hits_appear_where_the_light_cone_says(renderers: &mut Renderers) {
    let scene = PreparedScene::moving(&still_life());
    for view in sweep(0, 9, views()) {
        let image = renderers.hits(Method::Mesh, &scene, &view).expect("device works");
        for (i, hit) in image.hits.iter().enumerate().filter_map(|(i, hit)| Some((i, (*hit)?))) {
            let point = SourcePoint::from_rest(hit.rest_position.to_array(), &view.speed);
            let seen = sighting(&view.speed, point, view.camera.aperture, view.observation_time);
            let place = place(&view, seen.expect("inside the domain").position);
            let off = place.distance(pixel(&image, i));
            assert!(off < Method::MESH_ERROR_PX, "beta {}: {off} px off", view.speed.beta());
        }
    }
}

/// Eyes close together and eyes as far apart as the bodies are wide, alone and among other groups.
fn with_one_light_cone_pictures_keep_the_bound(renderers: &mut Renderers) {
    let alone = (PreparedScene::moving(&still_life()), still_life());
    for (seed, (scene, bodies)) in (0..).zip([alone, groups()]) {
        let eyes = [[-0.05, 0.0, 0.0], [0.5, 0.0, 0.0], [0.2, -0.3, 0.4]].map(DVec3::from);
        for (view, off_middle) in sweep(seed, 10, views().zip(eyes.into_iter().cycle())) {
            let [x, y, z] = off_middle.to_array();
            let camera = Camera { aperture: Aperture { x, y, z }, off_middle, ..view.camera };
            let mut view = View { camera, geometry: Geometry::OneCone, ..view };
            let followed = view.apparent_position(FOLLOWED).expect("inside the domain");
            view.camera.gaze = Gaze::along(followed.to_array());
            keep_bound(renderers, &scene, &bodies, &view);
        }
    }
}

/// The published model places the right eye's view of every group where the core does; a resting point
/// appears where the left eye sees it.
fn the_published_right_eye_is_the_cores(renderers: &mut Renderers) {
    let separation = 0.1;
    let [left, _] = Aperture::pair(separation);
    let (scene, _) = groups();
    let mut seen = [0; 3];
    for mut view in sweep(0, 4, views()) {
        view.camera.aperture = left;
        let published = View { geometry: Geometry::Published, ..view };
        let image = renderers.hits(Method::Mesh, &scene, &published).expect("device works");
        for (i, hit) in image.hits.iter().enumerate().filter_map(|(i, hit)| Some((i, (*hit)?))) {
            let apparent = match scene.motion_of(hit.body) {
                Motion::Own(Velocity::REST) => hit.rest_position - DVec3::new(left.x, left.y, left.z),
                Motion::WithEyes => unreachable!("nobody rides"),
                Motion::Own(velocity) => published_right(velocity, &hit, separation, &view),
                Motion::Scene => published_right(Velocity::forward(view.speed), &hit, separation, &view),
            };
            let off = place(&view, apparent.to_array()).distance(pixel(&image, i));
            let group = scene.group_of(hit.body);
            let context = format!("beta {}, group {group}", view.speed.beta());
            assert!(off < Method::MESH_ERROR_PX, "{context}: {off} px off");
            seen[group] += 1;
        }
    }
    assert!(seen.iter().all(|&seen| seen > 10_000), "{seen:?} pixels are too few to judge by");
}

/// Returns the direction in which the published model of the core sees the event of the `hit` with the right
/// eye.
fn published_right(velocity: Velocity, hit: &Hit, separation: f64, view: &View) -> DVec3 {
    let model = Model::Published(PublishedVariant::AppendixA);
    let both = velocity.disparity(
        model,
        hit.rest_position.to_array(),
        Aperture::pair(separation),
        view.observation_time,
    );
    both.expect("inside the domain").secondary.position.into()
}

/// The pixel's centre.
fn pixel(image: &HitImage, i: usize) -> DVec2 {
    let width = image.size[0] as usize;
    DVec2::new((i % width) as f64 + 0.5, (i / width) as f64 + 0.5)
}

fn place(view: &View, apparent: [f64; 3]) -> DVec2 {
    view.camera.pixel(apparent.into()).expect("in front of the camera").into()
}

/// Places up to `reach` from `centre`.
fn around(centre: DVec2, reach: f64) -> impl Iterator<Item = DVec2> {
    let turned = |k: u32| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 32.0);
    [1.0, 0.6, 0.3]
        .into_iter()
        .flat_map(move |share| (0..32).map(move |k| centre + turned(k) * (share * reach)))
}
