//! Clicking points of the cyclist, their markers, and looking around.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, PointerButton, Pos2, Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use gamow::app::commands::{PlaybackCommand, PointsCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::app::state::pointer::Pick;
use gamow::eye::Eye;
use gamow::flags::choices::{GazeChoice, ZeroParallax};
use gamow::flags::{SpeedParameter, SpeedSetting};
use gamow::settings::LookSettings;
use glam::DVec3;
use relativity_core::math::atan2;
use relativity_core::{Aperture, SourcePoint, sighting};
use relativity_render::{Gaze, Geometry, Gpu, Method, Renderers};

use super::Test;
use super::support::{
    FRAME, SEPARATION, cyclist, drag, label_starting_with, pane, shown, wide_window, window,
};

pub const TESTS: &[Test] = trials![
    clicking_the_wheel_at_beta_0_9_plots_that_point,
    clicking_the_wheel_at_beta_0_1_plots_that_point,
    a_pointer_that_was_forgotten_tells_nothing,
    shift_clicking_compares_points,
    double_clicking_follows_again_and_picks_nothing,
    a_click_beside_everything_changes_nothing,
    marker_and_drawn_surface_agree_within_half_a_pixel,
    the_published_right_eye_shows_its_own_picture_and_marker,
    dragging_looks_around_and_frame_comes_back,
    scrolling_zooms_at_the_pointer,
    a_pick_leaves_the_whole_scene_where_it_is,
    the_gazes_are_chosen_by_name,
    the_followed_point_stays_in_the_middle,
];

/// On the side of the front tyre that faces the eyes, at its top: the wheel stands around (-0.525, 3, 2)
/// with a radius of 0.493 and a tyre of 0.032.
pub const ON_THE_TYRE: [f64; 3] = [-0.525, 3.0 - 0.032, 2.0 + 0.493];
/// The front tyre is the first body of the scene file.
pub const FRONT_TYRE: usize = 0;

/// Where an eye sees a point at rest coordinates `rest`, in its pane.
fn place(window: &Harness<'_, App>, rest: [f64; 3], eye: usize) -> Pos2 {
    let state = window.state().state();
    let speed = state.speed();
    let point = SourcePoint::from_rest(rest, &speed);
    let aperture = Aperture::pair(SEPARATION)[eye];
    let seen = sighting(&speed, point, aperture, state.document.time).expect("in the domain");
    let pane = pane(window, eye);
    let camera = state.view(Eye::BOTH[eye], [pane.width() as u32, pane.height() as u32]).camera;
    let [u, v] = camera.pixel(DVec3::from(seen.position)).expect("in front");
    pane.min + vec2(u as f32, v as f32)
}

/// The hover label has one line after a move, until three seconds at rest or a key press. After a click it
/// has all, until a key press.
fn a_pointer_that_was_forgotten_tells_nothing() {
    let mut window = window(cyclist(0.9));
    let tyre = place(&window, ON_THE_TYRE, 0);
    let tag = |window: &Harness<'_, App>| {
        let nodes = window.root().children_recursive();
        let mut told = nodes.filter(|node| {
            let node = node.accesskit_node();
            let told = node.label().or_else(|| node.value());
            told.is_some_and(|told| told.starts_with("Under the pointer: "))
        });
        told.next().map(|node| node.rect().height())
    };
    assert_eq!(tag(&window), None);
    window.hover_at(tyre);
    window.run_steps(2);
    let line = tag(&window).expect("it moved");
    assert!(line < 30.0, "a line, not {line} points");
    window.run_steps((2.5 / FRAME) as usize);
    assert_eq!(tag(&window), Some(line));
    window.run_steps((0.7 / FRAME) as usize);
    assert_eq!(tag(&window), None, "it was forgotten");
    window.hover_at(tyre + vec2(0.0, 0.5));
    window.run_steps(2);
    assert_eq!(tag(&window), Some(line));
    window.key_press(Key::ArrowRight);
    window.run_steps(2);
    assert_eq!(tag(&window), None, "a key is pressed and the picture changes");
    let tyre = place(&window, ON_THE_TYRE, 0);
    click(&mut window, tyre, Modifiers::NONE);
    window.run_steps(2);
    let all = tag(&window).expect("it was clicked");
    assert!(all > 2.0 * line, "{all} is not the rest too");
    window.run_steps((4.0 / FRAME) as usize);
    assert_eq!(tag(&window), Some(all), "it is read");
    window.key_press(Key::ArrowLeft);
    window.run_steps(2);
    assert_eq!(tag(&window), None);
}

