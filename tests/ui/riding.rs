//! Riding: keys pedal and brake, the instruments and all else on screen follow, and the ride is recorded as
//! it was ridden.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Pos2, Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{
    Command, GazeCommand, PlaybackCommand, SettingsCommand, ShowCommand, Switch, WindowCommand,
};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::riding::saddle::RideCommand;
use gamow::eye::Eye;
use gamow::flags::choices::Layout;
use gamow::settings::{MapFrame, Preset, Riding, Settings};
use relativity_core::{Baseline, Model, Observer, ObserverVelocity, SourcePoint, Speed};

use super::Test;
use super::support::{
    FRAME, assert_sane, in_layout, label_starting_with, labels, pane, settle, shown, type_into, wide_window,
    window, window_of_size, window_without_pictures,
};

pub const TESTS: &[Test] = trials![
    pedals_and_brakes_are_recorded_as_they_are_pushed,
    who_walks_goes_where_they_look_and_leaves_the_bicycle,
    a_rider_reads_what_the_core_says,
    a_ride_off_the_street_has_the_cores_numbers_and_a_map,
    the_map_follows_a_ride_aslant,
    a_typed_speed_is_reached_by_pedalling,
    the_map_has_a_riders_frame_while_one_rides,
    a_fit_finds_ones_own_speed,
    a_ride_is_one_large_picture_and_getting_off_gives_the_layout_back,
    the_caption_of_a_passage_goes_while_one_rides,
    one_command_opens_the_street_and_rides,
    the_large_speed_is_ones_own,
    the_throttle_is_reached_by_pedalling,
    instruments_cover_nothing_that_is_marked,
    a_ride_is_compared_with_standing_at_the_same_place,
];

fn street() -> State {
    let mut state = State::open(Settings::default()).expect("a preset");
    state.run(PlaybackCommand::GoTo(0.0));
    state
}

fn preset(name: &str) -> State {
    State::open(Preset::named(name).expect("a preset").settings.clone()).expect("its scene is one")
}

fn state<'a>(window: &'a Harness<'_, App>) -> &'a State {
    window.state().state()
}

fn pedals_and_brakes_are_recorded_as_they_are_pushed() {
    let mut window = window_without_pictures(street(), [800.0, 600.0]);
    window.key_press(Key::I);
    window.run_steps(2);
    assert!(state(&window).document.settings.ride.is_on() && state(&window).scratch.playing);
    let has_bicycle = |window: &Harness<'_, App>| {
        state(window).document.scene.names.iter().any(|name| name == "my handlebar")
    };
    assert!(has_bicycle(&window));
    let push = state(&window).document.settings.ride.push;

    window.key_down(Key::ArrowUp);
    window.run_steps(33);
    window.key_up(Key::ArrowUp);
    window.step();
    let ride = state(&window).document.settings.ride.clone();
    let legs = ride.ride.0.as_deref().expect("it is on").to_vec();
    let pushed = legs.last().expect("it was pushed");
    assert_eq!(pushed.acceleration, [push, 0.0, 0.0]);
    assert!((pushed.duration / f64::from(FRAME) - 32.0).abs() < 2.5, "{legs:?}");
    let rapidity = state(&window).rider().velocity.rapidity();
    assert!((rapidity - push * pushed.duration).abs() < 1e-12);
    // Constant proper acceleration from rest, in closed form.
    let begun = legs[..legs.len() - 1].iter().map(|leg| leg.duration).sum::<f64>();
    let before = ride.rider(begun);
    let after = ride.rider(begun + pushed.duration);
    let expected = (rapidity.cosh() - 1.0) / push;
    assert!((after.x - before.x - expected).abs() < 1e-12, "{} {expected}", after.x);

    // Who brakes for longer than it takes stays where they are.
    window.key_down(Key::S);
    window.run_steps(45);
    assert!(state(&window).rider().velocity.rapidity().abs() < 1e-12);
    let place = state(&window).rider().x;
    window.run_steps(5);
    assert!((state(&window).rider().x - place).abs() < 1e-10);
    window.key_up(Key::S);
    window.step();
    // A new push goes the other way.
    window.key_down(Key::S);
    window.run_steps(10);
    window.key_up(Key::S);
    window.step();
    assert!(state(&window).rider().velocity.beta() < -0.05);
    assert_sane(state(&window));

    // Each push is a step: the last is taken back, and with it where it led.
    window.state_mut().run(Command::Undo);
    window.state_mut().run(PlaybackCommand::Toggle);
    assert!(state(&window).rider().velocity.rapidity().abs() < 1e-12);
    window.state_mut().run(Command::Undo);
    assert!(state(&window).rider().velocity.rapidity() > 0.1);

    window.key_press(Key::I);
    window.run_steps(2);
    assert!(!state(&window).document.settings.ride.is_on());
    assert!(!has_bicycle(&window));
    assert_eq!(state(&window).document.settings.motion.turn, 0.0);
}

