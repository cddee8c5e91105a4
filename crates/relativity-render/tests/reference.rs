//! The reference renderer against a tracer on the ground that knows no boost, and against what is known
//! of pictures of fast bodies.

use glam::{DMat3, DQuat, DVec3};
use relativity_core::{Aperture, MAX_GAMMA, SourcePoint, Speed, sighting};
use relativity_render::{Body, Camera, Gaze, Geometry, Hit, HitImage, Motion, PreparedScene, Shape, View};

use crate::joints::{joints, shared_pixels};
use crate::support::{centred, documented, signed_distance, spread};

const BETAS: [f64; 5] = [0.0, 0.5, 0.9, 0.99, 0.999];

fn view(beta: f64, observation_time: f64, towards: [f64; 3], fov_degrees: f64) -> View {
    let camera =
        Camera::new(Aperture::pair(0.1)[1], Gaze::along(towards), fov_degrees.to_radians(), [60, 40]);
    let speed = Speed::from_beta(beta).expect("below 1");
    View { camera, speed, observation_time, geometry: Geometry::Seen }
}

/// Fourteen bodies of all shapes within about 1.5 of (0, 3, 1), some touching.
fn bodies() -> Vec<Body> {
    let body = |i: u32| {
        let [a, b, c, d, e, f, g] = spread(i + 7);
        let centre = (DVec3::new(0.0, 3.0, 1.0) + 1.2 * centred([a, b, c])).to_array();
        let turned = centred([d, e, f]);
        let shape = match i % 5 {
            0 => Shape::Sphere { centre, radius: 0.15 + 0.3 * g },
            3 => Shape::Box {
                centre,
                half: [0.1 + 0.3 * g, 0.1 + 0.1 * a, 0.2],
                turn: DQuat::from_rotation_arc(DVec3::X, turned.normalize()).to_array(),
            },
            4 => Shape::Cylinder {
                from: centre,
                to: (DVec3::from(centre) + 0.5 * turned).to_array(),
                radius: 0.1 + 0.2 * g,
            },
            1 => Shape::Tube {
                from: centre,
                to: (DVec3::from(centre) + turned).to_array(),
                radius: 0.03 + 0.1 * g,
            },
            _ => Shape::Ring {
                centre,
                axis: turned.normalize().to_array(),
                radius: 0.4 + 0.4 * g,
                tube_radius: 0.05 + 0.05 * a,
            },
        };
        Body::new(shape, 600.0)
    };
    (0..14).map(body).collect()
}

/// Views of them before, about abreast and after, for each of [`BETAS`], so close that the bodies are
/// well seen.
fn views() -> Vec<View> {
    let mut views = Vec::new();
    for beta in BETAS {
        for time in [-1.0, 2.0, 3.2, 6.0] {
            let middle = apparent_middle(beta, time);
            let fov_degrees = (5.0 / middle.length()).to_degrees().min(70.0);
            views.push(view(beta, time, middle.to_array(), fov_degrees));
        }
    }
    views
}

/// Returns the direction of the bodies' middle from the origin, by bisection on its light cone.
fn apparent_middle(beta: f64, observation_time: f64) -> DVec3 {
    let place = |t: f64| DVec3::new(beta * t, 3.0, 1.0);
    let emission = retarded_time(place, DVec3::ZERO, observation_time);
    place(emission)
}

/// When light received at `observation_time` at `eye` left the point at `place(t)`.
fn retarded_time(place: impl Fn(f64) -> DVec3, eye: DVec3, observation_time: f64) -> f64 {
    let mut back = 1.0;
    while place(observation_time - back).distance(eye) > back {
        back *= 2.0;
    }
    let [mut near, mut far] = [0.0, back];
    for _ in 0..200 {
        let middle = 0.5 * (near + far);
        if place(observation_time - middle).distance(eye) > middle { near = middle } else { far = middle }
    }
    observation_time - 0.5 * (near + far)
}

fn aperture(view: &View) -> DVec3 {
    let Aperture { x, y, z } = view.camera.aperture;
    DVec3::new(x, y, z)
}

/// Returns the place whose light cone a view shows: the aperture's, or the middle between two.
fn receiver(view: &View) -> DVec3 {
    let off_middle = if view.geometry == Geometry::OneCone { view.camera.off_middle } else { DVec3::ZERO };
    aperture(view) - off_middle
}

/// The rest coordinates of a place on the ground at a time: bodies are contracted and move, nothing else.
fn in_body_coordinates(view: &View, place: DVec3, time: f64) -> DVec3 {
    DVec3::new(view.speed.gamma() * (place.x - view.speed.beta() * time), place.y, place.z)
}