/// Presses the button at `place` and lets it go.
pub fn click(window: &mut Harness<'_, App>, place: Pos2, modifiers: Modifiers) {
    window.hover_at(place);
    window.step();
    for pressed in [true, false] {
        window.event_modifiers(
            eframe::egui::Event::PointerButton {
                pos: place,
                button: PointerButton::Primary,
                pressed,
                modifiers,
            },
            modifiers,
        );
    }
    window.run_ok();
}

fn clicking_the_wheel_at_beta_0_9_plots_that_point() {
    clicking_the_wheel(0.9);
}

fn clicking_the_wheel_at_beta_0_1_plots_that_point() {
    clicking_the_wheel(0.1);
}

fn clicking_the_wheel(beta: f64) {
    for eye in [0, 1] {
        let mut window = window(cyclist(beta));
        let place = place(&window, ON_THE_TYRE, eye);
        assert!(pane(&window, eye).contains(place));
        click(&mut window, place, Modifiers::NONE);
        let point = *window.state().state().document.points.selected();
        assert_eq!(point.body, Some(FRONT_TYRE));
        let off = DVec3::from(point.track.rest).distance(DVec3::from(ON_THE_TYRE));
        assert!(off < 1e-3, "{off} from where it was clicked");
        label_starting_with(&window, "Plot of Δφ of front tyre (2) against T");
        label_starting_with(&window, "Plot of Δθ of front tyre (2) against T");
        // The scene's own point is one of the list all the same, and another click moves the one that was
        // picked.
        window.get_by_label("front tyre (1)");
        click(&mut window, place + vec2(3.0, 0.0), Modifiers::NONE);
        let points = &window.state().state().document.points;
        assert_eq!((points.all().len(), points.selected().number), (2, 2));
        assert_ne!(points.selected().track, point.track);
    }
}

fn double_clicking_follows_again_and_picks_nothing() {
    let mut window = window(cyclist(0.9));
    let before = window.state().state().document.points.clone();
    let middle = pane(&window, 0).center();
    drag(&mut window, middle, middle + vec2(60.0, 30.0));
    let tyre = place(&window, ON_THE_TYRE, 0);
    window.hover_at(tyre);
    window.run_ok();
    for pressed in [true, false, true, false] {
        window.event(eframe::egui::Event::PointerButton {
            pos: tyre,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        });
        window.step();
    }
    window.run_ok();
    let state = window.state().state();
    assert_eq!((&state.document.points, state.document.settings.look), (&before, LookSettings::default()));
    // A click of its own picks, however soon another point is double-clicked.
    window.run_steps(16);
    let tyre = place(&window, ON_THE_TYRE, 0);
    click(&mut window, tyre, Modifiers::NONE);
    assert_eq!(window.state().state().document.points.selected().body, Some(FRONT_TYRE));
}

