//! Lessons 14 to 19, from the saddle: against aberration, the hyperbolic motion of constant proper
//! acceleration, and light that runs straight on the ground.

use gamow::lesson::Lesson;

use super::support::lesson;
use super::told::{number, observed, right, says, settings, words};

const BETA: f64 = 0.9;

fn gamma(beta: f64) -> f64 {
    (1.0 - beta * beta).sqrt().recip()
}

/// Returns the angle from ahead, degrees, at which a rider at `beta` sees what an eye at rest sees at
/// `degrees`: tan(theta'/2) = tan(theta/2) sqrt((1 - beta)/(1 + beta)).
fn aberrated(degrees: f64, beta: f64) -> f64 {
    let half = (0.5 * degrees.to_radians()).tan() * ((1.0 - beta) / (1.0 + beta)).sqrt();
    2.0 * half.atan().to_degrees()
}

fn lab(lesson: &Lesson) -> &str {
    lesson.lab.as_ref().expect("a lab").text.markdown.source()
}

#[test]
fn lamps_crowd_ahead_by_the_law_of_aberration() {
    let lesson = lesson("ride-crowd");
    assert_eq!(settings(&lesson, 0, true).time, Some(0.0));
    assert_eq!(
        (right(&lesson, 0), observed(&lesson, 0)),
        ("still ahead of me", "well inside the picture, ahead")
    );
    // Beside the post the left eye, 0.05 to the left of the middle, has the lamp at x = 0.
    says(&lesson, 0, "You see it at {}:", aberrated(90.0, BETA), 1);
    says(&lesson, 0, "sees the lamp {} degrees", 90.0, 0);
    // Half of the sky: the mean over directions of those within arccos beta is (1 + beta)/2 of light, 1/2 of
    // directions at rest.
    let edge = BETA.acos().to_degrees();
    assert!((aberrated(90.0, BETA) - edge).abs() < 1e-12);
    says(&lesson, 1, "is within {} degrees", edge, 0);
    let seen = |time: f64| {
        // Of the head that looks back the left eye is at y = 5.5 - 0.05; the lamp is at (0, 1.2, 2.4).
        let across = (5.45_f64 - 1.2).hypot(2.4);
        across.atan2(-BETA * gamma(BETA) * time).to_degrees()
    };
    for time in [-8.0, 0.0, 8.0] {
        let (rest, ridden) = (seen(time), aberrated(seen(time), BETA));
        let [rest, ridden] = [rest, ridden].map(|degrees| format!("{degrees:.2}"));
        assert!(
            lab(&lesson).contains(&rest) && lab(&lesson).contains(&ridden),
            "{rest} {ridden}: {}",
            lab(&lesson)
        );
    }
}

#[test]
fn a_street_has_two_lengths_and_its_end_is_seen_to_hurry() {
    let lesson = lesson("ride-length");
    let beta = 0.99_f64.sqrt();
    let time = 100.0 / (10.0 * beta);
    assert!((settings(&lesson, 0, true).time.expect("given") - time).abs() < 1e-12);
    assert_eq!((right(&lesson, 0), observed(&lesson, 0)), ("10 units", "10"));
    says(&lesson, 0, "{} units have gone by under it", beta * time, 1);
    says(&lesson, 0, "as it is for itself: {}.", 100.0, 0);
    // Light from the clock, 6.35 aside of the left eye and 1 up.
    let shows = |x: f64, street_time: f64| street_time - (100.0 - x).hypot(6.35_f64.hypot(1.0));
    let gained = shows(100.0, 10.0 * time) - shows(0.0, 0.0);
    assert!((number(&lesson, 1) - gained).abs() < 1e-6, "{} {gained}", number(&lesson, 1));
    says(&lesson, 1, "you see it show {}:", shows(0.0, 0.0), 1);
    says(&lesson, 1, "it showed {} already", beta * 100.0, 1);
    assert_eq!(observed(&lesson, 1), "faster than yours");
}

