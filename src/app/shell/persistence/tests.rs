//! An answer is on the disc when it is given; two windows know of each other; failures to read and to write
//! are reported.

use std::path::Path;

use eframe::egui;
use gamow_platform::sizes::TEXT_BYTES;

use super::*;
use crate::app::commands::{Command, WindowCommand};
use crate::app::shell::App;
use crate::app::state::lesson::LessonCommand;
use crate::app::tools::folded;
use crate::lesson::{Answer, Library, Outcome};

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("there is a place for temporary files")
}

/// A window over the files in `folder` in which a lesson is open.
fn window(folder: &Path) -> App {
    let keeper = Keeper::in_folder(folder);
    let loaded = keeper.load();
    let mut state = State::open(loaded.settings).expect("a preset");
    state.recall_answers(&loaded.answers);
    state.begin_lesson(&Library::own().open("turned").expect("it is there")).expect("it can be shown");
    state.scratch.notice = loaded.notice;
    App::new(&egui::Context::default(), None, state).kept_by(keeper)
}

fn ask(window: &mut App, command: LessonCommand) {
    window.run(Command::Lesson(command));
}

/// The outcomes in the lesson that the next window finds in `folder`.
fn outcomes(folder: &Path) -> Vec<Option<Outcome>> {
    let window = window(folder);
    window.state().course().expect("a lesson").records().iter().map(|record| record.outcome.clone()).collect()
}

/// The path of the file of the lesson's answers in the folder of all.
const ANSWERS: &str = "answers/turned.json";

/// Has another program write `bytes` in the place of the lesson's answers.
fn with_answers(folder: &Path, bytes: &[u8]) {
    std::fs::create_dir_all(folder.join(answers_file::FOLDER)).expect("it is writable");
    std::fs::write(folder.join(ANSWERS), bytes).expect("it is writable");
}

fn notice(window: &App) -> &str {
    window.state().scratch.notice.as_ref().map_or("", |notice| &notice.text)
}

#[test]
fn an_answer_is_on_the_disc_as_soon_as_it_is_given() {
    let folder = folder();
    let mut window = window(folder.path());
    assert!(!folder.path().join(answers_file::FOLDER).exists());
    ask(&mut window, LessonCommand::Skip);
    assert_eq!(outcomes(folder.path())[0], Some(Outcome::Skipped));
    ask(&mut window, LessonCommand::BeginAnew);
    assert_eq!(outcomes(folder.path())[0], None);
    // Nothing else was written yet, and this window never ends.
    assert!(!folder.path().join(SETTINGS).exists());
    std::mem::forget(window);
}

#[test]
fn two_windows_keep_the_answers_of_both() {
    let folder = folder();
    let (mut first, mut second) = (window(folder.path()), window(folder.path()));
    assert_eq!(notice(&first), "");
    assert!(notice(&second).starts_with("Another window of Gamow is open."), "{}", notice(&second));
    ask(&mut first, LessonCommand::Skip);
    ask(&mut second, LessonCommand::Open("rods".to_owned()));
    ask(&mut second, LessonCommand::Skip);
    for window in [&mut second, &mut first] {
        eframe::App::on_exit(window);
    }
    drop((first, second));
    let loaded = Keeper::in_folder(folder.path()).load();
    assert_eq!(loaded.notice, None);
    for name in ["turned", "rods"] {
        let lesson = Library::own().open(name).expect("it is there");
        let way = loaded.answers.progress(&lesson).expect("it was begun");
        assert_eq!(way.record(&lesson, 0).outcome, Some(Outcome::Skipped), "{name}");
    }
}

#[test]
fn of_two_windows_in_one_lesson_the_later_answers_count_and_the_window_says_so() {
    let folder = folder();
    let (mut first, mut second) = (window(folder.path()), window(folder.path()));
    ask(&mut first, LessonCommand::Skip);
    let earlier = std::fs::read(folder.path().join(ANSWERS)).expect("it is written");
    ask(&mut second, LessonCommand::Draft(Some(Answer::Choice(1))));
    ask(&mut second, LessonCommand::Predict);
    let told = "Another window has written answers in this lesson since; those of this window replace them.";
    assert!(notice(&second).starts_with(told), "{}", notice(&second));
    assert!(notice(&second).contains("turned.json.old1") && notice(&first).is_empty());
    assert_eq!(std::fs::read(folder.path().join(ANSWERS.to_owned() + ".old1")).expect("it is kept"), earlier);
    drop((first, second));
    let made = Outcome::Made { answer: Answer::Choice(1), confidence: None };
    assert_eq!(outcomes(folder.path())[0], Some(made));
}