fn shift_clicking_compares_points() {
    let mut window = window(cyclist(0.9));
    let tyre = place(&window, ON_THE_TYRE, 0);
    click(&mut window, tyre, Modifiers::SHIFT);
    let points = window.state().state().document.points.clone();
    assert_eq!(points.all().len(), 2);
    assert_eq!((points.selected().number, points.selected().body), (2, Some(FRONT_TYRE)));
    window.get_by_label("front tyre (1)").click();
    window.run();
    assert_eq!(window.state().state().document.points.selected().number, 1);
    assert!(window.query_by_label("Remove front tyre (1)").is_none());
    window.get_by_label("Remove front tyre (2)").click();
    window.run();
    assert_eq!(window.state().state().document.points.all().len(), 1);
    label_starting_with(&window, "Plot of Δφ of front tyre");
}

fn a_click_beside_everything_changes_nothing() {
    let mut window = window(cyclist(0.9));
    let before = window.state().state().document.points.clone();
    let corner = pane(&window, 0).right_top() + vec2(-5.0, 5.0);
    click(&mut window, corner, Modifiers::NONE);
    assert_eq!(window.state().state().document.points, before);
}

/// Every pixel the GPU draws of the scene: the marker of the point it shows lies on that pixel's centre,
/// and so does that of a point picked there.
fn marker_and_drawn_surface_agree_within_half_a_pixel() {
    let mut renderers = Renderers::new(Some(Gpu::headless().expect("an adapter")));
    let size = [320, 240];
    for gamma in [1.0, 1.005, 2.3, 10.0, 1000.0] {
        for geometry in [Geometry::Seen, Geometry::OneCone, Geometry::Contracted, Geometry::Rest] {
            let mut state = cyclist(0.0);
            let mut motion = state.document.settings.motion;
            motion.speed = SpeedSetting::new(SpeedParameter::Gamma, gamma).expect("a speed");
            if geometry == Geometry::Rest {
                // At rest the eyes are gamma d apart; like this the scene stays between them.
                motion.d /= gamma;
            }
            state.run(SettingsCommand::Motion(motion));
            state.run(SettingsCommand::Geometry(geometry));
            // Where each geometry has the scene in front of the eyes.
            let is_seen = matches!(geometry, Geometry::Seen | Geometry::OneCone);
            state.run(PlaybackCommand::GoTo(if is_seen { 0.4 } else { 0.0 }));
            let mut worst = 0.0f64;
            let mut checked = 0;
            for eye in Eye::BOTH {
                let view = state.view(eye, size);
                let image =
                    renderers.hits(Method::Rays, &state.document.prepared, &view).expect("the device works");
                let hits: Vec<_> = image.hits.iter().enumerate().filter(|(_, hit)| hit.is_some()).collect();
                for (index, hit) in hits.iter().step_by((hits.len() / 40).max(1)) {
                    let Some(hit) = hit else { continue };
                    let centre =
                        [(index % size[0] as usize) as f64 + 0.5, (index / size[0] as usize) as f64 + 0.5];
                    if state.point_at(eye, centre, size).is_none_or(|(_, body)| body != hit.body) {
                        continue; // An edge runs through this pixel.
                    }
                    let mut picked = state.clone();
                    picked.run(PointsCommand::Pick(Pick {
                        eye,
                        is_second: false,
                        pixel: centre,
                        size,
                        add: false,
                    }));
                    let mut drawn = *picked.document.points.selected();
                    for rest in [drawn.track.rest, hit.rest_position.to_array()] {
                        drawn.track.rest = rest;
                        let direction = state.direction(&drawn, eye).expect("in the domain");
                        let [u, v] = view.camera.pixel(direction).expect("in front");
                        worst = worst.max((u - centre[0]).hypot(v - centre[1]));
                        checked += 1;
                    }
                }
            }
            assert!(checked > 10, "gamma = {gamma}, {geometry:?}: only {checked} pixels");
            assert!(worst < 0.5, "gamma = {gamma}, {geometry:?}: {worst} pixels apart");
        }
    }
}

