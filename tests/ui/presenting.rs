//! The whole screen, an audience, borders that are dragged, parts alone in the window, and the meter of
//! comfort.

use eframe::egui::{Event, Key, Modifiers, Rect, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use gamow::app::commands::{PlaybackCommand, SettingsCommand, Switch, WindowCommand};
use gamow::app::shell::App;
use gamow::app::state::lesson::LessonCommand;
use gamow::flags::choices::Layout;
use gamow::settings::{MotionSettings, PlotSettings, Preset, ScreenSettings, WindowSettings};

use super::Test;
use super::layouts::assert_no_broken_numbers;
use super::screens::{LEAST_PICTURE, painted_over, pictures};
use super::support::{
    cyclist, drag, in_layout, label_starting_with, labels, pane, some_lessons, sweep, wide_window, window,
    window_of_size, window_without_pictures,
};

pub const TESTS: &[Test] = trials![
    an_audience_has_one_large_picture_and_words_and_all_comes_back,
    keys_show_an_audience_both_eyes_a_plot_and_the_map_beside_a_picture_as_high,
    a_key_shows_one_eye_in_the_window_and_both_again,
    layouts_for_two_eyes_keep_both_before_an_audience,
    every_preset_has_two_thirds_of_the_height_before_an_audience_and_nothing_over_it,
    every_step_of_every_lesson_keeps_its_large_picture_in_one_place_before_an_audience,
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

fn an_audience_has_one_large_picture_and_words_and_all_comes_back() {
    let mut window = window(cyclist(0.9));
    let before = settings_window(&window);
    window.key_press(Key::P);
    window.run();
    for name in ["Left eye view", "β = 0.9"] {
        window.get_by_label(name);
    }
    // The times are told only where somebody asks for them.
    let tells_times = |window: &Harness<'_, App>| has_label(window, "The light reaching you now");
    assert!(!tells_times(&window));
    window.state_mut().run(SettingsCommand::Switch(Switch::Sentence));
    window.run();
    assert!(tells_times(&window));
    let hidden =
        ["Controls", "Speed β", "Play", "Help", "Right eye view", "Plot of Δφ of front tyre against T"];
    assert!(hidden.iter().all(|name| window.query_by_label(name).is_none()));
    assert!(!has_label(&window, "Click a point"));
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
    window.get_by_label("Right eye view");
}

fn has_label(window: &Harness<'_, App>, beginning: &str) -> bool {
    labels(window).iter().any(|label| label.starts_with(beginning))
}

fn keys_show_an_audience_both_eyes_a_plot_and_the_map_beside_a_picture_as_high() {
    let mut window = window_without_pictures(cyclist(0.9), [1280.0, 720.0]);
    window.key_press(Key::P);
    window.run_steps(3);
    let alone = pane(&window, 0);
    let plot = "Plot of Δφ of front tyre against T";
    for (key, name) in [(Key::B, "Right eye view"), (Key::N, plot), (Key::M, "Map, from above")] {
        assert!(window.query_by_label(name).is_none(), "{name}");
        window.key_press(key);
        window.run_steps(3);
        let (picture, shown) = (pane(&window, 0), window.get_by_label(name).rect());
        assert_eq!(picture.y_range(), alone.y_range(), "{name}");
        assert!(picture.max.x <= shown.min.x && picture.width() < alone.width(), "{name}");
        window.key_press(key);
        window.run_steps(3);
        assert!(window.query_by_label(name).is_none() && pane(&window, 0) == alone, "{name}");
    }
    // What was chosen for one preset is not for the next.
    window.key_press(Key::N);
    window.key_press(Key::PageDown);
    window.run_steps(3);
    assert!(!has_label(&window, "Plot of "));
}

fn a_key_shows_one_eye_in_the_window_and_both_again() {
    let mut window = window_without_pictures(cyclist(0.9), [1120.0, 700.0]);
    let wide = pane(&window, 0).width();
    window.key_press(Key::B);
    window.run_steps(3);
    assert!(window.query_by_label("Right eye view").is_none() && pane(&window, 0).width() > 1.9 * wide);
    window.key_press(Key::B);
    window.run_steps(3);
    assert_eq!(pane(&window, 0).width(), wide);
    window.get_by_label("Right eye view");
}

fn layouts_for_two_eyes_keep_both_before_an_audience() {
    for layout in [Layout::Anaglyph, Layout::FreeViewing, Layout::CrossEyed, Layout::Flicker] {
        let mut window = window_without_pictures(cyclist(0.9), [1280.0, 720.0]);
        window.state_mut().run(in_layout(layout));
        window.key_press(Key::P);
        window.run_steps(3);
        let has_both = window.query_by_label("Both eyes' view").is_some()
            || window.query_by_label("Right eye view").is_some();
        assert!(has_both, "{layout:?}");
    }
}

fn a_clicker_steps_the_presets_in_front_of_an_audience() {
    let mut window = window(cyclist(0.9));
    window.key_press(Key::P);
    window.run();
    for preset in &Preset::all()[..3] {
        window.key_press(Key::PageDown);
        window.run();
        assert_eq!(window.state().state().document.preset, Some(preset));
        window.get_by_label(&preset.title);
        let words = labels(&window);
        let is_begun =
            |label: &String| label.len() > 10 && preset.caption.starts_with(label.trim_end_matches('.'));
        assert!(words.iter().any(is_begun), "{}", preset.name);
        assert!(window.state().state().session.stage.is_presented());
    }
    window.key_press(Key::PageUp);
    window.run();
    assert_eq!(window.state().state().document.preset, Some(&Preset::all()[1]));
}

/// The screens of a lecture, points, and the least share of their height that the picture has.
const SCREENS: [[f32; 2]; 4] = [[1024.0, 768.0], [1366.0, 768.0], [1920.0, 1080.0], [3840.0, 2160.0]];

/// Checks how high the pictures are in a window of this `size`, and that they do not leave it.
fn assert_picture_is_large(window: &Harness<'_, App>, size: [f32; 2], at: &str) -> Rect {
    let all = pictures(window);
    let screen = Rect::from_min_size(pos2(0.0, 0.0), size.into()).expand(0.5);
    assert!(!all.is_empty() && all.iter().all(|picture| screen.contains_rect(*picture)), "{at}: {all:?}");
    let together = all.iter().copied().reduce(Rect::union).expect("a picture");
    assert!(together.height() >= LEAST_PICTURE * size[1], "{at}: {together:?} in {size:?}");
    together
}

fn every_preset_has_two_thirds_of_the_height_before_an_audience_and_nothing_over_it() {
    for size in SCREENS {
        let mut window = window_without_pictures(cyclist(0.9), size);
        window.key_press(Key::P);
        for preset in Preset::all() {
            window.key_press(Key::PageDown);
            window.run_steps(3);
            let at = format!("{} in {size:?}", preset.name);
            let picture = assert_picture_is_large(&window, size, &at);
            if !preset.settings.ride.is_on() && preset.settings.plots == PlotSettings::default() {
                let over = painted_over(&window, picture);
                assert!(over.is_empty(), "{at}: painted over {picture:?}: {over:?}");
            }
            assert!(words_are_high(&window, size), "{at}");
        }
    }
}

/// Whether the caption has at most three lines, high enough to be read.
fn words_are_high(window: &Harness<'_, App>, size: [f32; 2]) -> bool {
    let Some(preset) = window.state().state().document.preset else { return false };
    let nodes = window.root().children_recursive();
    let mut captions = nodes.filter(|node| {
        let node = node.accesskit_node();
        let label = node.label().or_else(|| node.value()).unwrap_or_default();
        label.len() > 20 && preset.caption.starts_with(label.trim_end_matches('.'))
    });
    // Three lines of 3 % of the height, and the space between them.
    let (least, most) = (0.03 * size[1], 3.0 * 1.3 * 0.042 * size[1]);
    captions.any(|node| (least..=most).contains(&node.rect().height()))
}

fn every_step_of_every_lesson_keeps_its_large_picture_in_one_place_before_an_audience() {
    for (number, lesson) in some_lessons(2).iter().enumerate() {
        let count = sweep([1, SCREENS.len()]);
        for size in (0..count).map(|other| SCREENS[(number + other) % SCREENS.len()]) {
            let mut state = cyclist(0.9);
            state.begin_lesson(lesson).expect("it can be worked out");
            let mut window = window_without_pictures(state, size);
            // A field for a number takes the keys of letters.
            window.state_mut().run(WindowCommand::TogglePresenting);
            window.run_steps(3);
            let mut before: Option<(usize, Rect)> = None;
            loop {
                let course = window.state().state().course().expect("a lesson");
                let (place, is_over) = (course.place(), course.step().is_none());
                let at = format!("{} {place:?} in {size:?}", lesson.name);
                let picture = assert_picture_is_large(&window, size, &at);
                if let Some((step, picture_before)) = before
                    && step == place.step
                {
                    assert_eq!(picture, picture_before, "{at}");
                }
                before = Some((place.step, picture));
                if is_over {
                    break;
                }
                window.key_press(Key::PageDown);
                window.run_steps(2);
                window.state_mut().run(LessonCommand::Observe(0));
                window.run_steps(2);
            }
        }
    }
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
            if size[0] >= 800.0 {
                assert_picture_is_large(&window, size, "a preset");
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
        // One large picture with its words, as before an audience in the one window.
        assert_eq!(window.query_all_by_label("Right eye view").count(), 1);
        assert_eq!(window.query_all_by_label("β = 0.9").count(), 2);
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
