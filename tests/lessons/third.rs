//! Lessons 4 to 6: how fast bodies look, their colour and their brightness.

use std::f64::consts::FRAC_PI_2;

use gamow::lesson::AnswerKind;
use relativity_core::aberration::{ground_from_rest, rest_from_ground};
use relativity_core::{Aperture, Sighting, SourcePoint, Speed, sighting};

use super::support::lesson;
use super::told::{number, observed, right, says, settings};

/// The left eye of the usual pair.
const LEFT: Aperture = Aperture { x: -0.05, y: 0.0, z: 0.0 };

fn speed(beta: f64) -> Speed {
    Speed::from_beta(beta).expect("a speed")
}

/// What the left eye sees at `time` of a point at this place in its own frame.
fn seen(beta: f64, rest: [f64; 3], time: f64) -> Sighting {
    let speed = speed(beta);
    sighting(&speed, SourcePoint::from_rest(rest, &speed), LEFT, time).expect("in the domain")
}

fn doppler(beta: f64, rest: [f64; 3], time: f64) -> f64 {
    seen(beta, rest, time).doppler_factor
}

/// Azimuths of the four upright edges of a die of edge 2 whose front passes x = 0 at t = 0, by which of its
/// ends it is (rear, front) and by its side (near, far), where its middle passes `y` away.
fn edges(beta: f64, y: f64, time: f64) -> [[f64; 2]; 2] {
    [-2.0, 0.0].map(|x| [y - 1.0, y + 1.0].map(|y| seen(beta, [x, y, 0.0], time).phi()))
}

#[test]
fn from_far_a_die_shows_its_rear_and_looks_turned_by_arcsin_beta() {
    let l = lesson("turned");
    // Azimuths grow to the left.
    let [[rear_near, rear_far], [front_near, front_far]] = edges(0.8, 22.0, 22.6);
    assert!(rear_far > rear_near, "the rear face is seen");
    assert!(front_far > front_near, "the front face is hidden behind the side");
    assert_eq!(right(&l, 0), "the five, and the six on its rear");
    assert!(rear_far - rear_near > rear_near - front_near);
    assert_eq!(observed(&l, 0), "the six");

    // The limit of far away: faces of a cube turned by arcsin 0.8, which is 53.1 degrees (Commun. Phys. 8,
    // 161).
    let [[near, far], [front, _]] = edges(0.8, 1e5, 1e5);
    let [six, five] = [far - near, near - front].map(|angle| angle * 1e5 / 2.0);
    assert!((six - 0.8).abs() < 1e-3 && (five - 0.6).abs() < 1e-3, "{six}, {five}");
    assert!((number(&l, 1) - six.atan2(five).to_degrees()).abs() < 0.05);
    assert!((number(&l, 1) - 53.1).abs() < 0.05);
    assert_eq!(observed(&l, 1), "no, it looks like a turned cube");
    says(&l, 1, r"\beta L = {} \, L", six, 1);
    says(&l, 1, r"\frac{L}{\gamma} = {} \, L", five, 1);
    says(&l, 1, "{}$ degrees", six.atan2(five).to_degrees(), 1);
    says(&l, 2, "{} units away, eleven times its edge", 11.0 * 2.0, 0);
}

#[test]
fn from_nearby_upright_edges_of_a_die_are_bent() {
    let l = lesson("turned");
    let bulge = |y: f64, time: f64| {
        let [middle, end] = [0.0, 1.0].map(|z| seen(0.8, [-2.0, y - 1.0, z], time));
        assert!(end.distance > middle.distance && end.retarded_time < middle.retarded_time);
        (middle.position[0] - end.position[0]) / 2.0
    };
    let [near, far] = [bulge(6.0, 6.0), bulge(22.0, 22.6)];
    // Abreast, what is further away by so much left it earlier by as much, and further back by beta of that.
    let expected = 0.8 * (26.0_f64.sqrt() - 5.0) / 2.0;
    assert!((near / expected - 1.0).abs() < 0.15, "the middle is seen further ahead: {near}, {expected}");
    assert!(far < near / 3.0, "{far}");
    assert_eq!(right(&l, 2), "bent");
    assert_eq!(observed(&l, 2), "forward, at its middle");
}