/// Body and distance seen along `n`, by walking back along the light (or, for `Contracted`, along a line
/// at the observation time) until the moving surface is met. A step is what the surface, as it moves,
/// cannot have crossed.
fn walked(bodies: &[Body], view: &View, n: DVec3) -> Option<(usize, f64)> {
    let place = |s: f64| {
        let place = aperture(view) + n * s;
        let travelled = match view.geometry {
            Geometry::Seen => s,
            Geometry::OneCone => place.distance(receiver(view)),
            _ => 0.0,
        };
        in_body_coordinates(view, place, view.observation_time - travelled)
    };
    let far = 1e9;
    let last_rate = place(2.0 * far).distance(place(far)) / far;
    // The greatest from s on: along a curve it falls to that of the line that it becomes.
    let rate = |s: f64| {
        let received_along = (aperture(view) + n * s - receiver(view)).normalize_or(n);
        last_rate + view.speed.gamma() * (1.0 - n.dot(received_along))
    };
    let nearest = |s: f64| {
        let distances = bodies.iter().map(|body| signed_distance(&body.shape, place(s)));
        distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).expect("there are bodies")
    };
    let end = 2.0 * (place(0.0).length() + 10.0) / last_rate;
    let mut s = 0.0;
    while s < end {
        let (body, distance) = nearest(s);
        if distance < 1e-12 {
            return Some((body, s));
        }
        s += (distance / rate(s)).max(1e-13 * s);
    }
    None
}

/// Doppler factor of what is seen of the rest-frame point: its proper time per time of reception.
fn measured_doppler_factor(view: &View, rest: DVec3) -> f64 {
    let [beta, gamma] = [view.speed.beta(), view.speed.gamma()];
    let place = |t: f64| DVec3::new(rest.x / gamma + beta * t, rest.y, rest.z);
    let h = 1e-5;
    let [later, earlier] = [h, -h].map(|h| retarded_time(place, receiver(view), view.observation_time + h));
    (later - earlier) / (2.0 * h) / gamma
}

fn pixels(view: &View) -> impl Iterator<Item = [u32; 2]> + use<> {
    let [width, height] = view.camera.size;
    (0..height).flat_map(move |v| (0..width).map(move |u| [u, v]))
}

fn line_of_sight(view: &View, [u, v]: [u32; 2]) -> DVec3 {
    view.camera.line_of_sight([f64::from(u) + 0.5, f64::from(v) + 0.5])
}

fn body_at(image: &HitImage, u: i64, v: i64) -> Option<usize> {
    let [width, height] = image.size.map(i64::from);
    let [u, v] = [u.clamp(0, width - 1), v.clamp(0, height - 1)];
    image.hits[(v * width + u) as usize].map(|hit| hit.body)
}

fn on_outline(image: &HitImage, [u, v]: [u32; 2]) -> bool {
    let [u, v] = [i64::from(u), i64::from(v)];
    let here = body_at(image, u, v);
    (-1..=1).any(|dv| (-1..=1).any(|du| body_at(image, u + du, v + dv) != here))
}

fn close(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= 1e-6 * expected.abs()
}

/// Compares one view with the walk; returns how many pixels show a body, and on how many of them the
/// body's number differs.
fn compare_with_walk(scene: &PreparedScene, bodies: &[Body], view: &View) -> [usize; 2] {
    let image = scene.hit_image(view);
    let [mut covered, mut different] = [0; 2];
    for (pixel, hit) in pixels(view).zip(&image.hits) {
        let walked = walked(bodies, view, line_of_sight(view, pixel));
        covered += usize::from(walked.is_some());
        if walked.map(|(body, _)| body) != hit.map(|hit| hit.body) {
            different += 1;
            assert!(on_outline(&image, pixel), "{view:?}, pixel {pixel:?}: {hit:?} against {walked:?}");
        } else if let (Some(hit), Some((_, distance))) = (hit, walked) {
            compare_hit(view, hit, distance);
        }
    }
    [covered, different]
}

fn compare_hit(view: &View, hit: &Hit, distance: f64) {
    assert!(close(hit.distance, distance), "{view:?}: {hit:?} at {distance}");
    if view.geometry == Geometry::Contracted {
        assert_eq!([hit.emission_time, hit.doppler_factor], [view.observation_time, 1.0]);
        return;
    }
    let emission_time = match view.geometry {
        Geometry::OneCone => {
            let [beta, gamma] = [view.speed.beta(), view.speed.gamma()];
            let [x, y, z] = hit.rest_position.to_array();
            let place = |t: f64| DVec3::new(x / gamma + beta * t, y, z);
            retarded_time(place, receiver(view), view.observation_time)
        }
        _ => view.observation_time - distance,
    };
    assert!((hit.emission_time - emission_time).abs() <= 1e-6 * distance, "{view:?}: {hit:?}");
    let doppler_factor = measured_doppler_factor(view, hit.rest_position);
    assert!(close(hit.doppler_factor, doppler_factor), "{view:?}: {hit:?} with D = {doppler_factor}");
}

