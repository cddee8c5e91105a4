//! Lessons in the window: what a student does in the panel, what an audience sees, and the way back.

use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Rect, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use gamow::app::commands::{Command, FileCommand, PlaybackCommand, SettingsCommand, Switch, WindowCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::lesson::LessonCommand;
use gamow::flags::choices::Layout;
use gamow::lesson::{Answer, AnswerKind, Confidence, Course, Lesson, Library, Outcome, Phase, Place};
use gamow::settings::{PlotTab, Presence, Settings, Theme, WindowSettings};
use relativity_render::Gaze;

use super::Test;
use super::support::{
    in_layout, labels, open, some_lessons, type_into, wait_for, wait_for_file, window_without_pictures,
};

pub const TESTS: &[Test] = trials![
    a_lesson_is_gone_through_by_its_labels,
    a_prediction_in_a_lesson_can_be_skipped_and_the_way_back_is_open,
    an_observation_in_a_lesson_against_what_was_shown_offers_to_look_again,
    hands_are_counted_in_a_lesson_of_a_class,
    letters_and_digits_answer_a_lesson_that_has_choices_and_do_nothing_else,
    a_question_for_a_number_has_the_keyboard_and_the_clicker_still_goes_on,
    hands_in_a_lesson_are_typed_as_numbers,
    a_narrow_window_folds_the_lesson_for_its_controls,
    what_was_explored_in_a_lesson_is_set_up_again_and_undone,
    closing_a_lesson_has_the_parts_of_the_window_as_before,
    a_lesson_that_is_closed_keeps_its_answers,
    a_lesson_that_is_written_anew_keeps_its_place,
    an_audience_is_led_through_a_lesson_with_two_keys,
    a_lesson_about_one_eye_has_one_wide_picture_until_another_layout_is_chosen,
    the_end_of_a_lesson_leads_to_the_next_and_to_its_pages,
    every_step_of_every_lesson_fits_and_shows_its_state,
    every_step_of_every_lesson_fits_before_an_audience,
];

const LESSON: &str = r#"---
title: Clocks and rods
---

## Rods

```state
scene = "rods"
time = -20

[motion]
beta = 0.6

[window]
map = "on"
```

Some rods come.

### Predict

How long do they look?

- [ ] short
- [x] long

### Reveal

```play
time = -5
seconds = 2
```

Look at them.

### Observe

What did you see?

- [x] They looked long.
- [ ] They looked short.

### Explain

Light is late.

## Gamma

### Predict

How large is gamma?

```number
truth = "gamma"
unit = "times"
decimals = 2
within = 0.1
```

### Reveal

It is worked out.

### Explain

So large.

## In a sentence

What comes looks long.
"#;

fn lesson() -> Lesson {
    Lesson::read("test", LESSON, "test.md").expect("a lesson")
}

/// A window of this `size` in which `lesson` begins. Nothing is drawn in its views, which takes most of the
/// time.
pub fn window(lesson: &Lesson, size: [f32; 2]) -> Harness<'static, App> {
    window_with(WindowSettings::default(), lesson, size)
}

/// The same, with these parts.
fn window_with(parts: WindowSettings, lesson: &Lesson, size: [f32; 2]) -> Harness<'static, App> {
    let settings = Settings { window: parts, ..Settings::default() };
    let mut state = State::open(settings).expect("usual settings");
    state.begin_lesson(lesson).expect("it can be worked out");
    window_without_pictures(state, size)
}

pub fn course<'a>(window: &'a Harness<'_, App>) -> &'a Course {
    window.state().state().course().expect("a lesson is gone through")
}

fn ask(window: &mut Harness<'_, App>, command: LessonCommand) {
    window.state_mut().run(Command::Lesson(command));
    window.run_steps(2);
}

fn press(window: &mut Harness<'_, App>, name: &str) {
    window.get_by_role_and_label(Role::Button, name).click();
    window.run_steps(2);
}

fn choose(window: &mut Harness<'_, App>, name: &str) {
    window.get_by_role_and_label(Role::RadioButton, name).click();
    window.run_steps(2);
}

fn place(step: usize, phase: Phase) -> Place {
    Place { step, phase }
}

fn made(answer: Answer, confidence: Option<Confidence>) -> Outcome {
    Outcome::Made { answer, confidence }
}

fn is_running(window: &Harness<'_, App>) -> bool {
    window.state().state().session.lesson.as_ref().is_some_and(gamow::app::state::lesson::Running::is_running)
}

