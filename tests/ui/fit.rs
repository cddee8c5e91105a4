//! The Fit tab: what it recovers from noisy curves, and what it says where there is nothing to recover. The
//! corrected view, which shows whether the fitted speed is right.

use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{PlaybackCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::flags::choices::ProjectionChoice;
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::settings::{FitSettings, MAX_SEED, PlotSettings, PlotTab, Presence, Settings, Theme};
use relativity_core::{
    Curves, FitOptions, Model, Observations, Parameter, PublishedVariant, Reading, Sample, fit,
};
use relativity_render::Geometry;

use super::Test;
use super::support::{
    SEPARATION, cyclist, labels, rest, seen, settle, shown, type_into, wait_for_rest, window, window_of_size,
};

pub const TESTS: &[Test] = trials![
    the_fit_recovers_speed_and_distance,
    each_curve_alone_recovers_them_too,
    without_noise_the_fit_is_exact,
    the_published_model_is_biased_and_says_so,
    one_light_cone_is_biased_unless_the_views_show_it,
    what_cannot_be_fitted_is_said_in_words,
    intervals_keep_to_what_is_possible,
    the_fit_follows_the_controls,
    a_hidden_fit_is_not_made,
    a_window_that_shows_a_fit_rests,
    the_corrected_picture_is_red_if_the_fit_is_right,
    the_corrected_picture_costs_nothing_when_off,
    extremes_are_fitted_and_corrected_without_harm,
    a_seed_typed_too_large_is_the_largest,
];

const APPENDIX_A: Model = Model::Published(PublishedVariant::AppendixA);

/// The default scene at this beta, with this fit in view.
fn fitted(beta: f64, setup: FitSettings) -> State {
    let mut state = cyclist(beta);
    state.run(SettingsCommand::Fit(setup));
    state.run(SettingsCommand::Plots(PlotSettings { plot: PlotTab::Fit, ..PlotSettings::default() }));
    state
}

fn a_seed_typed_too_large_is_the_largest() {
    let mut window = window_of_size(fitted(0.9, FitSettings::default()), [1280.0, 1600.0], 1.0);
    type_into(&mut window, "Seed", "1e300");
    let shown = window.state().state().shown();
    assert_eq!(shown.fit.seed, MAX_SEED);
    let written =
        Settings::default().with_toml(&shown.to_toml(), "state.toml").expect("it can be read again");
    assert_eq!(written.fit.seed, MAX_SEED);
}

fn window_with_fit(state: State) -> Harness<'static, App> {
    let mut window = window(state);
    settle(&mut window);
    window
}

fn estimate(window: &Harness<'_, App>, symbol: &str) -> [f64; 2] {
    [shown(window, &format!("Fitted {symbol}")), shown(window, &format!("Uncertainty of {symbol}"))]
}

/// The first text that starts with `words`.
fn text(window: &Harness<'_, App>, words: &str) -> String {
    let all = labels(window);
    let found = all.iter().find(|label| label.starts_with(words));
    found.unwrap_or_else(|| panic!("no {words:?} in {all:?}")).clone()
}

fn the_fit_recovers_speed_and_distance() {
    // Beside the map there is room for one of the plots.
    let mut state = cyclist(0.9);
    state.document.settings.window.map = Presence::Off;
    let mut window = window(state);
    window.get_by_label("Fit").click();
    window.run_steps(2);
    settle(&mut window);
    for (symbol, truth) in [("β", 0.9), ("y", 3.0), ("z", 2.0)] {
        let [value, uncertainty] = estimate(&window, symbol);
        assert!(uncertainty > 0.0 && uncertainty < 0.02, "{symbol}: {uncertainty}");
        assert!((value - truth).abs() < 3.0 * uncertainty, "{symbol} = {value} +- {uncertainty}");
        assert_eq!(shown(&window, &format!("True {symbol}")), truth);
    }
    text(&window, "Agrees with the truth");
    for name in ["Fit of Δφ against T", "Residuals of Δφ against T", "Fit of Δθ against T"] {
        assert!(window.get_by_label(name).rect().height() > 40.0, "{name}");
    }
    window.render().expect("a picture");
}