#[test]
fn the_pictures_are_those_of_a_walk_back_along_the_light() {
    let bodies = bodies();
    let scene = PreparedScene::moving(&bodies);
    let mut total = [0; 2];
    for view in views() {
        let [covered, different] = compare_with_walk(&scene, &bodies, &view);
        assert!(covered > 50, "only {covered} pixels covered at {view:?}");
        total = [total[0] + covered, total[1] + different];
    }
    let [covered, different] = total;
    println!("{covered} pixels show a body, {different} of them another one to the walk");
    assert!(different * 1000 <= covered);
}

/// Eyes as far apart as the bodies are wide, too, and with a body between them, in any direction from each
/// other.
#[test]
fn with_one_light_cone_the_pictures_are_those_of_a_walk_back_along_the_middles_light() {
    let bodies = bodies();
    let scene = PreparedScene::moving(&bodies);
    let mut total = [0; 2];
    let along = [0.05, -0.5, 0.5, -1.5].map(|x| DVec3::X * x);
    let turned = [[0.03, -0.04, 0.0], [0.0, 0.0, -0.5], [-0.3, 0.2, 0.4], [0.0, -1.0, 0.3]].map(DVec3::from);
    let cases = views().into_iter().zip(along.into_iter().cycle());
    for (view, off_middle) in cases.chain(views().into_iter().zip(turned.into_iter().cycle())) {
        let [x, y, z] = (off_middle + DVec3::Y * 0.1).to_array();
        let camera = Camera { aperture: Aperture { x, y, z }, off_middle, ..view.camera };
        let view = View { camera, geometry: Geometry::OneCone, ..view };
        let [covered, different] = compare_with_walk(&scene, &bodies, &view);
        assert!(covered > 30, "only {covered} pixels covered at {view:?}");
        total = [total[0] + covered, total[1] + different];
    }
    let [covered, different] = total;
    println!("{covered} pixels show a body, {different} of them another one to the walk");
    assert!(different * 1000 <= covered);
}

#[test]
fn contracted_pictures_are_those_of_a_walk_at_one_instant() {
    let bodies = bodies();
    let scene = PreparedScene::moving(&bodies);
    for beta in BETAS {
        let towards = [beta * 3.0, 3.0, 1.0];
        let view = View { geometry: Geometry::Contracted, ..view(beta, 3.0, towards, 70.0) };
        let [covered, different] = compare_with_walk(&scene, &bodies, &view);
        assert!(covered > 50 && different * 1000 <= covered, "{different} of {covered} at beta = {beta}");
    }
}

#[test]
fn at_rest_a_camera_that_moves_along_sees_a_resting_scene() {
    let bodies = bodies();
    let scene = PreparedScene::moving(&bodies);
    let moving = View { geometry: Geometry::Rest, ..view(0.9, 1.5, [1.0, 1.0, 0.3], 90.0) };
    let mut resting = view(0.0, 0.0, [1.0, 1.0, 0.3], 90.0);
    let origin = moving.of_group(Motion::Scene).origin;
    resting.camera.aperture = Aperture { x: origin.x, y: origin.y, z: origin.z };
    let [a, b] = [moving, resting].map(|view| scene.hit_image(&view));
    assert!(a.hits.iter().flatten().count() > 100);
    for (a, b) in a.hits.iter().zip(&b.hits) {
        assert_eq!(a.map(|hit| (hit.body, hit.distance)), b.map(|hit| (hit.body, hit.distance)));
    }
    // The event of emission, boosted to the ground: t = gamma (t' + beta x'), reception being at t = T.
    let [beta, gamma] = [moving.speed.beta(), moving.speed.gamma()];
    let reception = gamma * (moving.observation_time - beta * moving.camera.aperture.x);
    for hit in a.hits.iter().flatten() {
        let emission = gamma * (reception - hit.distance + beta * hit.rest_position.x);
        assert!((hit.emission_time - emission).abs() < 1e-12 * gamma * gamma * hit.distance);
    }
}