fn time(window: &Harness<'_, App>) -> f64 {
    window.state().state().document.time
}

fn a_lesson_is_gone_through_by_its_labels() {
    let mut window = window(&lesson(), [1280.0, 800.0]);
    window.get_by_label("1 of 2");
    assert!(window.get_by_role_and_label(Role::Button, "Predict").accesskit_node().is_disabled());
    choose(&mut window, "short");
    press(&mut window, "How sure: fairly sure");
    press(&mut window, "Predict");
    assert_eq!(
        course(&window).records()[0].outcome,
        Some(made(Answer::Choice(0), Some(Confidence::FairlySure)))
    );
    // The reveal lasts two seconds.
    assert!(is_running(&window) && window.query_by_label("What did you see?").is_none());
    window.run_steps(10);
    assert!(time(&window) > -20.0 && time(&window) < -5.0, "{}", time(&window));
    window.run_steps(40);
    assert!(!is_running(&window));
    assert!((time(&window) + 5.0).abs() < 1e-12);
    // What was seen is asked before the truth is told.
    assert!(window.query_by_label("You said").is_none() && window.query_by_label("It is").is_none());
    choose(&mut window, "They looked long.");
    for name in ["Yes, that is what happened.", "You said", "It is"] {
        window.get_by_label(name);
    }
    assert_eq!(course(&window).records()[0].observed, Some(0));
    press(&mut window, "Next");
    window.get_by_label("Light is late.");
    press(&mut window, "Next");
    a_number_is_entered_and_the_end_reached(&mut window);
}

fn a_number_is_entered_and_the_end_reached(window: &mut Harness<'_, App>) {
    // 1/sqrt(1 - 0.36) = 1.25.
    type_into(window, "Predicted number", "1,2");
    assert_eq!(course(window).records()[1].outcome, Some(made(Answer::Number(1.2), None)));
    press(window, "Next");
    press(window, "Back");
    press(window, "Next");
    press(window, "Next");
    window.get_by_label("What comes looks long.");
    window.get_by_label("Predicted: 1 of 2 right.");
    press(window, "Again");
    assert_eq!(course(window).place(), Place::START);
    assert!((time(window) + 20.0).abs() < 1e-12);
}

fn a_prediction_in_a_lesson_can_be_skipped_and_the_way_back_is_open() {
    let mut window = window(&lesson(), [1024.0, 600.0]);
    press(&mut window, "Skip");
    assert_eq!(course(&window).records()[0].outcome, Some(Outcome::Skipped));
    press(&mut window, "Show the end");
    assert!(!is_running(&window));
    assert_eq!(course(&window).place(), place(0, Phase::Shown));
    press(&mut window, "Back");
    assert_eq!(course(&window).place(), Place::START);
    assert!((window.state().state().document.time + 20.0).abs() < 1e-12);
    // What was skipped is asked again, and can be skipped again.
    window.get_by_role_and_label(Role::RadioButton, "long");
    window.get_by_role_and_label(Role::Button, "Skip");
    press(&mut window, "Step 2: Gamma");
    assert_eq!(course(&window).place(), place(1, Phase::Ask));
    press(&mut window, "Step 1: Rods");
    assert_eq!(course(&window).place(), Place::START);
    choose(&mut window, "short");
    press(&mut window, "Predict");
    assert_eq!(course(&window).records()[0].outcome, Some(made(Answer::Choice(0), None)));
    press(&mut window, "Show the end");
    press(&mut window, "Back");
    // What was said is shown, and can be changed.
    window.get_by_label("This is what you said. You can change it.");
    assert_eq!(course(&window).draft, Some(Answer::Choice(0)));
    choose(&mut window, "long");
    press(&mut window, "Predict");
    assert_eq!(course(&window).records()[0].outcome, Some(made(Answer::Choice(1), None)));
}

fn an_observation_in_a_lesson_against_what_was_shown_offers_to_look_again() {
    let mut window = window(&lesson(), [1024.0, 600.0]);
    choose(&mut window, "long");
    press(&mut window, "Predict");
    window.get_by_label("Look at them.");
    press(&mut window, "Show the end");
    choose(&mut window, "They looked short.");
    window.get_by_label("You said, rightly,");
    press(&mut window, "Look again");
    assert!(is_running(&window));
    assert!(window.state().state().document.time < -15.0);
    assert_eq!(course(&window).records()[0].observed, Some(1));
}

