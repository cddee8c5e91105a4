//! The layouts of the two eyes' pictures: in each, what is clicked is selected, what is under the pointer is
//! told, markers stand where the core sees the point, and only what is shown is drawn.

use clap::ValueEnum as _;
use eframe::egui::{Key, Modifiers, Pos2, Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use gamow::app::commands::{Command, ShowCommand};
use gamow::app::shell::App;
use gamow::eye::Eye;
use gamow::flags::choices::{Form, Layout};
use gamow::settings::Preset;
use glam::DVec3;
use relativity_core::{Aperture, SourcePoint, sighting};
use relativity_render::Composition;

use super::Test;
use super::picking::{FRONT_TYRE, ON_THE_TYRE, click};
use super::support::{
    FRAME, SEPARATION, cyclist, in_layout, label_starting_with, labels, window, window_of_size,
};

pub const TESTS: &[Test] = trials![
    in_every_layout_a_click_on_the_tyre_selects_it_and_resting_there_tells_it,
    every_layout_is_chosen_by_name_and_by_key,
    swapped_eyes_are_remembered_for_each_layout,
    one_eye_alone_has_all_of_the_views,
    flicker_waits_for_its_beat_and_shows_each_eye_in_turn,
    composed_views_show_both_eyes,
    dragging_in_a_squeezed_picture_moves_it_with_the_pointer,
    tiny_windows_do_no_harm_in_any_layout,
];

/// The window with this layout. What flickers asks for frames without an end, so that frames are counted.
fn shown(layout: Layout) -> Harness<'static, App> {
    let mut state = cyclist(0.9);
    state.document.settings.picture.layout = layout;
    window(state)
}

/// Where the pictures of an eye are, and whether both share the place; `None` if it is not shown alone or
/// with the other.
fn picture_of(window: &Harness<'_, App>, eye: usize) -> Option<Rect> {
    let own = window.query_by_label(["Left eye view", "Right eye view"][eye]);
    own.or(window.query_by_label("Both eyes' view")).map(|node| node.rect())
}

/// The size of the picture of an eye, pixels, in a window of one per point.
fn size_of(layout: Layout, rect: Rect) -> [u32; 2] {
    let [width, height] = [rect.width(), rect.height()].map(|side| side.round() as u32);
    match layout.form() {
        Form::Composed(Composition::HalfSideBySide) => [2 * width, height],
        Form::Composed(Composition::HalfOverUnder) => [width, 2 * height],
        _ => [width, height],
    }
}

/// Where an eye sees the point on the tyre.
fn place_of_tyre(window: &Harness<'_, App>, layout: Layout, eye: usize) -> Option<Pos2> {
    let rect = picture_of(window, eye)?;
    let size = size_of(layout, rect);
    let state = window.state().state();
    let speed = state.speed();
    let point = SourcePoint::from_rest(ON_THE_TYRE, &speed);
    let seen = sighting(&speed, point, Aperture::pair(SEPARATION)[eye], state.document.time);
    let camera = state.view(Eye::BOTH[eye], size).camera;
    let [u, v] = camera.pixel(DVec3::from(seen.expect("in the domain").position)).expect("in front");
    let part = vec2((u / f64::from(size[0])) as f32, (v / f64::from(size[1])) as f32);
    Some(rect.min + part * rect.size())
}

fn in_every_layout_a_click_on_the_tyre_selects_it_and_resting_there_tells_it() {
    let mut window = window(cyclist(0.9));
    for &layout in Layout::value_variants() {
        for eye in [0, 1] {
            // The scene's own point is selected again.
            for command in [in_layout(layout), Command::Show(ShowCommand::Scene("cyclist"))] {
                window.state_mut().run(command);
            }
            window.run_steps(3);
            let is_shared = window.query_by_label("Both eyes' view").is_some();
            let Some(place) = place_of_tyre(&window, layout, eye).filter(|_| eye == 0 || !is_shared) else {
                continue;
            };
            assert!(picture_of(&window, eye).is_some_and(|rect| rect.contains(place)), "{layout:?}");
            window.hover_at(place);
            window.run_steps(3);
            let told = label_starting_with(&window, "Under the pointer: ");
            assert!(told.starts_with("Under the pointer: front tyre"), "{layout:?}: {told}");
            click_without_rest(&mut window, place);
            let point = *window.state().state().document.points.selected();
            assert_eq!(point.body, Some(FRONT_TYRE), "{layout:?}, eye {eye}");
            // A pixel of a squeezed picture is two wide: it is clicked to within half of that.
            let off = DVec3::from(point.track.rest).distance(DVec3::from(ON_THE_TYRE));
            assert!(off < 2e-3, "{layout:?}, eye {eye}: {off} from where it was clicked");
            // The pictures are shifted so that the selected point is at the screen.
            let place = place_of_tyre(&window, layout, eye).expect("it is shown");
            assert_is_marked(&window, eye, place);
        }
    }
}

