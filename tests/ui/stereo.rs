//! The plot tab "Stereo": where two eyes take the selected point to be, held against the core.

use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{PlaybackCommand, SettingsCommand};
use gamow::settings::PlotTab;
use gamow::units::Units;
use relativity_core::{Aperture, Baseline, Model, SourcePoint, Speed};
use relativity_render::Geometry;

use super::Test;
use super::support::{
    SEPARATION, TRACKED, cyclist, label_starting_with, labels, seen, shown, window, window_of_size,
    window_without_pictures,
};

pub const TESTS: &[Test] = trials![
    the_stereo_tab_gives_the_gain_and_four_distances,
    the_stereo_tab_gives_distances_in_the_chosen_unit,
    with_one_light_cone_the_stereo_tab_has_gain_1_and_the_seen_distance,
    the_stereo_tab_fits_in_the_smallest_window,
    the_stereo_of_eyes_above_and_behind_each_other_is_told,
    the_stereo_of_a_turned_head_and_no_separation_leave_the_window_whole,
];

/// Where two eyes take the tracked point to be, after its label, and the other distances after theirs.
const DISTANCES: [&str; 4] = [
    "Where two eyes place it: ",
    "Where the left eye sees it: ",
    "Where the right eye sees it: ",
    "Where it is measured now: ",
];

/// Of the tracked point at 0.9 c.
fn distances(model: Model, time: f64) -> (f64, [f64; 4]) {
    let speed = Speed::from_beta(0.9).expect("a speed");
    let point = SourcePoint::from_rest(TRACKED, &speed);
    let fused = model.stereo(&speed, point, Aperture::pair(SEPARATION), time).expect("in the domain");
    let [left, right] = [0, 1].map(|eye| seen(0.9, time, eye).distance);
    let [_, y, z] = TRACKED;
    let measured = ((0.9 * time).powi(2) + y * y + z * z).sqrt();
    (fused.gain, [fused.distance(), left, right, measured])
}

fn the_stereo_tab_gives_the_gain_and_four_distances() {
    let mut window = window(cyclist(0.9));
    window.get_by_label("Stereo").click();
    window.run();
    assert_eq!(window.state().state().document.settings.plots.plot, PlotTab::Stereo);
    label_starting_with(&window, "Plot of stereo gain of front tyre against T");
    label_starting_with(&window, "Plot of distance of front tyre against T");
    for time in [-2.0, 1.1, 3.6, 7.0] {
        window.state_mut().run(PlaybackCommand::GoTo(time));
        window.run();
        let (gain, distances) = distances(Model::Exact, time);
        assert!((shown(&window, "stereo gain at T") - gain).abs() < 6e-5, "{time}");
        for (name, distance) in DISTANCES.into_iter().zip(distances) {
            assert!((shown(&window, name) - distance).abs() < 6e-3, "{name} {time} {distance}");
        }
    }
}

fn the_stereo_tab_gives_distances_in_the_chosen_unit() {
    let mut state = cyclist(0.9);
    state.document.settings.window.units = Units::Metric;
    state.document.settings.plots.plot = PlotTab::Stereo;
    let mut window = window(state);
    window.state_mut().run(PlaybackCommand::GoTo(1.1));
    window.run();
    assert!(labels(&window).contains(&"distance / m".to_owned()));
    let (_, distances) = distances(Model::Exact, 1.1);
    for (name, distance) in DISTANCES.into_iter().zip(distances) {
        assert!((shown(&window, name) - 0.65 * distance).abs() < 6e-3, "{name} {distance}");
    }
}

fn with_one_light_cone_the_stereo_tab_has_gain_1_and_the_seen_distance() {
    let mut state = cyclist(0.9);
    state.document.settings.look.geometry = Geometry::OneCone;
    state.document.settings.plots.plot = PlotTab::Stereo;
    let mut window = window_without_pictures(state, [1120.0, 700.0]);
    window.state_mut().run(PlaybackCommand::GoTo(1.1));
    window.run();
    let (gain, [distance, ..]) = distances(Model::OneCone, 1.1);
    assert_eq!((gain, shown(&window, "stereo gain at T")), (1.0, 1.0));
    assert!((shown(&window, DISTANCES[0]) - distance).abs() < 6e-3);
}

