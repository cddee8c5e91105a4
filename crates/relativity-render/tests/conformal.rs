//! Conformal pictures by the renderers on the CPU, against formulas of their own.

use glam::{DVec2, DVec3};
use relativity_core::{Aperture, SourcePoint, sighting};
use relativity_render::{
    Appearance, Body, Camera, Method, PreparedScene, Projection, Renderers, Shape, View,
};

use crate::mercator::{self, Chart, FOLLOWED, along, doppler_factor, gamma, pixel_centre, rapidity, views};
use crate::scenes::{still_life, time_seen_at, view_following};
use crate::support::documented;

const RENDERERS: &str = include_str!("../src/renderers.rs");

/// The bound for the reference and for packets, px.
const BOUNDS: [(Method, f64); 2] = [(Method::Reference, 0.01), (Method::Packets, 0.03)];

#[test]
fn u_and_v_are_linear_in_column_and_row() {
    for (method, bound_px) in BOUNDS {
        mercator::u_and_v_are_linear(&mut Renderers::new(None), method, bound_px);
    }
}

#[test]
fn a_ball_keeps_its_outline() {
    for (method, reach_px) in BOUNDS {
        mercator::a_ball_keeps_its_outline(&mut Renderers::new(None), method, reach_px);
    }
}

/// In the reference each pixel shows the same point of the same body as the pixel whole columns further to
/// the right does at rest: it has outlines to 1e-11 px, and none passes as near to the centre of a pixel by
/// chance. Packets are as far off as each of both pictures may be.
#[test]
fn motion_slides_the_picture_and_nothing_else() {
    let renderers = &mut Renderers::new(None);
    let exact = mercator::slid(renderers, Method::Reference, 0.01);
    assert_eq!(exact.differing, 0);
    assert!(exact.farthest < 1e-9, "{exact:?}");
    let wrong_percent = documented(RENDERERS, "the body differs at fewer than ");
    let packets = mercator::slid(renderers, Method::Packets, documented(RENDERERS, "all of them within "));
    assert!(packets.differing as f64 <= 0.02 * wrong_percent * packets.shown as f64, "{packets:?}");
}

/// The left and the right eye see a point in the same row of their pictures, as far apart as for resting eyes
/// gamma times as far apart; so does the core's light cone.
#[test]
fn both_eyes_see_a_point_in_one_row() {
    let scene = PreparedScene::moving(&still_life());
    for view in views() {
        let [_, right] = Aperture::pair(0.2);
        let other = View {
            camera: Camera { aperture: right, off_middle: DVec3::X * right.x, ..view.camera },
            ..view
        };
        let chart = Chart::new(&view);
        let image = scene.hit_image(&view);
        for (i, hit) in image.hits.iter().enumerate().filter_map(|(i, hit)| Some((i, (*hit)?))) {
            let here = pixel_centre(&image, i);
            let point = SourcePoint::from_rest(hit.rest_position.to_array(), &view.speed);
            let there = sighting(&view.speed, point, right, view.observation_time).expect("in the domain");
            let there = other.camera.pixel(there.position.into()).expect("off the baseline");
            let context = format!("gamma {}: {here} and {there:?}", view.speed.gamma());
            assert!((there[1] - here.y).abs() < 0.01, "{context}");
            let rho = hit.rest_position.y.hypot(hit.rest_position.z);
            let columns = [&view, &other].map(|view| (along(view, hit.rest_position) / rho).asinh());
            let apart = (columns[0] - columns[1]) * chart.px_per_unit;
            assert!((here.x - there[0] - apart).abs() < 0.01, "{context}: {apart} px apart");
        }
    }
}

/// D depends on the column alone; the emission time follows from u, too.
#[test]
fn the_column_tells_the_doppler_factor() {
    let scene = PreparedScene::moving(&still_life());
    let (mut most, mut most_time) = (0.0f64, 0.0f64);
    for view in views() {
        let (chart, speed) = (Chart::new(&view), &view.speed);
        let image = scene.hit_image(&view);
        for (i, hit) in image.hits.iter().enumerate().filter_map(|(i, hit)| Some((i, (*hit)?))) {
            let u = chart.coordinates(pixel_centre(&image, i)).x;
            let expected = doppler_factor(speed, u);
            most = most.max((hit.doppler_factor / expected - 1.0).abs());
            let rho = hit.rest_position.y.hypot(hit.rest_position.z);
            let received = speed.gamma() * (view.observation_time - speed.beta() * view.camera.aperture.x);
            let distance = rho * (u + rapidity(speed)).cosh();
            let off = [
                (hit.emission_time - (view.observation_time - rho * u.cosh())) / (rho * u.cosh()),
                (hit.proper_time - (received - distance)) / distance.max(received.abs()),
            ];
            most_time = off.into_iter().fold(most_time, |most, off| most.max(off.abs()));
        }
    }
    println!("D off by {most:e}, times by {most_time:e} of themselves");
    assert!(most < 2e-6, "D is off by {most:e} of itself");
    assert!(most_time < 2e-6, "times are off by {most_time:e} of themselves");
}

/// At gamma = 1e30 a body's own length counts for nothing: u = ln(T/rho), and a ball is seen where the ball's
/// disc, across the motion, is, from the end that is ahead.
#[test]
fn the_greatest_gamma_gives_the_picture_of_the_limit() {
    let speed = gamma(1e30);
    let (centre, radius) = (DVec3::from(FOLLOWED), 0.6);
    let body = Body::new(Shape::Sphere { centre: FOLLOWED, radius }, 600.0);
    let scene = PreparedScene::moving(&[body]);
    let mut renderers = Renderers::new(None);
    for (along, method) in [-2.0, 0.0, 1.5]
        .into_iter()
        .flat_map(|along| [Method::Reference, Method::Packets].map(|method| (along, method)))
    {
        let mut view = view_following(FOLLOWED, speed, time_seen_at(FOLLOWED, &speed, along), 100.0);
        view.camera.projection = Projection::Mercator { right: DVec3::X, shift: 0.0 };
        let chart = Chart::new(&view);
        let image = renderers.hits(method, &scene, &view).expect("the CPU draws it");
        let (mut shown, context) = (0, format!("{method}, along {along}"));
        for (i, hit) in image.hits.iter().enumerate() {
            let DVec2 { x: u, y: v } = chart.coordinates(pixel_centre(&image, i));
            let rho = view.observation_time * (-u).exp();
            let off = DVec2::new(rho * v.cos() - centre.y, rho * v.sin() - centre.z).length();
            // A hundredth of a pixel.
            let is_at_edge = (off - radius).abs() < 0.01 * rho / chart.px_per_unit;
            assert!(is_at_edge || hit.is_some() == (off < radius), "{context}: {off} from the middle");
            let Some(hit) = hit else { continue };
            shown += 1;
            let expected = doppler_factor(&speed, u);
            assert!((hit.doppler_factor / expected - 1.0).abs() < 1e-5, "{context}: {}", hit.doppler_factor);
            assert!((hit.distance / (rho * u.cosh()) - 1.0).abs() < 1e-5, "{context}: {}", hit.distance);
            if !is_at_edge && off < 0.99 * radius {
                let x = centre.x - (radius * radius - off * off).sqrt();
                assert!((hit.rest_position.x - x).abs() < 1e-4, "{context}: {} for {x}", hit.rest_position.x);
            }
        }
        assert!(shown > 500, "{context}: {shown}");
        let appearance = Appearance { ground_z: Some(-1.0), ..Appearance::default() };
        assert!(renderers.picture(method, &scene, &view, &appearance, 1).is_ok(), "{context}");
    }
}
