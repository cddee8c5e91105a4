//! The slide in the views: the rapidity ruler, the panorama, and what a resting outline needs to be in the
//! picture.

use eframe::egui::Key;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::SettingsCommand;
use gamow::settings::MotionSettings;

use super::Test;
use super::support::{cyclist, labels, pane, window};

pub const TESTS: &[Test] = trials![
    the_ruler_is_there_while_motion_is_a_slide,
    the_panorama_has_one_strip_above_the_other_and_can_be_left,
    the_resting_outline_is_framed_with_what_moves,
];

const RULER: &str = "Rapidity ruler, Left eye";

fn the_ruler_is_there_while_motion_is_a_slide() {
    let mut window = window(cyclist(0.9));
    let is_there = |labels: &[String]| labels.iter().any(|label| label.starts_with(RULER));
    let ruler = labels(&window).into_iter().find(|label| label.starts_with(RULER)).expect("it is there");
    assert!(ruler.contains("0.9 c"), "the own speed is marked: {ruler}");
    // A camera's picture has none, nor has that of a tilted head.
    window.key_press(Key::V);
    window.run();
    assert!(!is_there(&labels(&window)));
    window.key_press(Key::V);
    let motion = window.state().state().document.settings.motion;
    window.state_mut().run(SettingsCommand::Motion(MotionSettings { roll: 10.0, ..motion }));
    window.run();
    assert!(!is_there(&labels(&window)));
}

fn the_panorama_has_one_strip_above_the_other_and_can_be_left() {
    let mut window = window(cyclist(0.9));
    let before = window.state().state().document.settings.clone();
    window.get_by_label("Panorama").click();
    window.run();
    assert!(window.state().state().document.settings.is_panorama());
    let [left, right] = [0, 1].map(|number| pane(&window, number));
    assert!(left.max.y <= right.min.y && left.width() > 4.0 * left.height(), "{left:?} above {right:?}");
    window.key_press(Key::U);
    window.run();
    assert_eq!(window.state().state().document.settings, before);
}

/// The picture reaches further aside by about the rapidity.
fn the_resting_outline_is_framed_with_what_moves() {
    let mut window = window(cyclist(0.9));
    let half_width = |fov: f64| (0.5 * fov.to_radians()).tan().asinh();
    let shown = |window: &egui_kittest::Harness<'_, gamow::app::shell::App>| {
        window.state().state().look().set_fov().expect("a number")
    };
    let before = half_width(shown(&window));
    window.key_press(Key::O);
    window.run();
    assert!(window.state().state().document.settings.window.resting);
    let wider = half_width(shown(&window)) - before;
    // 1.47 on both sides together, with a margin; the picture had more room than what moves needs.
    assert!(wider > 0.5 && wider < 0.5 * 1.4722 / 0.8 + 0.01, "{wider}");
}
