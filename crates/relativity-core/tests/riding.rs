//! Views of two moving eyes: numbers worked out in 60-digit arithmetic, and claims that need none.

use std::f64::consts::{FRAC_PI_2, PI};

use relativity_core::{
    Aperture, Baseline, Disparity, Leg, Model, Observer, ObserverError, ObserverVelocity, Odometers, Ride,
    RideMoment, RiderVelocity, SourcePoint, Speed, Turning, WheelPoint, disparity, sighting, stereo,
};

/// In a row: the point's gamma and x0, y, z; the observer's gamma, azimuth and elevation, place and T; roll
/// and turn; then what the left eye sees, D, phi, theta and R', then dphi and dtheta, and t and tau, with ten
/// significant digits; the stereo position with eight. A speed that is not above 1 is a beta.
const ROWS: &str = "
a | 0 0 3 2 | 0.9 0 0 0 0 0 0 | 0 0 | 2.359812302 0.3710152326 0.2371591889 8.512729049 -0.02450990186 -0.0142672226 -3.710612566 -3.710612566 | 1.4151767 0.57 0.38
b | 0 5 3 2 | 0.9 0 0 0 0 0 0 | 0 0 | 3.981735471 0.1210853244 0.08035305334 24.91696013 -0.004595314193 -0.003019919708 -6.361051121 -6.361051121 | 2.6578164 0.32948869 0.21965913
c | 0 -20 3 2 | 10 0 0 0 0 0 4 | 0 0 | 0.2159684829 0.9143451523 0.4858809088 4.282769915 -0.0450018347 -0.01379204867 -16.32802573 -16.32802573 | 1.0608445 1.4418423 0.96122821
d | 0 -3e6 3 2 | 1e6 0 0 0 0 0 0 | 0 0 | 1.246911807e-6 1.332608731 0.5748586456 3.678389831 -0.03882244921 -0.003946238973 -3000000.000 -3000000.000 | 0.54585748 2.4541425 1.636095
e | 0.6 1 3 2 | 0.8 pi 0 0 0 0 2 | 0 0 | 1.253738787 2.558557566 0.3517739291 5.804442847 -0.03855663999 0.01927919299 -1.542341695 -1.983873356 | -1.1717468 0.73980882 0.49320588
f | 0.9 1 3 2 | 0.8 0 0 0 0 0 2 | 0 0 | 0.7365204584 0.6316858382 0.3750382466 5.459884464 -0.00928964206 -0.004305283345 -1.699752422 -2.805646509 | 5.1449761 3.8011637 2.5341092
g | 10 0.1 0.4 -0.3 | 10 0 0 0 0 0 0 | 0 0 | 1 0.3639789565 -0.2609102981 1.162970335 -0.03454348916 0.02230871314 -1.679828979 -1.162970335 | 1 0.4 -0.3
h | 0 5 3 2 | 0.8 0.5 0 1 0.5 0 1 | 0 0 | 2.895296476 0.5169421282 0.1335052118 15.02528301 -0.003803198701 -0.003813489843 -4.248054532 -4.248054532 | 6.9321984 3.9583781 1.0875334
i | 0.6 5 3 2 | 0.8 0.5 0.4 1 0.5 0 1 | 0.2 -1.5 | 1.737938467 0.6032255389 0.4520028641 11.42014204 -0.01002836791 0.002319790223 -2.874569758 -6.049655806 | 7.2466256 5.04597 4.2747685
j | 0 10 1 -1 | 0.9 0 0 0 0 0 0 | 0 -pi/2 | 4.339533969 0.0216937857 -0.02282980567 43.80619295 -0.002271537423 -1.183408837e-5 -10.09467682 -10.09467682 | 43.999013 1.0046537 -1.0046654
k | 0 0 3 -5 | 0.6 0 pi/2 0 0 0 2 | 0 0 | 0.6069039485 1.554131203 -0.5589263709 3.53895783 -0.03333024743 0 -3.831166264 -3.831166264 | 0 3 -1.8766253
l | 0 -540 -838 2 | 1000 1 0 0 0 0 0 | 0.2 0.3 | 0.004066517228 1.495310985 0.5411933728 3.901577414 -0.05110432881 -0.01794481535 -996.9193336 -996.9193336 | 0.077719083 1.5422971 0.94724618
";

struct Row {
    name: &'static str,
    speed: Speed,
    point: SourcePoint,
    observer: Observer,
    pair: [Aperture; 2],
    seen: Vec<f64>,
    stereo: Vec<f64>,
}