fn hands_are_counted_in_a_lesson_of_a_class() {
    let mut window = window(&lesson(), [1024.0, 600.0]);
    window.get_by_label("Count hands").click();
    window.run_steps(2);
    assert!(window.query_by_label("How sure?").is_none());
    for name in ["One more for long", "One more for long", "One more for short", "One fewer for long"] {
        press(&mut window, name);
    }
    press(&mut window, "One more for long");
    press(&mut window, "Predict");
    press(&mut window, "Show the end");
    assert_eq!(course(&window).records()[0].outcome, Some(made(Answer::Votes(vec![1, 2]), None)));
    choose(&mut window, "They looked long.");
    for hands in ["Hands for short: 1", "Hands for long: 2"] {
        assert!(labels(&window).iter().any(|label| label == hands), "{hands}");
    }
    let score = course(&window).score(&Settings::default());
    assert_eq!((score.asked, score.others), (0, vec!["Step 1: 2 of 3 hands were right.".to_owned()]));
}

fn letters_and_digits_answer_a_lesson_that_has_choices_and_do_nothing_else() {
    for (is_presented, keys) in [
        (false, [Key::Num1, Key::Num2, Key::Num3]),
        (false, [Key::A, Key::B, Key::Num3]),
        (true, [Key::Num1, Key::Num2, Key::Num4]),
        (true, [Key::A, Key::B, Key::Num4]),
    ] {
        let [first, second, beyond] = keys;
        let mut window = window(&lesson(), [1280.0, 800.0]);
        if is_presented {
            window.state_mut().run(WindowCommand::TogglePresenting);
            window.run_steps(4);
        }
        // The screen says so.
        let says = if is_presented { "A–B\u{a0}answer" } else { "Press A or B." };
        assert!(["A", "B"].iter().all(|letter| labels(&window).iter().any(|label| label == letter)));
        assert!(labels(&window).iter().any(|label| label.contains(says)), "{says}");
        let shown = |window: &Harness<'_, App>| {
            let state = window.state().state();
            (state.document.settings.geometry(), state.document.settings.picture, state.session.stage)
        };
        let before = shown(&window);
        for (pressed, draft) in [(second, 1), (first, 0), (beyond, 0)] {
            key(&mut window, pressed);
            assert_eq!(course(&window).draft, Some(Answer::Choice(draft)), "{pressed:?}");
            assert_eq!(shown(&window), before, "{pressed:?}");
        }
        ask(&mut window, LessonCommand::Predict);
        ask(&mut window, LessonCommand::Forward);
        key(&mut window, second);
        assert_eq!(course(&window).records()[0].observed, Some(1));
        assert_eq!(shown(&window), before);
        // Where nothing is asked they do what they always do.
        ask(&mut window, LessonCommand::Forward);
        key(&mut window, second);
        assert_ne!(shown(&window), before);
    }
}

fn a_question_for_a_number_has_the_keyboard_and_the_clicker_still_goes_on() {
    let mut window = window(&lesson(), [1280.0, 800.0]);
    for _ in 0..20 {
        let kind = course(&window).asked().map(|asked| asked.kind.clone());
        if matches!(kind, Some(AnswerKind::Number(_))) {
            break;
        }
        ask(&mut window, LessonCommand::Forward);
    }
    window.run_steps(3);
    window.event(Event::Text("1.5".to_owned()));
    window.run_steps(2);
    assert_eq!(course(&window).draft, Some(Answer::Number(1.5)));
    let place = course(&window).place();
    key(&mut window, Key::PageDown);
    assert_ne!(course(&window).place(), place);
}

fn hands_in_a_lesson_are_typed_as_numbers() {
    for is_presented in [false, true] {
        let mut window = window(&lesson(), [1280.0, 800.0]);
        if is_presented {
            window.state_mut().run(WindowCommand::TogglePresenting);
        }
        ask(&mut window, LessonCommand::ToggleClass);
        let geometry = window.state().state().document.settings.geometry();
        let digit = |window: &mut Harness<'_, App>, digit: Key, text: &str| {
            window.key_press(digit);
            window.event(Event::Text(text.to_owned()));
            window.run_steps(2);
        };
        // Nothing has the keyboard: the first field takes it.
        digit(&mut window, Key::Num1, "1");
        digit(&mut window, Key::Num2, "2");
        key(&mut window, Key::Tab);
        assert_eq!(course(&window).draft, Some(Answer::Votes(vec![12, 0])));
        window.get_by_role_and_label(Role::TextInput, "Hands for long: 0").click();
        window.run_steps(2);
        digit(&mut window, Key::Num4, "4");
        assert_eq!(course(&window).draft, Some(Answer::Votes(vec![12, 4])));
        assert_eq!(window.state().state().document.settings.geometry(), geometry);
    }
}

