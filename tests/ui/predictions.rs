//! What is predicted with the mouse: curves that are drawn, places that are clicked; and the report of it
//! all.

use eframe::egui::{Event, Key, Modifiers, Pos2, Rect, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use gamow::app::commands::{Command, PlaybackCommand, WindowCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::lesson::LessonCommand;
use gamow::eye::Eye;
use gamow::lesson::{Answer, Lesson, Outcome, Phase, Place, Record, verdict};
use gamow::settings::Settings;
use glam::{DQuat, DVec3};
use relativity_render::Gaze;

use super::Test;
use super::saving::save;
use super::support::{drag, label_starting_with, labels, pane, seen, type_into, wide_window, window};

pub const TESTS: &[Test] = trials![
    a_number_that_is_none_stays_where_it_was_typed,
    a_letter_that_no_number_contains_is_a_command_in_the_field_of_one,
    a_drawn_curve_is_recorded_where_the_mouse_was,
    nothing_of_the_true_curve_is_shown_before_the_reveal,
    a_drawn_curve_is_compared_with_the_core,
    a_curve_is_drawn_before_an_audience_too,
    a_click_into_a_view_predicts_a_place_and_selects_nothing,
    a_place_on_the_body_or_near_it_is_right,
    the_report_of_a_lesson_holds_what_was_done_and_nothing_from_elsewhere,
];

/// A lesson at this speed that has a curve drawn, then a place clicked.
fn lesson(beta: f64) -> Lesson {
    let text = format!(
        r#"---
title: Drawn and clicked
---

It rides by.

## A curve

```state
scene = "cyclist"
time = -6

[motion]
beta = {beta}

[playback]
range = "-10,10"

[window]
plots = false
```

### Predict

How does its colour change?

```curve
of = "doppler"
from = 0
to = 5
```

### Reveal

```play
time = 4
seconds = 0.1
```

### Explain

It turns red.

## A place

```state
time = -4
```

### Predict

Where is its front tyre seen?

```point
body = "front tyre"
```

### Reveal

```state
time = 3
```

### Observe

Was it there?

- [x] It was *further on*.
- [ ] It was there.

### Explain

Its light is late by $t$.

## Never reached

### Predict

Is this told?

- [x] The secret.
- [ ] No.

### Reveal

It is told.

## In a sentence

What comes is blue.
"#
    );
    Lesson::read("drawn", &text, "drawn.md").expect("a lesson")
}

fn at_lesson(beta: f64) -> Harness<'static, App> {
    let mut state = State::open(Settings::default()).expect("usual settings");
    state.begin_lesson(&lesson(beta)).expect("it can be worked out");
    wide_window(state)
}

fn ask(window: &mut Harness<'_, App>, command: LessonCommand) {
    window.state_mut().run(Command::Lesson(command));
    window.run_ok();
}

/// A window with a lesson that asks for a number.
fn asked_for_a_number() -> Harness<'static, App> {
    let text = "---\ntitle: Asked\n---\n\n## One\n\n### Predict\n\nHow much?\n\n```number\ntruth = \"gamma\"\n```\n\n### Reveal\n\nSo.\n";
    let lesson = Lesson::read("asked", text, "asked.md").expect("a lesson");
    let mut state = State::open(Settings::default()).expect("usual settings");
    state.begin_lesson(&lesson).expect("it can be worked out");
    window(state)
}

/// Types `text` by the keys that its letters are on.
fn type_keys(window: &mut Harness<'_, App>, keys: &[(Key, &str)]) {
    for (key, text) in keys {
        let pressed = |pressed| Event::Key {
            key: *key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers: Modifiers::NONE,
        };
        window.input_mut().events.extend([pressed(true), Event::Text((*text).to_owned()), pressed(false)]);
        window.run();
    }
}