#[test]
fn hits_lie_where_the_light_cone_shows_them_up_to_the_greatest_gamma() {
    let bodies = bodies();
    let scene = PreparedScene::moving(&bodies);
    let renderers = include_str!("../src/renderers.rs");
    let offset_px = documented(renderers, "positions are off by less than ");
    let share = documented(renderers, "distances and Doppler factors by less than ");
    let eyes = [[0.5, 0.0, 0.0], [0.0, -0.03, 0.04], [-0.05, 0.0, 0.0]].map(DVec3::from);
    let with_one_cone =
        extreme_views().into_iter().zip(eyes.into_iter().cycle()).map(|(view, off_middle)| {
            let [x, y, z] = off_middle.to_array();
            let camera = Camera { aperture: Aperture { x, y, z }, off_middle, ..view.camera };
            View { camera, geometry: Geometry::OneCone, ..view }
        });
    for view in extreme_views().into_iter().chain(with_one_cone) {
        let worst = worst_against_light_cone(&scene, &view);
        println!(
            "{:?}, gamma {:e}, T {}: {worst:?}",
            view.geometry,
            view.speed.gamma(),
            view.observation_time
        );
        assert!(worst.covered > 50, "only {} pixels covered at {view:?}", worst.covered);
        assert!(worst.offset_px < offset_px, "{worst:?} at {view:?}");
        assert!(worst.distance < share && worst.doppler_factor < share, "{worst:?} at {view:?}");
    }
}

/// Views like [`views`] from rest up to the greatest gamma; beyond a million without the first, for which f64
/// has no gaze (the bodies are 1e-12 wide, or less).
fn extreme_views() -> Vec<View> {
    let mut views = Vec::new();
    for gamma in [1.0, 10.0, 100.0, 1e3, 1e6, 1e12, MAX_GAMMA] {
        let times: &[f64] = if gamma > 1e6 { &[2.0, 3.2, 6.0] } else { &[-1.0, 2.0, 3.2, 6.0] };
        for &time in times {
            let speed = Speed::from_gamma(gamma).expect("in range");
            let middle = SourcePoint { x0: 0.0, y: 3.0, z: 1.0 };
            let middle = sighting(&speed, middle, Aperture::pair(0.1)[1], time).expect("in the domain");
            let fov_degrees = (5.0 / middle.distance).to_degrees().min(70.0);
            views.push(View { speed, ..view(0.0, time, middle.position, fov_degrees) });
        }
    }
    views
}

/// Largest differences of an image from the light cone of each point it shows.
#[derive(Debug, Default)]
struct Worst {
    covered: usize,
    offset_px: f64,
    distance: f64,
    doppler_factor: f64,
}

fn worst_against_light_cone(scene: &PreparedScene, view: &View) -> Worst {
    let image = scene.hit_image(view);
    let mut worst = Worst::default();
    for (pixel, hit) in pixels(view).zip(&image.hits) {
        let Some(hit) = hit else { continue };
        let source = SourcePoint::from_rest(hit.rest_position.to_array(), &view.speed);
        let DVec3 { x, y, z } = receiver(view);
        let seen = sighting(&view.speed, source, Aperture { x, y, z }, view.observation_time);
        let seen = seen.expect("in the domain");
        let place = DVec3::from(seen.position) + receiver(view) - aperture(view);
        let [u, v] = view.camera.pixel(place).expect("in front");
        let offset_px = (u - 0.5 - f64::from(pixel[0])).hypot(v - 0.5 - f64::from(pixel[1]));
        worst.covered += 1;
        worst.offset_px = worst.offset_px.max(offset_px);
        worst.distance = worst.distance.max((hit.distance / place.length() - 1.0).abs());
        worst.doppler_factor =
            worst.doppler_factor.max((hit.doppler_factor / seen.doppler_factor - 1.0).abs());
    }
    worst
}

/// Directions on the outline of the one body of `scene`, bisected between neighbouring pixels of a row or
/// column.
fn outline(scene: &PreparedScene, view: &View) -> Vec<DVec3> {
    let image = scene.hit_image(view);
    let seen = |place: [f64; 2]| scene.first_hit(view, view.camera.line_of_sight(place)).is_some();
    let mut outline = Vec::new();
    for [u, v] in pixels(view) {
        for [du, dv] in [[1, 0], [0, 1]] {
            let here = body_at(&image, i64::from(u), i64::from(v));
            if here == body_at(&image, i64::from(u + du), i64::from(v + dv)) {
                continue;
            }
            let [mut low, mut high] = [0.0, 1.0];
            let place = |share: f64| {
                [f64::from(u) + 0.5 + share * f64::from(du), f64::from(v) + 0.5 + share * f64::from(dv)]
            };
            for _ in 0..50 {
                let middle = 0.5 * (low + high);
                if seen(place(middle)) == here.is_some() { low = middle } else { high = middle }
            }
            outline.push(view.camera.line_of_sight(place(low)));
        }
    }
    outline
}

