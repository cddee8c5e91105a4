//! Messages, keys, names and small windows: nothing leaves the window, nothing covers what is worked with.

use std::path::Path;

use clap::ValueEnum as _;
use eframe::egui::{Key, Modifiers, OutputCommand, Rect, Vec2, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use gamow::app::commands::{PlaybackCommand, PointsCommand, SettingsCommand, ShowCommand, WindowCommand};
use gamow::app::shell::App;
use gamow::app::state::pointer::Pick;
use gamow::flags::choices::GazeChoice;
use gamow::settings::PlotTab;

use super::Test;
use super::picking::{FRONT_TYRE, click};
use super::support::{
    FRAME, cyclist, label_starting_with, labels, open, painted_texts, pane, slider, wide_window, window,
    window_of_size, window_without_pictures,
};

pub const TESTS: &[Test] = trials![
    a_message_of_any_length_stays_over_the_views,
    a_message_is_copied_and_closed,
    a_message_names_its_file_without_the_folder,
    no_control_leaves_the_window_or_covers_another,
    the_smallest_window_has_plots_and_views_of_use,
    a_click_beside_everything_says_so,
    a_click_near_something_means_it,
    what_is_under_the_pointer_is_outlined,
    points_are_numbered_only_where_two_have_one_name,
    the_palette_finds_what_to_do_by_its_words,
    the_palette_follows_what_is_named,
    keys_look_around_in_a_focused_view,
    keys_go_from_body_to_body,
    keys_work_while_a_button_has_the_keyboard,
    no_tooltip_covers_what_was_dragged,
    no_writing_in_the_window_is_smaller_than_eleven_points,
    a_newcomer_is_told_to_click_until_the_first_click,
    a_hint_in_the_views_goes_by_itself,
    the_tabulator_reaches_every_control_and_both_views_visibly,
    scroll_bars_have_room_of_their_own,
    the_help_fits_into_the_smallest_window,
];

const SIZES: [[f32; 2]; 4] = [[800.0, 600.0], [900.0, 600.0], [1024.0, 600.0], [1280.0, 800.0]];

/// A window that says it could not open a file whose path is so long.
fn with_message(size: [f32; 2], text: &str) -> Harness<'static, App> {
    let mut state = cyclist(0.9);
    state.scratch.notice = Some(gamow::app::state::notice::Notice::error(text));
    window_without_pictures(state, size)
}

/// Where the controls called so are.
fn places(window: &Harness<'_, App>, names: &[&str]) -> Vec<(String, Rect)> {
    let nodes = window.root().children_recursive();
    nodes
        .filter_map(|node| {
            let name = node.accesskit_node().label().filter(|name| names.contains(&name.as_str()))?;
            Some((name, node.rect()))
        })
        .collect()
}

fn a_message_of_any_length_stays_over_the_views() {
    let words = "This file could not be read. ".repeat(69);
    let unbroken = "x".repeat(2000);
    for text in [words.as_str(), &unbroken] {
        for size in [[800.0, 600.0], [1280.0, 800.0]] {
            for present in [false, true] {
                let mut window = with_message(size, text);
                if present {
                    window.state_mut().run(WindowCommand::TogglePresenting);
                    window.run_ok();
                }
                let whole = Rect::from_min_size(pos2(0.0, 0.0), Vec2::from(size));
                for button in ["Close message", "Copy message"] {
                    let rect = window.get_by_label(button).rect();
                    assert!(whole.contains_rect(rect), "{size:?} {button}: {rect:?}");
                }
                let before = window.query_by_label("Help").map(|node| node.rect());
                window.get_by_label("Close message").click();
                window.run_ok();
                assert!(window.query_by_label("Close message").is_none());
                let after = window.query_by_label("Help").map(|node| node.rect());
                assert_eq!((before, before.is_none()), (after, present), "it takes no room from the bar");
            }
        }
    }
}

fn a_message_is_copied_and_closed() {
    let text = "One thing. ".repeat(200);
    let mut window = with_message([800.0, 600.0], &text);
    window.get_by_label("Copy message").click();
    let mut copied = None;
    for _ in 0..4 {
        window.step();
        for command in &window.output().platform_output.commands {
            if let OutputCommand::CopyText(text) = command {
                copied = Some(text.clone());
            }
        }
    }
    assert_eq!(copied.as_deref(), Some(text.as_str()));
    window.key_press(Key::Escape);
    window.run_ok();
    assert_eq!(window.state().state().scratch.notice, None);
}

