//! A window without a display, and what a test reads off it.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

use clap::ValueEnum as _;
use eframe::egui::accesskit::Role;
use eframe::egui::epaint::TextShape;
use eframe::egui::{Pos2, Rect, Shape, Vec2, ViewportId};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use egui_kittest::{Harness, HarnessBuilder};
use gamow::app::commands::{Command, FileCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::flags::choices::Layout;
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::lesson::{Lesson, Library};
use gamow::settings::Settings;
use relativity_core::{Aperture, Sighting, SourcePoint, Speed, sighting};

use super::device;

/// What is shown in `state` is what its file gives back: nothing the user did has set a value that the judges
/// of settings refuse. All that follows from it is a number.
pub fn assert_sane(state: &State) {
    let shown = state.shown();
    let text = shown.to_toml();
    let read = Settings::default().with_toml(&text, "state.toml");
    assert_eq!(read.unwrap_or_else(|error| panic!("{error} in\n{text}")), shown, "{text}");
    let [from, to] = state.time_range();
    let numbers = [state.document.time, state.frame.cm_per_pixel, from, to];
    assert!(from <= to && numbers.iter().all(|number| number.is_finite()), "{numbers:?} in\n{text}");
}

/// The cyclist's tracked point, and the usual separation of the eyes.
pub const TRACKED: [f64; 3] = [0.0, 3.0, 2.0];
pub const SEPARATION: f64 = 0.1;

/// Seconds between frames: short enough for two clicks to be a double click.
pub const FRAME: f32 = 1.0 / 16.0;

/// Longest that a window may take for anything, on a busy machine too.
const LIMIT: Duration = Duration::from_mins(2);

/// The paper's cyclist at this beta.
pub fn cyclist(beta: f64) -> State {
    let mut settings = Settings { scene: "cyclist".to_owned(), ..Settings::default() };
    settings.motion.speed = SpeedSetting::new(SpeedParameter::Beta, beta).expect("a speed");
    State::open(settings).expect("a preset")
}

/// The command that shows both eyes' pictures in this layout.
pub fn in_layout(layout: Layout) -> Command {
    let value = layout.to_possible_value().expect("it is a flag's value").get_name().to_owned();
    Command::Settings(SettingsCommand::Value { name: "layout", value })
}

/// A window that shows `state`, no larger than most claims need.
pub fn window(state: State) -> Harness<'static, App> {
    window_of_size(state, [1120.0, 700.0], 1.0)
}

/// A window with room for every part, its whole bar, and a map.
pub fn wide_window(mut state: State) -> Harness<'static, App> {
    state.run(SettingsCommand::Value { name: "map", value: "on".to_owned() });
    window_of_size(state, [1280.0, 800.0], 1.0)
}

/// A window of this `size`, points, before it is given a renderer and an app.
pub fn builder(size: [f32; 2]) -> HarnessBuilder<App> {
    Harness::builder()
        .with_size(Vec2::from(size))
        .with_step_dt(FRAME)
        .with_max_steps(12)
        .with_render_cursor(false)
}

/// A window of this `size` whose views stay empty, for tests of the texts around them: pictures take most of
/// the time of a frame.
pub fn window_without_pictures(state: State, size: [f32; 2]) -> Harness<'static, App> {
    let mut harness = builder(size).build_eframe(|cc| App::new(&cc.egui_ctx, None, state));
    harness.run_steps(3);
    harness
}

/// Returns the number of cases that a sweep tries: `some` usually, `all` where the environment has
/// `GAMOW_SWEEPS=full`, as in the nightly checks.
pub fn sweep([some, all]: [usize; 2]) -> usize {
    if std::env::var_os("GAMOW_SWEEPS").is_some_and(|value| value == "full") { all } else { some }
}

/// Returns the lessons that a test of this `number` walks through: usually a third of all, another one than
/// that of the next number, and in the nightly checks all.
pub fn some_lessons(number: usize) -> Vec<Arc<Lesson>> {
    let parts = sweep([3, 1]);
    all_lessons().into_iter().skip(number % parts).step_by(parts).collect()
}

/// Returns all lessons of the program.
pub fn all_lessons() -> Vec<Arc<Lesson>> {
    Library::own().all().iter().filter(|lesson| !lesson.is_a_preset()).cloned().collect()
}

pub fn window_of_size(state: State, size: [f32; 2], pixels_per_point: f32) -> Harness<'static, App> {
    let mut harness = builder(size)
        .with_pixels_per_point(pixels_per_point)
        .renderer(device::renderer())
        .build_eframe(|cc| App::new(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), state).without_refinement());
    harness.run_steps(3);
    harness
}

/// What the core says an eye (0 left, 1 right) sees of the tracked point.
pub fn seen(beta: f64, time: f64, eye: usize) -> Sighting {
    let speed = Speed::from_beta(beta).expect("a speed");
    let point = SourcePoint::from_rest(TRACKED, &speed);
    sighting(&speed, point, Aperture::pair(SEPARATION)[eye], time).expect("in the domain")
}

/// The number behind the colon of the only label that starts with `name`, without its unit.
pub fn shown(harness: &Harness<'_, App>, name: &str) -> f64 {
    let text = label_starting_with(harness, name);
    let number = text.rsplit(": ").next().expect("a label names its value");
    let number = number.split(' ').next().unwrap_or_default().replace('−', "-");
    number.parse().unwrap_or_else(|_| panic!("{text:?} ends in a number"))
}

