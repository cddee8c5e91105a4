//! The window on a screen of a phone: all parts have room, and a newcomer makes a prediction.

use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Pos2, Rect, TouchDeviceId, TouchId, TouchPhase, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::WindowCommand;
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::overlay::Overlay;
use gamow::app::state::riding::saddle::RideCommand;
use gamow::flags::choices::Layout;
use gamow::lesson::{Library, Outcome};
use gamow::settings::Settings;

use super::Test;
use super::support::{assert_sane, drag, in_layout, pane, slider, window_of_size};

pub const TESTS: &[Test] = trials![
    a_newcomer_makes_the_first_prediction_on_a_phone,
    a_phone_has_a_bar_without_overlaps_and_a_speed_slider,
    two_thumbs_ride,
    each_of_two_pictures_has_pedals,
];

/// Width and height of a small phone's screen, points.
const PHONE: [f32; 2] = [360.0, 740.0];

fn phone(state: State) -> Harness<'static, App> {
    window_of_size(state, PHONE, 1.0)
}

fn a_newcomer_makes_the_first_prediction_on_a_phone() {
    let mut window = phone(State::open(Settings::default()).expect("usual settings"));
    window.state_mut().run(WindowCommand::Toggle(Overlay::Start));
    window.run_steps(2);
    let first = Library::own().all().iter().find(|lesson| !lesson.is_a_preset()).cloned();
    let first = first.expect("there are lessons");
    let begin = format!("First lesson, {} min", first.minutes);
    assert!(inside(&window, &begin), "it is out of sight");
    window.get_by_role_and_label(Role::Button, &begin).click();
    window.run_steps(4);
    let course = |window: &Harness<'_, App>| window.state().state().course().cloned().expect("it has begun");
    assert_eq!(course(&window).lesson().name, first.name);
    let choices = || window.query_all_by_role(Role::RadioButton).collect::<Vec<_>>();
    assert!(choices().len() >= 2);
    for name in ["Predict", "Skip", "Fold the lesson", "Close the lesson", "Play"] {
        assert!(inside(&window, name), "{name} is out of sight");
    }
    choices()[0].click();
    window.run_steps(2);
    window.get_by_role_and_label(Role::Button, "Predict").click();
    window.run_steps(2);
    assert!(matches!(course(&window).records()[0].outcome, Some(Outcome::Made { .. })));
}

/// Whether the button called `name` is all on the screen.
fn inside(window: &Harness<'_, App>, name: &str) -> bool {
    let screen = Rect::from_min_max(pos2(0.0, 0.0), PHONE.into());
    screen.contains_rect(window.get_by_role_and_label(Role::Button, name).rect())
}

fn a_phone_has_a_bar_without_overlaps_and_a_speed_slider() {
    let mut window = phone(State::open(Settings::default()).expect("usual settings"));
    let bar = Rect::from_min_max(pos2(0.0, 0.0), pos2(PHONE[0], 38.0));
    let in_bar = |window: &Harness<'_, App>| -> Vec<Rect> {
        let roles = [Role::Button, Role::ComboBox];
        let all = roles.into_iter().flat_map(|role| window.query_all_by_role(role));
        all.map(|node| node.rect()).filter(|rect| bar.contains(rect.center())).collect()
    };
    let rects = in_bar(&window);
    assert!(rects.len() >= 4, "{rects:?}");
    for (i, rect) in rects.iter().enumerate() {
        assert!(bar.contains_rect(*rect), "{rect:?}");
        for other in &rects[i + 1..] {
            let overlap = rect.intersect(*other);
            assert!(overlap.width() <= 0.0 || overlap.height() <= 0.0, "{rect:?} {other:?}");
        }
    }
    window.get_by_role_and_label(Role::Button, "More").click();
    window.run_steps(2);
    for name in ["Undo", "Redo", "Reset", "Help"] {
        assert!(inside(&window, name), "{name}");
    }
    window.get_by_role_and_label(Role::Button, "More").click();
    window.run_steps(2);
    let speed =
        |window: &Harness<'_, App>| window.state().state().document.settings.motion.speed.speed().beta();
    let (before, rail) = (speed(&window), slider(&window, "Speed β"));
    assert!(rail.width() >= 300.0 && rail.min.y >= pane(&window, 1).max.y, "{rail:?}");
    drag(&mut window, rail.left_center() + vec2(20.0, 0.0), rail.right_center() - vec2(20.0, 0.0));
    assert!(speed(&window) > before.max(0.99));
}