fn a_message_names_its_file_without_the_folder() {
    let mut window = window(cyclist(0.9));
    open(&mut window, Path::new("/nowhere/at/all/balls.toml"));
    window.run_ok();
    let notice = window.state().state().scratch.notice.clone().expect("it cannot be read");
    assert!(notice.text.starts_with("balls.toml: "), "{}", notice.text);
    window.get_by_label(&notice.text);
    assert_eq!(notice.path.as_deref(), Some("/nowhere/at/all/balls.toml"));
}

/// Buttons and fields of the bar and the timeline.
const CONTROLS: [&str; 20] = [
    "Scene",
    "Lessons",
    "Units",
    "Views",
    "Map",
    "Plots",
    "Controls",
    "More",
    "Theme",
    "Help",
    "To the start",
    "Step back",
    "Play",
    "Step forwards",
    "To the end",
    "T, typed",
    "Playback rate",
    "Loop",
    "First T",
    "Last T",
];

fn no_control_leaves_the_window_or_covers_another() {
    for size in SIZES {
        for (units, scene) in [("scene", "cyclist"), ("metres", "street")] {
            let mut state = cyclist(0.9);
            if units == "metres" {
                state.run(ShowCommand::Scene("street"));
                let units = gamow::units::Units::Metric;
                let shown = gamow::settings::WindowSettings { units, ..state.document.settings.window };
                state.run(SettingsCommand::Window(shown));
            }
            let window = window_of_size(state, size, 1.0);
            let whole = Rect::from_min_size(pos2(0.0, 0.0), Vec2::from(size));
            let all = places(&window, &CONTROLS);
            assert!(all.len() >= 14, "{size:?} {scene}: {all:?}");
            for (number, (name, rect)) in all.iter().enumerate() {
                assert!(whole.contains_rect(*rect), "{size:?} {scene}: {name} at {rect:?}");
                for (other, its) in &all[number + 1..] {
                    let both = rect.intersect(*its);
                    let overlap = both.width() > 0.5 && both.height() > 0.5;
                    assert!(!overlap || name == other, "{size:?} {scene}: {name} {rect:?}, {other} {its:?}");
                }
            }
        }
    }
}

fn the_smallest_window_has_plots_and_views_of_use() {
    for size in SIZES {
        let window = window_of_size(cyclist(0.9), size, 1.0);
        for eye in [0, 1] {
            let pane = pane(&window, eye);
            assert!(pane.width() >= 220.0 && pane.height() >= 165.0, "{size:?}: {pane:?}");
        }
        for quantity in ["Δφ", "Δθ"] {
            let name = label_starting_with(&window, &format!("Plot of {quantity}"));
            let plot = window.get_by_label(&name).rect();
            // Three ticks and what is between them: the pictures come first.
            assert!(plot.width() >= 160.0 && plot.height() >= 75.0, "{size:?} {quantity}: {plot:?}");
        }
    }
}

fn a_click_beside_everything_says_so() {
    let mut window = window(cyclist(0.9));
    let corner = pane(&window, 0).right_top() + vec2(-5.0, 5.0);
    click(&mut window, corner, Modifiers::NONE);
    window.get_by_label("Nothing here to follow.");
    window.key_press(Key::ArrowRight);
    window.run_ok();
    assert!(window.query_by_label("Nothing here to follow.").is_none());
}

fn what_is_under_the_pointer_is_outlined() {
    let mut window = window(cyclist(0.9));
    window.state_mut().run(SettingsCommand::Geometry(relativity_render::Geometry::Contracted));
    window.run_ok();
    let bare = window.render().expect("a picture");
    let pane = pane(&window, 0);
    // From the left edge to the right one the pointer comes upon the wheel.
    let found = (0..200).find_map(|step| {
        let place = pane.left_center() + vec2(pane.width() * step as f32 / 200.0, 0.2 * pane.height());
        window.hover_at(place);
        window.run_ok();
        labels(&window).into_iter().find(|label| label.starts_with("Under the pointer: ")).map(|_| place)
    });
    let place = found.expect("something is there");
    let outlined = window.render().expect("a picture");
    // Above the pointer there is no tag.
    let around = pane.shrink(3.0).with_max_y(place.y - 2.0);
    let differing = (around.min.y as u32..around.max.y as u32)
        .flat_map(|y| (around.min.x as u32..around.max.x as u32).map(move |x| (x, y)))
        .filter(|&(x, y)| bare.get_pixel(x, y) != outlined.get_pixel(x, y))
        .count();
    assert!(differing > 10, "{differing} pixels");
}

