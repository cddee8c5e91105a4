//! The start page: all lessons and presets, pictures of what they show, and the way in.

use std::collections::BTreeSet;
use std::sync::Arc;

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Rect, Vec2, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use gamow::app::commands::{Command, WindowCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::lesson::LessonCommand;
use gamow::app::state::overlay::Overlay;
use gamow::lesson::{Course, Library};
use gamow::settings::{Preset, Settings, Theme};

use super::Test;
use super::support::{settle, window, window_of_size};

pub const TESTS: &[Test] = trials![
    the_start_page_has_all_lessons_and_presets,
    the_start_page_opens_and_closes_by_its_key_and_button,
    the_start_page_begins_the_first_lesson_and_then_goes_on,
    three_clicks_lead_a_newcomer_to_the_first_reveal,
    a_click_on_a_card_of_the_start_page_shows_it,
    cards_of_the_start_page_are_reached_and_pressed_by_keys,
    keys_change_nothing_behind_the_start_page,
    thumbnails_arrive_once_and_differ,
    no_thumbnail_is_drawn_while_the_start_page_is_closed,
    the_start_page_fits_every_window,
    lessons_that_cannot_be_read_stand_beside_the_others_with_the_reason,
];

/// A window as a newcomer finds it.
fn newcomers() -> State {
    let mut state = State::open(Settings::default()).expect("a preset");
    state.session.overlay = Some(Overlay::Start);
    state
}

/// What the cards of lessons are called, in their order, and those of presets.
fn names() -> (Vec<String>, Vec<String>) {
    let library = Library::own();
    let lessons = library.all().iter().filter(|lesson| !lesson.is_a_preset());
    let lessons = lessons.enumerate().map(|(number, lesson)| format!("{}. {}", number + 1, lesson.title));
    (lessons.collect(), Preset::all().iter().map(|preset| preset.title.clone()).collect())
}

fn is_open(window: &Harness<'_, App>) -> bool {
    window.query_by_label("Look around").is_some()
}

fn open_lesson(window: &Harness<'_, App>) -> Option<String> {
    window.state().state().course().map(|course| course.lesson().name.clone())
}

fn lessons_that_cannot_be_read_stand_beside_the_others_with_the_reason() {
    let folder = tempfile::tempdir().expect("a folder");
    for number in 0..30 {
        std::fs::write(folder.path().join(format!("{number}.md")), "---\n").expect("it is written");
    }
    let good = "---\ntitle: A good one\norder: 0\n---\n\n## One\n\nLook.\n";
    std::fs::write(folder.path().join("good.md"), good).expect("it is written");
    let mut state = newcomers();
    state.session.library =
        Some(Arc::new(Library::new(Some(folder.path())).expect("the others are lessons")));
    let window = window_of_size(state, [1000.0, 8000.0], 1.0);
    assert!(window.query_by_label("1. A good one").is_some());
    assert_eq!(window.query_all_by_label_contains(".md:1: a lesson begins with a line `---`").count(), 20);
    assert_eq!(window.query_all_by_label_contains("10 more lessons cannot be read").count(), 1);
}

fn the_start_page_has_all_lessons_and_presets() {
    let window = window(newcomers());
    let (lessons, presets) = names();
    assert!(lessons.len() >= 12 && lessons[0].starts_with("1. "));
    let place = |name: &String| window.get_by_label(name).rect().min;
    let places: Vec<_> = lessons.iter().chain(&presets).map(place).collect();
    assert!(places.is_sorted_by(|a, b| (a.y, a.x) < (b.y, b.x)), "in order, row by row: {places:?}");
    // The views have made way.
    assert!(window.query_by_label("Left eye view").is_none());
    // Whoever has a lesson or a preset to begin with has no page before it.
    assert!(!is_open(&super::support::window(State::open(Settings::default()).expect("a preset"))));
}

fn the_start_page_opens_and_closes_by_its_key_and_button() {
    let mut window = window(newcomers());
    assert!(is_open(&window));
    window.key_press(Key::Escape);
    window.run_ok();
    assert!(!is_open(&window));
    window.get_by_label("Left eye view");
    for _ in 0..2 {
        window.key_press(Key::S);
        window.run_ok();
        assert!(is_open(&window));
        window.get_by_role_and_label(Role::Button, "Lessons").click();
        window.run_ok();
        assert!(!is_open(&window));
    }
    window.get_by_role_and_label(Role::Button, "Lessons").click();
    window.run_ok();
    window.get_by_label("Look around").click();
    window.run_ok();
    assert!(!is_open(&window) && open_lesson(&window).is_none());
}

fn the_start_page_begins_the_first_lesson_and_then_goes_on() {
    let library = Library::own();
    let [first, second] = [0, 1].map(|number: usize| &library.all()[number]);
    let mut window = window(newcomers());
    window.get_by_label(&format!("Begin: {}", first.title)).click();
    window.run_ok();
    assert!(!is_open(&window));
    assert_eq!(open_lesson(&window).as_deref(), Some(first.name.as_str()));
    window.key_press(Key::S);
    window.run_ok();
    // Its card says where one is; it and the way in lead back without beginning anew.
    let place = window.state().state().course().expect("it is open").place();
    window.get_by_label(&format!("Go on: {}", first.title)).click();
    window.run_ok();
    assert!(!is_open(&window));
    assert_eq!(window.state().state().course().expect("it is open").place(), place);
    // Once it is over the next one is offered; a lesson left in its middle is offered again.
    let ask = |window: &mut Harness<'_, App>, command| {
        window.state_mut().run(Command::Lesson(command));
        window.run_ok();
    };
    ask(&mut window, LessonCommand::Close);
    window.key_press(Key::S);
    window.run_ok();
    window.get_by_label(&format!("Begin: {}", first.title)).click();
    window.run_ok();
    for _ in 0..100 {
        ask(&mut window, LessonCommand::Forward);
    }
    ask(&mut window, LessonCommand::Close);
    window.key_press(Key::S);
    window.run_ok();
    window.get_by_label(&format!("Begin: {}", second.title));
}