fn number(text: &str) -> f64 {
    match text {
        "pi" => PI,
        "pi/2" => FRAC_PI_2,
        "-pi/2" => -FRAC_PI_2,
        text => text.parse().expect("a number"),
    }
}

fn speed(value: f64) -> Speed {
    if value > 1.0 { Speed::from_gamma(value) } else { Speed::from_beta(value) }.expect("a speed")
}

fn rows() -> impl Iterator<Item = Row> {
    ROWS.trim().lines().map(|line| {
        let mut parts = line.split('|');
        let name = parts.next().expect("a name");
        let mut numbers = || parts.next().expect("a part").split_whitespace().map(number).collect::<Vec<_>>();
        let (point, observer, head) = (numbers(), numbers(), numbers());
        let velocity = ObserverVelocity::new(speed(observer[0]), observer[1], observer[2]);
        Row {
            name,
            speed: speed(point[0]),
            point: SourcePoint { x0: point[1], y: point[2], z: point[3] },
            observer: Observer {
                velocity,
                place: [observer[3], observer[4], observer[5]],
                time: observer[6],
            },
            pair: Baseline { separation: 0.1, roll: head[0], turn: head[1] }.apertures(),
            seen: numbers(),
            stereo: numbers(),
        }
    })
}

impl Row {
    fn disparity(&self) -> Disparity {
        self.observer
            .disparity(Model::Exact, &self.speed, self.point, self.pair, 0.0)
            .expect("inside the domain")
    }
}

/// Whether `value` is what was rounded to this many significant digits.
fn agrees(value: f64, rounded: f64, digits: i32) -> bool {
    let unit =
        if rounded == 0.0 { 1e-15 } else { 10_f64.powi(rounded.abs().log10().floor() as i32 + 1 - digits) };
    (value - rounded).abs() <= 0.51 * unit
}

fn assert_close(a: f64, b: f64, name: &str) {
    assert!((a - b).abs() <= 1e-12 * (a.abs() + b.abs()) + 1e-15, "{name}: {a} against {b}");
}

#[test]
fn rows_worked_out_elsewhere_are_seen_to_their_last_digit() {
    for row in rows() {
        let both = row.disparity();
        let left = both.primary;
        let seen = [
            left.doppler_factor,
            left.phi(),
            left.theta(),
            left.distance,
            both.dphi,
            both.dtheta,
            left.retarded_time,
            left.proper_time,
        ];
        let fused = row.observer.stereo(Model::Exact, &row.speed, row.point, row.pair, 0.0);
        let position = fused.expect("lines of sight that meet").position;
        let all = [(&seen[..], &row.seen, 10), (&position, &row.stereo, 8)];
        for (values, told, digits) in all {
            for (&value, &told) in values.iter().zip(told) {
                assert!(agrees(value, told, digits), "{}: {values:?}, {told}", row.name);
            }
        }
    }
}

/// Only relative motion counts: the same lamp, as a cyclist who comes the other way, in a mirror.
#[test]
fn a_rider_past_a_lamp_sees_what_a_resting_observer_sees_of_a_cyclist() {
    let row = rows().nth(1).expect("row b");
    let riding = row.disparity();
    let cyclist = SourcePoint { x0: -2.179_449_471_770_337, ..row.point };
    let [left, right] = row.pair;
    let resting = disparity(&speed(0.9), cyclist, left, right, 0.0).expect("inside the domain");
    assert_close(riding.dphi, resting.dphi, "dphi");
    assert_close(riding.dtheta, -resting.dtheta, "dtheta");
    assert_close(riding.primary.doppler_factor, resting.secondary.doppler_factor, "D");
    assert_close(riding.primary.position[0], -resting.secondary.position[0], "x");
}

#[test]
fn an_observer_at_rest_has_the_numbers_of_a_resting_pair_bit_for_bit() {
    for row in rows() {
        let observer = Observer { velocity: ObserverVelocity::REST, place: [0.0; 3], ..row.observer };
        let [left, right] = row.pair;
        let there = disparity(&row.speed, row.point, left, right, observer.time).expect("inside the domain");
        let fused = stereo(&row.speed, row.point, row.pair, observer.time).expect("lines that meet");
        let seen = observer.disparity(Model::Exact, &row.speed, row.point, row.pair, 0.0);
        assert_eq!(seen.expect("inside the domain"), there, "{}", row.name);
        let seen = observer.stereo(Model::Exact, &row.speed, row.point, row.pair, 0.0);
        assert_eq!(seen.expect("lines that meet"), fused, "{}", row.name);
    }
}

