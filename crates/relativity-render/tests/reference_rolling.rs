//! A rolling wheel in the reference's hits, against what is known of it.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DVec2, DVec3};
use relativity_core::{Aperture, Speed, Turning};
use relativity_render::{
    Appearance, Body, Camera, Gaze, Geometry, Hit, MaterialPoint, Motion, PreparedScene, Shape, Spin, View,
};

const HUB: DVec3 = DVec3::new(-0.525, 3.0, 2.0);
const RADIUS: f64 = 0.525;

fn spin(hub: DVec3) -> Spin {
    Spin { hub: hub.to_array(), radius: RADIUS, turning: Turning::Rolling }
}

/// On the rim in the wheel's plane, `rho` radii from the hub.
fn on_wheel(hub: DVec3, rho: f64, angle: f64) -> DVec3 {
    hub + rho * RADIUS * DVec3::new(angle.cos(), 0.0, angle.sin())
}

fn spoke(hub: DVec3, angle: f64, radius: f64) -> Body {
    let [from, to] = [0.1, 1.0 - radius / RADIUS].map(|rho| on_wheel(hub, rho, angle).to_array());
    Body::new(Shape::Tube { from, to, radius }, 600.0).turning(spin(hub))
}

fn tyre(hub: DVec3) -> Body {
    let tube_radius = 0.03;
    let axis = [0.0, 1.0, 0.0];
    let shape = Shape::Ring { centre: hub.to_array(), axis, radius: RADIUS - tube_radius, tube_radius };
    Body::new(shape, 600.0).turning(spin(hub))
}

fn view(beta: f64, observation_time: f64, geometry: Geometry) -> View {
    let camera = Camera::new(Aperture::default(), Gaze::STRAIGHT_AHEAD, 1.0, [640, 480]);
    View { camera, speed: Speed::from_beta(beta).expect("below 1"), observation_time, geometry }
}

/// Towards what is at `place` in the wheel's frame when the view shows it.
fn towards(view: &View, place: DVec3) -> DVec3 {
    view.apparent_position(place).expect("inside the domain").normalize()
}

fn where_it_is(view: &View, point: DVec3, hub: DVec3) -> DVec3 {
    let point = MaterialPoint { rest: point, spin: Some(spin(hub)) };
    view.apparent_position(point).expect("inside the domain")
}

#[test]
fn what_is_on_the_road_rests_and_has_the_doppler_factor_1() {
    // The camera is below the road, which is glass.
    let road = HUB - DVec3::Z * RADIUS;
    for beta in [0.1, 0.5, 0.9, 0.93, 0.99, 0.999] {
        for time in [-3.0, 0.0, 2.5, 3.605, 8.0] {
            let view = view(beta, time, Geometry::Seen);
            let proper_time = view.of_group(Motion::Scene).time_at(road);
            let down = spoke(HUB, -FRAC_PI_2 + beta / RADIUS * proper_time, 0.01);
            for body in [tyre(HUB), down] {
                let scene = PreparedScene::moving(&[body]);
                let hit = scene.first_hit(&view, towards(&view, road)).expect("it touches the road there");
                assert!(hit.rest_position.distance(road) < 1e-11, "{:?}", hit.rest_position);
                let off = (hit.doppler_factor - 1.0).abs();
                assert!(off < 1e-12, "{off:e} at beta = {beta}, T = {time}");
            }
        }
    }
}