#[test]
fn a_globe_keeps_a_round_outline() {
    let l = lesson("turned");
    let speed = speed(0.999);
    // As it is seen abreast, its outline in its own frame is a circle on the sky about the direction of its
    // centre.
    let centre = seen(0.999, [-1.5, 22.0, 0.0], 22.07);
    let distance = centre.distance;
    let axis = rest_from_ground(centre.position.map(|x| x / distance), &speed);
    let from_rest = 1.5 / (distance * speed.gamma() * (1.0 + 0.999 * centre.position[0] / distance));
    let up = [0.0, 0.0, 1.0];
    let aside = [axis[1], -axis[0], 0.0];
    let (sin, cos) = from_rest.asin().sin_cos();
    let outline: Vec<[f64; 3]> = (0..12)
        .map(|part| {
            let (s, c) = (f64::from(part) * FRAC_PI_2 / 3.0).sin_cos();
            let rest = [0, 1, 2].map(|k| cos * axis[k] + sin * (c * aside[k] + s * up[k]));
            ground_from_rest(rest, &speed)
        })
        .collect();
    // A circle on a sphere lies in a plane.
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let from = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|k| a[k] - b[k]);
    let [u, v] = [from(outline[4], outline[0]), from(outline[8], outline[0])];
    let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = dot(normal, normal).sqrt();
    for direction in &outline {
        let off = dot(from(*direction, outline[0]), normal) / length;
        assert!(off.abs() < 1e-9, "{off}");
    }
    // It comes, passes and goes.
    let [before, after] = [14.0, 30.0].map(|time| seen(0.999, [-1.5, 22.0, 0.0], time).position[0]);
    assert!(before < -1.5 && after > 1.5, "{before}, {after}");
    assert_eq!(settings(&l, 3, true).time, Some(30.0));
    assert_eq!(right(&l, 3), "a circle");
    assert_eq!(observed(&l, 3), "no, it was round all the time");
    says(&l, 3, "{} times as thick as it is high", (1.0_f64 - 0.999 * 0.999).sqrt(), 3);
    // The part that faces the eyes is its rear: in its own frame the eyes are seen far behind it.
    let behind = axis[0].atan2(axis[1]).to_degrees();
    assert!((behind - 87.0).abs() < 1.0, "{behind}");
    says(&l, 3, "abreast it looks turned by {} degrees, and you see its rear", 87.0, 0);
}

/// The front of the front tyre, the rear of the rear tyre, with the shift of the lesson.
const FRONT: [f64; 3] = [0.0, 3.0, 0.0];
const REAR: [f64; 3] = [-2.63, 3.0, 0.0];

#[test]
fn colours_run_from_blue_at_the_rear_to_infrared_at_the_front() {
    let l = lesson("colour");
    let received = |x: f64| 700.0 / doppler(0.9, [x, 3.0, 0.0], 1.6);
    let along: Vec<f64> = (0..=20).map(|part| received(REAR[0] * (1.0 - f64::from(part) / 20.0))).collect();
    assert!(along.is_sorted_by(|a, b| a < b));
    assert!((380.0..480.0).contains(&along[0]), "violet or blue: {}", along[0]);
    assert!(along[20] > 780.0, "infrared: {}", along[20]);
    assert!(along.iter().any(|nm| (500.0..560.0).contains(nm)), "green");
    assert_eq!(right(&l, 0), "its rear");
    assert_eq!(observed(&l, 0), "from blue and violet through green to red");
    says(&l, 0, "At the front tyre D = {}:", doppler(0.9, FRONT, 1.6), 2);
    says(&l, 0, ": {} nm is infrared", along[20], 0);
    assert!(seen(0.9, REAR, 1.6).phi() > seen(0.9, FRONT, 1.6).phi(), "the rear is further to the left");
}