#[test]
fn what_is_half_entered_is_kept_when_the_window_is_closed() {
    let folder = folder();
    let mut window = window(folder.path());
    ask(&mut window, LessonCommand::Draft(Some(Answer::Choice(1))));
    assert!(!folder.path().join(answers_file::FOLDER).exists(), "it is no answer yet");
    eframe::App::on_exit(&mut window);
    drop(window);
    assert_eq!(
        self::window(folder.path()).state().course().expect("a lesson").draft,
        Some(Answer::Choice(1))
    );
}

/// Not even root can create a folder below a file.
#[test]
fn what_cannot_be_written_is_told_at_the_start_when_it_fails_and_at_the_end() {
    let folder = folder();
    let file = folder.path().join("file");
    std::fs::write(&file, "precious").expect("it is writable");
    let within = file.join("gamow");
    let mut window = window(&within);
    let told = |window: &App, what: &str| {
        let text = notice(window);
        assert!(text.contains(&*within.to_string_lossy()) && text.contains(what), "{text}");
    };
    told(&window, "Free some space, or make the folder writable");
    window.run(WindowCommand::CloseNotice);
    ask(&mut window, LessonCommand::Skip);
    told(&window, "The answers in lessons are not saved: ");
    // It is said once.
    window.run(WindowCommand::CloseNotice);
    ask(&mut window, LessonCommand::Forward);
    assert_eq!(notice(&window), "");
    let keeper = Keeper::in_folder(&within);
    let problem = keeper.keep(window.state()).expect_err("it cannot be written").to_string();
    assert!(problem.starts_with("the settings and the answers in lessons are not saved: "), "{problem}");
    assert!(!problem.contains('\n') && keeper.end().is_err());
    assert_eq!(std::fs::read(&file).expect("it is there"), b"precious");
    // Once there is a folder, all is well.
    std::fs::remove_file(&file).expect("it is writable");
    keeper.keep(window.state()).expect("it is written");
    assert!(keeper.end().is_ok());
    assert_eq!(outcomes(&within)[0], Some(Outcome::Skipped));
}

#[test]
fn one_setting_is_reset_and_named_and_the_others_are_kept() {
    let folder = folder();
    let text = "[motion]\nd = nan\nbeta = 0.5\n[playback]\nrate = 1e300\n[fit]\nfit-samples = 18446744073709551615\n\
                seed = 7\n[later]\nx = 1";
    let path = folder.path().join(SETTINGS);
    std::fs::write(&path, text).expect("it is writable");
    std::fs::write(folder.path().join(MEMORY), "zoom = 0.0\nrecent = [\"/a.toml\"]\nlesson = 3\n")
        .expect("it is writable");
    let loaded = Keeper::in_folder(folder.path()).load();
    let told = loaded.notice.expect("it is told").text;
    for part in [
        "d = nan: not a finite number",
        "rate = 1e300: must be between 1e-3 and 1e6",
        "fit-samples = 18446744073709551615: must be a whole number between 2 and 5000",
        "unknown section [later]: there are motion",
        "settings.toml.old1",
        "zoom = 0.0",
        "lesson = 3",
        "window.toml.old1",
    ] {
        assert!(told.contains(part), "{part} in {told}");
    }
    assert_eq!(std::fs::read(path.with_extension("toml.old1")).expect("it is kept"), text.as_bytes());
    let expected =
        Settings::default().with_toml("[motion]\nbeta = 0.5\n[fit]\nseed = 7", "").expect("it is right");
    assert_eq!((&loaded.settings, loaded.memory.recent().all().len()), (&expected, 1));
    // It is told once, and what is left can be opened like any file of settings.
    let again = Keeper::in_folder(folder.path()).load();
    assert_eq!((again.settings, again.memory, again.notice), (loaded.settings, loaded.memory, None));
    assert_eq!(Settings::default().with_file(&path).expect("it is right"), expected);
}

