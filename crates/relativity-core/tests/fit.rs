//! The fit and its bootstrap against known objects.

use rand::SeedableRng as _;
use rand_chacha::ChaCha8Rng;
use relativity_core::fit::NOISE_FREE_ERROR;
use relativity_core::{
    Aperture, Curves, Fit, FitError, FitOptions, Model, Observations, Parameter, Passage, PublishedVariant,
    Reading, Rolling, Sample, Simulation, SourcePoint, Speed, Turning, WheelPoint, bootstrap, disparity, fit,
    fit_from, one_cone_disparity, published_disparity,
};

use crate::common::{Case, PAPER};
use crate::tally::Tally;

const MODELS: [Model; 4] = Model::ALL;
const CURVES: [Curves; 3] = [Curves::Azimuth, Curves::Polar, Curves::Both];
const PASSAGES: [Passage; 2] = [Passage::Known(0.0), Passage::Fitted];

fn assert_recovers(fit: &Fit, truth: [f64; 4], tolerance: f64) {
    for (index, &parameter) in fit.parameters().iter().enumerate() {
        let error = (fit.value(parameter) - truth[index]).abs();
        assert!(error <= tolerance, "{parameter:?} is off by {error:e}: {:?} {:?}", fit.values, fit.options);
    }
}

#[test]
fn noise_free_curves_of_the_paper_give_its_object_back() {
    for model in MODELS {
        let observations = PAPER.observations(model, 0);
        for curves in CURVES {
            for passage in PASSAGES {
                let options = FitOptions { model, curves, passage, ..FitOptions::default() };
                let fit = fit(&observations, &options).expect("a fit");
                assert_recovers(&fit, PAPER.truth(), NOISE_FREE_ERROR);
                let replicates = bootstrap(&fit, 20, 1).expect("replicates");
                assert_eq!(replicates.failed(), 0);
                assert!(replicates.standard_error(Parameter::Y) < 1e-9);
            }
        }
    }
}

/// The fit's own curves are those of `disparity` and `published_disparity`.
#[test]
fn simulated_curves_are_the_disparities() {
    let case = Case { x0: 0.4, separation: 0.3, ..PAPER };
    let speed = Speed::from_beta(case.beta).expect("a speed");
    let point = SourcePoint { x0: case.x0, y: case.y, z: case.z };
    let [left, right] = Aperture::pair(case.separation);
    for model in MODELS {
        for sample in case.samples(model, 0) {
            let seen = match model {
                Model::Exact => disparity(&speed, point, left, right, sample.time),
                Model::OneCone => one_cone_disparity(&speed, point, [left, right], sample.time),
                Model::Published(variant) => published_disparity(&speed, point, 0.3, sample.time, variant),
            };
            let seen = seen.expect("inside the domain");
            let [dphi, dtheta] =
                [sample.dphi, sample.dtheta].map(|reading| reading.expect("a reading").value);
            assert!((dphi - seen.dphi).abs() < 1e-15 && (dtheta - seen.dtheta).abs() < 1e-15);
        }
    }
}

#[test]
fn the_sign_of_height_is_seen_by_the_polar_curve() {
    let below = Case { z: -2.0, x0: 0.7, ..PAPER };
    let options = FitOptions { passage: Passage::Fitted, ..FitOptions::default() };
    let both = fit(&below.observations(Model::Exact, 0), &options).expect("a fit");
    assert_recovers(&both, below.truth(), 1e-9);
    let options = FitOptions { curves: Curves::Azimuth, ..options };
    let azimuth = fit(&below.observations(Model::Exact, 0), &options).expect("a fit");
    assert_recovers(&azimuth, [0.9, 3.0, 2.0, 0.7], 1e-8);
}

#[test]
fn three_apertures_anywhere_give_the_object_back() {
    let [left, right] = Aperture::pair(0.2);
    let above = Aperture { x: 0.1, y: -0.2, z: 0.3 };
    let pairs = vec![[left, right], [left, above]];
    let speed = Speed::from_beta(0.6).expect("a speed");
    let point = SourcePoint { x0: -0.4, y: 1.5, z: -0.8 };
    let sample = |index: u32| {
        let (time, pair) = (-4.0 + f64::from(index) / 10.0, (index % 2) as usize);
        let [primary, secondary] = pairs[pair];
        let seen = disparity(&speed, point, primary, secondary, time).expect("inside the domain");
        let reading = |value| Some(Reading { value, sigma: None });
        Sample { time, pair, dphi: reading(seen.dphi), dtheta: reading(seen.dtheta) }
    };
    let samples: Vec<Sample> = (0..120).map(sample).collect();
    let observations = Observations::new(pairs.clone(), samples).expect("usable samples");
    for curves in CURVES {
        let options = FitOptions { curves, passage: Passage::Fitted, ..FitOptions::default() };
        let fit = fit(&observations, &options).expect("a fit");
        assert_recovers(&fit, [0.6, 1.5, -0.8, -0.4], 1e-8);
    }
}

