//! Points of wheels against what is known of them.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use relativity_core::wheel::measured_later;
use relativity_core::{
    Aperture, Baseline, Disparity, DomainError, MAX_ERROR_UNITS, Model, PublishedVariant, Sighting, Source,
    SourcePoint, Speed, Stereo, StereoError, Turning, WheelPoint, disparities, disparity, equidistance_time,
    one_cone_disparity, sighting, stereo,
};

const RADIUS: f64 = 0.525;
/// The front wheel of the paper's bicycle, and the valve in it.
const VALVE: WheelPoint = WheelPoint {
    hub: SourcePoint { x0: -0.525, y: 3.0, z: 2.0 },
    radius: RADIUS,
    rho: 1.0,
    angle: 0.0,
    turning: Turning::Rolling,
};
const BETAS: [f64; 8] = [0.01, 0.3, 0.6, 0.9, 0.93, 0.99, 0.9999, 1.0 - 1e-9];

fn speed(beta: f64) -> Speed {
    Speed::from_beta(beta).expect("a speed")
}

fn seen(speed: &Speed, source: impl Into<Source>, aperture: Aperture, time: f64) -> Sighting {
    sighting(speed, source, aperture, time).expect("inside the domain")
}

/// Points all round, and across the wheel.
fn points() -> impl Iterator<Item = WheelPoint> {
    [0.0, 0.2, 0.7, 1.0].into_iter().flat_map(|rho| {
        (0..12).map(move |i| WheelPoint { rho, angle: PI * f64::from(i) / 6.0 - 3.0, ..VALVE })
    })
}

/// X from the eye, z, t, t', angle in degrees and D, by a root-finder in 40-digit arithmetic.
#[test]
fn the_valve_is_seen_where_another_solution_has_it() {
    let rows = [
        (
            0.5,
            0.0,
            ["-3.224919516", "1.841072917", "-4.773851210", "-3.621592898", "197.620941", "0.8844761986"],
        ),
        (
            0.9,
            3.605_551_275_463_989,
            [
                "0.04960746323",
                "2.000171075",
                "-0.0004361384647",
                "-0.0001900832636",
                "0.01867023216",
                "0.2389794071",
            ],
        ),
        (
            0.99,
            8.0,
            ["3.158284293", "1.807020435", "3.284060801", "1.466387054", "201.5664544", "0.01794733091"],
        ),
    ];
    let eye = Aperture { x: -0.05, y: 0.0, z: 0.0 };
    for (beta, time, expected) in rows {
        // The table's hub is at rest coordinate -0.525.
        let speed = speed(beta);
        let valve = WheelPoint { hub: SourcePoint::from_rest([-0.525, 3.0, 2.0], &speed), ..VALVE };
        let seen = seen(&speed, valve, eye, time);
        let angle = valve.angle_at(&speed, seen.proper_time).to_degrees().rem_euclid(360.0);
        let [x, _, z] = seen.position;
        let computed = [x, z, seen.retarded_time, seen.proper_time, angle, seen.doppler_factor];
        for (computed, expected) in computed.into_iter().zip(expected) {
            let decimals = expected.len() - expected.find('.').expect("decimals") - 1;
            assert_eq!(format!("{computed:.decimals$}"), expected, "at {beta}");
        }
    }
}

#[test]
fn a_point_on_the_road_keeps_its_colour_at_every_speed() {
    let bottom = WheelPoint { angle: -FRAC_PI_2, hub: SourcePoint { x0: 0.0, y: 0.0, z: RADIUS }, ..VALVE };
    // It is at the origin at t = 0: eyes at whole distances receive that at whole times.
    let eyes = [
        [2.0, -3.0, 6.0],
        [-2.0, 3.0, 6.0],
        [-6.0, -2.0, 3.0],
        [0.0, -3.0, 4.0],
        [4.0, 3.0, 0.0],
        [-8.0, 4.0, 1.0],
    ];
    for beta in [0.999, 0.9999].into_iter().chain((0..100).map(|i| 0.005 + 0.01 * f64::from(i))) {
        let speed = speed(beta);
        for [x, y, z] in eyes {
            let time = f64::sqrt(x * x + y * y + z * z);
            let seen = seen(&speed, bottom, Aperture { x, y, z }, time);
            let error = (seen.doppler_factor - 1.0).abs();
            // By so much D changes with the roundings of T, of the place and of the angle at t' = 0: dD/da =
            // gamma n_z, da/dT = gamma omega, and the place where it is at an angle tells the time 1/(1 +
            // v.n') times as well.
            let slope = 1.0 / (speed.gamma() * speed.gamma() * (1.0 - beta * x / time));
            let of_angle = FRAC_PI_2 * (1.0 + beta / slope) + speed.gamma() * 2.0 * time / RADIUS;
            let of_inputs = 1.0 + speed.gamma() * z / time * of_angle;
            let by_inputs = MAX_ERROR_UNITS * 0.5 * f64::EPSILON * of_inputs;
            assert!(error <= by_inputs, "{error:e} at {beta}, {by_inputs:e}");
            assert!(error <= 1e-12 || (z != 0.0 && speed.gamma() > 20.0), "{error:e} at {beta}");
        }
    }
}

