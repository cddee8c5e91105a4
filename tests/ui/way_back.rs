//! Undoing, redoing, and having things as usual again.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use gamow::app::commands::{PlaybackCommand, PointsCommand, SettingsCommand, ShowCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::flags::choices::{GazeChoice, Layout, further};
use gamow::settings::{MotionSettings, Settings};

use super::Test;
use super::picking::click;
use super::support::{
    cyclist, drag, in_layout, slider, type_into, wide_window, window, window_of_size, window_without_pictures,
};

pub const TESTS: &[Test] = trials![
    a_drag_is_one_step_and_comes_back_by_keys_and_buttons,
    a_run_of_nudges_is_one_step,
    time_and_playing_are_no_steps,
    a_pick_and_a_removal_can_be_undone,
    undoing_another_scene_brings_it_back_with_its_points,
    a_new_step_forgets_what_was_undone,
    reset_has_all_as_usual_but_the_window,
    a_section_is_reset_by_a_button_that_is_there_only_then,
    a_double_click_on_a_slider_or_its_name_restores_it,
    usual_is_what_the_shown_preset_says,
    shifts_belong_to_their_scene,
];

fn settings<'a>(window: &'a Harness<'_, App>) -> &'a Settings {
    &window.state().state().document.settings
}

fn press(window: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    window.key_press_modifiers(modifiers, key);
    window.run_ok();
}

fn is_enabled(window: &Harness<'_, App>, name: &str) -> bool {
    !window.get_by_role_and_label(Role::Button, name).accesskit_node().is_disabled()
}

const WITH_SHIFT: Modifiers = Modifiers { shift: true, ..Modifiers::COMMAND };

