//! The first window: how large its pictures are, and how many controls and numbers it begins with.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Rect, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use gamow::app::commands::SettingsCommand;
use gamow::app::shell::App;
use gamow::app::shell::persistence::Keeper;
use gamow::app::state::State;
use gamow::settings::{PlotTab, Settings};

use super::Test;
use super::controls::controls;
use super::support::{PaintedText, labels, painted_texts, pane, window_of_size, window_without_pictures};

pub const TESTS: &[Test] = trials![
    the_pictures_have_half_of_the_height_at_first_sight,
    there_are_few_controls_and_few_numbers_at_first_sight,
    there_are_three_sizes_of_writing,
    a_speed_is_fitted_by_the_button_beside_the_plot,
    more_controls_and_numbers_are_one_click_away_and_one_back,
    notes_fade_and_come_back_with_pointer_and_keyboard,
];

/// Who opens the program for the first time, past the start page.
fn first_window(size: [f32; 2]) -> Harness<'static, App> {
    let folder = tempfile::tempdir().expect("a folder");
    let settings = Keeper::in_folder(folder.path()).load().settings;
    window_without_pictures(State::open(settings).expect("a preset"), size)
}

fn the_pictures_have_half_of_the_height_at_first_sight() {
    for size in [[1024.0, 600.0], [1280.0, 800.0], [1366.0, 768.0], [1920.0, 1080.0]] {
        let window = first_window(size);
        for eye in [0, 1] {
            let share = pane(&window, eye).height() / size[1];
            let least = if size[1] < 700.0 { 0.45 } else { 0.5 };
            assert!(share >= least, "{size:?}: {share}");
        }
    }
}

/// Returns every text in sight, with its place.
fn texts(window: &Harness<'_, App>) -> Vec<(String, Rect)> {
    let texts = painted_texts(window).into_iter().filter(PaintedText::is_in_sight);
    texts.map(|text| (text.shape.galley.text().to_owned(), text.shape.visual_bounding_rect())).collect()
}

/// Returns the numbers in a text; a power of ten belongs to the unit of an axis.
fn numbers(text: &str) -> usize {
    let parts = text.split(|letter: char| !letter.is_ascii_digit() && letter != '.' && letter != '⁻');
    parts.filter(|part| part.contains(|c: char| c.is_ascii_digit()) && !part.contains('⁻')).count()
}

/// Returns the places of the axes: numbers alone there are ticks.
fn axes(window: &Harness<'_, App>) -> Vec<Rect> {
    let nodes = window.root().children_recursive();
    let around = nodes.filter_map(|node| {
        let node_of_it = node.accesskit_node();
        let label = node_of_it.label().or_else(|| node_of_it.value()).unwrap_or_default();
        let beside = |left: f32, below: f32| {
            let rect = node.rect();
            Rect::from_min_max(
                rect.min - eframe::egui::vec2(left, 4.0),
                rect.max + eframe::egui::vec2(4.0, below),
            )
        };
        match label.as_str() {
            "Speed β" => Some(beside(20.0, 24.0)),
            _ if label.starts_with("Map, from") || label.starts_with("Rapidity ruler") => {
                Some(beside(4.0, 4.0))
            }
            _ if label.starts_with("Plot of") => Some(beside(60.0, 30.0)),
            _ => None,
        }
    });
    around.collect()
}

fn there_are_few_controls_and_few_numbers_at_first_sight() {
    let window = first_window([1280.0, 800.0]);
    let controls = controls(&window);
    assert!(controls.len() <= 20, "{}: {controls:?}", controls.len());
    let axes = axes(&window);
    let is_tick = |(text, place): &(String, Rect)| {
        let is_number = text.chars().all(|letter| !letter.is_alphabetic() || letter == 'c');
        is_number && axes.iter().any(|axis| axis.contains_rect(*place))
    };
    let told: Vec<String> = texts(&window)
        .into_iter()
        .filter(|text| !is_tick(text))
        .map(|(text, _)| text)
        .filter(|text| numbers(text) > 0)
        .collect();
    let count: usize = told.iter().map(|text| numbers(text)).sum();
    assert!(count <= 12, "{count}: {told:?}");
    assert!(count >= 4, "not all texts are found: {told:?}");
}

fn a_speed_is_fitted_by_the_button_beside_the_plot() {
    let mut window = first_window([1280.0, 800.0]);
    window.get_by_label("Fit a speed").click();
    window.run_steps(3);
    assert_eq!(window.state().state().document.settings.plots.plot, PlotTab::Fit);
    window.get_by_role_and_label(Role::Button, "Disparity").click();
    window.run_steps(3);
    window.get_by_label("Fit a speed");
}

fn there_are_three_sizes_of_writing() {
    let mut windows = vec![first_window([1280.0, 800.0])];
    windows.extend(["disparity", "angles", "doppler", "stereo", "fit", "accuracy"].map(|tab| {
        let mut state = State::open(Settings::default()).expect("the street");
        for (name, value) in [("plot", tab), ("map", "on")] {
            state.run(SettingsCommand::Value { name, value: value.to_owned() });
        }
        window_of_size(state, [1920.0, 1080.0], 1.0)
    }));
    let texts = windows.iter().flat_map(painted_texts);
    let sections = texts.flat_map(|text| text.shape.galley.job.sections.clone());
    let mut sizes: Vec<f32> = sections.map(|section| section.format.font_id.size).collect();
    sizes.sort_by(f32::total_cmp);
    sizes.dedup();
    assert!(sizes.len() <= 3 && sizes[0] >= 12.0, "{sizes:?}");
}

fn more_controls_and_numbers_are_one_click_away_and_one_back() {
    let mut window = first_window([1280.0, 800.0]);
    let before = window.state().state().document.settings.window;
    let has_numbers =
        |window: &Harness<'_, App>| labels(window).iter().any(|label| label.starts_with("Stereo gain"));
    assert!(!has_numbers(&window));
    window.get_by_label("Numbers").click();
    window.run_steps(3);
    assert!(has_numbers(&window));
    window.get_by_label("Numbers").click();
    window.run_steps(3);
    window.get_by_label("More controls").click();
    window.run_steps(3);
    let all = window.state().state().document.settings.window;
    assert!(!all.simple && all.readout && all.spectrum && all.sentence);
    window.get_by_label("Fewer controls").click();
    window.run_steps(3);
    assert_eq!(window.state().state().document.settings.window, before);
}

/// Returns whether the note on the light is drawn on the left picture.
fn note_is_shown(window: &Harness<'_, App>) -> bool {
    let left = pane(window, 0);
    texts(window).iter().any(|(text, place)| text.contains("daylight") && left.contains(place.center()))
}

fn notes_fade_and_come_back_with_pointer_and_keyboard() {
    let mut window = first_window([1280.0, 800.0]);
    assert!(note_is_shown(&window));
    window.run_steps(80);
    assert!(!note_is_shown(&window));
    let middle = pane(&window, 0).center();
    window.hover_at(middle);
    window.run_steps(2);
    window.hover_at(middle + eframe::egui::vec2(9.0, 0.0));
    window.run_steps(8);
    assert!(note_is_shown(&window));
    window.hover_at(pos2(1100.0, 60.0));
    window.run_steps(80);
    assert!(!note_is_shown(&window));
    window.get_by_label("Left eye view").focus();
    window.run_steps(8);
    assert!(note_is_shown(&window));
    window.key_press(Key::Tab);
    window.run_steps(80);
    assert!(!note_is_shown(&window));
}
