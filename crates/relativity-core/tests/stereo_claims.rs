//! The stereo position of a moving body: each derived claim, against sightings and lines of sight crossed
//! here.

use nalgebra::{Matrix3, Rotation3, Vector3};
use relativity_core::aberration::rest_from_ground;
use relativity_core::{
    Aperture, Baseline, Model, PublishedVariant, SourcePoint, Speed, Stereo, StereoError, disparity,
    sighting, stereo,
};

type Vector = Vector3<f64>;

/// Small separation for functions that admit no 0.
const SMALL: f64 = 1e-4;
/// Half the length of a small body.
const STEP: f64 = 1e-3;
/// Places of a body at t = 0 (in its rest frame), and times of reception: ahead, abreast, behind, aside, and
/// high up.
const EVENTS: [([f64; 3], f64); 5] = [
    ([-4.0, 3.0, 2.0], -3.0),
    ([0.5, 3.0, 2.0], 3.5),
    ([2.0, 4.0, -1.0], 15.0),
    ([0.0, -5.0, 0.5], 0.0),
    ([1.0, 0.2, 6.0], -1.0),
];

fn speeds() -> [Speed; 3] {
    [0.5, 0.9, 0.99].map(|beta| Speed::from_beta(beta).expect("a speed"))
}

/// Every speed with every event.
fn cases() -> impl Iterator<Item = (Speed, Vector, f64)> {
    speeds().into_iter().flat_map(|speed| EVENTS.map(|(rest, time)| (speed, Vector::from(rest), time)))
}

fn source(speed: &Speed, rest: Vector) -> SourcePoint {
    SourcePoint::from_rest(rest.into(), speed)
}

/// Returns where one eye in the middle sees the point at `rest`.
fn seen(speed: &Speed, rest: Vector, time: f64) -> Vector {
    let seen = sighting(speed, source(speed, rest), Aperture::default(), time).expect("inside the domain");
    seen.position.into()
}

fn doppler_factor(speed: &Speed, rest: Vector, time: f64) -> f64 {
    sighting(speed, source(speed, rest), Aperture::default(), time).expect("inside the domain").doppler_factor
}

/// Returns the stereo position for eyes of this separation along the motion.
fn fused(speed: &Speed, rest: Vector, separation: f64, time: f64) -> Stereo {
    stereo(speed, source(speed, rest), Aperture::pair(separation), time).expect("inside the domain")
}

/// The middle of the shortest connection of the lines of sight of two eyes, `baseline` from one to the other;
/// how far along the line from each it ends comes with it, below 0 where the lines diverge.
fn crossing(speed: &Speed, rest: Vector, baseline: Vector, time: f64) -> (Vector, [f64; 2]) {
    let places = [-0.5 * baseline, 0.5 * baseline];
    let [u, v] = places.map(|place| {
        let aperture = Aperture { x: place.x, y: place.y, z: place.z };
        let seen = sighting(speed, source(speed, rest), aperture, time).expect("inside the domain");
        Vector::from(seen.position).normalize()
    });
    // baseline = s u - t v + a part across both.
    let normal = u.cross(&v);
    let along = [baseline.cross(&v), baseline.cross(&u)].map(|w| w.dot(&normal) / normal.norm_squared());
    (0.5 * (places[0] + along[0] * u + places[1] + along[1] * v), along)
}

/// Returns how the `image` of a small body at `rest` changes with each of its coordinates.
fn jacobian(rest: Vector, image: impl Fn(Vector) -> Vector) -> Matrix3<f64> {
    let column = |axis: usize| {
        let step = Vector::ith(axis, STEP);
        (image(rest + step) - image(rest - step)) / (2.0 * STEP)
    };
    Matrix3::from_columns(&[column(0), column(1), column(2)])
}

