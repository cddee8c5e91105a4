//! Identities, limits and symmetries of the exact model, which hold whatever the numbers.

use proptest::prelude::*;
use relativity_core::aberration::{doppler_factor, ground_from_rest, rest_from_ground};
use relativity_core::{Aperture, SourcePoint, Speed, disparity, one_cone_disparity, sighting};

fn speed() -> impl Strategy<Value = Speed> {
    // Rapidity spans rest to gamma = 1e4 evenly in what it does to pictures.
    (0.0..9.9_f64).prop_map(|rapidity| Speed::from_rapidity(rapidity).expect("in range"))
}

fn direction() -> impl Strategy<Value = [f64; 3]> {
    (-1.0..1.0_f64, 0.0..std::f64::consts::TAU).prop_map(|(cosine, azimuth)| {
        let sine = (1.0 - cosine * cosine).sqrt();
        [cosine, sine * azimuth.cos(), sine * azimuth.sin()]
    })
}

fn point() -> impl Strategy<Value = SourcePoint> {
    (-10.0..10.0, -10.0..10.0, -10.0..10.0).prop_map(|(x0, y, z)| SourcePoint { x0, y, z })
}

fn aperture() -> impl Strategy<Value = Aperture> {
    (-1.0..1.0, -1.0..1.0, -1.0..1.0).prop_map(|(x, y, z)| Aperture { x, y, z })
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let norm = dot(a, a).sqrt();
    a.map(|v| v / norm)
}

/// Whether `a` and `b` agree to `tolerance` of `scale`.
fn close(a: f64, b: f64, tolerance: f64, scale: f64) -> bool {
    (a - b).abs() <= tolerance * scale
}

