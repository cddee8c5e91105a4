//! Lessons 8 to 11.

use relativity_core::{Aperture, Sighting, SourcePoint, Speed, disparity, sighting, stereo};

use gamow::lesson::values::value;

use super::support::lesson;
use super::told::{number, observed, right, says, settings, words};

/// The near end of the front hub of the cyclist on the street, from the eyes, at this speed.
fn front_hub(speed: &Speed) -> SourcePoint {
    SourcePoint::from_rest([-0.525, 3.901, -1.975], speed)
}

fn speed(beta: f64) -> Speed {
    Speed::from_beta(beta).expect("a speed")
}

#[test]
fn a_clock_is_seen_fast_then_slow_and_is_slow_once_corrected() {
    let lesson = lesson("clocks");
    let speed = speed(0.8);
    let [left, _] = Aperture::pair(0.1);
    let at = |time| sighting(&speed, front_hub(&speed), left, time).expect("seen");
    assert_eq!(settings(&lesson, 0, false).time, Some(-4.0));

    // Coming: more than one unit of its own time for each of T.
    let [first, last] = [at(-4.0), at(0.0)];
    // A turn of the dial is two units of it.
    assert!(last.proper_time - first.proper_time > 4.0);
    assert_eq!((right(&lesson, 0), observed(&lesson, 0)), ("faster", "more than twice"));
    says(&lesson, 0, "T = −4 you saw it show {}", first.proper_time, 1);
    says(&lesson, 0, "T = 0 it showed {}", last.proper_time, 1);
    says(&lesson, 0, "{} times at T = −4", first.doppler_factor, 2);
    // D is how fast it is seen to run.
    let step = 1e-5;
    let rate = (at(-4.0 + step).proper_time - at(-4.0 - step).proper_time) / (2.0 * step);
    assert!((rate / first.doppler_factor - 1.0).abs() < 1e-6);

    // From near 3 to near 1/3, and 1/gamma where X = 0.
    let [far_before, far_after] = [at(-1e6), at(1e6)].map(|seen| seen.doppler_factor);
    assert!((far_before - 3.0).abs() < 1e-4 && (far_after - 1.0 / 3.0).abs() < 1e-4);
    let abreast = at(time_at(&at, |seen| seen.position[0]));
    assert!((abreast.doppler_factor - 0.6).abs() < 1e-9);
    says(&lesson, 1, "\\sqrt{1 - \\beta^2} = {}", 0.6, 1);
    let pace = time_at(&at, |seen| 1.0 - seen.doppler_factor);
    assert!(at(pace).position[0] < 0.0 && pace > -4.0 && pace < 10.0, "it keeps pace at T = {pace}");
    assert_eq!(observed(&lesson, 1), "before it is seen abreast");

    // Corrected: 1/gamma, coming and going.
    for [from, to] in [[-4.0, 0.0], [8.0, 12.0]] {
        let [from, to] = [at(from), at(to)];
        let rate = (to.proper_time - from.proper_time) / (to.retarded_time - from.retarded_time);
        assert!((rate - 0.6).abs() < 1e-12);
    }
    assert!((number(&lesson, 2) - 0.6).abs() < 1e-12);
    assert_eq!(observed(&lesson, 2), "the same number");
    for (time, text) in
        [(-4.0, "T = −4 left at t = {}"), (0.0, "T = 0 left at t = {}"), (8.0, "T = 8 left at t = {}")]
    {
        says(&lesson, 2, text, at(time).retarded_time, 2);
    }
    says(&lesson, 2, "at T = 12 at t = {}", at(12.0).retarded_time, 2);
    says(&lesson, 2, "(clock at {})", at(8.0).proper_time, 2);
    says(&lesson, 2, "(clock at {})", at(12.0).proper_time, 2);
}

/// The T at which `of` what is seen passes 0, upwards.
fn time_at(at: &impl Fn(f64) -> Sighting, of: impl Fn(&Sighting) -> f64) -> f64 {
    let [mut from, mut to] = [-1e3, 1e3];
    for _ in 0..100 {
        let middle = 0.5 * (from + to);
        if of(&at(middle)) < 0.0 { from = middle } else { to = middle }
    }
    0.5 * (from + to)
}

