//! The test of residuals that follow one another: it is silent on good readings, and speaks where the model
//! or what it is given is wrong.

use rand::{Rng, RngExt as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use relativity_core::fit::FALSE_ALARM;
use relativity_core::{
    Aperture, Baseline, Curves, Fit, FitOptions, Leg, Model, Observations, Reading, Ride, RideMoment, Sample,
    Simulation, SourcePoint, Speed, fit, math,
};

use crate::common::{Case, PAPER};

/// Sets of each kind.
const SETS: u64 = 66;
/// Of these as many must be remarked on.
const REMARKED: usize = 64;

/// A set as somebody at a table takes it: 41 readings of each curve, noise of 0.1 to 0.5 % of their range.
fn drawn(random: &mut impl Rng) -> Case {
    let mut between = |low: f64, high: f64| random.random_range(low..high);
    let [beta, y, z] =
        [between(0.3, 0.95), between(1.0, 5.0), between(0.5, 4.0) * between(-1.0, 1.0).signum()];
    Case { beta, y, z, noise: between(0.001, 0.005), samples: 41, ..PAPER }
}

/// Whether the fit of both curves is refused, or its residuals are no chance.
fn is_remarked(observations: &Observations) -> bool {
    let is_good = |fit: Fit| fit.serial.is_none_or(|serial| serial.is_chance());
    !fit(observations, &FitOptions::default()).is_ok_and(is_good)
}

/// Asserts that sets that are `broken` are remarked on.
fn assert_remarked(name: &str, broken: impl Fn(&Case, &mut ChaCha8Rng, u64) -> Observations) {
    let remarked = (0..SETS).filter(|&seed| {
        let mut random = ChaCha8Rng::seed_from_u64(1000 + seed);
        let case = drawn(&mut random);
        is_remarked(&broken(&case, &mut random, seed))
    });
    let remarked = remarked.count();
    assert!(remarked >= REMARKED, "{name}: {remarked} of {SETS}");
}

/// The samples of a case, changed, as seen by a pair of eyes that is taken to be this one.
fn changed(case: &Case, seed: u64, pair: [Aperture; 2], change: impl Fn(Sample) -> Sample) -> Observations {
    let samples = case.samples(Model::Exact, seed).into_iter().map(change).collect();
    Observations::new(vec![pair], samples).expect("usable samples")
}

fn scaled(reading: Option<Reading>, by: f64) -> Option<Reading> {
    reading.map(|reading| Reading { value: by * reading.value, ..reading })
}

#[test]
fn good_readings_raise_no_alarm() {
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let (mut fits, mut alarms, mut lowest) = (0, 0, 0);
    for seed in 0..200 {
        for samples in [8, 12, 41, 240] {
            let case = Case { samples, ..drawn(&mut random) };
            let observations = case.observations(Model::Exact, seed);
            for curves in [Curves::Azimuth, Curves::Polar, Curves::Both] {
                let Ok(best) = fit(&observations, &FitOptions { curves, ..FitOptions::default() }) else {
                    continue;
                };
                let serial = best.serial.expect("noisy readings are judged");
                fits += 1;
                alarms += usize::from(!serial.is_chance());
                lowest += usize::from(serial.probability < 0.05);
            }
        }
    }
    assert!(fits > 2000, "{fits}");
    // By a Poisson distribution of mean 2.4 there are more than 8 once in a thousand times.
    let expected = FALSE_ALARM * f64::from(fits);
    assert!(alarms <= 8, "{alarms} of {fits}, where {expected} are expected");
    let share = f64::from(lowest as u32) / f64::from(fits);
    assert!((0.03..0.07).contains(&share), "{share} below 5 %");
}

/// The number is that of its definition, over both curves.
#[test]
fn the_number_is_that_of_its_definition() {
    let case = Case { noise: 0.01, samples: 60, ..PAPER };
    let samples = case.samples(Model::Exact, 3);
    let shuffled = samples.iter().rev().copied().collect();
    let observations = Observations::of_pair(case.separation, shuffled).expect("usable samples");
    let best =
        fit(&observations, &FitOptions { curves: Curves::Polar, ..FitOptions::default() }).expect("a fit");
    let residual = |sample: &Sample| {
        let fitted = best.angles(0, sample.time).expect("a curve")[1];
        sample.dtheta.expect("a reading").value - fitted
    };
    let residuals: Vec<f64> = samples.iter().map(residual).collect();
    let differences: f64 = residuals.windows(2).map(|pair| (pair[1] - pair[0]).powi(2)).sum();
    let expected = differences / residuals.iter().map(|value| value * value).sum::<f64>();
    let found = best.serial.expect("it is judged").durbin_watson;
    assert!((found - expected).abs() < 1e-9, "{found} {expected}");
}

#[test]
fn readings_without_noise_are_not_judged() {
    let best = fit(&PAPER.observations(Model::Exact, 0), &FitOptions::default()).expect("a fit");
    assert!(best.serial.is_none(), "{:?}", best.serial);
}

#[test]
fn a_wrong_zero_of_the_clock_is_remarked_on() {
    assert_remarked("clock", |case, random, seed| {
        let by = random.random_range(0.2..2.0)
            * math::hypot(case.y, case.z)
            * random.random_range(-1.0..1.0_f64).signum();
        changed(case, seed, Aperture::pair(case.separation), |sample| Sample {
            time: sample.time + by,
            ..sample
        })
    });
}

#[test]
fn degrees_taken_for_radians_are_remarked_on() {
    assert_remarked("degrees", |case, _, seed| {
        changed(case, seed, Aperture::pair(case.separation), |sample| Sample {
            dphi: scaled(sample.dphi, 1_f64.to_degrees()),
            dtheta: scaled(sample.dtheta, 1_f64.to_degrees()),
            ..sample
        })
    });
}

#[test]
fn milliseconds_taken_for_seconds_are_remarked_on() {
    assert_remarked("milliseconds", |case, _, seed| {
        changed(case, seed, Aperture::pair(case.separation), |sample| Sample {
            time: 1e3 * sample.time,
            ..sample
        })
    });
}

#[test]
fn eyes_that_are_closer_than_said_are_remarked_on() {
    assert_remarked("separation", |case, _, seed| {
        changed(&Case { noise: 0.001, ..*case }, seed, Aperture::pair(1.07 * case.separation), |sample| {
            sample
        })
    });
}

#[test]
fn a_tilted_head_taken_as_straight_is_remarked_on() {
    assert_remarked("head", |case, random, seed| {
        let roll = random.random_range(0.1..0.5) * random.random_range(-1.0..1.0_f64).signum();
        let tilted = Baseline { separation: case.separation, roll, turn: 0.0 };
        let simulation = Simulation {
            speed: Speed::from_beta(case.beta).expect("a speed"),
            point: SourcePoint { x0: 0.0, y: case.y, z: case.z },
            rolling: None,
            pair: tilted.apertures(),
            model: Model::Exact,
            times: case.times(),
            noise: case.noise,
            seed,
        };
        let samples = simulation.observations().expect("usable samples").samples().to_vec();
        Observations::of_pair(case.separation, samples).expect("usable samples")
    });
}

/// Who rides past a lamp and speeds up, as the eyes see it: mirrored, as `gamow fit --riding` does.
#[test]
fn a_rider_who_accelerates_taken_as_coasting_is_remarked_on() {
    assert_remarked("rider", |case, random, seed| {
        let leg = Leg { duration: 1e3, acceleration: [random.random_range(0.03..0.2), 0.0, 0.0] };
        let start = RideMoment { place: [-2.0 * case.y, 0.0, 0.0], ..RideMoment::AT_REST };
        let moving = start.after(math::atanh(0.6 * case.beta) / leg.acceleration[0], leg.acceleration);
        let start = RideMoment { place: start.place, proper_time: 0.0, time: 0.0, ..moving };
        let ride = Ride::new(start, vec![leg]);
        let lamp = SourcePoint { x0: 0.0, y: case.y, z: case.z };
        let seen = |number: usize| {
            let clock = 6.0 * case.y * number as f64 / 40.0;
            let observer = ride.at(clock).observer().expect("a speed");
            let pair = Aperture::pair(case.separation);
            let both = observer.disparity(Model::Exact, &Speed::REST, lamp, pair, 0.0).expect("inside");
            [clock, both.dphi, -both.dtheta]
        };
        let curves: Vec<[f64; 3]> = (0..41).map(seen).collect();
        noisy(&curves, case, seed)
    });
}

/// Samples of a curve of time, dphi and dtheta, with the noise of `case`.
fn noisy(curves: &[[f64; 3]], case: &Case, seed: u64) -> Observations {
    let quiet = case.samples(Model::Exact, seed);
    let clean = Case { noise: 0.0, ..*case }.samples(Model::Exact, seed);
    let range = |of: &dyn Fn(usize) -> f64, count: usize| {
        (0..count).map(of).fold(f64::NEG_INFINITY, f64::max)
            - (0..count).map(of).fold(f64::INFINITY, f64::min)
    };
    let value = |samples: &[Sample], row: usize, curve: usize| {
        [samples[row].dphi, samples[row].dtheta][curve].expect("a reading").value
    };
    let noise = |row: usize, curve: usize| {
        let scale = range(&|row| curves[row][curve + 1], curves.len())
            / range(&|row| value(&clean, row, curve), clean.len());
        scale * (value(&quiet, row, curve) - value(&clean, row, curve))
    };
    let reading = |row: usize, curve: usize| {
        Some(Reading { value: curves[row][curve + 1] + noise(row, curve), sigma: None })
    };
    let sample =
        |row: usize| Sample { time: curves[row][0], pair: 0, dphi: reading(row, 0), dtheta: reading(row, 1) };
    Observations::of_pair(case.separation, (0..curves.len()).map(sample).collect()).expect("usable samples")
}

/// Fits of one curve alone are judged, too.
#[test]
fn a_curve_alone_is_judged() {
    let seen = |fit: Fit| fit.serial.expect("it is judged");
    let case = Case { beta: 0.7, samples: 41, noise: 0.003, ..PAPER };
    let late = changed(&case, 1, Aperture::pair(0.1), |sample| Sample { time: sample.time + 3.0, ..sample });
    let best = fit(&late, &FitOptions { curves: Curves::Azimuth, ..FitOptions::default() }).expect("a fit");
    assert!(!seen(best).is_chance());
}
