//! Measured disparities in the Fit tab, and simulated ones by each model.

use std::path::{Path, PathBuf};
use std::process::Command as Program;

use eframe::egui::{Pos2, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{SettingsCommand, ShowCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::settings::{FitSettings, MotionSettings, PlotSettings, PlotTab, Presence};
use gamow::units::Units;
use relativity_core::{Curves, Model, PublishedVariant};

use super::Test;
use super::saving::{message, save};
use super::support::{
    cyclist, label_starting_with, labels, open, settle, shown, type_into, wait_for_file, window,
};

pub const TESTS: &[Test] = trials![
    own_data_are_fitted_and_shown,
    the_saved_fit_is_that_of_the_command_line,
    a_dropped_csv_file_is_data,
    a_click_on_a_reading_leaves_it_out_and_takes_it_back,
    the_plotted_samples_are_saved_and_fitted_again,
    the_plotted_curves_are_saved_and_fitted,
    what_is_wrong_in_own_data_is_located,
    what_own_data_do_not_tell_is_told,
    the_papers_own_fit_is_repeated,
];

const APPENDIX_A: Model = Model::Published(PublishedVariant::AppendixA);

fn gamow(arguments: &[&str]) -> String {
    let output = Program::new(env!("CARGO_BIN_EXE_gamow")).args(arguments).output().expect("it starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

/// A file in `folder` of what a point at 0.7 c, 4 in front and 1 above, looks like; with a little noise.
fn measured(folder: &Path, columns: &[&str]) -> PathBuf {
    let curve = gamow(&["curve", "--beta=0.7", "--d=0.2", "--y=4", "--z=1", "--samples=120"]);
    let mut lines = curve.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = lines.next().expect("a header");
    let place = |column: &str| names.iter().position(|name| *name == column);
    let mut text = columns.join(",") + "\n";
    for (index, line) in lines.enumerate() {
        let cell = |column: &&str| match place(column) {
            Some(place) if column.starts_with("dp") || column.starts_with("dt") => {
                let value: f64 = line[place].parse().expect("a number");
                (value + 1e-4 * (37.0 * (index * index) as f64).sin()).to_string()
            }
            Some(place) => line[place].to_owned(),
            None => "0.0001".to_owned(),
        };
        text += &(columns.iter().map(cell).collect::<Vec<_>>().join(",") + "\n");
    }
    let path = folder.join("measured.csv");
    std::fs::write(&path, text).expect("written");
    path
}

/// A window with room for all of the Fit tab.
fn fit_window(setup: FitSettings) -> Harness<'static, App> {
    let mut state = cyclist(0.9);
    state.document.settings.window.map = Presence::Off;
    state.run(SettingsCommand::Fit(setup));
    state.run(SettingsCommand::Plots(PlotSettings { plot: PlotTab::Fit, ..PlotSettings::default() }));
    window(state)
}

fn open_data(window: &mut Harness<'_, App>, path: &Path) {
    window.get_by_label("Own data…").click();
    window.run_ok();
    type_into(window, "Path", path.to_str().expect("a plain path"));
    wait_for_file(window);
}

fn own_data_are_fitted_and_shown() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = measured(folder.path(), &["T", "d", "dphi", "dtheta"]);
    let mut window = fit_window(FitSettings::default());
    settle(&mut window);
    open_data(&mut window, &path);
    settle(&mut window);
    label_starting_with(&window, "Data from measured.csv");
    for (symbol, truth) in [("β", 0.7), ("y", 4.0), ("z", 1.0)] {
        let value = shown(&window, &format!("Fitted {symbol}"));
        let uncertainty = shown(&window, &format!("Uncertainty of {symbol}"));
        assert!((value - truth).abs() < 5.0 * uncertainty, "{symbol} = {value} +- {uncertainty}");
    }
    // Nobody knows the truth here.
    assert!(!labels(&window).iter().any(|label| label.starts_with("True ") || label.contains("biases it")));
    for name in ["Fit of Δφ against T", "Residuals of Δφ against T", "Fit of Δθ against T"] {
        assert!(window.get_by_label(name).rect().height() > 40.0, "{name}");
    }
    let outcome = window.state().fitting().shown().expect("a fit").clone();
    assert_eq!(outcome.data.map(|data| data.len()), [120, 120]);
    window.render().expect("a picture");
    // Another model fits them, too, and badly.
    window.state_mut().run(SettingsCommand::Fit(FitSettings { model: APPENDIX_A, ..FitSettings::default() }));
    settle(&mut window);
    assert!((shown(&window, "Fitted β") - 0.7).abs() > 0.01);
    window.get_by_label("Simulated").click();
    window.run_ok();
    settle(&mut window);
    assert_eq!(shown(&window, "True β"), 0.9);
}

fn the_saved_fit_is_that_of_the_command_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let (with_sigmas, json) =
        (["T", "d", "dphi", "sigma_dphi", "dtheta", "sigma_dtheta"], folder.path().join("fit.json"));
    for (columns, arguments) in [
        (&with_sigmas[..], &["--json"][..]),
        (&["T", "dphi", "dtheta"][..], &["--json", "--d=0.1", "--fit-x0"][..]),
        // Too many of its replicates have no fit, and the window says so.
        (&["T", "dtheta"][..], &["--json", "--d=0.1", "--model=published", "--bootstrap=0"][..]),
    ] {
        let path = measured(folder.path(), columns);
        let setup = FitSettings {
            model: if arguments.contains(&"--model=published") { APPENDIX_A } else { Model::Exact },
            fit_x0: arguments.contains(&"--fit-x0"),
            ..FitSettings::default()
        };
        let mut window = fit_window(setup);
        open_data(&mut window, &path);
        settle(&mut window);
        let text = save(&mut window, "Save fit…", &json);
        let is_bootstrapped = !arguments.contains(&"--bootstrap=0");
        assert!(text.starts_with("Saved fit.json."), "{text}");
        assert_eq!(text == "Saved fit.json.", is_bootstrapped, "{text}");
        let file = path.to_str().expect("a plain path");
        let expected = gamow(&[&["fit", file], arguments].concat());
        assert_eq!(std::fs::read_to_string(&json).expect("it is there"), expected);
        std::fs::remove_file(&json).expect("removed");
    }
}

fn the_plotted_samples_are_saved_and_fitted_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let [csv, svg, of_samples, of_file] =
        ["fit.csv", "fit.svg", "samples.json", "file.json"].map(|name| folder.path().join(name));
    let mut window = fit_window(FitSettings { fit_samples: 60, ..FitSettings::default() });
    settle(&mut window);
    save(&mut window, "Save plots as CSV…", &csv);
    save(&mut window, "Save plots as SVG…", &svg);
    save(&mut window, "Save fit…", &of_samples);
    let svg = std::fs::read_to_string(svg).expect("text");
    assert!(svg.contains("sample − fit") && svg.contains("95 % band"));
    open_data(&mut window, &csv);
    settle(&mut window);
    save(&mut window, "Save fit…", &of_file);
    let text = |path: &Path| std::fs::read_to_string(path).expect("text");
    assert_eq!(text(&of_samples), text(&of_file));
    // What is left over is what its rows say.
    let rows = text(&csv).lines().skip(1).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(rows.len(), 60);
    for row in rows {
        let numbers: Vec<f64> = row.split(',').map(|cell| cell.parse().expect("a number")).collect();
        let [.., dphi, fitted, residual, _, _, _] = numbers[..] else { panic!("{row}") };
        assert!((dphi - fitted - residual).abs() < 1e-15, "{row}");
    }
}