fn who_walks_goes_where_they_look_and_leaves_the_bicycle() {
    let hold = |window: &mut Harness<'_, App>, keys: &[Key], frames: usize| {
        for key in keys {
            window.key_down(*key);
        }
        window.run_steps(frames);
        for key in keys {
            window.key_up(*key);
        }
        window.step();
    };
    // Keys are let go one after the other, which leaves short legs between.
    let last_leg = |window: &Harness<'_, App>| {
        let legs = state(window).document.settings.ride.ride.0.clone().expect("it is on");
        *legs.iter().rfind(|leg| leg.duration > 0.3).expect("it was pushed")
    };
    let mut window = window_without_pictures(street(), [800.0, 600.0]);
    window.key_press(Key::I);
    window.run_steps(2);
    let (bodies, push) =
        (state(&window).document.scene.bodies.len(), state(&window).document.settings.ride.push);
    hold(&mut window, &[Key::D], 40);
    let leg = last_leg(&window);
    assert_eq!(leg.acceleration, [0.0, -push, 0.0]);
    assert!(state(&window).document.scene.bodies.len() < bodies, "the bicycle stays behind");
    let rider = state(&window).rider();
    let rapidity = push * leg.duration;
    assert!((rider.velocity.rapidity() - rapidity).abs() < 1e-12);
    let coasted = state(&window).document.time - state(&window).document.settings.ride.duration();
    let expected = (rapidity.cosh() - 1.0) / push + rapidity.sinh() * coasted;
    assert!((rider.aside[0] + expected).abs() < 1e-12 && (rider.x + 20.0).abs() < 1e-12, "{rider:?}");
    assert!(label_starting_with(&window, "Left eye, instruments").contains("at x, y = "));
    assert_sane(state(&window));

    // Two keys push between both; the head is carried, and turns against the observer's axes.
    hold(&mut window, &[Key::W, Key::D], 30);
    let [ahead, left, _] = last_leg(&window).acceleration;
    assert!((ahead - push * 0.5_f64.sqrt()).abs() < 1e-15 && (left + ahead).abs() < 1e-15);
    // Who brakes comes to rest from any way of moving.
    hold(&mut window, &[Key::ArrowDown], 90);
    assert!(state(&window).rider().velocity.rapidity() < 1e-12);
    let place = state(&window).rider().observer().place;
    window.run_steps(3);
    assert!((state(&window).rider().observer().place[1] - place[1]).abs() < 1e-10);
    hold(&mut window, &[Key::A], 20);
    window.state_mut().run(RideCommand::Face);
    window.run_steps(2);
    let velocity = state(&window).rider().observer().velocity.direction();
    let camera = state(&window).view(Eye::Left, [400, 300]).camera;
    let gaze = camera.gaze.axes();
    assert!((gaze.right.x * velocity[0] + gaze.right.y * velocity[1]).abs() < 1e-9, "{velocity:?}");
    assert!(gaze.forward.x * velocity[0] + gaze.forward.y * velocity[1] > 0.9);
    assert!((camera.off_middle.normalize() + gaze.right).length() < 1e-9, "both eyes are abreast");
    hold(&mut window, &[Key::ArrowDown], 90);
    window.state_mut().run(RideCommand::Face);
    window.step();
    // A head that turns on has pushes in steps of 5 degrees.
    window.state_mut().run(GazeCommand::Aside([-0.11, 0.0]));
    window.step();
    hold(&mut window, &[Key::W], 10);
    let [ahead, left, _] = last_leg(&window).acceleration;
    let degrees = left.atan2(ahead).to_degrees();
    let looks = state(&window).gaze().azimuth.to_degrees();
    assert!((degrees / 5.0 - (degrees / 5.0).round()).abs() < 1e-12 && (degrees - looks).abs() < 2.5);
    assert!(degrees > 4.0, "{degrees}");
    assert_sane(state(&window));

    window.state_mut().run(PlaybackCommand::Toggle);
    for _ in 0..12 {
        if !state(&window).document.settings.ride.is_straight() {
            window.state_mut().run(Command::Undo);
            window.step();
        }
    }
    assert_eq!(state(&window).document.scene.bodies.len(), bodies, "back on the bicycle");
}

