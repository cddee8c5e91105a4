//! Sizes, scales, themes and extremes: everything is in the window, has a name, and is a number.

use eframe::egui::accesskit::Role;
use eframe::egui::{Rect, pos2, vec2};
use egui_kittest::kittest::Queryable as _;
use egui_kittest::{Harness, SnapshotOptions};
use gamow::app::commands::{PlaybackCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::lesson::LessonCommand;
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::lesson::Library;
use gamow::scene::{PRESETS, Scene};
use gamow::settings::{PlotSettings, PlotTab, Theme};

use super::Test;
use super::support::{cyclist, labels, wide_window, window, window_of_size, window_without_pictures};

pub const TESTS: &[Test] = trials![
    every_part_is_in_the_window_from_1024x600_to_4k,
    the_light_window_looks_as_it_did,
    the_dark_window_looks_as_it_did,
    tiny_windows_do_no_harm,
    extremes_show_numbers_or_dashes,
    every_scene_shows,
    hidden_parts_make_room,
    the_published_model_adds_dashed_curves,
];

/// Widgets that are in view without scrolling.
const ALWAYS_THERE: [&str; 11] = [
    "Scene",
    "Help",
    "Speed β",
    "Gamma, typed",
    "Play",
    "Observation time T",
    "Left eye view",
    "Right eye view",
    "Disparity",
    "Plot of Δφ of front tyre against T",
    "Plot of Δθ of front tyre against T",
];

fn every_part_is_in_the_window_from_1024x600_to_4k() {
    for (size, scale) in
        [([1024.0, 600.0], 1.0), ([1280.0, 800.0], 2.0), ([3840.0, 2160.0], 1.0), ([1920.0, 1080.0], 2.0)]
    {
        // Themes have other colours, not other sizes.
        let themes = [Theme::Light, Theme::Dark];
        for theme in themes.into_iter().take(if size[0] < 1100.0 { 2 } else { 1 }) {
            let mut state = cyclist(0.9);
            state.document.settings.window.theme = theme;
            let mut window = window_of_size(state, size, scale);
            window.run();
            let area = Rect::from_min_size(pos2(0.0, 0.0), size.into()).expand(0.5);
            for name in ALWAYS_THERE {
                let rect = window.get_by_label(name).rect();
                assert!(area.contains_rect(rect), "{name} at {rect:?} in {size:?}, scale {scale}");
                assert!(rect.width() >= 14.0 && rect.height() >= 14.0, "{name} at {rect:?}");
            }
            assert_both_backgrounds_differ(&mut window, theme);
        }
    }
}

fn the_light_window_looks_as_it_did() {
    assert_looks_as_it_did(Theme::Light, "window-light");
}

fn the_dark_window_looks_as_it_did() {
    assert_looks_as_it_did(Theme::Dark, "window-dark");
}

/// The views are left out: their pixels depend on the rasteriser. `UPDATE_SNAPSHOTS=1` accepts a new look.
fn assert_looks_as_it_did(theme: Theme, name: &str) {
    let mut state = cyclist(0.9);
    state.document.settings.window.theme = theme;
    state.document.settings.window.views = false;
    let mut window = window_of_size(state, [1024.0, 600.0], 1.0);
    window.run();
    let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(300_usize);
    window.try_snapshot_options(name, &options).unwrap_or_else(|difference| panic!("{difference}"));
}

/// The corner of the window shows the theme: light or dark.
fn assert_both_backgrounds_differ(window: &mut Harness<'_, App>, theme: Theme) {
    let picture = window.render().expect("a picture");
    let corner = picture.get_pixel(1, 1).0;
    assert_eq!(corner[0] > 128, theme == Theme::Light, "{corner:?}");
}

fn tiny_windows_do_no_harm() {
    for size in [[64.0, 64.0], [200.0, 100.0], [480.0, 320.0], [3000.0, 90.0], [90.0, 1500.0]] {
        let mut window = window_of_size(cyclist(0.9), size, 1.0);
        window.run();
        window.render().expect("a picture");
        // A lesson's panel too, whose steps are dots in a row: however narrow it is.
        let mut state = cyclist(0.9);
        let lesson = Library::own().open("turned").expect("it is there");
        state.begin_lesson(&lesson).expect("it can be shown");
        let mut window = window_of_size(state, size, 1.0);
        window.run();
        window.state_mut().run(LessonCommand::ToggleFolded);
        window.run();
    }
}

fn extremes_show_numbers_or_dashes() {
    let speeds = [
        (SpeedParameter::Gamma, 1e12),
        (SpeedParameter::Gamma, 1e30),
        (SpeedParameter::Beta, 0.0),
        (SpeedParameter::Beta, 1e-14),
    ];
    for (parameter, value) in speeds {
        let mut window = window_without_pictures(extreme(parameter, value), [1024.0, 600.0]);
        for plot in [PlotTab::Disparity, PlotTab::Angles, PlotTab::Doppler, PlotTab::Stereo] {
            window.state_mut().run(SettingsCommand::Plots(PlotSettings {
                plot,
                published: true,
                ..PlotSettings::default()
            }));
            for time in [0.0, -1e12, 1e12] {
                window.state_mut().run(PlaybackCommand::GoTo(time));
                window.run();
                assert_no_broken_numbers(&window);
            }
        }
        let mut drawn = window_of_size(extreme(parameter, value), [800.0, 600.0], 1.0);
        drawn.render().expect("a picture");
    }
}

/// d = 0, and the selected point passes through both apertures.
fn extreme(parameter: SpeedParameter, value: f64) -> State {
    let mut state = cyclist(0.5);
    let mut motion = state.document.settings.motion;
    motion.speed = SpeedSetting::new(parameter, value).expect("a speed");
    motion.d = 0.0;
    motion.depth_shift = -3.0;
    motion.height_shift = -2.0;
    state.run(SettingsCommand::Motion(motion));
    state
}

pub fn assert_no_broken_numbers(window: &Harness<'_, App>) {
    for label in labels(window) {
        let broken = label.contains("NaN") || label.contains("inf");
        assert!(!broken || label.contains("infrared"), "{label:?}");
    }
}

fn every_scene_shows() {
    let mut window = window(cyclist(0.9));
    for preset in PRESETS {
        let name = Scene::preset(preset).expect("a preset").name;
        window.get_by_label("Scene").click();
        window.run();
        window.get_by_role_and_label(Role::Button, &name).click();
        window.run();
        assert_eq!(window.state().state().document.scene.name, name);
    }
}

fn hidden_parts_make_room() {
    let mut window = wide_window(cyclist(0.9));
    let before = window.get_by_label("Left eye view").rect();
    for part in ["Controls", "Plots", "Map"] {
        window.get_by_label(part).click();
        window.run();
    }
    let after = window.get_by_label("Left eye view").rect();
    assert!(after.width() > before.width() + 100.0 && after.height() > before.height() + 100.0);
    window.get_by_label("Views").click();
    window.run();
    assert!(window.query_by_label("Left eye view").is_none());
}

fn the_published_model_adds_dashed_curves() {
    let mut window = window(cyclist(0.9));
    let picture = |window: &mut Harness<'_, App>| {
        window.remove_cursor();
        window.run();
        let plot = window.get_by_label("Plot of Δφ of front tyre against T").rect();
        let picture = window.render().expect("a picture");
        let (min, size) = (plot.min + vec2(2.0, 2.0), plot.size() - vec2(4.0, 4.0));
        let (width, height) = (size.x as u32, size.y as u32);
        (0..width * height)
            .map(|i| picture.get_pixel(min.x as u32 + i % width, min.y as u32 + i / width).0)
            .collect::<Vec<_>>()
    };
    let before = picture(&mut window);
    window.get_by_role_and_label(Role::CheckBox, "Published").click();
    window.run();
    assert!(picture(&mut window) != before);
    window.get_by_role_and_label(Role::CheckBox, "Published").click();
    window.run();
    assert!(picture(&mut window) == before);
}