#[test]
fn the_doppler_factor_falls_through_1_before_the_point_is_seen_abreast() {
    let l = lesson("colour");
    let curve: Vec<f64> = (0..=1000).map(|k| doppler(0.9, FRONT, -20.0 + f64::from(k) * 0.05)).collect();
    assert!(curve.is_sorted_by(|a, b| a > b), "it falls without a stop");
    let limit = (1.9_f64 / 0.1).sqrt();
    assert!((doppler(0.9, FRONT, -1e5) - limit).abs() < 1e-6);
    assert!((doppler(0.9, FRONT, 1e5) - 1.0 / limit).abs() < 1e-6);
    says(&l, 1, r"\sqrt{\frac{1+\beta}{1-\beta}} = {}", limit, 2);
    // D = 1 by bisection.
    let (mut from, mut to) = (-20.0, 20.0);
    for _ in 0..60 {
        let middle = f64::midpoint(from, to);
        if doppler(0.9, FRONT, middle) > 1.0 { from = middle } else { to = middle }
    }
    // The middle between the eyes is 3 from it as it passes.
    assert!(from < 3.0);
    says(&l, 1, "It passes 1 at T = {}, while", from, 2);
    says(&l, 1, "it is seen abreast only at T = {}.", 3.0, 2);
    assert_eq!(observed(&l, 1), "before it is seen abreast");
    let kind = &l.steps[1].prediction.as_ref().expect("a prediction").kind;
    let AnswerKind::Curve(drawn) = kind else { panic!("{kind:?} is no curve") };
    assert!(drawn.range[0] < 1.0 / limit && drawn.range[1] > limit, "the curve can be drawn");
}

#[test]
fn as_it_is_seen_abreast_waves_are_gamma_times_as_long() {
    let l = lesson("colour");
    let at_abreast = seen(0.9, FRONT, 2.945);
    assert!((at_abreast.position[0]).abs() < 0.01, "T of the lesson is that of abreast");
    let gamma = 1.0 / (1.0_f64 - 0.81).sqrt();
    assert!((number(&l, 2) / (700.0 * gamma) - 1.0).abs() < 5e-3, "{}", number(&l, 2));
    says(&l, 2, "= {}", 1.0 / gamma, 3);
    says(&l, 2, "{} times as long", gamma, 2);
    assert_eq!(observed(&l, 2), "below 1");
}

#[test]
fn a_white_hot_body_stays_in_sight() {
    let l = lesson("colour");
    let d = doppler(0.9, FRONT, 5.0);
    says(&l, 3, "{} K now", 6500.0 * d, 0);
    // What glows is seen from about 798 K on (Draper); below 4000 K its colour is warm.
    assert!((798.0..4000.0).contains(&(6500.0 * d)));
    assert!(550.0 * d < 380.0, "green was ultraviolet");
    assert!(700.0 / d > 780.0, "while the red one is infrared");
    assert_eq!(right(&l, 3), "reddish: its ultraviolet becomes visible");
    assert_eq!(observed(&l, 3), "yes, in a warm colour");
}

