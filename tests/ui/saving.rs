//! What leaves the window, by the menu and by keys: each file is read back, each command is run. Dialogs of
//! the system cannot be driven from here; paths are typed.

use std::path::{Path, PathBuf};
use std::process::Command as Program;
use std::time::Duration;

use eframe::egui::{Key, Modifiers, OutputCommand};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{Command, PlaybackCommand, SettingsCommand, WindowCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::files::purpose::Product;
use gamow::app::state::lesson::LessonCommand;
use gamow::eye::Eye;
use gamow::files::png::PngFile;
use gamow::flags::TimeRange;
use gamow::flags::choices::{FileKind, Layout, RendererChoice};
use gamow::flags::words::words;
use gamow::lesson::Library;
use gamow::settings::{MotionSettings, PlaybackSettings, PlotSettings, PlotTab, QualitySettings, Settings};

use super::Test;
use super::support::{cyclist, in_layout, labels, type_into, wait_for, wait_for_file, window};

pub const TESTS: &[Test] = trials![
    a_saved_picture_opens_as_the_state_that_it_shows,
    a_saved_picture_has_the_pixels_of_the_views,
    a_saved_state_opens_as_it_was,
    a_file_that_is_there_is_replaced_only_when_asked,
    what_cannot_be_written_is_said_and_leaves_nothing,
    #[cfg(unix)]
    nothing_is_saved_to_a_pipe_that_nobody_reads,
    films_have_the_frames_of_the_loop,
    a_film_of_ten_seconds_has_the_passage_just_shown_and_tells_its_size_before,
    a_stopped_film_leaves_no_file,
    the_copied_commands_give_the_same_again,
    the_copied_curve_command_gives_the_plotted_numbers,
    the_copied_values_are_those_of_the_moment,
    the_copied_picture_is_that_of_the_views,
    what_is_typed_first_is_the_name,
    saved_plots_hold_the_numbers_of_the_core,
    a_file_is_opened_by_its_path,
    opening_and_saving_can_be_left,
];

/// Chooses `entry` of the menu.
pub fn choose(window: &mut Harness<'_, App>, entry: &str) {
    window.get_by_label("File").click();
    window.run_ok();
    window.get_by_label(entry).click();
    window.run_ok();
}

/// Frames until a message stands there and nothing is left to do; the message.
pub fn message(window: &mut Harness<'_, App>) -> String {
    let notice = |window: &Harness<'_, App>| window.state().state().scratch.notice.clone();
    wait_for(window, "a message", |window| notice(window).is_some() && window.state().is_settled());
    notice(window).expect("it was waited for").text
}

/// Saves what `entry` says at `path`; the message.
pub fn save(window: &mut Harness<'_, App>, entry: &str, path: &Path) -> String {
    choose(window, entry);
    type_into(window, "Path", path.to_str().expect("a plain path"));
    message(window)
}

/// The text that was copied in the last frame, if any was.
fn copied(window: &Harness<'_, App>) -> Option<String> {
    window.output().platform_output.commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    })
}

/// Copies what `entry` says.
fn copy(window: &mut Harness<'_, App>, entry: &str) -> String {
    window.get_by_label("File").click();
    window.run_ok();
    window.get_by_label(entry).click();
    for _ in 0..8 {
        window.step();
        if let Some(text) = copied(window) {
            return text;
        }
    }
    panic!("nothing was copied");
}

/// A state that differs from the usual in several ways.
fn special() -> State {
    let mut state = cyclist(0.8);
    state.run(SettingsCommand::Motion(MotionSettings {
        d: 0.3,
        height_shift: -0.5,
        ..state.document.settings.motion
    }));
    state.run(PlaybackCommand::GoTo(5.25));
    state
}

/// A point of the tyre of a wheel that rolls is selected.
fn on_a_wheel() -> State {
    let mut state = State::open(Settings::default()).expect("a preset");
    let tyre = state.document.scene.names.iter().position(|name| name == "front tyre").expect("a tyre");
    let track = state.document.scene.track_on(tyre).expect("a body");
    state.document.points.choose(track, tyre, false);
    state
}