/// In the published model the right eye's marker is where the left eye saw the point at T - Delta T.
fn the_published_right_eye_shows_its_own_picture_and_marker() {
    let mut window = window(cyclist(0.9));
    let exact = window.render().expect("a picture");
    window.get_by_role_and_label(Role::Button, "Published").click();
    window.remove_cursor();
    window.run();
    let published = window.render().expect("a picture");
    let differing = |pane: Rect| {
        let columns = pane.min.x as u32 + 4..pane.max.x as u32 - 4;
        let rows = pane.min.y as u32 + 4..pane.max.y as u32 - 40;
        rows.flat_map(|y| columns.clone().map(move |x| (x, y)))
            .filter(|&(x, y)| exact.get_pixel(x, y) != published.get_pixel(x, y))
            .count()
    };
    assert!(differing(pane(&window, 1)) > 500);

    let state = window.state().state();
    let point = state.document.points.selected();
    let model = relativity_core::published_disparity(
        &state.speed(),
        state.selected_source().place(),
        SEPARATION,
        state.document.time,
        relativity_core::PublishedVariant::AppendixA,
    );
    let published = model.expect("in the domain");
    let [x, y, z] = published.secondary.position;
    // The numbers are those of the view, and the table says which model's.
    window.get_by_label("Right, published");
    for (name, value, rounding) in [
        ("Right eye, Received wavelength", 700.0 / published.secondary.doppler_factor, 0.06),
        ("Left eye, Received wavelength", 700.0 / published.primary.doppler_factor, 0.06),
        ("Disparity Δφ", published.dphi, 6e-6),
        ("Right eye, azimuth φ", published.secondary.phi(), 6e-6),
    ] {
        let told = shown(&window, name);
        assert!((told - value).abs() < rounding, "{name}: {told} for {value}");
    }
    let direction = state.direction(point, Eye::Right).expect("in the domain");
    assert!(direction.distance(DVec3::new(x, y, z)) < 1e-12, "{direction} for {x}, {y}, {z}");

    let right = pane(&window, 1).center();
    click(&mut window, right, Modifiers::NONE);
    assert_eq!(window.state().state().document.points.selected().body, None);
    window.get_by_label("With the right eye as published, click in the left eye's view.");
}

fn dragging_looks_around_and_frame_comes_back() {
    let mut window = wide_window(cyclist(0.9));
    let before = window.state().state().gaze();
    let middle = pane(&window, 0).center();
    let looked_at = place_of_gaze(&window, before, pane(&window, 0));
    drag(&mut window, middle, middle + vec2(60.0, 30.0));
    let GazeChoice::Fixed(degrees) = window.state().state().document.settings.look.gaze else {
        panic!("a drag fixes the gaze");
    };
    let [azimuth, elevation] = degrees.map(f64::to_radians);
    // The scene follows the pointer: right and down, so the gaze turns left and up, about the line between
    // the eyes.
    let rise = |gaze: Gaze| atan2(gaze.axes().forward.z, gaze.axes().forward.y);
    assert!(azimuth > before.azimuth && rise(Gaze { azimuth, elevation }) > rise(before));
    let place = place_of_gaze(&window, before, pane(&window, 0));
    assert!((place - (looked_at + vec2(60.0, 30.0))).length() < 6.0, "{place:?} from {looked_at:?}");
    window.key_press(Key::F);
    window.run();
    assert_eq!(window.state().state().document.settings.look, LookSettings::default());
    drag(&mut window, middle, middle + vec2(60.0, 30.0));
    window.get_by_label("Left eye view").click();
    window.get_by_label("Left eye view").click();
    window.run_ok();
    assert_eq!(window.state().state().document.settings.look, LookSettings::default());
    drag(&mut window, middle, middle + vec2(60.0, 30.0));
    window.get_by_label("Frame").click();
    window.run();
    assert_eq!(window.state().state().document.settings.look, LookSettings::default());
}

