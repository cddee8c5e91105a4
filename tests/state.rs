//! The window and `gamow render` show the same of the same settings, wherever these come from.

use std::path::Path;

use clap::{Parser, ValueEnum as _};
use gamow::app::commands::{FileCommand, PlaybackCommand, PointsCommand, SettingsCommand, ShowCommand};
use gamow::app::shell::args::WindowArgs;
use gamow::app::state::State;
use gamow::app::state::pointer::Select;
use gamow::cli::Cli;
use gamow::eye::Eye;
use gamow::files::png::PngFile;
use gamow::flags::choices::{GazeChoice, Layout};
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::scene::{PRESETS, Scene, Track};
use gamow::settings::{LightSettings, Preset, Settings, Subject, Theme};
use relativity_render::camera::MAX_SLANT;
use relativity_render::{Geometry, Motion, PreparedScene, View};

use crate::support::sweep;

const SIZE: [u32; 2] = [960, 720];

/// What the window shows both eyes of `settings` when it starts.
fn in_window(settings: Settings) -> [View; 2] {
    let state = State::open(settings).expect("the scene is there");
    Eye::BOTH.map(|eye| state.view(eye, SIZE))
}

/// What `gamow render` draws of them, by the command that it records.
fn in_picture(settings: &Settings) -> [View; 2] {
    let scene = Scene::open(&settings.scene).expect("the scene is there");
    let (prepared, tracked) = (scene.prepared(), settings.track(&scene));
    let command = settings
        .resolved(Subject { scene: &prepared, tracked })
        .command(gamow::flags::words::Shell::RECORDED);
    let recorded = Settings::default().with_command(&command, "picture.png").expect("it can be read");
    let time = recorded.time.expect("it is recorded");
    // The gaze and the field are recorded as angles, so that nothing needs to be followed.
    assert!(matches!(recorded.look.gaze, GazeChoice::Fixed(_)), "{command}");
    let (nothing, nowhere) = (PreparedScene::moving(&[]), Track { rest: [f64::NAN; 3], ..tracked });
    recorded.views(Subject { scene: &nothing, tracked: nowhere }, time, recorded.picture.size.0)
}

#[test]
fn the_window_at_its_start_shows_what_is_rendered_to_the_last_digit() {
    let speeds = [
        (SpeedParameter::Beta, 0.0),
        (SpeedParameter::Beta, 0.01),
        (SpeedParameter::Beta, 0.3),
        (SpeedParameter::Beta, 0.9),
        (SpeedParameter::Gamma, 1000.0),
        (SpeedParameter::Gamma, 1e12),
    ];
    let cases = PRESETS.into_iter().flat_map(|scene| speeds.map(|speed| (scene, speed)));
    let cases = cases.flat_map(|case| [0.0, 0.1, 2.0, 10.0].map(|d| (case, d)));
    let geometries = Geometry::value_variants();
    let cases = cases.flat_map(|case| geometries.iter().map(move |&geometry| (case, geometry)));
    for (((scene, (parameter, value)), d), geometry) in sweep(0, 48, cases) {
        let mut settings = Settings { scene: scene.to_owned(), ..Settings::default() };
        settings.motion.speed = SpeedSetting::new(parameter, value).expect("a speed");
        settings.motion.d = d;
        settings.look.geometry = geometry;
        let context = format!("{scene}, {parameter:?} {value}, d = {d}, {geometry:?}");
        assert_eq!(in_window(settings.clone()), in_picture(&settings), "{context}");
        (settings.motion.depth_shift, settings.motion.height_shift) = (0.7, -1.3);
        assert_eq!(in_window(settings.clone()), in_picture(&settings), "{context}, shifted");
    }
}

