//! Points of wheels that roll: picked in the views of the street, followed, plotted, kept.

use std::f64::consts::FRAC_PI_2;

use eframe::egui::{Key, Modifiers, vec2};
use egui_kittest::Harness;
use gamow::app::commands::{PlaybackCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::points::Point;
use gamow::eye::Eye;
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::scene::Track;
use gamow::settings::{FitSettings, PlotSettings, PlotTab, Settings};
use glam::DVec3;
use relativity_core::{Aperture, Model, SourcePoint, Speed, Turning, WheelPoint};
use relativity_render::Geometry;

use super::Test;
use super::picking::click;
use super::support::{
    SEPARATION, label_starting_with, labels, pane, settle, shown, window, window_without_pictures,
};

pub const TESTS: &[Test] = trials![
    a_clicked_point_of_a_wheel_is_followed_round_with_its_body,
    what_is_told_of_a_point_of_a_wheel_is_what_the_core_has_it,
    curves_of_a_point_of_a_wheel_are_those_of_the_core,
    a_point_of_a_wheel_is_undone_redone_and_kept_in_a_state,
    a_point_of_a_wheel_has_numbers_at_every_speed,
    the_fit_of_a_point_of_a_wheel_finds_its_hub,
    the_pointer_tells_where_on_the_wheel_it_is,
];

/// The street's front wheel: its hub at rest, and the radius on which it rolls.
const HUB: [f64; 3] = [-0.525, 4.0, -1.975];
const RADIUS: f64 = 0.525;

fn street(parameter: SpeedParameter, speed: f64) -> State {
    let mut settings = Settings { scene: "street".to_owned(), time: Some(3.0), ..Settings::default() };
    settings.motion.speed = SpeedSetting::new(parameter, speed).expect("a speed");
    State::open(settings).expect("a preset")
}

fn size(window: &Harness<'_, App>, eye: usize) -> [u32; 2] {
    let pane = pane(window, eye);
    [pane.width() as u32, pane.height() as u32]
}

/// A pixel in which the picture of an eye shows a body of the front wheel whose name has `word` in it.
fn pixel_of(state: &State, eye: Eye, size: [u32; 2], word: &str) -> [f64; 2] {
    let view = state.view(eye, size);
    let hub = Track { rest: HUB, spin: None, ..state.document.scene.track(None) };
    let middle =
        state.document.settings.directions(&hub, state.document.time)[eye.index()].expect("in the domain");
    let [u, v] = view.camera.pixel(middle).expect("in front").map(f64::round);
    let around = |at: f64| (-60..60).map(move |step| at + 0.5 + f64::from(step));
    let pixels = around(v).flat_map(|v| around(u).map(move |u| [u, v]));
    let is_inside =
        |[u, v]: &[f64; 2]| (0.0..f64::from(size[0])).contains(u) && (0.0..f64::from(size[1])).contains(v);
    let shows = |pixel: &[f64; 2]| {
        let hit = state.document.prepared.first_hit(&view, view.camera.line_of_sight(*pixel));
        hit.is_some_and(|hit| {
            let name = state.document.scene.name_of(hit.body);
            name.contains(word) && name.contains("front")
        })
    };
    let all: Vec<_> = pixels.filter(is_inside).filter(shows).collect();
    assert!(!all.is_empty(), "no {word} is in sight");
    all[all.len() / 3]
}

/// A window in which the front wheel's `word` was clicked in the picture of `eye`.
fn with_clicked(state: State, eye: Eye, word: &str) -> Harness<'static, App> {
    let mut window = window(state);
    let [u, v] = pixel_of(window.state().state(), eye, size(&window, eye.index()), word);
    let place = pane(&window, eye.index()).min + vec2(u as f32, v as f32);
    click(&mut window, place, Modifiers::NONE);
    let state = window.state().state();
    let point = state.document.points.selected();
    assert!(point.what(&state.document.scene).contains(word), "{}", point.what(&state.document.scene));
    assert!(point.track.spin.is_some(), "it turns");
    window
}

/// Where the marker of `point` is, the same body is seen, at the same place of it; how many of the eyes see
/// it there.
fn in_sight(state: &State, point: &Point) -> usize {
    let size = [480, 360];
    let seen = Eye::BOTH.into_iter().filter(|&eye| {
        let view = state.view(eye, size);
        let direction = state.direction(point, eye).expect("in the domain");
        let first = state.document.prepared.first_hit(&view, direction.normalize());
        let Some(hit) = first.filter(|hit| (hit.distance / direction.length() - 1.0).abs() < 1e-6) else {
            return false;
        };
        let pixel = view.camera.pixel(direction).expect("in front");
        let (track, body) = state.point_at(eye, pixel, size).expect("it is hit");
        let off = DVec3::from(track.rest).distance(DVec3::from(point.track.rest));
        // A pixel of the picture is some hundredths; on a slope the place along the line of sight is known as
        // well as that.
        assert!(off < 1e-5, "{:?}: {off:e}", state.document.scene.name_of(hit.body));
        assert_eq!((Some(body), track.spin), (point.body, point.track.spin));
        true
    });
    seen.count()
}

