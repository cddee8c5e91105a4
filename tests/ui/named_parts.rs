//! Whatever a lesson names is on the screen: each step of each lesson in the usual window, before an
//! audience, in the projector's window and on a phone.
//!
//! A text names a part by a phrase of [`PARTS`], by a name in quotation marks, or by one in italics. Italics
//! and quotation marks that name no part are known as such ([`STRESSED`]), so that a new name cannot pass
//! unnoticed.

use std::collections::BTreeMap;
use std::sync::Arc;

use egui_kittest::Harness;
use egui_kittest::kittest::NodeT as _;
use gamow::app::commands::WindowCommand;
use gamow::app::shell::App;
use gamow::lesson::{AnswerKind, Course, Lesson, Phase};

use super::Test;
use super::lessons::{course, walk, window};
use super::support::{PaintedText, all_lessons, painted_texts, some_lessons};

pub const TESTS: &[Test] = trials![
    the_window_shows_what_a_lesson_names,
    an_audience_is_shown_what_a_lesson_names,
    the_projectors_window_shows_what_a_lesson_names,
    a_phone_shows_what_a_lesson_names,
    a_part_that_is_hidden_is_missed,
];

/// What can be read off a window: the texts that are painted in sight, and the names for assistive
/// technology.
struct Screen {
    painted: Vec<String>,
    named: Vec<String>,
}

impl Screen {
    fn of(window: &Harness<'_, App>) -> Self {
        let area = window.ctx.content_rect();
        // As far as they are written out, with their middle in sight.
        let is_shown = |text: &PaintedText| {
            let middle = text.shape.pos + text.shape.galley.rect.center().to_vec2();
            text.clip.intersect(area).contains(middle)
        };
        let texts = painted_texts(window).into_iter().filter(is_shown);
        let painted =
            texts.flat_map(|text| text.shape.galley.rows.iter().map(|row| row.text()).collect::<Vec<_>>());
        let painted = painted.collect();
        let named = window.root().children_recursive().filter_map(|node| {
            let name = node.accesskit_node().label().or_else(|| node.accesskit_node().value())?;
            area.intersects(node.rect()).then_some(name)
        });
        Self { painted, named: named.collect() }
    }

    fn paints(&self, text: &str) -> usize {
        let text = text.to_lowercase();
        self.painted.iter().filter(|painted| painted.to_lowercase().contains(&text)).count()
    }

    fn names(&self, is_meant: impl Fn(&str) -> bool) -> usize {
        self.named.iter().filter(|name| is_meant(name)).count()
    }
}

/// A part of the window: the phrases that name it, and how often it is on a screen.
type Part = (&'static [&'static str], fn(&Screen) -> usize);

const PARTS: &[Part] = &[
    (&["the map"], |screen| screen.names(|name| name.starts_with("Map, "))),
    (&["both events", "two events lies", "the two marks"], |screen| {
        let [left, right] = ["left", "right"]
            .map(|eye| screen.names(|name| name.ends_with(&format!(", as the {eye} eye sees it"))));
        left.min(right)
    }),
    (&["pink"], |screen| screen.paints("two eyes")),
    (&["how does the ground's \"now\" lie"], |screen| screen.paints("now, ground")),
    (&["dashed is", "on this axis", "in the plot", "draw "], |screen| {
        screen.names(|name| name.starts_with("Plot of") || name.starts_with("Plot to"))
    }),
    (&["the fitted curve"], |screen| screen.names(|name| name.starts_with("Fit of"))),
    (&["the residuals"], |screen| screen.paints("residual")),
    (&["the strip", "colours of the strip"], |screen| {
        screen.names(|name| name.starts_with("Rapidity ruler") && name.contains("spectrum"))
    }),
    (&["the ruler"], |screen| screen.names(|name| name.starts_with("Rapidity ruler"))),
    (&["the arrow", "thin outline"], |screen| screen.paints("η = ")),
    (&["the dial"], |screen| screen.names(|name| name.starts_with("Clock of"))),
    (&["white dial"], |screen| screen.names(|name| name.starts_with("Clock beside you"))),
    (&["number below each dial"], |screen| screen.names(|name| name.ends_with(" turns"))),
    (&["the ring around its lamp"], |screen| screen.names(|name| name.starts_with("Clock of lamp"))),
    (&["number at the ring"], |screen| screen.paints(" away")),
    (&["the clock on your handlebar", "your clock shows"], |screen| screen.paints("my clock")),
    (&["the instruments"], |screen| screen.paints("at x = ")),
    (&["your odometer"], |screen| screen.paints("ridden")),
    (&["the clock of the street"], |screen| {
        screen.paints("clock of the street here") + screen.paints("street’s clock")
    }),
    (&["the first picture", "the first with"], |screen| screen.names(|name| name.contains(" view: ")) / 2),
];

