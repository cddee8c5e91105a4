//! The Fit tab: measures the selected point, fits it beside the window, and says what came of it.

use std::thread;
use std::time::{Duration, Instant};

use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::App;
use gamow::app::command::Command;
use gamow::app::settings::PlotTab;

use super::Test;
use super::support::{cyclist, label_starting_with, labels, shown, window};

pub const TESTS: &[Test] = &[
    ("an_exact_fit_finds_the_truth", an_exact_fit_finds_the_truth),
    ("the_published_model_is_biased", the_published_model_is_biased),
    ("a_fit_follows_the_speed", a_fit_follows_the_speed),
    ("a_scene_at_rest_has_nothing_to_fit", a_scene_at_rest_has_nothing_to_fit),
];

/// Longest time that a fit and its bootstrap may take here.
const PATIENCE: Duration = Duration::from_secs(30);

fn fit_window(beta: f64) -> Harness<'static, App> {
    let mut state = cyclist(beta);
    state.settings.plots.tab = PlotTab::Fit;
    state.settings.fitting.noise = 0.0;
    window(state)
}

/// Runs frames until a label starts with `start`, which means what was asked for last is there.
fn wait_for(window: &mut Harness<'_, App>, start: &str) {
    let begin = Instant::now();
    while !labels(window).iter().any(|label| label.starts_with(start)) {
        assert!(begin.elapsed() < PATIENCE, "no {start:?} among {:?}", labels(window));
        thread::sleep(Duration::from_millis(20));
        window.step();
    }
}

fn an_exact_fit_finds_the_truth() {
    let mut window = fit_window(0.9);
    wait_for(&mut window, "rms");
    for (parameter, truth) in [("Fitted β", 0.9), ("Fitted y", 3.0), ("Fitted z", 2.0)] {
        assert!(
            (shown(&window, parameter) - truth).abs() < 1e-5,
            "{}",
            label_starting_with(&window, parameter)
        );
    }
    label_starting_with(&window, "Plot of measured and fitted Δφ");
}

fn the_published_model_is_biased() {
    let mut window = fit_window(0.9);
    wait_for(&mut window, "rms");
    window.get_by_label("Δφ only").click();
    window.get_by_label("As published").click();
    window.run_ok();
    let begin = Instant::now();
    // Either no such object fits, or one that is clearly another.
    loop {
        let told = labels(&window).iter().any(|label| label.starts_with("no such object"));
        let biased = labels(&window).iter().any(|label| label.starts_with("Fitted y"))
            && (shown(&window, "Fitted y") - 3.0).abs() > 0.1;
        if told || biased {
            return;
        }
        assert!(begin.elapsed() < PATIENCE, "{:?}", labels(&window));
        thread::sleep(Duration::from_millis(20));
        window.step();
    }
}

fn a_fit_follows_the_speed() {
    let mut window = fit_window(0.9);
    wait_for(&mut window, "Fitted β: 0.90000");
    let mut motion = window.state().state().settings.motion;
    motion.speed = cyclist(0.6).settings.motion.speed;
    window.state_mut().ask(Command::Motion(motion));
    window.step();
    wait_for(&mut window, "Fitted β: 0.60000");
}

fn a_scene_at_rest_has_nothing_to_fit() {
    let mut window = fit_window(0.0);
    wait_for(&mut window, "The disparities of a scene at rest do not change");
}
