//! Three times, in three units: what the window shows and takes, its marks of two times, its clocks, and what
//! is under the pointer.

use eframe::egui::{Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{PlaybackCommand, SettingsCommand, ShowCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::flags::TimeRange;
use gamow::flags::choices::Layout;
use gamow::lesson::Library;
use gamow::settings::{PlaybackSettings, WindowSettings};
use gamow::units::Units;
use relativity_render::Geometry;

use super::Test;
use super::support::{
    cyclist, in_layout, label_starting_with, labels, pane, seen, shown, slider, type_into, wide_window,
    window, window_of_size,
};

pub const TESTS: &[Test] = trials![
    an_event_has_its_numbers_in_three_units,
    what_is_typed_is_taken_in_the_unit_that_is_shown,
    units_are_chosen_in_the_bar_and_only_where_there_are_metres,
    two_marks_tell_presently_from_seen_abreast,
    marks_of_time_never_cover_each_other,
    what_is_under_the_pointer_is_told,
    nothing_is_told_of_what_no_ray_leads_to,
    clocks_show_proper_time_and_can_be_switched_off,
    a_lesson_counts_the_turns_of_its_clocks,
];

/// What a unit of length and of time is in these: 0.65 m, and what light takes for that.
fn factors(units: Units) -> [f64; 2] {
    match units {
        Units::Natural => [1.0, 1.0],
        Units::Metric => [0.65, 0.65 / 0.299_792_458],
        Units::Town => [0.65, 0.65 * 3.6 / 30.0],
    }
}

const ALL: [Units; 3] = [Units::Natural, Units::Metric, Units::Town];

fn in_units(units: Units) -> State {
    let mut state = cyclist(0.9);
    state.document.settings.window.units = units;
    state
}

fn an_event_has_its_numbers_in_three_units() {
    for units in ALL {
        let [length, time] = factors(units);
        let mut window = window(in_units(units));
        window.state_mut().run(PlaybackCommand::GoTo(1.1));
        window.run();
        for (eye, name) in ["Left eye", "Right eye"].into_iter().enumerate() {
            let seen = seen(0.9, 1.1, eye);
            let rows = [
                ("received T", 1.1 * time),
                ("happened t", seen.retarded_time * time),
                // The clock rests where it passes x = 0 at t = 0.
                ("proper time τ", seen.retarded_time * 0.19_f64.sqrt() * time),
                ("apparent X", seen.position[0] * length),
                ("apparent Y", 3.0 * length),
                ("Doppler factor D", seen.doppler_factor),
            ];
            for (row, expected) in rows {
                let value = shown(&window, &format!("{name}, {row}"));
                assert!((value - expected).abs() < 6e-5, "{units:?}, {name}, {row}: {value} for {expected}");
            }
        }
        let [left, right] = [0, 1].map(|eye| seen(0.9, 1.1, eye).position[0]);
        // Lines from (-d/2, 0) along (X left, y) and from (d/2, 0) along (X right, y), d = 0.1.
        let gain = (left - right) / 0.1;
        let (x, y) = ((-0.05 + left / gain) * length, 3.0 / gain * length);
        // To as many decimals as are shown.
        for (row, expected, rounding) in [("gain", gain, 6e-4), ("x", x, 6e-3), ("y", y, 6e-3)] {
            let value = shown(&window, &format!("Stereo {row}"));
            assert!((value - expected).abs() < rounding, "{units:?}, stereo {row}: {value} for {expected}");
        }
        let suffix = ["", " ns", " s"][units as usize];
        let label = label_starting_with(&window, "Left eye, happened t");
        assert!(label.ends_with(suffix), "{label}");
    }
}

fn what_is_typed_is_taken_in_the_unit_that_is_shown() {
    for units in ALL {
        let [length, time] = factors(units);
        let mut window = window(in_units(units));
        type_into(&mut window, "T, typed", "2.25");
        let set = window.state().state().document.time;
        assert!((set * time - 2.25).abs() < 1e-12, "{units:?}: T = {set}");
        type_into(&mut window, "Distance y, typed", "1.3");
        let set = window.state().state().document.settings.motion.depth_shift + 3.0;
        assert!((set * length - 1.3).abs() < 1e-12, "{units:?}: y = {set}");
        type_into(&mut window, "Playback rate", "0.5");
        let set = window.state().state().document.settings.playback.rate;
        assert!((set * time - 0.5).abs() < 1e-12, "{units:?}: {set} / s");
    }
}

fn units_are_chosen_in_the_bar_and_only_where_there_are_metres() {
    let mut window = wide_window(cyclist(0.9));
    let choose = |window: &mut Harness<'_, App>, name: &str| {
        window.get_by_label("Units").click();
        window.run();
        window.get_by_label(name).click();
        window.run();
    };
    choose(&mut window, "c = 30 km/h");
    assert_eq!(window.state().state().measures().units, Units::Town);
    assert!(labels(&window).iter().any(|label| label.ends_with("27.0 km/h")));
    window.state_mut().run(ShowCommand::Scene("two-balls"));
    window.run();
    assert_eq!(window.state().state().measures().units, Units::Natural);
    window.get_by_label("Units").click();
    window.run();
    window.get_by_label_contains("does not say how many metres");
    window.get_by_label("m, ns").click();
    window.run();
    assert_eq!(window.state().state().measures().units, Units::Natural);
    // What was chosen comes back with a scene that can have it.
    window.state_mut().run(ShowCommand::Scene("street"));
    window.run();
    assert_eq!(window.state().state().measures().units, Units::Town);
}

fn two_marks_tell_presently_from_seen_abreast() {
    // The cyclist moved back by one unit is abreast 1/beta times its contracted length later.
    let mut state = cyclist(0.9);
    let track = gamow::scene::Track { rest: [-1.0, 3.0, 2.0], ..state.document.points.selected().track };
    state.document.points.choose(track, 0, false);
    let mut window = window(state);
    window.get_by_label("Go to measured abreast").click();
    window.run();
    let presently = 0.19_f64.sqrt() / 0.9;
    let time = window.state().state().document.time;
    assert!((time - presently).abs() < 1e-12, "{time}");
    // It is seen far behind, where it is measured beside the eyes.
    assert!(shown(&window, "Left eye, apparent X") < -1.0);
    window.get_by_label("Go to seen abreast").click();
    window.run();
    let time = window.state().state().document.time;
    assert!((time - presently - 13.0025_f64.sqrt()).abs() < 1e-12, "{time}");
    // What is seen happened when it was measured abreast.
    assert!((shown(&window, "Left eye, happened t") - presently).abs() < 6e-5);
    assert!((shown(&window, "Right eye, apparent X") + 0.05).abs() < 6e-5);
}

fn marks_of_time_never_cover_each_other() {
    let ranges = [[-5.0, 20.0], [-1e3, 1e3], [0.0, 3.6], [3.0, 4.0], [10.0, 20.0], [-20.0, -10.0]];
    for size in [[800.0, 600.0], [1024.0, 600.0], [1920.0, 1080.0]] {
        for range in ranges {
            let mut state = in_units(Units::Metric);
            state.document.settings.playback =
                PlaybackSettings { range: TimeRange(Some(range)), ..PlaybackSettings::default() };
            let window = window_of_size(state, size, 1.0);
            let rect = |name: &str| window.get_by_label(name).rect();
            let (presently, seen) = (rect("Go to measured abreast"), rect("Go to seen abreast"));
            assert!(presently.max.x < seen.min.x, "{size:?}, {range:?}: {presently:?} {seen:?}");
            // What there is no room for is in a menu.
            let has_rate = window.query_by_label("Playback rate").is_some();
            let row = ["Play", "T, typed", if has_rate { "Playback rate" } else { "range" }].map(rect);
            assert!(row.is_sorted_by(|left, right| left.max.x < right.min.x), "{size:?}, {range:?}: {row:?}");
            let scrubber = slider(&window, "Observation time T");
            for mark in [presently, seen] {
                assert!(scrubber.x_range().expand(0.5).contains(mark.min.x), "{size:?}, {range:?}: {mark:?}");
                assert!(scrubber.x_range().expand(0.5).contains(mark.max.x), "{size:?}, {range:?}: {mark:?}");
                assert!(mark.min.y >= scrubber.max.y - 2.0, "{mark:?} {scrubber:?}");
            }
        }
    }
}

/// What is told of what is under the pointer in the view of an eye, at this part of its width and height.
fn told(window: &mut Harness<'_, App>, eye: usize, part: [f32; 2]) -> Option<(String, Rect)> {
    let pane = pane(window, eye);
    window.hover_at(pane.min + vec2(part[0] * pane.width(), part[1] * pane.height()));
    window.run_steps(2);
    let told = labels(window).into_iter().find(|label| label.starts_with("Under the pointer: "))?;
    let rect = window.get_by_label(&told).rect();
    Some((told, rect))
}

fn what_is_under_the_pointer_is_told() {
    let mut window = window(in_units(Units::Metric));
    let state = window.state().state();
    let size = [pane(&window, 0).width() as u32, pane(&window, 0).height() as u32];
    // Where the left eye sees the tracked point, a little inside of its tyre.
    let view = state.view(gamow::eye::Eye::Left, size);
    let direction = state.direction(state.document.points.selected(), gamow::eye::Eye::Left);
    let [u, v] = view.camera.pixel(direction.expect("it is seen")).expect("in front");
    let part = [(u as f32 - 2.0) / size[0] as f32, v as f32 / size[1] as f32];
    let time = state.document.time;
    let (text, tag) = told(&mut window, 0, part).expect("the tyre");
    assert!(text.starts_with("Under the pointer: front tyre   D = "), "{text}");
    let number = |name: &str| -> f64 {
        let (_, rest) = text.split_once(&format!("{name} = ")).expect("it is told");
        let number = rest.split([' ', ';']).next().expect("a number").replace('−', "-");
        number.parse().expect("a number")
    };
    let [_, nanoseconds] = factors(Units::Metric);
    let seen = seen(0.9, time, 0);
    assert!((number("received T") - time * nanoseconds).abs() < 6e-3, "{text}");
    // It is a point nearby on the same tyre.
    assert!((number("happened t") - seen.retarded_time * nanoseconds).abs() < 0.3, "{text}");
    assert!((number("D") - seen.doppler_factor).abs() < 0.05, "{text}");
    assert!(pane(&window, 0).contains_rect(tag), "{tag:?}");
    let pointer = pane(&window, 0).min + vec2(part[0] * size[0] as f32, part[1] * size[1] as f32);
    assert!(!tag.contains(pointer));
}

fn nothing_is_told_of_what_no_ray_leads_to() {
    let mut state = cyclist(0.9);
    state.document.settings.look.geometry = Geometry::Published;
    let mut window = window(state);
    // The sky, then the middle of the rider in the left eye's view and in the published one.
    assert_eq!(told(&mut window, 0, [0.02, 0.5]), None);
    assert!(told(&mut window, 0, [0.5, 0.5]).is_some() || told(&mut window, 0, [0.55, 0.6]).is_some());
    for part in [[0.5, 0.5], [0.55, 0.6], [0.45, 0.4]] {
        assert_eq!(told(&mut window, 1, part), None);
    }
    // Nor while T runs too fast to read it.
    window.state_mut().run(PlaybackCommand::Toggle);
    window.run_steps(1);
    for part in [[0.5, 0.5], [0.55, 0.6]] {
        assert_eq!(told(&mut window, 0, part), None);
    }
}

fn clocks_show_proper_time_and_can_be_switched_off() {
    let mut window = window(cyclist(0.9));
    for time in [-3.0, 1.1, 12.0] {
        window.state_mut().run(PlaybackCommand::GoTo(time));
        window.run();
        for (eye, name) in ["Left eye", "Right eye"].into_iter().enumerate() {
            let clock = format!("Clock of front tyre, {name}");
            assert!(label_starting_with(&window, &clock).ends_with(" of a turn"));
            let turn = shown(&window, &clock);
            // A turn takes 2 on it, and it passes x = 0 at t = 0.
            let expected = (seen(0.9, time, eye).retarded_time * 0.19_f64.sqrt() / 2.0).rem_euclid(1.0);
            assert!((turn - expected).abs() < 6e-5, "T = {time}, {name}: {turn} for {expected}");
        }
    }
    let settings = window.state().state().document.settings.window;
    window.state_mut().run(SettingsCommand::Window(WindowSettings { dials: false, ..settings }));
    window.run();
    assert!(window.query_by_label_contains("Clock of").is_none());
}

/// The clock that comes in the lesson, against the one that rests, from the beginning of its first step.
fn a_lesson_counts_the_turns_of_its_clocks() {
    let mut state = cyclist(0.9);
    let lesson = Library::own().open("clocks").expect("the program's own");
    state.begin_lesson(&lesson).expect("it begins");
    let mut window = window_of_size(state, [1280.0, 800.0], 1.0);
    let turns = |window: &Harness<'_, App>, clock: &str| -> f64 {
        let label = label_starting_with(window, clock);
        let count = label.trim_end_matches(" turns").rsplit(' ').next().expect("a count").replace('−', "-");
        count.parse().expect("a number")
    };
    // The lesson shows one eye's picture, until somebody asks for both.
    window.state_mut().run(in_layout(Layout::SideBySide));
    window.run_steps(2);
    for eye in ["Left eye", "Right eye"] {
        for clock in ["Clock of front hub", "Clock beside you"] {
            assert_eq!(turns(&window, &format!("{clock}, {eye}")), 0.0, "{clock}");
        }
    }
    window.state_mut().run(PlaybackCommand::GoTo(0.0));
    window.run_steps(2);
    // At 0.8 c, where the hub rests; a turn is 2 units.
    let gamma = 1.0 / 0.6;
    let proper_time = |a: f64, time: f64| {
        let [received, x] = [gamma * (time - 0.8 * a), gamma * (a - 0.8 * time)];
        let [dx, y, z]: [f64; 3] = [-0.525 - x, 3.901, -1.975];
        received - (dx * dx + y * y + z * z).sqrt()
    };
    for (eye, a) in [("Left eye", -0.05), ("Right eye", 0.05)] {
        let expected = 0.5 * (proper_time(a, 0.0) - proper_time(a, -4.0));
        let counted = turns(&window, &format!("Clock of front hub, {eye}"));
        assert!((counted - expected).abs() < 6e-3, "{eye}: {counted} for {expected}");
        assert_eq!(turns(&window, &format!("Clock beside you, {eye}")), 2.0);
    }
}