/// Whatever is selected: with the zero parallax at the point it is at one place in both pictures, and
/// everything is as high in one as in the other.
#[test]
fn in_parallel_pictures_the_selected_point_is_at_one_place_and_nothing_has_vertical_parallax() {
    let mut settings = Settings { scene: "cyclist".to_owned(), ..Settings::default() };
    let mut compared = 0;
    for beta in [0.0, 0.3, 0.9, 0.99] {
        settings.motion.speed = SpeedSetting::new(SpeedParameter::Beta, beta).expect("a speed");
        for (d, gaze) in [(0.0, "whole"), (0.1, "whole"), (0.4, "point"), (0.4, "100,25")] {
            settings.motion.d = d;
            settings.look.gaze = gaze.parse().expect("a gaze");
            for &geometry in Geometry::value_variants() {
                settings.look.geometry = geometry;
                let mut state = State::open(settings.clone()).expect("a preset");
                for time in [-2.0, 0.7, 2.0, 3.6, 5.0] {
                    state.run(PlaybackCommand::GoTo(time));
                    compared += assert_fusible(&state);
                }
            }
        }
    }
    assert!(compared > 300, "{compared} pictures");
}

/// Whether the selected point is in front of both eyes of `state`; and that it is then at one place, unless
/// its lines of sight diverge, as in the paper's model.
fn assert_fusible(state: &State) -> usize {
    let views = Eye::BOTH.map(|eye| state.view(eye, SIZE));
    let place = |rest: [f64; 3]| {
        let point = state.document.points.selected();
        let track = Track { rest, ..point.track };
        let [left, right] = state.document.settings.directions(&track, state.document.time);
        Some([views[0].camera.pixel(left?)?, views[1].camera.pixel(right?)?])
    };
    let is_published = state.document.settings.look.geometry == Geometry::Published;
    let rest = state.document.points.selected().track.rest;
    let Some([left, right]) = place(rest) else { return 0 };
    let context = (state.document.settings.look, state.document.time);
    if state.document.settings.motion.d > 0.0 && !is_published {
        assert!((left[0] - right[0]).abs() < 1e-6, "{left:?}, {right:?}: {context:?}");
    }
    // Further aside pictures turn with the gaze.
    let gaze = views[0].camera.gaze.axes().forward;
    let is_level = gaze.x.abs() <= MAX_SLANT.sin();
    if !is_published && is_level {
        for rest in [rest, [0.3, 3.2, 1.4], [-1.0, 2.5, 2.5]] {
            let Some([left, right]) = place(rest) else { continue };
            assert!((left[1] - right[1]).abs() < 1e-6, "{left:?}, {right:?}: {context:?}");
        }
    }
    1
}

/// The window's command line.
#[derive(Debug, Parser)]
struct Line {
    #[command(flatten)]
    args: WindowArgs,
}

fn started(flags: &[&str], left: Settings) -> State {
    let line = Line::try_parse_from([&["gamow"], flags].concat()).expect("they are flags");
    line.args.state(left).expect("they make a state")
}

#[test]
fn what_is_not_given_is_as_it_was_left_but_beside_a_file_as_usual() {
    let mut left = Settings::default();
    left.motion.d = 0.5;
    left.light.sky = false;
    let state = started(&["--gamma", "3", "--light=on", "--corrected"], left.clone());
    let settings = &state.document.settings;
    assert_eq!((settings.motion.d, settings.light.sky, settings.window.corrected), (0.5, false, true));
    assert_eq!(settings.motion.speed.given(), (SpeedParameter::Gamma, 3.0));

    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let file = folder.path().join("state.toml");
    std::fs::write(&file, "time = 2.5\n[motion]\nbeta = 0.5\n[window]\nplots = false\n")
        .expect("it is writable");
    let state = started(&["--state", file.to_str().expect("a plain path"), "--d", "2"], left);
    let Settings { motion, light, window, .. } = &*state.document.settings;
    assert_eq!((motion.speed.given(), motion.d), ((SpeedParameter::Beta, 0.5), 2.0));
    assert_eq!((light.sky, window.plots, state.document.time), (true, false, 2.5));
}

