//! Measuring in the views themselves: angles with a ruler, times with a stopwatch.

use eframe::egui::{Key, Modifiers, Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{PlaybackCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::measuring::stopwatch::Stopwatch;
use gamow::eye::Eye;
use gamow::flags::FieldOfView;
use gamow::flags::choices::{Compare, GazeChoice, ProjectionChoice};
use gamow::settings::{LookSettings, Settings};
use glam::{DQuat, DVec3};
use relativity_core::aberration::ground_from_rest;
use relativity_render::{Geometry, Shape};

use super::Test;
use super::support::{
    FRAME, SEPARATION, cyclist, drag, label_starting_with, labels, pane, seen, window, window_of_size,
};

pub const TESTS: &[Test] = trials![
    a_ruler_across_the_globe_shows_its_angle,
    a_ruler_stays_where_it_was_laid_until_it_is_taken_away,
    a_ruler_in_the_second_picture_measures_that,
    a_stopwatch_shows_t_and_the_clock_that_is_seen,
    a_stopwatch_of_running_t_is_right_within_its_error,
    a_stopwatch_takes_no_drag_of_the_view_below_and_is_closed,
];

/// The globe at 0.8 c, still coming.
fn globe() -> State {
    let settings = Settings { scene: "globe".to_owned(), time: Some(1.0), ..Settings::default() };
    let mut state = State::open(settings).expect("a preset");
    let mut motion = state.document.settings.motion;
    motion.speed = gamow::flags::SpeedSetting::new(gamow::flags::SpeedParameter::Beta, 0.8).expect("a speed");
    state.run(SettingsCommand::Motion(motion));
    state
}

/// Number and error that a label ends in, radians.
fn told(window: &Harness<'_, App>, name: &str) -> [f64; 2] {
    let label = label_starting_with(window, name);
    let (_, numbers) = label.rsplit_once(": ").expect("a label names its value");
    let unit = if numbers.contains('°') { 1.0 } else { 1.0 / 60.0 };
    let number = |text: &str| text.trim_end_matches(['°', '′']).parse::<f64>().expect("a number");
    let (angle, error) = numbers.split_once(" ± ").expect("an error");
    [angle, error].map(|text| (unit * number(text)).to_radians())
}

/// The directions in which the left eye sees both ends of the ball in the plane of the motion and its middle:
/// tangents in the ball's own frame, where it rests.
fn tangents(state: &State) -> [DVec3; 2] {
    let ball = state.document.scene.bodies.iter().find_map(|body| match body.shape {
        Shape::Sphere { centre, radius } => Some((DVec3::from(centre), radius)),
        _ => None,
    });
    let ((centre, radius), speed) = (ball.expect("a globe"), state.speed());
    let eye = speed.gamma() * (-SEPARATION / 2.0 - speed.beta() * state.document.time);
    let away = centre - DVec3::new(eye, 0.0, 0.0);
    let half = (radius / away.length()).asin();
    let axis = DVec3::X.cross(away).normalize();
    [half, -half].map(|turn| {
        let tangent = DQuat::from_axis_angle(axis, turn) * away.normalize();
        DVec3::from(ground_from_rest(tangent.to_array(), &speed))
    })
}

fn a_ruler_across_the_globe_shows_its_angle() {
    let mut window = window(globe());
    let state = window.state().state().clone();
    let rect = pane(&window, 0);
    let size = [rect.width().round() as u32, rect.height().round() as u32];
    let ends = tangents(&state);
    let camera = state.view(Eye::Left, size).camera;
    // A row of a conformal picture is a plane through the line of motion.
    let row = camera.pixel(ends[0]).expect("in front")[1];
    assert!((camera.pixel(ends[1]).expect("in front")[1] - row).abs() < 1e-6);
    let is_on_it = |column: &u32| {
        let hit = state.point_at(Eye::Left, [f64::from(*column) + 0.5, row], size);
        hit.is_some_and(|(_, body)| matches!(state.document.scene.bodies[body].shape, Shape::Sphere { .. }))
    };
    let columns: Vec<u32> = (0..size[0]).filter(is_on_it).collect();
    let [first, last] = [columns[0], columns[columns.len() - 1]];
    assert!(columns.len() > 60 && first > 0 && last + 1 < size[0], "{first} {last} of {size:?}");
    window.key_press(Key::R);
    window.run();
    let place = |column: u32| rect.min + vec2(column as f32, row as f32);
    drag(&mut window, place(first), place(last + 1));
    let [angle, error] = told(&window, "Ruler, Left eye: ");
    let expected = ends[0].angle_between(ends[1]);
    assert!((angle - expected).abs() < error, "{angle} ± {error} for {expected}");
    // The error is that of a pixel here, no more: a column has this angle in the mean.
    let column = expected / columns.len() as f64;
    assert!((0.5..1.6).contains(&(error / column)), "{error} for {column}");
    let look = window.state().state().document.settings.look;
    assert_eq!(look.gaze, state.document.settings.look.gaze, "a drag that measures does not turn the view");
}

fn a_ruler_stays_where_it_was_laid_until_it_is_taken_away() {
    let mut state = cyclist(0.9);
    let look = LookSettings { fov: FieldOfView(Some(80.0)), ..state.look() };
    state.run(SettingsCommand::Look(look));
    let mut window = window(state);
    let rect = pane(&window, 0);
    let rulers = |window: &Harness<'_, App>| {
        labels(window).iter().filter(|label| label.starts_with("Ruler, ")).count()
    };
    let (from, to) = (rect.center() - vec2(60.0, 20.0), rect.center() + vec2(70.0, 30.0));
    window.key_press(Key::R);
    window.run();
    assert!(labels(&window).iter().any(|label| label.starts_with("Drag from one place")));
    drag(&mut window, from, to);
    let before = told(&window, "Ruler, Left eye: ");
    assert_eq!(rulers(&window), 1);
    // T, another projection and a gaze that is turned by a drag leave it its angle.
    let gaze = window.state().state().document.settings.look.gaze;
    window.state_mut().run(PlaybackCommand::GoTo(1.0));
    drag(&mut window, rect.center(), rect.center() + vec2(25.0, 10.0));
    assert_ne!(window.state().state().document.settings.look.gaze, gaze, "drags look around again");
    assert_eq!(told(&window, "Ruler, Left eye: "), before);
    let look =
        LookSettings { projection: ProjectionChoice::Gaze, ..window.state().state().document.settings.look };
    window.state_mut().run(SettingsCommand::Look(look));
    window.run();
    assert_eq!(told(&window, "Ruler, Left eye: "), before);
    // Behind the back it is nowhere.
    window
        .state_mut()
        .run(SettingsCommand::Look(LookSettings { gaze: GazeChoice::Fixed([-90.0, 0.0]), ..look }));
    window.run();
    assert_eq!(rulers(&window), 0);
    window.state_mut().run(SettingsCommand::Look(look));
    window.run();
    assert_eq!(rulers(&window), 1);
    window.key_press(Key::Escape);
    window.run();
    assert_eq!(rulers(&window), 0);
}

fn a_ruler_in_the_second_picture_measures_that() {
    let mut state = cyclist(0.9);
    let look =
        LookSettings { compare: Compare::Rest, fov: FieldOfView(Some(80.0)), ..state.document.settings.look };
    state.run(SettingsCommand::Look(look));
    let mut window = window(state);
    let rect: Rect = window.get_by_label("Left eye view: at rest").rect();
    window.key_press(Key::R);
    window.run();
    let (from, to) = (rect.center(), rect.center() + vec2(80.0, 0.0));
    drag(&mut window, from, to);
    let place = window.get_by_label(&label_starting_with(&window, "Ruler, Left eye: ")).rect();
    assert!(rect.contains_rect(place.shrink(1.0)), "{place:?} in {rect:?}");
    // As in a window that shows this geometry alone.
    let mut alone = window.state().state().clone();
    alone.document.settings.look =
        LookSettings { compare: Compare::Off, geometry: Geometry::Rest, ..alone.document.settings.look };
    let camera = alone.view(Eye::Left, [rect.width() as u32, rect.height() as u32]).camera;
    let [a, b] = [from, to].map(|place| {
        camera.line_of_sight([f64::from(place.x - rect.min.x), f64::from(place.y - rect.min.y)])
    });
    let [angle, error] = told(&window, "Ruler, Left eye: ");
    // It is told to a tenth of a degree.
    assert!((angle - a.angle_between(b)).abs() <= 0.0501_f64.to_radians(), "{angle} ± {error}");
}

/// The numbers of the stopwatch's lines: `value ± error` behind a name.
fn timed(window: &Harness<'_, App>, name: &str) -> [f64; 2] {
    let label = label_starting_with(window, &format!("Stopwatch: {name}"));
    let (_, numbers) = label.rsplit_once(": ").expect("a label names its value");
    let (value, error) = numbers.split_once(" ± ").expect("an error");
    [value, error].map(|text| text.replace('−', "-").parse().expect("a number"))
}

fn a_stopwatch_shows_t_and_the_clock_that_is_seen() {
    let mut window = window_of_size(cyclist(0.9), [1280.0, 800.0], 1.0);
    window.state_mut().run(PlaybackCommand::GoTo(-2.0));
    window.key_press(Key::T);
    window.run();
    window.state_mut().run(PlaybackCommand::GoTo(4.5));
    window.key_press(Key::T);
    window.run();
    assert_eq!(timed(&window, "T"), [6.5, 0.0]);
    // By the clock that rests at the point: gamma (t - beta x) of what is seen, 1/gamma of t here.
    let own = |time: f64| seen(0.9, time, 0).retarded_time * 0.19_f64.sqrt();
    let expected = own(4.5) - own(-2.0);
    let [clock, error] = timed(&window, "clock of ");
    assert!((clock - expected).abs() < 6e-4 && error == 0.0, "{clock} for {expected}");
    let mean = format!("mean D = {:.3}", expected / 6.5);
    assert!(labels(&window).iter().any(|label| label.ends_with(&mean)), "{mean}");
    // Stopped, it keeps its time; a press begins anew, and Clear has nothing.
    window.state_mut().run(PlaybackCommand::GoTo(9.0));
    window.run();
    assert_eq!(timed(&window, "T"), [6.5, 0.0]);
    window.get_by_label("Start").click();
    window.run();
    assert_eq!(timed(&window, "T"), [0.0, 0.0]);
    // Where T begins its range again meanwhile, the time from the earlier to the later is told.
    window.state_mut().run(PlaybackCommand::GoTo(2.5));
    window.run();
    assert_eq!(timed(&window, "T"), [6.5, 0.0]);
    window.get_by_label("Clear").click();
    window.run();
    assert!(labels(&window).iter().any(|label| label == "Stopwatch: T: –"));
    // What is not seen by light has no clock.
    window.state_mut().run(SettingsCommand::Geometry(Geometry::Contracted));
    window.key_press(Key::T);
    window.run();
    assert!(!labels(&window).iter().any(|label| label.starts_with("Stopwatch: clock of ")));
}

fn a_stopwatch_of_running_t_is_right_within_its_error() {
    let mut window = window(cyclist(0.9));
    window.state_mut().run(PlaybackCommand::GoTo(0.0));
    window.state_mut().run(PlaybackCommand::Toggle);
    window.run_steps(3);
    window.key_press(Key::T);
    window.run_steps(40);
    window.key_press(Key::T);
    window.step();
    window.state_mut().run(PlaybackCommand::Toggle);
    window.run();
    let Stopwatch::Stopped(marks) = &window.state().state().scratch.stopwatch else {
        panic!("it was stopped")
    };
    // A frame for each press and each release.
    let [from, to] = [marks[0].time, marks[1].time];
    assert!(to - from > 40.0 * f64::from(FRAME) && to < window.state().state().document.time);
    let [time, error] = timed(&window, "T");
    assert!((time - (to - from)).abs() < 6e-4, "{time} for {}", to - from);
    // The step of a frame at a unit a second.
    assert!((error - f64::from(FRAME)).abs() < 6e-4, "{error}");
    let own = |time: f64| seen(0.9, time, 0).retarded_time * 0.19_f64.sqrt();
    let [clock, late] = timed(&window, "clock of ");
    assert!((clock - (own(to) - own(from))).abs() < 6e-4, "{clock} for {}", own(to) - own(from));
    let rate = [from, to].map(|time| seen(0.9, time, 0).doppler_factor);
    assert!((late - rate[0].max(rate[1]) * error).abs() < 6e-3, "{late}");
}

fn a_stopwatch_takes_no_drag_of_the_view_below_and_is_closed() {
    let mut window = window(cyclist(0.9));
    window.key_press_modifiers(Modifiers::SHIFT, Key::T);
    window.run();
    let gaze = window.state().state().document.settings.look.gaze;
    let at = window.get_by_label("Stopwatch: T: –").rect().center();
    assert!(pane(&window, 0).contains(at));
    drag(&mut window, at, at + vec2(-40.0, 30.0));
    assert_eq!(window.state().state().document.settings.look.gaze, gaze);
    window.get_by_label("Close stopwatch").click();
    window.run();
    assert!(!labels(&window).iter().any(|label| label.starts_with("Stopwatch: ")));
    drag(&mut window, at, at + vec2(-40.0, 30.0));
    assert_ne!(window.state().state().document.settings.look.gaze, gaze);
}
