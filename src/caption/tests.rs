//! The sentences of moments, against numbers of the core.

use clap::ValueEnum as _;
use relativity_core::{Aperture, PublishedVariant, SourcePoint, Speed, published_disparity, sighting};
use relativity_render::{Colour, Emission, Geometry, Motion, Velocity};

use super::Moment;
use crate::flags::{SpeedParameter, SpeedSetting};
use crate::scene::{Scene, Track};
use crate::settings::Settings;
use crate::units::Units;

const POINT: Track = Track { rest: [0.0, 3.0, 2.0], motion: Motion::Scene, spin: None };

fn settings(beta: f64, d: f64) -> Settings {
    let mut settings = Settings::default();
    settings.motion.speed = SpeedSetting::new(SpeedParameter::Beta, beta).expect("a speed");
    settings.motion.d = d;
    settings
}

fn moment(settings: &Settings, time: f64) -> Moment {
    Moment::new(settings, &POINT, "the front tyre".to_owned(), Emission::Wavelength(700.0), time)
}

/// Returns t and wavelength for each eye by the core, and the time of a clock at the event: that of its own
/// frame, as Lorentz has it.
fn core(beta: f64, d: f64, time: f64) -> [[f64; 3]; 2] {
    let speed = Speed::from_beta(beta).expect("a speed");
    let source = SourcePoint::from_rest(POINT.rest, &speed);
    Aperture::pair(d).map(|eye| {
        let seen = sighting(&speed, source, eye, time).expect("in the domain");
        let (t, x) = (seen.retarded_time, source.x0 + beta * seen.retarded_time);
        [t, 700.0 / seen.doppler_factor, (t - beta * x) / (1.0 - beta * beta).sqrt()]
    })
}

#[test]
fn the_sentence_tells_times_wavelengths_and_colours_of_both_eyes() {
    let [[left, left_nm, left_own], [right, right_nm, right_own]] = core(0.9, 0.1, 1.1);
    let expected = format!(
        "The light reaching you now (T = 1.10) left the front tyre at t = {left:.2} for the left eye, {right:.2} for the \
         right, when its own clock read τ = {left_own:.2} and {right_own:.2}: {left_nm:.0} and {right_nm:.0} nm, orange and yellow."
    );
    assert_eq!(
        moment(&settings(0.9, 0.1), 1.1).sentence(),
        expected.replace("= -", "= −").replace(", -", ", −").replace("and -", "and −")
    );
}

#[test]
fn few_words_tell_colours_and_the_pace_of_the_clock() {
    let early = moment(&settings(0.9, 0.1), 1.1);
    assert_eq!(early.looks().as_deref(), Some("looks orange to the left eye, yellow to the right"));
    let factors = core(0.9, 0.1, 1.1).map(|[_, nm, _]| 700.0 / nm);
    let expected = format!("its clock looks fast: D = {:.2} and {:.2}", factors[0], factors[1]);
    assert_eq!(early.pace().map(|pace| pace.replace('\u{a0}', " ")), Some(expected));
    let late = moment(&settings(0.9, 0.0), 12.0);
    assert_eq!(late.looks().as_deref(), Some("looks infrared (eyes see nothing)"));
    assert!(late.pace().is_some_and(|pace| pace.starts_with("its clock looks slow: D")));
    let mut white = settings(0.9, 0.1);
    white.light.colour = Colour::White;
    assert_eq!(moment(&white, 1.1).looks().as_deref(), Some("looks bluer than at rest"));
    let mut contracted = settings(0.9, 0.1);
    contracted.look.geometry = Geometry::Contracted;
    let measured = moment(&contracted, 1.1);
    assert_eq!((measured.looks(), measured.pace()), (None, None));
}

#[test]
fn a_sentence_has_the_units_of_the_window() {
    let scene = Scene::preset("cyclist").expect("a preset");
    let told =
        |units: Units| moment(&settings(0.9, 0.1), 1.1).with_measures(units.measures(&scene)).sentence();
    // 0.65 m take light 2.168166621 ns, and 0.078 s at 30 km/h.
    let [metric, town] = [Units::Metric, Units::Town].map(told).map(|text| text.replace('\u{a0}', " "));
    let [[t, ..], _] = core(0.9, 0.1, 1.1);
    for (sentence, factor, decimals, unit) in [(metric, 2.168_166_621, 2, "ns"), (town, 0.078, 3, "s")] {
        let time = |value: f64| format!("= {:.decimals$} {unit}", value * factor).replace('-', "−");
        for time in [time(1.1), time(t)] {
            assert!(sentence.contains(&time), "{time} in {sentence}");
        }
    }
    assert_eq!(told(Units::Natural), moment(&settings(0.9, 0.1), 1.1).sentence());
}

