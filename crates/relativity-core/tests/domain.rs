//! The edges of the domain: every result finite inside, an error outside, and rest as a speed like any other.

use relativity_core::aberration::{doppler_factor, ground_from_rest, rest_from_ground};
use relativity_core::batch::{
    BatchError, Column, DisparityColumns, ObservationColumns, PointColumns, Real, SightingColumns, Speeds,
    Threads, sightings_of_points,
};
use relativity_core::{
    Aperture, Disparity, MAX_COORDINATE, MAX_GAMMA, PublishedVariant, Sighting, SourcePoint, Speed,
    SpeedError, StereoError, batch, disparities, disparity, equidistance_time, one_cone_disparity,
    printed_apparent_x, published_disparity, sighting, stereo,
};

fn speeds() -> Vec<Speed> {
    let betas = [0.0, f64::MIN_POSITIVE, 1e-14, 0.9, 1.0 - f64::EPSILON / 2.0].map(Speed::from_beta);
    let gammas = [1.0, 1.0 + f64::EPSILON, 7.0, 1e12, MAX_GAMMA].map(Speed::from_gamma);
    let rapidities = [0.0, f64::MIN_POSITIVE, 30.0, 69.7].map(Speed::from_rapidity);
    betas.into_iter().chain(gammas).chain(rapidities).map(|speed| speed.expect("in range")).collect()
}

const CORNERS: [f64; 9] =
    [0.0, -0.0, f64::MIN_POSITIVE, -1e-200, 1e-100, 1.0, -1.0, MAX_COORDINATE, -MAX_COORDINATE];

/// Returns the combinations of corners for `N` numbers, thinned by `stride`.
fn corners<const N: usize>(stride: usize) -> impl Iterator<Item = [f64; N]> {
    let count = CORNERS.len().pow(N as u32);
    (0..count).step_by(stride).map(|mut index| {
        std::array::from_fn(|_| {
            let corner = CORNERS[index % CORNERS.len()];
            index /= CORNERS.len();
            corner
        })
    })
}

fn assert_sighting(seen: &Sighting, context: &str) {
    let Sighting { position, distance, retarded_time, proper_time, doppler_factor } = *seen;
    let angles = [seen.phi(), seen.theta()];
    let all =
        position.into_iter().chain(angles).chain([distance, retarded_time, proper_time, doppler_factor]);
    assert!(all.into_iter().all(f64::is_finite), "{seen:?} for {context}");
    assert!(distance >= 0.0 && doppler_factor > 0.0, "{seen:?} for {context}");
    assert!(seen.intensity(2.0).is_finite() && seen.intensity(4.0).is_finite());
}

fn assert_disparity(both: &Disparity, context: &str) {
    assert_sighting(&both.primary, context);
    assert_sighting(&both.secondary, context);
    assert!(both.dphi.abs() <= std::f64::consts::PI, "{both:?} for {context}");
    assert!(both.dtheta.abs() <= std::f64::consts::PI, "{both:?} for {context}");
}

#[test]
fn every_sighting_in_the_domain_is_finite() {
    for speed in speeds() {
        for [x0, y, z, time, x] in corners(7) {
            let (point, aperture) = (SourcePoint { x0, y, z }, Aperture { x, y: -z, z: y });
            let context = format!("{speed:?} {point:?} {aperture:?} {time}");
            assert_sighting(&sighting(&speed, point, aperture, time).expect("inside the domain"), &context);
            let printed = printed_apparent_x(&speed, point, aperture, time).expect("inside the domain");
            assert!(printed.is_finite(), "{context}");
        }
    }
}

#[test]
fn every_disparity_in_the_domain_is_finite() {
    for speed in speeds() {
        for [x0, y, z, time, a, b] in corners(61) {
            let point = SourcePoint { x0, y, z };
            let (primary, secondary) = (Aperture { x: a, y: b, z: -a }, Aperture { x: b, y: -b, z: a });
            let context = format!("{speed:?} {point:?} {primary:?} {secondary:?} {time}");
            let both = disparity(&speed, point, primary, secondary, time).expect("inside the domain");
            assert_disparity(&both, &context);
            for variant in [PublishedVariant::AppendixA, PublishedVariant::TextSign] {
                let both = published_disparity(&speed, point, a, time, variant).expect("inside the domain");
                assert_disparity(&both, &context);
            }
            let both =
                one_cone_disparity(&speed, point, [primary, secondary], time).expect("inside the domain");
            assert_disparity(&both, &context);
            let fused = stereo(&speed, point, Aperture::pair(a), time).expect("inside the domain");
            assert!(fused.gain > 0.0 && fused.gain.is_finite(), "{fused:?} for {context}");
            assert!(fused.distance().is_finite() && fused.miss == 0.0, "{fused:?} for {context}");
            match stereo(&speed, point, [primary, secondary], time) {
                Ok(fused) => {
                    assert!(fused.gain > 0.0 && fused.gain.is_finite(), "{fused:?} for {context}");
                    let lengths = fused.position.into_iter().chain([fused.miss]);
                    assert!(lengths.into_iter().all(f64::is_finite), "{fused:?} for {context}");
                }
                Err(error) => assert_eq!(error, StereoError::Apart, "{context}"),
            }
            for pair in [Aperture::pair(a), [primary, secondary]] {
                let t0 = equidistance_time(&speed, point, pair).expect("inside the domain");
                assert!(t0.is_none_or(f64::is_finite), "{context}");
            }
        }
    }
}

