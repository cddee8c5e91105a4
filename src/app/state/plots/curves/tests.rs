//! Drawn curves against the functions that they are of.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;
use relativity_core::Turning;
use relativity_render::Spin;

use super::*;
use crate::time_range::{fitted_range, time_within};

/// Every quantity that is plotted.
const PLOTTED: [Quantity; 9] = [
    Quantity::DeltaPhi,
    Quantity::DeltaTheta,
    Quantity::DeltaU,
    Quantity::DeltaV,
    Quantity::Phi,
    Quantity::Theta,
    Quantity::Doppler,
    Quantity::StereoGain,
    Quantity::Distance,
];
/// The quantities of what the eyes see; each is there at every T.
const SEEN: [Quantity; 5] =
    [Quantity::DeltaPhi, Quantity::DeltaTheta, Quantity::Phi, Quantity::Theta, Quantity::Doppler];
/// Both models that a point of these tests is drawn by.
const MODELS: [Model; 2] = [Model::OneCone, Model::Exact];
const RANGE: [f64; 2] = [-2.0, 5.0];

fn seen(beta: f64, point: [f64; 3]) -> SeenPoint {
    let velocity = Velocity::from_beta(beta).expect("in range");
    let [x0, y, z] = point;
    let rest = [x0 * velocity.speed.gamma(), y, z];
    SeenPoint {
        ride: Riding::default(),
        velocity,
        point: rest.into(),
        baseline: Baseline::straight(0.3),
        model: Model::OneCone,
    }
}

fn curves(point: &SeenPoint, range: [f64; 2], quantity: Quantity) -> QuantityCurves {
    QuantityCurves::new(CurvesKey { point: point.clone(), quantity, range, published: true })
}

/// The curve that both eyes have.
const fn both(quantity: Quantity) -> Curve {
    Curve { quantity, whose: Whose::Both }
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
        let point = seen(beta, point);
        let curves = curves(&point, RANGE, Quantity::DeltaPhi);
        for model in MODELS {
            let [curve] = curves.pieces(Whose::Both, model) else { panic!("one piece") };
            let height = curve.iter().map(|p| p.y).fold(0.0f64, |a, b| a.max(b.abs()));
            for i in 0..5000 {
                let time = -2.0 + 7.0 * (f64::from(i) + 0.37) / 5000.0;
                let exact = point.value(model, both(Quantity::DeltaPhi), time).expect("in the domain");
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
            let all = PLOTTED.map(|quantity| curves(&seen(beta, point), RANGE, quantity));
            let all =
                || all.iter().flat_map(|curves| &curves.drawn).flat_map(|(.., pieces)| pieces).flatten();
            assert!(all().all(|point| point.x.is_finite() && point.y.is_finite()));
            assert!(all().count() < 60_000, "beta = {beta}, {point:?}: {}", all().count());
        }
    }
}

/// Delta-u of what moves is that of what rests, for eyes gamma d apart, at every T and speed; a drawn curve
/// is within a pixel.
#[test]
fn disparities_of_u_are_those_of_a_resting_point_for_wider_eyes() {
    for (beta, is_turned) in [(0.0, false), (0.5, false), (-0.9, false), (0.9999, true)] {
        let turn = if is_turned { std::f64::consts::PI } else { 0.0 };
        let point = SeenPoint {
            model: Model::Exact,
            baseline: Baseline { turn, ..Baseline::straight(0.3) },
            ..seen(beta, [0.3, 3.0, 2.0])
        };
        let curves = curves(&point, RANGE, Quantity::DeltaU);
        let [drawn_resting] = curves.pieces(Whose::Resting, Model::Exact) else { panic!("one piece") };
        let [drawn_moving] = curves.pieces(Whose::Both, Model::Exact) else { panic!("one piece") };
        let height = drawn_moving.iter().map(|point| point.y.abs()).fold(0.0, f64::max);
        for i in 0..2000 {
            let time = -2.0 + 7.0 * (f64::from(i) + 0.37) / 2000.0;
            let of = |quantity, whose| {
                point.value(Model::Exact, Curve { quantity, whose }, time).expect("off the baseline")
            };
            let moving = of(Quantity::DeltaU, Whose::Both);
            let resting = of(Quantity::DeltaU, Whose::Resting);
            // In front of a head that faces the other way the left eye is still the left one.
            assert!(
                moving > 0.0 && (moving - resting).abs() <= 1e-11 * height,
                "{beta} {time}: {moving} {resting}"
            );
            for drawn in [drawn_moving, drawn_resting].map(|curve| drawn(curve, time)) {
                assert!((drawn - moving).abs() <= height / 600.0, "{beta} {time}: {drawn} for {moving}");
            }
            assert_eq!(of(Quantity::DeltaV, Whose::Both).abs(), 0.0);
        }
    }
}