#[test]
fn exact_data_fitted_by_the_published_model_are_biased() {
    let observations = Case { noise: 0.005, ..PAPER }.observations(Model::Exact, 3);
    let options =
        FitOptions { model: Model::Published(PublishedVariant::AppendixA), ..FitOptions::default() };
    let exact = fit(&observations, &FitOptions::default()).expect("a fit");
    let is_biased = match fit(&observations, &options) {
        Ok(fit) => (fit.value(Parameter::Y) - PAPER.y).abs() > 10.0 * exact.standard_error(Parameter::Y),
        Err(_) => true,
    };
    assert!(is_biased);
}

/// Shares over all parameters; 150 cases leave them uncertain by about 3 %.
#[test]
fn intervals_hold_the_truth_as_often_as_they_say() {
    for (curves, passage_is_known, seed) in [(Curves::Both, true, 11), (Curves::Both, false, 12)] {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut tally = Tally::default();
        for index in 0..150 {
            let case = Case::drawn(&mut random);
            let passage = if passage_is_known { Passage::Known(case.x0) } else { Passage::Fitted };
            tally.add(&case, &FitOptions { curves, passage, ..FitOptions::default() }, index);
        }
        let [within_error, within_interval] = tally.coverage(if passage_is_known { 3 } else { 4 });
        assert!(tally.right as f64 >= 0.98 * tally.cases as f64, "{tally} {:?}", tally.complaints);
        assert!((60.0..=76.0).contains(&within_error), "within one standard error: {within_error} %");
        assert!((91.0..=98.0).contains(&within_interval), "within 95 %: {within_interval} %");
    }
}

#[test]
fn standard_errors_of_covariance_and_bootstrap_agree_for_small_noise() {
    let noisy = Case { noise: 0.005, ..PAPER };
    let observations = noisy.observations(Model::Exact, 5);
    let fit = fit(&observations, &FitOptions::default()).expect("a fit");
    let replicates = bootstrap(&fit, 2000, 1).expect("replicates");
    for &parameter in fit.parameters() {
        let ratio = replicates.standard_error(parameter) / fit.standard_error(parameter);
        assert!((0.8..1.25).contains(&ratio), "{parameter:?}: {ratio}");
        let correlations =
            [replicates.correlation(parameter, Parameter::Beta), fit.correlation(parameter, Parameter::Beta)];
        assert!((correlations[0] - correlations[1]).abs() < 0.15, "{parameter:?}: {correlations:?}");
    }
}

#[test]
fn right_sigmas_make_chi_squared_one_and_do_not_change_the_fit() {
    let noisy = Case { noise: 0.01, ..PAPER };
    let mut samples = noisy.samples(Model::Exact, 8);
    let options = FitOptions { curves: Curves::Azimuth, ..FitOptions::default() };
    let without = Observations::of_pair(noisy.separation, samples.clone()).expect("usable samples");
    let without = fit(&without, &options).expect("a fit");
    let clean = Case { noise: 0.0, ..noisy }.samples(Model::Exact, 8);
    let value = |sample: &Sample| sample.dphi.expect("a reading").value;
    let range =
        clean.iter().map(value).fold(f64::MIN, f64::max) - clean.iter().map(value).fold(f64::MAX, f64::min);
    for sample in &mut samples {
        let reading = sample.dphi.as_mut().expect("a reading");
        reading.sigma = Some(noisy.noise * range);
    }
    let with = Observations::of_pair(noisy.separation, samples).expect("usable samples");
    let with = fit(&with, &options).expect("a fit");
    let reduced = with.reduced_chi_squared.expect("sigmas were given");
    assert!((reduced - 1.0).abs() < 4.0 * (2.0_f64 / 237.0).sqrt(), "{reduced}");
    assert_recovers(&with, without.values, 1e-6);
}

#[test]
fn replicates_depend_on_the_seed_but_not_on_threads() {
    let observations = Case { noise: 0.01, ..PAPER }.observations(Model::Exact, 2);
    let fit = fit(&observations, &FitOptions::default()).expect("a fit");
    let with_threads = |threads, seed| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| bootstrap(&fit, 100, seed)).expect("replicates")
    };
    assert_eq!(with_threads(1, 7), with_threads(3, 7));
    assert_ne!(with_threads(1, 7), with_threads(1, 8));
}

