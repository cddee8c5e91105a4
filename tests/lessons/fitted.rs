//! Lessons 12 and 13: what is measured and fitted.

use relativity_core::{
    Aperture, DEFAULT_REPLICATES, FitOptions, Model, Parameter, PublishedVariant, Simulation, SourcePoint,
    Speed, bootstrap, disparity, fit,
};

use super::support::lesson;
use super::told::{number, observed, right, says, settings, words};

const PUBLISHED: Model = Model::Published(PublishedVariant::AppendixA);

/// The paper's point.
const POINT: SourcePoint = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };

fn speed() -> Speed {
    Speed::from_beta(0.9).expect("a speed")
}

fn dphi(model: Model, time: f64) -> f64 {
    model.disparity(&speed(), POINT, Aperture::pair(0.1), time).expect("seen").dphi
}

/// The fitted beta, its standard error, and by how many of these it is off: of so many samples with 1 % of
/// noise.
fn fitted(made: Model, fitted: Model, samples: usize, range: [f64; 2]) -> [f64; 3] {
    let [from, to] = range;
    let simulation = Simulation {
        speed: speed(),
        point: POINT,
        rolling: None,
        pair: Aperture::pair(0.1),
        model: made,
        times: (0..samples).map(|i| from + (to - from) * i as f64 / (samples - 1) as f64).collect(),
        noise: 0.01,
        seed: 1,
    };
    let observations = simulation.observations().expect("samples");
    let best = fit(&observations, &FitOptions { model: fitted, ..FitOptions::default() }).expect("a fit");
    let value = best.value(Parameter::Beta);
    let sigma = bootstrap(&best, DEFAULT_REPLICATES, 1)
        .map_or_else(|_| best.standard_error(Parameter::Beta), |found| found.standard_error(Parameter::Beta));
    [value, sigma, ((value - 0.9) / sigma).abs()]
}

/// The range of T of a lesson's samples.
fn range(name: &str) -> [f64; 2] {
    let settings = settings(&lesson(name), 0, false);
    let scene = settings.opened_scene().expect("a scene");
    settings.time_range(&settings.track(&scene))
}

#[test]
fn a_speed_is_measured_with_its_uncertainty() {
    let lesson = lesson("measure-speed");
    // The curve: largest before it is seen abreast, small far away, within what can be drawn.
    let t0 = 13.0025_f64.sqrt();
    let largest = (0..2000).map(|i| -5.0 + 0.01 * f64::from(i)).max_by(|a, b| {
        let size = |time: &f64| dphi(Model::Exact, *time).abs();
        size(a).total_cmp(&size(b))
    });
    let largest = largest.expect("a T");
    assert!(largest < t0 - 1.0, "largest at {largest}");
    assert!(dphi(Model::Exact, largest) > -0.06 && dphi(Model::Exact, largest) < -0.033);
    assert!(dphi(Model::Exact, -100.0).abs() < 1e-3);
    assert_eq!(observed(&lesson, 0), "before it is seen abreast");
    // A point at rest straight ahead, three units away.
    let ahead = SourcePoint { x0: 0.0, y: 3.0, z: 0.0 };
    let [left, right_eye] = Aperture::pair(0.1);
    let still = disparity(&Speed::REST, ahead, left, right_eye, 0.0).expect("seen");
    assert!((still.dphi + 0.033).abs() < 5e-4);

    let range = range("measure-speed");
    let [value, sigma, off] = fitted(Model::Exact, Model::Exact, 240, range);
    assert!(off < 3.0 && (value - 0.9).abs() < 3.0 * sigma);
    assert!(right(&lesson, 1).starts_with("near 0.9"));
    assert_eq!(observed(&lesson, 1), "by less than 3");
    says(&lesson, 1, "β = {}", value, 4);
    says(&lesson, 1, "± {}", sigma, 4);
    says(&lesson, 1, "off by {} of it", off, 1);
    assert!(
        words(&lesson, 1).contains("240 of them") && words(&lesson, 1).contains("1 % of the curve's range")
    );

    // Four times the readings, half the uncertainty: as 1/sqrt(N), within what a bootstrap tells.
    let [value, quarter, off] = fitted(Model::Exact, Model::Exact, 960, range);
    assert!((quarter / sigma - 0.5).abs() < 0.1, "{quarter} of {sigma}");
    assert!(off < 3.0 && value != 0.9);
    assert_eq!(settings(&lesson, 2, true).fit.fit_samples, 960);
    assert_eq!(right(&lesson, 2), "half as large");
    assert!(observed(&lesson, 2).starts_with("yes"));
    says(&lesson, 2, "Now it is β = {}", value, 5);
    says(&lesson, 2, "± {}.", quarter, 5);
}