#[test]
fn the_top_of_the_tyre_moves_at_two_beta_over_one_plus_beta_squared() {
    for beta in [0.1, 0.5, 0.93, 0.999] {
        let scene = PreparedScene::moving(&[tyre(HUB)]);
        let view = |time| view(beta, time, Geometry::Contracted);
        let place = |hit: &Hit, line_of_sight: DVec3| line_of_sight * hit.distance;
        // From above, so that the top is in sight.
        let above = |view: View| {
            let aperture = Aperture { x: -0.4, y: 3.0, z: 5.0 };
            View { camera: Camera { aperture, ..view.camera }, ..view }
        };
        let step = 1e-6;
        let [before, after] = [-step, step].map(|time| above(view(time)));
        let top = HUB + DVec3::Z * RADIUS;
        // The point that is at the top at T = 0, found by its angle.
        let now = above(view(0.0));
        let hit = scene.first_hit(&now, towards(&now, top)).expect("the top");
        assert!(hit.rest_position.distance(top) < 1e-12);
        let [from, to] = [before, after].map(|view| {
            let line_of_sight = where_it_is(&view, hit.material_position, HUB).normalize();
            let there = scene.first_hit(&view, line_of_sight).expect("the same point");
            assert!(there.material_position.distance(hit.material_position) < 1e-7 * RADIUS);
            place(&there, line_of_sight)
        });
        let speed = (to.x - from.x) / (2.0 * step);
        let expected = 2.0 * beta / (1.0 + beta * beta);
        assert!((speed - expected).abs() < 1e-7, "{speed} instead of {expected}");
    }
}