fn names_in(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

fn opened(path: &Path) -> State {
    let settings = Settings::default().with_file(path).expect("it is a state");
    State::open(settings).expect("its scene is there")
}

fn a_saved_picture_opens_as_the_state_that_it_shows() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("ride.png");
    let mut window = window(special());
    window.key_press_modifiers(Modifiers::COMMAND, Key::S);
    window.run_ok();
    type_into(&mut window, "Path", path.to_str().expect("a plain path"));
    assert_eq!(message(&mut window), "Saved ride.png.");
    assert_eq!(names_in(folder.path()), ["ride.png"]);
    let (shown, again) = (window.state().state(), opened(&path));
    assert_eq!(again.document.settings.motion, shown.document.settings.motion);
    assert_eq!(again.document.time, shown.document.time);
    assert_eq!(again.document.scene.name, shown.document.scene.name);
    assert_eq!(again.document.points.selected().track, shown.document.points.selected().track);
    // What follows something is recorded as where it was.
    let size = shown.frame.picture.size;
    for eye in Eye::BOTH {
        assert_eq!(again.view(eye, size), shown.view(eye, size));
    }
}

fn a_saved_picture_has_the_pixels_of_the_views() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("left.png");
    let mut state = special();
    state.run(in_layout(Layout::Left));
    let mut window = window(state);
    let size = window.state().state().frame.picture.size;
    save(&mut window, "Save picture…", &path);
    assert_eq!(PngFile::read(&path).expect("a picture").picture().size, size);
    // Another size is typed.
    choose(&mut window, "Save picture…");
    window.state_mut().run(WindowCommand::Close);
    window.run_ok();
    choose(&mut window, "Save picture…");
    let field = "Size of a picture";
    window.get_by_role_and_label(eframe::egui::accesskit::Role::TextInput, field).click();
    window.run_ok();
    window.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.get_by_role_and_label(eframe::egui::accesskit::Role::TextInput, field).type_text("64x48");
    window.run_ok();
    type_into(&mut window, "Path", folder.path().join("small").to_str().expect("a plain path"));
    assert_eq!(message(&mut window), "Saved small.png.");
    let small = PngFile::read(&folder.path().join("small.png")).expect("a picture");
    assert_eq!(small.picture().size, [64, 48]);
    // `gamow render` makes the same of what it records.
    let again = folder.path().join("again.png");
    gamow(&words(small.command())[1..], &["--out", again.to_str().expect("a plain path")]);
    assert_eq!(PngFile::read(&again).expect("a picture").frames, small.frames);
}

fn gamow(arguments: &[String], more: &[&str]) -> String {
    let output =
        Program::new(env!("CARGO_BIN_EXE_gamow")).args(arguments).args(more).output().expect("it starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

fn a_saved_state_opens_as_it_was() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("ride.toml");
    let mut window = window(special());
    window.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    window.run_ok();
    type_into(&mut window, "Path", path.to_str().expect("a plain path"));
    assert_eq!(message(&mut window), "Saved ride.toml.");
    assert_eq!(opened(&path).shown(), window.state().state().shown());
}

fn a_file_that_is_there_is_replaced_only_when_asked() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("ride.toml");
    std::fs::write(&path, "precious").expect("written");
    let mut window = window(special());
    choose(&mut window, "Save state…");
    type_into(&mut window, "Path", path.to_str().expect("a plain path"));
    window.get_by_label("ride.toml exists already.");
    assert_eq!(std::fs::read_to_string(&path).expect("text"), "precious");
    window.get_by_label("Replace it").click();
    window.run_ok();
    assert_eq!(message(&mut window), "Saved ride.toml.");
    assert_eq!(opened(&path).shown(), window.state().state().shown());
}