#[test]
fn a_hub_is_seen_as_any_point_that_does_not_turn() {
    let eye = Aperture { x: 0.3, y: -0.2, z: 0.4 };
    let pair = [Aperture::default(), eye];
    for beta in BETAS {
        let speed = speed(beta);
        for time in [-20.0, 0.0, 3.0, 50.0] {
            let hub = WheelPoint { rho: 0.0, ..VALVE };
            assert_eq!(seen(&speed, hub, eye, time), seen(&speed, hub.hub, eye, time));
            assert_eq!(stereo(&speed, hub, pair, time), stereo(&speed, hub.hub, pair, time));
            let both = disparities(&speed, hub, &pair, time).expect("inside the domain");
            let of_point = disparities(&speed, hub.hub, &pair, time).expect("inside the domain");
            assert!((both[1].dphi - of_point[1].dphi).abs() <= 1e-15 * of_point[1].dphi.abs());
            assert!((both[1].dtheta - of_point[1].dtheta).abs() <= 1e-15 * of_point[1].dtheta.abs());
            assert_eq!([both[1].primary, both[1].secondary], [of_point[1].primary, of_point[1].secondary]);
        }
    }
}

/// The proper time of a point that moves at v is sqrt(1 - v^2) times that of the clocks at rest with its
/// wheel.
#[test]
fn the_doppler_factor_is_how_fast_its_own_clock_is_seen_to_run() {
    for beta in [0.1, 0.5, 0.9, 0.99] {
        let speed = speed(beta);
        for point in points() {
            for turning in [Turning::Rolling, Turning::RimSpeed(-0.4), Turning::RimSpeed(0.95)] {
                let point = WheelPoint { turning, ..point };
                let v = point.rho * turning.rim_speed(beta);
                for time in [-3.0, 0.7, 4.0, 11.0] {
                    let clock = |time| seen(&speed, point, Aperture::default(), time).proper_time;
                    let [near, far] = [1e-5, 2e-5].map(|h| (clock(time + h) - clock(time - h)) / (2.0 * h));
                    let rate = (4.0 * near - far) / 3.0 * (1.0 - v * v).sqrt();
                    let d = seen(&speed, point, Aperture::default(), time).doppler_factor;
                    assert!((rate / d - 1.0).abs() < 1e-7, "{rate} {d} of {point:?} at {time}, {beta}");
                }
            }
        }
    }
}

/// Returns the place on the ground and the angle of a point at time `t`.
fn measured(speed: &Speed, point: &WheelPoint, t: f64) -> ([f64; 2], f64) {
    let hub_time = t / speed.gamma() - speed.beta() * speed.gamma() * point.hub.x0;
    let (r, omega) = (point.rho * point.radius, point.omega(speed));
    let proper_time = hub_time + measured_later(speed.beta(), r, point.angle_at(speed, hub_time), omega);
    let angle = point.angle_at(speed, proper_time);
    ([point.hub.x0 + speed.beta() * t + r * angle.cos() / speed.gamma(), r * angle.sin()], angle)
}

#[test]
fn the_top_of_the_rim_moves_at_twice_the_speed_of_the_hub_added_as_speeds_are() {
    for beta in [0.01, 0.3, 0.6, 0.9, 0.99, 0.9999] {
        let speed = speed(beta);
        let top = WheelPoint { hub: SourcePoint { x0: 0.0, y: 0.0, z: RADIUS }, angle: FRAC_PI_2, ..VALVE };
        let bottom = WheelPoint { angle: -FRAC_PI_2, ..top };
        let h = 1e-3 / (speed.gamma() * speed.gamma());
        let moved = |point: &WheelPoint| measured(&speed, point, h).0[0] - measured(&speed, point, -h).0[0];
        let expected = 2.0 * beta / (1.0 + beta * beta);
        let error = (moved(&top) / (2.0 * h) - expected).abs();
        assert!(error < 1e-6 + 1e-15 / h, "{error:e} at {beta}");
        assert!(moved(&bottom).abs() / (2.0 * h) < 1e-4, "{beta}");
    }
}

