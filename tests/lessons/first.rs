//! Lessons 1 to 3: lengths that are seen and lengths that are measured.

use relativity_core::{Aperture, Sighting, SourcePoint, Speed, sighting};

use super::support::lesson;
use super::told::{number, observed, right, says, settings, words};

/// The left eye of the usual pair.
const LEFT: Aperture = Aperture { x: -0.05, y: 0.0, z: 0.0 };

/// What the left eye sees at `time` of a point at this place in its own frame.
fn seen(beta: f64, rest: [f64; 3], time: f64) -> Sighting {
    let speed = Speed::from_beta(beta).expect("a speed");
    sighting(&speed, SourcePoint::from_rest(rest, &speed), LEFT, time).expect("in the domain")
}

/// What the left eye sees of the rear end, the middle and the front end of the riding rod, 2 long at rest.
fn rod(time: f64) -> [Sighting; 3] {
    [-1.0, 0.0, 1.0].map(|x| seen(0.7, [x, 4.0, 0.2], time))
}

fn length([rear, _, front]: [Sighting; 3]) -> f64 {
    (front.position[0] - rear.position[0]) / 2.0
}

/// Where the middle of the rod is seen, from between the eyes.
fn place([_, middle, _]: [Sighting; 3]) -> f64 {
    middle.position[0] + LEFT.x
}

#[test]
fn a_rod_that_comes_is_seen_longer_than_its_twin() {
    let l = lesson("rods");
    let (coming, beta) = (rod(-4.5), 0.7_f64);
    assert!((place(coming) + 12.0).abs() < 0.2, "above its twin: {}", place(coming));
    assert!(coming[0].retarded_time < coming[2].retarded_time, "light of its rear left earlier");
    assert!(coming[0].distance > coming[2].distance, "its rear is further away");
    says(&l, 0, "here to {} times the length at rest", length(coming), 2);
    says(&l, 0, r"\sqrt{\frac{1+\beta}{1-\beta}} = {}", ((1.0 + beta) / (1.0 - beta)).sqrt(), 2);
    assert!(length(coming) > 1.0);
    assert_eq!((right(&l, 0), observed(&l, 0)), ("longer than the twin", "longer"));
    // The limit is that of a rod far off on the line of sight.
    let far = [-1.0, 1.0].map(|x| seen(0.7, [x, 4.0, 0.2], -3e4).position[0]);
    assert!(((far[1] - far[0]) / 2.0 - 2.3805).abs() < 1e-3);
}

#[test]
fn a_rod_beside_the_eyes_is_seen_contracted() {
    let l = lesson("rods");
    let (beside, contraction) = (rod(4.01), (1.0_f64 - 0.7 * 0.7).sqrt());
    assert!(place(beside).abs() < 0.1, "as its middle is seen abreast: {}", place(beside));
    assert!((number(&l, 1) - length(beside)).abs() < 1e-9);
    assert!((length(beside) - contraction).abs() < 0.01, "it is short or far");
    says(&l, 1, r"\frac{1}{\gamma} = \sqrt{1-\beta^2} = {}", contraction, 2);
    says(&l, 1, "In the picture it is {}", length(beside), 2);
    assert_eq!(observed(&l, 1), "shorter");
}

#[test]
fn a_rod_that_goes_is_seen_less_than_half_as_long() {
    let l = lesson("rods");
    let (going, beta) = (rod(29.8), 0.7_f64);
    assert!((place(going) - 12.0).abs() < 0.2, "above its twin: {}", place(going));
    assert!(going[2].retarded_time < going[0].retarded_time && going[2].distance > going[0].distance);
    assert!(length(going) < 0.5 && length(going) < (1.0 - beta * beta).sqrt());
    says(&l, 2, "here to {}.", length(going), 2);
    says(&l, 2, r"\sqrt{\frac{1-\beta}{1+\beta}} = {}", ((1.0 - beta) / (1.0 + beta)).sqrt(), 2);
    assert_eq!((right(&l, 2), observed(&l, 2)), ("less than 0.71 times as long", "less than half as long"));
}

/// In the picture itself: columns are arsinh(X/rho), and a twin rests 0.3 below the eyes, 4 away.
#[test]
fn the_pictures_of_rods_are_as_long_as_the_text_says() {
    for (time, middle) in [(-4.5, -12.0), (4.01, 0.0), (29.8, 12.0)] {
        let [rear, _, front] = rod(time).map(|end| {
            let [x, y, z] = end.position;
            (x / y.hypot(z)).asinh()
        });
        let twin = [-1.0, 1.0].map(|end| ((middle + end - LEFT.x) / 4.0_f64.hypot(0.3)).asinh());
        let drawn = (front - rear) / (twin[1] - twin[0]);
        assert!((drawn / length(rod(time)) - 1.0).abs() < 0.015, "{time}: {drawn}");
    }
}

