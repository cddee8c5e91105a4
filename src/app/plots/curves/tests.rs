//! Drawn curves against the functions that they are of.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;
use relativity_core::Turning;
use relativity_render::Spin;

use super::*;
use crate::time_range::{fitted_range, time_within};

fn key(beta: f64, point: [f64; 3]) -> CurvesKey {
    let velocity = Velocity::from_beta(beta).expect("in range");
    let [x0, y, z] = point;
    let rest = [x0 * velocity.speed.gamma(), y, z];
    let model = Model::OneCone;
    CurvesKey {
        ride: Riding::default(),
        velocity,
        point: rest.into(),
        baseline: Baseline::straight(0.3),
        range: [-2.0, 5.0],
        model,
        published: true,
        stereo: true,
        conformal: true,
    }
}

/// Linear interpolation in a drawn curve.
fn drawn(curve: &[PlotPoint], time: f64) -> f64 {
    let after = curve.partition_point(|point| point.x < time).clamp(1, curve.len() - 1);
    let (a, b) = (curve[after - 1], curve[after]);
    a.y + (b.y - a.y) * (time - a.x) / (b.x - a.x)
}

#[test]
fn drawn_curves_stay_within_a_pixel_of_the_exact_ones() {
    for (beta, point) in
        [(0.0, [0.0, 0.5, 0.5]), (0.9, [0.0, 0.5, 0.5]), (0.9999, [0.3, 3.0, 2.0]), (0.9, [0.0, 1e-3, 1e-3])]
    {
        let key = key(beta, point);
        let curves = Curves::new(key.clone());
        for (model, curves) in
            [(Model::OneCone, &curves.shown), (Model::Exact, curves.exact.as_ref().expect("another"))]
        {
            let curve = &curves.eyes[0];
            let height = curve.iter().map(|p| p.y).fold(0.0f64, |a, b| a.max(b.abs()));
            for i in 0..5000 {
                let time = -2.0 + 7.0 * (f64::from(i) + 0.37) / 5000.0;
                let exact = values(&key, model, time).expect("in the domain")[0];
                assert!(
                    (drawn(curve, time) - exact).abs() <= height / 600.0,
                    "{model:?}, beta = {beta}, T = {time}: {} for {exact}",
                    drawn(curve, time)
                );
            }
            assert!(curve.len() < 4000, "{} samples", curve.len());
        }
    }
}

#[test]
fn every_drawn_value_is_finite() {
    for beta in [0.0, 0.5, 0.999_999_999_999_999_9] {
        for point in [[0.0, 0.0, 0.0], [0.15, 0.0, 0.0], [0.0, 0.0, 1.0], [1e6, 1e-9, 0.0]] {
            let curves = Curves::new(key(beta, point));
            let models = [Some(&curves.shown), curves.exact.as_ref()].into_iter().flatten();
            let models = models.flat_map(|of| {
                of.eyes.iter().chain(&of.gains).chain(&of.distances).chain(of.conformal.iter().flatten())
            });
            let conformal = curves.published_conformal.iter().flatten().chain(&curves.resting);
            let all = models.chain(&curves.published).chain(conformal).flatten();
            assert!(all.clone().all(|point| point.x.is_finite() && point.y.is_finite()));
            assert!(all.count() < 30_000, "beta = {beta}, {point:?}");
        }
    }
}