#[test]
fn a_guess_near_the_truth_leads_to_the_same_fit() {
    let observations = Case { noise: 0.01, ..PAPER }.observations(Model::Exact, 2);
    let options = FitOptions::default();
    let found = fit(&observations, &options).expect("a fit");
    let guessed = fit_from(&observations, &options, [0.85, 3.3, 1.8, 0.0]).expect("a fit");
    assert_recovers(&guessed, found.values, 1e-6);
    let nonsense = fit_from(&observations, &options, [1.2, 3.0, 2.0, 0.0]);
    assert!(matches!(nonsense, Err(FitError::Guess { .. })));
}

/// Samples of Delta-phi from values, one per unit of time.
fn azimuth_samples(values: &[f64]) -> Vec<Sample> {
    let reading = |&value| Some(Reading { value, sigma: None });
    let times = (0..).map(f64::from);
    times.zip(values).map(|(time, v)| Sample { time, pair: 0, dphi: reading(v), dtheta: None }).collect()
}

fn azimuth_error(values: &[f64]) -> FitError {
    let observations = Observations::of_pair(0.1, azimuth_samples(values)).expect("usable samples");
    let options = FitOptions { curves: Curves::Azimuth, ..FitOptions::default() };
    fit(&observations, &options).expect_err("no fit")
}

#[test]
fn what_cannot_be_fitted_is_said_in_words() {
    let few = azimuth_error(&[-0.1, -0.2, -0.1]);
    assert_eq!(few.to_string(), "3 samples of dphi are too few: 3 parameters need at least 6");
    assert!(matches!(azimuth_error(&[-0.1; 50]), FitError::Flat { .. }));
    let noise: Vec<f64> =
        (0..50_u32).map(|i| f64::from(i.wrapping_mul(2_654_435_761) >> 20) * 1e-6).collect();
    let error = azimuth_error(&noise);
    assert!(matches!(error, FitError::Unexplained { .. } | FitError::Indistinguishable { .. }), "{error}");
    let polar = FitOptions { curves: Curves::Polar, ..FitOptions::default() };
    let without_dtheta = Observations::of_pair(0.1, azimuth_samples(&[-0.1, -0.2])).expect("usable");
    assert!(matches!(fit(&without_dtheta, &polar), Err(FitError::TooFew { samples: 0, .. })));
}

/// Delta-phi depends on the height by the delays of light alone.
#[test]
fn a_slow_object_seen_only_in_azimuth_does_not_tell_its_height() {
    let slow = Case { beta: 0.005, y: 8.0, z: 0.5, noise: 0.02, ..PAPER };
    let options = FitOptions { curves: Curves::Azimuth, passage: Passage::Fitted, ..FitOptions::default() };
    let error = fit(&slow.observations(Model::Exact, 1), &options).expect_err("no fit");
    assert!(matches!(error, FitError::Indistinguishable { parameter: "z", .. }), "{error}");
    let both = FitOptions { curves: Curves::Both, ..options };
    fit(&slow.observations(Model::Exact, 1), &both).expect("both curves tell it");
}

/// Delta-phi has no slope at z = 0, where the noise often puts the best fit: z then has a bound only.
#[test]
fn a_height_that_fits_best_as_zero_is_a_bound() {
    let low = Case { beta: 0.5, y: 8.0, z: 0.05, noise: 0.01, ..PAPER };
    let options = FitOptions { curves: Curves::Azimuth, ..FitOptions::default() };
    let fits = (0..20).map(|seed| fit(&low.observations(Model::Exact, seed), &options).expect("a fit"));
    let zeros: Vec<Fit> = fits.filter(|fit| fit.value(Parameter::Z) == 0.0).collect();
    assert!((4..=16).contains(&zeros.len()), "{} of 20", zeros.len());
    for zero in zeros {
        let bound = zero.standard_error(Parameter::Z);
        let replicates = bootstrap(&zero, 200, 1).expect("replicates");
        let [lowest, highest] = replicates.interval_95(Parameter::Z);
        assert!(bound > low.z && bound < 2.0, "{bound}");
        assert!(lowest == 0.0 && (0.5 * bound..3.0 * bound).contains(&highest), "{highest} {bound}");
    }
}