fn a_rider_reads_what_the_core_says() {
    let mut window = window(preset("ride-lamps"));
    window.state_mut().run(PlaybackCommand::GoTo(9.0));
    window.run_steps(2);
    let speed = Speed::from_beta(0.9).expect("a speed");
    let gamma = speed.gamma();
    let velocity = ObserverVelocity::along_street(speed);
    let observer = Observer { velocity, place: [0.9 * gamma * 9.0, 5.5, 0.0], time: gamma * 9.0 };
    // Facing ahead, the left eye is at the greater y.
    let pair = Baseline { turn: -std::f64::consts::FRAC_PI_2, ..Baseline::straight(0.1) }.apertures();
    let lamp = SourcePoint { x0: 20.0, y: 1.2, z: 2.4 };
    let both = observer.disparity(Model::Exact, &Speed::REST, lamp, pair, 0.0).expect("in the domain");
    for (label, expected) in [
        ("Left eye, Doppler factor D", both.primary.doppler_factor),
        ("Right eye, happened t", both.secondary.retarded_time),
        ("Left eye, received s", 9.0),
        ("Left eye, azimuth φ", both.primary.phi()),
    ] {
        assert!((shown(&window, label) - expected).abs() < 6e-5, "{label}: {expected}");
    }
    // The street's clock at x shows T + V (x - o) now, in the frame of who rides.
    let reckoned = observer.time + 0.9 * (20.0 - observer.place[0]);
    assert!((shown(&window, "Proper time now, by my reckoning") - reckoned).abs() < 6e-5);
    assert!((shown(&window, "Disparity Δφ") - both.dphi).abs() < 6e-6);
    let instruments = label_starting_with(&window, "Left eye, instruments");
    // Its wheel counts the contracted street, its lamps the street's own.
    for part in [
        "my speed 0.900\u{a0}c",
        "γ = 2.294",
        "η = 1.472",
        "my clock 9.00",
        "clock of the street here 20.65",
        "ridden: 8.10 by my wheel, 18.58 by the lamps",
        "I am at x = 18.58",
    ] {
        assert!(instruments.contains(part), "{part} in {instruments}");
    }
}

fn a_ride_off_the_street_has_the_cores_numbers_and_a_map() {
    let mut window = window(preset("ride-lamps"));
    window.state_mut().run(PlaybackCommand::GoTo(8.0));
    let bodies = state(&window).document.scene.bodies.len();
    let along = state(&window).document.settings.ride.clone();
    let aslant = Riding { ride_azimuth: 60.0, ..along.clone() };
    window.state_mut().run(RideCommand::Set(aslant));
    window.run_steps(2);
    // A bicycle faces along the street.
    assert!(state(&window).document.scene.bodies.len() < bodies);
    let speed = Speed::from_beta(0.9).expect("a speed");
    let way = 0.9 * speed.gamma() * 8.0;
    let velocity = ObserverVelocity::new(speed, 60_f64.to_radians(), 0.0);
    let place = [0.5 * way, 5.5 + 0.75_f64.sqrt() * way, 0.0];
    let observer = Observer { velocity, place, time: speed.gamma() * 8.0 };
    let pair = Baseline { turn: -std::f64::consts::FRAC_PI_2, ..Baseline::straight(0.1) }.apertures();
    let lamp = SourcePoint { x0: 20.0, y: 1.2, z: 2.4 };
    let both = observer.disparity(Model::Exact, &Speed::REST, lamp, pair, 0.0).expect("in the domain");
    assert!((shown(&window, "Left eye, Doppler factor D") - both.primary.doppler_factor).abs() < 6e-5);
    assert!((shown(&window, "Right eye, happened t") - both.secondary.retarded_time).abs() < 6e-5);
    assert!((shown(&window, "Disparity Δφ") - both.dphi).abs() < 6e-6);
    assert_sane(state(&window));

    window.state_mut().run(RideCommand::Set(along));
    window.run_steps(2);
    assert_eq!(state(&window).document.scene.bodies.len(), bodies);
}