/// Delta-u of what moves is that of what rests, for eyes gamma d apart, at every T and speed; a drawn curve is within a pixel.
#[test]
fn disparities_of_u_are_those_of_a_resting_point_for_wider_eyes() {
    for (beta, is_turned) in [(0.0, false), (0.5, false), (-0.9, false), (0.9999, true)] {
        let turn = if is_turned { std::f64::consts::PI } else { 0.0 };
        let key = CurvesKey {
            model: Model::Exact,
            baseline: Baseline { turn, ..Baseline::straight(0.3) },
            ..key(beta, [0.3, 3.0, 2.0])
        };
        let curves = Curves::new(key.clone());
        let [drawn_resting] = curves.pieces(Curve::RestingU, Model::Exact) else { panic!("one piece") };
        let [drawn_moving] = curves.pieces(Curve::DeltaU, Model::Exact) else { panic!("one piece") };
        let height = drawn_moving.iter().map(|point| point.y.abs()).fold(0.0, f64::max);
        for i in 0..2000 {
            let time = -2.0 + 7.0 * (f64::from(i) + 0.37) / 2000.0;
            let of = |curve| value(&key, Model::Exact, curve, time).expect("off the baseline");
            let (moving, resting) = (of(Curve::DeltaU), of(Curve::RestingU));
            // In front of a head that faces the other way the left eye is still the left one.
            assert!(
                moving > 0.0 && (moving - resting).abs() <= 1e-11 * height,
                "{beta} {time}: {moving} {resting}"
            );
            for drawn in [drawn_moving, drawn_resting].map(|curve| drawn(curve, time)) {
                assert!((drawn - moving).abs() <= height / 600.0, "{beta} {time}: {drawn} for {moving}");
            }
            assert_eq!(of(Curve::DeltaV).abs(), 0.0);
        }
    }
}

/// Motion is no slide for a tilted head, nor is there one resting place of what turns with a wheel.
#[test]
fn there_is_no_resting_curve_where_motion_is_no_slide() {
    let tilted = CurvesKey {
        baseline: Baseline { roll: 0.3, ..Baseline::straight(0.3) },
        ..key(0.9, [0.0, 3.0, 2.0])
    };
    let tilted = CurvesKey { published: false, ..tilted };
    for key in [tilted, wheel_key(0.9, 1.0, 0.0)] {
        let curves = Curves::new(key.clone());
        assert!(curves.pieces(Curve::RestingU, Model::Exact).is_empty());
        assert_eq!(curves.pieces(Curve::DeltaV, Model::Exact).len(), 1);
    }
}

/// The front wheel of the street's bicycle, from between the eyes.
fn wheel_key(beta: f64, rho: f64, angle: f64) -> CurvesKey {
    let spin = Spin { hub: [-0.525, 3.0, 2.0], radius: 0.525, turning: Turning::Rolling };
    let (sine, cosine) = math::sin_cos(angle);
    let rest = DVec3::new(-0.525 + 0.525 * rho * cosine, 3.0, 2.0 + 0.525 * rho * sine);
    let key = key(beta, [0.0; 3]);
    let pair = key.baseline.apertures();
    let hub = SourcePoint::from_rest(spin.hub, &key.velocity.speed);
    let range = fitted_range(&key.velocity.speed, hub, pair);
    CurvesKey { point: MaterialPoint { rest, spin: Some(spin) }, range, ..key }
}

/// Returns the distance of `exact` from where a drawn `curve` goes a third of a pixel before and after `time`, in a plot 600 pixels wide.
fn off_the_line(curve: &[PlotPoint], time: f64, exact: f64, width: f64) -> f64 {
    let [from, to] = [-1.0, 1.0].map(|sign| time + sign * width / 1800.0);
    let between = [from, to].map(|end| curve.partition_point(|point| point.x < end));
    let inside = curve[between[0]..between[1]].iter().map(|point| point.y);
    let all = || inside.clone().chain([drawn(curve, from), drawn(curve, to)]);
    let [low, high] = [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)];
    (low - exact).max(exact - high).max(0.0)
}