#[test]
fn every_single_precision_result_in_the_domain_is_finite() {
    let single = [0.0, -0.0, f32::MIN_POSITIVE, 1e-20, -1e-4, 1.0, f32::MAX_COORDINATE, -f32::MAX_COORDINATE];
    for speed in speeds()
        .iter()
        .filter(|speed| speed.gamma() <= f32::MAX_GAMMA)
        .copied()
        .chain([Speed::from_gamma(f32::MAX_GAMMA).expect("in range")])
    {
        for x0 in single {
            for y in single {
                for time in single {
                    let [mut x, mut t, mut d, mut dphi, mut dtheta] = [[f32::NAN]; 5];
                    let aperture = Aperture { x: y.into(), y: x0.into(), z: time.into() };
                    let out =
                        SightingColumns { apparent_x: &mut x, retarded_time: &mut t, doppler_factor: &mut d };
                    let points = PointColumns { x0: &[x0], y: &[y], z: &[-time] };
                    sightings_of_points(&speed, points, aperture, time, out, Threads::One).expect("inside");
                    let observations = ObservationColumns {
                        speeds: Speeds::Same(speed),
                        x0: Column::Same(x0),
                        y: Column::Same(y),
                        z: Column::Same(-y),
                        times: Column::Same(time),
                        apertures: [Aperture::default(), aperture],
                    };
                    let out = DisparityColumns { dphi: &mut dphi, dtheta: &mut dtheta };
                    batch::disparities(&observations, out, Threads::One).expect("inside");
                    let all = [x, t, d, dphi, dtheta].concat();
                    assert!(all.iter().all(|v| v.is_finite()), "{all:?} for {speed:?} {x0} {y} {time}");
                }
            }
        }
    }
}

#[test]
fn every_line_of_sight_is_finite() {
    let axes = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [-0.6, 0.8, 0.0]];
    for speed in speeds() {
        for n in axes {
            let [there, back] = [rest_from_ground(n, &speed), ground_from_rest(n, &speed)];
            assert!(there.into_iter().chain(back).all(|v| v.abs() <= 1.0 + 1e-15), "{n:?} {speed:?}");
            assert!(doppler_factor(n, &speed).is_finite() && doppler_factor(n, &speed) > 0.0);
        }
    }
}

#[test]
fn a_point_inside_the_aperture_has_the_documented_sighting() {
    let aperture = Aperture { x: 3.0, y: -1.0, z: 0.5 };
    let point = SourcePoint { x0: 3.0, y: -1.0, z: 0.5 };
    for speed in speeds() {
        let seen = sighting(&speed, point, aperture, 0.0).expect("inside the domain");
        assert_eq!(seen.position, [0.0; 3]);
        assert_eq!([seen.distance, seen.retarded_time, seen.phi(), seen.theta()], [0.0; 4]);
        let off = seen.doppler_factor - speed.gamma();
        assert!(off.abs() <= f64::EPSILON * speed.gamma(), "{seen:?} for {speed:?}");
    }
}

#[test]
fn a_point_on_the_axis_is_seen_head_on_until_it_passes() {
    let point = SourcePoint { x0: 0.0, y: 0.0, z: 0.0 };
    for beta in [1e-14, 0.3, 0.9, 1.0 - 1e-12] {
        let speed = Speed::from_beta(beta).expect("in range");
        let ratio = speed.head_on_doppler_factor();
        for (time, x, doppler) in
            [(-1e-6, -1e-6 * beta / (1.0 - beta), ratio), (1e-6, 1e-6 * beta / (1.0 + beta), 1.0 / ratio)]
        {
            let seen = sighting(&speed, point, Aperture::default(), time).expect("inside the domain");
            assert!((seen.position[0] / x - 1.0).abs() < 4e-16 * 4.0, "{seen:?}");
            assert!((seen.doppler_factor / doppler - 1.0).abs() < 4e-16 * 4.0, "{seen:?}");
        }
    }
}

