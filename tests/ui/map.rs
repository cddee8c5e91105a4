//! The map: its marks are where the core says, whatever the size; the mouse in it; what it shows in each
//! frame.

use eframe::egui::{Key, Modifiers, Pos2, Rect, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{PlaybackCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::settings::{
    MapFrame, MapFraming, MapSettings, MotionSettings, Presence, Settings, WindowSettings,
};
use relativity_core::Speed;

use super::Test;
use super::layouts::assert_no_broken_numbers;
use super::picking::click;
use super::support::{
    SEPARATION, TRACKED, cyclist, drag, label_starting_with, labels, seen, wide_window, window_of_size,
};

pub const TESTS: &[Test] = trials![
    marks_on_the_map_are_where_the_numbers_say_to_half_a_pixel,
    the_bicycle_rests_in_its_own_frame_and_the_eyes_ride_past,
    abreast_is_said_when_it_is_measured_there_and_when_it_is_seen_there,
    clicking_the_map_selects_the_point_there,
    what_is_under_the_pointer_on_the_map_is_told_with_its_times,
    the_map_is_dragged_zoomed_at_the_pointer_and_fitted_again,
    a_close_up_tells_the_length_of_a_rod_to_one_eye_and_to_two,
    a_hidden_map_is_not_there_at_all,
    the_keys_of_the_map_do_what_the_help_says,
    the_map_is_whole_at_every_size,
    no_speed_distance_or_time_breaks_the_map,
];

const SIZES: [[f32; 2]; 4] = [[800.0, 600.0], [1024.0, 600.0], [1280.0, 800.0], [1920.0, 1080.0]];

/// A window that is large enough for the map shows `state`.
fn map_window(state: State) -> Harness<'static, App> {
    wide_window(state)
}

/// The middle of the mark called `name`.
fn mark(window: &Harness<'_, App>, name: &str) -> Pos2 {
    window.get_by_label(name).rect().center()
}

fn point(picture: &str) -> String {
    format!("front tyre, {picture}")
}

/// Goes to `time`.
fn go_to(window: &mut Harness<'_, App>, time: f64) {
    window.state_mut().run(PlaybackCommand::GoTo(time));
    window.run();
}

/// A chart as it is found by where two marks of known places are: how many points a unit has, and where 0 is.
struct Found {
    scale: f64,
    origin: [f64; 2],
}

impl Found {
    /// From where the tracked point is measured at two times, at x = beta T, and an eye, which is at 0 in
    /// depth and height.
    fn new(window: &mut Harness<'_, App>, chart: &str, beta: f64, [first, last]: [f64; 2]) -> Self {
        let mut measured = |time| {
            go_to(window, time);
            f64::from(mark(window, &format!("{chart}: {}", point("measured now"))).x)
        };
        let [left, right] = [measured(first), measured(last)];
        let scale = (right - left) / (beta * (last - first));
        let eye = f64::from(mark(window, &format!("{chart}: Left eye")).y);
        Self { scale, origin: [left - scale * beta * first, eye] }
    }

    fn place(&self, right: f64, up: f64) -> Pos2 {
        pos2((self.origin[0] + self.scale * right) as f32, (self.origin[1] - self.scale * up) as f32)
    }
}

fn marks_on_the_map_are_where_the_numbers_say_to_half_a_pixel() {
    for size in SIZES {
        for beta in [0.3, 0.9, 0.99] {
            let mut state = cyclist(beta);
            state.document.settings.window =
                WindowSettings { map: Presence::On, views: false, ..state.document.settings.window };
            let mut window = window_of_size(state, size, 1.0);
            for (chart, up) in [("Map, from above", 1), ("Map, from the side", 2)] {
                let found = Found::new(&mut window, chart, beta, [-3.0, 5.0]);
                for time in [1.0, 2.5, 4.0] {
                    go_to(&mut window, time);
                    assert_marks(&window, chart, up, &found, beta);
                }
            }
        }
    }
}

/// What the eyes see is where the core has it; their lines of sight cross where both take it to be.
#[track_caller]
fn assert_marks(window: &Harness<'_, App>, chart: &str, up: usize, found: &Found, beta: f64) {
    let time = window.state().state().document.time;
    let [left, right] = [0, 1].map(|eye| seen(beta, time, eye).position);
    let near = |name: &str, [x, along]: [f64; 2]| {
        let (shown, expected) = (mark(window, &format!("{chart}: {name}")), found.place(x, along));
        assert!(shown.distance(expected) < 0.5, "{chart}: {name} at {shown:?}, not {expected:?}; T = {time}");
    };
    near(&point("as the left eye sees it"), [left[0] - 0.5 * SEPARATION, left[up]]);
    near(&point("as the right eye sees it"), [right[0] + 0.5 * SEPARATION, right[up]]);
    let crossing = SEPARATION / (left[0] - right[0]);
    let both = [-0.5 * SEPARATION + crossing * left[0], crossing * left[up]];
    near(&point("where two eyes place it"), both);
    near(&point("measured now"), [beta * time, TRACKED[up]]);
    near("Right eye", [0.5 * SEPARATION, 0.0]);
}

fn the_bicycle_rests_in_its_own_frame_and_the_eyes_ride_past() {
    let mut window = map_window(cyclist(0.9));
    window
        .state_mut()
        .run(SettingsCommand::Map(MapSettings { frame: MapFrame::Bicycle, ..MapSettings::default() }));
    let gamma = Speed::from_beta(0.9).expect("a speed").gamma();
    let name = format!("Map, from above: {}", point("measured now"));
    let mut at = |time| {
        go_to(&mut window, time);
        (
            mark(&window, &name),
            mark(&window, "Map, from above: Left eye"),
            mark(&window, "Map, from above: Right eye"),
        )
    };
    let ((rest, earlier, _), (still, later, right)) = (at(-1.0), at(1.0));
    assert_eq!(rest, still);
    // Two units of T are 2 gamma on board; the eyes ride back by beta times that, d/gamma apart, 3 from the
    // bicycle.
    let scale = (later.y - still.y) / 3.0;
    assert!((earlier.x - later.x - 2.0 * 0.9 * gamma as f32 * scale).abs() < 0.5, "{earlier:?} {later:?}");
    assert!((right.x - later.x - 0.1 / gamma as f32 * scale).abs() < 0.1, "{later:?} {right:?}");
}

fn abreast_is_said_when_it_is_measured_there_and_when_it_is_seen_there() {
    let mut window = map_window(cyclist(0.9));
    let said = |window: &Harness<'_, App>| {
        ["measured abreast", "seen abreast"]
            .map(|words| window.query_by_label(&format!("Map, from above: {words}")).is_some())
    };
    go_to(&mut window, 0.0);
    assert_eq!(said(&window), [true, false]);
    go_to(&mut window, 13.0025f64.sqrt());
    assert_eq!(said(&window), [false, true]);
    go_to(&mut window, 8.0);
    assert_eq!(said(&window), [false, false]);
}

