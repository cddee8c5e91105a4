//! The window as the screen of a stereoscope: pictures as far apart as the lenses, a head that turns, and a
//! screen measured by a card.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Rect, ViewportId, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{SettingsCommand, WindowCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::settings::{ScreenSettings, Settings};

use super::Test;
use super::support::{drag, pane, window_of_size};

pub const TESTS: &[Test] = trials![
    the_pictures_of_a_stereoscope_are_as_far_apart_as_its_lenses,
    a_head_that_turns_sees_something_else_and_leaves_the_document_as_it_is,
    a_tap_on_a_stereoscope_plays_and_a_drag_turns_the_head,
    a_bank_card_measures_the_screen,
    a_stereoscope_in_a_window_of_any_size_breaks_nothing,
];

/// Width and height of a small phone on its side, points, and its width in millimetres.
const PHONE: [f32; 2] = [740.0, 360.0];
const PHONE_MM: f32 = 150.0;

/// A phone whose screen has this width, as far as that is set.
fn phone(width_cm: Option<f64>) -> Harness<'static, App> {
    let settings = Settings {
        screen: ScreenSettings {
            screen_width: gamow::flags::ScreenWidth(width_cm),
            ..ScreenSettings::default()
        },
        ..Settings::default()
    };
    let mut window = window_of_size(State::open(settings).expect("usual settings"), PHONE, 1.0);
    let viewport = window.input_mut().viewports.entry(ViewportId::ROOT).or_default();
    viewport.monitor_size = Some(vec2(PHONE[0], PHONE[1]));
    window.state_mut().run(WindowCommand::ToggleStereoscope);
    window.run_steps(3);
    window
}

fn lens(window: &Harness<'_, App>, eye: usize) -> Rect {
    window.get_by_label(["Left eye through its lens", "Right eye through its lens"][eye]).rect()
}

fn press(window: &mut Harness<'_, App>, button: &str) {
    window.get_by_role_and_label(Role::Button, button).click();
    window.run_steps(3);
}

fn the_pictures_of_a_stereoscope_are_as_far_apart_as_its_lenses() {
    let mut window = phone(Some(0.1 * f64::from(PHONE_MM)));
    for apart_mm in [55.0, 60.0, 75.0] {
        let screen = window.state().state().document.settings.screen;
        window
            .state_mut()
            .run(SettingsCommand::Screen(ScreenSettings { picture_distance: apart_mm, ..screen }));
        window.run_steps(3);
        let [left, right] = [0, 1].map(|eye| lens(&window, eye));
        let points_per_mm = PHONE[0] / PHONE_MM;
        let apart = right.center().x - left.center().x;
        assert!((apart - apart_mm as f32 * points_per_mm).abs() <= 1.0, "{apart_mm}: {apart}");
        assert!(left.max.x <= 0.5 * PHONE[0] + 0.5 && right.min.x >= 0.5 * PHONE[0] - 0.5);
        assert!(left.min.x >= -0.5 && right.max.x <= PHONE[0] + 0.5 && left.height() == PHONE[1]);
    }
    window.key_press(Key::Escape);
    window.run_steps(3);
    assert!(pane(&window, 0).width() > 10.0, "the views are back");
}

/// The bytes of the window, without the menu.
fn picture(window: &mut Harness<'_, App>) -> Vec<u8> {
    window.run_steps(2);
    window.render().expect("a picture").into_raw()
}

fn a_head_that_turns_sees_something_else_and_leaves_the_document_as_it_is() {
    let mut window = phone(Some(15.0));
    let document = window.state().state().document.clone();
    press(&mut window, "Look");
    window.state_mut().turn_device([90.0, 0.0, -90.0, 90.0]);
    let ahead = picture(&mut window);
    let colours: std::collections::HashSet<_> = ahead.chunks_exact(4).collect();
    assert!(colours.len() > 100, "{}", colours.len());
    for angles in [[0.0, 0.0, -90.0, 90.0], [180.0, 0.0, -90.0, 90.0], [90.0, 0.0, -60.0, 90.0]] {
        window.state_mut().turn_device(angles);
        assert_ne!(picture(&mut window), ahead, "{angles:?}");
    }
    // What is no number turns nothing.
    let last = picture(&mut window);
    window.state_mut().turn_device([f64::NAN; 4]);
    assert_eq!(picture(&mut window), last);
    window.state_mut().turn_device([90.0, 0.0, -90.0, 90.0]);
    assert_eq!(picture(&mut window), ahead);
    assert_eq!(window.state().state().document, document);
    assert!(!window.state().state().session.history.can_undo());
}

fn a_tap_on_a_stereoscope_plays_and_a_drag_turns_the_head() {
    let mut window = phone(Some(15.0));
    press(&mut window, "Look");
    let before = picture(&mut window);
    drag(&mut window, pos2(150.0, 100.0), pos2(250.0, 140.0));
    assert_ne!(picture(&mut window), before, "the head is turned");
    assert!(!window.state().state().scratch.playing);
    let place = pos2(200.0, 120.0);
    for is_playing in [true, false] {
        window.hover_at(place);
        window.step();
        window.drag_at(place);
        window.step();
        window.drop_at(place);
        window.run_steps(2);
        assert_eq!(window.state().state().scratch.playing, is_playing);
    }
    press(&mut window, "Menu");
    press(&mut window, "Leave");
    assert!(!window.state().state().session.stage.stereoscope);
}

fn a_bank_card_measures_the_screen() {
    let mut window = phone(None);
    press(&mut window, "Card…");
    // At 96 points to an inch the card is drawn 323.5 points long from x = 12 on; it is longer.
    let edge = 12.0 + 85.60 / 25.4 * 96.0;
    drag(&mut window, pos2(edge, 300.0), pos2(edge + 98.8, 300.0));
    press(&mut window, "It matches");
    let width = window.state().state().document.settings.screen.screen_width.0.expect("it is measured");
    // 85.60 mm are 422.3 points of 740.
    let expected = 8.560 * f64::from(PHONE[0]) / f64::from(edge - 12.0 + 98.8);
    assert!((width - expected).abs() < 0.05, "{width} for {expected}");
    let [left, right] = [0, 1].map(|eye| lens(&window, eye));
    let apart_mm = f64::from(right.center().x - left.center().x) * 10.0 * width / f64::from(PHONE[0]);
    assert!((apart_mm - 60.0).abs() < 0.3, "{apart_mm}");
}

fn a_stereoscope_in_a_window_of_any_size_breaks_nothing() {
    for size in [[360.0, 740.0], [200.0, 100.0], [2400.0, 1300.0]] {
        let mut window = window_of_size(State::open(Settings::default()).expect("usual"), size, 1.0);
        window.state_mut().run(WindowCommand::ToggleStereoscope);
        window.run_steps(3);
        for eye in 0..2 {
            let rect = lens(&window, eye);
            assert!(rect.is_finite() && rect.width() > 0.0, "{size:?}: {rect:?}");
        }
        window.key_press(Key::Escape);
        window.run_steps(3);
        assert!(!window.state().state().session.stage.stereoscope);
    }
}
