//! The map's spacetime face: its marks are where the core says, in both frames; the present that is dragged;
//! what is said of an event.

use eframe::egui::{Modifiers, Pos2, Rect, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{PlaybackCommand, SettingsCommand, Switch};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::settings::{
    MapFace, MapFrame, MapFraming, MapSettings, Presence, Settings, Theme, WindowSettings,
};
use relativity_core::Speed;

use super::Test;
use super::layouts::assert_no_broken_numbers;
use super::picking::click;
use super::support::{SEPARATION, TRACKED, cyclist, drag, label_starting_with, labels, seen, window_of_size};

pub const TESTS: &[Test] = trials![
    events_of_spacetime_are_where_the_numbers_say_to_half_a_pixel,
    light_runs_at_45_degrees_in_every_unit,
    dragging_the_present_along_the_worldline_of_the_eyes_goes_to_another_time,
    a_click_on_the_worldline_goes_to_when_that_event_is_seen,
    an_event_tells_its_three_times_by_their_names,
    the_way_of_the_light_on_the_plan_tells_when_it_left,
    a_close_up_has_the_clocks_of_all_followed_points_at_one_ground_time,
    spacetime_that_is_not_shown_is_not_there,
    no_speed_time_or_size_breaks_spacetime,
];

const NAME: &str = "Map, x against t";

/// A window that shows the cyclist's spacetime in this frame, and nothing else that is large.
fn spacetime(beta: f64, frame: MapFrame, size: [f32; 2]) -> Harness<'static, App> {
    let mut state = cyclist(beta);
    state.document.settings.map = MapSettings { face: MapFace::Spacetime, frame, ..MapSettings::default() };
    state.document.settings.window = WindowSettings {
        views: false,
        plots: false,
        controls: false,
        map: Presence::On,
        ..WindowSettings::default()
    };
    window_of_size(state, size, 1.0)
}

fn mark(window: &Harness<'_, App>, name: &str) -> Pos2 {
    window.get_by_label(&format!("{NAME}: {name}")).rect().center()
}

fn go_to(window: &mut Harness<'_, App>, time: f64) {
    window.state_mut().run(PlaybackCommand::GoTo(time));
    window.run();
}

fn time(window: &Harness<'_, App>) -> f64 {
    window.state().state().document.time
}

fn gamma(beta: f64) -> f64 {
    Speed::from_beta(beta).expect("a speed").gamma()
}

/// An event of the ground, as `frame` has it: by the textbook.
fn transformed(beta: f64, frame: MapFrame, [x, t]: [f64; 2]) -> [f64; 2] {
    match frame {
        MapFrame::Ground | MapFrame::Rider => [x, t],
        MapFrame::Bicycle => [gamma(beta) * (x - beta * t), gamma(beta) * (t - beta * x)],
    }
}

/// The chart, found by where the present is at two times.
struct Found {
    beta: f64,
    frame: MapFrame,
    scale: f64,
    origin: [f64; 2],
}

impl Found {
    fn new(window: &mut Harness<'_, App>, beta: f64, frame: MapFrame) -> Self {
        let [first, last] = [1.3, 4.4].map(|time| {
            go_to(window, time);
            (mark(window, "the present T"), transformed(beta, frame, [0.0, time]))
        });
        let scale = f64::from(first.0.y - last.0.y) / (last.1[1] - first.1[1]);
        let [x, t] = last.1;
        let origin = [f64::from(last.0.x) - scale * x, f64::from(last.0.y) + scale * t];
        Self { beta, frame, scale, origin }
    }

    /// Where an event of the ground is drawn.
    fn place(&self, event: [f64; 2]) -> Pos2 {
        let [x, t] = transformed(self.beta, self.frame, event);
        pos2((self.origin[0] + self.scale * x) as f32, (self.origin[1] - self.scale * t) as f32)
    }
}

fn events_of_spacetime_are_where_the_numbers_say_to_half_a_pixel() {
    for size in [[800.0, 600.0], [1280.0, 800.0], [1920.0, 1080.0]] {
        for beta in [0.3, 0.9, 0.99] {
            for frame in [MapFrame::Ground, MapFrame::Bicycle] {
                let mut window = spacetime(beta, frame, size);
                let found = Found::new(&mut window, beta, frame);
                for time in [1.5, 2.75, 4.0] {
                    go_to(&mut window, time);
                    assert_events(&window, &found);
                }
            }
        }
    }
}