/// Motion of the eyes does not decide which event arrives at the middle between them.
#[test]
fn the_light_that_arrives_is_that_which_an_eye_at_rest_receives() {
    for row in rows() {
        let [x, y, z] = row.observer.place;
        let resting = sighting(&row.speed, row.point, Aperture { x, y, z }, row.observer.time);
        let resting = resting.expect("inside the domain");
        let eyes = [Aperture::default(); 2];
        let riding = row.observer.disparity(Model::Exact, &row.speed, row.point, eyes, 0.0);
        let riding = riding.expect("inside the domain").primary;
        assert_close(riding.retarded_time, resting.retarded_time, row.name);
        assert_close(riding.proper_time, resting.proper_time, row.name);
    }
}

/// The frame in which both velocities are given plays no part: seen from a frame that moves along x, a rider
/// along x sees the same.
#[test]
fn any_frame_that_moves_along_the_street_tells_the_same() {
    let rapidity = |value: f64| Speed::from_rapidity(value).expect("in range");
    let (point, observer, frame) = (0.4, 1.3, 0.3);
    let event = |x: f64, t: f64| {
        let frame = rapidity(frame);
        (frame.gamma() * (x - frame.beta() * t), frame.gamma() * (t - frame.beta() * x))
    };
    let seen = |by: f64, [x, t]: [f64; 2], [ox, time]: [f64; 2]| {
        let speed = rapidity(point - by);
        let velocity = ObserverVelocity::along_street(rapidity(observer - by));
        let lamp = SourcePoint { x0: x - speed.beta() * t, y: 3.0, z: 2.0 };
        Observer { velocity, place: [ox, 0.2, -0.1], time }
            .disparity(Model::Exact, &speed, lamp, Aperture::pair(0.1), 0.0)
            .expect("inside the domain")
    };
    let (lamp, rider) = ([4.0, 1.0], [1.5, 2.0]);
    let here = seen(0.0, lamp, rider);
    let there = seen(frame, event(lamp[0], lamp[1]).into(), event(rider[0], rider[1]).into());
    for (a, b, name) in [
        (here.dphi, there.dphi, "dphi"),
        (here.dtheta, there.dtheta, "dtheta"),
        (here.primary.doppler_factor, there.primary.doppler_factor, "D"),
        (here.primary.distance, there.primary.distance, "R'"),
    ] {
        assert_close(a, b, name);
    }
}

/// Coasting, what is seen at a time of one's own clock is what is seen at that event.
#[test]
fn coasting_is_the_same_from_any_event_on() {
    for row in rows().filter(|row| row.speed.gamma() < 100.0 && row.observer.velocity.speed().gamma() < 100.0)
    {
        let at = |observer: Observer, proper_time| {
            observer
                .disparity(Model::Exact, &row.speed, row.point, row.pair, proper_time)
                .expect("in the domain")
        };
        let [later, there] = [at(row.observer, 0.7), at(row.observer.at(0.7), 0.0)];
        for (a, b, name) in [
            (later.dphi, there.dphi, "dphi"),
            (later.primary.distance, there.primary.distance, "R'"),
            (later.secondary.retarded_time, there.secondary.retarded_time, "t"),
            (later.secondary.proper_time, there.secondary.proper_time, "tau"),
        ] {
            assert!((a - b).abs() < 1e-11 * (1.0 + a.abs()), "{}: {name} {a} against {b}", row.name);
        }
    }
}

/// A lamp ahead is taken to be nearer by Gamma, though it seems smaller: by two eyes along the way.
#[test]
fn two_eyes_along_the_way_take_a_lamp_to_be_nearer_by_gamma() {
    let velocity = ObserverVelocity::along_street(speed(0.9));
    let rider = Observer { velocity, place: [0.0; 3], time: 0.0 };
    let lamp = SourcePoint { x0: 40.0, y: 3.0, z: 2.0 };
    let fused = rider.stereo(Model::Exact, &Speed::REST, lamp, Aperture::pair(1e-6), 0.0);
    let on_ground = (40.0_f64 * 40.0 + 13.0).sqrt();
    let ratio = fused.expect("lines that meet").distance() / on_ground;
    assert!((ratio - 1.0 / velocity.speed().gamma()).abs() < 1e-6, "{ratio}");
}