fn what_cannot_be_written_is_said_and_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = window(special());
    let cases = [
        (
            folder.path().join("nowhere/ride.toml"),
            format!("There is no folder {}.", folder.path().join("nowhere").display()),
        ),
        (folder.path().join("ride.png"), "The name of such a file ends in .toml.".to_owned()),
        (PathBuf::from(" "), "A path is needed.".to_owned()),
    ];
    for (path, remark) in cases {
        choose(&mut window, "Save state…");
        type_into(&mut window, "Path", path.to_str().expect("a plain path"));
        window.get_by_label(&remark);
        window.key_press(Key::Escape);
        window.run_ok();
        assert_eq!(window.state().state().scratch.chooser, None);
    }
    assert!(names_in(folder.path()).is_empty());
}

#[cfg(unix)]
fn nothing_is_saved_to_a_pipe_that_nobody_reads() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = window(special());
    for (entry, name) in [("Save state…", "ride.toml"), ("Save picture…", "ride.png")] {
        let path = folder.path().join(name);
        let made = std::process::Command::new("mkfifo").arg(&path).status();
        assert!(made.expect("there is mkfifo").success());
        // A window that waits gets its reader in the end, and has not said what it should.
        let reader = path.clone();
        std::thread::spawn(move || {
            std::thread::sleep(Duration::from_mins(1));
            std::fs::read(reader)
        });
        choose(&mut window, entry);
        type_into(&mut window, "Path", path.to_str().expect("a plain path"));
        window.get_by_label("Replace it").click();
        window.run_ok();
        let right = "Nothing was saved: it is a device or a pipe; an ordinary file would be right.";
        assert_eq!(message(&mut window), right);
    }
}

/// A short loop in small pictures.
fn short_loop() -> State {
    let mut state = cyclist(0.9);
    state.run(in_layout(Layout::Left));
    state.run(SettingsCommand::Playback(PlaybackSettings {
        rate: 10.0,
        range: TimeRange(Some([2.0, 6.0])),
        ..state.document.settings.playback
    }));
    state
}

/// Types 48x36 for the size of a picture, in the window that asks for a path.
fn small(window: &mut Harness<'_, App>) {
    let field = || eframe::egui::accesskit::Role::TextInput;
    window.get_by_role_and_label(field(), "Size of a picture").click();
    window.run_ok();
    window.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.get_by_role_and_label(field(), "Size of a picture").type_text("48x36");
    window.run_ok();
}

/// The size of a file, or of all files in a folder.
fn bytes_at(path: &Path) -> u64 {
    if path.is_dir() {
        return names_in(path).iter().map(|name| bytes_at(&path.join(name))).sum();
    }
    path.metadata().expect("it is there").len()
}