fn click_at(window: &mut Harness<'_, App>, place: Pos2) {
    window.hover_at(place);
    window.step();
    window.drag_at(place);
    window.drop_at(place);
    window.run_ok();
}

fn a_click_on_a_reading_leaves_it_out_and_takes_it_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = measured(folder.path(), &["T", "d", "dphi", "dtheta"]);
    let rows = std::fs::read_to_string(&path).expect("text");
    let mut rows: Vec<Vec<String>> =
        rows.lines().map(|row| row.split(',').map(str::to_owned).collect()).collect();
    // A gross outlier of dtheta, higher than all others, in the line after the header and 60 samples.
    let without = |rows: &[Vec<String>]| rows.iter().map(|row| row.join(",") + "\n").collect::<String>();
    "0.9".clone_into(&mut rows[61][3]);
    std::fs::write(&path, without(&rows)).expect("written");
    let mut window = fit_window(FitSettings::default());
    open_data(&mut window, &path);
    settle(&mut window);
    let readings = |window: &Harness<'_, App>| {
        window.state().fitting().shown().expect("a fit").data.clone().map(|data| data.len())
    };
    assert_eq!(readings(&window), [120, 120]);
    label_starting_with(&window, "A reading stands out, in standard deviations: dtheta in line 62 by ");
    assert!(labels(&window).iter().any(|label| label == "A click on a reading in the plots leaves it out."));
    // Clicks beside readings go to a T, and so say where T is in the plot.
    let plot = window.get_by_label("Fit of Δθ against T").rect();
    let time_at = |window: &mut Harness<'_, App>, x: f32| {
        click_at(window, pos2(x, plot.min.y + 4.0));
        window.state().state().document.time
    };
    let [left, right] = [0.7, 0.9].map(|part| plot.min.x + part * plot.width());
    let [first, last] = [left, right].map(|x| time_at(&mut window, x));
    let time: f64 = rows[61][0].parse().expect("a number");
    let x = left + ((time - first) / (last - first)) as f32 * (right - left);
    let left_out = |window: &Harness<'_, App>| {
        let data = window.state().state().session.data.clone().expect("own data");
        data.left_out.iter().map(|left| (left.sample, left.curve)).collect::<Vec<_>>()
    };
    let heights = (6..60).step_by(4).map(|y| plot.min.y + y as f32);
    let found = heights.into_iter().find(|&y| {
        click_at(&mut window, pos2(x, y));
        !left_out(&window).is_empty()
    });
    let place = pos2(x, found.expect("the highest reading is near the top"));
    let before = window.state().state().document.time;
    settle(&mut window);
    assert_eq!((left_out(&window), readings(&window)), (vec![(60, 1)], [120, 119]));
    assert!(labels(&window).iter().any(|label| label.starts_with("Left out by hand: dtheta in line 62.")));
    // As if it had not been taken.
    let json = folder.path().join("fit.json");
    save(&mut window, "Save fit…", &json);
    let saved = std::fs::read_to_string(&json).expect("text");
    assert!(saved.contains("left out by hand: dtheta in line 62"), "{saved}");
    rows[61][3] = String::new();
    std::fs::write(&path, without(&rows)).expect("written");
    let expected = gamow(&["fit", "--json", path.to_str().expect("a plain path")]);
    let parameters = |text: &str| -> serde_json::Value {
        serde_json::from_str::<serde_json::Value>(text).expect("JSON")["parameters"].clone()
    };
    assert_eq!(parameters(&saved), parameters(&expected));
    click_at(&mut window, place);
    settle(&mut window);
    assert_eq!((left_out(&window), readings(&window)), (vec![], [120, 120]));
    assert_eq!(window.state().state().document.time, before, "T stays where it is");
}