#[test]
fn the_street_measures_one_length_each_time() {
    let l = lesson("rods");
    assert_eq!((right(&l, 3), observed(&l, 3)), ("0.71 each time", "shorter than the twin"));
    says(&l, 3, r"1/\gamma = {}$ everywhere", (1.0_f64 - 0.7 * 0.7).sqrt(), 2);
    let lengths = [-4.5, 4.01, 29.8].map(|time| format!("{:.1}", length(rod(time))));
    assert_eq!(lengths, ["2.1", "0.7", "0.4"]);
    assert!(words(&l, 3).contains("2.1 lengths as it came, and 0.4 as it went"));
    // At t = 0 its middle is measured above the second twin, at x = 0.
    assert_eq!(settings(&l, 3, true).time, Some(0.0));
    // The formula of the lab, from the direction in which the middle is seen.
    let coming = rod(-4.5);
    let cosine = coming[1].position[0] / coming[1].distance;
    assert!((cosine + 0.95).abs() < 0.005, "{cosine}");
    let ratio = (1.0_f64 - 0.49).sqrt() / (1.0 + 0.7 * cosine);
    assert!((ratio / length(coming) - 1.0).abs() < 0.02, "{ratio}");
}

/// The near ends of the hubs of the street's bicycle, at rest; that of the front one is selected.
const FRONT: [f64; 3] = [-0.525, 3.901, -1.975];
const REAR: [f64; 3] = [-2.105, 3.881, -1.975];

#[test]
fn gamow_drew_what_is_measured_and_not_what_is_seen() {
    let l = lesson("what-gamow-drew");
    let contraction = (1.0_f64 - 0.81).sqrt();
    assert!((number(&l, 0) - contraction).abs() < 1e-12);
    says(&l, 0, r"\sqrt{1 - \beta^2} = {}", contraction, 2);
    assert_eq!((settings(&l, 0, false).speed().beta(), settings(&l, 0, true).speed().beta()), (0.0, 0.9));
    assert_eq!(observed(&l, 0), "nothing: only lengths along the motion change");

    let [front, rear] = [FRONT, REAR].map(|place| seen(0.9, place, 0.25));
    let delay = |seen: &Sighting| 0.25 - seen.retarded_time;
    says(&l, 1, "the front hub {} units of time ago", delay(&front), 1);
    says(&l, 1, "the rear hub {} ago", delay(&rear), 1);
    assert!(rear.retarded_time < front.retarded_time && front.position[0] < 0.0, "it was still coming");
    assert_eq!(right(&l, 1), "each part where it was earlier, elsewhere");
    let (seen, measured) = (front.position[0] - rear.position[0], 1.58 * contraction);
    assert!(seen > 1.58, "{seen}: longer than at rest, let alone than measured");
    assert!(seen > measured);
    assert_eq!((observed(&l, 1), observed(&l, 2)), ("longer", "measured now"));
    assert_eq!(right(&l, 2), "many of them mark, at one time t, what is beside them");
}

#[test]
fn what_arrives_together_left_at_different_times() {
    let l = lesson("light-is-late");
    let now = seen(0.9, FRONT, 2.0);
    says(&l, 0, "*happened* at t = {} by the street's clocks", now.retarded_time, 2);
    says(&l, 0, "showed τ = {} then", now.proper_time, 2);
    let measured = 0.9 * 2.0 + FRONT[0] * (1.0_f64 - 0.81).sqrt();
    assert!(now.position[0] < -2.0 && measured > 1.0, "seen coming, measured beyond: {measured}");
    assert_eq!((right(&l, 0), observed(&l, 0)), ("further on, to the right", "after: it has passed already"));

    let [front, rear] = [FRONT, REAR].map(|place| seen(0.9, place, 0.5));
    assert!(rear.distance > front.distance && rear.retarded_time < front.retarded_time);
    assert!(seen(0.9, REAR, 2.0).retarded_time < now.retarded_time);
    says(&l, 1, "left at t = {}.", now.retarded_time, 2);
    says(&l, 1, "the front hub at t = {}", front.retarded_time, 2);
    says(&l, 1, "the near end of the rear hub at t = {}", rear.retarded_time, 2);
    says(&l, 1, "The rear hub's light left at t = {}", rear.retarded_time, 2);
    assert!(front.position[0] - rear.position[0] > 1.58 * (1.0_f64 - 0.81).sqrt());
    assert_eq!((right(&l, 1), observed(&l, 1)), ("earlier", "longer"));
}

#[test]
fn the_hub_is_seen_abreast_when_its_light_from_there_arrives() {
    let l = lesson("light-is-late");
    let passing = -FRONT[0] * (1.0_f64 - 0.81).sqrt() / 0.9;
    let distance = (FRONT[1].powi(2) + FRONT[2].powi(2)).sqrt();
    assert!((passing - 0.25).abs() < 0.005, "{passing}");
    says(&l, 2, "It is then {} away", distance, 1);
    says(&l, 2, "its light takes {}", distance, 1);
    says(&l, 2, "only at T = {}", passing + distance, 2);
    assert!(distance > 4.0);
    assert_eq!(observed(&l, 2), "more than 4 later");
    // Its azimuth changes little for long, then fast.
    let turned = |from: f64, to: f64| seen(0.9, FRONT, from).phi() - seen(0.9, FRONT, to).phi();
    assert!(turned(-4.0, -1.0) < 0.15 && turned(1.0, 4.0) > 0.8);
}