fn clicking_the_map_selects_the_point_there() {
    let mut state = cyclist(0.9);
    state.document.settings.window.plots = false;
    let mut window = map_window(state);
    let found = Found::new(&mut window, "Map, from the side", 0.9, [0.0, 2.0]);
    // The top of the front tyre, the first body of the file, where it is measured at T = 2: contracted.
    let gamma = Speed::from_beta(0.9).expect("a speed").gamma();
    let place = found.place(-0.525 / gamma + 0.9 * 2.0, 2.0 + 0.493);
    click(&mut window, place, Modifiers::SHIFT);
    let points = window.state().state().document.points.clone();
    let selected = points.selected();
    assert_eq!((points.all().len(), selected.body), (2, Some(0)));
    let [x, y, z] = selected.track.rest;
    assert!((x + 0.525).abs() < 0.05 && (z - 2.493).abs() < 0.02, "{:?}", selected.track.rest);
    // On the side of the tyre that faces the eyes.
    assert!((y - (3.0 - 0.032)).abs() < 1e-9, "{y}");
    let corner = window_corner(&window);
    click(&mut window, corner, Modifiers::NONE);
    assert_eq!(window.state().state().document.points, points);
}

fn window_corner(window: &Harness<'_, App>) -> Pos2 {
    window.get_by_label("Map, from above").rect().right_bottom() - vec2(10.0, 6.0)
}