fn each_curve_alone_recovers_them_too() {
    for curves in [Curves::Azimuth, Curves::Polar] {
        let setup = FitSettings { curves, noise_percent: 0.5, fit_x0: true, ..FitSettings::default() };
        let mut state = fitted(0.6, setup);
        let mut motion = state.document.settings.motion;
        motion.height_shift = -3.5; // z = -1.5, of which Δφ tells only the magnitude
        state.run(SettingsCommand::Motion(motion));
        let window = window_with_fit(state);
        let z = if curves == Curves::Azimuth { 1.5 } else { -1.5 };
        for (symbol, truth) in [("β", 0.6), ("y", 3.0), ("z", z), ("x₀", 0.0)] {
            let [value, uncertainty] = estimate(&window, symbol);
            assert!(
                (value - truth).abs() < 4.0 * uncertainty,
                "{curves:?}: {symbol} = {value} +- {uncertainty}"
            );
        }
    }
}

fn without_noise_the_fit_is_exact() {
    let window = window_with_fit(fitted(0.9, FitSettings { noise_percent: 0.0, ..FitSettings::default() }));
    for (symbol, truth) in [("β", 0.9), ("y", 3.0), ("z", 2.0)] {
        assert!((estimate(&window, symbol)[0] - truth).abs() <= 1e-9, "{symbol}");
    }
    let error = text(&window, "Recovered to ");
    let error = error.trim_start_matches("Recovered to ").trim_end_matches('.').replace('−', "-");
    assert!(error.parse::<f64>().expect("a number") < 1e-9, "{error}");
}

fn the_published_model_is_biased_and_says_so() {
    let setup = FitSettings { model: APPENDIX_A, curves: Curves::Polar, ..FitSettings::default() };
    let window = window_with_fit(fitted(0.9, setup));
    assert!((shown(&window, "Fitted β") - 0.9).abs() > 0.01);
    text(&window, "Uncertainty of β: —");
    text(&window, "95 % interval of β: —");
    text(&window, "Wrong: ");
    text(&window, "The residuals of dtheta follow one another (Durbin-Watson 0.");
    let note = text(&window, "Leaving out parallax biases it, even without noise: β by ");
    let bias = published_beta_of_exact_curves(window.state().state(), setup) - 0.9;
    assert!(bias > 0.05 && note.contains(&format!("β by +{bias:.3},")), "{note} for {bias}");
}

fn one_light_cone_is_biased_unless_the_views_show_it() {
    let setup = FitSettings { model: Model::OneCone, noise_percent: 0.0, ..FitSettings::default() };
    let two_cones = window_with_fit(fitted(0.9, setup));
    let beta = shown(&two_cones, "Fitted β");
    assert!((beta - 0.9).abs() > 0.05, "β = {beta}");
    text(&two_cones, "Uncertainty of β: —");
    text(&two_cones, "Taking one light cone for both eyes biases it, even without noise: β by ");
    // The data are those of the views.
    let mut state = fitted(0.9, setup);
    state.document.settings.look.geometry = Geometry::OneCone;
    let one_cone = window_with_fit(state);
    let [beta, _] = estimate(&one_cone, "β");
    assert!((beta - 0.9).abs() < 1e-9, "β = {beta}");
    assert!(!labels(&one_cone).iter().any(|label| label.contains("biases it")));
}

/// Beta that the published model fits to exact curves without noise, by the core.
fn published_beta_of_exact_curves(state: &State, setup: FitSettings) -> f64 {
    let [from, to] = state.time_range();
    let sample = |index: usize| {
        let time = from + (to - from) * index as f64 / (setup.fit_samples - 1) as f64;
        let [left, right] = [0, 1].map(|eye| seen(0.9, time, eye).theta());
        Sample { time, pair: 0, dphi: None, dtheta: Some(Reading { value: left - right, sigma: None }) }
    };
    let observed = Observations::of_pair(SEPARATION, (0..setup.fit_samples).map(sample).collect());
    let options = FitOptions { model: setup.model, curves: setup.curves, ..FitOptions::default() };
    fit(&observed.expect("usable samples"), &options).expect("a fit").value(Parameter::Beta)
}