/// From the middle between the eyes' marks on the map to `mark`, points to the right and up.
fn on_map(window: &Harness<'_, App>, mark: &str) -> [f32; 2] {
    let at = |name: &str| window.get_by_label(&format!("Map, from above: {name}")).rect().center();
    let way = at(mark) - at("Left eye").lerp(at("Right eye"), 0.5);
    [way.x, -way.y]
}

/// Holds marks of the map against a ruler: all of them have one scale, that of the eyes' distance.
fn assert_on_map(window: &Harness<'_, App>, marks: &[(&str, [f64; 2])]) {
    let [(first, [x, y]), ..] = marks else { panic!("there are marks") };
    let found = on_map(window, first);
    let scale = f64::from(found[0].hypot(found[1])) / x.hypot(*y);
    for (mark, place) in marks {
        let found = on_map(window, mark);
        for (found, expected) in found.into_iter().zip(place) {
            let expected = scale * expected;
            assert!((f64::from(found) - expected).abs() < 0.6, "{mark}: {found} for {expected}");
        }
    }
}

/// The marks of the map at 0.9 c in a direction of 60 degrees: on the ground where things are, and in my
/// frame by the boost without turning.
fn the_map_follows_a_ride_aslant() {
    let mut state = preset("ride-lamps");
    let ride = Riding { ride_azimuth: 60.0, ..state.document.settings.ride.clone() };
    state.run(RideCommand::Set(ride));
    state.run(PlaybackCommand::GoTo(8.0));
    let mut window = wide_window(state);
    window.run_steps(2);
    let gamma = 1.0 / (1.0_f64 - 0.81).sqrt();
    let (sin, cos) = 60_f64.to_radians().sin_cos();
    let way = 0.9 * gamma * 8.0;
    // The lamp, from the observer: the street starts 5.5 nearer.
    let settings = self::state(&window).document.settings.clone();
    let start = self::state(&window).rider().observer().place;
    assert!((start[0] - cos * way).abs() < 1e-9 && (start[1] - sin * way).abs() < 1e-9);
    let rest = settings.rest_place([20.0, 1.2, 2.4]);
    let [x, y, z] = [rest[0] - start[0], rest[1] - start[1], rest[2]];
    let name = self::state(&window).name_of(self::state(&window).document.points.selected());
    let measured = format!("{name}, measured now");
    let eye = 0.05;
    assert_on_map(
        &window,
        &[(&measured, [x, y]), ("Left eye", eyes_of_a_turned_head(eye, gamma, [cos, sin]))],
    );

    window.state_mut().run(SettingsCommand::Switch(Switch::Frame));
    window.state_mut().run(SettingsCommand::Switch(Switch::Frame));
    window.run_steps(2);
    assert_eq!(self::state(&window).document.settings.map_frame(), MapFrame::Rider);
    let ahead = cos * x + sin * y;
    let contracted = (1.0 / gamma - 1.0) * ahead;
    let distance = (x * x + y * y + z * z).sqrt();
    // P' = P + [(Gamma - 1) P_p + Gamma V R] along the motion, for the middle of both eyes.
    let stretched = (gamma - 1.0) * ahead + gamma * 0.9 * distance;
    let seen = [x + stretched * cos, y + stretched * sin];
    let marks = [(measured.as_str(), [x + contracted * cos, y + contracted * sin])];
    assert_on_map(&window, &marks);
    let [left, right] =
        ["left", "right"].map(|eye| on_map(&window, &format!("{name}, as the {eye} eye sees it")));
    let scale = f64::from(on_map(&window, &measured)[0]) / marks[0].1[0];
    for axis in 0..2 {
        let middle = 0.5 * f64::from(left[axis] + right[axis]);
        assert!((middle - scale * seen[axis]).abs() < 1.0, "{middle} {}", scale * seen[axis]);
    }
    assert_sane(self::state(&window));
}