fn what_is_under_the_pointer_on_the_map_is_told_with_its_times() {
    let mut window = map_window(cyclist(0.9));
    go_to(&mut window, 1.5);
    let told = |window: &mut Harness<'_, App>, name: &str| {
        let place = mark(window, &format!("Map, from the side: {name}"));
        window.hover_at(place);
        // Until the pointer has stayed for long enough.
        window.run_steps(20);
        labels(window).into_iter().find(|label| label.contains("\nx = ")).expect("it is told")
    };
    let text = told(&mut window, &point("measured now"));
    assert!(text.contains("measured now") && text.contains("now t = 1.500"), "{text}");
    let text = told(&mut window, &point("as the left eye sees it"));
    let seen = seen(0.9, 1.5, 0);
    assert!(text.contains("as the left eye sees it") && text.contains("received T = 1.500"), "{text}");
    // Of the outline near the point, not of the point itself: as far as its line is thick.
    let happened = text.split("happened t = ").nth(1).and_then(|rest| rest.lines().next()).expect("a time");
    let happened: f64 = happened.replace('−', "-").parse().expect("a number");
    assert!((happened - seen.retarded_time).abs() < 0.2, "{happened} for {}", seen.retarded_time);
    let text = told(&mut window, "Left eye");
    assert_eq!(text, "Left eye\nx = −0.050,  y = 0.000,  z = 0.000\nreceived T = 1.500");
}

fn the_map_is_dragged_zoomed_at_the_pointer_and_fitted_again() {
    let mut window = map_window(cyclist(0.9));
    let eye = |window: &Harness<'_, App>| mark(window, "Map, from above: Left eye");
    let before = eye(&window);
    let chart = window.get_by_label("Map, from above").rect();
    let from = chart.center() + vec2(40.0, 10.0);
    drag(&mut window, from, from + vec2(-30.0, -12.0));
    assert!(
        (eye(&window) - before - vec2(-30.0, -12.0)).length() < 0.5,
        "{:?} from {before:?}",
        eye(&window)
    );

    let at = eye(&window);
    window.hover_at(at);
    window.step();
    scroll(&mut window, 100.0);
    assert!(eye(&window).distance(at) < 0.5, "what is under the pointer stays there");
    assert!(window.state().state().scratch.map_view.zoom > 1.1);

    for _ in 0..2 {
        window.get_by_label("Map, from above").click();
    }
    window.run_ok();
    assert!(eye(&window).distance(before) < 1e-3);
}

fn scroll(window: &mut Harness<'_, App>, points: f32) {
    window.event(eframe::egui::Event::MouseWheel {
        source: eframe::egui::MouseWheelSource::Wheel,
        unit: eframe::egui::MouseWheelUnit::Point,
        delta: vec2(0.0, points),
        phase: eframe::egui::TouchPhase::Move,
        modifiers: Modifiers::NONE,
    });
    window.run_ok();
}

fn a_close_up_tells_the_length_of_a_rod_to_one_eye_and_to_two() {
    // Seen abreast and far away, a rod of length 2 is contracted to two eyes one above the other; to two eyes
    // along the motion it is sqrt(1 - beta^4) of its length, and turned (physics.md). One eye sees its ends
    // at one ground time.
    const BETA: f64 = 0.8;
    const AWAY: f64 = 4000.0;
    let contracted = 2.0 * (1.0 - BETA * BETA).sqrt();
    for (roll, two_eyes) in [(0.0, 2.0 * (1.0 - BETA.powi(4)).sqrt()), (90.0, contracted)] {
        let mut settings =
            Settings { scene: "two-balls".to_owned(), ..Settings::clone(&cyclist(BETA).document.settings) };
        settings.point = Some([-1.0, 2.9, 2.0]);
        settings.motion =
            MotionSettings { roll, depth_shift: AWAY - 2.9, height_shift: -2.0, ..settings.motion };
        settings.window = WindowSettings { map: Presence::On, views: false, ..settings.window };
        settings.map.framing = MapFraming::CloseUp;
        let mut window = map_window(State::open(settings).expect("a preset"));
        // Its middle is beside the eyes at t = 0.75, and its light takes as long as it is away.
        go_to(&mut window, 0.75 + AWAY);
        for (picture, expected) in [("two eyes", two_eyes), ("left eye", contracted)] {
            let shown = label_starting_with(&window, &format!("Map, from above: length, {picture}: "));
            let length: f64 = shown.rsplit(' ').next().and_then(|text| text.parse().ok()).expect("a number");
            assert!((length - expected).abs() < 0.0051, "{shown} is not {expected}, roll {roll}");
        }
    }
}