fn a_letter_that_no_number_contains_is_a_command_in_the_field_of_one() {
    let mut window = asked_for_a_number();
    window.run();
    let drafted = |window: &Harness<'_, App>| {
        let course = window.state().state().course().expect("a lesson");
        course.draft.clone()
    };
    type_keys(&mut window, &[(Key::Num2, "2"), (Key::E, "e"), (Key::Num3, "3")]);
    assert_eq!(drafted(&window), Some(Answer::Number(2e3)));
    let map = window.state().state().document.settings.window.map;
    type_keys(&mut window, &[(Key::M, "m")]);
    assert_ne!(window.state().state().document.settings.window.map, map);
    assert_eq!(drafted(&window), Some(Answer::Number(2e3)), "the letter is not typed");
    assert!(!window.ctx.text_edit_focused(), "and the field is left");
    // Where words are typed a letter is one of them.
    window.key_press_modifiers(Modifiers::COMMAND, Key::P);
    window.run();
    type_keys(&mut window, &[(Key::P, "p")]);
    assert!(!window.state().state().session.stage.is_presented());
    assert_eq!(window.get_by_label("Command").value().as_deref(), Some("p"));
}

fn a_number_that_is_none_stays_where_it_was_typed() {
    let mut window = asked_for_a_number();
    let is = "is not a number: type one such as 1.25 or 2e-3.";
    for typed in ["1.2.3", "about two", "1e309", "NaN"] {
        type_into(&mut window, "Predicted number", typed);
        assert_eq!(window.get_by_label("Predicted number").value().as_deref(), Some(typed));
        window.get_by_label(&format!("“{typed}” {is}"));
        assert!(window.state().state().course().expect("a lesson").draft.is_none());
    }
    type_into(&mut window, "Predicted number", "1,5");
    let made = Outcome::Made { answer: Answer::Number(1.5), confidence: None };
    assert_eq!(window.state().state().course().expect("a lesson").records()[0].outcome, Some(made));
    assert!(labels(&window).iter().all(|label| !label.contains(is)));
}

const EMPTY: &str = "Plot to draw D of front tyre against T into";
const INVITATION: &str = "Draw the curve that you expect: press and drag.";

fn frame(window: &Harness<'_, App>) -> Rect {
    window.get_by_label(EMPTY).rect()
}

/// Where a T and a value are in a plot that shows T from -10 to 10 and values from 0 to 5.
fn place(frame: Rect, [time, value]: [f64; 2]) -> Pos2 {
    let (x, y) = ((time + 10.0) / 20.0, 1.0 - value / 5.0);
    frame.min + vec2(x as f32 * frame.width(), y as f32 * frame.height())
}

fn draft(window: &Harness<'_, App>) -> Vec<[f64; 2]> {
    match &window.state().state().course().expect("a lesson").draft {
        Some(Answer::Curve(points)) => points.clone(),
        other => panic!("no curve: {other:?}"),
    }
}

fn a_drawn_curve_is_recorded_where_the_mouse_was() {
    let mut window = at_lesson(0.9);
    let frame = frame(&window);
    assert!(frame.width() > 300.0 && frame.height() > 100.0, "though the plots are off: {frame:?}");
    window.get_by_label(INVITATION);
    let ends = [[-7.93, 4.1], [7.91, 0.5]];
    drag(&mut window, place(frame, ends[0]), place(frame, ends[1]));
    let points = draft(&window);
    assert!((90..=100).contains(&points.len()), "a sample each sixth of a unit: {}", points.len());
    for &[time, value] in &points {
        let expected = 4.1 + (0.5 - 4.1) * (time + 7.93) / (7.91 + 7.93);
        assert!((value - expected).abs() < 1e-3, "at {time}: {value} for {expected}");
    }
    assert!(points[0][0] < -7.7 && points[points.len() - 1][0] > 7.7);
    // Backwards over a part of it: that part is replaced.
    drag(&mut window, place(frame, [5.1, 3.0]), place(frame, [0.9, 3.0]));
    for ([time, value], [_, before]) in draft(&window).into_iter().zip(points) {
        let expected = if (0.9..=5.1).contains(&time) { 3.0 } else { before };
        assert!((value - expected).abs() < 1e-3, "at {time}: {value} for {expected}");
    }
    assert!(labels(&window).iter().all(|label| label != INVITATION));
    window.get_by_label("Clear").click();
    window.run_ok();
    assert_eq!(window.state().state().course().expect("a lesson").draft, None);
}