fn what_cannot_be_fitted_is_said_in_words() {
    let mut together = fitted(0.9, FitSettings::default());
    let mut motion = together.document.settings.motion;
    motion.d = 0.0;
    together.run(SettingsCommand::Motion(motion));
    let mut behind = fitted(0.9, FitSettings::default());
    motion.d = 0.1;
    motion.depth_shift = -3.0;
    behind.run(SettingsCommand::Motion(motion));
    // So slow, it hardly moves while it is watched.
    let azimuth =
        FitSettings { curves: Curves::Azimuth, fit_x0: true, noise_percent: 2.0, ..FitSettings::default() };
    let mut slow = fitted(0.005, azimuth);
    motion.speed = slow.document.settings.motion.speed;
    motion.depth_shift = 5.0;
    motion.height_shift = -1.5;
    slow.run(SettingsCommand::Motion(motion));
    // On the heap: states are large.
    let cases = vec![
        (together, "Both eyes are in one place (d = 0)"),
        (fitted(0.0, FitSettings::default()), "At rest (β = 0)"),
        (behind, "The fit looks in front of the eyes"),
        (
            fitted(0.9, FitSettings { fit_samples: 4, ..FitSettings::default() }),
            "4 samples of both are too few",
        ),
        (slow, "The data cannot tell x0 from z"),
    ];
    for (state, words) in cases {
        // A frame is drawn too: what cannot be drawn panics there.
        let mut window = window_with_fit(state);
        text(&window, "No fit");
        text(&window, words);
        assert!(!labels(&window).iter().any(|label| label.contains("NaN")));
        window.render().expect("a picture");
    }
}

fn intervals_keep_to_what_is_possible() {
    // So few readings with so much noise tell neither a height nor an end to the speed.
    let curves = Curves::Azimuth;
    let noisy = FitSettings { curves, fit_samples: 60, noise_percent: 50.0, ..FitSettings::default() };
    let window = window_with_fit(fitted(0.9, noisy));
    text(&window, "± by linearisation");
    let interval = |symbol: &str| -> Vec<f64> {
        let text = text(&window, &format!("95 % interval of {symbol}: "));
        let (_, ends) = text.rsplit_once(": ").expect("a label names its value");
        ends.split(" … ").map(|end| end.replace('−', "-").parse().expect("a number")).collect()
    };
    assert_eq!(interval("β")[1], 1.0);
    assert_eq!(interval("z")[0], 0.0);
}

fn the_fit_follows_the_controls() {
    // Higher than usual, so that every row is in view.
    let mut window = window_of_size(fitted(0.9, FitSettings::default()), [1280.0, 1000.0], 1.0);
    settle(&mut window);
    type_into(&mut window, "Beta, typed", "0.7");
    settle(&mut window);
    let [beta, uncertainty] = estimate(&window, "β");
    assert!((beta - 0.7).abs() < 4.0 * uncertainty, "β = {beta} +- {uncertainty}");
    window.get_by_label("Fit Δθ").click();
    window.run_steps(2);
    settle(&mut window);
    assert!(window.query_by_label("Fit of Δφ against T").is_none());
    window.get_by_label("Fit of Δθ against T");
    window.get_by_label("Fit x₀").click();
    window.run_steps(2);
    settle(&mut window);
    text(&window, "Fitted x₀");
}

fn a_hidden_fit_is_not_made() {
    let mut window = window(fitted(0.9, FitSettings::default()));
    settle(&mut window);
    let requests = window.state().fitting().requests;
    assert_eq!(requests, 1, "one for one state of the controls");
    window.get_by_label("Disparity").click();
    window.run();
    type_into(&mut window, "Beta, typed", "0.7");
    window.run();
    assert_eq!(window.state().fitting().requests, requests);
    window.get_by_label("Fit").click();
    window.run_steps(2);
    settle(&mut window);
    assert_eq!(window.state().fitting().requests, requests + 1);
    window.get_by_label("Plots").click();
    window.run();
    type_into(&mut window, "Beta, typed", "0.8");
    window.run();
    assert_eq!(window.state().fitting().requests, requests + 1);
}