/// The only label that starts with `name`.
pub fn label_starting_with(harness: &Harness<'_, App>, name: &str) -> String {
    let labels: Vec<String> = labels(harness).into_iter().filter(|label| label.starts_with(name)).collect();
    assert_eq!(labels.len(), 1, "labels that start with {name:?}: {labels:?}");
    labels[0].clone()
}

/// A text that is painted, and what clips it.
pub struct PaintedText {
    pub shape: TextShape,
    pub clip: Rect,
}

impl PaintedText {
    /// Whether something of it can be seen.
    pub fn is_in_sight(&self) -> bool {
        self.shape.opacity_factor > 0.0 && self.clip.intersects(self.shape.visual_bounding_rect())
    }
}

/// Returns every text that is painted.
pub fn painted_texts(window: &Harness<'_, App>) -> Vec<PaintedText> {
    fn add(shape: &Shape, clip: Rect, texts: &mut Vec<PaintedText>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| add(shape, clip, texts)),
            Shape::Text(text) => texts.push(PaintedText { shape: text.clone(), clip }),
            _ => {}
        }
    }
    let mut texts = Vec::new();
    for clipped in &window.output().shapes {
        add(&clipped.shape, clipped.clip_rect, &mut texts);
    }
    texts
}

/// Every label and value in the window.
pub fn labels(harness: &Harness<'_, App>) -> Vec<String> {
    let nodes = harness.root().children_recursive();
    nodes
        .flat_map(|node| {
            let node = node.accesskit_node();
            [node.label(), node.value()]
        })
        .flatten()
        .collect()
}

/// Where the picture of an eye is.
pub fn pane(harness: &Harness<'_, App>, eye: usize) -> Rect {
    harness.get_by_label(["Left eye view", "Right eye view"][eye]).rect()
}

/// The slider called `name`, whose row is labelled so too.
pub fn slider(harness: &Harness<'_, App>, name: &str) -> Rect {
    harness.get_by_role_and_label(Role::Slider, name).rect()
}

/// Presses the button at `from`, moves to `to` in a few steps, and lets go.
pub fn drag(harness: &mut Harness<'_, App>, from: Pos2, to: Pos2) {
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    for i in 1..=4 {
        harness.hover_at(from + (to - from) * (i as f32 / 4.0));
        harness.step();
    }
    harness.drop_at(to);
    harness.run_ok();
}

/// Has the window open the file at `path`, and waits until it is read.
pub fn open(harness: &mut Harness<'_, App>, path: &std::path::Path) {
    harness.state_mut().run(FileCommand::Open(path.to_owned()));
    wait_for_file(harness);
}

/// Hears the threads that ask for a frame of a window.
pub struct Wakes(Receiver<()>);

impl Wakes {
    /// Hears them from now on.
    pub fn of(window: &Harness<'_, App>) -> Self {
        let (sender, asked) = channel();
        let own_thread = thread::current().id();
        window.ctx.set_repaint_observer(move |_| {
            if thread::current().id() != own_thread {
                // Nobody may listen any more.
                let _ = sender.send(());
            }
        });
        Self(asked)
    }

    /// Waits for the first that asks and was not waited for before; there is none if `what` does not happen.
    pub fn next(&self, what: &str) {
        self.0.recv_timeout(LIMIT).unwrap_or_else(|_| panic!("it does not happen: {what}"));
    }
}

/// Steps the window until `is_done`, and sleeps between the frames, which take the processor from the work
/// that they wait for.
pub fn wait_for(
    window: &mut Harness<'_, App>,
    what: &str,
    mut is_done: impl FnMut(&Harness<'_, App>) -> bool,
) {
    let start = Instant::now();
    window.step();
    while !is_done(window) {
        assert!(start.elapsed() < LIMIT, "it does not happen: {what}");
        thread::sleep(Duration::from_millis(10));
        window.step();
    }
}

/// Steps the window until the notes on its pictures have faded: it is at rest then.
pub fn rest(window: &mut Harness<'_, App>) {
    window.run_steps((5.0 / FRAME) as usize);
}

/// Returns the time for which the window would sleep before its next frame, if nobody woke it.
pub fn repaint_delay(window: &Harness<'_, App>) -> Duration {
    window.output().viewport_output[&ViewportId::ROOT].repaint_delay
}

/// Steps the window until it asks for no further frame. A thread whose result the window has taken in asks
/// for one, too, and may do so a moment later.
pub fn wait_for_rest(window: &mut Harness<'_, App>) {
    wait_for(window, "a window at rest uses no processor", |window| repaint_delay(window) == Duration::MAX);
}

/// Steps the window until no work is left in the background: in three frames together, since some begins in
/// the frame after other work has ended.
pub fn settle(window: &mut Harness<'_, App>) {
    let mut still = 0;
    wait_for(window, "all work is done", |window| {
        still = if window.state().is_settled() { still + 1 } else { 0 };
        still == 3
    });
}

/// Frames until no file is being read.
pub fn wait_for_file(harness: &mut Harness<'_, App>) {
    let wakes = Wakes::of(harness);
    harness.step();
    while harness.state().is_reading() {
        wakes.next("the file is read");
        harness.step();
    }
    harness.step();
}

/// Types `text` in place of what is in the field called `name`, and presses Enter.
pub fn type_into(harness: &mut Harness<'_, App>, name: &str, text: &str) {
    use eframe::egui::{Key, Modifiers};
    harness.get_by_label(name).click();
    harness.run_ok();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.get_by_label(name).type_text(text);
    harness.key_press(Key::Enter);
    harness.run_ok();
}