#[test]
fn a_scene_given_by_a_flag_starts_at_a_time_of_its_own() {
    let left = Settings { time: Some(77.0), point: Some([1.0, 2.0, 3.0]), ..Settings::default() };
    let state = started(&["--scene", "cyclist"], left.clone());
    let cyclist = Scene::preset("cyclist").expect("a preset");
    assert_eq!(
        (state.document.time < 70.0, state.document.points.selected().track.rest),
        (true, cyclist.tracked)
    );
    let state = started(&[], left);
    assert_eq!((state.document.time, state.document.points.selected().track.rest), (77.0, [1.0, 2.0, 3.0]));
}

/// A slide's command line.
#[test]
fn flags_that_name_a_scene_start_from_what_is_usual() {
    let mut left = Settings { scene: "cyclist".to_owned(), time: Some(77.0), ..Settings::default() };
    (left.motion.depth_shift, left.motion.height_shift, left.motion.d) = (-3.0, -2.0, 0.5);
    left.light.sky = false;
    left.picture.layout = Layout::Anaglyph;
    left.window.plots = false;
    for flags in [&["--scene", "street", "--beta", "0.9"][..], &["--scene=cyclist"], &["--state", "overhead"]]
    {
        let shown = |left: Settings| {
            let state = started(flags, left);
            (state.shown(), state.document.preset)
        };
        assert_eq!(shown(left.clone()), shown(Settings::default()), "{flags:?}");
    }
    // As it was left, but for what belongs to the other scene.
    let kept = started(&["--scene", "street", "--keep-settings"], left.clone()).document.settings;
    assert_eq!((kept.motion.depth_shift, kept.motion.height_shift, kept.motion.d), (0.0, 0.0, 0.5));
    assert_eq!((kept.light.sky, kept.picture.layout, kept.window.plots), (false, Layout::Anaglyph, false));
    let same = started(&["--scene", "cyclist", "--keep-settings", "--d", "2"], left.clone());
    assert_eq!((same.document.settings.motion.depth_shift, same.document.settings.motion.d), (-3.0, 2.0));
    assert_eq!(same.document.time, 77.0);
    let state = started(&["--state", "overhead", "--keep-settings"], left.clone()).document.settings;
    let overhead = Preset::named("overhead").expect("a preset").settings.clone().in_place_of(&left);
    assert_eq!(*state, Settings { time: None, ..overhead });
    // Whatever else is given, all is as it was left.
    assert_eq!(started(&["--beta", "0.5"], left.clone()).document.settings.motion.d, 0.5);
}

/// Also one on what rests, and beside the scene's own.
#[test]
fn all_followed_points_are_part_of_what_is_shown() {
    let mut state = State::open(Settings::default()).expect("a preset");
    let names = state.document.scene.names.clone();
    let body = |name: &str| names.iter().position(|own| own == name).expect("there is one");
    let (tyre, last) = (body("rear tyre"), names.len() - 1);
    for (number, body) in [tyre, last, body("front tyre")].into_iter().enumerate() {
        let rest = [0.1 * number as f64, 4.0, -1.5];
        let track = state.document.scene.track_at(rest, body).expect("there is one");
        state.run(PointsCommand::Choose(Select { track, body, add: true }));
    }
    for selected in 0..4 {
        state.run(PointsCommand::Select(selected));
        let shown = state.shown();
        let again = State::open(shown.clone()).expect("a preset");
        assert_eq!(again.document.points, state.document.points);
        // `gamow render` looks at the same one.
        assert_eq!(shown.track(&state.document.scene), state.document.points.selected().track);
        let read = Settings::default().with_toml(&shown.to_toml(), "x.toml").expect("it is right");
        assert_eq!(read, shown);
    }
    // Of a body that is not there nothing is followed.
    let settings = Settings { points: "0,3,2@100000".parse().ok(), ..Settings::default() };
    assert_eq!(State::open(settings).expect("a preset").document.points.all().len(), 1);
}