fn a_drag_is_one_step_and_comes_back_by_keys_and_buttons() {
    let mut window = window(cyclist(0.9));
    assert!(!is_enabled(&window, "Undo") && !is_enabled(&window, "Redo"));
    let distance = slider(&window, "Distance y");
    drag(&mut window, distance.left_center() + vec2(20.0, 0.0), distance.center());
    let dragged = settings(&window).motion;
    assert!(dragged.depth_shift > 4.0);
    press(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(*settings(&window), *cyclist(0.9).document.settings);
    assert!(!is_enabled(&window, "Undo"), "one step");
    for (modifiers, key) in [(WITH_SHIFT, Key::Z), (Modifiers::COMMAND, Key::Y)] {
        press(&mut window, modifiers, key);
        assert_eq!(settings(&window).motion, dragged);
        window.get_by_label("Undo").click();
        window.run();
        assert_eq!(settings(&window).motion.depth_shift, 0.0);
    }
    window.get_by_label("Redo").click();
    window.run();
    assert_eq!(settings(&window).motion, dragged);
    // Two drags are two steps.
    drag(&mut window, distance.center(), distance.left_center() + vec2(20.0, 0.0));
    press(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(settings(&window).motion, dragged);
}

fn a_run_of_nudges_is_one_step() {
    let mut window = window(cyclist(0.9));
    for _ in 0..3 {
        press(&mut window, Modifiers::NONE, Key::ArrowUp);
    }
    press(&mut window, Modifiers::NONE, Key::L);
    press(&mut window, Modifiers::NONE, Key::L);
    assert_eq!(settings(&window).picture.layout, further(&Layout::SideBySide, 2));
    for steps in [1, 0] {
        press(&mut window, Modifiers::COMMAND, Key::Z);
        assert_eq!(settings(&window).picture.layout, further(&Layout::SideBySide, steps));
    }
    assert!(settings(&window).speed().beta() > 0.9);
    press(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(*settings(&window), *cyclist(0.9).document.settings);
    assert!(!is_enabled(&window, "Undo"));
}

fn time_and_playing_are_no_steps() {
    let mut window = window(cyclist(0.9));
    for key in [Key::ArrowRight, Key::Home, Key::Space, Key::Space] {
        window.key_press(key);
        window.run_steps(2);
    }
    assert!(!is_enabled(&window, "Undo"));
    let time = window.state().state().document.time;
    type_into(&mut window, "Gamma, typed", "3");
    press(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(window.state().state().document.time, time);
}

fn a_pick_and_a_removal_can_be_undone() {
    let mut window = window(cyclist(0.9));
    let middle = super::support::pane(&window, 0).center();
    click(&mut window, middle, Modifiers::SHIFT);
    let picked = window.state().state().document.points.clone();
    assert_eq!(picked.all().len(), 2, "the frame is in the middle");
    window.state_mut().run(PointsCommand::Remove(1));
    window.run();
    for expected in [2, 1] {
        press(&mut window, Modifiers::COMMAND, Key::Z);
        assert_eq!(window.state().state().document.points.all().len(), expected);
    }
    press(&mut window, WITH_SHIFT, Key::Z);
    assert_eq!(window.state().state().document.points, picked);
}

fn undoing_another_scene_brings_it_back_with_its_points() {
    let mut window = window(cyclist(0.9));
    let middle = super::support::pane(&window, 0).center();
    click(&mut window, middle, Modifiers::NONE);
    window.state_mut().run(PlaybackCommand::GoTo(2.25));
    let before = window.state().state().clone();
    window.state_mut().run(ShowCommand::Scene("globe"));
    window.run();
    let globe = window.state().state().clone();
    assert_ne!(globe.document.scene, before.document.scene);
    press(&mut window, Modifiers::COMMAND, Key::Z);
    let same = |a: &State, b: &State| {
        assert_eq!(a.document.settings, b.document.settings);
        assert_eq!((&a.document.scene, &a.document.points), (&b.document.scene, &b.document.points));
        assert_eq!((a.document.time, a.document.preset), (b.document.time, b.document.preset));
    };
    same(window.state().state(), &before);
    press(&mut window, WITH_SHIFT, Key::Z);
    same(window.state().state(), &globe);
}

fn a_new_step_forgets_what_was_undone() {
    let mut window = window(cyclist(0.9));
    type_into(&mut window, "Gamma, typed", "3");
    press(&mut window, Modifiers::COMMAND, Key::Z);
    assert!(is_enabled(&window, "Redo"));
    type_into(&mut window, "Gamma, typed", "4");
    assert!(!is_enabled(&window, "Redo"));
}

fn reset_has_all_as_usual_but_the_window() {
    let mut window = wide_window(cyclist(0.9));
    assert!(!is_enabled(&window, "Reset"));
    for choice in ["False", "Theme", "Angles"] {
        window.get_by_label(choice).click();
        window.run();
    }
    type_into(&mut window, "Gamma, typed", "3");
    let middle = super::support::pane(&window, 0).center();
    click(&mut window, middle, Modifiers::NONE);
    let before = window.state().state().clone();
    window.get_by_label("Reset").click();
    window.run();
    let default = Settings {
        window: before.document.settings.window,
        ..Settings::clone(&cyclist(0.9).document.settings)
    };
    assert_eq!(*settings(&window), default);
    assert_ne!(default.window, Settings::default().window, "the theme is another");
    assert_eq!(window.state().state().document.points, cyclist(0.9).document.points);
    assert!(!is_enabled(&window, "Reset"));
    press(&mut window, Modifiers::COMMAND, Key::Z);
    let state = window.state().state();
    assert_eq!(
        (&state.document.settings, &state.document.points),
        (&before.document.settings, &before.document.points)
    );
}

fn a_section_is_reset_by_a_button_that_is_there_only_then() {
    let mut window = window_of_size(cyclist(0.9), [1280.0, 1600.0], 1.0);
    for (section, choice) in
        [("Motion", "Set β to 0.5"), ("Look", "Contracted"), ("Two eyes", "Above"), ("Light", "False")]
    {
        let name = format!("Reset {section}");
        assert!(window.query_by_label(&name).is_none(), "{section} is as usual");
        window.get_by_label(choice).click();
        window.run();
        assert_ne!(*settings(&window), *cyclist(0.9).document.settings);
        window.get_by_label(&name).click();
        window.run();
        assert_eq!(*settings(&window), *cyclist(0.9).document.settings, "{section}");
        assert!(window.query_by_label(&name).is_none(), "{section} is as usual again");
    }
}

fn double_click(window: &mut Harness<'_, App>, place: eframe::egui::Pos2) {
    // Far enough from the clicks before not to go on with them.
    window.hover_at(place);
    window.run_steps(16);
    for pressed in [true, false, true, false] {
        window.event(eframe::egui::Event::PointerButton {
            pos: place,
            button: eframe::egui::PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        });
        window.step();
    }
    window.run_ok();
}

fn a_double_click_on_a_slider_or_its_name_restores_it() {
    let mut window = window_without_pictures(cyclist(0.9), [1280.0, 1600.0]);
    for name in ["Separation d", "Distance y", "Height z", "Head tilted", "Head turned"] {
        let rail = slider(&window, name);
        let row_name =
            pos2(window.get_by_role_and_label(Role::Label, name).rect().min.x + 12.0, rail.center().y);
        for place in [rail.center() + vec2(9.0, 0.0), row_name] {
            // To a place that none of these values has.
            drag(&mut window, rail.center(), rail.center() + vec2(40.0, 0.0));
            assert_ne!(*settings(&window), *cyclist(0.9).document.settings, "{name}");
            double_click(&mut window, place);
            assert_eq!(*settings(&window), *cyclist(0.9).document.settings, "{name} at {place:?}");
        }
    }
    let rail = slider(&window, "Speed β");
    for place in [rail.center(), window.get_by_role_and_label(Role::Label, "Speed").rect().center()] {
        window.get_by_label("Set β to 0.5").click();
        window.run();
        double_click(&mut window, place);
        assert_eq!(settings(&window).speed().beta(), 0.9, "{place:?}");
    }
    let rail = slider(&window, "Field of view");
    drag(&mut window, rail.center(), rail.center() + vec2(25.0, 0.0));
    assert!(settings(&window).look.fov.0.is_some());
    double_click(&mut window, rail.center());
    assert_eq!(settings(&window).look.fov.0, None, "automatic again");
}

fn usual_is_what_the_shown_preset_says() {
    let mut window = window(cyclist(0.9));
    let preset = gamow::settings::Preset::named("abreast-0.6").expect("a preset");
    window.state_mut().run(ShowCommand::Preset(preset));
    window.run();
    assert!(!is_enabled(&window, "Reset"));
    window.get_by_label("Set β to 0.99").click();
    window.run();
    window.get_by_label("Reset Motion").click();
    window.run();
    assert_eq!(settings(&window).motion, preset.settings.motion);
    window.get_by_label("Set β to 0.99").click();
    window.state_mut().run(PlaybackCommand::GoTo(-3.0));
    window.run();
    window.get_by_label("Reset").click();
    window.run();
    let state = window.state().state();
    let time = preset.settings.time.expect("it says when");
    assert_eq!((state.document.preset, state.document.time), (Some(preset), time));
    assert_eq!(state.document.settings.motion, preset.settings.motion);
}

/// As the path runs through the eyes nothing is seen of it; that is of no concern to another scene.
fn shifts_belong_to_their_scene() {
    let mut window = window(cyclist(0.9));
    let motion = MotionSettings {
        depth_shift: -3.0,
        height_shift: -2.0,
        d: 0.2,
        roll: 10.0,
        ..cyclist(0.5).document.settings.motion
    };
    window.state_mut().run(SettingsCommand::Motion(motion));
    window.state_mut().run(in_layout(Layout::Anaglyph));
    window.get_by_label("Fixed").click();
    window.run();
    // Quit, start again: as it was left.
    let left = window.state().state().shown();
    let again = State::open(left.clone()).expect("a preset");
    assert_eq!(again.document.settings.motion, motion);
    // Another scene passes where it says, and the eyes look at it.
    let mut window = super::support::window(again);
    window.state_mut().run(ShowCommand::Scene("street"));
    window.run();
    let Settings { motion, look, picture, .. } = settings(&window);
    assert_eq!((motion.depth_shift, motion.height_shift, look.gaze), (0.0, 0.0, GazeChoice::Whole));
    assert_eq!((motion.d, motion.roll, motion.speed.speed().beta()), (0.2, 10.0, 0.5));
    assert_eq!(picture.layout, Layout::Anaglyph);
    assert!(window.state().state().framing().is_some(), "something is in the views");
}