#[test]
fn the_measured_spokes_crowd_at_the_top_by_1_plus_beta_squared_over_1_minus_it() {
    let beta = 0.93;
    let view = view(beta, 1.3, Geometry::Contracted);
    let group_view = view.of_group(Motion::Scene);
    // Two spokes this far apart, where they are shown at `angle`: how far apart they are shown, halfway out
    // and at the rim.
    let apart = 1e-4;
    let shown = |angle: f64, rho: f64| {
        let turned = beta / RADIUS * group_view.time_at(on_wheel(HUB, rho, angle));
        let places = [-0.5, 0.5].map(|side| {
            let scene = PreparedScene::moving(&[spoke(HUB, angle + turned + side * apart, 4e-4)]);
            let hits = |at: f64| scene.first_hit(&view, towards(&view, on_wheel(HUB, rho, at))).is_some();
            assert!(hits(angle));
            let edge = |towards: f64| {
                let [mut inside, mut outside] = [angle, angle + towards];
                for _ in 0..50 {
                    let middle = 0.5 * (inside + outside);
                    if hits(middle) { inside = middle } else { outside = middle }
                }
                inside
            };
            0.5 * (edge(-0.5) + edge(0.5))
        });
        places[1] - places[0]
    };
    let rho = 0.98;
    let ratio = shown(-FRAC_PI_2, rho) / shown(FRAC_PI_2, rho);
    let squared = beta * beta * rho;
    let expected = (1.0 + squared) / (1.0 - squared);
    assert!((ratio / expected - 1.0).abs() < 1e-3, "{ratio} instead of {expected}");
    // At the rim itself, from the marks on the tyre: which point of it is shown where.
    let scene = PreparedScene::moving(&[tyre(HUB)]);
    let material = |angle: f64| {
        // Its side that faces the camera is this far from the axle.
        let place = on_wheel(HUB, 1.0 - 0.03 / RADIUS, angle) - 0.03 * DVec3::Y;
        let hit = scene.first_hit(&view, towards(&view, place)).expect("the tyre");
        let off = hit.material_position - HUB;
        off.z.atan2(off.x)
    };
    let density = |angle: f64| {
        let [one, other] = [-1e-4, 1e-4].map(|step| material(angle + step));
        (other - one + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0
    };
    let ratio = density(FRAC_PI_2) / density(-FRAC_PI_2);
    let squared = beta * beta * (1.0 - 0.03 / RADIUS);
    let expected = (1.0 + squared) / (1.0 - squared);
    assert!((ratio / expected - 1.0).abs() < 1e-4, "{ratio} instead of {expected}");
}

#[test]
fn spokes_are_straight_where_they_are_seen_along_the_axle() {
    // At the height of the eye, a hundred radii away.
    let hub = DVec3::new(-0.2, 100.0 * RADIUS, 0.0);
    for beta in [0.5, 0.93, 0.99] {
        let mut view = view(beta, 0.0, Geometry::Seen);
        let gamma = view.speed.gamma();
        // o_x = -gamma beta T is that of the hub.
        view.observation_time = -hub.x / (gamma * beta);
        let middle = towards(&view, hub);
        // The wheel is ninety pixels wide.
        let gaze = Gaze::along(middle.to_array());
        view.camera = Camera::new(Aperture::default(), gaze, 0.01 * 320.0 / 45.0 / gamma, [320, 240]);
        let doppler = view.of_group(Motion::Scene).rest_ray(middle).doppler_factor;
        assert!((doppler / gamma - 1.0).abs() < 1e-9);
        let pixel = |place: DVec3| DVec2::from(view.camera.pixel(towards(&view, place)).expect("in front"));
        let width = pixel(on_wheel(hub, 1.0, 0.0)).distance(pixel(on_wheel(hub, 1.0, TAU / 2.0)));
        assert!((89.0..91.0).contains(&width), "{width} px");
        let mut worst: f64 = 0.0;
        for i in 0..36 {
            let scene = PreparedScene::moving(&[spoke(hub, f64::from(i) * TAU / 36.0, 0.004)]);
            let group_view = view.of_group(Motion::Scene);
            let centre = |rho: f64| {
                let on_axis = MaterialPoint {
                    rest: on_wheel(hub, rho, f64::from(i) * TAU / 36.0),
                    spin: Some(spin(hub)),
                };
                let near = group_view.place_when_shown(on_axis) - hub;
                let angle = near.z.atan2(near.x);
                let hits =
                    |angle: f64| scene.first_hit(&view, towards(&view, on_wheel(hub, rho, angle))).is_some();
                let edge = |towards: f64| {
                    let [mut inside, mut outside] = [angle, angle + towards];
                    assert!(hits(inside) && !hits(outside));
                    for _ in 0..40 {
                        let middle = 0.5 * (inside + outside);
                        if hits(middle) { inside = middle } else { outside = middle }
                    }
                    inside
                };
                pixel(on_wheel(hub, rho, 0.5 * (edge(-0.3) + edge(0.3))))
            };
            let [first, last] = [centre(0.15), centre(0.95)];
            let along = (last - first).normalize();
            for step in 1..8 {
                let place = centre(0.15 + 0.1 * f64::from(step));
                worst = worst.max((place - first).perp_dot(along).abs());
            }
        }
        // What is rho radii from the hub is seen later by rho^2 radii/200, when it has turned by beta
        // rho^2/200: aside by beta rho^3/200 radii. Aberration bends what is upright by as much as beta
        // rho^2/200.
        let aside = |rho: f64| beta * (rho.powi(3) + rho.powi(2)) / 200.0 * 45.0;
        let chord = |rho: f64| aside(0.15) + (aside(0.95) - aside(0.15)) / 0.8 * (rho - 0.15);
        let expected = (1..8).map(|step| 0.15 + 0.1 * f64::from(step)).map(|rho| chord(rho) - aside(rho));
        let expected = expected.fold(0.0, f64::max);
        assert!((worst / expected - 1.0).abs() < 0.05, "{worst} px instead of {expected} at beta = {beta}");
        assert!(worst < 0.1, "a spoke is {worst} px off its line at beta = {beta}");
    }
}

#[test]
fn a_tyre_is_received_in_the_bands_in_which_its_pixels_are() {
    let scene = PreparedScene::moving(&[tyre(HUB)]);
    let appearance = Appearance::default();
    for (beta, time) in [(0.5, 1.0), (0.9, 3.6), (0.93, 2.5), (0.93, 5.0)] {
        let mut view = view(beta, time, Geometry::Seen);
        let middle = view.apparent_position(HUB).expect("inside the domain");
        view.camera.gaze = Gaze::along(middle.to_array());
        let [shares] = scene.received_shares(&view, &appearance)[..] else { panic!("it is one group") };
        // Ultraviolet, visible, infrared: of 600 nm.
        let mut counts = [0.0; 3];
        for hit in scene.hit_image(&view).hits.into_iter().flatten() {
            let received_nm = 600.0 / hit.doppler_factor;
            counts[usize::from(received_nm > 380.0) + usize::from(received_nm > 750.0)] += 1.0;
        }
        let all: f64 = counts.iter().sum();
        for (band, share) in shares.into_iter().enumerate() {
            let expected = counts[band] / all;
            assert!(
                (share - expected).abs() < 0.15,
                "{shares:?}, of pixels {counts:?}, at beta = {beta}, T = {time}"
            );
        }
    }
}
