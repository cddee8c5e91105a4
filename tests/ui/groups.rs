//! Groups in the window: points that rest beside the road, and points that come the other way.

use eframe::egui::{Modifiers, Pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{PlaybackCommand, PointsCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::pointer::Pick;
use gamow::eye::Eye;
use gamow::flags::FieldOfView;
use gamow::flags::choices::GazeChoice;
use gamow::scene::Scene;
use gamow::settings::{PlotSettings, PlotTab, Settings};
use relativity_render::{Colour, Shading};

use super::Test;
use super::picking::click;
use super::support::{drag, label_starting_with, labels, pane, shown, slider, window};

pub const TESTS: &[Test] = trials![
    a_point_that_rests_keeps_its_colour_place_and_disparity,
    a_point_that_rests_or_comes_is_not_fitted_and_why_is_said,
    markers_lie_where_the_reference_shows_their_points,
    the_colour_that_is_read_out_is_that_of_the_picture,
];

/// A ball that passes at the scene's speed, one that rests beside the road, and one that comes the other way.
const SCENE: &str = include_str!("../groups.toml");
/// When all three are in sight.
const TIME: f64 = 3.5;
const RESTING: usize = 1;
const ONCOMING: usize = 2;

/// The scene, seen by eyes that look straight ahead.
fn groups() -> State {
    let mut settings = Settings { time: Some(TIME), ..Settings::default() };
    settings.look.gaze = GazeChoice::Fixed([90.0, 5.0]);
    settings.look.fov = FieldOfView(Some(80.0));
    State::new(settings, Scene::parse(SCENE, "groups.toml").expect("it is right"))
}

/// The centres of the pixels in which the reference shows `body` to `eye`.
fn pixels(state: &State, eye: Eye, size: [u32; 2], body: usize) -> Vec<[f64; 2]> {
    let image = state.document.prepared.hit_image(&state.view(eye, size));
    let shows = |pixel: &usize| image.hits[*pixel].is_some_and(|hit| hit.body == body);
    let width = size[0] as usize;
    let centre = |pixel: usize| [(pixel % width) as f64 + 0.5, (pixel / width) as f64 + 0.5];
    (0..image.hits.len()).filter(shows).map(centre).collect()
}

/// A place in the left eye's pane that shows `body`.
fn place(window: &Harness<'_, App>, body: usize) -> Pos2 {
    let pane = pane(window, 0);
    let pixels = pixels(window.state().state(), Eye::Left, [pane.width() as u32, pane.height() as u32], body);
    let [u, v] = pixels[pixels.len() / 2];
    pane.min + vec2(u as f32, v as f32)
}

/// Where the marker of the selected point is in the left eye's pane.
fn marker(window: &Harness<'_, App>) -> Pos2 {
    let (state, pane) = (window.state().state(), pane(window, 0));
    let camera = state.view(Eye::Left, [pane.width() as u32, pane.height() as u32]).camera;
    let direction = state.direction(state.document.points.selected(), Eye::Left).expect("in the domain");
    let [u, v] = camera.pixel(direction).expect("in front");
    pane.min + vec2(u as f32, v as f32)
}

fn a_point_that_rests_keeps_its_colour_place_and_disparity() {
    let mut window = window(groups());
    let clicked = place(&window, RESTING);
    click(&mut window, clicked, Modifiers::NONE);
    assert_eq!(window.state().state().document.points.selected().body, Some(RESTING));
    let numbers = |window: &Harness<'_, App>| {
        let names =
            ["Left eye, Doppler factor D", "Left eye, Received wavelength", "Disparity Δφ", "Disparity Δθ"];
        names.map(|name| shown(window, name))
    };
    let before = numbers(&window);
    assert_eq!(before[..2], [1.0, 550.0]);
    assert!(before[2] < 0.0);
    window.state_mut().run(PlaybackCommand::GoTo(TIME + 4.0));
    window.run_steps(2);
    assert_eq!(numbers(&window), before);
    let slider = slider(&window, "Speed β");
    drag(&mut window, slider.center(), slider.left_center() + vec2(30.0, 0.0));
    assert!(window.state().state().speed().beta() < 0.3);
    assert_eq!(numbers(&window), before);
    assert!(marker(&window).distance(clicked) < 0.6, "{:?} for {clicked:?}", marker(&window));
}

fn a_point_that_rests_or_comes_is_not_fitted_and_why_is_said() {
    for (body, words) in [
        (RESTING, "At rest (β = 0) no disparity changes with T."),
        (ONCOMING, "The fit needs a point that moves towards +x, and this one moves the other way."),
    ] {
        let mut window = window(groups());
        let clicked = place(&window, body);
        click(&mut window, clicked, Modifiers::NONE);
        window
            .state_mut()
            .run(SettingsCommand::Plots(PlotSettings { plot: PlotTab::Fit, ..PlotSettings::default() }));
        while !window.state().fitting().is_up_to_date() {
            window.step();
        }
        window.step();
        assert!(labels(&window).iter().any(|label| label == words), "{words}");
        assert!(window.query_by_label("No fit").is_some());
    }
}

fn markers_lie_where_the_reference_shows_their_points() {
    let size = [240, 180];
    for body in [RESTING, ONCOMING] {
        for time in [TIME, TIME + 1.0] {
            let mut state = groups();
            state.run(PlaybackCommand::GoTo(time));
            for eye in Eye::BOTH {
                let pixels = pixels(&state, eye, size, body);
                assert!(pixels.len() > 50, "body {body}, T = {time}: {} pixels", pixels.len());
                // A picture is shifted by what is selected.
                let camera = state.view(eye, size).camera;
                for &pixel in pixels.iter().step_by(pixels.len() / 40) {
                    let mut state = state.clone();
                    state.run(PointsCommand::Pick(Pick { eye, is_second: false, pixel, size, add: false }));
                    let point = state.document.points.selected();
                    let direction = state.direction(point, eye).expect("in the domain");
                    let [u, v] = camera.pixel(direction).expect("in front");
                    let off = (u - pixel[0]).hypot(v - pixel[1]);
                    assert!(point.body == Some(body) && off < 1e-6, "body {body}, T = {time}: {off} px off");
                }
            }
        }
    }
}

fn the_colour_that_is_read_out_is_that_of_the_picture() {
    for colour in [Colour::White, Colour::Glowing, Colour::StreetDaylight] {
        let mut state = groups();
        let mut settings = Settings::clone(&state.document.settings);
        (settings.light.colour, settings.light.shading) = (colour, Shading::Emission);
        state.set(settings).expect("a scene that is there");
        let mut window = window(state);
        let clicked = place(&window, ONCOMING);
        click(&mut window, clicked, Modifiers::NONE);
        let (state, pane) = (window.state().state(), pane(&window, 0));
        let size = [pane.width() as u32, pane.height() as u32];
        let is_light = !window.ctx.global_style().visuals.dark_mode;
        let (view, appearance) = (state.view(Eye::Left, size), state.appearance(is_light));
        let picture = state.document.prepared.picture(&view, &appearance, 1);
        let [u, v] = (clicked - pane.min).into();
        let [r, g, b, _] = picture.rgba[v as usize * size[0] as usize + u as usize];
        let read = label_starting_with(&window, "Left eye, Colour: ");
        assert_eq!(read, format!("Left eye, Colour: #{r:02X}{g:02X}{b:02X}"), "{colour:?}");
        assert!(window.query_by_label_contains("Received wavelength").is_none());
    }
}