/// The left eye on the ground, from the middle: of a head that faces along x, `aside`, and Gamma times as far
/// along the motion.
fn eyes_of_a_turned_head(aside: f64, gamma: f64, ahead: [f64; 2]) -> [f64; 2] {
    let along = (gamma - 1.0) * aside * ahead[1];
    [along * ahead[0], aside + along * ahead[1]]
}

fn a_typed_speed_is_reached_by_pedalling() {
    let mut state = street();
    state.run(Command::Ride(gamow::app::state::riding::saddle::RideCommand::Toggle));
    state.run(PlaybackCommand::Toggle);
    let mut window = window(state);
    type_into(&mut window, "My speed β, typed", "0.6");
    assert!(
        (self::state(&window).rider().velocity.beta() - 0.6).abs() < 1e-12,
        "at the start it is had at once"
    );
    window.state_mut().run(PlaybackCommand::GoTo(2.0));
    type_into(&mut window, "My speed β, typed", "gamma:-1.25");
    let ride = &self::state(&window).document.settings.ride;
    let needed = 2.0 * 0.6_f64.atanh() / ride.push;
    assert!((ride.duration() - 2.0 - needed).abs() < 1e-12);
    assert!((ride.rider(ride.duration()).velocity.beta() + 0.6).abs() < 1e-12);
    type_into(&mut window, "My speed β, typed", "1.5");
    let told = super::support::labels(&window);
    assert!(told.iter().any(|label| label.contains("beta = 1.5 is out of range")), "{told:?}");
}

fn the_map_has_a_riders_frame_while_one_rides() {
    let mut window = wide_window(preset("ride-lamps"));
    for (expected, key) in
        [(MapFrame::Bicycle, "Bicycle"), (MapFrame::Rider, "Mine"), (MapFrame::Ground, "Ground")]
    {
        window.key_press(Key::G);
        window.run_steps(2);
        assert_eq!(state(&window).document.settings.map.frame, expected, "{key}");
        assert_sane(state(&window));
    }
    assert!(window.query_by_label("Mine").is_some());
    window.key_press(Key::I);
    window.run_steps(2);
    assert!(window.query_by_label("Mine").is_none());
}

fn a_fit_finds_ones_own_speed() {
    let along = Preset::named("ride-lamps").expect("a preset").settings.clone();
    let mut aslant = along.clone();
    (aslant.ride.ride_azimuth, aslant.motion.turn) = (60.0, -30.0);
    // The lamp is 20 ahead on the street and 4.3 aside of it.
    let aside = 4.3 * 60_f64.to_radians().cos() + 20.0 * 60_f64.to_radians().sin();
    for (mut settings, expected) in [(along, 4.3), (aslant, aside)] {
        settings.plots.plot = gamow::settings::PlotTab::Fit;
        settings.fit.noise_percent = 0.0;
        let mut window = window(State::open(settings).expect("a preset"));
        settle(&mut window);
        let outcome = window.state().fitting().shown().expect("it is fitted");
        let fitted = outcome.fitted.as_ref().expect("it can be");
        let beta = fitted.value(relativity_core::Parameter::Beta).expect("it is fitted");
        let aside = fitted.value(relativity_core::Parameter::Y).expect("it is fitted");
        assert!((beta - 0.9).abs() < 1e-6 && (aside - expected).abs() < 1e-5, "{beta} {aside} {expected}");
    }
}

fn layout(window: &Harness<'_, App>) -> Layout {
    state(window).document.settings.picture.layout
}