#[test]
fn what_rests_has_no_clock_but_those_on_the_ground() {
    let post = Track { rest: [5.0, 3.0, 2.0], motion: Motion::Own(Velocity::REST), spin: None };
    let name = "the lamp post".to_owned();
    let post = Moment::new(&settings(0.9, 0.1), &post, name, Emission::Wavelength(700.0), 1.1);
    assert!(!post.sentence().contains("own clock"), "{}", post.sentence());
}

#[test]
fn what_eyes_do_not_see_is_said() {
    let early = moment(&settings(0.9, 0.1), -1.0).sentence();
    assert!(early.ends_with("nm, ultraviolet: eyes see nothing."), "{early}");
    let late = moment(&settings(0.9, 0.1), 12.0).sentence();
    assert!(late.ends_with("nm, infrared: eyes see nothing."), "{late}");
}

#[test]
fn eyes_in_one_place_have_one_sentence() {
    let sentence = moment(&settings(0.9, 0.0), 1.1).sentence();
    assert!(!sentence.contains("eye") && sentence.matches("nm").count() == 1, "{sentence}");
}

#[test]
fn eyes_that_hardly_differ_are_told_apart_by_more_decimals() {
    let sentence = moment(&settings(0.9, 1e-3), 1.1).sentence();
    let [[left, ..], [right, ..]] =
        core(0.9, 1e-3, 1.1).map(|eye| eye.map(|value| (value * 1e3).round() / 1e3));
    assert!(left != right, "{left} {right}");
    assert!(
        sentence.contains(&format!("{left:.3} for the left eye, −{:.3}", -right).replace('-', "−")),
        "{sentence}"
    );
}

#[test]
fn at_rest_light_arrives_as_it_left() {
    for &geometry in Geometry::value_variants() {
        let mut settings = settings(0.0, 0.1);
        settings.look.geometry = geometry;
        let sentence = moment(&settings, 1.1).sentence();
        assert!(
            sentence.starts_with("The light reaching you now (T = 1.10) left the front tyre at t = −2.5"),
            "{sentence}"
        );
        assert!(sentence.ends_with(": 700 nm, red."), "{sentence}");
    }
}

#[test]
fn what_is_measured_is_not_said_to_be_seen() {
    let mut settings = settings(0.6, 0.1);
    settings.look.geometry = Geometry::Contracted;
    let sentence = moment(&settings, 2.5).sentence();
    assert_eq!(
        sentence,
        "The front tyre is drawn where it is now (t = 2.50, x = 1.50), as measured on the ground: nobody sees this."
    );
    assert_eq!(moment(&settings, 2.5).doppler_factors(), [None; 2]);
}

#[test]
fn who_rides_along_receives_no_shift_from_what_rides_along() {
    let mut settings = settings(0.6, 0.1);
    settings.look.geometry = Geometry::Rest;
    let riding = moment(&settings, 2.5);
    assert_eq!(riding.doppler_factors(), [Some(1.0); 2]);
    assert!(riding.sentence().ends_with("from the front tyre: 700 nm, red."), "{}", riding.sentence());
    // A lamp post that comes towards them.
    let post = Track { rest: [500.0, 3.0, 2.0], motion: Motion::Own(Velocity::REST), spin: None };
    let post = Moment::new(&settings, &post, "the lamp post".to_owned(), Emission::Wavelength(700.0), 0.0);
    // D = sqrt((1 + 0.6)/(1 - 0.6)) = 2 head-on.
    assert!(post.wavelengths_nm().iter().all(|nm| (nm.expect("received") - 350.0).abs() < 0.1), "{post:?}");
}

#[test]
fn one_light_cone_for_both_eyes_is_said_to_be_made_up() {
    let mut settings = settings(0.9, 0.1);
    settings.look.geometry = Geometry::OneCone;
    let moment = moment(&settings, 1.1);
    let sentence = moment.sentence();
    assert!(sentence.starts_with("As if both eyes received the same events"), "{sentence}");
    assert_eq!(sentence.matches("nm").count(), 1, "{sentence}");
    // What the middle receives.
    let [[left, ..], [right, ..]] = core(0.9, 0.1, 1.1);
    let [[middle, wavelength, _], _] = core(0.9, 0.0, 1.1);
    assert!(left < middle && middle < right || right < middle && middle < left);
    assert!(sentence.contains(&format!("at t = {middle:.2}").replace('-', "−")), "{sentence}");
    assert!(moment.wavelengths_nm().iter().flatten().all(|nm| (nm - wavelength).abs() < 1e-9));
}