#[test]
fn one_cone_has_both_eyes_look_at_one_event() {
    let row = rows().nth(8).expect("row i");
    let both = row.observer.disparity(Model::OneCone, &row.speed, row.point, row.pair, 0.0);
    let both = both.expect("inside the domain");
    let [left, right] = row.pair;
    assert_eq!(both.primary.retarded_time, both.secondary.retarded_time);
    let apart: [f64; 3] = std::array::from_fn(|i| both.primary.position[i] - both.secondary.position[i]);
    for (seen, eyes) in apart.into_iter().zip([right.x - left.x, right.y - left.y, right.z - left.z]) {
        assert!((seen - eyes).abs() < 1e-13);
    }
    let fused = row.observer.stereo(Model::OneCone, &row.speed, row.point, row.pair, 0.0);
    assert_eq!(fused.expect("always meets").gain, 1.0);
}

#[test]
fn what_cannot_be_told_is_an_error() {
    let row = rows().next().expect("row a");
    let told = |observer: Observer, speed: Speed, model: Model| {
        observer.disparity(model, &speed, row.point, row.pair, 0.0).expect_err("out of range")
    };
    let fast = Speed::from_gamma(1e20).expect("in range");
    let away = Observer { velocity: ObserverVelocity::new(fast, PI, 0.0), ..row.observer };
    assert_eq!(told(away, fast, Model::Exact), ObserverError::RelativeSpeed);
    let nowhere = Observer { place: [f64::NAN, 0.0, 0.0], ..row.observer };
    assert!(matches!(told(nowhere, row.speed, Model::Exact), ObserverError::Domain(_)));
    let published = Model::ALL[2];
    assert_eq!(told(row.observer, row.speed, published), ObserverError::Published(published));
}

/// The point of a tyre on the road rests there: a rider sees it where a lamp on the road would be, and as
/// blue.
#[test]
fn where_a_wheel_meets_the_road_a_rider_sees_the_road() {
    let velocity = ObserverVelocity::new(speed(0.8), 0.3, 0.0);
    let rider = Observer { velocity, place: [0.5, 0.2, 0.0], time: 1.0 };
    let pair = Aperture::pair(0.1);
    let on_road = SourcePoint { x0: 4.0, y: 3.0, z: -1.5 };
    let lamp =
        rider.disparity(Model::Exact, &Speed::REST, on_road, pair, 0.0).expect("inside the domain").primary;
    // A wheel whose point is on the road at the event that the left eye sees.
    let rolling = speed(0.9);
    let (x, t) = (on_road.x0, lamp.retarded_time);
    let own = rolling.gamma() * (t - rolling.beta() * x);
    let hub = SourcePoint { x0: x - rolling.beta() * t, y: 3.0, z: -1.0 };
    let angle = rolling.beta() / 0.5 * own - FRAC_PI_2;
    let valve = WheelPoint { hub, radius: 0.5, rho: 1.0, angle, turning: Turning::Rolling };
    let seen = rider.disparity(Model::Exact, &rolling, valve, pair, 0.0).expect("inside the domain").primary;
    assert!((seen.doppler_factor / lamp.doppler_factor - 1.0).abs() < 1e-9, "{seen:?}");
    for (a, b) in seen.position.into_iter().zip(lamp.position) {
        assert!((a - b).abs() < 1e-9, "{seen:?} against {lamp:?}");
    }
}

fn legs(parts: &[(f64, [f64; 3])]) -> Ride {
    let legs = parts.iter().map(|&(duration, acceleration)| Leg { duration, acceleration });
    Ride::new(RideMoment::AT_REST, legs.collect::<Vec<_>>())
}

/// Own time, T, place and proper velocity of accelerated rides, and the turn of the head about z in degrees.
#[test]
fn rides_end_where_they_were_worked_out_to_end() {
    let [x, y] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let [back, right] = [x, y].map(|axis: [f64; 3]| axis.map(|part| -part));
    let cases = [
        (legs(&[(2.0, x)]), 2.0, 3.626_860_408, [2.762_195_691, 0.0], [3.626_860_408, 0.0], 0.0),
        (
            legs(&[(2.0, x), (1.0, y)]),
            3.0,
            8.048_197_275,
            [7.024_486_372, 0.543_080_634_8],
            [5.596_538_061, 1.175_201_194],
            -38.778_603_27,
        ),
        (
            legs(&[(1.0, x), (1.0, y), (1.0, back), (1.0, right)]),
            4.0,
            6.858_719_506,
            [3.624_642_879, 3.217_306_610],
            [-0.103_382_115_3, 0.984_838_826_3],
            -78.014_801_94,
        ),
        (legs(&[(2.0, x), (2.0, back), (2.0, back), (2.0, x)]), 8.0, 14.507_441_63, [0.0; 2], [0.0; 2], 0.0),
    ];
    for (ride, proper_time, time, [px, py], [wx, wy], turn) in cases {
        let end = ride.at(proper_time);
        let [x, y, _] = end.proper_velocity();
        let [real, _, _, about_z] = end.head;
        let head = (2.0 * about_z.atan2(real)).to_degrees();
        for (value, told) in
            [(end.time, time), (end.place[0], px), (end.place[1], py), (x, wx), (y, wy), (head, turn)]
        {
            assert!((value - told).abs() <= 1e-9 * (1.0 + told.abs()), "{value} for {told}: {end:?}");
        }
        assert_eq!(ride.duration(), proper_time);
    }
}