fn a_ride_is_one_large_picture_and_getting_off_gives_the_layout_back() {
    let glasses = [Layout::Anaglyph, Layout::CrossEyed, Layout::Right, Layout::Left];
    for (before, ridden) in [Layout::SideBySide, Layout::OverUnder]
        .map(|apart| (apart, Layout::Left))
        .into_iter()
        .chain(glasses.map(|kept| (kept, kept)))
    {
        let mut window = window(street());
        window.state_mut().run(in_layout(before));
        window.key_press(Key::I);
        window.run_steps(2);
        assert_eq!(layout(&window), ridden, "{before:?}");
        window.key_press(Key::I);
        window.run_steps(2);
        assert_eq!(layout(&window), before);
        // A preset of a ride has it too, and takes it away again.
        let named = |name| ShowCommand::Preset(Preset::named(name).expect("a preset"));
        window.state_mut().run(named("ride-lamps"));
        assert_eq!(layout(&window), ridden, "{before:?}");
        assert_eq!(state(&window).document.preset.map(|preset| preset.name), Some("ride-lamps"));
        window.state_mut().run(named("die"));
        let expected = if ridden == before { before } else { Layout::SideBySide };
        assert!(layout(&window) == expected || before == Layout::Left, "{before:?}");
    }
    let mut window = window(street());
    window.key_press(Key::I);
    window.run_steps(2);
    let picture = pane(&window, 0);
    assert!(window.query_by_label("Right eye view").is_none());
    assert!(picture.width() > 700.0, "{picture:?}");
    // Who chose two pictures on the ride keeps them.
    window.state_mut().run(in_layout(Layout::OverUnder));
    window.key_press(Key::I);
    window.run_steps(2);
    assert_eq!(layout(&window), Layout::OverUnder);
}

fn the_caption_of_a_passage_goes_while_one_rides() {
    let passage = Preset::named("street").expect("a preset");
    let mut window = window_without_pictures(street(), [1366.0, 768.0]);
    let says = |window: &mut Harness<'_, App>| {
        window.run_steps(3);
        let is_caption = |label: &String| label.len() > 20 && passage.caption.starts_with(label.as_str());
        labels(window).iter().any(is_caption)
    };
    for is_presented in [false, true] {
        window.state_mut().run(ShowCommand::Preset(passage));
        assert!(says(&mut window), "{is_presented}");
        window.key_press(Key::I);
        assert!(!says(&mut window), "{is_presented}");
        window.key_press(Key::I);
        assert!(says(&mut window), "{is_presented}");
        window.state_mut().run(WindowCommand::TogglePresenting);
    }
}

fn one_command_opens_the_street_and_rides() {
    let mut window = window(preset("globe"));
    window.state_mut().run(ShowCommand::Ride);
    window.run_steps(2);
    let Settings { scene, ride, .. } = &*state(&window).document.settings;
    assert_eq!((scene.as_str(), ride.is_on(), layout(&window)), ("street", true, Layout::Left));
    assert!(state(&window).scratch.playing && state(&window).rider().velocity.beta() == 0.0);
    window.state_mut().run(Command::Undo);
    window.run_steps(2);
    assert_eq!(state(&window).document.settings.scene, "globe");
    assert_sane(state(&window));
}

/// The speed is written large in three places, and in all of them it is the rider's.
fn the_large_speed_is_ones_own() {
    let has = |window: &Harness<'_, App>, text: &str| labels(window).iter().any(|label| label == text);
    for simple in [true, false] {
        let mut state = preset("ride-overtaking");
        state.document.settings.window.simple = simple;
        let mut window = window(state);
        assert!(has(&window, "I ride at 0.900\u{a0}c") && !has(&window, "β = 0.5"), "{simple}");
        // With few controls there is one slider for speeds.
        assert_eq!(has(&window, "cyclist at 0.5\u{a0}c"), !simple);
        let speeds = ["Speed β", "My speed β"].map(|name| {
            window
                .query_all_by(|node| node.role() == Role::Slider && node.label().as_deref() == Some(name))
                .count()
        });
        assert_eq!(speeds, [usize::from(!simple), 1]);
        window.key_press(Key::P);
        window.run_steps(3);
        assert!(has(&window, "I ride at 0.900\u{a0}c") && !has(&window, "β = 0.5"));
        assert!(has(&window, "cyclist at 0.5\u{a0}c"));
    }
    // Where no body moves none has a speed, and without a ride the bodies' is the large one.
    let mut window = window(preset("ride-lamps"));
    assert!(!labels(&window).iter().any(|label| label.contains("at 0.000")));
    window.key_press(Key::I);
    window.run_steps(2);
    assert!(has(&window, "β = 0"));
    let mut narrow = window_without_pictures(preset("ride-overtaking"), [360.0, 740.0]);
    narrow.run_steps(2);
    assert!(has(&narrow, "I ride at 0.900\u{a0}c"));
}