fn films_have_the_frames_of_the_loop() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = window(short_loop());
    // 4 units of T at 10 a second, 25 frames a second.
    for name in ["ride.gif", "ride.mp4", "ride.png", "ride"] {
        choose(&mut window, "Save film…");
        assert!(labels(&window).iter().any(|label| label.contains("10 frames, 0.4 s, about ")));
        small(&mut window);
        type_into(&mut window, "Path", folder.path().join(name).to_str().expect("a plain path"));
        let text = message(&mut window);
        let rest = text.strip_prefix(&format!("Saved {name}: 10 frames, 0.4 s, "));
        let (size, _) = rest.and_then(|rest| rest.split_once(" kB.")).unwrap_or_else(|| panic!("{text}"));
        let size = 1000.0 * size.parse::<f64>().expect("a number");
        let on_disc = bytes_at(&folder.path().join(name)) as f64;
        assert!((size / on_disc - 1.0).abs() < 0.06, "{text}: {on_disc}");
    }
    assert_eq!(names_in(folder.path()), ["ride", "ride.gif", "ride.mp4", "ride.png"]);

    let file = std::fs::File::open(folder.path().join("ride.gif")).expect("it is there");
    let mut gif = gif::DecodeOptions::new().read_info(file).expect("a GIF");
    assert_eq!((gif.width(), gif.height()), (48, 36));
    let mut delays = Vec::new();
    while let Some(frame) = gif.read_next_frame().expect("a whole GIF") {
        delays.push(frame.delay);
    }
    assert_eq!(delays, [4; 10]);

    let file =
        std::io::BufReader::new(std::fs::File::open(folder.path().join("ride.png")).expect("it is there"));
    let reader = png::Decoder::new(file).read_info().expect("a PNG");
    assert_eq!(reader.info().animation_control().map(|control| control.num_frames), Some(10));

    // The frames are those that T runs through, the last of them one step before the first again.
    let sequence = folder.path().join("ride");
    let frames = names_in(&sequence);
    assert_eq!((frames.len(), frames[9].as_str()), (10, "frame_00009.png"));
    for (number, frame) in frames.iter().enumerate() {
        let time = opened(&sequence.join(frame)).document.time;
        assert!((time - (2.0 + 0.4 * number as f64)).abs() < 1e-12, "{frame}: T = {time}");
    }
    let first = PngFile::read(&sequence.join("frame_00000.png")).expect("a picture").frames;
    let film = PngFile::read(&folder.path().join("ride.png")).expect("a film");
    assert_eq!(film.picture(), &first[0]);
    assert_eq!(opened(&folder.path().join("ride.png")).document.time, 2.0);
}

fn a_film_of_ten_seconds_has_the_passage_just_shown_and_tells_its_size_before() {
    let mut state = State::open(Settings::default()).expect("defaults");
    state.begin_lesson(&Library::own().open("rods").expect("a lesson")).expect("it begins");
    assert_eq!(state.film(Product::TenSeconds), ([-10.0, 32.0], 250), "the whole range, before the reveal");
    for command in [LessonCommand::Skip, LessonCommand::Forward] {
        state.run(Command::Lesson(command));
    }
    assert_eq!(state.film(Product::TenSeconds), ([-8.5, -4.5], 250));
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = window(state);
    window.key_press_modifiers(Modifiers::COMMAND, Key::F);
    window.run_ok();
    small(&mut window);
    let told =
        labels(&window).into_iter().find(|label| label.starts_with("T = −8.5 to −4.5 in 10 s: 250 frames"));
    let told = told.unwrap_or_else(|| panic!("{:?}", labels(&window)));
    let megabytes =
        told.split_once(", about ").and_then(|(_, rest)| rest.split_once(" MB. The name ends in "));
    let megabytes = megabytes.and_then(|(number, _)| number.parse::<f64>().ok());
    let path = folder.path().join("ten.gif");
    type_into(&mut window, "Path", path.to_str().expect("a plain path"));
    let text = message(&mut window);
    assert!(text.starts_with("Saved ten.gif: 250 frames, 10.0 s, "), "{text}");
    let ratio = megabytes.expect("a number") * 1e6 / bytes_at(&path) as f64;
    assert!((0.5..2.0).contains(&ratio), "{told} {ratio}");
}

fn a_stopped_film_leaves_no_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut state = short_loop();
    state.run(SettingsCommand::Playback(PlaybackSettings { rate: 0.05, ..state.document.settings.playback }));
    // Its frames take long: the window is seen before their size is known.
    state.run(SettingsCommand::Quality(QualitySettings {
        renderer: RendererChoice::Reference,
        ..state.document.settings.quality
    }));
    let mut window = window(state);
    choose(&mut window, "Save film…");
    type_into(&mut window, "Path", folder.path().join("ride.gif").to_str().expect("a plain path"));
    wait_for(&mut window, "it can be stopped", |window| window.query_by_label("Stop").is_some());
    window.get_by_label_contains("Saving ride.gif");
    let place = |window: &Harness<'_, App>| window.get_by_label("Stop").rect();
    let first = place(&window);
    wait_for(&mut window, "a size is expected", |window| {
        window.query_by_label_contains("in all, judging by the frames so far").is_some()
    });
    // What is learnt on the way moves nothing: the button stays under the pointer.
    assert_eq!(place(&window), first);
    window.get_by_label("Stop").click();
    assert_eq!(message(&mut window), "Stopped: no file was written.");
    // The thread has ended with the window.
    drop(window);
    assert!(names_in(folder.path()).is_empty(), "{:?}", names_in(folder.path()));
}