fn a_narrow_window_folds_the_lesson_for_its_controls() {
    let has_controls = |window: &Harness<'_, App>| window.query_by_label("Speed β").is_some();
    let mut wide = window(&lesson(), [1280.0, 800.0]);
    assert!(has_controls(&wide));
    ask(&mut wide, LessonCommand::Close);
    let mut narrow = window(&lesson(), [1024.0, 600.0]);
    assert!(!has_controls(&narrow));
    press(&mut narrow, "Fold the lesson");
    assert!(has_controls(&narrow) && narrow.query_by_label("Some rods come.").is_none());
    press(&mut narrow, "Unfold the lesson");
    narrow.get_by_label("Some rods come.");
    ask(&mut narrow, LessonCommand::Close);
    assert!(has_controls(&narrow));
}

fn what_was_explored_in_a_lesson_is_set_up_again_and_undone() {
    let mut window = window(&lesson(), [1024.0, 600.0]);
    let told = window.state().state().document.settings.clone();
    assert!(window.query_by_label("Set up again").is_none());
    for change in [
        Command::Settings(SettingsCommand::NudgeSpeed(3)),
        Command::Playback(PlaybackCommand::GoTo(3.0)),
        Command::Settings(SettingsCommand::Switch(Switch::Map)),
    ] {
        window.state_mut().run(change);
        window.run_steps(2);
        press(&mut window, "Set up again");
        assert_eq!(window.state().state().document.settings, told);
        assert!((window.state().state().document.time + 20.0).abs() < 1e-12);
        assert!(window.query_by_label("Set up again").is_none());
    }
    press(&mut window, "Skip");
    press(&mut window, "Show the end");
    for _ in 0..3 {
        press(&mut window, "Next");
    }
    assert_eq!(course(&window).place(), place(1, Phase::Ask));
    window.state_mut().run(SettingsCommand::NudgeSpeed(3));
    window.state_mut().run(Command::Undo);
    window.run_steps(2);
    assert_eq!(course(&window).place(), place(1, Phase::Ask));
    assert_eq!(window.state().state().document.settings, told);
}

fn closing_a_lesson_has_the_parts_of_the_window_as_before() {
    let mut state = State::open(Settings::default()).expect("usual settings");
    let before = WindowSettings { readout: false, theme: Theme::Dark, ..WindowSettings::default() };
    state.document.settings.window = before;
    state.begin_lesson(&lesson()).expect("it can be worked out");
    let mut window = window_without_pictures(state, [1280.0, 800.0]);
    assert_ne!(window.state().state().document.settings.window, before);
    press(&mut window, "Close the lesson");
    assert!(window.state().state().course().is_none());
    assert_eq!(window.state().state().document.settings.window, before);
}

fn a_lesson_that_is_closed_keeps_its_answers() {
    let mut window = window(&lesson(), [1280.0, 800.0]);
    choose(&mut window, "short");
    press(&mut window, "Predict");
    ask(&mut window, LessonCommand::Forward);
    choose(&mut window, "They looked long.");
    let left = course(&window).clone();
    press(&mut window, "Close the lesson");
    assert_eq!(window.state().state().course(), None);
    // Another one is begun and left for the first.
    ask(&mut window, LessonCommand::Open("rods".to_owned()));
    window.state_mut().run(LessonCommand::Skip);
    let begin = |window: &mut Harness<'_, App>| {
        let mut state = window.state().state().clone();
        state.begin_lesson(&lesson()).expect("it can be worked out");
        state
    };
    let again = begin(&mut window);
    let again = again.course().expect("a lesson");
    assert_eq!((again.records(), again.place()), (left.records(), left.place()));
    assert_eq!(again.records()[0].observed, Some(0));
    // What was asked otherwise then is asked again.
    let other =
        Lesson::read("test", &LESSON.replace("- [ ] short", "- [ ] shorter"), "test.md").expect("a lesson");
    let mut state = window.state().state().clone();
    state.begin_lesson(&other).expect("it can be worked out");
    let asked = state.course().expect("a lesson");
    assert_eq!((asked.records()[0].outcome.as_ref(), asked.place()), (None, Place::START));
    // The start page goes on with the one that was left last.
    ask(&mut window, LessonCommand::Close);
    window.state_mut().run(WindowCommand::Toggle(gamow::app::state::overlay::Overlay::Start));
    window.run_steps(2);
    press(&mut window, "Go on: Rods at 0.7 c");
    assert_eq!(course(&window).records()[0].outcome, Some(Outcome::Skipped));
    ask(&mut window, LessonCommand::BeginAnew);
    assert_eq!(
        (course(&window).records()[0].outcome.as_ref(), course(&window).place()),
        (None, Place::START)
    );
}