fn render(folder: &Path, flags: &str) {
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_gamow"));
    let words = ["render", "--renderer=reference", "--samples=1", "--size=48x36"];
    let output = command.current_dir(folder).args(words).args(flags.split_whitespace()).output();
    let output = output.expect("the program starts");
    assert!(output.status.success(), "{flags}: {}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn pictures_and_files_open_in_the_window_and_in_render_alike() {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let path = |name: &str| folder.path().join(name);
    let ball = "name = 'Ball'\n[[object]]\nshape = 'sphere'\ncentre = [0.0, 3.0, 0.5]\nradius = 0.4\n";
    std::fs::write(path("ball.toml"), ball).expect("the folder is writable");
    render(
        folder.path(),
        "--scene ball.toml --beta 0.8 --d 0.7 --height-shift 0.25 --colour false --out a.png",
    );
    render(folder.path(), "--state a.png --out b.png");
    render(folder.path(), "--state a.png --out c.exr");
    render(folder.path(), "--state c.exr --out d.png");
    let bytes = |name: &str| std::fs::read(path(name)).expect("it is there");
    let pixels = |name: &str| PngFile::read(&path(name)).expect("it is there").picture().rgba.clone();
    // The scene is found beside the file, and recorded by the name that it has there.
    assert!(bytes("b.png") == bytes("d.png"));

    let mut shown = Vec::new();
    for name in ["a.png", "b.png", "c.exr"] {
        let mut state = State::open(Settings::default()).expect("a preset");
        state.document.settings.window.plots = false;
        state.run(FileCommand::Open(path(name)));
        assert_eq!(state.scratch.notice, None);
        assert!(!state.document.settings.window.plots, "the window's parts stay as they are");
        assert_eq!(state.document.scene.name, "Ball");
        shown.push(Eye::BOTH.map(|eye| state.view(eye, [48, 36])));
        let file = path("saved.toml");
        std::fs::write(&file, state.shown().to_toml()).expect("the folder is writable");
        render(folder.path(), "--state saved.toml --out again.png");
        assert!(pixels("again.png") == pixels("b.png"), "{name}");
    }
    assert!(shown.windows(2).all(|pair| pair[0] == pair[1]), "{shown:?}");
}

#[test]
fn a_file_that_cannot_be_opened_leaves_all_as_it_was_and_says_why() {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let file = folder.path().join("state.toml");
    for (text, told) in [
        ("[motion]\nd = -1", "state.toml:2: d = -1: must be between 0 and 1e6"),
        ("scene = \"bicycle\"", "no scene is called `bicycle`"),
        ("name = \"x\"", "state.toml:1: a scene needs at least one"),
    ] {
        std::fs::write(&file, text).expect("the folder is writable");
        let mut state = State::open(Settings::default()).expect("a preset");
        let before = state.clone();
        state.run(FileCommand::Open(file.clone()));
        let notice = state.scratch.notice.take().expect("it says why");
        assert!(notice.text.contains(told), "{notice:?}");
        assert_eq!(state, before);
    }
}

#[test]
fn a_preset_is_a_state_by_its_name() {
    for preset in Preset::all() {
        let state = started(&["--state", preset.name], Settings { time: Some(77.0), ..Settings::default() });
        assert_eq!(state.document.preset, Some(preset), "{}", preset.name);
        assert!(!preset.title.is_empty() && !preset.caption.is_empty());
    }
    assert_eq!(Preset::start().name, "real-light");
    let line = Line::try_parse_from(["gamow", "--state", "streets"]).expect("it is a flag");
    let error = line.args.state(Settings::default()).expect_err("there is none").to_string();
    assert!(
        error.starts_with(
            "no preset is called `streets` (did you mean `street`?): there are real-light, street, "
        ),
        "{error}"
    );
}

#[test]
fn a_link_opens_what_is_shown() {
    for preset in Preset::all() {
        let state = started(&["--state", preset.name, "--time=0.25"], Settings::default());
        let link = state.shown().link().expect("a preset");
        assert!(link.len() < 400 && link.is_ascii() && !link.contains(' '), "{link}");
        let mut opened = State::open(Settings::default()).expect("a preset");
        opened.run(FileCommand::Open(link.clone().into()));
        assert_eq!(opened.scratch.notice, None, "{link}");
        // The window and the screen are those of whoever opens it.
        let expected = Settings {
            window: opened.document.settings.window,
            screen: opened.document.settings.screen,
            ..state.shown()
        };
        assert_eq!(opened.shown(), expected, "{link}");
        assert!(opened.session.recent.all().is_empty() && opened.shown_files().is_empty(), "{link}");
        let by_flag = started(&["--state", &link], Settings::default());
        assert_eq!(by_flag.shown(), expected, "{link}");
    }
}

#[test]
fn a_preset_is_applied_afresh_but_for_the_parts_of_the_window() {
    let mut state = started(&["--beta", "0.3", "--plots=off", "--theme=light"], Settings::default());
    assert_eq!(state.document.preset, None);
    let preset = Preset::named("overhead").expect("a preset");
    state.run(ShowCommand::Preset(preset));
    let window = state.document.settings.window;
    assert!(!window.plots && window.theme == Theme::Light);
    assert_eq!(
        state.shown(),
        Settings { window, time: Some(state.document.time), ..preset.settings.clone() }
    );
    state.run(ShowCommand::Scene("two-balls"));
    assert_eq!(state.document.preset, None);
}

#[test]
fn surroundings_are_left_out_and_put_back_and_all_else_stays() {
    let mut state = started(&["--time", "2.5"], Settings::default());
    let before = state.clone();
    let set = |state: &mut State, surroundings| {
        state.run(SettingsCommand::Light(LightSettings { surroundings, ..state.document.settings.light }));
    };
    set(&mut state, false);
    assert!(state.document.prepared.groups().iter().all(|group| group.motion == Motion::Scene));
    assert_eq!((state.document.time, &state.document.points), (2.5, &before.document.points));
    set(&mut state, true);
    assert_eq!(state.document.scene, before.document.scene);
}

#[test]
fn both_commands_know_every_setting() {
    for flags in [vec!["gamow"], vec!["gamow", "render"]] {
        let default = Settings::default().command(gamow::flags::words::Shell::RECORDED);
        let given = default.split_whitespace().skip(2).map(str::to_owned);
        let more = [
            "--time=2",
            "--point=0,3,2",
            "--range=auto",
            "--fit-samples=10",
            "--theme=light",
            "--looping=off",
        ];
        let words = flags.iter().map(ToString::to_string).chain(given).chain(more.map(str::to_owned));
        assert!(Cli::try_parse_from(words).is_ok(), "{flags:?}");
    }
}

#[cfg(unix)]
#[test]
fn the_window_opens_no_pipe_and_does_not_wait_for_one() {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let named_by = folder.path().join("state.toml");
    std::fs::write(&named_by, "scene = \"pipe.toml\"").expect("the folder is writable");
    let mut paths: Vec<_> = ["toml", "csv", "md", "png", "exr"]
        .map(|ending| folder.path().join("pipe").with_extension(ending))
        .into();
    for path in &paths {
        let made = std::process::Command::new("mkfifo").arg(path).status();
        assert!(made.expect("there is mkfifo").success());
    }
    paths.extend([named_by, "/dev/zero".into()]);
    let (sender, told) = std::sync::mpsc::channel();
    std::thread::spawn(move || {
        for path in paths {
            let mut state = State::open(Settings::default()).expect("a preset");
            let before = state.clone();
            state.run(FileCommand::Open(path.clone()));
            let notice = state.scratch.notice.take();
            sender.send((path, notice, state == before)).expect("it is waited for");
        }
    });
    for _ in 0..7 {
        let (path, notice, is_as_before) =
            told.recv_timeout(std::time::Duration::from_mins(1)).expect("nothing waits");
        let notice = notice.expect("it says why");
        let right = "it is a device or a pipe; an ordinary file would be right";
        assert!(notice.is_error && notice.text.contains(right), "{path:?}: {}", notice.text);
        assert!(is_as_before, "{path:?}");
    }
}