fn the_copied_commands_give_the_same_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = window(special());
    let command = copy(&mut window, "Copy command");
    assert!(command.starts_with("gamow --scene=cyclist "), "{command}");
    let again = Settings::default().with_command(&command, "the clipboard").expect("a command of ours");
    assert_eq!(again.motion, window.state().state().document.settings.motion);
    assert_eq!(again.time, Some(5.25));
    // Keys do it, too.
    window.event(eframe::egui::Event::Copy);
    window.step();
    assert_eq!(copied(&window).as_deref(), Some(command.as_str()));

    let render = copy(&mut window, "Copy render command");
    let [rendered, saved] = ["rendered.png", "saved.png"].map(|name| folder.path().join(name));
    gamow(&words(&render)[1..], &["--out", rendered.to_str().expect("a plain path")]);
    save(&mut window, "Save picture…", &saved);
    let pixels = |path: &Path| PngFile::read(path).expect("a picture").frames;
    assert!(pixels(&rendered) == pixels(&saved));
}

/// The rows of a CSV file without text, by the names of its columns.
fn table(csv: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let mut lines = csv.lines();
    let names = lines.next().expect("a header").split(',').map(str::to_owned).collect();
    let number = |cell: &str| cell.parse().unwrap_or(f64::NAN);
    (names, lines.map(|line| line.split(',').map(number).collect()).collect())
}

fn the_copied_curve_command_gives_the_plotted_numbers() {
    let mut tilted = special();
    tilted.run(SettingsCommand::Motion(MotionSettings { roll: 30.0, ..tilted.document.settings.motion }));
    for state in [special(), tilted, on_a_wheel()] {
        let mut window = window(state);
        let command = copy(&mut window, "Copy curve command");
        assert_eq!(
            command.contains("--wheel-radius"),
            window.state().state().document.settings.scene == "street"
        );
        let (names, rows) = table(&gamow(&words(&command)[1..], &[]));
        let column = |name: &str| names.iter().position(|found| found == name).expect("it is there");
        let state = window.state().state();
        let point = state.document.points.selected();
        let [from, to] = state.time_range();
        assert_eq!([rows[0][column("T")], rows[rows.len() - 1][column("T")]], [from, to]);
        for row in rows {
            let mut then = state.clone();
            then.run(PlaybackCommand::GoTo(row[column("T")]));
            let both = then.disparity(point).expect("in the domain");
            assert_eq!([row[column("dphi")], row[column("dtheta")]], [both.dphi, both.dtheta]);
            assert_eq!(row[column("doppler_left")], both.primary.doppler_factor);
            assert_eq!(row[column("phi_right")], both.secondary.phi());
        }
    }
}

fn the_copied_values_are_those_of_the_moment() {
    let mut window = window(special());
    let text = copy(&mut window, "Copy values");
    let (names, rows) = table(&text.replace('\t', ","));
    let value = |name: &str| rows[0][names.iter().position(|found| found == name).expect("it is there")];
    let state = window.state().state();
    let both = state.disparity(state.document.points.selected()).expect("in the domain");
    assert_eq!([value("T"), value("beta"), value("d")], [5.25, 0.8, 0.3]);
    assert_eq!([value("dphi"), value("dtheta")], [both.dphi, both.dtheta]);
    assert_eq!(value("tau_left"), both.primary.proper_time);
}

