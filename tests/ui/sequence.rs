//! A presenter's own sequence, gone through with two keys.

use eframe::egui::Key;
use egui_kittest::Harness;
use gamow::app::commands::ShowCommand;
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::flags::choices::Layout;
use gamow::lesson::{Course, Phase, Place};
use gamow::settings::Settings;

use super::Test;
use super::support::{labels, open, wait_for_file, window_without_pictures};

pub const TESTS: &[Test] = trials![
    two_keys_go_through_a_sequence_and_back,
    a_sequence_with_a_mistake_is_refused_with_its_line_and_leaves_all_as_it_was,
];

/// The entry that is shown: the preset, the step of a lesson with its phase, or the speed.
fn shown(window: &Harness<'_, App>) -> String {
    let State { document, session, .. } = window.state().state();
    match (session.lesson.as_ref().map(|running| running.course.place()), document.preset) {
        (Some(Place { step, phase }), _) => format!("step {} {phase:?}", step + 1),
        (None, Some(preset)) => preset.name.to_owned(),
        (None, None) => format!("{}", document.settings.speed().beta()),
    }
}

fn press(window: &mut Harness<'_, App>, key: Key) {
    window.key_press(key);
    window.run_steps(2);
    wait_for_file(window);
    window.run_steps(1);
}

fn two_keys_go_through_a_sequence_and_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).expect("it is written");
        path
    };
    write("mine.toml", "[motion]\nbeta = 0.123\n");
    let path = write(
        "lecture.txt",
        "# My lecture\nstreet\nlesson rods 2\nmine.toml # my own\ngamow:?beta=0.25&scene=globe\nglobe\n",
    );
    let mut window =
        window_without_pictures(State::open(Settings::default()).expect("defaults"), [1280.0, 800.0]);
    open(&mut window, &path);
    window.run_steps(2);
    assert_eq!(shown(&window), "street");
    assert!(
        labels(&window).iter().any(|label| label.starts_with("lecture.txt: 1 of 5")),
        "{:?}",
        labels(&window)
    );
    // A reveal that plays is taken to its end by the same key.
    let mut seen = vec![shown(&window)];
    for _ in 0..30 {
        press(&mut window, Key::PageDown);
        if seen.last() != Some(&shown(&window)) {
            seen.push(shown(&window));
        }
    }
    let forth = ["street", "step 2 Ask", "step 2 Shown", "step 2 Explained", "0.123", "0.25", "globe"];
    assert_eq!(seen, forth);
    assert_eq!(window.state().state().course().map(|course| course.is_class), None, "the lesson is closed");
    assert_eq!(window.state().state().document.settings.picture.layout, Layout::SideBySide);
    let mut back = vec![shown(&window)];
    for _ in 0..30 {
        press(&mut window, Key::PageUp);
        if back.last() != Some(&shown(&window)) {
            back.push(shown(&window));
        }
    }
    assert_eq!(back, ["globe", "0.25", "0.123", "step 2 Ask", "street"]);
    let questions = |phase| Place { step: 1, phase };
    press(&mut window, Key::PageDown);
    assert_eq!(window.state().state().course().map(Course::place), Some(questions(Phase::Ask)));
    window.state_mut().run(ShowCommand::EndSequence);
    press(&mut window, Key::PageUp);
    assert_eq!(
        window.state().state().course().map(|course| course.place().step),
        Some(0),
        "the whole lesson"
    );
}

fn a_sequence_with_a_mistake_is_refused_with_its_line_and_leaves_all_as_it_was() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("wrong.txt");
    std::fs::write(&path, "street\n\nlesson rods 9\n").expect("it is written");
    let mut window =
        window_without_pictures(State::open(Settings::default()).expect("defaults"), [1280.0, 800.0]);
    let before = window.state().state().document.clone();
    open(&mut window, &path);
    let State { document, session, scratch, .. } = window.state().state();
    let notice = scratch.notice.as_ref().expect("it is refused");
    assert!(notice.text.contains("wrong.txt:3: rods has the steps 1 to 4, and no 9"), "{}", notice.text);
    assert_eq!((document, session.sequence.is_none()), (&before, true));
}