fn the_throttle_is_reached_by_pedalling() {
    let mut state = preset("ride-lamps");
    state.document.settings.window.simple = true;
    let mut window = window(state);
    window.get_by_label("Set β to 0.99").click();
    window.run_steps(2);
    assert!(self::state(&window).scratch.playing, "T runs");
    let ride = &self::state(&window).document.settings.ride;
    let needed = (0.99_f64.atanh() - 0.9_f64.atanh()) / ride.push;
    assert!((ride.duration() - 10.0 - needed).abs() < 1e-9);
    assert!((ride.rider(ride.duration()).velocity.beta() - 0.99).abs() < 1e-12);
    let target = self::state(&window).throttle().speed().beta();
    assert!((target - 0.99).abs() < 1e-12, "the slider shows what is aimed at: {target}");
    let speed = self::state(&window).rider().velocity.beta();
    assert!(speed > 0.9 && speed < 0.99, "{speed}");
    window.state_mut().run(Command::Undo);
    assert!(self::state(&window).document.settings.ride.coasts());
    assert_sane(self::state(&window));
}

/// At all of these sizes: every followed point in the picture is beside the instruments.
fn instruments_cover_nothing_that_is_marked() {
    const SIZES: [[f32; 2]; 4] = [[360.0, 740.0], [1024.0, 600.0], [1280.0, 800.0], [1920.0, 1080.0]];
    for name in ["ride-lamps", "ride-post-office", "ride-tunnel", "ride-overtaking", "ride-twins"] {
        for size in SIZES {
            let mut window = window_of_size(preset(name), size, 0.25);
            for time in [0.0, 5.0, 9.0, 11.0] {
                window.state_mut().run(PlaybackCommand::GoTo(time));
                window.run_steps(2);
                let Some(node) = window.query_by(|node| {
                    node.value().is_some_and(|text| text.starts_with("Left eye, instruments"))
                }) else {
                    panic!("{name} at {size:?} has no instruments")
                };
                let (instruments, picture) = (node.rect(), pane(&window, 0));
                assert!(
                    picture.contains_rect(instruments),
                    "{name} at {size:?}: {instruments:?} {picture:?}"
                );
                for place in marked(&window, picture) {
                    assert!(!instruments.contains(place), "{name} at {size:?}, {time}: {place:?}");
                }
            }
        }
    }
}

/// Places of the followed points in the left eye's picture.
fn marked(window: &Harness<'_, App>, picture: Rect) -> Vec<Pos2> {
    let state = state(window);
    let size = [picture.width(), picture.height()].map(|side| side.round() as u32);
    let camera = state.view(Eye::Left, size).camera;
    let points = state.document.points.all().iter();
    points
        .filter_map(|point| camera.pixel(state.direction(point, Eye::Left)?))
        .map(|[u, v]| picture.min + vec2(u as f32, v as f32))
        .filter(|place| picture.contains(*place))
        .collect()
}

fn a_ride_is_compared_with_standing_at_the_same_place() {
    let mut window = wide_window(preset("ride-lamps"));
    window.state_mut().run(SettingsCommand::Switch(Switch::Comparison));
    window.run_steps(3);
    assert!(window.query_by_label("Left eye view: standing here").is_some());
    let [riding, standing] = ["Left eye, instruments", "Second picture, instruments"]
        .map(|name| label_starting_with(&window, name));
    assert!(riding.contains("my speed 0.900") && standing.contains("my speed 0.000"), "{standing}");
    for instruments in [riding, standing] {
        for part in ["clock of the street here 22.94", "I am at x = 20.65"] {
            assert!(instruments.contains(part), "{part} in {instruments}");
        }
    }
    assert_sane(state(&window));
    window.key_press(Key::I);
    window.run_steps(2);
    assert!(window.query_by_label("Right eye view").is_some());
    assert_sane(state(&window));
}