fn nothing_of_the_true_curve_is_shown_before_the_reveal() {
    let mut of_speeds = [0.9, 0.2].map(|beta| {
        let mut window = at_lesson(beta);
        let frame = frame(&window);
        drag(&mut window, place(frame, [-5.0, 2.0]), place(frame, [5.0, 2.0]));
        window.hover_at(pos2(1.0, 1.0));
        window.run_ok();
        let told = labels(&window);
        assert!(told.iter().all(|label| !label.contains("true") && !label.contains("rms")), "{told:?}");
        window.render().expect("drawn")
    });
    let [a, b] = &mut of_speeds;
    let around = frame(&at_lesson(0.9)).expand2(vec2(40.0, 15.0));
    let [x, y] = [around.min.x as u32, around.min.y as u32];
    let mut pixels = 0;
    for x in x..around.max.x as u32 {
        for y in y..around.max.y as u32 {
            assert_eq!(a.get_pixel(x, y), b.get_pixel(x, y), "at {x}, {y}");
            pixels += 1;
        }
    }
    assert!(pixels > 30_000);
}

fn difference(window: &Harness<'_, App>) -> String {
    labels(window).into_iter().find(|label| label.starts_with("rms difference ")).expect("it is told")
}

fn a_drawn_curve_is_compared_with_the_core() {
    let mut window = at_lesson(0.9);
    let frame = frame(&window);
    drag(&mut window, place(frame, [-8.05, 3.5]), place(frame, [8.05, 1.5]));
    let points = draft(&window);
    ask(&mut window, LessonCommand::Predict);
    for _ in 0..8 {
        window.step();
    }
    let squares = points.iter().map(|[time, value]| (value - seen(0.9, *time, 0).doppler_factor).powi(2));
    let expected = (squares.sum::<f64>() / points.len() as f64).sqrt();
    let text = difference(&window);
    let number: f64 = text.split(' ').nth(2).and_then(|word| word.parse().ok()).expect("a number");
    assert!((number / expected - 1.0).abs() < 0.06, "{text} for {expected}");
    assert!(text.ends_with("over T = −8.0 to 8.0"), "{text}");
    let legend = label_starting_with(&window, "Legend of the sketch: ");
    assert!(legend.contains("true curve") && legend.contains("your curve"), "{legend}");
    // The usual plots are a click away, and the curve another.
    window.get_by_label("All plots").click();
    window.run_ok();
    window.get_by_label("Plot of Δφ of front tyre against T");
    window.get_by_label("Your curve").click();
    window.run_ok();
    difference(&window);
    ask(&mut window, LessonCommand::Forward);
    assert_eq!(window.state().state().course().expect("a lesson").place().phase, Phase::Explained);
    difference(&window);
    // Before an audience the words of the reveal tell it.
    ask(&mut window, LessonCommand::Back);
    window.state_mut().run(WindowCommand::TogglePresenting);
    window.run_ok();
    let number = text.split(' ').nth(2).expect("a number");
    let is_told = |label: &String| label.contains(&format!("rms difference {number}"));
    assert!(labels(&window).iter().any(is_told), "{:?}", labels(&window));
}

fn a_curve_is_drawn_before_an_audience_too() {
    let mut window = at_lesson(0.9);
    window.state_mut().run(WindowCommand::TogglePresenting);
    window.run_ok();
    let frame = frame(&window);
    drag(&mut window, place(frame, [-8.05, 3.5]), place(frame, [8.05, 1.5]));
    let points = draft(&window);
    assert_eq!(points.len(), 97);
    for [time, value] in points {
        let expected = 3.5 - 2.0 * (time + 8.05) / 16.1;
        assert!((value - expected).abs() < 1e-3, "at {time}: {value} for {expected}");
    }
}