#[track_caller]
fn assert_events(window: &Harness<'_, App>, found: &Found) {
    let (beta, time) = (found.beta, time(window));
    let near = |name: &str, event: [f64; 2]| {
        let (shown, expected) = (mark(window, name), found.place(event));
        assert!(shown.distance(expected) < 0.5, "{name} at {shown:?}, not {expected:?}; T = {time}");
    };
    for (eye, name, x) in [(0, "Left eye", -0.5 * SEPARATION), (1, "Right eye", 0.5 * SEPARATION)] {
        let seen = seen(beta, time, eye);
        near(&format!("received, {name}"), [x, time]);
        near(&format!("happened, {name}"), [x + seen.position[0], seen.retarded_time]);
    }
    near("measured now", [beta * time, time]);
    // t - beta x = T on the worldline x = beta t: all that is now on the bicycle's clocks.
    let now = time * gamma(beta) * gamma(beta);
    if window.query_by_label(&format!("{NAME}: now on the bicycle's clocks")).is_some() {
        near("now on the bicycle's clocks", [beta * now, now]);
    }
}

fn light_runs_at_45_degrees_in_every_unit() {
    use gamow::units::Units;
    for units in [Units::Natural, Units::Metric, Units::Town] {
        let mut window = spacetime(0.9, MapFrame::Ground, [1280.0, 800.0]);
        let settings = WindowSettings { units, ..window.state().state().document.settings.window };
        window.state_mut().run(SettingsCommand::Window(settings));
        window.run();
        let found = Found::new(&mut window, 0.9, MapFrame::Ground);
        let [first, last] = [1.5, 4.0].map(|time| {
            go_to(&mut window, time);
            mark(&window, "measured now")
        });
        let [across, up] = [last.x - first.x, first.y - last.y].map(f64::from);
        assert!((across - 0.9 * up).abs() < 0.1 && (up - 2.5 * found.scale).abs() < 0.1, "{across} {up}");
    }
}

fn dragging_the_present_along_the_worldline_of_the_eyes_goes_to_another_time() {
    for frame in [MapFrame::Ground, MapFrame::Bicycle] {
        let mut window = spacetime(0.9, frame, [1280.0, 800.0]);
        let found = Found::new(&mut window, 0.9, frame);
        go_to(&mut window, 2.0);
        let from = mark(&window, "the present T");
        drag(&mut window, from, found.place([0.0, 3.5]));
        // egui takes the first six points for a click still.
        assert!((time(&window) - 3.5).abs() < 7.0 / found.scale, "{frame:?}: {}", time(&window));
        let eye = mark(&window, "the present T");
        assert!(eye.distance(found.place([0.0, time(&window)])) < 0.5);
        assert_eq!(window.state().state().scratch.map_view, gamow::map::Viewpoint::default());
    }
}

fn a_click_on_the_worldline_goes_to_when_that_event_is_seen() {
    let mut window = spacetime(0.9, MapFrame::Ground, [1280.0, 800.0]);
    let found = Found::new(&mut window, 0.9, MapFrame::Ground);
    go_to(&mut window, 2.0);
    let happened = -1.5;
    click(&mut window, found.place([0.9 * happened, happened]), Modifiers::NONE);
    let [_, y, z] = TRACKED;
    let received = happened + (0.81 * happened * happened + y * y + z * z).sqrt();
    assert!((time(&window) - received).abs() < 1.0 / found.scale, "{} {received}", time(&window));
    // On the worldline of the eyes, above the present.
    click(&mut window, found.place([0.0, 4.0]), Modifiers::NONE);
    assert!((time(&window) - 4.0).abs() < 1.0 / found.scale, "{}", time(&window));
}

fn an_event_tells_its_three_times_by_their_names() {
    let mut window = spacetime(0.9, MapFrame::Ground, [1280.0, 800.0]);
    go_to(&mut window, 2.0);
    let place = mark(&window, "happened, Left eye");
    window.hover_at(place);
    window.run_steps(30);
    let seen = seen(0.9, 2.0, 0);
    let text = label_starting_with(&window, "What the left eye sees now happened here");
    let shown = |name: &str| -> f64 {
        let line = text.lines().find_map(|line| line.strip_prefix(name)).expect("it is told");
        line.replace('−', "-").parse().expect("a number")
    };
    assert!((shown("received T = ") - 2.0).abs() < 1e-9);
    assert!((shown("happened t = ") - seen.retarded_time).abs() < 6e-4);
    // The tracked point is at the origin of its frame: its clock shows t/gamma.
    assert!((shown("proper time τ = ") - seen.retarded_time / gamma(0.9)).abs() < 6e-4);
}