/// Not only at the samples, but everywhere in between, over all T that the window shows at first: every curve of it, by each
/// model, peaks thinner than a pixel among them.
#[test]
fn curves_of_a_rolling_wheel_are_drawn_as_exactly() {
    for beta in [0.01, 0.5, 0.9, 0.99] {
        for (rho, angle) in [(1.0, 0.0), (0.94, 2.0), (0.3, -1.0)] {
            let key = wheel_key(beta, rho, angle);
            let curves = Curves::new(key.clone());
            let [from, to] = key.range;
            let exact = curves.exact.as_ref().expect("another");
            for (model, of) in [(Model::OneCone, &curves.shown), (Model::Exact, exact)] {
                let heights = of.eyes.each_ref().map(|curve| {
                    let values = || curve.iter().map(|point| point.y);
                    values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
                });
                for i in 0..10_000 {
                    let time = from + (to - from) * (f64::from(i) + 0.37) / 10_000.0;
                    let exact = super::values(&key, model, time).expect("in the domain");
                    for (channel, curve) in of.eyes.iter().enumerate() {
                        let off = off_the_line(curve, time, exact[channel], to - from) / heights[channel];
                        assert!(
                            off < 1.0 / 1200.0,
                            "{model:?}, beta = {beta}, rho = {rho}, T = {time}, curve {channel}: {off:e}"
                        );
                    }
                }
            }
        }
    }
}

/// D of a point at each angle of the rim, as the left eye at (-0.15, 0, 0) sees it at `time`: in the frame in which the hub rests light
/// comes from the point to o, and the Doppler factors of its own motion and of that of the frame are multiplied.
fn on_the_rim(beta: f64, time: f64) -> [f64; 2] {
    let gamma = 1.0 / (1.0 - beta * beta).sqrt();
    let o = DVec3::new(gamma * (-0.15 - beta * time), 0.0, 0.0);
    let d = |angle: f64| {
        let (sine, cosine) = math::sin_cos(angle);
        let place = DVec3::new(-0.525 + 0.525 * cosine, 3.0, 2.0 + 0.525 * sine);
        let velocity = beta * DVec3::new(sine, 0.0, -cosine);
        let n = (place - o).normalize();
        math::log10(gamma * (1.0 - beta * n.x) / (gamma * (1.0 + velocity.dot(n))))
    };
    let all = (0..100_000).map(|i| d(TAU * f64::from(i) / 100_000.0));
    all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], d| [low.min(d), high.max(d)])
}

/// Turns thinner than a pixel: the line fills what the point moves in, and no more. Within a pixel or two it goes as high
/// and as low as each eye's D does there.
#[test]
fn turns_too_fast_to_be_told_apart_are_filled() {
    let key = wheel_key(0.9999, 1.0, 0.0);
    let curves = Curves::new(key.clone());
    let curve = &curves.exact.as_ref().expect("another").eyes[6];
    for part in [0.01, 0.05, 0.1, 0.15] {
        let window = [part, part + 0.005].map(|part| time_within(key.range, part));
        let there = curve.iter().filter(|point| (window[0]..window[1]).contains(&point.x));
        let drawn = there.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], point| {
            [low.min(point.y), high.max(point.y)]
        });
        let exact = on_the_rim(0.9999, window[0].midpoint(window[1]));
        let off = [0, 1].map(|end| (exact[end] - drawn[end]).abs());
        assert!(off.iter().all(|off| *off < 0.03), "from {part} on {drawn:?} for {exact:?}");
    }
}

/// Nothing is lost at the ends of what speeds there are, and nothing takes long.
#[test]
fn every_drawn_value_of_a_wheel_is_finite() {
    for beta in [0.0, 1e-300, 1e-6, 0.9999, 0.999_999_999_999_5, 0.999_999_999_999_999_9] {
        for (rho, angle) in [(0.0, 0.0), (0.94, 2.0), (1.0, -FRAC_PI_2)] {
            let curves = Curves::new(wheel_key(beta, rho, angle));
            for of in [&curves.shown, curves.exact.as_ref().expect("another")] {
                let all = of.eyes.iter().chain(&of.gains).chain(&of.distances);
                for curve in all {
                    assert!(
                        curve.len() > 10 && curve.len() <= 10_100,
                        "beta = {beta}: {} samples",
                        curve.len()
                    );
                    let is_finite = |point: &PlotPoint| point.x.is_finite() && point.y.is_finite();
                    assert!(curve.iter().all(is_finite), "beta = {beta}, rho = {rho}");
                }
            }
        }
    }
}