/// At the step that asks for a place.
fn at_the_place() -> Harness<'static, App> {
    let mut window = at_lesson(0.9);
    for command in [LessonCommand::Skip, LessonCommand::GoTo(Place { step: 1, phase: Phase::Ask })] {
        ask(&mut window, command);
    }
    window
}

const HINT: &str = "Click where you expect the front tyre to be seen.";

fn click(window: &mut Harness<'_, App>, place: Pos2) {
    window.hover_at(place);
    window.step();
    window.drag_at(place);
    window.step();
    window.drop_at(place);
    window.run_ok();
}

/// The direction that is marked under this name in the view of an eye, by the camera of that eye.
fn marked(window: &Harness<'_, App>, eye: Eye, name: &str) -> DVec3 {
    let pane = pane(window, eye.index());
    let at = window.get_by_label(&format!("{name}, {}", eye.name())).rect().center() - pane.min;
    let size = [pane.width(), pane.height()].map(|side| side.round() as u32);
    let camera = window.state().state().view(eye, size).camera;
    camera.line_of_sight([at.x, at.y].map(f64::from))
}

/// What the core says of the tracked point at this T.
fn direction(time: f64, eye: usize) -> DVec3 {
    DVec3::from(seen(0.9, time, eye).position).normalize()
}

fn a_click_into_a_view_predicts_a_place_and_selects_nothing() {
    let mut window = at_the_place();
    let hints = labels(&window).iter().filter(|label| *label == HINT).count();
    assert_eq!(hints, 3, "in both views and in the panel");
    let before = window.state().state().document.points.clone();
    let there = pane(&window, 1).min + vec2(90.0, 60.0);
    let expected = {
        let (state, pane) = (window.state().state(), pane(&window, 1));
        let size = [pane.width(), pane.height()].map(|side| side.round() as u32);
        state.view(Eye::Right, size).camera.line_of_sight([90.0, 60.0])
    };
    click(&mut window, there);
    let state = window.state().state();
    assert_eq!(state.document.points, before, "nothing else is selected");
    assert_eq!(state.scratch.missed, None);
    let Some(Answer::Direction(gaze)) = state.course().expect("a lesson").draft else { panic!("no answer") };
    assert!(gaze.axes().forward.angle_between(expected) < 1e-3);
    for eye in Eye::BOTH {
        assert!(marked(&window, eye, "Predicted place").angle_between(expected) < 2e-3, "{eye:?}");
    }
    assert!(labels(&window).iter().all(|label| !label.starts_with("Where the front tyre is seen")));
    ask(&mut window, LessonCommand::Predict);
    for eye in Eye::BOTH {
        let off =
            marked(&window, eye, "Where the front tyre is seen").angle_between(direction(3.0, eye.index()));
        assert!(off < 2e-3, "{eye:?}: {off}");
    }
    let state = window.state().state();
    let course = state.course().expect("a lesson");
    let verdict =
        verdict(&course.lesson().steps[1], &course.records()[1], &state.sight()).expect("predicted");
    assert_eq!(verdict.right, Some(false));
    let degrees = expected.angle_between(direction(3.0, 0)).to_degrees();
    let told = verdict.is.rsplit(", ").next().and_then(|text| text.split_once(" degrees "));
    let (number, side) = told.expect("an angle, and a side");
    let number: f64 = number.parse().expect("an angle");
    assert!((number - degrees).abs() <= 0.5, "{} for {degrees}", verdict.is);
    // +x is to the right of eyes that look along +y.
    let is_left = direction(3.0, 0).x < expected.x;
    assert!(side.contains(if is_left { "left" } else { "right" }), "{side}");
}