fn three_clicks_lead_a_newcomer_to_the_first_reveal() {
    let text = "---\ntitle: Another first\norder: 1\n---\n\n## One step\n\nLook.\n\n### Predict\n\nWhich?\n\n\
                - [ ] this one\n- [x] that one\n\n### Reveal\n\nSee.\n";
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("rods.md"), text).expect("it is written");
    let mut state = newcomers();
    state.session.library = Some(Arc::new(Library::new(Some(folder.path())).expect("it is a lesson")));
    let mut window = window(state);
    for name in ["Begin: Another first", "that one", "Predict"] {
        assert!(!window.state().state().course().is_some_and(Course::is_revealed), "before {name}");
        window.get_by_label(name).click();
        window.run_ok();
    }
    assert!(window.state().state().course().is_some_and(Course::is_revealed));
}

fn a_click_on_a_card_of_the_start_page_shows_it() {
    let (lessons, _) = names();
    let mut window = window_of_size(newcomers(), [1280.0, 2400.0], 1.0);
    window.get_by_label("A globe").click();
    window.run_ok();
    assert!(!is_open(&window) && open_lesson(&window).is_none());
    assert_eq!(window.state().state().document.preset.map(|preset| preset.name), Some("globe"));
    window.key_press(Key::S);
    window.run_ok();
    window.get_by_label(&lessons[2]).click();
    window.run_ok();
    assert!(!is_open(&window));
    assert_eq!(open_lesson(&window), Some(Library::own().all()[2].name.clone()));
}

/// What has the keyboard, and where.
fn focused(window: &Harness<'_, App>) -> Option<(String, Rect)> {
    let node = window.root().children_recursive().find(|node| node.accesskit_node().is_focused())?;
    Some((node.accesskit_node().label()?, node.rect()))
}

fn cards_of_the_start_page_are_reached_and_pressed_by_keys() {
    let mut window = window_of_size(newcomers(), [800.0, 600.0], 1.0);
    let (lessons, presets) = names();
    let mut reached = BTreeSet::new();
    while !reached.contains(presets.last().expect("there are some")) {
        window.key_press(Key::Tab);
        window.run_steps(20);
        let (name, rect) = focused(&window).expect("something has the keyboard");
        assert!(rect.min.y >= 0.0 && rect.max.y <= 601.0, "{name} is scrolled to: {rect:?}");
        assert!(reached.insert(name) && reached.len() < 60, "each once: {reached:?}");
    }
    assert!(lessons.iter().chain(&presets).all(|name| reached.contains(name)), "{reached:?}");
    window.key_press(Key::Enter);
    window.run_ok();
    assert!(!is_open(&window));
    let last = Preset::all().last().map(|preset| preset.name);
    assert_eq!(window.state().state().document.preset.map(|preset| preset.name), last);
}