fn points_are_numbered_only_where_two_have_one_name() {
    let mut window = window(cyclist(0.9));
    let readout =
        |window: &Harness<'_, App>| labels(window).iter().filter(|label| *label == "front tyre").count();
    assert!(readout(&window) > 0);
    let track = window.state().state().document.scene.track_on(FRONT_TYRE).expect("a body");
    let select = gamow::app::state::pointer::Select { track, body: FRONT_TYRE, add: true };
    window.state_mut().run(PointsCommand::Choose(select));
    window.run_ok();
    assert_eq!(readout(&window), 0);
    window.get_by_label("front tyre (1)");
    window.get_by_label("Remove front tyre (2)");
}

fn the_palette_finds_what_to_do_by_its_words() {
    let mut window = window(cyclist(0.9));
    window.key_press_modifiers(Modifiers::COMMAND, Key::P);
    window.run_ok();
    window.get_by_label("play or pause");
    window.get_by_label("Command").type_text("map hide");
    window.run_ok();
    assert!(window.query_by_label("play or pause").is_none());
    window.get_by_label("show or hide the map");
    let shown = window.state().state().frame.shows_map;
    window.key_press(Key::Enter);
    window.run_ok();
    assert_eq!(window.state().state().frame.shows_map, !shown);
    assert!(window.query_by_label("Command").is_none());
    window.key_press_modifiers(Modifiers::COMMAND, Key::P);
    window.run_ok();
    // What was typed before is forgotten; below the step is the one of ten.
    window.get_by_label("Command").type_text("back in time");
    window.run_ok();
    window.key_press(Key::ArrowDown);
    window.run_ok();
    let mut expected = window.state().state().clone();
    expected.run(PlaybackCommand::Step(-10));
    window.key_press(Key::Enter);
    window.run_ok();
    assert_eq!(window.state().state().document.time, expected.document.time);
    window.key_press_modifiers(Modifiers::COMMAND, Key::P);
    window.run_ok();
    window.key_press(Key::Escape);
    window.run_ok();
    assert!(window.query_by_label("Command").is_none());
}

fn the_palette_follows_what_is_named() {
    let mut window = window(cyclist(0.9));
    window.key_press_modifiers(Modifiers::COMMAND, Key::P);
    window.run_ok();
    window.get_by_label("Command").type_text("tyre rear");
    window.run_ok();
    window.get_by_label("follow: rear tyre").click();
    window.run_ok();
    label_starting_with(&window, "Plot of Δφ of rear tyre against T");
}

fn keys_look_around_in_a_focused_view() {
    let mut window = window(cyclist(0.9));
    window.get_by_label("Left eye view").focus();
    window.run_ok();
    let (before, fov) = (window.state().state().gaze(), window.state().state().look().set_fov());
    let time = window.state().state().document.time;
    window.key_press(Key::ArrowRight);
    window.run_ok();
    let aside = window.state().state().gaze();
    assert!(aside.azimuth < before.azimuth, "{before:?} {aside:?}");
    window.key_press(Key::ArrowUp);
    window.run_ok();
    assert!(window.state().state().gaze().elevation > aside.elevation);
    assert!(matches!(window.state().state().document.settings.look.gaze, GazeChoice::Fixed(_)));
    assert_eq!(window.state().state().document.time, time, "arrows do not step while a view takes them");
    window.key_press(Key::Plus);
    window.run_ok();
    assert!(window.state().state().look().set_fov() < fov);
    let body = window.state().state().document.points.selected().body;
    window.key_press(Key::Enter);
    window.run_ok();
    assert_ne!(window.state().state().document.points.selected().body, body);
}

fn keys_go_from_body_to_body() {
    let mut window = window(cyclist(0.9));
    window.key_press(Key::J);
    window.run_ok();
    label_starting_with(&window, "Plot of Δφ of front rim against T");
    for _ in 0..2 {
        window.key_press_modifiers(Modifiers::SHIFT, Key::J);
        window.run_ok();
    }
    // Before the first comes the last.
    label_starting_with(&window, "Plot of Δφ of crown of the hat against T");
}

