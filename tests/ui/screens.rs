//! Measures of a screen: how much of it the pictures have, what is painted over bodies, and the smallest
//! writing, for presets and steps of lessons on five screens, in the window and before an audience.
//!
//! With `GAMOW_SWEEPS=full` all are measured, and with `GAMOW_SCREENS=FILE` the table goes to that file.

use std::fmt::Write as _;

use eframe::egui::{Key, Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT as _;
use gamow::app::commands::{ShowCommand, WindowCommand};
use gamow::app::shell::App;
use gamow::app::state::lesson::LessonCommand;
use gamow::eye::Eye;
use gamow::lesson::Library;
use gamow::settings::{PlotSettings, Preset};
use relativity_render::Motion;

use super::Test;
use super::support::{cyclist, painted_texts, sweep, window_without_pictures};

pub const TESTS: &[Test] =
    trials![pictures_are_large_and_free_and_writing_is_high_on_five_screens, what_covers_a_body_is_counted];

/// Width and height of each screen, points.
const SCREENS: [[f32; 2]; 5] =
    [[1024.0, 600.0], [1280.0, 800.0], [1366.0, 768.0], [1920.0, 1080.0], [3840.0, 2160.0]];
/// Least share of the height that the picture has before an audience, and the least size of writing there.
pub const LEAST_PICTURE: f32 = 0.65;
const LEAST_WRITING: f32 = 0.03;
/// Least size of writing in the window, points.
const LEAST_IN_WINDOW: f32 = 11.0;
/// Distance of the places in which bodies are looked for, points.
const STEP: f32 = 3.0;

/// The measures of a screen.
#[derive(Debug, Clone, Copy)]
struct Measures {
    /// Share of the height that the pictures have.
    share: f32,
    /// Area of moving bodies that something is painted over, square points.
    covered: f32,
    /// Size of the smallest writing, points.
    smallest: f32,
}

impl Measures {
    fn of(window: &Harness<'_, App>) -> Self {
        let pictures = pictures(window);
        let together = pictures.iter().copied().reduce(Rect::union).unwrap_or(Rect::ZERO);
        let texts = painted_texts(window);
        let sizes = texts.iter().filter(|text| text.is_in_sight());
        let sizes = sizes.flat_map(|text| text.shape.galley.job.sections.clone());
        Self {
            share: together.height() / window.ctx.content_rect().height(),
            covered: pictures.iter().map(|picture| covered_area(window, *picture)).sum(),
            smallest: sizes.map(|section| section.format.font_id.size).fold(f32::INFINITY, f32::min),
        }
    }
}

/// Returns the places of the pictures.
pub fn pictures(window: &Harness<'_, App>) -> Vec<Rect> {
    let names = ["Left eye view", "Right eye view", "Both eyes' view"];
    let all = names.iter().flat_map(|name| {
        let nodes = window.root().children_recursive();
        nodes
            .filter(|node| node.accesskit_node().label().is_some_and(|label| label.starts_with(name)))
            .map(|node| node.rect())
            .collect::<Vec<_>>()
    });
    all.collect()
}

/// Returns the places of what is painted over a `picture` and does not cover all of it, as its grounds do.
pub fn painted_over(window: &Harness<'_, App>, picture: Rect) -> Vec<Rect> {
    let inside = picture.shrink(3.0);
    let shapes = window.output().shapes.iter();
    let places = shapes.map(|clipped| clipped.shape.visual_bounding_rect().intersect(clipped.clip_rect));
    places
        .filter(|place| place.is_positive() && place.intersects(inside) && !place.contains_rect(inside))
        .map(|place| place.intersect(inside))
        .collect()
}

/// Returns the area of the left eye's moving bodies in `picture` that something is painted over.
fn covered_area(window: &Harness<'_, App>, picture: Rect) -> f32 {
    let state = window.state().state();
    let size = [picture.width().round() as u32, picture.height().round() as u32];
    let over = painted_over(window, picture);
    let counts = [picture.width(), picture.height()].map(|side| (side / STEP) as usize);
    let places = (0..counts[0]).flat_map(|x| (0..counts[1]).map(move |y| [x, y]));
    let places = places.map(|place| place.map(|count| (count as f32 + 0.5) * STEP));
    let is_covered = |[x, y]: &[f32; 2]| over.iter().any(|part| part.contains(picture.min + vec2(*x, *y)));
    let is_body = |place: &[f32; 2]| {
        let hit = state.point_at(Eye::Left, place.map(f64::from), size);
        hit.is_some_and(|(track, _)| track.motion == Motion::Scene)
    };
    places.filter(is_covered).filter(is_body).count() as f32 * STEP * STEP
}

/// The table of all screens.
#[derive(Default)]
struct Table {
    text: String,
    /// Rows of the table in which a screen falls short, in words.
    wrong: Vec<String>,
}

impl Table {
    /// Measures what is shown now, as `name`.
    fn add(&mut self, window: &Harness<'_, App>, name: &str) {
        let state = window.state().state();
        let (area, is_presented) = (window.ctx.content_rect(), state.session.stage.is_presented());
        let measures = Measures::of(window);
        let Measures { share, covered, smallest } = measures;
        let place = if is_presented { "audience" } else { "window" };
        let [width, height] = [area.width(), area.height()];
        writeln!(self.text, "{name},{width}x{height},{place},{share:.3},{covered:.0},{smallest:.1}")
            .expect("it is a string");
        // Whoever rides has instruments, and whoever measures marks.
        let is_plain = state.session.lesson.is_none()
            && !state.document.settings.ride.is_on()
            && state.document.settings.plots == PlotSettings::default();
        let is_right = if is_presented {
            share >= LEAST_PICTURE
                && smallest >= LEAST_WRITING * height - 0.1
                && (covered == 0.0 || !is_plain)
        } else {
            share > 0.0 && smallest >= LEAST_IN_WINDOW
        };
        if !is_right {
            self.wrong.push(format!("{name} in {area:?}, {place}: {measures:?}"));
        }
    }
}

fn pictures_are_large_and_free_and_writing_is_high_on_five_screens() {
    let mut table =
        Table { text: "shown,screen,place,picture,covered,smallest\n".to_owned(), ..Table::default() };
    let sizes = sweep([1, SCREENS.len()]);
    for (number, size) in
        SCREENS.into_iter().rev().take(sizes + 2).skip(if sizes == 1 { 2 } else { 0 }).enumerate()
    {
        for is_presented in [false, true] {
            presets(&mut table, size, is_presented);
            if sizes > 1 || number == 0 {
                lessons(&mut table, size, is_presented);
            }
        }
    }
    if let Some(path) = std::env::var_os("GAMOW_SCREENS") {
        std::fs::write(path, &table.text).expect("the table can be written");
    }
    assert!(table.wrong.is_empty(), "{}", table.wrong.join("\n"));
}

/// Adds presets in a window of this `size`.
fn presets(table: &mut Table, size: [f32; 2], is_presented: bool) {
    let mut window = window_without_pictures(cyclist(0.9), size);
    if is_presented {
        window.state_mut().run(WindowCommand::TogglePresenting);
    }
    let every = Preset::all().len() / sweep([3, Preset::all().len()]);
    for preset in Preset::all().iter().step_by(every) {
        window.state_mut().run(ShowCommand::Preset(preset));
        window.run_steps(3);
        table.add(&window, preset.name);
    }
}

/// Adds the places of lessons in a window of this `size`.
fn lessons(table: &mut Table, size: [f32; 2], is_presented: bool) {
    let lessons = Library::own();
    let count = sweep([1, usize::MAX]);
    for lesson in lessons.all().iter().filter(|lesson| !lesson.is_a_preset()).take(count) {
        let mut state = cyclist(0.9);
        state.begin_lesson(lesson).expect("it can be worked out");
        let mut window = window_without_pictures(state, size);
        if is_presented {
            window.state_mut().run(WindowCommand::TogglePresenting);
        }
        window.run_steps(6);
        let place = |window: &Harness<'_, App>| {
            let course = window.state().state().course().expect("a lesson");
            (course.place(), course.step().is_none())
        };
        while let (at, false) = place(&window) {
            table.add(&window, &format!("{} {} {:?}", lesson.name, at.step + 1, at.phase));
            window.key_press(Key::PageDown);
            window.run_steps(2);
            window.state_mut().run(LessonCommand::Observe(0));
            window.run_steps(6);
            if place(&window).0 == at {
                break;
            }
        }
    }
}

/// The count finds what it is to find: labels on a wheel in the window, which an audience does not have.
fn what_covers_a_body_is_counted() {
    let wheel = Preset::named("rolling-wheel").expect("a preset");
    let mut window = window_without_pictures(cyclist(0.9), [1280.0, 800.0]);
    window.state_mut().run(ShowCommand::Preset(wheel));
    window.run_steps(3);
    assert!(Measures::of(&window).covered > 0.0);
    window.state_mut().run(WindowCommand::TogglePresenting);
    window.run_steps(3);
    assert_eq!(Measures::of(&window).covered, 0.0);
}