fn a_place_on_the_body_or_near_it_is_right() {
    let window = at_the_place();
    let state = window.state().state();
    let mut course = state.course().expect("a lesson").clone();
    let mut right = |direction: DVec3| {
        course.go_to(Place { step: 1, phase: Phase::Ask });
        let answer = Answer::Direction(Gaze::along(direction.into()));
        let outcome = Outcome::Made { answer, confidence: None };
        let record = Record { outcome: Some(outcome), observed: None };
        let mut shown = state.clone();
        shown.run(PlaybackCommand::GoTo(3.0));
        verdict(&course.lesson().steps[1], &record, &shown.sight()).expect("predicted").right
    };
    let seen = direction(3.0, 0);
    let turned = |degrees: f64| DQuat::from_rotation_z(degrees.to_radians()) * seen;
    let off = |degrees: f64| turned(degrees).angle_between(seen).to_degrees();
    assert!(off(1.8) < 2.0 && off(30.0) > 10.0);
    assert_eq!([right(seen), right(turned(1.8)), right(turned(-1.8))], [Some(true); 3]);
    assert_eq!([right(turned(30.0)), right(turned(-30.0)), right(-seen)], [Some(false); 3]);
    // Across the wheel from its tracked point is its rim again, more than 2 degrees away.
    let view = state.clone();
    let on_tyre = (-400..400).map(|tenth| turned(0.1 * f64::from(tenth))).find(|direction| {
        let mut shown = view.clone();
        shown.run(PlaybackCommand::GoTo(3.0));
        let hit = shown.document.prepared.first_hit(&shown.view(Eye::Left, [400, 300]), *direction);
        let far = direction.angle_between(seen).to_degrees() > 3.0;
        far && hit.is_some_and(|hit| shown.document.scene.name_of(hit.body) == "front tyre")
    });
    assert_eq!(right(on_tyre.expect("a wheel is wide")), Some(true));
}

fn the_report_of_a_lesson_holds_what_was_done_and_nothing_from_elsewhere() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("done.html");
    let mut window = at_lesson(0.9);
    let frame = frame(&window);
    drag(&mut window, place(frame, [-8.05, 3.5]), place(frame, [8.05, 1.5]));
    ask(&mut window, LessonCommand::Confidence(Some(gamow::lesson::Confidence::Sure)));
    ask(&mut window, LessonCommand::Predict);
    for _ in 0..8 {
        window.step();
    }
    let off = difference(&window);
    ask(&mut window, LessonCommand::GoTo(Place { step: 1, phase: Phase::Ask }));
    ask(&mut window, LessonCommand::Skip);
    ask(&mut window, LessonCommand::Observe(1));
    ask(&mut window, LessonCommand::GoTo(Place { step: 2, phase: Phase::Ask }));
    assert_eq!(save(&mut window, "Report of the lesson…", &path), "Saved done.html.");
    let page = std::fs::read_to_string(&path).expect("it is written");
    for told in [
        "<h1>Drawn and clicked</h1>",
        "How does its colour change?",
        "the dashed curve (sure)",
        &off,
        "true curve</text>",
        "drawn curve</text>",
        "Where is its front tyre seen?",
        "nothing (skipped)",
        "It is:</strong> at <em>",
        "<strong>Observed:</strong> It was there.",
        "It was <em>further on</em>.",
        "Its light is late by <svg",
        "Never reached",
        "Not done.",
    ] {
        assert!(page.contains(told), "{told}: {page}");
    }
    for hidden in ["The secret", "What comes is blue"] {
        assert!(!page.contains(hidden), "{hidden}");
    }
    // All that it shows is in it.
    let addresses: Vec<&str> = ["src=\"", "href=\"", "url(", "@import"]
        .iter()
        .flat_map(|holder| page.split(holder).skip(1))
        .filter(|rest| !rest.starts_with("data:image/png;base64,") && !rest.starts_with('#'))
        .collect();
    assert!(addresses.is_empty(), "{addresses:?}");
    assert_eq!(page.matches("data:image/png").count(), 2, "a picture of each step that was done");
    // Without a lesson there is none.
    ask(&mut window, LessonCommand::Close);
    window.get_by_label("File").click();
    window.run_ok();
    assert!(window.get_by_label("Report of the lesson…").accesskit_node().is_disabled());
}