#[test]
fn clocks_that_are_set_alike_on_the_bicycle_differ_at_one_time_of_the_ground() {
    let lesson = lesson("clocks");
    // The Lorentz transformation of (t = 0, x), of both hubs.
    let [front, rear] = [-0.525, -2.105].map(|hub| {
        let x = hub / speed(0.8).gamma();
        -speed(0.8).gamma() * 0.8 * x
    });
    assert!((rear - front - 0.8 * 1.58).abs() < 1e-12 && front < rear);
    assert_eq!(right(&lesson, 3), "an earlier time");
    says(&lesson, 3, "front hub's clock shows {}", front, 2);
    says(&lesson, 3, "rear hub's {}", rear, 2);
    assert!(words(&lesson, 3).contains("0.8 times 1.58"));
    // In the bicycle's frame events at one t of the ground do not have one t'.
    assert_eq!(observed(&lesson, 3), "sloping");
}

#[test]
fn the_eyes_receive_two_events_and_agree_on_them() {
    let lesson = lesson("two-eyes");
    let speed = speed(0.9);
    let [left, right_eye] = Aperture::pair(0.4);
    let hub = front_hub(&speed);
    let seen = |eye, time| sighting(&speed, hub, eye, time).expect("seen");
    let [a, b] = [seen(left, 1.0), seen(right_eye, 1.0)];
    assert!(b.retarded_time < a.retarded_time && b.distance > a.distance);
    assert_eq!((right(&lesson, 0), observed(&lesson, 0)), ("earlier for the right eye", "the right eye's"));
    says(&lesson, 0, "What the left eye receives left the hub at t = {}", a.retarded_time, 2);
    says(&lesson, 0, "what the right one receives at t = {}", b.retarded_time, 2);

    assert_eq!(settings(&lesson, 1, false).time, Some(0.0));
    let before = seen(left, 0.0).retarded_time - seen(right_eye, 0.0).retarded_time;
    assert!(before > a.retarded_time - b.retarded_time);
    assert!((number(&lesson, 1) - before).abs() < 1e-12 && before > 0.4);
    says(&lesson, 1, "the hub went {} along", 0.9 * before, 2);
    assert!(0.9 * before > 2.0 * 0.4);
    assert_eq!(observed(&lesson, 1), "yes, much further");
    // Straight ahead it is d / (1 - beta) = 10 d, and less at an angle.
    let ahead = SourcePoint { x0: 0.0, y: 1e-9, z: 0.0 };
    let [a_ahead, b_ahead] = [left, right_eye].map(|eye| sighting(&speed, ahead, eye, -9.0).expect("seen"));
    assert!((a_ahead.retarded_time - b_ahead.retarded_time - 4.0).abs() < 1e-9 && before < 4.0);

    // Equal distances at T0 alone.
    let gap = |time| seen(right_eye, time).distance - seen(left, time).distance;
    let t0 = (0.2_f64.powi(2) + hub.y.powi(2) + hub.z.powi(2)).sqrt() - hub.x0 / 0.9;
    assert!(gap(t0).abs() < 1e-12 && gap(t0 - 1.0) > 0.0 && gap(t0 + 1.0) < 0.0);
    assert_eq!(right(&lesson, 2), "when it is seen abreast");
    assert_eq!(observed(&lesson, 2), "on each other");
    says(&lesson, 2, "T0 = {}", t0, 2);
    says(&lesson, 2, "the event of t = {}", seen(left, 4.63).retarded_time, 2);
    assert!((t0 - 4.63).abs() < 0.005 && settings(&lesson, 2, true).time == Some(4.63));

    // What the left eye receives at T = 1 reaches the right eye when the reveal ends, less than d later.
    let there = settings(&lesson, 3, true).time.expect("a T");
    let later = seen(right_eye, there);
    assert!((later.retarded_time - a.retarded_time).abs() < 0.005);
    let state = settings(&lesson, 0, false);
    let scene = state.opened_scene().expect("a scene");
    let arrives = value("T_right", &state, &scene).expect("a value");
    assert!((seen(right_eye, arrives).retarded_time - a.retarded_time).abs() < 1e-9);
    assert!((there - arrives).abs() < 5e-4);
    assert!((later.position[0] + 0.2 - (a.position[0] - 0.2)).abs() < 0.005);
    assert!(there - 1.0 > 0.0 && there - 1.0 < 0.4);
    assert_eq!(
        (right(&lesson, 3), observed(&lesson, 3)),
        ("the same t and the same place", "by less than d = 0.4")
    );
    says(&lesson, 3, "sent at t = {}. The right", a.retarded_time, 2);
    says(&lesson, 3, "It was sent at t = {}", later.retarded_time, 2);
}