/// Motion is no slide for a tilted head, nor is there one resting place of what turns with a wheel.
#[test]
fn there_is_no_resting_curve_where_motion_is_no_slide() {
    let tilted = SeenPoint {
        baseline: Baseline { roll: 0.3, ..Baseline::straight(0.3) },
        ..seen(0.9, [0.0, 3.0, 2.0])
    };
    let (wheel, range) = on_wheel(0.9, 1.0, 0.0);
    for (point, range) in [(tilted, RANGE), (wheel, range)] {
        let of = |quantity| curves(&point, range, quantity);
        assert!(of(Quantity::DeltaU).pieces(Whose::Resting, Model::OneCone).is_empty());
        assert_eq!(of(Quantity::DeltaV).pieces(Whose::Both, Model::Exact).len(), 1);
    }
}

/// A point of the front wheel of the street's bicycle, from between the eyes, and the T that the window shows
/// at first.
fn on_wheel(beta: f64, rho: f64, angle: f64) -> (SeenPoint, [f64; 2]) {
    let spin = Spin { hub: [-0.525, 3.0, 2.0], radius: 0.525, turning: Turning::Rolling };
    let (sine, cosine) = math::sin_cos(angle);
    let rest = DVec3::new(-0.525 + 0.525 * rho * cosine, 3.0, 2.0 + 0.525 * rho * sine);
    let seen = seen(beta, [0.0; 3]);
    let pair = seen.baseline.apertures();
    let hub = SourcePoint::from_rest(spin.hub, &seen.velocity.speed);
    let range = fitted_range(&seen.velocity.speed, hub, pair);
    (SeenPoint { point: MaterialPoint { rest, spin: Some(spin) }, ..seen }, range)
}

/// Returns the distance of `exact` from where a drawn `curve` goes a third of a pixel before and after
/// `time`, in a plot 600 pixels wide.
fn off_the_line(curve: &[PlotPoint], time: f64, exact: f64, width: f64) -> f64 {
    let [from, to] = [-1.0, 1.0].map(|sign| time + sign * width / 1800.0);
    let between = [from, to].map(|end| curve.partition_point(|point| point.x < end));
    let inside = curve[between[0]..between[1]].iter().map(|point| point.y);
    let all = || inside.clone().chain([drawn(curve, from), drawn(curve, to)]);
    let [low, high] = [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)];
    (low - exact).max(exact - high).max(0.0)
}

/// Not only at the samples, but everywhere in between, over all T that the window shows at first: every curve
/// of it, by each model, peaks thinner than a pixel among them.
#[test]
fn curves_of_a_rolling_wheel_are_drawn_as_exactly() {
    for beta in [0.01, 0.5, 0.9, 0.99] {
        for (rho, angle) in [(1.0, 0.0), (0.94, 2.0), (0.3, -1.0)] {
            let (point, [from, to]) = on_wheel(beta, rho, angle);
            for quantity in SEEN {
                let curves = curves(&point, [from, to], quantity);
                for (model, &whose) in
                    MODELS.into_iter().flat_map(|of| Whose::of(quantity).iter().map(move |who| (of, who)))
                {
                    let [curve] = curves.pieces(whose, model) else { panic!("one piece") };
                    let values = || curve.iter().map(|point| point.y);
                    let height =
                        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min);
                    for i in 0..10_000 {
                        let time = from + (to - from) * (f64::from(i) + 0.37) / 10_000.0;
                        let exact =
                            point.value(model, Curve { quantity, whose }, time).expect("in the domain");
                        let off = off_the_line(curve, time, exact, to - from) / height;
                        assert!(
                            off < 1.0 / 1200.0,
                            "{model:?}, {quantity:?} of {whose:?}, beta = {beta}, rho = {rho}, T = {time}: {off:e}"
                        );
                    }
                }
            }
        }
    }
}

/// D of a point at each angle of the rim, as the left eye at (-0.15, 0, 0) sees it at `time`: in the frame in
/// which the hub rests light comes from the point to o, and the Doppler factors of its own motion and of that
/// of the frame are multiplied.
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

/// Turns thinner than a pixel: the line fills what the point moves in, and no more. Within a pixel or two it
/// goes as high and as low as each eye's D does there.
#[test]
fn turns_too_fast_to_be_told_apart_are_filled() {
    let (point, range) = on_wheel(0.9999, 1.0, 0.0);
    let curves = curves(&point, range, Quantity::Doppler);
    let [curve] = curves.pieces(Whose::Eye(Eye::Left), Model::Exact) else { panic!("one piece") };
    for part in [0.01, 0.05, 0.1, 0.15] {
        let window = [part, part + 0.005].map(|part| time_within(range, part));
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
            let (point, range) = on_wheel(beta, rho, angle);
            for quantity in PLOTTED {
                let is_conformal = matches!(quantity, Quantity::DeltaU | Quantity::DeltaV);
                for (model, whose, pieces) in &curves(&point, range, quantity).drawn {
                    let count = pieces.iter().map(Vec::len).sum::<usize>();
                    let least = if is_conformal { 0 } else { 11 };
                    assert!(
                        (least..=10_100).contains(&count),
                        "{model:?}, {quantity:?} of {whose:?}, beta = {beta}: {count} samples"
                    );
                    let is_finite = |point: &PlotPoint| point.x.is_finite() && point.y.is_finite();
                    assert!(pieces.iter().flatten().all(is_finite), "beta = {beta}, rho = {rho}");
                }
            }
        }
    }
}
