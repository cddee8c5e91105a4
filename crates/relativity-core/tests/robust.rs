//! Robust fits: against `SciPy`, and against wrong readings.

use rand::{RngExt as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use relativity_core::{
    Aperture, Curves, FitOptions, Loss, LossShape, Model, Observations, Parameter, Passage, Reading, Sample,
    SourcePoint, Speed, bootstrap, disparity, fit,
};

use crate::common::{Case, PAPER};

const ROBUST: [LossShape; 3] = [LossShape::SoftL1, LossShape::Huber, LossShape::Cauchy];

/// 150 readings of a point at 0.8 c, y = 1 and z = 0.7, with a ripple and six that are wrong.
fn rippled(has_sigmas: bool) -> Observations {
    let speed = Speed::from_beta(0.8).expect("a speed");
    let [left, right] = Aperture::pair(0.1);
    let wrong =
        |list: &[(u32, f64)], index| list.iter().find(|(at, _)| *at == index).map_or(0.0, |(_, by)| *by);
    let sample = |index: u32| {
        let time = -1.0 + f64::from(index) / 25.0;
        let point = SourcePoint { x0: 0.0, y: 1.0, z: 0.7 };
        let seen = disparity(&speed, point, left, right, time).expect("inside the domain");
        let [square, other] = [index * index, index * index + 2 * index].map(|n| f64::from(n).sin());
        let dphi =
            seen.dphi + 1e-3 * square + wrong(&[(30, 0.05), (60, -0.03), (90, 0.08), (91, 0.08)], index);
        let dtheta = seen.dtheta + 5e-4 * other + wrong(&[(40, -0.04), (75, 0.02)], index);
        let reading = |value, sigma| Some(Reading { value, sigma: Some(sigma).filter(|_| has_sigmas) });
        Sample { time, pair: 0, dphi: reading(dphi, 1e-3), dtheta: reading(dtheta, 5e-4) }
    };
    Observations::of_pair(0.1, (0..150).map(sample).collect()).expect("usable samples")
}

/// By `least_squares` of `SciPy` 1.17.1 with `loss` and `f_scale`, on the light cones of both
/// eyes solved in Python.
#[test]
fn robust_fits_are_those_of_scipy() {
    for (shape, scale, expected) in WITH_SIGMAS {
        let options = FitOptions { loss: Loss { shape, scale }, ..FitOptions::default() };
        let found = fit(&rippled(true), &options).expect("a fit");
        for (found, expected) in found.values.into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-7, "{shape:?} {scale}: {found} for {expected}");
        }
    }
}

const WITH_SIGMAS: [(LossShape, f64, [f64; 3]); 5] = [
    (LossShape::Linear, 1.0, [0.799_714_685_877_479_5, 1.007_639_813_904_611_9, 0.683_060_047_434_763_2]),
    (LossShape::SoftL1, 1.287, [0.799_859_311_012_188, 1.000_776_192_761_254_6, 0.696_111_749_234_000_8]),
    (LossShape::Huber, 1.345, [0.799_923_248_196_441_4, 1.000_688_584_228_160_3, 0.696_657_473_456_813_2]),
    (LossShape::Cauchy, 2.385, [0.799_898_160_438_963_3, 1.000_515_669_214_536_7, 0.696_346_277_349_525_5]),
    (LossShape::Huber, 0.5, [0.799_677_733_045_243_1, 1.000_943_742_640_837, 0.694_585_283_655_347_2]),
];

/// Likewise of dphi alone without sigmas: in turns the scale by the median of the residuals, and the fit.
#[test]
fn the_scale_without_sigmas_is_the_one_that_follows_from_its_own_fit() {
    for (shape, scatter, expected) in WITHOUT_SIGMAS {
        let options = FitOptions { curves: Curves::Azimuth, loss: Loss::of(shape), ..FitOptions::default() };
        let found = fit(&rippled(false), &options).expect("a fit");
        let stated = found.scatter[0].expect("it is stated");
        assert!((stated / scatter - 1.0).abs() < 0.01, "{shape:?}: {stated:e} for {scatter:e}");
        for (&parameter, expected) in found.parameters().iter().zip(expected) {
            let off = (found.value(parameter) - expected).abs() / found.standard_error(parameter);
            assert!(off < 0.01, "{shape:?}: {parameter:?} is off by {off} standard errors");
        }
    }
}

const WITHOUT_SIGMAS: [(LossShape, f64, [f64; 3]); 3] = [
    (LossShape::Huber, 1.080_115_238e-3, [0.799_955_420_988, 1.000_451_489_529, 0.696_731_103_692]),
    (LossShape::Cauchy, 1.025_273_404e-3, [0.799_671_274_701, 1.000_722_826_801, 0.695_193_497_837]),
    (LossShape::SoftL1, 1.073_337_287e-3, [0.799_917_221_614, 1.000_530_483_521, 0.696_287_508_376]),
];