#[test]
fn two_eyes_see_the_contraction() {
    let lesson = lesson("depth");
    let fast = speed(0.9);
    let seen = stereo(&fast, front_hub(&fast), Aperture::pair(0.1), 1.0).expect("they meet");
    let both = disparity(&fast, front_hub(&fast), Aperture::pair(0.1)[0], Aperture::pair(0.1)[1], 1.0)
        .expect("seen");
    let distance = both.primary.distance;
    assert!((number(&lesson, 0) - seen.gain).abs() < 1e-12);
    // gamma D of the middle, for eyes near each other.
    let d = sighting(&fast, front_hub(&fast), Aperture::default(), 1.0).expect("seen").doppler_factor;
    assert!((seen.gain / (fast.gamma() * d) - 1.0).abs() < 0.01);
    assert!(seen.distance() < distance);
    assert_eq!(observed(&lesson, 0), "nearer than one eye sees it");
    says(&lesson, 0, "meet too near: {} away", seen.distance(), 2);
    says(&lesson, 0, "has come {}", distance, 2);

    // The rod's ends, abreast: turned by about arctan beta and shortened to sqrt(1 - beta^4) along the
    // motion, true to the measure with eyes above each other.
    let beta = 0.8_f64;
    let speed = speed(beta);
    let place = |pair, x| {
        let end = SourcePoint::from_rest([x, 6.0, 0.0], &speed);
        stereo(&speed, end, pair, 6.78).expect("they meet").position
    };
    let rod = |pair: [Aperture; 2]| {
        let [rear, front] = [place(pair, -2.0), place(pair, 0.0)];
        let [dx, dy] = [front[0] - rear[0], front[1] - rear[1]];
        (dy.abs().atan2(dx.abs()).to_degrees(), dx.hypot(dy))
    };
    let (turn, length) = rod(Aperture::pair(0.1));
    assert!((turn - beta.atan().to_degrees()).abs() < 1.5, "turned by {turn}");
    assert!((length / 2.0 - (1.0 - beta.powi(4)).sqrt()).abs() < 0.02, "{length} long");
    assert_eq!(
        (right(&lesson, 1), observed(&lesson, 1)),
        ("turned, and shorter than at rest", "turned from the motion")
    );
    says(&lesson, 1, "about {} degrees and not", beta.asin().to_degrees(), 0);
    says(&lesson, 1, "turned by {} degrees and only", turn, 0);
    says(&lesson, 1, "only {} long", length, 2);
    assert!(
        words(&lesson, 1).contains("measures it 0.6 times") && words(&lesson, 1).contains("rod of length 2")
    );

    let above = [-0.05, 0.05].map(|z| Aperture { x: 0.0, y: 0.0, z });
    let (turn, length) = rod(above);
    assert!(turn < 0.5 && (length - 1.2).abs() < 0.005, "{turn} degrees, {length} long");
    assert_eq!(
        (right(&lesson, 2), observed(&lesson, 2)),
        ("along the motion, contracted", "along the motion")
    );
    says(&lesson, 2, "turned by {} degrees", turn, 0);
    says(&lesson, 2, "{} long: $1/\\gamma$", length, 2);
}

