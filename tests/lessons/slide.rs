//! The lesson of the slide: its numbers, from the core's sightings of points and of outlines.

use gamow::lesson::AnswerKind;
use relativity_core::aberration::{ground_from_rest, rest_from_ground};
use relativity_core::{Aperture, Sighting, SourcePoint, Speed, sighting};

use super::support::lesson;
use super::told::{number, observed, right, says, settings, words};

/// The single eye of the lesson: both are in one place.
const EYE: Aperture = Aperture { x: 0.0, y: 0.0, z: 0.0 };

fn seen(beta: f64, rest: [f64; 3], time: f64) -> Sighting {
    let speed = Speed::from_beta(beta).expect("a speed");
    sighting(&speed, SourcePoint::from_rest(rest, &speed), EYE, time).expect("in the domain")
}

/// Column and row of a direction or a place, from the definition of the projection.
fn coordinates([x, y, z]: [f64; 3]) -> [f64; 2] {
    [(x / y.hypot(z)).asinh(), z.atan2(y)]
}

/// The corners of the lesson's die, from the eyes: edge 2, its near side 3 away.
fn corners() -> impl Iterator<Item = [f64; 3]> {
    (0..8).map(|corner| {
        [-2.0 * f64::from(corner & 1), 3.0 + f64::from(corner & 2), f64::from(corner / 4) * 2.0 - 1.0]
    })
}

#[test]
fn a_die_is_seen_where_it_would_rest_moved_back_by_its_rapidity() {
    let l = lesson("slide");
    for beta in [0.5_f64, 0.8, 0.9, 0.99] {
        for corner in corners() {
            let [u, v] = coordinates(seen(beta, corner, 0.0).position);
            let [at_rest, row] = coordinates(corner);
            assert!((u - (at_rest - beta.atanh())).abs() < 1e-12 && (v - row).abs() < 1e-12, "{corner:?}");
        }
    }
    assert_eq!(observed(&l, 0), "it moved to the left, and kept its shape");
    says(&l, 0, "= {}", 0.5_f64.atanh(), 3);
    let state = settings(&l, 0, true);
    assert_eq!((state.speed().beta(), state.time, state.motion.d), (0.5, Some(0.0), 0.0));
    assert!(state.window.resting && state.window.ruler);
    let kind = &l.steps[0].prediction.as_ref().expect("a prediction").kind;
    assert!(matches!(kind, AnswerKind::Point(point) if point.body == "die"), "{kind:?}");
    // The selected edge: at rest straight ahead, and measured there at t = 0.
    let scene = state.opened_scene().expect("a scene");
    let edge = state.disparity(&state.track(&scene), 0.0).expect("seen").primary;
    let [u, v] = coordinates(edge.position);
    assert!((u + 0.5_f64.atanh()).abs() < 1e-12 && v == 0.0, "{u}, {v}");
    let resting = settings(&l, 0, false).disparity(&state.track(&scene), 0.0).expect("seen").primary;
    assert_eq!(resting.position.map(|x| x + 0.0), [0.0, 3.0, 0.0]);
}

#[test]
fn the_arrow_is_as_long_as_the_rapidity() {
    let l = lesson("slide");
    assert!((number(&l, 1) - 0.9_f64.atanh()).abs() < 1e-12);
    says(&l, 1, "At 0.5 c the arrow is {} long", 0.5_f64.atanh(), 3);
    says(&l, 1, r"\tanh {} = 0.9", 0.9_f64.atanh(), 3);
    says(&l, 1, "At 0.99 c the arrow is {} long", 0.99_f64.atanh(), 3);
    says(&l, 1, "at 0.999 c it is {} long", 0.999_f64.atanh(), 3);
    let added = [0.99_f64, 0.999, 0.9999, 0.99999].map(f64::atanh);
    assert!(added.windows(2).all(|pair| (pair[1] - pair[0] - 1.15).abs() < 0.01), "{added:?}");
    assert!(words(&l, 1).contains("every extra 9 adds about 1.15"));
    assert_eq!(observed(&l, 1), "at 0.9 c");
    assert!((coordinates(seen(0.9, [0.0, 3.0, 0.0], 0.0).position)[0] + 0.9_f64.atanh()).abs() < 1e-12);
}