/// The same in directions along and across the lines of sight: rows by the ground's, columns by the rest
/// frame's, the first of each along the line, the second across it in the plane of the motion.
fn along_and_across(speed: &Speed, rest: Vector, time: f64, jacobian: Matrix3<f64>) -> Matrix3<f64> {
    let ground = seen(speed, rest, time).normalize();
    let there = Vector::from(rest_from_ground(ground.into(), speed));
    let basis = |along: Vector| {
        let aside = along.cross(&Vector::x()).normalize();
        Matrix3::from_columns(&[along, aside.cross(&along), aside])
    };
    basis(ground).transpose() * jacobian * basis(there)
}

fn assert_close(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!((a - b).abs() <= tolerance * (1.0 + b.abs()), "{what}: {a} and {b}");
}

fn assert_alike(a: Vector, b: Vector, tolerance: f64, what: &str) {
    assert!((a - b).norm() <= tolerance * b.norm(), "{what}: {a} and {b}");
}

#[test]
fn both_lines_of_sight_pass_through_the_stereo_position() {
    for (speed, rest, time) in cases() {
        let both = Aperture::pair(0.7).map(|eye| {
            let seen = sighting(&speed, source(&speed, rest), eye, time).expect("inside the domain");
            (Vector::new(eye.x, eye.y, eye.z), Vector::from(seen.position))
        });
        let fused = fused(&speed, rest, 0.7, time);
        for (eye, seen) in both {
            let towards = Vector::from(fused.position) - eye;
            assert_alike(towards * fused.gain, seen, 1e-12, "a line of sight, times the gain");
        }
        assert_close(fused.gain, (both[0].1.x - both[1].1.x) / 0.7, 1e-12, "the gain");
    }
}

#[test]
fn the_stereo_gain_is_gamma_d_for_eyes_that_are_close_together() {
    for (speed, rest, time) in cases() {
        let limit = speed.gamma() * doppler_factor(&speed, rest, time);
        let off = |separation: f64| (fused(&speed, rest, separation, time).gain / limit - 1.0).abs();
        assert!(off(0.0) < 1e-14 && off(1e-300) < 1e-14 && off(1e-9) < 1e-14, "{limit}");
        // It comes near with the square of the separation.
        assert_close(off(1e-2), 100.0 * off(1e-3), 1e-5, "departures");
    }
}

#[test]
fn a_resting_point_has_gain_1_and_is_taken_to_be_where_it_is() {
    for separation in [0.0, 0.1, 5.0, 1e5] {
        let point = SourcePoint { x0: -3.0, y: 2.0, z: 1.0 };
        let fused = stereo(&Speed::REST, point, Aperture::pair(separation), 4.0).expect("inside the domain");
        assert_eq!(fused.gain, 1.0);
        assert_alike(fused.position.into(), Vector::new(-3.0, 2.0, 1.0), 1e-10, "place");
    }
}

#[test]
fn two_eyes_take_a_point_to_be_the_rest_frames_distance_over_gamma_away() {
    for (speed, rest, time) in cases() {
        // In the rest frame the camera's event (T, 0) is at x = -gamma beta T.
        let camera = Vector::new(-speed.gamma() * speed.beta() * time, 0.0, 0.0);
        let distance = (rest - camera).norm() / speed.gamma();
        assert_close(fused(&speed, rest, 0.0, time).distance(), distance, 1e-14, "distance");
    }
}

#[test]
fn the_stereo_position_is_the_seen_one_times_1_plus_beta_n_x() {
    for (speed, rest, time) in cases() {
        let seen = seen(&speed, rest, time);
        let nearer = 1.0 + speed.beta() * seen.x / seen.norm();
        assert_alike(fused(&speed, rest, 0.0, time).position.into(), nearer * seen, 1e-13, "position");
    }
}