/// In the measured wheel many even spokes crowd at the top, where they move fast and are late.
#[test]
fn measured_spokes_are_denser_at_the_top() {
    for beta in [0.3, 0.6, 0.93] {
        let speed = speed(beta);
        let spokes = 100_000;
        let (mut top, mut bottom) = (0.0, 0.0);
        for i in 0..spokes {
            let spoke = WheelPoint {
                hub: SourcePoint { x0: 0.0, y: 0.0, z: RADIUS },
                angle: TAU * f64::from(i) / f64::from(spokes),
                ..VALVE
            };
            let angle = measured(&speed, &spoke, 0.0).1.rem_euclid(TAU);
            // By the place of their ends along the rest frame's rim.
            let counts = |at: f64| f64::from(u8::from((angle - at).abs() < 0.02));
            top += counts(FRAC_PI_2);
            bottom += counts(3.0 * FRAC_PI_2);
        }
        let expected = (1.0 + beta * beta) / (1.0 - beta * beta);
        let ratio: f64 = top / bottom;
        assert!((ratio / expected - 1.0).abs() < 0.02, "{ratio} instead of {expected} at {beta}");
    }
}

/// Closest approach of two lines of sight, by the normal equations of their two multiples.
fn closest(pair: [Aperture; 2], views: [&Sighting; 2]) -> ([f64; 3], f64) {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let [a, b] = pair.map(|Aperture { x, y, z }| [x, y, z]);
    let [u, v] = views.map(|view| view.position);
    let w = [0, 1, 2].map(|i| b[i] - a[i]);
    let (uu, uv, vv, uw, vw) = (dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w));
    let determinant = uu * vv - uv * uv;
    let (l, r) = ((uw * vv - vw * uv) / determinant, (uw * uv - vw * uu) / determinant);
    let [p, q] = [[0, 1, 2].map(|i| a[i] + l * u[i]), [0, 1, 2].map(|i| b[i] + r * v[i])];
    let middle = [0, 1, 2].map(|i| 0.5 * (p[i] + q[i]) - 0.5 * (a[i] + b[i]));
    let apart = [0, 1, 2].map(|i| p[i] - q[i]);
    (middle, dot(apart, apart).sqrt())
}

#[test]
fn two_eyes_take_a_point_of_a_wheel_to_be_where_their_lines_of_sight_come_closest() {
    for beta in [0.1, 0.6, 0.9] {
        let speed = speed(beta);
        for point in points() {
            for baseline in [Baseline::straight(0.3), Baseline { separation: 0.3, roll: 0.4, turn: -0.3 }] {
                let pair = baseline.apertures();
                for time in [-2.0, 0.5, 3.7, 9.0] {
                    let Disparity { primary, secondary, .. } =
                        disparity(&speed, point, pair[0], pair[1], time).expect("inside the domain");
                    let Ok(Stereo { gain, position, miss }) = stereo(&speed, point, pair, time) else {
                        continue;
                    };
                    let (place, apart) = closest(pair, [&primary, &secondary]);
                    let size = position.iter().fold(0.0_f64, |size, part| size.max(part.abs()));
                    for i in 0..3 {
                        assert!((position[i] - place[i]).abs() < 1e-9 * size, "{position:?} {place:?}");
                    }
                    assert!((miss - apart).abs() < 1e-9 * size, "{miss} {apart}");
                    let share = parallax_along_resting(pair, [&primary, &secondary]);
                    assert!((gain - share).abs() < 1e-11 * gain, "{gain} {share}");
                }
            }
        }
    }
}

