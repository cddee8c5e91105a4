//! The timeline, the plots as a way through time, and the keys.

use std::time::Duration;

use eframe::egui::{Key, Modifiers, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::shell::App;
use relativity_render::Geometry;

use super::Test;
use super::support::{FRAME, cyclist, drag, repaint_delay, rest, seen, shown, slider, type_into, window};

pub const TESTS: &[Test] = trials![
    scrubbing_moves_the_time_and_the_readout,
    at_t0_the_elevations_agree_and_d_is_near_one_over_gamma,
    clicking_in_a_plot_goes_to_that_time,
    keys_do_what_the_help_says,
    keys_are_left_to_a_field_that_is_typed_in,
    a_paused_window_asks_for_no_frames,
    playing_runs_by_the_clock_and_loops,
    a_scene_at_rest_has_no_t0,
];

fn time(window: &Harness<'_, App>) -> f64 {
    window.state().state().document.time
}

fn scrubbing_moves_the_time_and_the_readout() {
    let mut window = window(cyclist(0.9));
    let scrubber = slider(&window, "Observation time T");
    drag(&mut window, scrubber.left_center() + [30.0, 0.0].into(), scrubber.center());
    let [from, to] = window.state().state().time_range();
    assert!((time(&window) - 0.5 * (from + to)).abs() < 0.01 * (to - from));
    let shown = shown(&window, "Right eye, happened t");
    assert!((shown - seen(0.9, time(&window), 1).retarded_time).abs() < 6e-5);
    type_into(&mut window, "T, typed", "2.25");
    assert_eq!(time(&window), 2.25);
}

fn at_t0_the_elevations_agree_and_d_is_near_one_over_gamma() {
    let mut window = window(cyclist(0.9));
    window.get_by_label("Go to seen abreast").click();
    window.run();
    // sqrt(0.05^2 + 3^2 + 2^2), and halfway between the eyes X = 0, where D = 1/gamma.
    assert!((time(&window) - 13.0025f64.sqrt()).abs() < 1e-12);
    assert!(shown(&window, "Disparity Δθ").abs() < 1e-9);
    let gamma = 1.0 / (1.0f64 - 0.81).sqrt();
    let mean = 0.5 * (shown(&window, "Left eye, Doppler") + shown(&window, "Right eye, Doppler"));
    assert!((mean - 1.0 / gamma).abs() < 1e-3, "{mean}");
}

fn clicking_in_a_plot_goes_to_that_time() {
    let mut window = window(cyclist(0.9));
    let plot = window.get_by_label("Plot of Δθ of front tyre against T").rect();
    let before = time(&window);
    let place = pos2(plot.min.x + 0.75 * plot.width(), plot.center().y);
    drag(&mut window, place, place + [20.0, 0.0].into());
    let [from, to] = window.state().state().time_range();
    let expected = from + (to - from) * 0.8;
    assert!(time(&window) != before && (time(&window) - expected).abs() < 0.1 * (to - from));
}

fn keys_do_what_the_help_says() {
    let mut window = window(cyclist(0.9));
    let press = |window: &mut Harness<'_, App>, key| {
        window.key_press(key);
        window.run_steps(2);
    };
    press(&mut window, Key::Space);
    assert!(window.state().state().scratch.playing);
    press(&mut window, Key::Space);
    assert!(!window.state().state().scratch.playing);

    let [from, to] = window.state().state().time_range();
    press(&mut window, Key::Home);
    assert_eq!(time(&window), from);
    press(&mut window, Key::ArrowRight);
    let step = time(&window) - from;
    assert!(step > 0.0 && step < (to - from) / 50.0);
    window.key_press_modifiers(Modifiers::SHIFT, Key::ArrowRight);
    window.run();
    assert!(time(&window) - from > 8.0 * step);
    press(&mut window, Key::End);
    assert_eq!(time(&window), to);

    press(&mut window, Key::ArrowUp);
    assert!(window.state().state().speed().beta() > 0.9);
    press(&mut window, Key::ArrowDown);
    press(&mut window, Key::ArrowDown);
    assert!(window.state().state().speed().beta() < 0.9);

    for (key, geometry) in [
        (Key::Num2, Geometry::Contracted),
        (Key::Num3, Geometry::Rest),
        (Key::Num4, Geometry::OneCone),
        (Key::Num1, Geometry::Seen),
    ] {
        press(&mut window, key);
        assert_eq!(window.state().state().document.settings.look.geometry, geometry);
    }

    assert!(window.query_by_label("What is this?").is_none());
    press(&mut window, Key::F1);
    window.get_by_label("What is this?");
    window.get_by_label("Keys").click();
    window.run();
    window.get_by_label("play or pause");
    press(&mut window, Key::Escape);
    assert!(window.query_by_label("What is this?").is_none());
    press(&mut window, Key::Questionmark);
    window.get_by_label("What is this?");
}

fn keys_are_left_to_a_field_that_is_typed_in() {
    let mut window = window(cyclist(0.9));
    window.get_by_label("Beta, typed").click();
    window.run();
    for key in [Key::Space, Key::Num3, Key::ArrowUp, Key::Home] {
        window.key_press(key);
    }
    window.run();
    let state = window.state().state();
    assert!(!state.scratch.playing);
    assert_eq!(state.document.settings.look.geometry, Geometry::Seen);
    assert_eq!(state.speed().beta(), 0.9);
}

fn a_paused_window_asks_for_no_frames() {
    let mut window = window(cyclist(0.9));
    rest(&mut window);
    assert_eq!(repaint_delay(&window), Duration::MAX);
    window.get_by_label("Play").click();
    window.run_steps(3);
    assert_eq!(repaint_delay(&window), Duration::ZERO);
    window.get_by_label("Pause").click();
    window.remove_cursor();
    window.run();
    window.step();
    assert_eq!(repaint_delay(&window), Duration::MAX);
}

fn playing_runs_by_the_clock_and_loops() {
    const RATE: f64 = 8.0;
    let mut state = cyclist(0.9);
    state.scratch.playing = true;
    state.document.settings.playback.rate = RATE;
    let mut window = window(state);
    let before = time(&window);
    window.run_steps(4);
    let expected = 4.0 * RATE * f64::from(FRAME);
    assert!((time(&window) - before - expected).abs() < 1e-6, "{} to {}", before, time(&window));
    let [from, to] = window.state().state().time_range();
    let frames_per_loop = (to - from) / (RATE * f64::from(FRAME));
    window.run_steps(frames_per_loop as usize);
    assert!((from..=to).contains(&time(&window)) && window.state().state().scratch.playing);
    window.get_by_label("Loop").click();
    window.run_steps((1.1 * frames_per_loop) as usize);
    assert_eq!(time(&window), to);
    assert!(!window.state().state().scratch.playing);
}

fn a_scene_at_rest_has_no_t0() {
    let mut window = window(cyclist(0.0));
    window.run();
    assert!(window.query_by_label_contains("Go to").is_none());
    assert!((shown(&window, "Left eye, Doppler") - 1.0).abs() < 1e-12);
}