fn a_hidden_map_is_not_there_at_all() {
    for window in [
        WindowSettings { map: Presence::Off, ..WindowSettings::default() },
        WindowSettings { map: Presence::Off, views: false, ..WindowSettings::default() },
        WindowSettings { map: Presence::Off, plots: false, ..WindowSettings::default() },
    ] {
        let mut state = cyclist(0.9);
        state.document.settings.window = window;
        let window = window_of_size(state, [1280.0, 800.0], 1.0);
        assert!(!labels(&window).iter().any(|label| label.starts_with("Map, ")));
        assert!(!window.state().state().frame.shows_map);
    }
}

fn the_keys_of_the_map_do_what_the_help_says() {
    let mut window = window_of_size(cyclist(0.9), [1024.0, 600.0], 1.0);
    let is_shown = |window: &Harness<'_, App>| window.query_by_label("Map, from above").is_some();
    let press = |window: &mut Harness<'_, App>, key| {
        window.key_press(key);
        window.run();
    };
    assert!(!is_shown(&window), "there is no room for it unasked");
    press(&mut window, Key::M);
    assert!(is_shown(&window));
    press(&mut window, Key::G);
    assert_eq!(window.state().state().document.settings.map.frame, MapFrame::Bicycle);
    press(&mut window, Key::G);
    assert_eq!(window.state().state().document.settings.map.frame, MapFrame::Ground);
    press(&mut window, Key::M);
    assert!(!is_shown(&window));
}

fn the_map_is_whole_at_every_size() {
    for size in SIZES {
        for others in [true, false] {
            let mut state = cyclist(0.9);
            let alone = WindowSettings {
                views: false,
                plots: false,
                map: Presence::On,
                ..state.document.settings.window
            };
            state.document.settings.window = if others {
                WindowSettings { map: Presence::On, ..state.document.settings.window }
            } else {
                alone
            };
            let window = window_of_size(state, size, 1.0);
            let area = Rect::from_min_size(pos2(0.0, 0.0), size.into());
            for name in ["Map, from above", "Map, from the side", "Space", "Spacetime", "Bicycle", "Close-up"]
            {
                let rect = window.get_by_label(name).rect();
                assert!(area.contains_rect(rect), "{name} at {rect:?} in {size:?}");
            }
            for chart in ["Map, from above", "Map, from the side"] {
                let rect = window.get_by_label(chart).rect();
                let least = if others { 45.0 } else { 150.0 };
                assert!(rect.width() > 380.0 && rect.height() > least, "{chart}: {rect:?} in {size:?}");
                assert!(rect.contains(mark(&window, &format!("{chart}: {}", point("measured now")))));
            }
        }
    }
}

fn no_speed_distance_or_time_breaks_the_map() {
    let speeds = [
        (SpeedParameter::Beta, 0.0),
        (SpeedParameter::Beta, 1e-14),
        (SpeedParameter::Gamma, 1e9),
        (SpeedParameter::Gamma, 1e30),
    ];
    for (parameter, value) in speeds {
        for d in [0.0, 1000.0] {
            let mut state = cyclist(0.5);
            state.document.settings.motion.speed = SpeedSetting::new(parameter, value).expect("a speed");
            state.document.settings.motion.d = d;
            state.document.settings.window.views = false;
            let mut window = map_window(state);
            for frame in [MapFrame::Ground, MapFrame::Bicycle] {
                window.state_mut().run(SettingsCommand::Map(MapSettings { frame, ..MapSettings::default() }));
                for time in [0.0, 3.6, -1e12, 1e12] {
                    go_to(&mut window, time);
                    assert_no_broken_numbers(&window);
                }
            }
            window.render().expect("a picture");
        }
    }
}
