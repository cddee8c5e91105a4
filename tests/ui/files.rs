//! Files that are opened: the list of them, what is read again, and what is remembered.

use std::path::{Path, PathBuf};

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{Command, FileCommand, PlaybackCommand, WindowCommand};
use gamow::app::shell::App;
use gamow::app::shell::persistence::Keeper;
use gamow::app::state::State;
use gamow::app::state::files::purpose::Purpose;

use super::Test;
use super::picking::click;
use super::support::{
    Wakes, cyclist, labels, open, pane, rest, wait_for_file, wait_for_rest, window, window_without_pictures,
};

pub const TESTS: &[Test] = trials![
    the_last_of_two_files_is_shown,
    an_opened_scene_stays_in_the_list_and_a_missing_one_is_dropped,
    the_list_of_scenes_and_a_key_ask_for_a_file,
    a_scene_is_read_again_when_its_file_changes,
    a_state_is_read_again_when_its_file_changes,
    scene_time_point_and_files_are_remembered,
    a_value_of_megabytes_is_refused_in_a_message_that_can_be_shown,
];

const BALLS: &str = "name = \"Balls\"\n[[object]]\nname = \"big ball\"\nshape = \"sphere\"\ncentre = [0, 3, 0]\n\
    radius = 0.9\n[[object]]\nname = \"small ball\"\nshape = \"sphere\"\ncentre = [1.5, 3, 1]\nradius = 0.2\n";

/// A file called `name` in `folder`, which holds `text`.
fn file(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.canonicalize().expect("it is there").join(name);
    std::fs::write(&path, text).expect("it is writable");
    path
}

fn ask(window: &mut Harness<'_, App>, command: Command) {
    window.state_mut().run(command);
    window.run();
}

fn open_the_list(window: &mut Harness<'_, App>) {
    window.get_by_role_and_label(Role::ComboBox, "Scene").click();
    window.run();
}

fn scene_name<'a>(window: &'a Harness<'_, App>) -> &'a str {
    &window.state().state().document.scene.name
}

fn an_opened_scene_stays_in_the_list_and_a_missing_one_is_dropped() {
    let folder = tempfile::tempdir().expect("a folder");
    let balls = file(folder.path(), "balls.toml", BALLS);
    let state = file(folder.path(), "fast.toml", "scene = \"globe\"\n[motion]\ngamma = 9\n");
    let mut window = window(cyclist(0.9));
    open(&mut window, &balls);
    assert_eq!(scene_name(&window), "Balls");
    open(&mut window, &state);
    assert_eq!(window.state().state().speed().gamma(), 9.0);
    for name in ["balls.toml", "fast.toml"] {
        open_the_list(&mut window);
        window.get_by_label(name).click();
        wait_for_file(&mut window);
    }
    assert_eq!(window.state().state().speed().gamma(), 9.0);
    std::fs::remove_file(&balls).expect("it is there");
    open_the_list(&mut window);
    window.get_by_label("balls.toml").click();
    wait_for_file(&mut window);
    let notice = window.state().state().scratch.notice.clone().expect("it says why not");
    assert!(notice.is_error && notice.text.contains("cannot read this scene file"), "{}", notice.text);
    open_the_list(&mut window);
    assert!(window.query_by_label("balls.toml").is_none());
    window.get_by_label("fast.toml");
}

fn the_list_of_scenes_and_a_key_ask_for_a_file() {
    let mut window = window(cyclist(0.9));
    open_the_list(&mut window);
    window.get_by_label("Open…").click();
    window.run();
    assert_eq!(window.state().state().scratch.chooser, Some(Purpose::Open));
    ask(&mut window, Command::Window(WindowCommand::Close));
    window.key_press_modifiers(Modifiers::COMMAND, Key::O);
    window.run();
    assert_eq!(window.state().state().scratch.chooser, Some(Purpose::Open));
}

/// A frame whenever a thread has looked at a file that changed, or has read it, until this `holds`.
fn wait_until(window: &mut Harness<'_, App>, wakes: &Wakes, what: &str, holds: impl Fn(&State) -> bool) {
    window.step();
    while !holds(window.state().state()) {
        wakes.next(what);
        window.step();
    }
}

/// A window that shows the scene in the file at `balls` at T = 1.25 and follows the ball in the middle.
fn window_on_a_ball(balls: &Path) -> Harness<'static, App> {
    let mut window = window(cyclist(0.9));
    open(&mut window, balls);
    let middle = pane(&window, 0).center();
    click(&mut window, middle, Modifiers::NONE);
    ask(&mut window, Command::Playback(PlaybackCommand::GoTo(1.25)));
    window
}