#[test]
fn dice_that_come_are_brightest_by_the_fourth_power() {
    let l = lesson("headlight");
    let along: Vec<f64> = (0..=13).map(|x| doppler(0.9, [-f64::from(x), 6.0, 0.0], 8.0)).collect();
    assert!(along.is_sorted_by(|a, b| a < b), "the further behind, the brighter");
    assert!(seen(0.9, [-13.0, 6.0, 0.0], 8.0).position[0] < 0.0, "the last still comes");
    assert_eq!(right(&l, 0), "those at the left, which still come");
    assert_eq!(observed(&l, 0), "at the right");
    let rod = doppler(0.9, [0.0, 6.0, -1.0], 8.0);
    says(&l, 0, "received {} times as bright as at rest", rod.powi(4), 3);

    // A patch of sky about a line of sight is smaller than at rest by D squared.
    let s = speed(0.9);
    for angle in [0.4_f64, 1.3, 2.6] {
        let ground = [angle.cos(), angle.sin(), 0.0];
        let d = 1.0 / (s.gamma() * (1.0 + 0.9 * ground[0]));
        let rest_cos = |angle: f64| rest_from_ground([angle.cos(), angle.sin(), 0.0], &s)[0];
        let step = 1e-5;
        let at_rest = rest_cos(angle - step) - rest_cos(angle + step);
        let here = (angle - step).cos() - (angle + step).cos();
        assert!((here / at_rest * d * d - 1.0).abs() < 1e-6, "{angle}");
    }
    assert_eq!(right(&l, 1), "1/16 of that at rest");
    assert_eq!(observed(&l, 1), "more steeply than with $D^2$");
}

#[test]
fn the_edge_of_the_beam_is_at_arccos_beta_and_shows_the_side_straight_on() {
    let l = lesson("headlight");
    let s = speed(0.9);
    // A line of sight that is abeam in the die's frame: light goes the other way.
    let [x, y, _] = ground_from_rest([0.0, 1.0, 0.0], &s);
    let angle = y.atan2(-x);
    assert!((angle.sin() * s.gamma() - 1.0).abs() < 1e-12);
    says(&l, 2, r"\arccos \beta = {}^\circ", angle.to_degrees(), 0);
    // Photons go evenly in its own frame: half of them into this cone on the ground, half out of it.
    let forward = (0..100_000)
        .filter(|k| {
            let cos = -1.0 + (f64::from(*k) + 0.5) / 50_000.0;
            let sight = ground_from_rest([-cos, (1.0 - cos * cos).sqrt(), 0.0], &s);
            -sight[0] > angle.cos()
        })
        .count();
    assert!(forward.abs_diff(50_000) <= 1, "{forward}");

    let place = SourcePoint::from_rest([-1.0, 4.0, 0.0], &s);
    let middle = sighting(&s, place, Aperture::default(), 0.484).expect("in the domain");
    let cos = -middle.position[0] / middle.distance;
    assert!((cos - 0.9).abs() < 1e-3, "its middle is on the edge between the eyes: {cos}");
    let [[rear_near, rear_far], [front_near, front_far]] = edges(0.9, 4.0, 0.484);
    assert!(rear_far < rear_near && front_far > front_near, "rear and front are hidden");
    assert_eq!(observed(&l, 2), "the five on its side, straight on");
    let [_, [near, far]] = edges(0.9, 4.0, -2.0);
    assert!(far < near, "before, the front is seen");
    let kind = &l.steps[2].prediction.as_ref().expect("a prediction").kind;
    assert!(matches!(kind, AnswerKind::Point(point) if point.body == "die"), "{kind:?}");
}

#[test]
fn what_comes_is_130_000_times_as_bright_as_what_goes() {
    let l = lesson("headlight");
    // Along the line of motion, seen from far ahead and far behind.
    let [coming, going] = [-1e6, 1e6].map(|time| doppler(0.9, [0.0, 0.0, 0.0], time));
    says(&l, 3, "D = {}, straight behind the inverse", coming, 2);
    assert!((coming * going - 1.0).abs() < 1e-9);
    assert!((coming / going - 19.0).abs() < 1e-9);
    let ratio = (coming / going).powi(4);
    assert!((ratio - 130_321.0).abs() < 0.5);
    says(&l, 3, "19^4 = {}", ratio, 0);
    assert_eq!(right(&l, 3), "about 130,000 times");
    let last = doppler(0.9, [-13.0, 6.0, 0.0], 16.0);
    let first = doppler(0.9, [0.0, 6.0, 0.0], 3.0);
    assert!(last.powi(4) < 0.1 && first > last, "{first}, {last}");
    assert_eq!(observed(&l, 3), "next to nothing: they are nearly black");
}