fn keys_work_while_a_button_has_the_keyboard() {
    let mut window = window(cyclist(0.9));
    window.get_by_label("Help").focus();
    window.run_ok();
    window.key_press(Key::J);
    window.run_ok();
    label_starting_with(&window, "Plot of Δφ of front rim against T");
    let time = window.state().state().document.time;
    window.key_press(Key::Space);
    window.run_ok();
    let help = Some(gamow::app::state::overlay::Overlay::Help);
    assert_eq!(window.state().state().session.overlay, help, "space presses the button");
    assert!(!window.state().state().scratch.playing && window.state().state().document.time == time);
}

fn the_help_fits_into_the_smallest_window() {
    let mut window = window_of_size(cyclist(0.9), [800.0, 600.0], 1.0);
    window.key_press(Key::F1);
    window.run_ok();
    let whole = Rect::from_min_size(pos2(0.0, 0.0), vec2(800.0, 600.0));
    for (section, told) in [
        ("What is this?", "two eyes"),
        ("Words", "light cone"),
        ("Keys", "play or pause"),
        ("Mouse", "Shift-click"),
        ("Paper", "Cryer-Jenkins"),
        ("Licences", "Under the Apache License, Version 2.0"),
    ] {
        let tab = window.get_by_label(section);
        assert!(whole.contains_rect(tab.rect()), "{section}");
        tab.click();
        window.run_ok();
        assert!(labels(&window).iter().any(|label| label.contains(told)), "{section}: {told}");
    }
    window.key_press(Key::Escape);
    window.run_ok();
    assert!(window.query_by_label("Words").is_none());
    assert_eq!(window.state().state().document.settings.plots.plot, PlotTab::Disparity);
}

