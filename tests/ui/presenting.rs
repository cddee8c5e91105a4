//! The whole screen, an audience, borders that are dragged, parts alone in the window, and the meter of
//! comfort.

use eframe::egui::{Event, Key, Modifiers, Rect, Vec2, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{PlaybackCommand, SettingsCommand, WindowCommand};
use gamow::app::shell::App;
use gamow::flags::choices::Layout;
use gamow::settings::{MotionSettings, Preset, ScreenSettings, WindowSettings};

use super::Test;
use super::layouts::assert_no_broken_numbers;
use super::support::{
    cyclist, drag, in_layout, label_starting_with, pane, wide_window, window, window_of_size,
};

pub const TESTS: &[Test] = trials![
    an_audience_has_views_a_plot_and_words_and_all_comes_back,
    a_clicker_steps_the_presets_in_front_of_an_audience,
    presenting_works_at_every_size_and_preset,
    borders_are_dragged_and_a_double_click_has_them_as_usual,
    a_double_click_on_a_title_has_a_part_alone,
    the_comfortable_button_narrows_d_and_says_so,
    a_layout_to_be_fused_offers_to_narrow_d_where_it_is_hard_to,
    the_projectors_window_shows_the_views_and_goes_again,
    a_projector_has_the_lessons_words_and_the_lecturer_keeps_notes,
    the_meter_knows_the_distance_and_costs_nothing_unseen,
];

fn settings_window(harness: &Harness<'_, App>) -> WindowSettings {
    harness.state().state().document.settings.window
}

fn an_audience_has_views_a_plot_and_words_and_all_comes_back() {
    let mut window = window(cyclist(0.9));
    let before = settings_window(&window);
    window.key_press(Key::P);
    window.run();
    for name in ["Left eye view", "Right eye view", "β = 0.900", "Plot of Δφ of front tyre against T"] {
        window.get_by_label(name);
    }
    label_starting_with(&window, "The light reaching you now");
    assert!(["Controls", "Speed β", "Play", "Help"].iter().all(|name| window.query_by_label(name).is_none()));
    assert!(window.state().state().session.stage.full_screen);
    window.key_press(Key::Space);
    window.step();
    assert!(window.state().state().scratch.playing);
    window.state_mut().run(PlaybackCommand::Toggle);
    window.key_press(Key::Escape);
    window.run();
    assert!(!window.state().state().session.stage.full_screen);
    assert_eq!(settings_window(&window), before);
    window.get_by_label("Controls");
}

fn a_clicker_steps_the_presets_in_front_of_an_audience() {
    let mut window = window(cyclist(0.9));
    window.key_press(Key::P);
    window.run();
    for preset in &Preset::all()[..3] {
        window.key_press(Key::PageDown);
        window.run();
        assert_eq!(window.state().state().document.preset, Some(preset));
        label_starting_with(&window, &format!("{}. ", preset.title));
        assert!(window.state().state().session.stage.is_presented());
    }
    window.key_press(Key::PageUp);
    window.run();
    assert_eq!(window.state().state().document.preset, Some(&Preset::all()[1]));
}

/// Checks the places of everything, in points, in every preset with few pixels; at the end the window is
/// drawn with all pixels.
fn presenting_works_at_every_size_and_preset() {
    for (size, few, scale) in [
        ([64.0, 64.0], 1.0, 1.0),
        ([800.0, 600.0], 1.0, 1.0),
        ([3840.0, 2160.0], 0.25, 1.0),
        ([1920.0, 1080.0], 0.5, 2.0),
    ] {
        let mut window = window_of_size(cyclist(0.9), size, few);
        window.state_mut().run(WindowCommand::TogglePresenting);
        for _ in Preset::all() {
            window.key_press(Key::PageDown);
            window.run();
            assert_no_broken_numbers(&window);
            if size[0] < 800.0 {
                continue;
            }
            let area = Rect::from_min_size(pos2(0.0, 0.0), Vec2::from(size)).expand(0.5);
            // A ride has one large picture.
            let is_one = window.state().state().document.settings.picture.layout == Layout::Left;
            let names: &[&str] =
                if is_one { &["Left eye view"] } else { &["Left eye view", "Right eye view"] };
            for name in names {
                let rect = window.get_by_label(name).rect();
                assert!(
                    area.contains_rect(rect) && rect.width() > 0.45 * size[0],
                    "{name} at {rect:?} in {size:?}"
                );
            }
        }
        window.set_pixels_per_point(scale);
        window.run();
        window.render().expect("a picture");
    }
}

fn borders_are_dragged_and_a_double_click_has_them_as_usual() {
    let mut window = wide_window(cyclist(0.9));
    let before = (pane(&window, 0), settings_window(&window));
    let middle = |window: &Harness<'_, App>, name: &str| window.get_by_label(name).rect().center();
    // The map goes where the controls leave it too little room: they come last.
    for (name, by) in [
        ("Border of the map", vec2(50.0, 0.0)),
        ("Border of the views", vec2(0.0, 60.0)),
        ("Border of the controls", vec2(-40.0, 0.0)),
    ] {
        let from = middle(&window, name);
        drag(&mut window, from, from + by);
        let moved = middle(&window, name) - from;
        let off = (moved - by).dot(by.normalized());
        assert!(off.abs() < 3.0, "{name} moved by {moved:?}, not {by:?}");
    }
    let after = pane(&window, 0);
    assert!(after.width() < before.0.width() - 15.0 && after.height() > before.0.height() + 40.0);
    let shares = settings_window(&window);
    assert!([shares.side_share, shares.strip_share, shares.map_share].iter().all(|share| share.0.is_some()));
    for name in ["Border of the controls", "Border of the views", "Border of the map"] {
        let place = middle(&window, name);
        double_click(&mut window, place);
    }
    assert_eq!((pane(&window, 0), settings_window(&window)), before);
}

fn double_click(window: &mut Harness<'_, App>, place: eframe::egui::Pos2) {
    window.hover_at(place);
    window.step();
    for pressed in [true, false, true, false] {
        let (button, modifiers) = (eframe::egui::PointerButton::Primary, Modifiers::NONE);
        window.event(Event::PointerButton { pos: place, button, pressed, modifiers });
        window.step();
    }
    window.run_ok();
}

fn a_double_click_on_a_title_has_a_part_alone() {
    let mut window = wide_window(cyclist(0.9));
    let parts = [
        ("Title of view 1", "Left eye view"),
        ("Title of view 2", "Right eye view"),
        ("Title of the map", "Map, from above"),
        ("Title of the plots", "Plot of Δφ of front tyre against T"),
    ];
    for (title, part) in parts {
        let before = window.get_by_label(part).rect();
        for leave_by_key in [false, true] {
            let place = window.get_by_label(title).rect();
            double_click(&mut window, pos2(place.max.x - 6.0, place.center().y));
            let alone = window.get_by_label(part).rect();
            assert!(alone.area() > 1.5 * before.area(), "{part}: {alone:?} instead of {before:?}");
            assert!(window.query_by_label("Speed β").is_none());
            window.get_by_label("Observation time T");
            if leave_by_key {
                window.key_press(Key::Escape);
                window.run();
            } else {
                let place = window.get_by_label(title).rect();
                double_click(&mut window, pos2(place.max.x - 6.0, place.center().y));
            }
            assert_eq!(window.get_by_label(part).rect(), before);
        }
    }
}

fn meter(window: &Harness<'_, App>) -> String {
    label_starting_with(window, "Fusing: ")
}

fn the_comfortable_button_narrows_d_and_says_so() {
    let mut window = window_of_size(cyclist(0.9), [1280.0, 1600.0], 1.0);
    let wide = MotionSettings { d: 1.5, ..window.state().state().document.settings.motion };
    window.state_mut().run(SettingsCommand::Motion(wide));
    window.run();
    assert!(meter(&window).starts_with("Fusing: too much: "), "{}", meter(&window));
    window.get_by_label("Comfortable").click();
    window.run();
    assert!(meter(&window).starts_with("Fusing: comfortable: "), "{}", meter(&window));
    let d = window.state().state().document.settings.motion.d;
    assert!(d > 0.0 && d < 1.5);
    window.get_by_label(&format!("d narrowed from 1.5 to {d}: measured disparities shrink with it."));
    window.get_by_label("As before").click();
    window.run();
    assert_eq!(window.state().state().document.settings.motion, wide);
}

fn a_layout_to_be_fused_offers_to_narrow_d_where_it_is_hard_to() {
    let mut window = window_of_size(cyclist(0.9), [1280.0, 800.0], 1.0);
    let wide = MotionSettings { d: 1.5, ..window.state().state().document.settings.motion };
    window.state_mut().run(SettingsCommand::Motion(wide));
    window.run();
    let offer = "too much to fuse: narrow d";
    assert!(window.query_by_label(offer).is_none(), "nobody fuses pictures side by side");
    window.state_mut().run(in_layout(Layout::Dubois));
    window.run();
    window.get_by_label(offer).click();
    window.run();
    assert!(window.query_by_label_contains(" to fuse: narrow d").is_none());
    let d = window.state().state().document.settings.motion.d;
    assert!(d > 0.0 && d < 1.5, "{d}");
}

fn the_meter_knows_the_distance_and_costs_nothing_unseen() {
    let mut window = window_of_size(cyclist(0.9), [1280.0, 1600.0], 1.0);
    let across = |window: &Harness<'_, App>| -> f64 {
        let text = meter(window);
        let number =
            text.rsplit(": ").next().expect("numbers").split('°').next().expect("degrees").to_owned();
        number.parse().unwrap_or_else(|_| panic!("{text}"))
    };
    let near = across(&window);
    window.state_mut().run(SettingsCommand::Screen(ScreenSettings {
        viewing_distance: 240.0,
        ..ScreenSettings::default()
    }));
    window.run();
    assert!((4.0 * across(&window) - near).abs() < 0.03, "{near} {}", across(&window));
    window.get_by_label("Views").click();
    window.run();
    assert_eq!(meter(&window), "Fusing: nothing to fuse");
}