/// Width and height, in u and v, of what is seen at this speed and T of the globe: radius 1.5, passing 6
/// away.
fn outline(beta: f64, time: f64) -> [f64; 2] {
    let speed = Speed::from_beta(beta).expect("a speed");
    let centre = seen(beta, [-1.5, 6.0, 0.0], time);
    let axis = rest_from_ground(centre.position.map(|x| x / centre.distance), &speed);
    // In its own frame a ball has a circle about its centre for its outline.
    let distance = 6.0 / axis[1].hypot(axis[2]);
    let (sin, cos) = (1.5 / distance).asin().sin_cos();
    let aside = [axis[1], -axis[0], 0.0];
    let around = (0..7200).map(|part| {
        let (s, c) = (f64::from(part) * std::f64::consts::TAU / 7200.0).sin_cos();
        let rest =
            [cos * axis[0] + sin * c * aside[0], cos * axis[1] + sin * c * aside[1], cos * axis[2] + sin * s];
        coordinates(ground_from_rest(rest, &speed))
    });
    let around: Vec<_> = around.collect();
    [0, 1].map(|k| {
        let all = around.iter().map(|place| place[k]);
        all.clone().fold(f64::MIN, f64::max) - all.fold(f64::MAX, f64::min)
    })
}

#[test]
fn a_globe_has_one_outline_all_the_way() {
    let l = lesson("slide");
    for beta in [0.0, 0.9, 0.999] {
        for time in [-1.5, 0.0, 4.0, 14.0] {
            let [width, height] = outline(beta, time);
            assert!((width - 2.0 * 0.25_f64.atanh()).abs() < 1e-5, "{beta} {time}: {width}");
            assert!((height - 2.0 * 0.25_f64.asin()).abs() < 1e-5, "{beta} {time}: {height}");
        }
    }
    says(&l, 2, "it is {} wide", 2.0 * 0.25_f64.atanh(), 3);
    says(&l, 2, "and {} high", 2.0 * 0.25_f64.asin(), 3);
    assert_eq!((right(&l, 2), observed(&l, 2)), ("round, and equally large all the way", "neither"));
    // It stays in the picture.
    let half = (142.5_f64 / 2.0).to_radians().sin().atanh();
    let middle = 127.2_f64.to_radians().cos().atanh();
    for (time, revealed) in [(-1.2, false), (14.0, true)] {
        assert_eq!(settings(&l, 2, revealed).time, Some(time));
        let [u, _] = coordinates(seen(0.9, [-1.5, 6.0, 0.0], time).position);
        assert!((u - middle).abs() + 0.26 < half, "T = {time}: {u}, {middle} +- {half}");
    }
}

#[test]
fn colours_hang_in_the_picture() {
    let l = lesson("slide");
    let eta = 0.9_f64.atanh();
    for place in [[0.0, 3.9, -2.0], [-3.0, 7.0, 1.0], [2.0, 0.5, 0.3]] {
        for time in [-4.0, 0.0, 2.0, 8.0] {
            let seen = seen(0.9, place, time);
            let [u, _] = coordinates(seen.position);
            let expected = u.cosh() / (u + eta).cosh();
            assert!((seen.doppler_factor / expected - 1.0).abs() < 1e-12, "{place:?} {time}");
        }
    }
    let at = |u: f64| u.cosh() / (u + eta).cosh();
    assert!((at(-0.5 * eta) - 1.0).abs() < 1e-12);
    says(&l, 3, r"e^\eta = {}$", eta.exp(), 2);
    says(&l, 3, r"1/\gamma = {}$", at(0.0), 3);
    says(&l, 3, r"e^{-\eta} = {}$", (-eta).exp(), 2);
    assert_eq!((right(&l, 3), observed(&l, 3)), ("half an arrow before abreast", "stood still"));
    let [before, after] = [false, true].map(|revealed| settings(&l, 3, revealed).window.ruler);
    assert!(!before && after, "the strip would tell the answer");
}

#[test]
fn slides_add() {
    let l = lesson("slide");
    let twice = 2.0 * 0.5_f64.atanh();
    assert!((number(&l, 4) - 0.8).abs() < 1e-12 && (twice.tanh() - 0.8).abs() < 1e-12);
    says(&l, 4, "the arrow is {} long", 0.5_f64.atanh(), 3);
    says(&l, 4, "slides by {}.", 0.5_f64.atanh(), 3);
    says(&l, 4, "add up to {}, and", twice, 3);
    assert_eq!(observed(&l, 4), "twice as long");
}

#[test]
fn the_lab_finds_one_slide_at_every_time() {
    let l = lesson("slide");
    let lab = l.lab.as_ref().expect("a lab");
    let gamma = 1.0 / (1.0_f64 - 0.81).sqrt();
    for time in [-3.0, 0.0, 3.0, 12.0] {
        let [u, _] = coordinates(seen(0.9, [0.0, 3.0, 0.0], time).position);
        let number = gamow::caption::decimal(u, 3);
        let text = lab.text.markdown.source();
        assert!(text.contains(&format!("u = {number}")), "{number}: {text}");
        assert!(((gamma * 0.9 * time / 3.0).asinh() - u - 0.9_f64.atanh()).abs() < 1e-12);
    }
}
