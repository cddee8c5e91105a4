//! The audience's window under any sequence of the presenter's two keys.

use eframe::egui::{FontId, Key, Pos2, Rect};
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT as _;
use gamow::app::commands::WindowCommand;
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::lesson::LessonCommand;
use gamow::lesson::{Course, Phase};
use gamow::settings::{MapFace, PlotTab, Presence, Preset, Settings};

use super::Test;
use super::random_user::dice::Dice;
use super::support::{settle, some_lessons, sweep, window_without_pictures};

pub const TESTS: &[Test] = trials![
    a_preset_about_a_fit_shows_an_audience_its_readings_residuals_and_numbers,
    an_audience_reads_every_word_of_every_lesson,
    no_press_of_a_presenters_two_keys_hides_a_plot_or_a_text,
];

const SEED: u64 = 31;
/// Presses in each lesson, of the usual tests and of the whole sweep.
const PRESSES: [usize; 2] = [20, 50];
/// The least part of the screen that the readings of a fit have; other plots and the map have half of it.
const READINGS: f32 = 0.125;

/// A window that is presented.
fn presented(state: State, size: [f32; 2]) -> Harness<'static, App> {
    let mut window = window_without_pictures(state, size);
    window.state_mut().run(WindowCommand::TogglePresenting);
    window.run_steps(4);
    window
}

/// Everything that has a name, and where it is.
fn named(window: &Harness<'_, App>) -> Vec<(String, Rect)> {
    let nodes = window.root().children_recursive();
    let named = nodes.filter_map(|node| {
        Some((node.accesskit_node().label().or_else(|| node.accesskit_node().value())?, node.rect()))
    });
    named.collect()
}

fn a_preset_about_a_fit_shows_an_audience_its_readings_residuals_and_numbers() {
    for size in [[1280.0, 800.0], [1920.0, 1080.0], [1024.0, 600.0]] {
        for preset in Preset::all().iter().filter(|preset| preset.settings.plots.plot == PlotTab::Fit) {
            let mut state = State::open(preset.settings.clone()).expect("a preset");
            state.document.preset = Some(preset);
            let mut window = presented(state, size);
            settle(&mut window);
            let all = named(&window);
            let of = |name: &str| all.iter().find(|(label, _)| label.starts_with(name));
            for (name, least) in
                [("Fit of Δφ against T", READINGS), ("Residuals of Δφ against T", 0.5 * READINGS)]
            {
                let (_, rect) = of(name).unwrap_or_else(|| panic!("{name} of {} in {size:?}", preset.name));
                assert!(rect.area() >= least * size[0] * size[1], "{name} at {rect:?} in {size:?}");
            }
            let is_right = preset.name == "measuring";
            let uncertainty = if is_right { "Uncertainty of β: 0.00" } else { "Uncertainty of β: —" };
            for number in ["Fitted β: 0.9", uncertainty, "True β: 0.9", "β off by "] {
                assert!(of(number).is_some(), "{number} of {} in {size:?}", preset.name);
            }
            let verdict = if is_right { "Agrees with the truth" } else { "Wrong: β is 1" };
            assert!(of(verdict).is_some(), "{verdict} of {} in {size:?}", preset.name);
        }
    }
}

/// The least height of writing, as a part of the screen's.
const LEAST: f32 = 0.03;

/// Every line at each place of each lesson is high enough, and on the screen.
fn an_audience_reads_every_word_of_every_lesson() {
    let size = [1024.0, 600.0];
    let screen = Rect::from_min_size(Pos2::ZERO, size.into());
    let mut small = Vec::new();
    for lesson in &some_lessons(0) {
        let mut state = State::open(Settings::default()).expect("usual settings");
        state.begin_lesson(lesson).expect("it can be worked out");
        let mut window = presented(state, size);
        let font = FontId::proportional(LEAST * size[1]);
        let row = window.ctx.fonts_mut(|fonts| fonts.row_height(&font)) - 1.0;
        while let Some(place) = course(&window).step().map(|_| course(&window).place()) {
            for (text, rect) in words(&window) {
                let at = format!("{} {place:?}: {text:?} at {rect:?}", lesson.name);
                assert!(screen.contains_rect(rect), "{at} is not on the screen");
                if rect.height() < row {
                    small.push(at);
                }
            }
            window.key_press(Key::PageDown);
            window.run_steps(2);
            window.state_mut().run(LessonCommand::Observe(1));
            window.run_steps(6);
        }
    }
    assert!(small.is_empty(), "too small:\n{}", small.join("\n"));
}