fn a_dropped_csv_file_is_data() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = measured(folder.path(), &["T", "d", "dphi", "dtheta"]);
    let mut window = window(cyclist(0.9));
    let before = window.state().state().clone();
    open(&mut window, &path);
    window.run_ok();
    settle(&mut window);
    let State { document, .. } = window.state().state();
    assert_eq!(document.settings.plots.plot, PlotTab::Fit);
    assert_eq!(document.scene, before.document.scene);
    label_starting_with(&window, "Fitted β");
    // They stay while scenes come and go.
    window.state_mut().run(ShowCommand::Scene("cube"));
    window.run_ok();
    assert!(window.state().state().session.data.is_some());
}

fn the_plotted_curves_are_saved_and_fitted() {
    let folder = tempfile::tempdir().expect("a folder");
    let csv = folder.path().join("curves.csv");
    // In metres and nanoseconds, with the head tilted: what is fitted is in the scene's own units.
    let mut state = cyclist(0.9);
    state.document.settings.window.units = Units::Metric;
    state.document.settings.motion.roll = 20.0;
    state.document.settings.plots = PlotSettings { plot: PlotTab::Disparity, ..PlotSettings::default() };
    let mut window = window(state);
    save(&mut window, "Save plots as CSV…", &csv);
    let told = gamow(&["fit", "--json", "--bootstrap=0", csv.to_str().expect("a plain path")]);
    let told: serde_json::Value = serde_json::from_str(&told).expect("JSON");
    for (key, expected) in [("beta", 0.9), ("y", 3.0), ("z", 2.0)] {
        let found = told["parameters"][key]["value"].as_f64().expect("it is fitted");
        assert!((found - expected).abs() < 1e-6, "{key}: {told}");
    }
    open(&mut window, &csv);
    settle(&mut window);
    assert!((shown(&window, "Fitted β") - 0.9).abs() < 1e-3);
}