fn the_copied_picture_is_that_of_the_views() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("ride.png");
    let mut window = window(special());
    save(&mut window, "Save picture…", &path);
    let saved = PngFile::read(&path).expect("a picture").frames.remove(0);
    window.get_by_label("File").click();
    window.run_ok();
    window.get_by_label("Copy picture").click();
    let mut copied = None;
    wait_for(&mut window, "a picture is copied", |window| {
        let commands = &window.output().platform_output.commands;
        copied = commands.iter().find_map(|command| match command {
            OutputCommand::CopyImage(image) => Some(image.clone()),
            _ => None,
        });
        copied.is_some()
    });
    let copied = copied.expect("it was waited for");
    assert_eq!(copied.size, saved.size.map(|side| side as usize));
    let pixels: Vec<[u8; 4]> = copied.pixels.iter().map(eframe::egui::Color32::to_array).collect();
    assert!(pixels == saved.rgba);
}

fn what_is_typed_first_is_the_name() {
    let mut window = window(special());
    choose(&mut window, "Save state…");
    window.get_by_label("Path").type_text("ride");
    window.run_ok();
    let path = labels(&window).into_iter().find(|label| label.ends_with("ride.toml"));
    let folder = std::env::current_dir().expect("a folder");
    assert_eq!(path.map(PathBuf::from), Some(folder.join("ride.toml")));
}

fn saved_plots_hold_the_numbers_of_the_core() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = window(special());
    let [csv, svg] = ["plots.csv", "plots.svg"].map(|name| folder.path().join(name));
    assert_eq!(save(&mut window, "Save plots as CSV…", &csv), "Saved plots.csv.");
    assert_eq!(save(&mut window, "Save plots as SVG…", &svg), "Saved plots.svg.");
    let svg = std::fs::read_to_string(svg).expect("text");
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "{}", &svg[..60]);
    // (The names of its columns have commas in them.)
    let (_, rows) = table(&std::fs::read_to_string(csv).expect("text"));
    assert!(rows.len() > 60, "{}", rows.len());
    let state = window.state().state();
    for row in rows {
        let mut then = state.clone();
        then.run(PlaybackCommand::GoTo(row[0]));
        let both = then.disparity(state.document.points.selected()).expect("in the domain");
        assert_eq!(row[1..3], [both.dphi, both.dtheta]);
        // What `gamow fit` reads: T, the separation, and both disparities.
        assert_eq!(row[3..], [row[0], state.document.settings.motion.d, both.dphi, both.dtheta]);
    }
}

fn a_file_is_opened_by_its_path() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("ride.toml");
    let mut first = window(special());
    save(&mut first, "Save state…", &path);
    let mut window = window(cyclist(0.1));
    window.key_press_modifiers(Modifiers::COMMAND, Key::O);
    window.run_ok();
    type_into(&mut window, "Path", folder.path().join("other.toml").to_str().expect("a plain path"));
    window.get_by_label(&format!("There is no file {}.", folder.path().join("other.toml").display()));
    type_into(&mut window, "Path", path.to_str().expect("a plain path"));
    wait_for_file(&mut window);
    assert_eq!(
        window.state().state().document.settings.motion,
        first.state().state().document.settings.motion
    );
    assert!(window.query_by_label("Path").is_none());
    assert_eq!(FileKind::from_path(&path), None);
}

fn opening_and_saving_can_be_left() {
    let mut state = special();
    state.run(SettingsCommand::Plots(PlotSettings {
        plot: PlotTab::Disparity,
        ..state.document.settings.plots
    }));
    let mut window = window(state);
    for entry in ["Open…", "Own data…", "Save picture…", "Save film…", "Save state…"] {
        choose(&mut window, entry);
        window.get_by_label("Path");
        window.get_by_label("Browse…");
        window.get_by_label("Cancel").click();
        window.run_ok();
        assert!(window.query_by_label("Path").is_none(), "{entry}");
    }
    // There is no fit to be saved unless one is shown.
    window.get_by_label("File").click();
    window.run_ok();
    window.get_by_label("Save fit…").click();
    window.run_ok();
    assert!(window.query_by_label("Path").is_none());
}