proptest! {
    #[test]
    fn what_is_seen_lies_on_the_light_cone(
        speed in speed(), point in point(), eye in aperture(), time in -30.0..30.0,
    ) {
        let seen = sighting(&speed, point, eye, time).expect("inside the domain");
        let [x, y, z] = seen.position;
        prop_assert!(close(x.hypot(y).hypot(z), seen.distance, 1e-14, seen.distance));
        // The event lies on the worldline, at the time when its light left.
        let travelled = point.x0 + speed.beta() * seen.retarded_time;
        let scale = time.abs() + seen.distance + 11.0;
        prop_assert!(close(x + eye.x, travelled, 1e-14, scale), "{} {}", x + eye.x, travelled);
    }

    #[test]
    fn the_doppler_factor_is_that_of_the_line_of_sight(
        speed in speed(), point in point(), eye in aperture(), time in -30.0..30.0,
    ) {
        let seen = sighting(&speed, point, eye, time).expect("inside the domain");
        prop_assume!(seen.distance > 1e-3);
        let n = seen.position.map(|v| v / seen.distance);
        // Near the forward direction the rounding of n alone is amplified by 1/(1 + beta n_x) < 2 gamma^2.
        let amplified = (seen.doppler_factor * speed.gamma()).max(1.0);
        let along = doppler_factor(n, &speed);
        prop_assert!(close(along, seen.doppler_factor, 4e-15 * amplified, along));
    }

    #[test]
    fn aberration_there_and_back_is_the_identity(speed in speed(), n in direction()) {
        let rest = rest_from_ground(n, &speed);
        prop_assert!(close(dot(rest, rest), 1.0, 4e-15, 1.0));
        let back = ground_from_rest(rest, &speed);
        // Backward directions on the ground crowd together in the rest frame by 1/D there.
        let amplified = (speed.gamma() / doppler_factor(n, &speed)).max(1.0) * speed.gamma().max(1.0);
        for (component, original) in back.iter().zip(n) {
            prop_assert!(close(*component, original, 4e-15 * amplified, 1.0), "{back:?} {n:?}");
        }
    }

    #[test]
    fn doppler_factors_there_and_back_multiply_to_one(speed in speed(), n in direction()) {
        let there = doppler_factor(n, &speed);
        let [x, y, z] = rest_from_ground(n, &speed);
        // Seen from the object, the ground moves at -beta.
        let back = doppler_factor([-x, y, z], &speed);
        let amplified = (speed.gamma() / there).max(1.0);
        prop_assert!(close(there * back, 1.0, 4e-15 * amplified, 1.0), "{there} {back}");
    }

    #[test]
    fn spheres_keep_a_circular_outline(
        speed in (0.0..3.0_f64).prop_map(|r| Speed::from_rapidity(r).expect("in range")),
        axis in direction(), radius in 0.01..1.5_f64,
    ) {
        // The rim of the cone around `axis` that touches a sphere in the rest frame.
        let across = unit(cross(axis, if axis[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] }));
        let other = cross(axis, across);
        let rim = |turn: f64| {
            let (sin, cos) = radius.sin_cos();
            let (s, c) = turn.sin_cos();
            unit(std::array::from_fn(|i| cos * axis[i] + sin * (c * across[i] + s * other[i])))
        };
        let seen = |turn: f64| ground_from_rest(rim(turn), &speed);
        // A circle on the unit sphere lies in a plane: that of three of its points.
        let [a, b, c] = [0.0, 2.1, 4.2].map(seen);
        let minus = |p: [f64; 3], q: [f64; 3]| std::array::from_fn(|i| p[i] - q[i]);
        let normal = cross(minus(b, a), minus(c, a));
        let size = dot(normal, normal).sqrt();
        prop_assume!(size > 1e-6);
        for step in 0..12 {
            let p = seen(f64::from(step) * 0.5);
            let off = dot(minus(p, a), normal) / size;
            prop_assert!(off.abs() < 1e-9, "{off} off the plane");
        }
    }

    #[test]
    fn slow_points_are_seen_with_the_plain_delay(
        beta in 1e-12..1e-6_f64, point in point(), eye in aperture(), time in -30.0..30.0,
    ) {
        let speed = Speed::from_beta(beta).expect("in range");
        let seen = sighting(&speed, point, eye, time).expect("inside the domain");
        let plain = |x: f64| (x.powi(2) + (point.y - eye.y).powi(2) + (point.z - eye.z).powi(2)).sqrt();
        // To first order in beta the light left at T - R with R the distance at that time.
        let here = point.x0 - eye.x + beta * time;
        let delayed = here - beta * plain(here);
        prop_assert!(close(seen.position[0], delayed, 2.0 * beta * beta + 1e-15, 100.0));
        let first_order = 1.0 - beta * here / plain(here).max(1e-3);
        prop_assume!(plain(here) > 0.1);
        prop_assert!(close(seen.doppler_factor, first_order, 100.0 * beta * beta + 1e-15, 1.0));
    }

    #[test]
    fn far_points_move_at_the_apparent_speeds(speed in speed(), y in -1.0..1.0_f64) {
        let point = SourcePoint { x0: 0.0, y, z: 0.5 };
        let beta = speed.beta();
        prop_assume!(beta > 0.01);
        let far = 1e9;
        let x = |time: f64| sighting(&speed, point, Aperture::default(), time).expect("inside").position[0];
        let approach = (x(-far) - x(-2.0 * far)) / far;
        let recession = (x(2.0 * far) - x(far)) / far;
        let (ahead, behind) = (beta / speed.one_minus_beta(), beta / (1.0 + beta));
        prop_assert!(close(approach, ahead, 1e-7, ahead), "{approach} {ahead}");
        prop_assert!(close(recession, behind, 1e-7, behind), "{recession} {behind}");
    }

    #[test]
    fn short_rods_look_stretched_by_the_head_on_doppler_factor(speed in speed(), length in 0.01..1.0_f64) {
        let ratio = speed.head_on_doppler_factor();
        prop_assume!(speed.beta() > 0.01);
        let end = |xr: f64, time: f64| {
            let point = SourcePoint::from_rest([xr, 0.0, 0.0], &speed);
            sighting(&speed, point, Aperture::default(), time).expect("inside").position[0]
        };
        let time = 100.0;
        let ahead = (end(length, -time) - end(0.0, -time)) / length;
        let behind = (end(length, time) - end(0.0, time)) / length;
        // The two positions are near 100 times the stretch squared, and their difference loses as much.
        let lost = 1e-13 * time / length;
        prop_assert!(close(ahead, ratio, lost * ratio, ratio), "{ahead} {ratio}");
        prop_assert!(close(behind, 1.0 / ratio, lost * ratio, 1.0 / ratio), "{behind} {ratio}");
    }

    #[test]
    fn both_eyes_are_equally_far_at_the_equidistance_time(
        speed in speed(), point in point(), left in aperture(), right in aperture(),
    ) {
        prop_assume!(speed.beta() > 0.01 && (left.x - right.x).abs() > 0.1);
        let t0 = relativity_core::equidistance_time(&speed, point, [left, right]).expect("inside").expect("moving");
        let both = disparity(&speed, point, left, right, t0).expect("inside the domain");
        let scale = (t0.abs() + 30.0) / (left.x - right.x).abs().min(1.0);
        prop_assert!(close(both.primary.distance, both.secondary.distance, 1e-13, scale));
    }

    /// For eyes close together, two light cones multiply disparities by the gain.
    #[test]
    fn two_light_cones_make_the_gain_times_the_disparities_of_one(
        rapidity in 0.0..3.0_f64, point in point(), time in -30.0..30.0,
    ) {
        let speed = Speed::from_rapidity(rapidity).expect("in range");
        let middle = sighting(&speed, point, Aperture::default(), time).expect("inside the domain");
        let off_axis = point.y.hypot(point.z);
        prop_assume!(off_axis > 0.3 && point.y.abs() > 0.1);
        let separation = 1e-6 * off_axis;
        let [left, right] = Aperture::pair(separation);
        let two = disparity(&speed, point, left, right, time).expect("inside the domain");
        let one = one_cone_disparity(&speed, point, [left, right], time).expect("inside the domain");
        let gain = speed.gamma() * middle.doppler_factor;
        let scale = gain * separation / middle.position[0].hypot(point.y);
        prop_assert!(close(two.dphi, gain * one.dphi, 1e-3, scale), "{} {} {gain}", two.dphi, one.dphi);
        prop_assert!(close(two.dtheta, gain * one.dtheta, 1e-3, scale), "{} {} {gain}", two.dtheta, one.dtheta);
        // At one event, which its own clock dates.
        prop_assert_eq!(one.primary.proper_time, one.secondary.proper_time);
        prop_assert_eq!(one.primary.retarded_time, middle.retarded_time);
    }

    #[test]
    fn a_mirror_changes_only_the_mirrored_coordinate(
        speed in speed(), point in point(), eye in aperture(), time in -30.0..30.0,
    ) {
        let seen = sighting(&speed, point, eye, time).expect("inside the domain");
        let (mirrored, mirrored_eye) = (SourcePoint { y: -point.y, ..point }, Aperture { y: -eye.y, ..eye });
        let image = sighting(&speed, mirrored, mirrored_eye, time).expect("inside the domain");
        let [x, y, z] = seen.position;
        prop_assert_eq!(image.position, [x, -y, z]);
        prop_assert_eq!(image.doppler_factor, seen.doppler_factor);
    }

    #[test]
    fn exchanging_the_eyes_changes_the_sign_of_the_disparities(
        speed in speed(), point in point(), a in aperture(), b in aperture(), time in -30.0..30.0,
    ) {
        let one = disparity(&speed, point, a, b, time).expect("inside the domain");
        let other = disparity(&speed, point, b, a, time).expect("inside the domain");
        prop_assume!(one.dphi.abs() < 3.1);
        prop_assert!(close(one.dphi, -other.dphi, 1e-9, 1.0), "{} {}", one.dphi, other.dphi);
        prop_assert!(close(one.dtheta, -other.dtheta, 1e-9, 1.0), "{} {}", one.dtheta, other.dtheta);
        // And they are what the two sightings' own angles differ by.
        prop_assert!(close(one.dtheta, one.primary.theta() - one.secondary.theta(), 1e-9, 1.0));
    }
}