fn no_tooltip_covers_what_was_dragged() {
    let mut window = window(cyclist(0.9));
    let is_told =
        |window: &Harness<'_, App>| labels(window).iter().any(|label| label.contains("finer towards 1"));
    let speed = slider(&window, "Speed β");
    let [from, to] = [0.4, 0.6].map(|part| speed.left_center() + vec2(part * speed.width(), 0.0));
    let button = |pos, pressed| eframe::egui::Event::PointerButton {
        pos,
        button: eframe::egui::PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    window.hover_at(from);
    window.step();
    window.event(button(from, true));
    window.step();
    window.hover_at(to);
    window.step();
    window.event(button(to, false));
    window.step();
    // Hands are not quite still.
    window.hover_at(to + vec2(1.0, 0.0));
    window.run_steps(30);
    assert!(window.state().state().speed().beta() != 0.9 && !is_told(&window));
    window.hover_at(pane(&window, 0).center());
    window.run_steps(30);
    window.hover_at(to);
    window.run_steps(30);
    assert!(is_told(&window));
}

fn no_writing_in_the_window_is_smaller_than_eleven_points() {
    for size in [[800.0, 600.0], [1280.0, 800.0]] {
        for present in [false, true] {
            let mut window = window_without_pictures(cyclist(0.9), size);
            window.state_mut().run(ShowCommand::Preset(&gamow::settings::Preset::all()[0]));
            if present {
                window.state_mut().run(WindowCommand::TogglePresenting);
            }
            window.run_ok();
            for &plot in PlotTab::value_variants() {
                let plots =
                    gamow::settings::PlotSettings { plot, ..window.state().state().document.settings.plots };
                window.state_mut().run(SettingsCommand::Plots(plots));
                window.run_ok();
                let sizes: Vec<(f32, String)> = painted_texts(&window)
                    .iter()
                    .map(|text| &text.shape.galley.job)
                    .flat_map(|job| job.sections.iter().map(|of| (of.format.font_id.size, job.text.clone())))
                    .collect();
                assert!(sizes.len() > 5, "{size:?} {plot:?}");
                let small = sizes.iter().find(|(size, _)| *size < 11.0);
                assert_eq!(small, None, "{size:?} {plot:?}");
            }
        }
    }
}

/// The hint goes by itself, and covers nothing else that is written in the view.
fn a_hint_in_the_views_goes_by_itself() {
    let hint = "Click a point to follow it.";
    let mut state = cyclist(0.9);
    state.session.hint = true;
    let mut window = window(state);
    let has_hint = |window: &Harness<'_, App>| labels(window).iter().any(|label| label == hint);
    assert!(has_hint(&window));
    window.run_steps((11.0 / FRAME) as usize);
    assert!(has_hint(&window));
    window.run_steps((2.0 / FRAME) as usize);
    assert!(!has_hint(&window) && window.state().state().session.hint);
}

fn a_newcomer_is_told_to_click_until_the_first_click() {
    let hint = "Click a point to follow it.";
    let mut state = cyclist(0.9);
    state.session.hint = true;
    let mut window = window(state);
    let count = |window: &Harness<'_, App>| labels(window).iter().filter(|label| *label == hint).count();
    assert_eq!(count(&window), 2);
    window.state_mut().run(ShowCommand::Scene("street"));
    window.run_ok();
    assert_eq!(count(&window), 2, "another scene is as new");
    let pane = pane(&window, 0);
    let on =
        (0..60).map(|step| pane.left_center() + vec2(pane.width() * step as f32 / 60.0, 0.2 * pane.height()));
    for place in on {
        click(&mut window, place, Modifiers::NONE);
        if !window.state().state().session.hint {
            break;
        }
    }
    assert_eq!(count(&window), 0);
}

/// Beside the tyre's outer edge nothing is, and the tyre is meant.
fn a_click_near_something_means_it() {
    let state = cyclist(0.9);
    let size = [466, 276];
    let eye = gamow::eye::Eye::Left;
    let is_free = |pixel: [f64; 2]| state.point_at(eye, pixel, size).is_none();
    let row = (0..466).map(|u| [f64::from(u) + 0.5, 190.5]);
    let first = row.clone().find(|&pixel| !is_free(pixel)).expect("something is in this row");
    for (off, is_meant) in [(3.0, true), (6.0, true), (40.0, false)] {
        let beside = [first[0] - off, first[1]];
        assert!(is_free(beside));
        let mut picked = state.clone();
        picked.run(PointsCommand::Pick(Pick { eye, is_second: false, pixel: beside, size, add: false }));
        assert_eq!(picked.document.points != state.document.points, is_meant, "{off}");
        assert_eq!(picked.scratch.missed.is_none(), is_meant, "{off}");
    }
}

fn the_tabulator_reaches_every_control_and_both_views_visibly() {
    let mut window = wide_window(cyclist(0.9));
    let bare = window.render().expect("a picture");
    let mut reached = std::collections::BTreeSet::new();
    for count in 0..160 {
        window.key_press(Key::Tab);
        window.run_steps(2);
        let Some((name, rect)) = focused(&window) else { continue };
        if count < 6 {
            let ringed = window.render().expect("a picture");
            let around = rect.expand(2.0);
            let top = around.min.y.round() as u32;
            let columns = around.min.x.max(0.0) as u32..(around.max.x as u32).min(1279);
            let changed = columns.clone().filter(|&x| {
                (top.saturating_sub(1)..top + 3).any(|y| bare.get_pixel(x, y) != ringed.get_pixel(x, y))
            });
            assert!(2 * changed.count() > columns.len(), "{name} at {rect:?}");
        }
        reached.insert(name);
    }
    for name in [
        "Scene",
        "Lessons",
        "Units",
        "Theme",
        "Help",
        "Speed β",
        "Play",
        "T, typed",
        "Left eye view",
        "Right eye view",
        "Whole",
        "Readout",
    ] {
        assert!(reached.contains(name), "{name} is not among {reached:?}");
    }
}

/// What has the keyboard, and where.
fn focused(window: &Harness<'_, App>) -> Option<(String, Rect)> {
    let node = window.root().children_recursive().find(|node| node.accesskit_node().is_focused())?;
    Some((node.accesskit_node().label().unwrap_or_default(), node.rect()))
}

fn scroll_bars_have_room_of_their_own() {
    for size in SIZES {
        let window = window_of_size(cyclist(0.9), size, 1.0);
        for name in ["Separation d, typed", "Height z, typed", "Speed β"] {
            let end = window.get_by_label(name).rect().max.x;
            // The bar is 9 points wide, at the edge of what stands 8 from that of the window.
            assert!(end <= size[0] - 17.0, "{size:?} {name} ends at {end}");
        }
    }
}