fn the_projectors_window_shows_the_views_and_goes_again() {
    // Without a system that has windows, it stands in this one.
    let mut window = window(cyclist(0.9));
    let views = |window: &Harness<'_, App>| window.query_all_by_label("Left eye view").count();
    for _ in 0..3 {
        assert_eq!(views(&window), 1);
        window.key_press(Key::W);
        window.run();
        assert_eq!(views(&window), 2);
        window.render().expect("a picture");
        window.key_press(Key::W);
        window.run();
    }
    assert_eq!(views(&window), 1);
}

fn a_projector_has_the_lessons_words_and_the_lecturer_keeps_notes() {
    let lesson = gamow::lesson::Library::own().open("turned").expect("a lesson");
    let mut state = cyclist(0.9);
    state.begin_lesson(&lesson).expect("it can be worked out");
    let mut window = window(state);
    let count = |window: &Harness<'_, App>, text: &str| {
        super::support::labels(window).iter().filter(|label| label.starts_with(text)).count()
    };
    let (question, notes) = ("What do you see as it passes", "Notes, for you alone: about ");
    let once = count(&window, question);
    assert_eq!(count(&window, notes), 0);
    window.key_press(Key::W);
    window.run_steps(4);
    assert_eq!(count(&window, question), 2 * once, "the audience reads it, too");
    assert!(count(&window, notes) > 0 && count(&window, "Answer") > 0 && count(&window, "Wrong") > 0);
    window.key_press(Key::W);
    window.run_steps(2);
    assert_eq!((count(&window, question), count(&window, notes)), (once, 0));
}