#[test]
fn two_eyes_see_a_small_body_turned_with_its_depth_over_gamma_and_its_width_over_gamma_d() {
    for (speed, rest, time) in cases() {
        let image = |rest| Vector::from(fused(&speed, rest, 0.0, time).position);
        let jacobian = jacobian(rest, image);
        let [depth, width] =
            [1.0, 1.0 / doppler_factor(&speed, rest, time)].map(|scale| scale / speed.gamma());
        let mut expected = [depth, width, width];
        expected.sort_by(|a, b| b.total_cmp(a));
        let singular_values = jacobian.singular_values();
        for (&value, expected) in singular_values.iter().zip(expected) {
            assert_close(value, expected, 1e-6, "singular value");
        }
        // Depth is along the line of sight, the body's own turned by aberration; nothing is sheared.
        let turned = along_and_across(&speed, rest, time, jacobian);
        let difference = turned - Matrix3::from_diagonal(&Vector::new(depth, width, width));
        assert!(difference.abs().max() < 1e-6, "{turned}");
    }
}

#[test]
fn one_light_cone_leaves_the_width_scales_depth_by_d_and_shears() {
    for (speed, rest, time) in cases() {
        let turned = along_and_across(&speed, rest, time, jacobian(rest, |rest| seen(&speed, rest, time)));
        let depth = doppler_factor(&speed, rest, time);
        let across = turned.fixed_view::<2, 2>(1, 1).singular_values();
        assert_close(across[0], 1.0, 1e-5, "greatest width");
        assert_close(across[1], 1.0, 1e-5, "least width");
        assert_close(turned[(0, 0)], depth, 1e-5, "depth");
        assert!(turned[(1, 0)].abs() < 1e-5 && turned[(2, 0)].abs() < 1e-5, "depth stays depth");
        // What is nearer the way that it comes from is seen earlier, and so farther back.
        let n = seen(&speed, rest, time).normalize();
        let shear = speed.beta() * (n.y * n.y + n.z * n.z).sqrt() / (1.0 + speed.beta() * n.x);
        assert_close(turned[(0, 1)].abs(), shear, 1e-5, "shear");
        assert_close(turned[(0, 2)], 0.0, 1e-5, "no shear across the plane of the motion");
    }
}

#[test]
fn with_one_light_cone_two_eyes_take_a_point_to_be_where_the_middle_sees_it() {
    for (speed, rest, time) in cases() {
        let point = source(&speed, rest);
        let fused =
            Model::OneCone.stereo(&speed, point, Aperture::pair(0.7), time).expect("inside the domain");
        let both =
            Model::OneCone.disparity(&speed, point, Aperture::pair(0.7), time).expect("inside the domain");
        let [left, right] = [both.primary, both.secondary].map(|seen| Vector::from(seen.position));
        assert_close(fused.gain, (left.x - right.x) / 0.7, 1e-12, "gain");
        assert_eq!(Vector::from(fused.position), seen(&speed, rest, time));
    }
}

/// Returns the stereo position for any two eyes.
fn fused_by(speed: &Speed, rest: Vector, baseline: Vector, time: f64) -> Result<Stereo, StereoError> {
    let [x, y, z] = (0.5 * baseline).into();
    let pair = [Aperture { x: -x, y: -y, z: -z }, Aperture { x, y, z }];
    stereo(speed, source(speed, rest), pair, time)
}