fn a_lesson_that_is_written_anew_keeps_its_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().canonicalize().expect("it is there").join("own.md");
    std::fs::write(&path, LESSON).expect("it is writable");
    let mut window =
        window_without_pictures(State::open(Settings::default()).expect("usual settings"), [1024.0, 600.0]);
    open(&mut window, &path);
    choose(&mut window, "long");
    press(&mut window, "Predict");
    press(&mut window, "Show the end");
    choose(&mut window, "They looked long.");
    press(&mut window, "Next");
    let records = course(&window).records().to_vec();
    std::fs::write(&path, LESSON.replace("Light is late.", "Light needs time.")).expect("it is writable");
    window.state_mut().run(FileCommand::Reload(path));
    wait_for_file(&mut window);
    window.get_by_label("Light needs time.");
    assert_eq!(course(&window).place(), place(0, Phase::Explained));
    assert_eq!(course(&window).records(), records);
}

fn key(window: &mut Harness<'_, App>, key: Key) {
    window.key_press(key);
    window.run_steps(3);
}

fn an_audience_is_led_through_a_lesson_with_two_keys() {
    let mut window = window(&lesson(), [800.0, 600.0]);
    window.state_mut().run(WindowCommand::TogglePresenting);
    window.run_steps(3);
    let text = |window: &Harness<'_, App>, text: &str| labels(window).iter().any(|label| label == text);
    assert!(text(&window, "How long do they look?") && text(&window, "long"));
    assert!(!text(&window, "Predict"));
    // On to the reveal, to its end, to why, to the next step, over its truth to why, to the sentence.
    key(&mut window, Key::PageDown);
    assert_eq!(course(&window).records()[0].outcome, Some(Outcome::Skipped));
    assert!(is_running(&window) && text(&window, "Look at them."));
    key(&mut window, Key::PageDown);
    assert!(!is_running(&window) && text(&window, "What did you see?") && !text(&window, "It is"));
    key(&mut window, Key::PageDown);
    assert!(text(&window, "It is"));
    // Back at the question its choices are open again.
    key(&mut window, Key::PageUp);
    assert!(text(&window, "How long do they look?") && text(&window, "short") && text(&window, "long"));
    assert!(course(&window).asked().is_some());
    for _ in 0..3 {
        key(&mut window, Key::PageDown);
    }
    assert!(text(&window, "It is"));
    key(&mut window, Key::PageDown);
    assert!(text(&window, "Light is late."));
    key(&mut window, Key::PageDown);
    assert!(text(&window, "How large is gamma?"));
    key(&mut window, Key::PageUp);
    assert!(text(&window, "Light is late."));
    for _ in 0..4 {
        key(&mut window, Key::PageDown);
    }
    assert!(text(&window, "What comes looks long."));
    key(&mut window, Key::Escape);
    assert!(!window.state().state().session.stage.is_presented());
    window.get_by_label("Predicted: 0 of 2 right, 2 skipped.");
}

/// What could be answered to a prediction of this `kind`.
fn fitting(kind: &AnswerKind) -> Answer {
    match kind {
        AnswerKind::Choice(options) => Answer::Choice(options.right),
        AnswerKind::Number(number) => Answer::Number(number.truth.expect("worked out")),
        AnswerKind::Point(_) => Answer::Direction(Gaze { azimuth: 1.5, elevation: 0.0 }),
        AnswerKind::Curve(curve) => Answer::Curve(vec![[-1.0, curve.range[0]], [1.0, curve.range[1]]]),
    }
}