fn a_clicked_point_of_a_wheel_is_followed_round_with_its_body() {
    for (beta, eye) in [(0.5, Eye::Left), (0.9, Eye::Right)] {
        for word in ["tyre", "spoke"] {
            let window = with_clicked(street(SpeedParameter::Beta, beta), eye, word);
            let mut state = window.state().state().clone();
            let point = *state.document.points.selected();
            let start = state.sighting(&point, Eye::Left).expect("in the domain").proper_time;
            let mut seen = 0;
            for geometry in [Geometry::Seen, Geometry::OneCone, Geometry::Contracted, Geometry::Rest] {
                state.run(SettingsCommand::Geometry(geometry));
                for step in -10..=10 {
                    state.run(PlaybackCommand::GoTo(3.0 + 0.4 * f64::from(step)));
                    seen += in_sight(&state, &point);
                }
            }
            assert!(seen > 30, "beta = {beta}, {word}: in sight {seen} times");
            // Meanwhile it has turned.
            state.run(SettingsCommand::Geometry(Geometry::Seen));
            let end = state.sighting(&point, Eye::Left).expect("in the domain").proper_time;
            assert!(beta / RADIUS * (end - start) > 1.0);
        }
    }
}

/// The selected point as the core has it: by its place at t' = 0 and the scene file's wheel.
fn expected(state: &State) -> (Speed, WheelPoint) {
    let speed = state.speed();
    let [x, y, z] = state.document.points.selected().track.rest;
    let (along, up) = (x - HUB[0], z - HUB[2]);
    let hub = SourcePoint::from_rest([HUB[0], y, HUB[2]], &speed);
    let (rho, angle) = (along.hypot(up) / RADIUS, up.atan2(along));
    (speed, WheelPoint { hub, radius: RADIUS, rho, angle, turning: Turning::Rolling })
}

fn what_is_told_of_a_point_of_a_wheel_is_what_the_core_has_it() {
    for beta in [0.3, 0.9, 0.99] {
        let window = with_clicked(street(SpeedParameter::Beta, beta), Eye::Left, "tyre");
        let state = window.state().state();
        let (speed, point) = expected(state);
        let both = Model::Exact
            .disparity(&speed, point, Aperture::pair(SEPARATION), state.document.time)
            .expect("in the domain");
        assert!((shown(&window, "Disparity Δφ") - both.dphi).abs() < 6e-6);
        assert!((shown(&window, "Disparity Δθ") - both.dtheta).abs() < 6e-6);
        for (name, seen) in [("Left eye", both.primary), ("Right eye", both.secondary)] {
            let number = |what: &str| shown(&window, &format!("{name}, {what}"));
            assert!((number("Doppler factor D") - seen.doppler_factor).abs() < 6e-5);
            assert!((number("proper time τ") - seen.proper_time).abs() < 6e-5);
            assert!((number("apparent Z") - seen.position[2]).abs() < 6e-5);
            let angle = point.angle - beta / RADIUS * seen.proper_time;
            let told = label_starting_with(&window, &format!("{name}, Angle on the wheel"));
            let told: f64 = told
                .rsplit(": ")
                .next()
                .and_then(|angle| angle.strip_suffix('°'))
                .expect("an angle")
                .parse()
                .expect("a number");
            let off = (told - angle.to_degrees() + 180.0).rem_euclid(360.0) - 180.0;
            assert!(off.abs() < 0.06, "beta = {beta}: {told} for {angle}");
            // On the ground: the velocities of the rim and of the hub, added.
            let v = beta * point.rho;
            let (vx, vz) = (v * angle.sin(), -v * angle.cos());
            let added = 1.0 + beta * vx;
            let on_ground = ((beta + vx) / added).hypot(vz / (speed.gamma() * added));
            assert!((number("Speed on the ground") - on_ground).abs() < 6e-5);
        }
    }
}