fn what_is_wrong_in_own_data_is_located() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("measured.csv");
    let mut window = fit_window(FitSettings::default());
    for (text, expected) in [
        (
            "T,dphi\n0,-0.1\n1,x\n",
            ":3: column dphi: \"x\" is not a number; it should be one such as 0.9 or 1e-3",
        ),
        (
            "T,phi\n",
            ":1: column dphi or dtheta is missing; the header should name T, dphi or dtheta, and d unless --d gives it, and it names T, phi",
        ),
    ] {
        std::fs::write(&path, text).expect("written");
        open(&mut window, &path);
        let text = message(&mut window);
        assert_eq!(text, format!("measured.csv{expected}"));
        assert!(window.state().state().session.data.is_none());
    }
    // What can be read but not fitted is said in the tab.
    std::fs::write(&path, "T,dphi\n0,-0.1\n1,-0.2\n").expect("written");
    open(&mut window, &path);
    window.run_ok();
    settle(&mut window);
    window.get_by_label("No fit");
    window.get_by_label("2 samples of dphi are too few: 3 parameters need at least 6.");
}

fn what_own_data_do_not_tell_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = fit_window(FitSettings { curves: Curves::Both, ..FitSettings::default() });
    let path = measured(folder.path(), &["T", "dphi"]);
    open_data(&mut window, &path);
    settle(&mut window);
    for words in [
        "The file has no sigmas: each reading is assumed as uncertain as the residuals suggest.",
        "The file has no column d: the eyes are d = 0.1 apart, as set.",
        "x₀ is fixed at 0: the point is level with you at t = 0.",
    ] {
        assert!(labels(&window).iter().any(|label| label == words), "{words}");
    }
    // As far apart as the eyes really were, they tell the distance.
    let motion = MotionSettings { d: 0.2, ..window.state().state().document.settings.motion };
    window.state_mut().run(SettingsCommand::Motion(motion));
    settle(&mut window);
    let (value, uncertainty) = (shown(&window, "Fitted y"), shown(&window, "Uncertainty of y"));
    assert!((value - 4.0).abs() < 5.0 * uncertainty, "y = {value} +- {uncertainty}");
    let path = measured(folder.path(), &["T", "d", "dphi", "sigma_dphi"]);
    open(&mut window, &path);
    settle(&mut window);
    assert!(labels(&window).iter().any(|label| label.starts_with("χ² per degree of freedom: ")));
    assert!(!labels(&window).iter().any(|label| label.starts_with("The file has no ")));
}

fn the_papers_own_fit_is_repeated() {
    let setup = FitSettings { model: APPENDIX_A, noise_percent: 0.0, ..FitSettings::default() };
    let mut window = fit_window(setup);
    settle(&mut window);
    assert!((shown(&window, "Fitted β") - 0.9).abs() > 0.01);
    window.get_by_label("Data from").click();
    window.run_ok();
    window.get_by_label("from published").click();
    window.run_ok();
    settle(&mut window);
    for (symbol, truth) in [("β", 0.9), ("y", 3.0), ("z", 2.0)] {
        assert!((shown(&window, &format!("Fitted {symbol}")) - truth).abs() < 1e-9, "{symbol}");
    }
    assert!(!labels(&window).iter().any(|label| label.contains("biases it")));
    // And the exact model has parallax that these data leave out.
    let setup = window.state().state().document.settings.fit;
    window.state_mut().run(SettingsCommand::Fit(FitSettings { model: Model::Exact, ..setup }));
    settle(&mut window);
    window.get_by_label("No fit");
    label_starting_with(&window, "It has parallax where the data leave it out. Even without noise: ");
}