#[test]
fn any_two_eyes_take_a_point_to_be_where_their_lines_of_sight_come_closest() {
    let directions =
        [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.6, 0.0, 0.8], [0.48, -0.6, 0.64], [-0.8, 0.6, 0.1]];
    let mut apart = 0;
    for (speed, rest, time) in cases() {
        for (direction, separation) in directions.into_iter().flat_map(|d| [0.01, 0.7, 3.0].map(|s| (d, s))) {
            let baseline = separation * Vector::from(direction);
            let (place, along) = crossing(&speed, rest, baseline, time);
            let Ok(fused) = fused_by(&speed, rest, baseline, time) else {
                assert!(along.iter().any(|&along| along <= 0.0), "{along:?}");
                apart += 1;
                continue;
            };
            assert!(along.iter().all(|&along| along > 0.0), "{along:?}");
            // The lines crossed here are differences of sightings, which lose the separation over the
            // distance.
            assert_alike(fused.position.into(), place, 1e-8 / separation, "place");
            let each = [-0.5, 0.5].map(|side| {
                let [x, y, z] = (side * baseline).into();
                let seen = sighting(&speed, source(&speed, rest), Aperture { x, y, z }, time);
                (side * baseline, Vector::from(seen.expect("inside the domain").position))
            });
            let normal = each[0].1.cross(&each[1].1).normalize();
            assert!((fused.miss - baseline.dot(&normal).abs()).abs() < 1e-9 / separation, "{fused:?}");
            let mean = (each[0].1 + each[1].1).normalize();
            let across = |v: Vector| v - v.dot(&mean) * mean;
            let (parallax, at_rest) = (across(each[0].1 - each[1].1), across(baseline));
            let gain = parallax.dot(&at_rest) / at_rest.norm_squared();
            assert_close(fused.gain, gain, 1e-8 / separation, "gain");
        }
    }
    assert!((1..20).contains(&apart), "{apart} of them do not meet");
}

#[test]
fn nothing_changes_where_the_eyes_swap_their_places_or_the_origin_is_elsewhere() {
    for (speed, rest, time) in cases() {
        let (point, at) = (source(&speed, rest), Vector::new(0.3, -0.5, 0.2));
        let [left, right] = Baseline { separation: 0.4, roll: 0.5, turn: -0.3 }.apertures();
        let moved = |a: Aperture| Aperture { x: a.x + at.x, y: a.y + at.y, z: a.z + at.z };
        let moved_point = SourcePoint { x0: point.x0 + at.x, y: point.y + at.y, z: point.z + at.z };
        let Ok(there) = stereo(&speed, point, [left, right], time) else { continue };
        for (point, pair) in [(point, [right, left]), (moved_point, [moved(left), moved(right)])] {
            let same = stereo(&speed, point, pair, time).expect("they meet");
            assert_alike(same.position.into(), there.position.into(), 1e-12, "place");
            assert_close(same.gain, there.gain, 1e-12, "gain");
            assert!((same.miss - there.miss).abs() < 1e-13, "{same:?} {there:?}");
        }
    }
}

/// At 0.9 c, 41.99 degrees and 0.5864 by eyes along the motion, 0 and 0.4359 by eyes above each other.
#[test]
fn whether_a_rod_abreast_is_turned_depends_on_how_the_head_is_held() {
    let speed = Speed::from_beta(0.9).expect("a speed");
    let seen_by = |roll: f64| {
        let baseline = Baseline { separation: 1e-6, roll: roll.to_radians(), turn: 0.0 };
        rod_abreast(&speed, |rest| {
            let fused = stereo(&speed, source(&speed, rest), baseline.apertures(), 10.0);
            Vector::from(fused.expect("they meet").position)
        })
    };
    let [x, depth] = seen_by(0.0);
    assert!((depth.atan2(x).to_degrees() - 41.99).abs() < 0.005 && (depth.hypot(x) - 0.5864).abs() < 5e-5);
    let [x, depth] = seen_by(90.0);
    assert!(depth.abs() < 1e-6 && (x - 1.0 / speed.gamma()).abs() < 1e-6);
    // In between it turns as the head does.
    let turned = [0.0, 30.0, 60.0, 90.0].map(seen_by).map(|[x, depth]| depth.atan2(x));
    assert!(turned.windows(2).all(|two| two[1] < two[0]), "{turned:?}");
}

#[test]
fn one_light_cone_leaves_the_place_to_any_two_eyes() {
    for (speed, rest, time) in cases() {
        let pair = Baseline { separation: 0.7, roll: 1.0, turn: 0.4 }.apertures();
        let fused =
            Model::OneCone.stereo(&speed, source(&speed, rest), pair, time).expect("inside the domain");
        assert_alike(fused.position.into(), seen(&speed, rest, time), 1e-14, "place");
        assert_eq!((fused.gain, fused.miss), (1.0, 0.0));
    }
}