fn keys_change_nothing_behind_the_start_page() {
    let mut window = window(newcomers());
    let shown = window.state().state().shown();
    for key in
        [Key::PageDown, Key::ArrowDown, Key::ArrowUp, Key::Home, Key::End, Key::Space, Key::L, Key::Num2]
    {
        window.key_press(key);
        window.run_steps(3);
    }
    assert!(is_open(&window));
    assert_eq!(window.state().state().shown(), shown);
    // They scroll.
    let top = window.get_by_label("Look around").rect().min.y;
    window.key_press(Key::Home);
    window.run_steps(30);
    assert!(window.get_by_label("Look around").rect().min.y > top + 300.0);
}

/// The pixels of the pictures on the cards with these `names`.
fn pictures(window: &mut Harness<'_, App>, names: &[String]) -> Vec<Vec<[u8; 4]>> {
    let image = window.render().expect("a picture");
    let pixels = |name: &String| {
        let rect = window.get_by_label(name).rect();
        let columns = rect.min.x as u32 + 12..rect.max.x as u32 - 12;
        // A picture is 0.58 of its width high; what is shown is said in a corner of it.
        let rows = rect.min.y as u32 + 40..(rect.min.y + 0.5 * rect.width()) as u32;
        rows.flat_map(|y| columns.clone().map(|x| image.get_pixel(x, y).0).collect::<Vec<_>>()).collect()
    };
    names.iter().map(pixels).collect()
}

fn thumbnails_arrive_once_and_differ() {
    let (_, presets) = names();
    let mut window = window_of_size(newcomers(), [1280.0, 2400.0], 1.0);
    let empty: BTreeSet<_> = pictures(&mut window, &presets[6..]).concat().into_iter().collect();
    assert_eq!(empty.len(), 1, "quiet places, until there are pictures");
    settle(&mut window);
    let count = window.state().thumbnails().count();
    // One of each, and what both eyes see beside the introduction.
    assert_eq!(count, Library::own().all().len() + 2);
    assert!(window.run_ok().is_some_and(|frames| frames < 4), "nothing is drawn any more");
    let drawn: BTreeSet<_> = pictures(&mut window, &presets).into_iter().collect();
    assert_eq!(drawn.len(), presets.len(), "each preset looks another");
    // They are kept.
    for _ in 0..2 {
        window.key_press(Key::S);
        window.run_ok();
    }
    settle(&mut window);
    assert_eq!(window.state().thumbnails().count(), count);
}

fn no_thumbnail_is_drawn_while_the_start_page_is_closed() {
    let mut window = window(State::open(Settings::default()).expect("a preset"));
    let count = |window: &Harness<'_, App>| window.state().thumbnails().count();
    settle(&mut window);
    assert_eq!(count(&window), 0);
    window.key_press(Key::S);
    window.run_steps(2);
    window.key_press(Key::Escape);
    window.run_ok();
    settle(&mut window);
    // The one that was begun may be finished.
    let left = count(&window);
    assert!(left < names().0.len(), "{left}");
    for _ in 0..5 {
        window.step();
        assert!(window.state().thumbnails().is_settled(), "none is begun");
    }
    assert_eq!(count(&window), left);
}

fn the_start_page_fits_every_window() {
    let (lessons, presets) = names();
    for (size, present) in [
        ([800.0, 600.0], false),
        ([1280.0, 800.0], false),
        ([1280.0, 800.0], true),
        ([3840.0, 2160.0], false),
    ] {
        let mut state = newcomers();
        state.document.settings.window.theme = Theme::Light;
        if present {
            state.run(WindowCommand::TogglePresenting);
        }
        let window = window_of_size(state, size, 1.0);
        let whole = Rect::from_min_size(pos2(0.0, 0.0), Vec2::from(size));
        let begin = format!("Begin: {}", Library::own().all()[0].title);
        for name in [begin.as_str(), "Look around"] {
            let rect = window.get_by_label(name).rect();
            assert!(whole.contains_rect(rect), "{size:?} {name}: {rect:?}");
        }
        let places: Vec<_> =
            lessons.iter().chain(&presets).map(|name| (name, window.get_by_label(name).rect())).collect();
        for (number, (name, rect)) in places.iter().enumerate() {
            assert!(rect.min.x >= 0.0 && rect.max.x <= size[0], "{size:?} {name}: {rect:?}");
            assert!(rect.width() > 140.0 && rect.height() > 0.6 * rect.width(), "{size:?} {name}: {rect:?}");
            for (other, place) in &places[..number] {
                assert!(!rect.intersects(*place), "{size:?} {name} covers {other}");
            }
        }
        assert!(
            whole.contains_rect(places[0].1),
            "{size:?}: the first lesson is in sight: {:?}",
            places[0].1
        );
    }
}
