//! Answers that are handed in: a pupil's link gives them back, and the links of a class make its page.

use std::path::PathBuf;

use eframe::egui::Key;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use gamow::app::commands::{Command, FileCommand, WindowCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::lesson::LessonCommand;
use gamow::app::state::overlay::Overlay;
use gamow::lesson::class::{Collected, PupilAnswers};
use gamow::lesson::{Answer, AnswerKind, Confidence, Phase, Place, Record};
use gamow::settings::Settings;

use super::Test;
use super::saving::message;
use super::support::{labels, type_into, wide_window};

pub const TESTS: &[Test] = trials![
    the_link_at_the_end_of_a_lesson_gives_the_answers_back,
    the_links_of_a_class_make_its_page,
    a_link_that_is_opened_says_whose_answers_it_holds,
    nothing_is_handed_in_where_nothing_was_answered,
];

fn ask(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    window.state_mut().run(command.into());
    window.run_ok();
}

/// A window at the end of the first lesson, whose choices were all the first.
fn at_the_end() -> Harness<'static, App> {
    let mut state = State::open(Settings::default()).expect("usual settings");
    let lesson = state.library().open("rods").expect("it is one of the program's own");
    state.begin_lesson(&lesson).expect("it can be worked out");
    for (step, told) in lesson.steps.iter().enumerate() {
        state.run(LessonCommand::GoTo(Place { step, phase: Phase::Ask }));
        let answer = match told.prediction.as_ref().map(|asked| &asked.kind) {
            Some(AnswerKind::Choice(_)) => Answer::Choice(0),
            Some(AnswerKind::Number(_)) => Answer::Number(0.5),
            other => panic!("{other:?}"),
        };
        state.run(LessonCommand::Draft(Some(answer)));
        state.run(LessonCommand::Confidence(Some(Confidence::Sure)));
        state.run(LessonCommand::Predict);
        if told.observation.is_some() {
            state.run(LessonCommand::Observe(1));
        }
    }
    state.run(LessonCommand::GoTo(Place { step: lesson.steps.len(), phase: Phase::Ask }));
    wide_window(state)
}

fn records(window: &Harness<'_, App>) -> Vec<Record> {
    window.state().state().course().expect("a lesson").records().to_vec()
}

/// The link that is shown.
fn link(window: &Harness<'_, App>) -> String {
    window.get_by_label("Link").accesskit_node().value().expect("it holds the link")
}

/// The answers in the link that is shown.
fn read(window: &Harness<'_, App>) -> PupilAnswers {
    let Collected { mut answers, .. } = Collected::from_text(&link(window));
    assert_eq!(answers.len(), 1);
    answers.remove(0)
}

fn the_link_at_the_end_of_a_lesson_gives_the_answers_back() {
    let mut window = at_the_end();
    window.get_by_label("My answers…").click();
    window.run_ok();
    type_into(&mut window, "Name", "Ada");
    let answers = read(&window);
    let lesson = window.state().state().course().expect("a lesson").lesson().clone();
    assert_eq!((answers.lesson.as_str(), answers.name.as_str()), ("rods", "Ada"));
    assert_eq!(answers.records(&lesson), records(&window));
    assert!(labels(&window).iter().any(|label| label == "QR code of the link"));
    window.get_by_label("Copy link").click();
    assert_eq!(message(&mut window), "Copied: the link with your answers");
    window.key_press(Key::Escape);
    window.run_ok();
    window.key_press(Key::Escape);
    window.run_ok();
    assert!(window.query_by_label("Link").is_none());
}

fn the_links_of_a_class_make_its_page() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("class.html");
    let mut window = at_the_end();
    ask(&mut window, WindowCommand::Toggle(Overlay::Answers));
    let links: Vec<String> = ["Ada", "Ben"]
        .map(|name| {
            type_into(&mut window, "Name", name);
            format!("{name},\"{}\"", link(&window))
        })
        .into();
    ask(&mut window, WindowCommand::Close);
    window.get_by_label("Class…").click();
    window.run_ok();
    window.get_by_label("Links").focus();
    window.run_ok();
    window.get_by_label("Links").type_text(&format!("{}\nanswers=damaged", links.join("\n")));
    window.run_ok();
    let shown = labels(&window);
    for told in [
        "Rods at 0.7 c: 2 pupils",
        "Line 3: this link is damaged or cut off: ask for it again, or for the report",
    ] {
        assert!(shown.iter().any(|label| label == told), "{told}: {shown:?}");
    }
    window.get_by_label("Save the class’s page…").click();
    window.run_ok();
    assert!(
        window
            .get_by_label("Path")
            .accesskit_node()
            .value()
            .is_some_and(|path| path.ends_with("rods-class.html"))
    );
    type_into(&mut window, "Path", path.to_str().expect("a plain path"));
    assert_eq!(message(&mut window), "Saved class.html.");
    let page = std::fs::read_to_string(&path).expect("it is written");
    for told in ["<h1>Class: Rods at 0.7 c</h1>", "2 pupils.", "<td>Ada</td>", "Not read: 1 link."] {
        assert!(page.contains(told), "{told}: {page}");
    }
}

fn a_link_that_is_opened_says_whose_answers_it_holds() {
    let mut window = at_the_end();
    ask(&mut window, WindowCommand::Toggle(Overlay::Answers));
    type_into(&mut window, "Name", "Ada");
    let link = link(&window);
    ask(&mut window, WindowCommand::Close);
    ask(&mut window, FileCommand::Open(PathBuf::from(&link)));
    let right = window
        .state()
        .state()
        .session
        .lesson
        .as_ref()
        .and_then(|lesson| lesson.score.clone())
        .expect("a score");
    let told = format!("Answers of Ada to “Rods at 0.7 c”: {} of {} right.", right.right, right.asked);
    assert_eq!(message(&mut window), told);
    assert_eq!(window.state().state().session.overlay, Some(Overlay::Class));
    // The same link again is the same pupil.
    ask(&mut window, FileCommand::Open(PathBuf::from(&link)));
    assert!(labels(&window).iter().any(|label| label == "Rods at 0.7 c: 1 pupil"));
    ask(&mut window, FileCommand::Open(PathBuf::from(&link[..link.len() - 3])));
    assert!(message(&mut window).starts_with("No answers: this link is damaged or cut off"));
}

fn nothing_is_handed_in_where_nothing_was_answered() {
    let mut state = State::open(Settings::default()).expect("usual settings");
    state.run(WindowCommand::Toggle(Overlay::Answers));
    let mut window = wide_window(state);
    window.run_ok();
    assert!(labels(&window).iter().any(|label| label.starts_with("Nothing was answered yet")));
    assert!(window.query_by_label("Copy link").is_none());
}