#[test]
fn a_published_model_has_both_eyes_along_the_motion_and_says_so() {
    let speed = Speed::from_beta(0.9).expect("a speed");
    let point = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };
    let pair = Baseline { separation: 0.1, roll: 0.1, turn: 0.0 }.apertures();
    let error = Model::Published(PublishedVariant::AppendixA).disparity(&speed, point, pair, 0.0);
    assert_eq!(
        error.expect_err("it knows no such pair").to_string(),
        "the model published has both eyes along the motion: the head can be neither tilted nor turned"
    );
}

#[test]
fn a_baseline_across_the_line_of_sight_gives_the_true_seen_distance() {
    for (speed, rest, time) in cases() {
        let seen = seen(&speed, rest, time);
        // One above the other before a point at their height, and heads turned to the point in two ways.
        let level = Vector::new(rest.x, rest.y, 0.0);
        let (place, _) = crossing(&speed, level, Vector::new(0.0, 0.0, SMALL), time);
        assert_alike(place, self::seen(&speed, level, time), 1e-6, "eyes above each other");
        for baseline in [seen.cross(&Vector::z()), seen.cross(&Vector::x())] {
            let (place, _) = crossing(&speed, rest, SMALL * baseline.normalize(), time);
            assert_alike(place, seen, 1e-6, "eyes across the line of sight");
        }
    }
}

#[test]
fn the_parallax_of_any_baseline_is_its_part_across_less_that_of_the_motion() {
    let baselines = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.48, -0.6, 0.64]];
    for (speed, rest, time) in cases() {
        let seen = seen(&speed, rest, time);
        let (r, n) = (seen.norm(), seen.normalize());
        let across = |v: Vector| v - v.dot(&n) * n;
        for b in baselines.map(Vector::from) {
            let direction = |sign: f64| {
                let [x, y, z] = (0.5 * sign * SMALL * b).into();
                let seen = sighting(&speed, source(&speed, rest), Aperture { x, y, z }, time);
                Vector::from(seen.expect("inside the domain").position).normalize()
            };
            let parallax = (direction(-1.0) - direction(1.0)) * (r / SMALL);
            let shift = speed.beta() * n.dot(&b) / (1.0 + speed.beta() * n.x);
            let expected = across(b) - shift * across(Vector::x());
            assert!((parallax - expected).norm() < 1e-6 * (1.0 + shift.abs()), "{parallax} {expected}");
        }
    }
}

#[test]
fn lines_of_sight_of_eyes_one_behind_the_other_can_diverge() {
    let speed = Speed::from_beta(0.9).expect("a speed");
    let behind = Vector::new(0.0, SMALL, 0.0);
    // They do where n_y^2 > 1 + beta n_x.
    for (n, diverges) in [([-0.8, 0.6, 0.01], true), ([0.6, 0.8, 0.01], false)] {
        let event = 5.0 * Vector::from(n);
        // Seen there at T = 0 by light that left 5 before.
        let x0 = event.x + speed.beta() * event.norm();
        let rest = Vector::new(speed.gamma() * x0, event.y, event.z);
        let (_, along) = crossing(&speed, rest, behind, 0.0);
        assert_eq!(along.map(|s| s < 0.0), [diverges; 2], "{n:?}: {along:?}");
        let fused = fused_by(&speed, rest, behind, 0.0);
        assert_eq!(fused.err(), diverges.then_some(StereoError::Apart), "{n:?}");
    }
}

/// The image of a short rod along the motion that is seen abreast, far away: its parts along the motion and
/// in depth, over its length.
fn rod_abreast(speed: &Speed, image: impl Fn(Vector) -> Vector) -> [f64; 2] {
    // At x = 0 at t = 0, which is seen at T = R.
    let along = Vector::new(STEP, 0.0, 0.0);
    let middle = Vector::new(0.0, 10.0, 0.0);
    let length = (image(middle + along) - image(middle - along)) / (2.0 * STEP);
    assert!(length.z.abs() < 1e-6, "{speed:?}: {length}");
    [length.x, length.y]
}