/// Before an audience pictures and words share the room within a few frames; a fit takes its time.
fn settle_words(window: &mut Harness<'_, App>) {
    if window.state().state().session.stage.has_audience() {
        window.run_steps(4);
    }
    let settings = &window.state().state().document.settings;
    if settings.window.plots && settings.plots.plot == PlotTab::Fit {
        wait_for(window, "the fit", |window| window.state().is_settled());
        window.run_steps(2);
    }
}

fn a_lesson_about_one_eye_has_one_wide_picture_until_another_layout_is_chosen() {
    let slide = Library::own().open("slide").expect("a lesson");
    let layout = |window: &Harness<'_, App>| window.state().state().document.settings.picture.layout;
    let views = |window: &Harness<'_, App>| {
        named(window, 0.0, 1280.0).into_iter().filter(|(name, _)| name.ends_with(" view")).collect::<Vec<_>>()
    };
    let mut window = window(&slide, [1280.0, 800.0]);
    let [(_, rect)] = &views(&window)[..] else { panic!("{:?}", views(&window)) };
    assert!(rect.width() > 900.0, "{rect:?}");
    // Both eyes again, by a choice that the next step of the lesson does not keep: it shows the same twice.
    window.state_mut().run(in_layout(Layout::SideBySide));
    window.run_steps(2);
    assert_eq!(views(&window).len(), 2);
    ask(&mut window, LessonCommand::Skip);
    ask(&mut window, LessonCommand::Forward);
    assert_eq!((layout(&window), views(&window).len()), (Layout::Left, 1));
    // Glasses are kept on.
    window.state_mut().run(in_layout(Layout::Anaglyph));
    window.run_steps(2);
    for _ in 0..12 {
        ask(&mut window, LessonCommand::Forward);
        assert_eq!(layout(&window), Layout::Anaglyph);
    }
    ask(&mut window, LessonCommand::Close);
    assert_eq!(layout(&window), Layout::Anaglyph);
    // Without a choice the layout before comes back.
    let mut window = self::window(&slide, [1280.0, 800.0]);
    assert_eq!(layout(&window), Layout::Left);
    ask(&mut window, LessonCommand::Close);
    assert_eq!(layout(&window), Layout::SideBySide);
}

/// Goes through all of `lesson` in `window`, and has `look` look at each of its places.
pub fn walk(window: &mut Harness<'_, App>, lesson: &Lesson, mut look: impl FnMut(&Harness<'_, App>, &str)) {
    for _ in 0..6 * lesson.steps.len() + 3 {
        let at = course(window).place();
        let name = format!("{} {}: {at:?}", lesson.name, lesson.title);
        assert!(window.state().state().scratch.notice.is_none(), "{name}");
        assert_is_as_told(window, &name);
        settle_words(window);
        look(window, &name);
        if let Some(asked) = course(window).asked().cloned() {
            ask(window, LessonCommand::Draft(Some(fitting(&asked.kind))));
            settle_words(window);
            look(window, &name);
            ask(window, LessonCommand::Predict);
            let record = course(window).record().expect("a step");
            assert_eq!(record.outcome, Some(made(fitting(&asked.kind), None)), "{name}");
            if is_running(window) {
                ask(window, LessonCommand::Forward);
            }
            continue;
        }
        let observation = course(window).step().and_then(|step| step.observation.clone());
        if let Some(observation) = observation.filter(|_| at.phase == Phase::Shown) {
            let other = (observation.options.right + 1) % observation.options.texts.len();
            ask(window, LessonCommand::Observe(other));
            settle_words(window);
            look(window, &name);
        }
        ask(window, LessonCommand::Forward);
        if is_running(window) {
            ask(window, LessonCommand::Forward);
        }
        if course(window).place() == at {
            assert!(at.step == lesson.steps.len() || lesson.is_a_preset(), "{name}: no way on");
            return;
        }
    }
    panic!("{}: no end", lesson.name);
}

/// Whether the window shows what the lesson says of its place.
fn assert_is_as_told(window: &Harness<'_, App>, name: &str) {
    let state = window.state().state();
    let at = course(window).place();
    if at.step == course(window).lesson().steps.len() {
        return;
    }
    let default = Settings::default().in_place_of(&state.document.settings);
    let told = course(window).lesson().settings(at.step, at.phase != Phase::Ask, &default).expect("settings");
    let of = |settings: &Settings| {
        let Settings { scene, motion, look, light, plots, map, fit, .. } = settings.clone();
        (scene, motion, look, light, plots, map, fit)
    };
    assert_eq!(of(&told), of(&state.document.settings), "{name}");
    if let Some(time) = told.time {
        assert!((time - state.document.time).abs() <= 1e-9 * (1.0 + time.abs()), "{name}");
    }
}