/// Largest deviation, pixels, of the directions from the circle that fits them best: the least-squares plane
/// n . w = 1 that cuts the sphere of directions.
fn circle_residual_px(outline: &[DVec3], focal_length_px: f64) -> f64 {
    let outer = |n: DVec3| DMat3::from_cols(n * n.x, n * n.y, n * n.z);
    let matrix = outline.iter().fold(DMat3::ZERO, |sum, &n| sum + outer(n));
    let axis = (matrix.inverse() * outline.iter().copied().sum::<DVec3>()).normalize();
    let angles: Vec<_> = outline.iter().map(|n| n.cross(axis).length().atan2(n.dot(axis))).collect();
    let mean = angles.iter().sum::<f64>() / angles.len() as f64;
    angles.iter().map(|angle| (angle - mean).abs()).fold(0.0, f64::max) * focal_length_px
}

#[test]
fn spheres_keep_a_circular_outline() {
    let ball = Shape::Sphere { centre: [0.0, 3.0, 1.0], radius: 0.8 };
    let scene = PreparedScene::moving(&[Body::new(ball, 600.0)]);
    for view in views() {
        let outline = outline(&scene, &view);
        assert!(outline.len() > 12, "an outline of {} points at {view:?}", outline.len());
        let residual = circle_residual_px(&outline, view.camera.focal_length_px());
        println!(
            "beta {}, T {}: {residual:.1e} px over {} points",
            view.speed.beta(),
            view.observation_time,
            outline.len()
        );
        assert!(residual < 1e-6, "{residual} px off a circle at {view:?}");
    }
}

#[test]
fn a_contracted_sphere_does_not_keep_a_circular_outline() {
    let ball = Shape::Sphere { centre: [0.0, 3.0, 1.0], radius: 0.8 };
    let scene = PreparedScene::moving(&[Body::new(ball, 600.0)]);
    let view = View { geometry: Geometry::Contracted, ..view(0.9, 0.0, [0.0, 3.0, 1.0], 70.0) };
    assert!(circle_residual_px(&outline(&scene, &view), view.camera.focal_length_px()) > 2.0);
}

#[test]
fn tiles_lose_no_body_that_a_single_ray_sees() {
    let bodies = bodies();
    let scene = PreparedScene::moving(&bodies);
    for geometry in [Geometry::Seen, Geometry::OneCone, Geometry::Contracted, Geometry::Rest] {
        for view in views().into_iter().chain(extreme_views()).map(|view| View { geometry, ..view }) {
            let image = scene.hit_image(&view);
            for (pixel, hit) in pixels(&view).zip(&image.hits) {
                assert_eq!(*hit, scene.first_hit(&view, line_of_sight(&view, pixel)), "{view:?}");
            }
        }
    }
}

#[test]
fn where_surfaces_coincide_the_first_body_is_seen() {
    let mut bodies = joints();
    for _ in 0..2 {
        for view in extreme_views() {
            let image = PreparedScene::moving(&bodies).hit_image(&view);
            let [shared, not_first] = shared_pixels(&image, &bodies, &view);
            assert!(shared > 10, "only {shared} pixels show a shared surface at {view:?}");
            assert_eq!(not_first, 0, "of {shared} pixels at {view:?}");
        }
        bodies.reverse();
    }
}

/// In the limit all light comes along the motion: the nearest body must still be distinguished from those
/// behind.
#[test]
fn from_a_gamma_of_a_million_on_the_picture_changes_no_more() {
    let bodies = bodies();
    let scene = PreparedScene::moving(&bodies);
    let views = extreme_views();
    let of = |gamma: f64| {
        let is_seen_close = |view: &&View| view.observation_time > 0.0;
        views.iter().filter(is_seen_close).filter(move |view| view.speed.gamma() == gamma)
    };
    for (fast, faster) in of(1e6).zip(of(MAX_GAMMA)) {
        let numbers =
            |view| scene.hit_image(view).hits.iter().map(|hit| hit.map(|hit| hit.body)).collect::<Vec<_>>();
        let [fast_numbers, faster_numbers] = [fast, faster].map(numbers);
        let differing = fast_numbers.iter().zip(&faster_numbers).filter(|(a, b)| a != b).count();
        println!("T {}: {differing} pixels differ", faster.observation_time);
        assert!(differing <= 2, "{differing} pixels differ at {faster:?}");
    }
}