#[test]
fn home_has_more_time_and_none_of_it_is_seen_twice() {
    let lesson = lesson("ride-home");
    let (push, quarter) = (0.5_f64, 4.0);
    let (street, away) = (4.0 * (push * quarter).sinh() / push, 2.0 * ((push * quarter).cosh() - 1.0) / push);
    says(&lesson, 0, "for you, {} for the station", street, 1);
    assert_eq!(right(&lesson, 0), "more than 16");
    // The left eye is 1.45 from the clock's face in y, the clock 1 above.
    let shows = |x: f64, street_time: f64| street_time - x.hypot(1.45_f64.hypot(1.0));
    says(&lesson, 1, "you saw it show only {};", shows(away, 0.5 * street), 1);
    says(&lesson, 1, "up to {},", shows(0.0, street), 1);
    // Now: T - V x as it goes, T + V x as it comes.
    let (v, x, t) = ((push * quarter).tanh(), 0.5 * away, 0.25 * street);
    says(&lesson, 1, "is {}, as you turn", t - v * x, 1);
    says(&lesson, 1, "as you begin to brake again {}.", 3.0 * t + v * x, 1);
    assert_eq!(observed(&lesson, 1), "no, never");
    assert!(words(&lesson, 1).contains("nobody sees it"));
}

#[test]
fn who_rides_measures_the_lamps_closer_and_sees_them_further() {
    let lesson = lesson("ride-contracted");
    assert!((number(&lesson, 0) - gamma(BETA).recip()).abs() < 1e-12);
    let at = |time: f64| BETA * gamma(BETA) * time;
    assert!((at(settings(&lesson, 0, false).time.expect("given")) - 20.0).abs() < 1e-3, "beside a lamp");
    let ahead = 60.0 - at(12.0);
    let asked = lesson.steps[1].observation.as_ref().expect("a question").question.markdown.source();
    assert!(asked.contains(&format!("the lamp is {ahead:.0} units ahead")), "{asked}");
    // R' = gamma (R + beta x), of the left eye.
    let (across, aside) = ((5.55_f64 - 1.2).hypot(2.4), ahead);
    let far = gamma(BETA) * (aside.hypot(across) + BETA * aside);
    says(&lesson, 1, "You see it {} units away", far, 0);
    says(&lesson, 1, "here by D = {};", far / aside.hypot(across), 1);
    assert!(far > 3.0 * ahead);
    assert_eq!(
        (right(&lesson, 1), observed(&lesson, 1)),
        ("no, they seem much further apart", "more than that away")
    );
}

#[test]
fn what_is_ahead_withdraws_at_the_first_push() {
    let lesson = lesson("ride-away");
    let (push, start) = (0.5_f64, 90.0);
    let far = |time: f64| {
        let x = start + ((push * time).cosh() - 1.0) / push;
        let (ahead, across) = (100.0 - x, 6.35_f64.hypot(1.0));
        (push * time).cosh() * ahead.hypot(across) + (push * time).sinh() * ahead
    };
    says(&lesson, 0, "the clock {} away at rest", far(0.0), 1);
    says(&lesson, 0, "see it {} away now", far(2.0), 1);
    assert!(far(2.0) > 2.0 * far(0.0) && far(4.9) < far(3.5));
    says(&lesson, 1, "measure, at {} on your clock", (1.0 + 10.0 * push).acosh() / push, 2);
    assert_eq!((right(&lesson, 0), observed(&lesson, 0)), ("seems to move away from you", "shrank"));
}

#[test]
fn in_the_gate_one_still_sees_it_ahead() {
    let lesson = lesson("ride-gate");
    assert_eq!(
        (right(&lesson, 0), observed(&lesson, 0)),
        ("it is still ahead of you", "in the picture, all of it")
    );
    says(&lesson, 0, "You see the mouth {} degrees", aberrated(90.0, BETA), 1);
    says(&lesson, 1, "here that is {} units of the street", gamma(BETA) * BETA * 3.0, 2);
    says(&lesson, 1, "the mouth is {} behind you", BETA * 3.0, 1);
    // Beside it is seen where the picture's middle is, in the reveal: at x = gamma beta 3 or a moment
    // earlier.
    let time = settings(&lesson, 1, true).time.expect("given");
    assert!((BETA * gamma(BETA) * time - gamma(BETA) * BETA * 3.0).abs() < 0.2);
    assert_eq!((right(&lesson, 1), observed(&lesson, 1)), ("6 units, twice its radius", "about 6"));
}