#[test]
fn the_published_model_says_so() {
    let mut settings = settings(0.9, 0.1);
    settings.look.geometry = Geometry::Published;
    let moment = moment(&settings, 1.1);
    let sentence = moment.sentence();
    let told = ["for the left eye and, as published, at t = ", "for the right eye: ", "the paper's model"];
    assert!(told.iter().all(|part| sentence.contains(part)), "{sentence}");
    let speed = Speed::from_beta(0.9).expect("a speed");
    let point = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };
    let model = published_disparity(&speed, point, 0.1, 1.1, PublishedVariant::AppendixA);
    let both = model.expect("in the domain");
    let expected = [both.primary, both.secondary].map(|seen| Some(700.0 / seen.doppler_factor));
    for (shown, expected) in moment.wavelengths_nm().iter().zip(expected) {
        assert!((shown.expect("a line") - expected.expect("a number")).abs() < 1e-9);
    }
}

#[test]
fn light_of_many_wavelengths_is_told_by_its_shift() {
    let name = || "the house".to_owned();
    let broad = Moment::new(&settings(0.9, 0.1), &POINT, name(), Emission::WHITE, 12.0);
    assert!(broad.sentence().ends_with("redder than at rest."), "{}", broad.sentence());
    assert_eq!(broad.wavelengths_nm(), [None; 2]);
}

#[test]
fn what_glows_is_told_by_its_temperatures() {
    let mut settings = settings(0.9, 0.1);
    (settings.light.colour, settings.light.temperature) = (Colour::Glowing, 1000.0);
    let [[_, left, _], [_, right, _]] = core(0.9, 0.1, 1.1);
    let sentence = moment(&settings, 1.1).sentence();
    let expected = format!(": a glow of 1000 K, received as of {:.0} and {:.0} K.", 7e5 / left, 7e5 / right);
    assert!(sentence.ends_with(&expected), "{sentence} {expected}");
    let late = moment(&settings, 12.0).sentence();
    assert!(late.ends_with("K: eyes see nothing."), "{late}");
    settings.light.colour = Colour::False;
    assert!(moment(&settings, 1.1).sentence().ends_with("false ones, which tell D."));
}

#[test]
fn extremes_are_told_in_numbers() {
    let mut all = Vec::new();
    for gamma in [1.0, 1.0 + 1e-9, 2.0, 1e5, 1e12, 1e30] {
        for d in [0.0, 1e-9, 0.1, 1e6] {
            for time in [-1e12, -3.0, 0.0, 4.0, 1e12] {
                for &geometry in Geometry::value_variants() {
                    let mut settings = settings(0.0, d);
                    settings.motion.speed = SpeedSetting::new(SpeedParameter::Gamma, gamma).expect("a speed");
                    settings.look.geometry = geometry;
                    settings.motion.depth_shift = -3.0;
                    settings.motion.height_shift = -2.0;
                    all.push(moment(&settings, time).sentence());
                }
            }
        }
    }
    let is_broken =
        |sentence: &&String| sentence.replace("infrared", "").contains("inf") || sentence.contains("NaN");
    assert_eq!(all.iter().find(is_broken), None);
}

#[test]
fn a_point_of_a_wheel_has_the_time_of_its_axle_and_the_light_of_its_own_motion() {
    let street = Scene::preset("street").expect("a preset");
    // The front of the front tyre at t' = 0: its wheel is 0.525 high and 4 away.
    let rim = street.track(Some([0.0, 4.0, -1.975]));
    let moment = |settings: &Settings| {
        Moment::new(settings, &rim, "the front tyre".to_owned(), Emission::Wavelength(700.0), 1.0)
    };
    let seen = moment(&settings(0.9, 0.1)).sentence();
    assert!(seen.contains(", when its axle's clock read τ = "), "{seen}");
    // A camera that rides along sees it turn about a hub at rest: D = sqrt(1 - v^2)/(1 + v.n).
    let mut riding = settings(0.9, 0.0);
    riding.look.geometry = Geometry::Rest;
    let found = moment(&riding).doppler_factors()[0].expect("light");
    let gamma = 1.0 / 0.19f64.sqrt();
    let hub = [-0.525 + 0.9 * gamma, 4.0, -1.975];
    let (mut own, omega) = (gamma - 4.5, 0.9 / 0.525);
    let mut place = [0.0; 3];
    let far = |place: [f64; 3]| place.iter().map(|x| x * x).sum::<f64>().sqrt();
    for _ in 0..400 {
        // The eye is at x = -gamma beta T in that frame, when its clocks show gamma T.
        let (sin, cos) = (omega * own).sin_cos();
        place = [hub[0] + 0.525 * cos, hub[1], hub[2] - 0.525 * sin];
        own = gamma - far(place);
    }
    let (sin, cos) = (omega * own).sin_cos();
    let along = -0.9 * (sin * place[0] + cos * place[2]) / far(place);
    assert!((found / (0.19f64.sqrt() / (1.0 + along)) - 1.0).abs() < 1e-9, "{found}");
}