#[test]
fn unusable_samples_are_named() {
    let unusable = |change: fn(&mut Sample)| {
        let mut samples = azimuth_samples(&[-0.1; 9]);
        change(&mut samples[4]);
        Observations::of_pair(0.1, samples).expect_err("an error").to_string()
    };
    assert_eq!(unusable(|sample| sample.time = f64::NAN), "sample 4: T = NaN is not usable");
    assert_eq!(unusable(|sample| sample.pair = 1), "sample 4: pair = 1 is not usable");
    let sigma = |sample: &mut Sample| sample.dphi = Some(Reading { value: 0.1, sigma: Some(0.0) });
    assert_eq!(unusable(sigma), "sample 4: sigma_dphi = 0 is not usable");
    let same = Observations::of_pair(0.0, Vec::new()).expect_err("an error");
    assert_eq!(same.to_string(), "pair 0 of apertures: its two apertures are one");
}

#[test]
fn sigmas_are_given_for_all_readings_of_a_curve_or_for_none() {
    let mut samples = PAPER.samples(Model::Exact, 0);
    samples[3].dphi = samples[3].dphi.map(|reading| Reading { sigma: Some(1e-3), ..reading });
    let observations = Observations::of_pair(PAPER.separation, samples).expect("usable samples");
    let error = fit(&observations, &FitOptions::default()).expect_err("mixed");
    assert_eq!(error, FitError::MixedSigma { curve: "dphi", with: 1, of: 240 });
}

#[test]
fn the_published_model_needs_apertures_along_the_motion() {
    let pair = [Aperture::default(), Aperture { x: 0.1, y: 0.1, z: 0.0 }];
    let observations = Observations::new(vec![pair], PAPER.samples(Model::Exact, 0)).expect("usable");
    let options =
        FitOptions { model: Model::Published(PublishedVariant::AppendixA), ..FitOptions::default() };
    assert!(matches!(fit(&observations, &options), Err(FitError::Pair { pair: 0, .. })));
}

/// The standard error of the weighted mean is the scatter of the weighted mean over the replicates.
#[test]
fn the_combined_error_accounts_for_correlation() {
    let observations = Case { noise: 0.01, ..PAPER }.observations(Model::Exact, 4);
    let [azimuth, polar] = [Curves::Azimuth, Curves::Polar].map(|curves| {
        let best = fit(&observations, &FitOptions { curves, ..FitOptions::default() }).expect("a fit");
        let replicates = bootstrap(&best, 500, 9).expect("replicates");
        (best, replicates)
    });
    for parameter in [Parameter::Beta, Parameter::Y, Parameter::Z] {
        let combined = relativity_core::combined((&azimuth.0, &azimuth.1), (&polar.0, &polar.1), parameter);
        let index = parameter as usize;
        let weight = combined.azimuth_weight;
        let means: Vec<f64> = (azimuth.1.estimates.iter().flatten())
            .zip(polar.1.estimates.iter().flatten())
            .map(|(a, b)| weight * a[index] + (1.0 - weight) * b[index])
            .collect();
        let mean = means.iter().sum::<f64>() / 500.0;
        let variance = means.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / 499.0;
        assert!((combined.standard_error - variance.sqrt()).abs() < 1e-12, "{combined:?}");
        assert!((combined.value - PAPER.truth()[index]).abs() < 4.0 * combined.standard_error);
    }
}

/// The paper's object as the hub of a wheel: its point is fitted as one that does not turn, and as what it
/// is.
#[test]
fn a_point_on_a_rolling_wheel_gives_its_hub_back() {
    let rolling = Some(Rolling { radius: 0.525, rho: 1.0, angle: 0.4 });
    for (model, curves) in
        [(Model::Exact, Curves::Both), (Model::Exact, Curves::Azimuth), (Model::OneCone, Curves::Both)]
    {
        let case = Case { rolling, x0: -0.3, ..PAPER };
        for passage in [Passage::Known(case.x0), Passage::Fitted] {
            let options = FitOptions { model, curves, passage, rolling, ..FitOptions::default() };
            let fit = fit(&case.observations(model, 0), &options).expect("a fit");
            assert_recovers(&fit, case.truth(), 1e-8);
        }
    }
}

/// Over the passage of the street's wheel, in which it turns through tens of radians.
#[test]
fn fast_wheels_give_their_hubs_back_from_the_range_of_the_window() {
    let rolling = Some(Rolling { radius: 0.525, rho: 1.0, angle: 0.0 });
    for beta in [0.9, 0.95, 0.99] {
        let truth = [beta, 4.0, -1.975, -0.2288];
        let [_, y, z, x0] = truth;
        let observed = Simulation {
            speed: Speed::from_beta(beta).expect("a speed"),
            point: SourcePoint { x0, y, z },
            rolling,
            pair: Aperture::pair(0.1),
            model: Model::Exact,
            times: (0..240).map(|i| -5.198 + 24.783 / 239.0 * f64::from(i)).collect(),
            noise: 0.0,
            seed: 1,
        };
        let options = FitOptions { passage: Passage::Known(x0), rolling, ..FitOptions::default() };
        let fit = fit(&observed.observations().expect("usable samples"), &options).expect("a fit");
        assert_recovers(&fit, truth, 1e-9);
    }
}

