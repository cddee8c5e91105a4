//! Two pictures of one eye beside each other: the second is what its geometry shows by itself, and so is what
//! is clicked and told in it; nothing claims that both make a pair.

use eframe::egui::{Key, Modifiers, Pos2, Rect, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{PlaybackCommand, SettingsCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::eye::Eye;
use gamow::flags::FieldOfView;
use gamow::flags::choices::{Compare, Layout};
use gamow::settings::LookSettings;
use glam::DVec3;
use relativity_render::Geometry;

use super::Test;
use super::picking::{FRONT_TYRE, ON_THE_TYRE, click};
use super::support::{
    SEPARATION, cyclist, in_layout, label_starting_with, labels, open, rest, shown, window, window_of_size,
};

pub const TESTS: &[Test] = trials![
    the_second_picture_is_that_of_its_geometry_by_itself,
    a_click_into_the_second_picture_selects_what_it_shows_there,
    dragging_the_second_picture_moves_it_with_the_pointer,
    two_pictures_of_one_eye_are_named_and_are_no_pair,
    what_cannot_be_compared_shows_two_eyes_and_says_why,
    a_comparison_is_chosen_by_key_saved_and_opened,
    a_clock_beside_you_has_a_checkbox,
];

const SECOND: &str = "Left eye view: contracted only";

/// The cyclist in pictures of one field of view.
fn compared(compare: Compare) -> State {
    let mut state = cyclist(0.9);
    let look = LookSettings { compare, fov: FieldOfView(Some(80.0)), ..state.document.settings.look };
    state.run(SettingsCommand::Look(look));
    state.run(PlaybackCommand::GoTo(-1.0));
    state
}

/// Pixels in `rect` of a window of one pixel per point, without its edge.
fn pixels(window: &mut Harness<'_, App>, rect: Rect) -> Vec<[u8; 4]> {
    window.remove_cursor();
    window.run();
    let picture = window.render().expect("a picture");
    let (min, max) = (rect.min.round() + vec2(3.0, 3.0), rect.max.round() - vec2(3.0, 3.0));
    let row = |y: u32| (min.x as u32..max.x as u32).map(move |x| [x, y]);
    (min.y as u32..max.y as u32).flat_map(row).map(|[x, y]| picture.get_pixel(x, y).0).collect()
}

fn the_second_picture_is_that_of_its_geometry_by_itself() {
    for (geometry, compare, name) in [
        (Geometry::Contracted, Compare::Contracted, SECOND),
        (Geometry::Rest, Compare::Rest, "Left eye view: at rest"),
    ] {
        let mut both = window(compared(compare));
        let [first, second] = ["Left eye view: as seen", name].map(|name| both.get_by_label(name).rect());
        assert!(first.max.x < second.min.x && (first.width() - second.width()).abs() < 1.5);
        let mut alone = compared(Compare::Off);
        alone.document.settings.look.geometry = geometry;
        let mut alone = window(alone);
        rest(&mut alone);
        rest(&mut both);
        let place = alone.get_by_label("Left eye view").rect();
        assert!((place.size() - second.size()).abs().max_elem() < 0.5, "{place:?} {second:?}");
        let [seen, in_it, by_itself] =
            [pixels(&mut both, first), pixels(&mut both, second), pixels(&mut alone, place)];
        // Edges of what is painted are rounded as their place on the screen has it, by a level: beside
        // the marker's nothing else differs.
        let differ = |(a, b): (&[u8; 4], &[u8; 4])| (0..4).any(|i| a[i].abs_diff(b[i]) > 1);
        let width = in_it.len() / (place.height() as usize - 6);
        let marker = marker(&alone, place) - vec2(3.0, 3.0);
        for (i, _) in in_it.iter().zip(&by_itself).enumerate().filter(|(_, both)| differ(*both)) {
            let off = marker - vec2((i % width) as f32, (i / width) as f32);
            assert!(off.length() < 9.0, "{name}: {off:?}");
        }
        assert!(seen != in_it, "{name}");
    }
}

/// The mark of the selected point in the left eye's picture at `place`, from its corner.
fn marker(window: &Harness<'_, App>, place: Rect) -> Vec2 {
    let state = window.state().state();
    let size = [place.width().round() as u32, place.height().round() as u32];
    let direction = state.direction(state.document.points.selected(), Eye::Left).expect("it is somewhere");
    let [u, v] = state.view(Eye::Left, size).camera.pixel(direction).expect("in front");
    vec2(u as f32, v as f32)
}

/// Where a place on the tyre is measured to be at T by the left eye's camera: a third independent of what the
/// views use, x0/gamma + beta T.
fn measured(window: &Harness<'_, App>, rest: [f64; 3]) -> Pos2 {
    let state = window.state().state();
    let [beta, time] = [0.9, state.document.time];
    let place = DVec3::new(rest[0] * (1.0_f64 - beta * beta).sqrt() + beta * time, rest[1], rest[2]);
    let rect = window.get_by_label(SECOND).rect();
    let mut alone = state.clone();
    alone.document.settings.look.compare = Compare::Off;
    alone.document.settings.look.geometry = Geometry::Contracted;
    let size = [rect.width().round() as u32, rect.height().round() as u32];
    let camera = alone.view(Eye::Left, size).camera;
    let [u, v] = camera.pixel(place - DVec3::new(-SEPARATION / 2.0, 0.0, 0.0)).expect("in front");
    rect.min + vec2(u as f32, v as f32)
}

fn a_click_into_the_second_picture_selects_what_it_shows_there() {
    let mut window = window(compared(Compare::Contracted));
    let place = measured(&window, ON_THE_TYRE);
    assert!(window.get_by_label(SECOND).rect().contains(place));
    window.hover_at(place);
    window.run_steps(2);
    let told = label_starting_with(&window, "Under the pointer: ");
    assert!(
        told.contains("front tyre") && told.contains("measured now at") && !told.contains("D ="),
        "{told}"
    );
    click(&mut window, place, Modifiers::NONE);
    let point = *window.state().state().document.points.selected();
    assert_eq!(point.body, Some(FRONT_TYRE));
    let off = DVec3::from(point.track.rest).distance(DVec3::from(ON_THE_TYRE));
    assert!(off < 2e-3, "{off} from where it was clicked");
    // There is nothing at the same place of the first picture, and that is said in that alone.
    let [first, second] = ["Left eye view: as seen", SECOND].map(|name| window.get_by_label(name).rect());
    let corner = vec2(12.0, 0.5 * first.height());
    click(&mut window, first.min + corner, Modifiers::NONE);
    let said = window.get_by_label("Nothing here to follow.").rect();
    assert!(first.contains_rect(said) && !second.intersects(said));
    assert_eq!(window.state().state().document.settings.look.compare, Compare::Contracted);
}

fn dragging_the_second_picture_moves_it_with_the_pointer() {
    let mut window = window(compared(Compare::Contracted));
    let from = measured(&window, ON_THE_TYRE);
    let to = from + vec2(-60.0, 25.0);
    super::support::drag(&mut window, from, to);
    let off = measured(&window, ON_THE_TYRE) - to;
    assert!(off.length() < 1.0, "{off:?}");
    let look = window.state().state().document.settings.look;
    assert_eq!((look.compare, look.geometry), (Compare::Contracted, Geometry::Seen));
}

fn two_pictures_of_one_eye_are_named_and_are_no_pair() {
    let mut window = window_of_size(compared(Compare::Rest), [1280.0, 1600.0], 1.0);
    window.run();
    let all = labels(&window);
    assert!(!all.iter().any(|label| label.starts_with("Right eye view")), "{all:?}");
    assert!(all.iter().any(|label| label == "Fusing: two pictures of one eye"), "{all:?}");
    // The numbers stay those of two eyes.
    let disparity = shown(&window, "Disparity Δφ");
    let look = window.state().state().document.settings.look;
    window.state_mut().run(SettingsCommand::Look(LookSettings { compare: Compare::Off, ..look }));
    window.run();
    assert!((shown(&window, "Disparity Δφ") - disparity).abs() < 1e-12);
    window.get_by_label("Right eye view");
    assert!(!labels(&window).iter().any(|label| label.starts_with("Fusing: two pictures")));
}

fn what_cannot_be_compared_shows_two_eyes_and_says_why() {
    let mut window = window_of_size(compared(Compare::Contracted), [1280.0, 1600.0], 1.0);
    window.state_mut().run(in_layout(Layout::Anaglyph));
    window.run();
    window.get_by_label("Both eyes' view");
    let reason = "Needs the layout side by side or over-under.";
    assert!(labels(&window).iter().any(|label| label == reason));
    window.state_mut().run(in_layout(Layout::OverUnder));
    window.run();
    let [first, second] = ["Left eye view: as seen", SECOND].map(|name| window.get_by_label(name).rect());
    assert!(first.max.y < second.min.y);
    assert!(!labels(&window).iter().any(|label| label == reason));
    // Both would be alike.
    window.state_mut().run(SettingsCommand::Geometry(Geometry::Contracted));
    window.run();
    window.get_by_label("Right eye view");
    window.get_by_label("The first picture shows this already.");
}

fn a_comparison_is_chosen_by_key_saved_and_opened() {
    let mut window = window(cyclist(0.9));
    for (name, other) in [
        // What is seen is no second picture of what is seen.
        ("Left eye view: as seen", SECOND),
        ("Left eye view: as seen", "Left eye view: at rest"),
        ("Left eye view: D⁴ surface", "Left eye view: D² paper"),
        ("Left eye view", "Right eye view"),
    ] {
        window.key_press_modifiers(Modifiers::SHIFT, Key::B);
        window.run();
        window.get_by_label(name);
        window.get_by_label(other);
    }
    window.key_press_modifiers(Modifiers::SHIFT, Key::B);
    window.run();
    let told = window.state().state().shown().to_toml();
    assert!(told.contains("compare = \"contracted\""), "{told}");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("state.toml");
    std::fs::write(&path, told).expect("it is writable");
    window.state_mut().run(SettingsCommand::Reset);
    window.run();
    assert_eq!(window.state().state().document.settings.look.compare, Compare::Off);
    open(&mut window, &path);
    assert_eq!(window.state().state().document.settings.look.compare, Compare::Contracted);
    window.run();
    window.get_by_label(SECOND);
    window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.run();
    assert_eq!(window.state().state().document.settings.look.compare, Compare::Off);
}

fn a_clock_beside_you_has_a_checkbox() {
    let mut window = window_of_size(cyclist(0.9), [1280.0, 1600.0], 1.0);
    assert!(!labels(&window).iter().any(|label| label.starts_with("Clock beside you")));
    window.get_by_label("clock beside you").click();
    window.run();
    label_starting_with(&window, "Clock beside you, Left eye: ");
    window.get_by_label("clocks").click();
    window.run();
    assert!(!labels(&window).iter().any(|label| label.starts_with("Clock beside you, ")));
    assert!(window.state().state().document.settings.window.resting_clock);
}