/// The clock of the selected point stands beside its marker, which is at `place`.
fn assert_is_marked(window: &Harness<'_, App>, eye: usize, place: Pos2) {
    let name = format!("Clock of front tyre (2), {}", ["Left eye", "Right eye"][eye]);
    let clock = labels(window).into_iter().find(|label| label.starts_with(&name));
    let is_in_turn = window.state().state().document.settings.picture.layout == Layout::Flicker;
    let Some(clock) = clock else { return assert!(is_in_turn, "{name} is not shown") };
    let rect = window.get_by_label(&clock).rect();
    // 15 points from the middle of the marker to its rim.
    let away = rect.center().distance(place) - 0.5 * rect.width();
    assert!((away - 15.0).abs() < 1.0, "{clock} at {rect:?} for {place:?}");
}

/// A click, and frames until it is done.
fn click_without_rest(window: &mut Harness<'_, App>, place: Pos2) {
    if window.state().state().document.settings.picture.layout != Layout::Flicker {
        return click(window, place, Modifiers::NONE);
    }
    window.hover_at(place);
    window.step();
    window.drag_at(place);
    window.step();
    window.drop_at(place);
    window.run_steps(2);
}

fn every_layout_is_chosen_by_name_and_by_key() {
    let mut window = window(cyclist(0.9));
    let layout = |window: &Harness<'_, App>| window.state().state().document.settings.picture.layout;
    window.key_press(Key::L);
    window.run();
    assert_eq!(layout(&window), Layout::FreeViewing);
    window.key_press_modifiers(Modifiers::SHIFT, Key::L);
    window.run();
    assert_eq!(layout(&window), Layout::SideBySide);
    window.get_by_label("Layout of the pictures").click();
    window.run();
    window.get_by_label("Anaglyph, colours").click();
    window.run();
    assert_eq!(layout(&window), Layout::Dubois);
    window.get_by_label("Both eyes' view");
    // A preset is another state to look at, in the same way.
    window.state_mut().run(ShowCommand::Preset(Preset::named("globe").expect("a preset")));
    window.run();
    assert_eq!(layout(&window), Layout::Dubois);
}

fn swapped_eyes_are_remembered_for_each_layout() {
    let mut window = window(cyclist(0.9));
    let left_of = |window: &Harness<'_, App>| {
        let [left, right] = [0, 1].map(|eye| picture_of(window, eye).expect("it is shown").center().x);
        left < right
    };
    assert!(left_of(&window));
    window.get_by_label("swap eyes").click();
    window.run();
    assert!(!left_of(&window));
    window.state_mut().run(in_layout(Layout::CrossEyed));
    window.run();
    assert!(!left_of(&window));
    window.key_press(Key::X);
    window.run();
    assert!(left_of(&window));
    window.state_mut().run(in_layout(Layout::SideBySide));
    window.run();
    assert!(!left_of(&window));
    let swapped = window.state().state().document.settings.picture.swapped;
    assert_eq!(swapped.layouts().collect::<Vec<_>>(), [Layout::SideBySide, Layout::CrossEyed]);
}