/// Where everything with a name is between `left` and `right`.
fn named(window: &Harness<'_, App>, left: f32, right: f32) -> Vec<(String, Rect)> {
    let nodes = window.root().children_recursive();
    let named = nodes.filter_map(|node| {
        let text = node.accesskit_node().label().or_else(|| node.accesskit_node().value())?;
        Some((text, node.rect()))
    });
    named.filter(|(_, rect)| rect.min.x >= left && rect.min.x < right && rect.is_positive()).collect()
}

fn the_end_of_a_lesson_leads_to_the_next_and_to_its_pages() {
    let library = Library::own();
    let colour = library.open("colour").expect("a lesson");
    let mut window = window(&colour, [1280.0, 800.0]);
    for _ in 0..40 {
        if matches!(course(&window).asked().map(|asked| &asked.kind), Some(AnswerKind::Curve(_))) {
            let drawn = Answer::Curve(vec![[-1.0, 1.0], [1.0, 1.0]]);
            ask(&mut window, LessonCommand::Draft(Some(drawn)));
        }
        if course(&window).step().is_some() {
            ask(&mut window, LessonCommand::Forward);
        }
    }
    assert_eq!(course(&window).step(), None);
    // Every prediction is counted, or said in a sentence.
    window.get_by_label("Predicted: 0 of 3 right, 3 skipped.");
    let told = labels(&window);
    assert!(
        told.iter().any(|label| label.starts_with("Step 2: a curve was drawn, rms difference ")),
        "{told:?}"
    );
    for page in ["Report…", "Worksheet…", "Lab…", "Teacher’s page…"] {
        window.get_by_role_and_label(Role::Button, page);
    }
    let next = library.after("colour").expect("there is one").clone();
    let name = labels(&window).into_iter().find(|label| label.starts_with("Next: ")).expect("a way on");
    press(&mut window, &name);
    assert_eq!(
        (course(&window).lesson().name.clone(), course(&window).place()),
        (next.name.clone(), Place::START)
    );
}

fn every_step_of_every_lesson_fits_and_shows_its_state() {
    // What stands beside the panel takes long and changes nothing in it.
    let parts = WindowSettings { plots: false, map: Presence::Off, ..WindowSettings::default() };
    for lesson in Library::own().all() {
        let mut window = window_with(parts, lesson, [1024.0, 600.0]);
        walk(&mut window, lesson, |window, name| {
            let fold = window.get_by_label("Fold the lesson").rect();
            let foot = window.get_by_role_and_label(Role::Button, "Back").rect();
            let panel = Rect::from_min_max(pos2(8.0, 38.0), pos2(308.0, 594.0));
            for (text, rect) in named(window, 0.0, 300.0).into_iter().filter(|(_, rect)| rect.min.y > 39.0) {
                assert!(panel.contains_rect(rect), "{name}: {text:?} at {rect:?} is out of the panel");
                let is_page = rect.min.y > fold.max.y && rect.min.y < foot.min.y - 2.0;
                assert!(
                    !is_page || rect.max.y <= foot.min.y,
                    "{name}: {text:?} at {rect:?} needs to be scrolled to"
                );
                let is_foot = ["Back", "Skip", "Predict", "Next", "Show the end", "Close", "Count hands"];
                let is_foot =
                    is_foot.iter().chain(&["Set up again", "All lessons"]).any(|foot| *foot == text)
                        || text.starts_with("Next: ");
                assert!(rect.min.y < foot.min.y - 2.0 || is_foot, "{name}: {text:?} at {rect:?}");
            }
        });
    }
}

fn every_step_of_every_lesson_fits_before_an_audience() {
    let size = [800.0, 600.0];
    let area = Rect::from_min_size(pos2(0.0, 0.0), size.into());
    for lesson in &some_lessons(2) {
        let mut window = window(lesson, size);
        window.state_mut().run(WindowCommand::TogglePresenting);
        window.run_steps(3);
        walk(&mut window, lesson, |window, name| {
            let words = named(window, 0.0, 800.0);
            assert!(words.iter().any(|(text, _)| text.starts_with(&lesson.title)), "{name}: no words");
            for (text, rect) in words {
                assert!(area.contains_rect(rect), "{name}: {text:?} at {rect:?}");
            }
        });
    }
}