#[test]
fn two_eyes_along_the_motion_see_a_rod_abreast_turned_by_arctan_beta_and_shortened() {
    for speed in speeds() {
        let beta = speed.beta();
        let [x, depth] = rod_abreast(&speed, |rest| Vector::from(fused(&speed, rest, 0.0, 10.0).position));
        assert_close(depth.atan2(x), beta.atan(), 1e-6, "angle");
        assert_close(depth.hypot(x), (1.0 - beta.powi(4)).sqrt(), 1e-6, "length");
    }
}

#[test]
fn one_eye_sees_a_rod_abreast_as_if_it_were_turned_by_arcsin_beta() {
    for speed in speeds() {
        let middle = Vector::new(0.0, 10.0, 0.0);
        let jacobian = jacobian(middle, |rest| seen(&speed, rest, 10.0).normalize() * 10.0);
        // A rod across the view and one in depth are seen as the same two on a body at rest turned by arcsin
        // beta.
        let turned = Rotation3::from_axis_angle(&Vector::z_axis(), speed.beta().asin());
        let expected = Matrix3::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0) * turned.matrix();
        assert!((jacobian - expected).abs().max() < 1e-5, "{jacobian} {expected}");
    }
}

#[test]
fn two_eyes_above_each_other_see_a_rod_abreast_contracted_and_not_turned() {
    for speed in speeds() {
        let above = Vector::new(0.0, 0.0, 1e-3);
        let [x, depth] = rod_abreast(&speed, |rest| crossing(&speed, rest, above, 10.0).0);
        assert_close(x, 1.0 / speed.gamma(), 1e-5, "length");
        assert_close(depth, 0.0, 1e-5, "depth");
    }
}

#[test]
fn a_head_turned_to_the_body_sees_its_width_unchanged_and_its_depth_times_d_without_shear() {
    for (speed, rest, time) in cases() {
        let across = seen(&speed, rest, time).cross(&Vector::x());
        let baseline = 1e-3 * across.cross(&seen(&speed, rest, time)).normalize();
        let jacobian = jacobian(rest, |rest| crossing(&speed, rest, baseline, time).0);
        let turned = along_and_across(&speed, rest, time, jacobian);
        let depth = doppler_factor(&speed, rest, time);
        let difference = turned - Matrix3::from_diagonal(&Vector::new(depth, 1.0, 1.0));
        assert!(difference.abs().max() < 1e-4 * (1.0 + depth), "{turned} {depth}");
    }
}

#[test]
fn on_a_picture_plane_parallel_to_the_baseline_there_is_no_vertical_parallax() {
    let [left, right] = Aperture::pair(0.1);
    for (speed, rest, time) in cases() {
        let both = disparity(&speed, source(&speed, rest), left, right, time).expect("inside the domain");
        let heights = [both.primary, both.secondary].map(|seen| seen.position[2] / seen.position[1]);
        assert_eq!(heights[0], heights[1]);
    }
}

#[test]
fn a_published_model_has_no_stereo_position_and_says_so() {
    let speed = Speed::from_beta(0.9).expect("a speed");
    let point = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };
    let published = Model::Published(PublishedVariant::AppendixA);
    let pair = Aperture::pair(0.1);
    let error = published.stereo(&speed, point, pair, 0.0).expect_err("it has none");
    assert_eq!(error, StereoError::Published(published.name()));
    let said = "the model published has no stereo position: it measures both eyes' angles from the left eye";
    assert_eq!(error.to_string(), said);
    assert_eq!(Model::Exact.stereo(&speed, point, pair, 0.0), stereo(&speed, point, pair, 0.0));
}