fn one_eye_alone_has_all_of_the_views() {
    let both = window(cyclist(0.9));
    let width = picture_of(&both, 0).expect("it is shown").width();
    for (layout, eye) in [(Layout::Left, 0), (Layout::Right, 1)] {
        let window = shown(layout);
        let rect = picture_of(&window, eye).expect("it is shown");
        assert!(rect.width() > 1.9 * width, "{layout:?}: {rect:?}");
        assert!(window.query_by_label(["Right eye view", "Left eye view"][eye]).is_none());
        // The arrow, the markers and the clock of the other eye are not there either.
        let other = ["Right eye", "Left eye"][eye];
        assert!(!labels(&window).iter().any(|label| label.starts_with("Clock") && label.contains(other)));
    }
}

fn flicker_waits_for_its_beat_and_shows_each_eye_in_turn() {
    let mut window = shown(Layout::Flicker);
    let mut waits = Vec::new();
    let mut turns = Vec::new();
    for _ in 0..(1.0 / FRAME) as usize {
        window.step();
        let whose =
            |eye: &str| labels(&window).iter().any(|label| label.starts_with("Clock") && label.contains(eye));
        turns.push([whose("Left eye"), whose("Right eye")]);
        let viewport = window.output().viewport_output.values().next().expect("one window");
        waits.push(viewport.repaint_delay);
    }
    // Six turns a second, of both eyes, each alone.
    let changes = turns.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert!((5..=6).contains(&changes), "{changes}: {turns:?}");
    assert!(turns.iter().all(|[left, right]| left != right), "{turns:?}");
    // No frame at once, and none later than the next turn.
    assert!(waits.iter().all(|wait| (0.0005..0.18).contains(&wait.as_secs_f64())), "{waits:?}");
}

/// Pixels of the picture of both eyes.
fn pixels(window: &mut Harness<'_, App>) -> Vec<[u8; 3]> {
    let rect = window.get_by_label("Both eyes' view").rect().shrink(4.0);
    let picture = window.render().expect("a picture");
    let columns = rect.min.x as u32..rect.max.x as u32;
    (rect.min.y as u32..rect.max.y as u32)
        .flat_map(|y| columns.clone().map(move |x| (x, y)))
        .map(|(x, y)| {
            let [r, g, b, _] = picture.get_pixel(x, y).0;
            [r, g, b]
        })
        .collect()
}

fn composed_views_show_both_eyes() {
    // In an anaglyph of the two the left eye is in red and the right one in cyan: swapping exchanges these.
    let mut state = cyclist(0.9);
    state.document.settings.picture.layout = Layout::Anaglyph;
    state.document.settings.window.dials = false;
    let mut window = window(state);
    let with_defaults = pixels(&mut window);
    window.key_press(Key::X);
    window.remove_cursor();
    window.run();
    let swapped = pixels(&mut window);
    let exchanged =
        with_defaults.iter().zip(&swapped).filter(|([r, g, _], [s, t, _])| r == t && g == s).count();
    let differing = with_defaults.iter().filter(|[r, g, _]| r.abs_diff(*g) > 40).count();
    // All but the markers and the words.
    assert!(exchanged as f64 > 0.97 * with_defaults.len() as f64, "{exchanged} of {}", with_defaults.len());
    assert!(differing > 500, "{differing} pixels differ between the eyes");
}

fn dragging_in_a_squeezed_picture_moves_it_with_the_pointer() {
    for layout in [Layout::HalfSideBySide, Layout::HalfOverUnder] {
        let mut window = shown(layout);
        let before = place_of_tyre(&window, layout, 0).expect("it is shown");
        let middle = picture_of(&window, 0).expect("it is shown").center();
        let moved = vec2(30.0, 18.0);
        super::support::drag(&mut window, middle, middle + moved);
        let after = place_of_tyre(&window, layout, 0).expect("it is shown");
        assert!((after - before - moved).length() < 5.0, "{layout:?}: {:?}", after - before);
    }
}

fn tiny_windows_do_no_harm_in_any_layout() {
    for size in [[64.0, 64.0], [90.0, 900.0]] {
        let mut state = cyclist(0.9);
        state.document.settings.window.corrected = true;
        let mut window = window_of_size(state, size, 1.5);
        for &layout in Layout::value_variants() {
            window.state_mut().run(in_layout(layout));
            window.run_steps(2);
            window.render().expect("a picture");
        }
    }
}