/// Any moment and both odometers of a ride of many legs, found by bisection, are those of step after step.
#[test]
fn a_moment_of_many_legs_is_that_of_one_after_the_other() {
    for aside in [0.0, 0.3] {
        let leg = |number: u32| {
            let ahead = if number.is_multiple_of(3) { -0.9 } else { 0.6 };
            let duration = f64::from(number % 4) / 8.0;
            (duration, [ahead, aside * f64::from(number % 2), 0.0])
        };
        let parts: Vec<_> = (0..60).map(leg).collect();
        let ride = legs(&parts);
        let (mut moment, mut before) = (RideMoment::AT_REST, Odometers::default());
        for &(duration, acceleration) in &parts {
            for part in [0.0, 0.25, 1.0] {
                let expected = moment.after(part * duration, acceleration);
                let found = ride.at(expected.proper_time);
                assert!((found.time - expected.time).abs() <= 1e-12 * (1.0 + expected.time), "{found:?}");
                for (a, b) in found.place.into_iter().zip(expected.place) {
                    assert!((a - b).abs() < 1e-11, "{found:?} for {expected:?}");
                }
                let odometers = ride.odometers(expected.proper_time);
                let counts_on =
                    odometers.by_wheel >= before.by_wheel && odometers.by_lamps >= before.by_lamps;
                assert!(counts_on || aside != 0.0, "{odometers:?} after {before:?}");
                before = odometers;
            }
            moment = moment.after(duration, acceleration);
        }
        assert_eq!(ride.at(-1.0).place, [0.0; 3]);
    }
}

/// The twin: out for four units of proper time, and back. In steps of any length he is home at rest.
#[test]
fn a_trip_in_a_thousand_steps_is_the_trip_in_one() {
    let quarter = |acceleration: f64, moment: RideMoment, steps: u32| {
        (0..steps).fold(moment, |moment, _| moment.after(2.0 / f64::from(steps), [acceleration, 0.0, 0.0]))
    };
    let trip = |steps| {
        [1.0, -1.0, -1.0, 1.0].into_iter().fold(RideMoment::AT_REST, |moment, a| quarter(a, moment, steps))
    };
    let [whole, fine] = [1, 1000].map(trip);
    assert!((fine.time - whole.time).abs() < 1e-11 && fine.place[0].abs() < 1e-11, "{fine:?}");
    let RiderVelocity::AlongStreet { rapidity } = fine.velocity else { panic!("along the street") };
    assert!(rapidity.abs() < 1e-12, "{rapidity}");
    // The general step says the same.
    let general = RideMoment { velocity: RiderVelocity::Any { proper: [0.0; 3] }, ..RideMoment::AT_REST };
    let away = general.after(2.0, [1.0, 0.0, 0.0]);
    assert!((away.time - whole_quarter().time).abs() < 1e-13 * away.time);
}

fn whole_quarter() -> RideMoment {
    RideMoment::AT_REST.after(2.0, [1.0, 0.0, 0.0])
}