/// Where the direction of `gaze` now is in `pane`.
fn place_of_gaze(window: &Harness<'_, App>, gaze: Gaze, pane: Rect) -> Pos2 {
    let state = window.state().state();
    let size = [pane.width() as u32, pane.height() as u32];
    let camera = state.view(Eye::Left, size).camera;
    let [u, v] = camera.pixel(gaze.axes().forward).expect("in front");
    pane.min + vec2(u as f32, v as f32)
}

/// What the right eye sees in its pane a quarter from the left and a third from the top.
fn seen_aside(window: &Harness<'_, App>) -> DVec3 {
    let pane = pane(window, 1);
    let size = [pane.width() as u32, pane.height() as u32];
    let camera = window.state().state().view(Eye::Right, size).camera;
    camera.line_of_sight([0.25 * f64::from(size[0]), f64::from(size[1]) / 3.0])
}

fn scrolling_zooms_at_the_pointer() {
    let mut window = window(cyclist(0.9));
    let fov = |window: &Harness<'_, App>| window.state().state().look().set_fov().expect("a number");
    let (before, aside) = (fov(&window), seen_aside(&window));
    let right = pane(&window, 1);
    window.hover_at(right.min + right.size() * vec2(0.25, 1.0 / 3.0));
    window.step();
    window.event(eframe::egui::Event::MouseWheel {
        source: eframe::egui::MouseWheelSource::Wheel,
        unit: eframe::egui::MouseWheelUnit::Point,
        delta: vec2(0.0, 80.0),
        phase: eframe::egui::TouchPhase::Move,
        modifiers: Modifiers::NONE,
    });
    window.run_ok();
    let after = fov(&window);
    assert!(after < 0.95 * before, "{before} to {after}");
    let moved = seen_aside(&window).angle_between(aside);
    assert!(moved < 0.003 * after.to_radians(), "what was under the pointer moved by {moved}");
    assert!(matches!(window.state().state().document.settings.look.gaze, GazeChoice::Fixed(_)));
}

fn a_pick_leaves_the_whole_scene_where_it_is() {
    let mut state = cyclist(0.9);
    // Else what is picked is shifted onto the screen.
    state.document.settings.look.zero_parallax = ZeroParallax::Infinity;
    let mut window = window(state);
    let before = window.state().state().look();
    let tyre = place(&window, ON_THE_TYRE, 0);
    click(&mut window, tyre, Modifiers::NONE);
    assert_eq!(window.state().state().document.points.selected().body, Some(FRONT_TYRE));
    assert_eq!(window.state().state().look(), before);
}

fn the_gazes_are_chosen_by_name() {
    let mut window = window(cyclist(0.9));
    let fitted = window.state().state().look().fov;
    for (name, gaze, fov) in [
        ("Point", GazeChoice::Point, 60.0),
        ("Ahead", GazeChoice::Ahead, 110.0),
        ("Whole", GazeChoice::Whole, fitted.0.expect("a number")),
    ] {
        window.get_by_label(name).click();
        window.run();
        let state = window.state().state();
        assert_eq!((state.document.settings.look.gaze, state.look().fov.0), (gaze, Some(fov)), "{name}");
    }
    let shown = window.state().state().look();
    window.get_by_label("Fixed").click();
    window.run();
    let expected = LookSettings { zero_parallax: ZeroParallax::Point, ..shown };
    assert_eq!(window.state().state().document.settings.look, expected);
}

fn the_followed_point_stays_in_the_middle() {
    let mut state = cyclist(0.9);
    state.document.settings.look.gaze = GazeChoice::Point;
    let mut window = window(state);
    for _ in 0..6 {
        window.key_press_modifiers(Modifiers::SHIFT, eframe::egui::Key::ArrowRight);
        window.run();
        let places =
            [0, 1].map(|eye| place(&window, super::support::TRACKED, eye) - pane(&window, eye).center());
        // The eyes look in parallel, so the point is as far left of the middle in one as right in the other.
        let mean = 0.5 * (places[0] + places[1]);
        assert!(mean.length() < 0.5, "{places:?}");
    }
}