#[test]
fn simulated_curves_of_a_wheel_are_its_disparities() {
    let rolling = Rolling { radius: 0.525, rho: 0.8, angle: 0.4 };
    let case = Case { x0: 0.4, separation: 0.3, rolling: Some(rolling), ..PAPER };
    let speed = Speed::from_beta(case.beta).expect("a speed");
    let Rolling { radius, rho, angle } = rolling;
    let hub = SourcePoint { x0: case.x0, y: case.y, z: case.z };
    let point = WheelPoint { hub, radius, rho, angle, turning: Turning::Rolling };
    for model in MODELS {
        for sample in case.samples(model, 0) {
            let seen =
                model.disparity(&speed, point, Aperture::pair(0.3), sample.time).expect("a pair along x");
            let [dphi, dtheta] =
                [sample.dphi, sample.dtheta].map(|reading| reading.expect("a reading").value);
            assert!((dphi - seen.dphi).abs() < 1e-15 && (dtheta - seen.dtheta).abs() < 1e-15);
        }
    }
}

#[test]
fn a_wheel_without_a_radius_is_refused() {
    let rolling = Some(Rolling { radius: 0.0, rho: 1.0, angle: 0.0 });
    let options = FitOptions { rolling, ..FitOptions::default() };
    let error = fit(&PAPER.observations(Model::Exact, 0), &options).expect_err("no wheel");
    assert!(error.to_string().contains("wheel_radius = 0e0"), "{error}");
}

/// Noisy cases of wheels seen from all sides: how often the right minimum is found.
#[test]
fn noisy_curves_of_wheels_give_their_hubs_back() {
    let mut random = ChaCha8Rng::seed_from_u64(21);
    let mut tally = Tally::default();
    for index in 0..20 {
        let drawn = Case::drawn(&mut random);
        let angle = f64::from(index as u32) * 0.7 - 3.0;
        let case = Case { rolling: Some(Rolling { radius: 0.1 * drawn.y, rho: 0.9, angle }), ..drawn };
        let passage = Passage::Known(case.x0);
        tally.add_fit(&case, &FitOptions { passage, rolling: case.rolling, ..FitOptions::default() }, index);
    }
    assert!(tally.right as f64 >= 0.95 * tally.cases as f64, "{tally} {:?}", tally.complaints);
}

/// Delta-phi alone of a wheel's point with the passage unknown: only the wheel distinguishes the two sides of
/// z = 0, and the search found a minimum on the wrong one.
#[test]
fn a_wheel_seen_in_azimuth_alone_is_looked_for_on_both_sides_of_the_level_of_the_eyes() {
    let rolling = Some(Rolling { radius: 0.215, rho: 0.98, angle: 0.060_813_601_790_062_68 });
    let case = Case {
        beta: 0.398,
        y: 3.46,
        z: -2.07,
        x0: 3.693_790_000_000_092_3,
        samples: 336,
        noise: 0.05,
        extent: 2.725_795_000_000_005,
        rolling,
        ..PAPER
    };
    let observations = case.observations(Model::Exact, 127);
    let passage = Passage::Fitted;
    let options = FitOptions { curves: Curves::Azimuth, passage, rolling, ..FitOptions::default() };
    let found = fit(&observations, &options).expect("a fit");
    let best = fit_from(&observations, &options, case.truth()).expect("a fit");
    assert!(found.rms <= best.rms * (1.0 + 1e-9), "{:?} for {:?}", found.values, best.values);
    assert!((found.value(Parameter::Z) + 2.07).abs() < 3.0 * found.standard_error(Parameter::Z));
    let other = found.other_side.expect("the search looks beyond the level of the eyes");
    let [beta, y, z, x0] = other.values;
    assert!(z > 0.0 && other.excess > 0.0);
    // By the sums of squares of two fits of their own.
    let there = fit_from(&observations, &options, [beta, y, z, x0]).expect("a fit");
    let excess = (there.rms.powi(2) / found.rms.powi(2) - 1.0) * (336.0 - 4.0);
    assert!((other.excess - excess).abs() < 1e-6 * excess, "{} for {excess}", other.excess);
}