fn curves_of_a_point_of_a_wheel_are_those_of_the_core() {
    for (beta, word) in [(0.9, "tyre"), (0.6, "spoke")] {
        let mut window = with_clicked(street(SpeedParameter::Beta, beta), Eye::Left, word);
        let (speed, point) = expected(window.state().state());
        let pair = Aperture::pair(SEPARATION);
        let both = |time| Model::Exact.disparity(&speed, point, pair, time).expect("in the domain");
        let name = window.state().state().name_of(window.state().state().document.points.selected());
        for tab in [PlotTab::Disparity, PlotTab::Angles, PlotTab::Doppler, PlotTab::Stereo] {
            let plots = PlotSettings { plot: tab, ..window.state().state().document.settings.plots };
            window.state_mut().run(SettingsCommand::Plots(plots));
            window.run();
            let csv = window.state_mut().plots_csv();
            let mut lines = csv.lines();
            let head: Vec<&str> = lines.next().expect("a header").split(',').collect();
            // Where lines of sight do not meet there is no number.
            let number =
                |cell: &str| if cell.is_empty() { f64::NAN } else { cell.parse().expect("a number") };
            let rows: Vec<Vec<f64>> = lines.map(|line| line.split(',').map(number).collect()).collect();
            let is_whole = |row: &Vec<f64>| row.iter().all(|value| value.is_finite());
            assert!(rows.len() > 200 && (tab == PlotTab::Stereo || rows.iter().all(is_whole)), "{tab:?}");
            let mut compared = 0;
            for (index, column) in head.iter().enumerate() {
                let value = |time: f64| {
                    let seen = both(time);
                    let (l, r) = (seen.primary, seen.secondary);
                    Some(match *column {
                        column if column.starts_with("Δφ") && column.ends_with(&name) => seen.dphi,
                        column if column.starts_with("Δθ") && column.ends_with(&name) => seen.dtheta,
                        column if column.starts_with('φ') && column.ends_with("Left eye") => l.phi(),
                        column if column.starts_with('θ') && column.ends_with("Right eye") => r.theta(),
                        column if column.starts_with("D: ") && column.ends_with("Right eye") => {
                            r.doppler_factor
                        }
                        column if column.ends_with("Where the left eye sees it") => l.distance,
                        _ => return None,
                    })
                };
                for row in rows.iter().step_by(37) {
                    let Some(expected) = value(row[0]) else { continue };
                    compared += 1;
                    let off = (row[index] - expected).abs();
                    assert!(
                        off < 1e-9 * (1.0 + expected.abs()),
                        "{column} at {}: {} for {expected}",
                        row[0],
                        row[index]
                    );
                }
            }
            assert!(compared > 5, "{tab:?}: {head:?}");
        }
    }
}

fn a_point_of_a_wheel_is_undone_redone_and_kept_in_a_state() {
    let mut window = with_clicked(street(SpeedParameter::Beta, 0.9), Eye::Left, "spoke");
    let picked = window.state().state().clone();
    let press = |window: &mut Harness<'_, App>, modifiers| {
        window.key_press_modifiers(modifiers, Key::Z);
        window.run_ok();
    };
    press(&mut window, Modifiers::COMMAND);
    assert_eq!(window.state().state().document.points.selected().number, 1);
    press(&mut window, Modifiers { shift: true, ..Modifiers::COMMAND });
    assert_eq!(window.state().state().document.points, picked.document.points);
    // As a file, and as the flags of a command.
    let toml = window.state().state().shown().to_toml();
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("state.toml");
    std::fs::write(&path, toml).expect("it is writable");
    let read = Settings::default().with_file(&path).expect("a state");
    let again = State::open(read).expect("a preset");
    assert_eq!(again.document.points.selected().track, picked.document.points.selected().track);
    assert_eq!(again.document.points.selected().body, picked.document.points.selected().body);
    assert_eq!(
        again.disparity(again.document.points.selected()),
        picked.disparity(picked.document.points.selected())
    );
    // A pin has its curves while the speed changes; the wheel then turns at another.
    window.key_press(Key::K);
    window.run_ok();
    let pinned = window.state().state().scratch.plotting.pins[0].seen.clone();
    assert_eq!(pinned.point.spin, picked.document.points.selected().track.spin);
}