/// How high the ends of neighbouring spokes of a rolling wheel of radius 1 are, and how far apart, at t = 0
/// of the road: each from the Lorentz transformation of its path in the hub's frame.
fn gaps_between_spokes(beta: f64, spokes: u32) -> Vec<[f64; 2]> {
    let gamma = 1.0 / (1.0 - beta * beta).sqrt();
    let end = |spoke: u32| {
        let at_first = f64::from(spoke) * std::f64::consts::TAU / f64::from(spokes);
        let place = |own: f64| (at_first - beta * own).sin_cos();
        // The time of the hub's frame at which the road's t = gamma (t' + beta x') is 0.
        let [mut from, mut to] = [-2.0, 2.0];
        for _ in 0..60 {
            let middle = 0.5 * (from + to);
            if middle + beta * place(middle).1 < 0.0 { from = middle } else { to = middle }
        }
        let (z, x) = place(from);
        [gamma * (x + beta * from), z]
    };
    (0..spokes)
        .map(|spoke| {
            let [[ax, az], [bx, bz]] = [end(spoke), end((spoke + 1) % spokes)];
            [0.5 * (az + bz), (ax - bx).hypot(az - bz)]
        })
        .collect()
}

#[test]
fn the_clocks_that_are_compared_are_those_of_both_hubs() {
    let settings = settings(&lesson("clocks"), 3, false);
    let scene = settings.opened_scene().expect("a scene");
    // The tracked point is followed anyhow: the front hub's is not given twice.
    assert_eq!(settings.point, Some([-0.525, 3.901, -1.975]));
    let followed = settings.points.expect("another point").0;
    let names: Vec<_> = followed.iter().map(|point| scene.names[point.body].as_str()).collect();
    assert_eq!(names, ["rear hub"]);
}

#[test]
fn the_bottom_of_a_wheel_rests_and_its_top_stays_below_light() {
    let lesson = lesson("red-below");
    // Light from what rests comes as it was sent; the hub's comes bluer, what goes by above bluer still.
    let seen = |beta, time| {
        let speed = speed(beta);
        let left = Aperture::pair(0.1)[0];
        sighting(&speed, front_hub(&speed), left, time).expect("seen")
    };
    let hub = seen(0.3, -10.0);
    assert!(hub.doppler_factor > 1.0);
    // Of what moves at v along x in that direction.
    let doppler =
        |v: f64, seen: &Sighting| (1.0 - v * v).sqrt() / (1.0 + v * seen.position[0] / seen.distance);
    assert!((doppler(0.3, &hub) - hub.doppler_factor).abs() < 1e-12);
    let top = |beta: f64| 2.0 * beta / (1.0 + beta * beta);
    assert!(doppler(top(0.3), &hub) > hub.doppler_factor);
    assert!((doppler(0.0, &hub) - 1.0).abs() < 1e-15);
    assert_eq!((right(&lesson, 0), observed(&lesson, 0)), ("red, as at rest", "above"));
    says(&lesson, 0, "D = {}, and what", hub.doppler_factor, 2);

    // 0.5 c and 0.5 c, as rapidities add.
    let added = (2.0 * 0.5_f64.atanh()).tanh();
    assert!((number(&lesson, 1) - added).abs() < 1e-12 && (added - 0.8).abs() < 1e-12);
    says(&lesson, 1, "= {}", 0.8, 1);
    let gaps = gaps_between_spokes(0.5, 3600);
    let [_, above] = gaps.iter().copied().max_by(|[a, _], [b, _]| a.total_cmp(b)).expect("spokes");
    let [_, below] = gaps.iter().copied().min_by(|[a, _], [b, _]| a.total_cmp(b)).expect("spokes");
    let within = |gap: f64| gap > above * (1.0 - 1e-6) && gap < below * (1.0 + 1e-6);
    assert!(gaps.iter().all(|[_, gap]| within(*gap)), "closest above, widest below");
    assert!((below / above - 1.25 / 0.75).abs() < 1e-3, "{above}, {below}");
    assert!(observed(&lesson, 1).starts_with("above"));

    // Going, the hub is infrared, and its top more so; what rests is red.
    let hub = seen(0.5, 8.0);
    let received = |doppler: f64| 700.0 / doppler;
    assert!(received(hub.doppler_factor) > 780.0 && doppler(top(0.5), &hub) < hub.doppler_factor);
    assert_eq!((right(&lesson, 2), observed(&lesson, 2)), ("the bottom", "only its lower part"));
    says(&lesson, 2, "received with D = {}", hub.doppler_factor, 2);
    says(&lesson, 2, "$D = \\sqrt{1 - 0.8^2} = {}$", (1.0_f64 - 0.8 * 0.8).sqrt(), 1);
    says(&lesson, 2, "top goes at {} c", 0.8, 1);
}