#[test]
fn the_published_model_leaves_out_parallax_and_its_fit_is_wrong() {
    let lesson = lesson("parallax");
    // Seen abreast both eyes receive one event, from x = 0: its azimuths differ by the angle of d at y.
    let parallax = 2.0 * (0.05_f64 / 3.0).atan();
    assert!((number(&lesson, 0) - parallax).abs() < 1e-6 && (parallax - 0.033).abs() < 5e-4);
    assert!(dphi(PUBLISHED, 13.0025_f64.sqrt()).abs() < 1e-15);
    assert_eq!(observed(&lesson, 0), "no difference at all");
    says(&lesson, 0, "what is due to the delays: {} here", 0.0, 4);

    let range = range("parallax");
    let [value, sigma, off] = fitted(Model::Exact, PUBLISHED, 240, range);
    assert!(off > 10.0);
    assert!(right(&lesson, 1).starts_with("wrong, by many"));
    says(&lesson, 1, "β = {}", value, 4);
    says(&lesson, 1, "± {}", sigma, 4);
    says(&lesson, 1, ": {} standard errors off", off, 0);

    let [more_value, more_sigma, more_off] = fitted(Model::Exact, PUBLISHED, 960, range);
    assert!((more_value - value).abs() < sigma, "it stays as wrong");
    assert!(more_sigma < 0.7 * sigma && more_off > 1.3 * off);
    assert_eq!(
        (right(&lesson, 2), observed(&lesson, 2)),
        ("about as wrong, with a smaller uncertainty", "it grew")
    );
    says(&lesson, 2, "β = {}", more_value, 4);
    says(&lesson, 2, ": {} standard errors off", more_off, 0);

    let [value, sigma, off] = fitted(PUBLISHED, PUBLISHED, 240, range);
    assert!(off < 3.0);
    assert!(right(&lesson, 3).starts_with("the right speed"));
    says(&lesson, 3, "β = {}", value, 4);
    says(&lesson, 3, "± {}", sigma, 4);
    says(&lesson, 3, ": {} standard errors off", off, 1);
}

#[test]
fn a_fit_that_misses_its_readings_does_so_in_long_stretches() {
    let [from, to] = range("parallax");
    let times: Vec<f64> = (0..240).map(|i| from + (to - from) * f64::from(i) / 239.0).collect();
    let simulation = Simulation {
        speed: speed(),
        point: POINT,
        rolling: None,
        pair: Aperture::pair(0.1),
        model: Model::Exact,
        times: times.clone(),
        noise: 0.01,
        seed: 1,
    };
    let observations = simulation.observations().expect("samples");
    // Signs of what is left over of Delta-phi: chance changes them in half of all places.
    let changes = |model| {
        let best = fit(&observations, &FitOptions { model, ..FitOptions::default() }).expect("a fit");
        let left: Vec<bool> = observations
            .samples()
            .iter()
            .map(|sample| {
                let [dphi, _] = best.angles(0, sample.time).expect("a curve");
                sample.dphi.expect("a reading").value > dphi
            })
            .collect();
        left.windows(2).filter(|pair| pair[0] != pair[1]).count()
    };
    assert!(changes(Model::Exact) > 90 && changes(PUBLISHED) < 40, "{}", changes(PUBLISHED));
    assert!(observed(&lesson("parallax"), 1).starts_with("no, it misses"));
}
