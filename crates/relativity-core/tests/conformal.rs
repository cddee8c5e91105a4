//! Conformal coordinates: motion is a slide by the rapidity, and the disparity is that of a resting point for
//! wider eyes.

use relativity_core::{
    Aperture, Baseline, Conformal, HeadAxes, MAX_GAMMA, Model, PublishedVariant, SourcePoint, Speed, Turning,
    WheelPoint, sighting,
};

const POINT: SourcePoint = SourcePoint { x0: 0.3, y: 3.0, z: 2.0 };
const BETAS: [f64; 7] = [1e-9, 0.1, 0.5, 0.9, 0.99, 0.999_999, 0.999_999_999_999];

fn straight() -> HeadAxes {
    Baseline::straight(0.0).axes()
}

fn times() -> impl Iterator<Item = f64> {
    (-60..=60).map(|step| f64::from(step * step * step) * 1e-3)
}

fn seen(speed: &Speed, point: SourcePoint, time: f64) -> Conformal {
    let seen = sighting(speed, point, Aperture::default(), time).expect("inside the domain");
    straight().conformal(seen.position).expect("off the baseline")
}

#[test]
fn motion_slides_a_point_back_by_its_rapidity() {
    let rho = 13.0_f64.sqrt();
    for beta in BETAS {
        let speed = Speed::from_beta(beta).expect("a speed");
        for time in times() {
            let moving = seen(&speed, POINT, time);
            let xi = speed.gamma() * (POINT.x0 + beta * time);
            let expected = (xi / rho).asinh() - beta.atanh();
            // Where the sum x0 + beta T cancels, xi is worse known than u.
            let tolerance =
                1e-14 * (1.0 + expected.abs()) + 1e-15 * speed.gamma() / rho / (xi / rho).hypot(1.0);
            assert!(
                (moving.u - expected).abs() <= tolerance,
                "beta = {beta}, T = {time}: {}",
                moving.u - expected
            );
            assert_eq!(moving.v, 2.0_f64.atan2(3.0));
        }
    }
}

/// The point that is objectively abreast is seen the rapidity behind: 1.4722 at 0.9 c, as read from a ruler
/// on the picture.
#[test]
fn what_is_abreast_is_seen_behind_by_the_rapidity() {
    let point = SourcePoint { x0: 0.0, ..POINT };
    for (beta, slide) in [(0.5, 0.5493), (0.9, 1.4722), (0.99, 2.6467)] {
        let speed = Speed::from_beta(beta).expect("a speed");
        assert!((seen(&speed, point, 0.0).u + slide).abs() < 5e-5);
    }
    let speed = Speed::from_gamma(1000.0).expect("a speed");
    assert!((seen(&speed, point, 0.0).u + 7.6009).abs() < 5e-5);
}

#[test]
fn the_doppler_factor_depends_on_the_column_alone() {
    for beta in BETAS {
        let speed = Speed::from_beta(beta).expect("a speed");
        for time in times() {
            let doppler = sighting(&speed, POINT, Aperture::default(), time).expect("inside").doppler_factor;
            let u = seen(&speed, POINT, time).u;
            let expected = u.cosh() / (u + speed.rapidity()).cosh();
            // D is e^-u for what is far aside: an error of u is a relative one of D.
            assert!((doppler / expected - 1.0).abs() < 1e-14 * (1.0 + u.abs()), "beta = {beta}, T = {time}");
        }
    }
}

#[test]
fn two_eyes_see_the_disparity_of_a_resting_point_with_eyes_gamma_d_apart() {
    for gamma in [1.0, 1.25, 2.3, 10.0, 1e3, 1e6] {
        let speed = Speed::from_gamma(gamma).expect("a speed");
        for d in [1e-9, 0.1, 3.0] {
            let [narrow, wide] = [d, gamma * d].map(Baseline::straight);
            for time in times() {
                // S without rounding, so that xi has none of its own: the point is at beta T from the middle.
                let point = SourcePoint { x0: 0.0, ..POINT };
                let resting = SourcePoint { x0: gamma * (speed.beta() * time), ..POINT };
                let of = |speed: &Speed, point, head: Baseline| {
                    let both = Model::Exact.conformal(speed, point, head.apertures(), &head.axes(), time);
                    both.expect("inside the domain").expect("off the baseline")
                };
                let (moving, resting) = (of(&speed, point, narrow), of(&Speed::REST, resting, wide));
                let error = (moving.du - resting.du).abs();
                assert!(error <= 4e-15 * resting.du.abs(), "gamma = {gamma}, d = {d}, T = {time}: {error:e}");
                assert_eq!((moving.dv, resting.dv), (0.0, 0.0));
                let slide = resting.primary.u - moving.primary.u;
                assert!((slide - speed.rapidity()).abs() < 1e-13, "gamma = {gamma}, T = {time}: {slide}");
            }
        }
    }
}

