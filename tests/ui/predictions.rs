//! What is predicted with the mouse: curves that are drawn, places that are clicked; and the report of it all.

use eframe::egui::{Pos2, Rect, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::App;
use gamow::app::command::Command;
use gamow::app::running::LessonCommand;
use gamow::app::state::State;
use gamow::lesson::{Answer, Lesson, Outcome, Phase};
use gamow::settings::Settings;

use super::Test;
use super::support::{SEPARATION, TRACKED, drag, label_starting_with, labels, pane, seen, window};

pub const TESTS: &[Test] = &[
    ("a_drawn_curve_is_recorded_where_the_mouse_was", recorded_where_the_mouse_was),
    ("nothing_of_the_true_curve_is_shown_before_the_reveal", nothing_is_shown_before),
    ("a_drawn_curve_is_compared_with_the_core", compared_with_the_core),
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

### Explain

There.

## In a sentence

What comes is blue.
"#
    );
    Lesson::read("drawn", &text, "drawn.md").expect("a lesson")
}

fn at_lesson(beta: f64) -> Harness<'static, App> {
    let mut state = State::open(Settings::default()).expect("usual settings");
    state.begin_lesson(&lesson(beta)).expect("it can be worked out");
    window(state)
}

fn ask(window: &mut Harness<'_, App>, command: LessonCommand) {
    window.state_mut().ask(Command::Lesson(command));
    window.run_ok();
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

fn shot(window: &mut Harness<'_, App>, name: &str) {
    window.run_ok();
    window.render().expect("drawn").save(format!("/tmp/draw-{name}.png")).expect("saved");
}

fn recorded_where_the_mouse_was() {
    let mut window = at_lesson(0.9);
    shot(&mut window, "empty");
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
    shot(&mut window, "drawn");
    for ([time, value], [_, before]) in draft(&window).into_iter().zip(points) {
        let expected = if (0.9..=5.1).contains(&time) { 3.0 } else { before };
        assert!((value - expected).abs() < 1e-3, "at {time}: {value} for {expected}");
    }
    assert!(labels(&window).iter().all(|label| label != INVITATION));
    window.get_by_label("Clear").click();
    window.run_ok();
    assert_eq!(window.state().state().course().expect("a lesson").draft, None);
}

fn nothing_is_shown_before() {
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

fn compared_with_the_core() {
    let mut window = at_lesson(0.9);
    let frame = frame(&window);
    drag(&mut window, place(frame, [-8.0, 3.5]), place(frame, [8.0, 1.5]));
    let points = draft(&window);
    ask(&mut window, LessonCommand::Predict);
    for _ in 0..8 {
        window.step();
    }
    shot(&mut window, "revealed");
    let squares = points.iter().map(|[time, value]| (value - seen(0.9, *time, 0).doppler_factor).powi(2));
    let expected = (squares.sum::<f64>() / points.len() as f64).sqrt();
    let text = label_starting_with(&window, "rms difference ");
    let number: f64 = text.split(' ').nth(2).and_then(|word| word.parse().ok()).expect("a number");
    assert!((number / expected - 1.0).abs() < 0.06, "{text} for {expected}");
    assert!(text.ends_with("over T = −8.0 to 8.0") || text.ends_with("over T = −7.8 to 7.8"), "{text}");
    let legend = label_starting_with(&window, "Legend of the sketch: ");
    assert!(legend.contains("true curve") && legend.contains("your curve"), "{legend}");
    // The usual plots are a click away, and the curve another.
    window.get_by_label("Plots").click();
    window.run_ok();
    shot(&mut window, "usual");
    window.get_by_label("Plot of Δφ of front tyre against T");
    window.get_by_label("Your curve").click();
    window.run_ok();
    label_starting_with(&window, "rms difference ");
    ask(&mut window, LessonCommand::Forward);
    assert_eq!(window.state().state().course().expect("a lesson").place().phase, Phase::Explained);
    label_starting_with(&window, "rms difference ");
    window.state_mut().ask(Command::TogglePresenting);
    window.run_ok();
    shot(&mut window, "presented");
    let _ = (TRACKED, SEPARATION, pane(&window, 0), Outcome::Skipped);
}