/// Italics and quotation marks that stress a word, and name no part.
const STRESSED: &[&str] = &[
    "own clock",
    "d",
    "work it out",
    "measure",
    "measures",
    "measured",
    "now",
    "arrive",
    "energy",
    "received",
    "happened",
    "measured abreast",
    "seen abreast",
    "bootstrap",
    "readings",
    "model",
    "systematic",
    "made",
    "rests",
    "see",
    "reckoning",
    "earlier",
    "front",
    "rapidity",
    "he",
    "you",
    "in",
    "its",
    "frames",
    "one time",
    "what you saw",
];

/// The texts of the present place, in Markdown, a paragraph each.
fn told(course: &Course, is_running: bool) -> Vec<String> {
    let Some(step) = course.step() else { return Vec::new() };
    let mut texts = Vec::new();
    let choices = |options: &gamow::lesson::Options| -> Vec<String> {
        options.texts.iter().map(|text| text.markdown.source().to_owned()).collect()
    };
    match course.place().phase {
        Phase::Ask => {
            texts.push(step.text.markdown.source().to_owned());
            if let Some(prediction) = &step.prediction {
                texts.push(prediction.question.markdown.source().to_owned());
                if let AnswerKind::Choice(options) = &prediction.kind {
                    texts.extend(choices(options));
                }
            }
        }
        Phase::Shown if is_running => {}
        Phase::Shown => {
            texts.extend(step.reveal.iter().map(|reveal| reveal.text.markdown.source().to_owned()));
            if let Some(observation) = &step.observation {
                texts.push(observation.question.markdown.source().to_owned());
                texts.extend(choices(&observation.options));
            }
        }
        Phase::Explained => texts.push(step.explanation.markdown.source().to_owned()),
    }
    texts
}

/// What stands between two `marks` in `text`: names in italics or in quotation marks.
fn between(text: &str, mark: char) -> Vec<&str> {
    text.split(mark).skip(1).step_by(2).map(str::trim).filter(|name| !name.is_empty()).collect()
}

/// How often a part with this name, in italics or quotation marks, is on the `screen`; `None` for a word that
/// is only stressed.
fn by_name(name: &str, screen: &Screen) -> Option<usize> {
    let is_speed = name.strip_suffix(" c").is_some_and(|number| number.parse::<f64>().is_ok());
    if is_speed || name == "abreast" {
        let is_tick = |label: &str| label.starts_with("Rapidity ruler") && label.contains(name);
        return Some(screen.names(is_tick));
    }
    (!STRESSED.contains(&name.to_lowercase().as_str())).then(|| {
        // The text itself, and the choices, are no proof.
        let is_part = |painted: &&String| {
            painted.to_lowercase().contains(&name.to_lowercase())
                && painted.chars().count() < name.chars().count() + 60
        };
        screen.painted.iter().filter(is_part).filter(|painted| !painted.contains('"')).count()
    })
}

/// What was looked for: how often each part, and what was missed.
#[derive(Default)]
struct Found {
    seen: BTreeMap<String, usize>,
    missed: Vec<String>,
}