/// Nothing that is seen jumps: what home's clock is seen to run by, added up over the trip, is what it shows
/// in the end.
#[test]
fn all_the_light_from_home_arrives_during_the_trip() {
    let (out, back) = ([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    let ride = legs(&[(2.0, out), (2.0, back), (2.0, back), (2.0, out)]);
    let home = SourcePoint { x0: 0.0, y: 0.0, z: 0.0 };
    let seen = |proper_time: f64| {
        let rider = ride.at(proper_time).observer().expect("a speed");
        let eyes = [Aperture::default(); 2];
        let both = rider.disparity(Model::Exact, &Speed::REST, home, eyes, 0.0).expect("inside the domain");
        (both.primary.proper_time, both.primary.doppler_factor)
    };
    // Simpson's rule on each leg, whose ends are smooth from within; halfway home is seen at 1 - e^-2.
    let steps = 2000;
    let leg = |from: f64| {
        let width = 2.0 / f64::from(steps);
        let term = |i: u32| {
            let weight = if i == 0 || i == steps {
                1.0
            } else if i % 2 == 1 {
                4.0
            } else {
                2.0
            };
            // At home itself the light has no direction.
            let proper_time = (from + width * f64::from(i)).clamp(1e-9, 8.0 - 1e-9);
            weight * seen(proper_time).1
        };
        (0..=steps).map(term).sum::<f64>() * width / 3.0
    };
    let sum: f64 = [0.0, 2.0, 4.0, 6.0].into_iter().map(leg).sum();
    assert!((sum - 14.507_441_63).abs() < 1e-7, "{sum}");
    let (shows, doppler) = seen(2.0);
    assert!((shows - 0.864_664_716_7).abs() < 1e-9 && (doppler - 0.135_335_283_2).abs() < 1e-9);
    let (shows, doppler) = seen(6.0);
    assert!((shows - 8.118_385_532).abs() < 1e-8 && (doppler - 7.389_056_099).abs() < 1e-8);
    assert!((seen(4.0).0 - 1.729_329_434).abs() < 1e-9);
}

/// A sign ahead seems to run away while one pedals: R' = R e^s grows until one sees it as it was when one
/// started.
#[test]
fn a_sign_ahead_runs_away_at_first() {
    let ride = legs(&[(4.0, [1.0, 0.0, 0.0])]);
    let sign = SourcePoint { x0: 5.524_391_382, y: 0.0, z: 0.0 };
    let distance = |proper_time: f64| {
        let rider = ride.at(proper_time).observer().expect("a speed");
        let eyes = [Aperture::default(); 2];
        let both = rider.disparity(Model::Exact, &Speed::REST, sign, eyes, 0.0).expect("inside the domain");
        (both.primary.distance, both.primary.proper_time)
    };
    let (farthest, shows) = distance(1.875_547_674);
    assert!((farthest - 20.783_841_45).abs() < 1e-7 && shows.abs() < 1e-8, "{farthest} {shows}");
    assert!(distance(1.7).0 < farthest && distance(2.0).0 < farthest);
}

/// The odometers are integrals of the rider's speed: against Simpson's rule on rides that speed up, brake and
/// turn round.
#[test]
fn odometers_add_up_what_is_ridden() {
    let rides = [
        legs(&[(2.0, [1.0, 0.0, 0.0]), (3.0, [-1.5, 0.0, 0.0]), (1.0, [0.0; 3])]),
        legs(&[(0.5, [1e-9, 0.0, 0.0]), (2.0, [6.0, 0.0, 0.0])]),
    ];
    for ride in rides {
        let duration = ride.duration();
        let steps = 60_000_u32;
        let width = duration / f64::from(steps);
        let mut sums = [0.0; 3];
        for i in 0..=steps {
            let [w, ..] = ride.at(width * f64::from(i)).proper_velocity();
            let weight = if i == 0 || i == steps { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
            sums[0] += weight * width / 3.0 * (w / 1.0_f64.hypot(w)).abs();
            sums[1] += weight * width / 3.0 * w.abs();
            sums[2] += weight * width / 3.0 * (w / 1.0_f64.hypot(w));
        }
        let Odometers { by_wheel, by_lamps, rolled } = ride.odometers(duration);
        assert!((rolled - sums[2]).abs() < 1e-8 * by_wheel, "{rolled} {sums:?}");
        assert!((by_wheel / sums[0] - 1.0).abs() < 1e-8, "{by_wheel} {sums:?}");
        assert!((by_lamps / sums[1] - 1.0).abs() < 1e-8, "{by_lamps} {sums:?}");
    }
    // One street length at gamma 10: 10.0 by the wheel, 100 by the lamps.
    let rapidity = 10.0_f64.acosh();
    let start = RideMoment { velocity: RiderVelocity::AlongStreet { rapidity }, ..RideMoment::AT_REST };
    let Odometers { by_wheel, by_lamps, .. } =
        Ride::new(start, Vec::new()).odometers(100.0 / 99.0_f64.sqrt());
    assert!((by_wheel - 10.0).abs() < 1e-13 && (by_lamps - 100.0).abs() < 1e-12, "{by_wheel} {by_lamps}");
}