fn a_window_that_shows_a_fit_rests() {
    let mut window = window_with_fit(fitted(0.9, FitSettings::default()));
    rest(&mut window);
    wait_for_rest(&mut window);
    window.state_mut().run(PlaybackCommand::GoTo(2.0));
    window.run();
    assert_eq!(window.state().fitting().requests, 1, "the fit does not depend on T");
}

/// The share of the corrected picture's bodies that is red: all of the cyclist at rest.
fn red_share(window: &mut Harness<'_, App>, by: &str) -> f64 {
    settle(window);
    let name = text(window, &format!("Corrected by the {by} β "));
    let rect = window.get_by_label(&name).rect().shrink(2.0);
    let picture = window.render().expect("a picture");
    let (mut red, mut bodies) = (0, 0);
    for y in rect.min.y as u32..rect.max.y as u32 {
        for x in rect.min.x as u32..rect.max.x as u32 {
            let [r, g, b, _] = picture.get_pixel(x, y).0.map(i32::from);
            // Light of one wavelength has hardly any grey in it; background and antialiased outlines have.
            if 4 * r.min(g).min(b) > r.max(g).max(b) {
                continue;
            }
            bodies += 1;
            red += i32::from(r > 80 && r > 3 * g && r > 2 * b);
        }
    }
    assert!(bodies > 500, "{bodies} pixels");
    f64::from(red) / f64::from(bodies)
}

fn the_corrected_picture_is_red_if_the_fit_is_right() {
    let mut state = fitted(0.9, FitSettings::default());
    // In a parallel picture it is smaller.
    state.document.settings.look.projection = ProjectionChoice::Gaze;
    state.document.settings.window.corrected = true;
    state.document.settings.window.theme = Theme::Light;
    let mut window = window_with_fit(state);
    let right = red_share(&mut window, "fitted");
    assert!(right > 0.9, "{right}");
    window.get_by_label("published").click();
    window.run_steps(2);
    settle(&mut window);
    let wrong = red_share(&mut window, "fitted");
    assert!(wrong < 0.1, "{wrong}");
    window.get_by_label("Disparity").click();
    window.run_steps(2);
    let set = red_share(&mut window, "set");
    assert!(set > 0.9, "{set}");
}

fn the_corrected_picture_costs_nothing_when_off() {
    let mut window = window_of_size(cyclist(0.9), [1280.0, 1000.0], 1.0);
    assert!(window.state().corrected().is_none());
    let before = window.get_by_label("Left eye view").rect();
    window.get_by_label("corrected").click();
    window.run_steps(2);
    settle(&mut window);
    assert!(window.get_by_label("Left eye view").rect().width() < 0.8 * before.width());
    rest(&mut window);
    wait_for_rest(&mut window);
    window.get_by_label("corrected").click();
    window.run();
    assert!(window.state().corrected().is_none());
    assert_eq!(window.get_by_label("Left eye view").rect(), before);
}

fn extremes_are_fitted_and_corrected_without_harm() {
    for gamma in [1.0, 1e3, 1e30] {
        let mut state = fitted(0.5, FitSettings { fit_samples: 60, ..FitSettings::default() });
        let mut motion = state.document.settings.motion;
        motion.speed = SpeedSetting::new(SpeedParameter::Gamma, gamma).expect("a speed");
        state.run(SettingsCommand::Motion(motion));
        state.document.settings.window.corrected = true;
        let mut window = window_of_size(state, [1024.0, 600.0], 1.0);
        for time in [-1e12, 0.0, 1e12] {
            window.state_mut().run(PlaybackCommand::GoTo(time));
            settle(&mut window);
            settle(&mut window);
            assert!(!labels(&window).iter().any(|label| label.contains("NaN") || label.contains("inf ")));
        }
        window.render().expect("a picture");
    }
    for size in [[64.0, 64.0], [200.0, 100.0], [480.0, 320.0], [3000.0, 90.0], [90.0, 1500.0]] {
        let mut state = fitted(0.9, FitSettings { fit_samples: 20, ..FitSettings::default() });
        state.document.settings.window.corrected = true;
        let mut window = window_of_size(state, size, 1.0);
        window.run_steps(3);
        window.render().expect("a picture");
    }
}