impl Found {
    /// Looks on the `screen` for `least` of each part that `texts` name.
    fn look_for(&mut self, texts: &[String], screen: &Screen, least: usize, place: &str) {
        for text in texts {
            let plain = without_formulas(text);
            let lower = plain.replace('*', "").to_lowercase();
            let phrases = |(phrases, count): &'static Part| {
                let said = phrases.iter().filter(|phrase| lower.contains(**phrase));
                said.map(|phrase| (*phrase, Some(count(screen))))
            };
            let italics = plain.replace("**", "");
            let by_names = between(&italics, '*').into_iter().chain(between(&plain, '"'));
            // The words of the lesson are no proof: names in italics are painted by themselves.
            let said = |name: &str| {
                texts.iter().map(|text| text.matches(&format!("*{name}*")).count()).sum::<usize>()
            };
            let by_names = by_names.map(|name| {
                let is_tick = name == "abreast" || name.ends_with(" c");
                let own = if is_tick { 0 } else { least * said(name) };
                (name, by_name(name, screen).map(|count| count.saturating_sub(own)))
            });
            for (part, count) in PARTS.iter().flat_map(phrases).chain(by_names) {
                let Some(count) = count else { continue };
                *self.seen.entry(part.to_owned()).or_default() += 1;
                if count < least {
                    self.missed.push(format!("{place}: {part:?} of {text:?}"));
                }
            }
        }
    }
}

fn without_formulas(text: &str) -> String {
    text.split('$').step_by(2).collect::<Vec<_>>().join(" ")
}

/// Goes through `lessons` in windows of this `size`, as `arranged`, and looks for `least` of each part.
/// Returns the parts that they name.
fn look_at(
    lessons: &[Arc<Lesson>],
    size: [f32; 2],
    least: usize,
    arranged: impl Fn(&mut Harness<'static, App>),
) -> BTreeMap<String, usize> {
    let mut found = Found::default();
    for lesson in lessons {
        let mut window = window(lesson, size);
        arranged(&mut window);
        walk(&mut window, lesson, |window, name| {
            let running = window.state().state().session.lesson.as_ref().expect("a lesson").is_running();
            found.look_for(&told(course(window), running), &Screen::of(window), least, name);
        });
    }
    let Found { seen, missed } = found;
    assert!(missed.is_empty(), "not on the screen, and not known as stressed:\n{}", missed.join("\n"));
    seen
}

fn the_window_shows_what_a_lesson_names() {
    let seen = look_at(&all_lessons(), [1280.0, 800.0], 1, |_| {});
    // Each phrase is used, so that none passes because nobody says it.
    let unused: Vec<_> = PARTS
        .iter()
        .flat_map(|(phrases, _)| *phrases)
        .filter(|phrase| !seen.contains_key(**phrase))
        .collect();
    assert!(unused.is_empty(), "no lesson says {unused:?}: {seen:?}");
    for name in ["abreast", "measured now", "left eye sees", "my clock", "ridden"] {
        assert!(seen.contains_key(name), "no lesson names {name:?}: {seen:?}");
    }
}

fn an_audience_is_shown_what_a_lesson_names() {
    look_at(&some_lessons(0), [1366.0, 768.0], 1, |window| {
        window.state_mut().run(WindowCommand::TogglePresenting);
        window.run_steps(4);
    });
}

/// Without a system that has windows it stands in this one: what a lesson names is there twice.
fn the_projectors_window_shows_what_a_lesson_names() {
    look_at(&some_lessons(1), [1920.0, 1080.0], 2, |window| {
        window.state_mut().run(WindowCommand::ToggleProjector);
        window.run_steps(4);
    });
}

fn a_phone_shows_what_a_lesson_names() {
    look_at(&some_lessons(2), [360.0, 740.0], 1, |_| {});
}

/// A window that shows nothing of what the table names has none of it: each row can fail.
fn a_part_that_is_hidden_is_missed() {
    let lesson = gamow::lesson::Lesson::read("bare", BARE, "bare.md").expect("a lesson");
    let screen = Screen::of(&window(&lesson, [1280.0, 800.0]));
    for (phrases, count) in PARTS {
        assert_eq!(count(&screen), 0, "{phrases:?}");
    }
    for name in ["abreast", "0.5 c", "measured now", "my clock", "ridden"] {
        assert_eq!(by_name(name, &screen), Some(0), "{name}");
    }
}

const BARE: &str = r#"---
title: Bare
---

## Nothing

```state
scene = "cube"

[picture]
layout = "left"

[window]
controls = false
ruler = false
readout = false
sentence = false
spectrum = false
dials = false
map = "off"
plots = false
```

Look.
"#;