#[test]
fn a_file_that_cannot_be_read_is_kept_aside_whole() {
    let long = vec![b'x'; 1 + TEXT_BYTES as usize];
    let deep = "[".repeat(100_000);
    for bytes in [&b"\xff\xfe\x00garbage"[..], b"{\"turned\": 3}", b"[1, 2", deep.as_bytes(), &long] {
        let folder = folder();
        with_answers(folder.path(), bytes);
        for name in [SETTINGS, MEMORY] {
            std::fs::write(folder.path().join(name), bytes).expect("it is writable");
        }
        let mut window = window(folder.path());
        for name in [SETTINGS, MEMORY, ANSWERS] {
            let aside = format!("{name}.old1");
            assert!(notice(&window).contains(&aside), "{aside} in {}", notice(&window));
            assert_eq!(std::fs::read(folder.path().join(aside)).expect("it is kept"), bytes);
        }
        ask(&mut window, LessonCommand::Skip);
        drop(window);
        assert_eq!(outcomes(folder.path())[0], Some(Outcome::Skipped));
    }
}

/// Another program may write nonsense there while the window is open.
#[test]
fn an_answer_does_not_replace_a_file_that_has_become_unreadable() {
    let folder = folder();
    let mut window = window(folder.path());
    with_answers(folder.path(), b"precious");
    ask(&mut window, LessonCommand::Skip);
    assert!(notice(&window).contains("turned.json.old1"), "{}", notice(&window));
    assert_eq!(
        std::fs::read(folder.path().join(ANSWERS.to_owned() + ".old1")).expect("it is kept"),
        b"precious"
    );
    assert_eq!(outcomes(folder.path())[0], Some(Outcome::Skipped));
}

#[test]
fn many_old_files_are_kept_and_not_without_end() {
    let folder = folder();
    for number in 0..20 {
        with_answers(folder.path(), format!("garbage {number}").as_bytes());
        assert!(Keeper::in_folder(folder.path()).load().notice.is_some());
    }
    let answers = folder.path().join(answers_file::FOLDER);
    let names = std::fs::read_dir(&answers).expect("a folder").flatten().map(|entry| entry.file_name());
    let old = names.filter(|name| name.to_string_lossy().contains(".old")).count();
    assert_eq!(old, 9);
    let first = std::fs::read_to_string(answers.join("turned.json.old1")).expect("it is kept");
    assert_eq!(first, "garbage 0");
}

#[test]
fn zoom_and_folded_sections_are_as_they_were_left() {
    let folder = folder();
    let (keeper, ctx) = (Keeper::in_folder(folder.path()), egui::Context::default());
    let mut state = State::open(Settings::default()).expect("a preset");
    keeper.0.borrow_mut().saved = Instant::now();
    ctx.set_zoom_factor(1.5);
    folded::note(&ctx, "Light", true);
    folded::note(&ctx, "Look", true);
    folded::note(&ctx, "Look", false);
    for _ in 0..2 {
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(600.0, 400.0))),
            ..egui::RawInput::default()
        };
        let mut output = ctx.run_ui(input, |_| {});
        output.textures_delta.clear();
    }
    keeper.keep_on(&mut state, &ctx);
    keeper.keep(&state).expect("it is written");
    let next = Keeper::in_folder(folder.path());
    let memory = next.load().memory;
    let placed = next.placed(ViewportBuilder::default());
    assert_eq!(placed.inner_size, Some(egui::vec2(900.0, 600.0)), "600 x 400 points of 1.5");
    let again = egui::Context::default();
    memory.restore_in(&again, true);
    again.begin_pass(egui::RawInput::default());
    again.end_pass().textures_delta.clear();
    assert_eq!(again.zoom_factor(), 1.5);
    assert!(folded::is_folded(&again, "Light") && !folded::is_folded(&again, "Look"));
}