fn course<'a>(window: &'a Harness<'_, App>) -> &'a Course {
    window.state().state().course().expect("a lesson")
}

/// Returns the written words and their places, without the names of marks in the pictures.
fn words(window: &Harness<'_, App>) -> Vec<(String, Rect)> {
    const MARKS: [&str; 5] = ["Clock of ", "Clock beside you", "Where the ", "Map, ", "seen abreast"];
    let mut words = named(window);
    words.retain(|(text, rect)| rect.is_positive() && !MARKS.iter().any(|mark| text.starts_with(mark)));
    words
}

/// Returns the beginning of the name that an audience must see: that of the plot or the map of the step.
fn expected(state: &State) -> &'static [&'static str] {
    let window = state.shown_window();
    match state.sketched() {
        Some(sketched) if sketched.is_revealed => return &["Plot of "],
        Some(_) => return &["Plot to draw "],
        None => {}
    }
    match (window.map, window.plots, state.document.settings.plots.plot) {
        (Presence::On, ..) if state.document.settings.map.face == MapFace::Space => &["Map, from above"],
        (Presence::On, ..) => &["Map, x against t"],
        (_, true, PlotTab::Fit) => &["Fit of "],
        (_, true, _) => &["Plot of "],
        (_, false, _) => &[],
    }
}

/// The words that an audience must read at the present place of the lesson, each as its beginning without
/// formulas.
fn texts(state: &State) -> Vec<String> {
    let Some(course) = state.course() else { return Vec::new() };
    let Some(step) = course.step() else {
        return vec![course.lesson().sentence.markdown.source().to_owned()];
    };
    let is_running =
        state.session.lesson.as_ref().is_some_and(gamow::app::state::lesson::Running::is_running);
    let mut texts = match course.place().phase {
        Phase::Ask => vec![step.text.markdown.source().to_owned()],
        // The truth takes the place of what was to be looked at.
        Phase::Shown if step.observation.is_some() && course.shows_truth() => Vec::new(),
        Phase::Shown => step.reveal.iter().map(|reveal| reveal.text.markdown.source().to_owned()).collect(),
        Phase::Explained => vec![step.explanation.markdown.source().to_owned()],
    };
    let question = step.prediction.as_ref().map(|asked| asked.question.markdown.source().to_owned());
    let seen = step.observation.as_ref().map(|asked| asked.question.markdown.source().to_owned());
    match course.place().phase {
        Phase::Ask => texts.extend(question),
        // The truth is told once it was asked what was seen.
        Phase::Shown if !is_running => {
            texts.extend(question.filter(|_| course.shows_truth()).into_iter().chain(seen));
        }
        _ => {}
    }
    texts
}

/// Returns the text up to its first character of markup.
fn beginning(text: &str) -> &str {
    let end = text.find(['$', '*', '_', '\n', '[', '`', '{', '\\']).unwrap_or(text.len());
    text[..end].trim()
}

fn no_press_of_a_presenters_two_keys_hides_a_plot_or_a_text() {
    let size = [1280.0, 800.0];
    for (number, lesson) in some_lessons(1).iter().enumerate() {
        let mut state = State::open(Settings::default()).expect("usual settings");
        state.begin_lesson(lesson).expect("it can be worked out");
        let mut window = presented(state, size);
        let mut dice = Dice::of_step(SEED, number);
        for press in 0..sweep(PRESSES) {
            let key = if dice.happens(65) { Key::PageDown } else { Key::PageUp };
            window.key_press(key);
            window.run_steps(2);
            let all = named(&window);
            let state = window.state().state();
            let course = state.course().expect("the lesson goes on");
            let at = format!("{}, press {press}: {:?}", lesson.name, course.place());
            assert!(state.session.stage.is_presented() && state.scratch.notice.is_none(), "{at}");
            for text in texts(state) {
                let begins = beginning(&text);
                assert!(all.iter().any(|(label, _)| label.starts_with(begins)), "{at}: {begins:?} is lost");
            }
            if course.step().is_none() {
                continue;
            }
            for name in expected(state) {
                // While the fit is made there is its place alone.
                let is_made = *name != "Fit of " || window.state().is_settled();
                let place = all.iter().find(|(label, _)| label.starts_with(name)).map(|(_, rect)| *rect);
                if let Some(rect) = place {
                    let least = if *name == "Fit of " { READINGS } else { 0.5 * READINGS };
                    assert!(rect.area() >= least * size[0] * size[1], "{at}: {name} at {rect:?}");
                }
                assert!(place.is_some() || !is_made, "{at}: {name} is hidden");
            }
        }
    }
}
