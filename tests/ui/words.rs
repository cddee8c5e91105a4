//! What stands below the views and in them: the wavelengths that arrive, the moment in a sentence, and why it
//! is dark.

use clap::ValueEnum as _;
use eframe::egui::{Rect, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{PlaybackCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::settings::Theme;
use relativity_render::Geometry;

use super::Test;
use super::support::{
    cyclist, drag, label_starting_with, labels, seen, slider, window, window_of_size, window_without_pictures,
};

pub const TESTS: &[Test] = trials![
    the_sentence_has_the_numbers_of_the_core,
    ticks_lie_where_the_wavelengths_do,
    words_follow_a_drag_in_the_same_frame,
    words_are_numbers_at_the_ends_of_every_range,
    words_are_in_the_window_from_800x600_on,
    words_that_are_switched_off_are_gone,
];

/// Wavelength at rest of the cyclist, nm.
const REST_NM: f64 = 700.0;
/// How all sentences begin that tell what arrives.
const ARRIVING: &str = "The light reaching you now";

fn the_sentence_has_the_numbers_of_the_core() {
    let mut window = window(cyclist(0.9));
    for time in [0.3, 1.1, 3.0, 9.0] {
        window.state_mut().run(PlaybackCommand::GoTo(time));
        window.run();
        let sentence = label_starting_with(&window, ARRIVING);
        let [left, right] = [0, 1].map(|eye| seen(0.9, time, eye));
        let time = |t: f64| format!("{t:.2}").replace('-', "−");
        let times = format!(
            "at t = {} for the left eye, {} for the right, ",
            time(left.retarded_time),
            time(right.retarded_time)
        );
        let [left_nm, right_nm] = [left, right].map(|seen| REST_NM / seen.doppler_factor);
        assert!(sentence.contains(&times), "{times} in {sentence}");
        assert!(sentence.contains(&format!("{left_nm:.0} and {right_nm:.0} nm, ")), "{sentence}");
    }
}

/// The tick called so.
fn tick(window: &Harness<'_, App>, name: &str) -> Rect {
    let label = label_starting_with(window, &format!("Wavelength, {name}"));
    window.get_by_label(&label).rect()
}

/// The middle of the tick of `wavelength_nm` on a logarithmic scale from 100 nm to 3 um, pinned to its ends.
fn place(window: &Harness<'_, App>, wavelength_nm: f64) -> f64 {
    let name = label_starting_with(window, "Wavelengths that arrive");
    let scale = window.get_by_label(&name).rect();
    let fraction = ((wavelength_nm / 100.0).ln() / 30.0_f64.ln()).clamp(0.0, 1.0);
    f64::from(scale.min.x) + fraction * f64::from(scale.width())
}

fn ticks_lie_where_the_wavelengths_do() {
    let mut window = window(cyclist(0.9));
    // At the last the light is redshifted off the scale: by 4.4 to 3,051 nm.
    for time in [0.0, 1.1, 2.5, 4.0, 1e6] {
        window.state_mut().run(PlaybackCommand::GoTo(time));
        window.run();
        assert!((f64::from(tick(&window, "at rest").center().x) - place(&window, REST_NM)).abs() < 0.1);
        for (eye, name) in ["Left eye", "Right eye"].into_iter().enumerate() {
            let wavelength = REST_NM / seen(0.9, time, eye).doppler_factor;
            let (shown, right) = (f64::from(tick(&window, name).center().x), place(&window, wavelength));
            assert!((shown - right).abs() < 0.1, "T = {time}, {name}: {shown} for {right}");
        }
    }
}

fn words_follow_a_drag_in_the_same_frame() {
    let mut window = window(cyclist(0.9));
    let before = label_starting_with(&window, ARRIVING);
    let handle = slider(&window, "Observation time T");
    let [from, to] = [0.3, 0.6].map(|part| pos2(handle.min.x + part * handle.width(), handle.center().y));
    window.hover_at(from);
    window.step();
    window.drag_at(from);
    window.step();
    window.hover_at(to);
    window.step();
    // No further frame has been drawn since T changed.
    let time = window.state().state().document.time;
    let wavelength = REST_NM / seen(0.9, time, 0).doppler_factor;
    let sentence = label_starting_with(&window, ARRIVING);
    assert!(sentence != before && sentence.contains(&format!(": {wavelength:.0} ")), "{sentence}");
    let right = place(&window, wavelength);
    assert!((f64::from(tick(&window, "Left eye").center().x) - right).abs() < 0.1);
    window.drop_at(to);
    drag(&mut window, to, from);
}

fn words_are_numbers_at_the_ends_of_every_range() {
    let speeds =
        [(SpeedParameter::Beta, 0.0), (SpeedParameter::Beta, 1.0 - 1e-9), (SpeedParameter::Gamma, 1e12)];
    for (parameter, value) in speeds {
        for d in [0.0, 0.1] {
            let mut state = cyclist(0.5);
            state.document.settings.motion.speed = SpeedSetting::new(parameter, value).expect("a speed");
            state.document.settings.motion.d = d;
            let mut window = window_without_pictures(state, [800.0, 600.0]);
            for &geometry in Geometry::value_variants() {
                for time in [-1e12, 0.0, 3.0, 1e12] {
                    window.state_mut().run(SettingsCommand::Geometry(geometry));
                    window.state_mut().run(PlaybackCommand::GoTo(time));
                    window.run();
                    for label in labels(&window) {
                        let plain = label.replace("infrared", "");
                        assert!(
                            !plain.contains("NaN") && !plain.contains("inf"),
                            "{value}, {d}, {time}: {label}"
                        );
                    }
                }
            }
        }
    }
}

fn words_are_in_the_window_from_800x600_on() {
    for size in [[800.0, 600.0], [1024.0, 600.0], [1200.0, 760.0], [1920.0, 1080.0]] {
        for theme in [Theme::Light, Theme::Dark] {
            let mut state = cyclist(0.9);
            state.document.settings.window.theme = theme;
            let mut window = window_of_size(state, size, 1.0);
            window.run();
            let area = Rect::from_min_size(pos2(0.0, 0.0), size.into());
            let scale = "Wavelengths that arrive";
            if size[1] <= 600.0 {
                // Low windows leave the scale's height to the plots.
                assert!(!labels(&window).iter().any(|label| label.starts_with(scale)), "{size:?}");
            }
            for name in [Some(ARRIVING), Some(scale).filter(|_| size[1] > 600.0)].into_iter().flatten() {
                let label = label_starting_with(&window, name);
                let rect = window.get_by_label(&label).rect();
                assert!(area.contains_rect(rect) && rect.width() > 400.0, "{name} at {rect:?} in {size:?}");
            }
        }
    }
}

fn words_that_are_switched_off_are_gone() {
    let mut state = cyclist(0.9);
    state.run(SettingsCommand::Value { name: "map", value: "on".to_owned() });
    let mut window = window_of_size(state, [1280.0, 900.0], 1.0);
    let before = window.get_by_label("Left eye view").rect();
    let has =
        |window: &Harness<'_, App>, name: &str| labels(window).iter().any(|label| label.starts_with(name));
    for (name, words) in [("spectrum", "Wavelengths that arrive"), ("sentence", ARRIVING)] {
        assert!(has(&window, words));
        window.get_by_label(name).click();
        window.run();
        assert!(!has(&window, words));
    }
    assert!(window.get_by_label("Left eye view").rect().height() > before.height() + 20.0);
}