#[test]
fn speeds_out_of_range_are_errors_that_name_the_value() {
    for beta in [1.0, 1.5, -0.1, f64::NAN, f64::INFINITY] {
        let error = Speed::from_beta(beta).expect_err("not a speed");
        assert!(
            matches!(error, SpeedError::Beta(_)) && error.to_string().contains(&format!("beta = {beta}"))
        );
    }
    for gamma in [0.999, 0.0, -2.0, 1e31, f64::NAN] {
        assert!(matches!(Speed::from_gamma(gamma), Err(SpeedError::Gamma(_))), "{gamma}");
    }
    for rapidity in [-1e-3, 70.0, 1e6, f64::NAN, f64::INFINITY] {
        assert!(matches!(Speed::from_rapidity(rapidity), Err(SpeedError::Rapidity(_))), "{rapidity}");
    }
}

#[test]
fn coordinates_out_of_range_are_errors_that_name_the_coordinate() {
    let point = SourcePoint { x0: 0.0, y: 1.0, z: 1.0 };
    let [left, right] = Aperture::pair(0.3);
    for bad in [f64::NAN, f64::INFINITY, -2e60] {
        let error = sighting(&Speed::REST, SourcePoint { y: bad, ..point }, left, 0.0).expect_err("outside");
        assert_eq!(error.name, "y");
        let error =
            disparity(&Speed::REST, point, left, Aperture { z: bad, ..right }, 0.0).expect_err("outside");
        assert_eq!(error.name, "aperture z");
        assert_eq!(sighting(&Speed::REST, point, left, bad).expect_err("outside").name, "T");
        let variant = PublishedVariant::AppendixA;
        assert_eq!(
            published_disparity(&Speed::REST, point, bad, 0.0, variant).expect_err("outside").name,
            "d"
        );
        assert_eq!(
            equidistance_time(&Speed::REST, point, [Aperture { x: bad, ..Aperture::default() }; 2])
                .expect_err("outside")
                .name,
            "aperture x"
        );
    }
}

#[test]
fn at_rest_everything_is_where_it_is() {
    let point = SourcePoint { x0: 1.0, y: 2.0, z: 2.0 };
    let seen = sighting(&Speed::REST, point, Aperture::default(), 5.0).expect("inside the domain");
    assert_eq!(seen.position, [1.0, 2.0, 2.0]);
    assert_eq!([seen.distance, seen.retarded_time, seen.doppler_factor], [3.0, 2.0, 1.0]);
    assert_eq!(equidistance_time(&Speed::REST, point, Aperture::pair(0.3)), Ok(None));
}

#[test]
fn many_apertures_are_each_compared_with_the_first() {
    let speed = Speed::from_beta(0.9).expect("in range");
    let point = SourcePoint { x0: 0.2, y: 2.0, z: 1.0 };
    let apertures = [0.0, 0.1, -0.4].map(|x| Aperture { x, y: x * x, z: 0.5 * x });
    let all = disparities(&speed, point, &apertures, 1.0).expect("inside the domain");
    assert_eq!(all.len(), 3);
    assert_eq!([all[0].dphi, all[0].dtheta], [0.0, 0.0]);
    for (both, aperture) in all.iter().zip(apertures) {
        let difference = both.primary.phi() - sighting(&speed, point, aperture, 1.0).expect("inside").phi();
        assert!((both.dphi - difference).abs() < 1e-15);
    }
    assert_eq!(disparities(&speed, point, &[], 1.0), Ok(vec![]));
}

#[test]
fn batches_name_the_row_or_the_column_at_fault() {
    let mut good = vec![1.0_f64; 9000];
    let [mut x, mut t, mut d] = [(); 3].map(|()| vec![0.0; 9000]);
    let mut run = |x0: &[f64], y: &[f64], threads| {
        let out = SightingColumns { apparent_x: &mut x, retarded_time: &mut t, doppler_factor: &mut d };
        let points = PointColumns { x0, y, z: y };
        sightings_of_points(&Speed::REST, points, Aperture::default(), 0.0, out, threads)
    };
    assert_eq!(run(&good, &good, Threads::All), Ok(()));
    let short = BatchError::Length { column: "y", expected: 9000, found: 8999 };
    assert_eq!(run(&good, &good[1..], Threads::One), Err(short));
    let other = good.clone();
    good[8500] = f64::NAN;
    good[8700] = 1e61;
    for threads in [Threads::One, Threads::All] {
        let error = run(&other, &good, threads).expect_err("a row is outside");
        assert!(matches!(error, BatchError::Row { index: 8500, column: "y", .. }), "{error}");
    }
}