#[test]
fn a_turned_head_sees_the_same_place_in_its_own_axes() {
    let head = Baseline { separation: 0.2, roll: 0.4, turn: -0.7 };
    let axes = head.axes();
    let place = [-3.0, 2.0, 0.5];
    let Conformal { u, v } = axes.conformal(place).expect("off the baseline");
    let length = (9.0_f64 + 4.0 + 0.25).sqrt();
    // n = right tanh u + (ahead cos v + up sin v)/cosh u.
    let HeadAxes { right, ahead, up } = axes;
    for (i, along) in place.into_iter().enumerate() {
        let n = right[i] * u.tanh() + (ahead[i] * v.cos() + up[i] * v.sin()) / u.cosh();
        assert!((n - along / length).abs() < 1e-15);
    }
    assert_eq!(straight(), HeadAxes { right: [1.0, 0.0, 0.0], ahead: [0.0, 1.0, 0.0], up: [0.0, 0.0, 1.0] });
}

#[test]
fn the_differences_are_those_of_both_coordinates_in_every_model_and_of_wheels() {
    let wheel = WheelPoint { hub: POINT, radius: 0.5, rho: 1.0, angle: 0.7, turning: Turning::Rolling };
    let speed = Speed::from_beta(0.9).expect("a speed");
    let heads = [Baseline::straight(0.3), Baseline { separation: 0.3, roll: 0.5, turn: 1.1 }];
    for (head, models) in heads.iter().zip([&Model::ALL[..], &Model::ALL[..2]]) {
        for &model in models {
            for source in [POINT.into(), relativity_core::Source::from(wheel)] {
                for time in times() {
                    let (pair, axes) = (head.apertures(), head.axes());
                    let both = model.conformal(&speed, source, pair, &axes, time).expect("inside the domain");
                    let both = both.expect("off the baseline");
                    let tell = || format!("{model:?} {source:?} T = {time}: {both:?}");
                    assert!((both.du - (both.primary.u - both.secondary.u)).abs() < 1e-12, "{}", tell());
                    assert!((both.dv - (both.primary.v - both.secondary.v)).abs() < 1e-12, "{}", tell());
                    let seen = model.disparity(&speed, source, pair, time).expect("inside the domain");
                    let each = [seen.primary, seen.secondary].map(|seen| axes.conformal(seen.position));
                    for (of, expected) in each.into_iter().zip([both.primary, both.secondary]) {
                        let of = of.expect("off the baseline");
                        assert!((of.u - expected.u).abs() < 1e-12 && (of.v - expected.v).abs() < 1e-12);
                    }
                }
            }
        }
    }
}

#[test]
fn a_published_model_has_no_tilted_head() {
    let head = Baseline { roll: 0.5, ..Baseline::straight(0.1) };
    let published = Model::Published(PublishedVariant::AppendixA);
    assert!(published.conformal(&Speed::REST, POINT, head.apertures(), &head.axes(), 0.0).is_err());
}

#[test]
fn nothing_is_infinite_at_the_ends_of_the_domain() {
    let tiny = f64::MIN_POSITIVE;
    for gamma in [1.0, 1e3, 1e30, MAX_GAMMA] {
        let speed = Speed::from_gamma(gamma).expect("a speed");
        for time in [-1e60, -1e12, -1.0, 0.0, 1e-12, 1.0, 1e12, 1e60] {
            for [y, z] in [[3.0, 2.0], [1e-300, 0.0], [0.0, tiny], [1e60, -1e60], [-1.0, -0.0], [0.0, 0.0]] {
                for d in [0.0, 1e-12, 0.1, 1e12] {
                    for (roll, turn) in [(0.0, 0.0), (0.3, -2.0), (1.5, 3.0)] {
                        let head = Baseline { separation: d, roll, turn };
                        let point = SourcePoint { x0: 0.0, y, z };
                        let both = Model::Exact
                            .conformal(&speed, point, head.apertures(), &head.axes(), time)
                            .expect("inside the domain");
                        let Some(both) = both else { continue };
                        let all = [both.primary.u, both.primary.v, both.secondary.u, both.secondary.v];
                        let is_finite = all.iter().chain([&both.du, &both.dv]).all(|value| value.is_finite());
                        assert!(is_finite, "gamma = {gamma}, T = {time}, {point:?}, {head:?}: {both:?}");
                    }
                }
            }
        }
    }
    let far = seen(&Speed::from_gamma(1e30).expect("a speed"), POINT, -1e12);
    assert!(far.u < -160.0 && far.u > -170.0, "{far:?}");
}

#[test]
fn what_is_on_the_baseline_has_no_coordinates() {
    for x in [-1.0, 0.0, 2.0] {
        assert_eq!(Conformal::from_direction([x, 0.0, 0.0]), None);
    }
    assert_eq!(Conformal::from_direction([f64::NAN, 1.0, 0.0]), None);
    assert_eq!(Conformal::from_direction([1.0, f64::INFINITY, 0.0]), None);
    // The quotient overflows, and u does not: arsinh(1e300/1e-300) = ln 2 + 600 ln 10.
    let aside = Conformal::from_direction([-1e300, 1e-300, 0.0]).expect("off the baseline");
    assert!((aside.u + 2.0_f64.ln() + 600.0 * 10.0_f64.ln()).abs() < 1e-12);
}