/// The part of the parallax, across the mean line of sight, along a resting point's, over that.
fn parallax_along_resting(pair: [Aperture; 2], views: [&Sighting; 2]) -> f64 {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let [u, v] = views.map(|view| view.position);
    let mean = [0, 1, 2].map(|i| u[i] + v[i]);
    let across = |a: [f64; 3]| {
        let along = dot(a, mean) / dot(mean, mean);
        [0, 1, 2].map(|i| a[i] - along * mean[i])
    };
    let [left, right] = pair.map(|Aperture { x, y, z }| [x, y, z]);
    let at_rest = across([0, 1, 2].map(|i| right[i] - left[i]));
    dot(across([0, 1, 2].map(|i| u[i] - v[i])), at_rest) / dot(at_rest, at_rest)
}

/// With V the velocity on the ground and n the line of sight the parallax is `e_x` - V `n_x`/(1 + V.n). The
/// part across n along that of a resting point, over that, is 1 - `n_x` (`V_x` - `n_x` V.n)/((1 + V.n)(1 -
/// `n_x`^2)).
#[test]
fn the_gain_of_close_eyes_has_a_limit() {
    let (speed, time) = (speed(0.9), 2.3);
    for point in points().filter(|point| point.rho > 0.0) {
        let limit = stereo(&speed, point, Aperture::pair(0.0), time).expect("it is in front");
        let at = |time| {
            let seen = seen(&speed, point, Aperture::default(), time);
            (seen.position, seen.retarded_time)
        };
        let ([before, after], h) = ([at(time - 1e-4), at(time + 1e-4)], at(time).0);
        let emitted = after.1 - before.1;
        let velocity = [0, 1, 2].map(|i| (after.0[i] - before.0[i]) / emitted);
        let distance = h.iter().map(|part| part * part).sum::<f64>().sqrt();
        let along: f64 = (0..3).map(|i| velocity[i] * h[i] / distance).sum();
        let n_x = h[0] / distance;
        let expected = 1.0 - n_x * (velocity[0] - n_x * along) / ((1.0 + along) * (1.0 - n_x * n_x));
        assert!((limit.gain - expected).abs() < 1e-6 * expected, "{} {expected} of {point:?}", limit.gain);
        for separation in [1e-13, 1e-9, 1e-5] {
            let near = stereo(&speed, point, Aperture::pair(separation), time).expect("it is in front");
            assert!((near.gain / limit.gain - 1.0).abs() < 1e-12 + 10.0 * separation, "{separation}");
            for i in 0..3 {
                let error = (near.position[i] - limit.position[i]).abs();
                assert!(error < (1e-12 + 100.0 * separation) * limit.distance(), "{error:e} at {separation}");
            }
        }
    }
}

/// Both eyes are then as far from one event on the point's worldline.
#[test]
fn at_the_equidistance_time_both_eyes_see_one_event() {
    for beta in BETAS {
        let speed = speed(beta);
        for point in points() {
            let pairs = [Aperture::pair(0.3), Baseline { separation: 0.3, roll: 0.1, turn: 0.2 }.apertures()];
            for [left, right] in pairs {
                let time = equidistance_time(&speed, point, [left, right])
                    .expect("inside the domain")
                    .expect("moving");
                let [a, b] = [left, right].map(|eye| seen(&speed, point, eye, time));
                let tolerance = 1e-13 * speed.gamma() * (time.abs() + a.distance);
                assert!((a.distance - b.distance).abs() < tolerance, "{a:?} {b:?}");
                assert!(
                    (a.proper_time - b.proper_time).abs() < 10.0 * tolerance * speed.gamma(),
                    "{a:?} {b:?}"
                );
            }
        }
        assert_eq!(equidistance_time(&Speed::REST, VALVE, Aperture::pair(0.3)), Ok(None));
    }
}

#[test]
fn a_published_model_looks_again_with_the_left_eye() {
    let pair = Aperture::pair(0.3);
    for beta in [0.3, 0.9, 0.99] {
        let speed = speed(beta);
        for (variant, sign) in [(PublishedVariant::AppendixA, -1.0), (PublishedVariant::TextSign, 1.0)] {
            for (point, time) in points().zip([-4.0, 0.0, 1.5, 3.0, 8.0].into_iter().cycle()) {
                let both = Model::Published(variant).disparity(&speed, point, pair, time).expect("along x");
                let first = seen(&speed, point, pair[0], time);
                let [x, y, z] = first.position;
                let delay = f64::sqrt((x - 0.3).powi(2) + y * y + z * z) - first.distance;
                let second = seen(&speed, point, pair[0], time + sign * delay);
                assert_eq!(both.primary, first);
                let error = |i: usize| (both.secondary.position[i] - second.position[i]).abs();
                assert!((0..3).all(|i| error(i) < 1e-10 * second.distance), "{both:?} {second:?}");
                assert!((both.secondary.doppler_factor / second.doppler_factor - 1.0).abs() < 1e-9);
                assert!((both.dphi - (first.phi() - second.phi())).abs() < 1e-11, "{both:?} {second:?}");
                assert!(
                    (both.dtheta - (first.theta() - second.theta())).abs() < 1e-11,
                    "{both:?} {second:?}"
                );
            }
        }
    }
}