fn the_stereo_tab_fits_in_the_smallest_window() {
    let mut state = cyclist(0.9);
    state.document.settings.plots.plot = PlotTab::Stereo;
    let mut window = window_of_size(state, [1024.0, 600.0], 1.0);
    window.run();
    let right = window.get_by_label("Plot of distance of front tyre against T").rect().max.x;
    for name in DISTANCES {
        let label = label_starting_with(&window, name);
        let place = window.get_by_label(&label).rect();
        assert!(place.max.x <= right + 1.0 && place.max.y <= 600.0, "{label}: {place:?}, plot to {right}");
    }
}

/// The buttons hold the head; readout and plot say what the core says of such a pair.
fn the_stereo_of_eyes_above_and_behind_each_other_is_told() {
    let mut state = cyclist(0.9);
    state.document.settings.plots.plot = PlotTab::Stereo;
    // Nearly level with the eyes.
    state.document.settings.motion.height_shift = -1.8;
    let mut window = window_of_size(state, [1280.0, 1300.0], 1.0);
    window.state_mut().run(PlaybackCommand::GoTo(0.5));
    window.get_by_label("Above").click();
    window.run();
    let motion = window.state().state().document.settings.motion;
    assert_eq!([motion.roll, motion.turn], [90.0, 0.0]);
    let (speed, time) = (Speed::from_beta(0.9).expect("a speed"), 0.5);
    let point = SourcePoint { z: TRACKED[2] - 1.8, ..SourcePoint::from_rest(TRACKED, &speed) };
    let above = Baseline { roll: std::f64::consts::FRAC_PI_2, ..Baseline::straight(SEPARATION) };
    let fused = Model::Exact.stereo(&speed, point, above.apertures(), time).expect("they meet");
    assert!((shown(&window, "Stereo gain:") - fused.gain).abs() < 6e-4);
    assert!((shown(&window, "Stereo x:") - fused.position[0]).abs() < 6e-3);
    let miss = shown(&window, "Lines of sight pass");
    assert!((miss - fused.miss).abs() < 6e-4 && fused.miss > 0.001, "{miss} {}", fused.miss);
    window.get_by_label("Behind").click();
    window.run();
    let behind = Baseline { turn: std::f64::consts::FRAC_PI_2, ..Baseline::straight(SEPARATION) };
    assert!(Model::Exact.stereo(&speed, point, behind.apertures(), time).is_err());
    let said = "The lines of sight diverge: they do not meet in front of the eyes.";
    assert!(labels(&window).iter().any(|label| label == said), "{:?}", labels(&window));
}

/// Whatever the tab, the geometry and the map, and with both eyes in one place.
fn the_stereo_of_a_turned_head_and_no_separation_leave_the_window_whole() {
    let mut window = window_without_pictures(cyclist(0.9), [1120.0, 700.0]);
    let default = window.state().state().document.settings.clone();
    for (roll, turn) in [(90.0, 0.0), (0.0, 90.0), (180.0, 0.0), (-30.0, 60.0)] {
        for (d, geometry) in [(0.1, Geometry::Seen), (0.0, Geometry::OneCone), (0.1, Geometry::Published)] {
            for plot in [PlotTab::Disparity, PlotTab::Stereo, PlotTab::Angles] {
                let mut settings = default.clone();
                (settings.motion.roll, settings.motion.turn, settings.motion.d) = (roll, turn, d);
                (settings.look.geometry, settings.plots.plot) = (geometry, plot);
                window.state_mut().run(SettingsCommand::Motion(settings.motion));
                window.state_mut().run(SettingsCommand::Look(settings.look));
                window.state_mut().run(SettingsCommand::Plots(settings.plots));
                window.run();
                assert!(
                    labels(&window).iter().all(|label| !label.contains("NaN") && !label.contains("inf "))
                );
            }
        }
    }
}