fn touch(window: &Harness<'_, App>, finger: u64, phase: TouchPhase, pos: Pos2) {
    window.event(Event::Touch { device_id: TouchDeviceId(0), id: TouchId(finger), phase, pos, force: None });
}

/// Pedals that a thumb holds speed the rider up while another thumb looks around, and brakes slow the rider
/// down. A screen that knows no touches shows neither.
fn two_thumbs_ride() {
    let mut window = phone(State::open(Settings::default()).expect("usual settings"));
    window.state_mut().run(RideCommand::Toggle);
    window.run_steps(2);
    assert!(window.query_by_label("Pedal: hold").is_none());
    // The page tells the toolkit so of a touch screen.
    touch(&window, u64::MAX, TouchPhase::Cancel, Pos2::ZERO);
    window.run_steps(2);
    let place = |window: &Harness<'_, App>, name: &str| {
        let place = window.get_by_role_and_label(Role::Button, name).rect();
        assert!(place.width() >= 44.0 && place.height() >= 44.0, "{name} is small: {place}");
        place.center()
    };
    let [pedal, brake] = ["Pedal: hold", "Brake: hold"].map(|name| place(&window, name));
    let rapidity = |window: &Harness<'_, App>| window.state().state().rider().velocity.rapidity();
    let gaze = |window: &Harness<'_, App>| window.state().state().gaze().azimuth;

    touch(&window, 1, TouchPhase::Start, pedal);
    window.run_steps(20);
    let pushed = rapidity(&window);
    assert!(pushed > 0.05, "{pushed}");
    let (before, field) = (gaze(&window), window.state().state().document.settings.look.fov);
    let from = pane(&window, 0).center();
    touch(&window, 2, TouchPhase::Start, from);
    window.step();
    touch(&window, 2, TouchPhase::Move, from + vec2(40.0, 0.0));
    window.step();
    touch(&window, 2, TouchPhase::End, from + vec2(40.0, 0.0));
    window.run_steps(2);
    // What is under the thumb follows it: the gaze turns to the left.
    assert!(gaze(&window) > before + 0.05, "{} after {before}", gaze(&window));
    assert_eq!(window.state().state().document.settings.look.fov, field, "two thumbs do not pinch");
    assert!(rapidity(&window) > pushed, "the first goes on");
    touch(&window, 1, TouchPhase::End, pedal);
    window.run_steps(2);

    touch(&window, 3, TouchPhase::Start, brake);
    window.run_steps(60);
    assert!(rapidity(&window).abs() < 1e-12, "who brakes long enough stands");
    touch(&window, 3, TouchPhase::End, brake);
    window.run_steps(2);
    assert_sane(window.state().state());
}

fn each_of_two_pictures_has_pedals() {
    let mut window =
        window_of_size(State::open(Settings::default()).expect("usual settings"), [900.0, 600.0], 1.0);
    window.state_mut().run(RideCommand::Toggle);
    window.state_mut().run(in_layout(Layout::SideBySide));
    touch(&window, u64::MAX, TouchPhase::Cancel, Pos2::ZERO);
    window.run_steps(2);
    let rapidity = |window: &Harness<'_, App>| window.state().state().rider().velocity.rapidity();
    let pedals: Vec<_> = window.query_all_by_label("Pedal: hold").map(|node| node.rect().center()).collect();
    assert_eq!(pedals.len(), 2);
    for pedal in pedals {
        let before = rapidity(&window);
        touch(&window, 4, TouchPhase::Start, pedal);
        window.run_steps(8);
        touch(&window, 4, TouchPhase::End, pedal);
        window.run_steps(2);
        assert!(rapidity(&window) > before + 0.01, "{pedal}");
    }
}