#[test]
fn with_one_cone_both_look_at_what_the_middle_sees() {
    let (speed, pair) = (speed(0.9), Baseline { separation: 0.3, roll: 0.5, turn: 0.2 }.apertures());
    for point in points() {
        let both = one_cone_disparity(&speed, point, pair, 3.0).expect("inside the domain");
        let middle = seen(&speed, point, Aperture::default(), 3.0);
        for (eye, view) in pair.into_iter().zip([both.primary, both.secondary]) {
            let place = [eye.x, eye.y, eye.z];
            let error = |i: usize| (view.position[i] + place[i] - middle.position[i]).abs();
            assert!((0..3).all(|i| error(i) < 1e-14 * middle.distance));
            assert_eq!(
                [view.retarded_time, view.proper_time, view.doppler_factor],
                [middle.retarded_time, middle.proper_time, middle.doppler_factor]
            );
        }
        assert!((both.dphi - (both.primary.phi() - both.secondary.phi())).abs() < 1e-14);
        assert_eq!(
            Model::OneCone.stereo(&speed, point, pair, 3.0).expect("one event").position,
            middle.position
        );
    }
}

#[test]
fn what_is_no_wheel_is_named() {
    let name = |wheel: WheelPoint| {
        let DomainError { name, .. } =
            sighting(&Speed::REST, wheel, Aperture::default(), 0.0).expect_err("no wheel");
        name
    };
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(name(WheelPoint { radius, ..VALVE }), "wheel_radius");
    }
    for rho in [-1e-9, 1.001, f64::NAN] {
        assert_eq!(name(WheelPoint { rho, ..VALVE }), "rho");
    }
    assert_eq!(name(WheelPoint { angle: f64::INFINITY, ..VALVE }), "angle");
    assert_eq!(name(WheelPoint { turning: Turning::RimSpeed(1.0), ..VALVE }), "rim speed");
    let published = Model::Published(PublishedVariant::AppendixA);
    let error = published.stereo(&Speed::REST, VALVE, Aperture::pair(0.1), 0.0);
    assert_eq!(error, Err(StereoError::Published("published")));
    let tilted = [Aperture::default(), Aperture { z: 0.1, ..Aperture::default() }];
    assert!(published.disparity(&Speed::REST, VALVE, tilted, 0.0).is_err());
}

#[test]
fn every_result_is_finite_to_the_end_of_the_domain() {
    let extremes = [-1e60, -1.0, -1e-60, 0.0, 1e-30, 3.0, 1e60];
    for speed in [Speed::REST, speed(1e-9), speed(0.9), Speed::from_gamma(1e30).expect("a speed")] {
        for radius in [1e-60, 1.0, 1e60] {
            for index in 0..extremes.len().pow(3) {
                let [x0, z, time] = [1, 7, 49].map(|step| extremes[index / step % 7]);
                for (rho, angle) in [(1.0, 0.3), (1e-20, -2.0), (0.5, 1e60)] {
                    let hub = SourcePoint { x0, y: 0.0, z };
                    let point = WheelPoint { hub, radius, rho, angle, turning: Turning::Rolling };
                    let [left, right] = Aperture::pair(0.1);
                    let Disparity { primary, secondary, dphi, dtheta } =
                        disparity(&speed, point, left, right, time).expect("inside the domain");
                    for Sighting {
                        position: [x, y, z],
                        distance,
                        retarded_time,
                        proper_time,
                        doppler_factor,
                    } in [primary, secondary]
                    {
                        let all =
                            [x, y, z, distance, retarded_time, proper_time, doppler_factor, dphi, dtheta];
                        let is_finite = all.iter().all(|value| value.is_finite());
                        assert!(
                            is_finite && doppler_factor > 0.0,
                            "{all:?} of {point:?} at {time}, {speed:?}"
                        );
                    }
                }
            }
        }
    }
}