fn the_way_of_the_light_on_the_plan_tells_when_it_left() {
    let mut window = spacetime(0.9, MapFrame::Ground, [1280.0, 800.0]);
    window.state_mut().run(SettingsCommand::Map(MapSettings::default()));
    go_to(&mut window, 5.0);
    let place = |name: &str| window.get_by_label(&format!("Map, from above: {name}")).rect().center();
    let [from, to] = ["front tyre, as the left eye sees it", "Left eye"].map(place);
    let way = from.lerp(to, 0.6);
    window.hover_at(way);
    window.run_steps(30);
    // The ways to both eyes are a few points apart there.
    let text = label_starting_with(&window, "Light that the ");
    let happened = text.lines().find_map(|line| line.strip_prefix("happened t = ")).expect("it is told");
    let eye = usize::from(text.contains("right eye"));
    assert!((happened.parse::<f64>().expect("a number") - seen(0.9, 5.0, eye).retarded_time).abs() < 6e-4);
}

fn a_close_up_has_the_clocks_of_all_followed_points_at_one_ground_time() {
    let beta = 0.8;
    let rear = [-2.105, 3.881, -1.975];
    let mut settings = cyclist(beta).document.settings;
    settings.points = Some("-2.105,3.881,-1.975@20".parse().expect("a point"));
    settings.map =
        MapSettings { face: MapFace::Spacetime, frame: MapFrame::Bicycle, framing: MapFraming::CloseUp };
    settings.window =
        WindowSettings { views: false, plots: false, map: Presence::On, ..WindowSettings::default() };
    let mut window =
        window_of_size(State::open(Settings::clone(&settings)).expect("a preset"), [1280.0, 800.0], 1.0);
    go_to(&mut window, 0.0);
    // What the ground has at t = 0 happens at t' = -beta x' on the bicycle.
    let marks: Vec<Pos2> = labels(&window)
        .iter()
        .filter(|name| name.starts_with(NAME) && name.ends_with("measured now"))
        .map(|name| window.get_by_label(name).rect().center())
        .collect();
    let [first, second] = marks[..] else { panic!("{:?}", labels(&window)) };
    let [right, left] = if first.x > second.x { [first, second] } else { [second, first] };
    let (across, up) = (f64::from(right.x - left.x), f64::from(right.y - left.y));
    let apart = TRACKED[0] - rear[0];
    assert!((up / across - beta).abs() < 0.01, "{marks:?}");
    assert!(across > 100.0, "{apart} units are {across} points");
}

fn spacetime_that_is_not_shown_is_not_there() {
    let mut window = spacetime(0.9, MapFrame::Ground, [1280.0, 800.0]);
    let is_there = |window: &Harness<'_, App>| labels(window).iter().any(|label| label.starts_with(NAME));
    assert!(is_there(&window));
    window.state_mut().run(SettingsCommand::Map(MapSettings::default()));
    window.run();
    assert!(!is_there(&window));
    window
        .state_mut()
        .run(SettingsCommand::Map(MapSettings { face: MapFace::Spacetime, ..MapSettings::default() }));
    window.state_mut().run(SettingsCommand::Switch(Switch::Map));
    window.run();
    assert!(!is_there(&window));
}

fn no_speed_time_or_size_breaks_spacetime() {
    for size in [[300.0, 290.0], [1024.0, 600.0]] {
        for theme in [Theme::Dark, Theme::Light] {
            let mut window = spacetime(0.9, MapFrame::Ground, size);
            let parts = WindowSettings { theme, ..window.state().state().document.settings.window };
            window.state_mut().run(SettingsCommand::Window(parts));
            for (parameter, value) in
                [(SpeedParameter::Beta, 0.0), (SpeedParameter::Beta, 1e-9), (SpeedParameter::Gamma, 1e9)]
            {
                let mut motion = window.state().state().document.settings.motion;
                motion.speed = SpeedSetting::new(parameter, value).expect("a speed");
                window.state_mut().run(SettingsCommand::Motion(motion));
                for (time, frame) in
                    [(-1e6, MapFrame::Ground), (0.0, MapFrame::Bicycle), (3.6, MapFrame::Bicycle)]
                {
                    window.state_mut().run(SettingsCommand::Map(MapSettings {
                        face: MapFace::Spacetime,
                        frame,
                        ..MapSettings::default()
                    }));
                    go_to(&mut window, time);
                    assert_no_broken_numbers(&window);
                    let room = window.get_by_label(NAME).rect();
                    let present = mark(&window, "the present T");
                    assert!(
                        Rect::from_min_size(room.min, room.size()).expand2(vec2(1.0, 1.0)).contains(present)
                    );
                }
            }
        }
    }
}