fn a_point_of_a_wheel_has_numbers_at_every_speed() {
    for (parameter, speed) in [
        (SpeedParameter::Beta, 0.0),
        (SpeedParameter::Beta, 1e-6),
        (SpeedParameter::Beta, 0.9999),
        (SpeedParameter::Gamma, 1e6),
    ] {
        let mut state = street(parameter, speed);
        let tyre = state.document.scene.names.iter().position(|name| name == "front tyre").expect("a tyre");
        let track = state.document.scene.track_on(tyre).expect("a body");
        state.document.points.choose(track, tyre, false);
        let mut window = window_without_pictures(state, [1120.0, 700.0]);
        let [from, to] = window.state().state().time_range();
        for tab in [PlotTab::Disparity, PlotTab::Angles, PlotTab::Doppler, PlotTab::Stereo] {
            let plots =
                PlotSettings { plot: tab, published: true, ..window.state().state().document.settings.plots };
            window.state_mut().run(SettingsCommand::Plots(plots));
            for part in [0.0, 0.31, 1.0] {
                window.state_mut().run(PlaybackCommand::GoTo(from + part * (to - from)));
                window.run_ok();
                let said = labels(&window);
                let is_broken = |label: &&String| label.contains("NaN") || label.contains("inf ");
                assert_eq!(said.iter().find(is_broken), None, "{parameter:?} {speed}, {tab:?}, {part}");
            }
            let csv = window.state_mut().plots_csv();
            assert!(!csv.contains("NaN") && !csv.contains("inf"), "{parameter:?} {speed}, {tab:?}");
        }
    }
}

fn the_fit_of_a_point_of_a_wheel_finds_its_hub() {
    for (beta, noise_percent) in [(0.9, 0.0), (0.6, 1.0)] {
        let mut state = street(SpeedParameter::Beta, beta);
        let spoke = state
            .document
            .scene
            .names
            .iter()
            .position(|name| name == "front wheel's spoke 3")
            .expect("a spoke");
        let track = state.document.scene.track_on(spoke).expect("a body");
        state.document.points.choose(track, spoke, false);
        state.run(SettingsCommand::Fit(FitSettings { noise_percent, ..FitSettings::default() }));
        state.run(SettingsCommand::Plots(PlotSettings { plot: PlotTab::Fit, ..PlotSettings::default() }));
        let mut window = window(state);
        settle(&mut window);
        // The spoke's end is in the plane of the rim or beside it; the hub it is told of is the axle there.
        for (symbol, truth) in [("β", beta), ("y", track.rest[1]), ("z", HUB[2])] {
            let value = shown(&window, &format!("Fitted {symbol}"));
            let known = 3.5 * shown(&window, &format!("Uncertainty of {symbol}")) + 6e-4;
            assert!((value - truth).abs() < known, "{symbol} = {value} for {truth}");
            assert!((shown(&window, &format!("True {symbol}")) - truth).abs() < 6e-5);
        }
        let said = labels(&window);
        let is_told = said.iter().any(|label| label.starts_with("The point is on a wheel that rolls"));
        assert!(
            is_told
                && said
                    .iter()
                    .any(|label| label.starts_with("Agrees with the truth")
                        || label.starts_with("Recovered to")),
            "{said:?}"
        );
    }
}

fn the_pointer_tells_where_on_the_wheel_it_is() {
    for (geometry, first) in [
        (Geometry::Seen, "seen at"),
        (Geometry::Contracted, "measured now at"),
        (Geometry::Rest, "seen from its frame at"),
    ] {
        let mut state = street(SpeedParameter::Beta, 0.6);
        state.run(SettingsCommand::Geometry(geometry));
        state.run(PlaybackCommand::GoTo(if geometry == Geometry::Seen { 4.5 } else { 0.0 }));
        let size = [480, 360];
        let pixel = pixel_of(&state, Eye::Left, size, "tyre");
        let under = state.hovered(Eye::Left, pixel, size).expect("something is there");
        assert!(under.lines[0].starts_with(first), "{:?}", under.lines);
        let on_wheel: Vec<_> = under.lines.iter().rev().take(2).collect();
        assert!(
            on_wheel[1].starts_with("on the wheel 0.9") || on_wheel[1].starts_with("on the wheel 1.00"),
            "{on_wheel:?}"
        );
        assert!(
            on_wheel[0].starts_with("turning at 0.5") || on_wheel[0].starts_with("turning at 0.60"),
            "{on_wheel:?}"
        );
        assert_eq!(on_wheel[0].contains("on the ground"), geometry != Geometry::Rest);
        // The angle is that of the place that is shown, from the hub, which passes as the geometry has it.
        let (track, _) = state.point_at(Eye::Left, pixel, size).expect("something is there");
        let view = state.view(Eye::Left, size);
        let wheel = state.on_wheel_in(&track, &view).expect("it turns");
        let hub = state.document.settings.directions(
            &Track { rest: [HUB[0], track.rest[1], HUB[2]], spin: None, ..track },
            state.document.time,
        )[0];
        let there = state.document.settings.directions(&track, state.document.time)[0];
        let above = there.expect("in the domain").z - hub.expect("in the domain").z;
        assert!((above - wheel.share * RADIUS * wheel.angle.sin()).abs() < 1e-9, "{geometry:?}: {above}");
        assert!(wheel.angle >= 0.0 && wheel.angle < 4.0 * FRAC_PI_2);
    }
}