/// `case` with normal noise, and with a reading of each of these `curves`, 0 for dphi and 1 for dtheta, that
/// is off by `wrong` of its curve's range, 2 rad at most.
fn with_outliers(case: &Case, curves: &[usize], seed: u64, wrong: f64) -> [Observations; 2] {
    let good = case.samples(Model::Exact, seed);
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut bad = good.clone();
    for &curve in curves {
        let value = |sample: &Sample| sample.readings()[curve].map_or(0.0, |reading| reading.value);
        let values = || good.iter().map(value);
        let range = values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min);
        let sample = &mut bad[random.random_range(0..good.len())];
        let by = f64::min(wrong * range, 2.0) * if random.random_bool(0.5) { 1.0 } else { -1.0 };
        let reading = if curve == 0 { &mut sample.dphi } else { &mut sample.dtheta };
        reading.as_mut().expect("it was taken").value += by;
    }
    [good, bad].map(|samples| Observations::of_pair(case.separation, samples).expect("usable samples"))
}

#[test]
fn a_gross_outlier_moves_z_by_less_than_its_standard_error() {
    let case = Case { noise: 0.01, samples: 120, ..PAPER };
    for (curves, wrong) in [(Curves::Polar, 1), (Curves::Both, 0), (Curves::Both, 1)] {
        let mut unmoved = 0;
        for seed in 0..10 {
            let [good, bad] = with_outliers(&case, &[wrong], seed, 3.0);
            let z = |observations, shape| {
                let options = FitOptions { curves, loss: Loss::of(shape), ..FitOptions::default() };
                let found = fit(observations, &options);
                found.map(|found| (found.value(Parameter::Z), found.standard_error(Parameter::Z)))
            };
            let is_unmoved = |shape| {
                let (before, error) = z(&good, shape).expect("a fit");
                z(&bad, shape).is_ok_and(|(after, _)| (after - before).abs() < error)
            };
            for shape in ROBUST {
                assert!(is_unmoved(shape), "{shape:?} {curves:?} {seed}");
            }
            unmoved += u32::from(is_unmoved(LossShape::Linear));
        }
        assert!(unmoved < 10, "nor do they move least squares");
    }
}

/// The cases are points and speeds of all kinds, and their passage is unknown.
#[test]
fn the_search_is_not_misled_by_outliers() {
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let mut tried = 0;
    for seed in 0..24 {
        let case = Case::drawn(&mut random);
        for (shape, wrong) in ROBUST.into_iter().zip([1.0, 1000.0, 10.0]) {
            let options =
                FitOptions { passage: Passage::Fitted, loss: Loss::of(shape), ..FitOptions::default() };
            let [good, bad] =
                with_outliers(&case, &[0, 1], seed, wrong).map(|readings| fit(&readings, &options));
            let Ok(good) = good else { continue };
            tried += 1;
            let bad = bad.expect("a fit");
            for &parameter in good.parameters() {
                let off = (bad.value(parameter) - good.value(parameter)).abs();
                let errors = off / good.standard_error(parameter);
                assert!(
                    errors < 1.0,
                    "{shape:?} {wrong} {case:?}: {parameter:?} by {errors} standard errors"
                );
            }
        }
    }
    assert!(tried > 60, "{tried} fits");
}

/// With one reading in twenty wrong. The shares of 80 sets are off by chance by up to 0.05.
#[test]
fn intervals_of_robust_fits_hold_the_truth() {
    let case = Case { noise: 0.01, samples: 41, ..PAPER };
    let mut held = [0_u32; 3];
    for seed in 0..80 {
        let mut samples = case.samples(Model::Exact, seed);
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        for sample in &mut samples {
            for reading in [&mut sample.dphi, &mut sample.dtheta].into_iter().flatten() {
                let is_wrong = random.random_bool(0.05);
                reading.value += if is_wrong { random.random_range(-0.05..0.05) } else { 0.0 };
            }
        }
        let observations = Observations::of_pair(case.separation, samples).expect("usable samples");
        let options = FitOptions { loss: Loss::of(ROBUST[seed as usize % 3]), ..FitOptions::default() };
        let best = fit(&observations, &options).expect("a fit");
        let replicates = bootstrap(&best, 400, seed).expect("replicates");
        for (index, &parameter) in best.parameters().iter().enumerate() {
            let [low, high] = replicates.interval_95(parameter);
            held[index] += u32::from((low..=high).contains(&case.truth()[index]));
        }
    }
    assert!(held.iter().all(|&held| held >= 70), "{held:?} of 80 intervals hold the truth");
}