fn a_scene_is_read_again_when_its_file_changes() {
    let folder = tempfile::tempdir().expect("a folder");
    let balls = file(folder.path(), "balls.toml", BALLS);
    let mut window = window_on_a_ball(&balls);
    let before = window.state().state().clone();
    assert_eq!(before.document.points.selected().body, Some(0), "the big ball is in the middle");
    // Watching costs no frames.
    window.remove_cursor();
    rest(&mut window);
    wait_for_rest(&mut window);

    let wakes = Wakes::of(&window);
    let without_the_small_one = BALLS.split_inclusive('\n').take(6).collect::<String>();
    let two = without_the_small_one.replace("Balls", "One ball").replace("0.9", "0.7");
    file(folder.path(), "balls.toml", &two);
    wait_until(&mut window, &wakes, "it is read again", |state| state.document.scene.name == "One ball");
    let state = window.state().state();
    assert_eq!((state.document.time, &state.document.settings), (1.25, &before.document.settings));
    assert_eq!(state.document.points.selected(), before.document.points.selected());
    assert_eq!(state.document.points.all()[0].track.rest, state.document.scene.tracked);

    file(folder.path(), "balls.toml", "name = = 3");
    wait_until(&mut window, &wakes, "the error is told", |state| state.scratch.notice.is_some());
    window.run();
    assert!(labels(&window).iter().any(|label| label.contains("balls.toml:1")), "{:?}", labels(&window));
    assert_eq!(scene_name(&window), "One ball");
    file(folder.path(), "balls.toml", BALLS);
    wait_until(&mut window, &wakes, "it is mended", |state| state.scratch.notice.is_none());
    assert_eq!(scene_name(&window), "Balls");
}

fn a_state_is_read_again_when_its_file_changes() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(folder.path(), "state.toml", "scene = \"cyclist\"\n[motion]\nbeta = 0.5\n");
    let mut window = window(cyclist(0.9));
    open(&mut window, &path);
    ask(&mut window, Command::Playback(PlaybackCommand::GoTo(1.25)));
    let middle = pane(&window, 0).center();
    click(&mut window, middle, Modifiers::NONE);
    let points = window.state().state().document.points.clone();
    let wakes = Wakes::of(&window);
    file(folder.path(), "state.toml", "scene = \"cyclist\"\n[motion]\nbeta = 0.75\n");
    wait_until(&mut window, &wakes, "it is read again", |state| state.speed().beta() == 0.75);
    let state = window.state().state();
    assert_eq!((state.document.time, &state.document.points), (1.25, &points));
}

fn the_last_of_two_files_is_shown() {
    let folder = tempfile::tempdir().expect("a folder");
    let rows = (0..200).map(|row| {
        format!("[[object]]\nname = \"row {row}\"\nshape = \"sphere\"\ncentre = [0, 4, {row}]\nradius = 0.1\nrepeat = 500\nstep = [1, 0, 0]\n")
    });
    let large =
        file(folder.path(), "large.toml", &("name = \"Large\"\n".to_owned() + &rows.collect::<String>()));
    let balls = file(folder.path(), "balls.toml", BALLS);
    let mut window = window_without_pictures(cyclist(0.9), [1120.0, 700.0]);
    let before = window.state().state().clone();
    window.state_mut().run(FileCommand::Open(large.clone()));
    // Nothing waits for it, and nothing has changed.
    assert!(window.state().is_reading() && *window.state().state() == before);
    open(&mut window, &balls);
    assert_eq!(scene_name(&window), "Balls");
    // The first one is read by now, and no longer wanted.
    open(&mut window, &large);
    assert_eq!(scene_name(&window), "Large");
    // Given up before it is read, or when it is read and not shown yet: it is not shown then.
    for is_read in [false, true] {
        let wakes = Wakes::of(&window);
        window.state_mut().run(FileCommand::Open(balls.clone()));
        if is_read {
            wakes.next("it is read");
        }
        window.state_mut().run(FileCommand::StopReading);
        wait_for_file(&mut window);
        assert_eq!(scene_name(&window), "Large");
    }
}

fn scene_time_point_and_files_are_remembered() {
    let folder = tempfile::tempdir().expect("a folder");
    let balls = file(folder.path(), "balls.toml", BALLS);
    let window = window_on_a_ball(&balls);
    let kept = tempfile::tempdir().expect("a folder");
    Keeper::in_folder(kept.path()).keep(window.state().state()).expect("it is written");
    let loaded = Keeper::in_folder(kept.path()).load();
    let again = State::open(loaded.settings).expect("it is there");
    let left = window.state().state();
    assert_eq!(
        (&again.document.settings, &again.document.scene),
        (&left.document.settings, &left.document.scene)
    );
    assert_eq!(again.document.time, 1.25);
    assert_eq!(again.document.points.selected().track, left.document.points.selected().track);
    assert_eq!(loaded.memory.recent().all(), [balls]);
    // The start is the same preset at any T.
    let mut window = super::support::window(
        State::open(gamow::settings::Preset::all()[0].settings.clone()).expect("a preset"),
    );
    ask(&mut window, Command::Playback(PlaybackCommand::GoTo(1.25)));
    Keeper::in_folder(kept.path()).keep(window.state().state()).expect("it is written");
    let again = State::open(Keeper::in_folder(kept.path()).load().settings).expect("it is there");
    assert_eq!(again.document.preset, window.state().state().document.preset);
    assert!(again.document.preset.is_some());
}

fn a_value_of_megabytes_is_refused_in_a_message_that_can_be_shown() {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let text = format!("[motion]\nd = \"{}\"\n", "7x".repeat(1_500_000));
    let path = file(folder.path(), "long.toml", &text);
    let mut window = window(cyclist(0.9));
    open(&mut window, &path);
    let notice = window.state().state().scratch.notice.clone().expect("it is told");
    assert!(notice.is_error && notice.text.starts_with("long.toml:2: d = 7x7x"), "{:.80}", notice.text);
    assert!(notice.text.ends_with(": not a number") && notice.text.len() < 5000, "{}", notice.text.len());
}
