//! The start page: the ways in, the chapters with their lessons, the presets, and pictures of all.

use std::collections::BTreeSet;
use std::sync::Arc;

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Rect, Vec2, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use gamow::app::commands::{Command, SettingsCommand, WindowCommand};
use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::app::state::lesson::LessonCommand;
use gamow::app::state::overlay::Overlay;
use gamow::files::jpeg;
use gamow::flags::choices::RendererChoice;
use gamow::lesson::{Course, Library, card};
use gamow::settings::{Preset, PresetGroup, Settings, Theme};

use super::Test;
use super::support::{settle, window, window_of_size};

pub const TESTS: &[Test] = trials![
    the_start_page_leads_to_all_lessons_and_presets,
    the_first_page_leads_to_a_ride_a_passage_and_a_lesson,
    the_start_page_opens_and_closes_by_its_key_and_button,
    the_start_page_begins_the_first_lesson_and_then_goes_on,
    three_clicks_lead_a_newcomer_to_the_first_reveal,
    a_click_on_a_card_of_the_start_page_shows_it,
    cards_of_the_start_page_are_reached_and_pressed_by_keys,
    keys_change_nothing_behind_the_start_page,
    shipped_pictures_show_their_lessons_and_presets,
    every_card_has_its_picture_at_once,
    lessons_of_ones_own_have_pictures_that_are_drawn_while_somebody_looks,
    the_picture_of_the_start_page_moves_only_while_it_is_seen,
    the_start_page_fits_every_window,
    lessons_that_cannot_be_read_stand_beside_the_others_with_the_reason,
];

/// A window as a newcomer finds it.
fn newcomers() -> State {
    let mut state = State::open(Settings::default()).expect("a preset");
    state.session.overlay = Some(Overlay::Start);
    // Pictures that move take time, and are tried by themselves.
    state.document.settings.window.animations = false;
    state
}

/// The ways in for a newcomer, in their order.
fn ways_in() -> [String; 3] {
    let minutes = Library::own().all()[0].minutes;
    ["Get on and ride".to_owned(), "Watch a cyclist pass".to_owned(), format!("First lesson, {minutes} min")]
}

/// What the cards of chapters are called.
fn chapters() -> Vec<String> {
    Library::own().chapters().iter().map(|chapter| chapter.title.to_owned()).collect()
}

/// What the cards of the lessons in the chapter with this number are called.
fn lessons(chapter: usize) -> Vec<String> {
    let library = Library::own();
    let lessons = &library.chapters()[chapter].lessons;
    lessons.iter().map(|(number, lesson)| format!("{number}. {}", lesson.title)).collect()
}

/// What the cards of presets are called.
fn presets() -> Vec<String> {
    Preset::all().iter().map(|preset| preset.title.clone()).collect()
}

/// A newcomer's window at this page.
fn at(page: Overlay, size: [f32; 2]) -> Harness<'static, App> {
    let mut state = newcomers();
    state.session.overlay = Some(page);
    window_of_size(state, size, 1.0)
}

fn page(window: &Harness<'_, App>) -> Option<Overlay> {
    window.state().state().session.overlay
}

fn is_open(window: &Harness<'_, App>) -> bool {
    page(window).is_some()
}

fn press(window: &mut Harness<'_, App>, name: &str) {
    window.get_by_label(name).click();
    window.run_ok();
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
    let mut window = window_of_size(state, [1000.0, 8000.0], 1.0);
    assert_eq!(window.query_all_by_label_contains(".md:1: a lesson begins with a line `---`").count(), 20);
    assert_eq!(window.query_all_by_label_contains("10 more lessons cannot be read").count(), 1);
    press(&mut window, "Your own lessons");
    assert!(window.query_by_label("1. A good one").is_some());
}

fn the_start_page_leads_to_all_lessons_and_presets() {
    let mut window = window(newcomers());
    let in_order = |window: &Harness<'_, App>, names: &[String]| {
        let place = |name: &String| window.get_by_label(name).rect().min;
        let places: Vec<_> = names.iter().map(place).collect();
        assert!(places.is_sorted_by(|a, b| (a.y, a.x) < (b.y, b.x)), "in order, row by row: {places:?}");
    };
    assert_eq!(chapters().len(), 4);
    in_order(&window, &chapters());
    for (number, chapter) in chapters().iter().enumerate() {
        press(&mut window, chapter);
        assert_eq!(page(&window), Some(Overlay::Chapter(number)));
        in_order(&window, &lessons(number));
        press(&mut window, "← Start page");
        assert_eq!(page(&window), Some(Overlay::Start));
    }
    let cards = window.query_all_by_role_and_label(Role::Button, "Presets").collect::<Vec<_>>();
    cards.last().expect("there is a way").click();
    window.run_ok();
    assert_eq!(page(&window), Some(Overlay::Presets));
    in_order(&window, &presets());
    for group in PresetGroup::ALL {
        window.get_by_role_and_label(Role::Label, group.title());
    }
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
        assert_eq!(page(&window), Some(Overlay::Start));
        window.get_by_role_and_label(Role::Button, "Lessons").click();
        window.run_ok();
        assert!(!is_open(&window));
    }
    // From the pages below it Escape leads back to it, and so does its key.
    for key in [Key::Escape, Key::S] {
        window.key_press_modifiers(Modifiers::SHIFT, Key::S);
        window.run_ok();
        assert_eq!(page(&window), Some(Overlay::Presets));
        window.key_press(key);
        window.run_ok();
        assert_eq!(page(&window), Some(Overlay::Start));
        window.key_press(key);
        window.run_ok();
        assert!(!is_open(&window));
    }
}

fn the_first_page_leads_to_a_ride_a_passage_and_a_lesson() {
    let [ride, watch, lesson] = ways_in();
    let mut window = window(newcomers());
    press(&mut window, &watch);
    let shown = |window: &Harness<'_, App>| window.state().state().clone();
    assert!(!is_open(&window) && shown(&window).scratch.playing);
    assert_eq!(shown(&window).document.preset, Some(Preset::start()));
    let begun = shown(&window).document.time;
    window.run_steps(4);
    assert!(shown(&window).document.time > begun, "the cyclist comes");
    for (way, is_ride) in [(&watch, false), (&ride, true)] {
        window.key_press(Key::S);
        window.run_steps(2);
        window.get_by_label(way).click();
        window.run_steps(3);
        assert!(!is_open(&window) && shown(&window).scratch.playing, "{way}");
        assert_eq!(shown(&window).document.settings.ride.is_on(), is_ride, "{way}");
    }
    // On a ride its key is one of those that walk.
    window.state_mut().run(WindowCommand::Toggle(Overlay::Start));
    window.run_steps(2);
    window.get_by_label(&lesson).click();
    window.run_steps(3);
    assert_eq!(open_lesson(&window), Some(Library::own().all()[0].name.clone()));
}

fn the_start_page_begins_the_first_lesson_and_then_goes_on() {
    let library = Library::own();
    let [first, second] = [0, 1].map(|number: usize| &library.all()[number]);
    let [.., begin] = ways_in();
    let mut window = window(newcomers());
    press(&mut window, &begin);
    assert!(!is_open(&window));
    assert_eq!(open_lesson(&window).as_deref(), Some(first.name.as_str()));
    window.key_press(Key::S);
    window.run_ok();
    // The way in leads back without beginning anew, and so does its card, which says where one is.
    let place = window.state().state().course().expect("it is open").place();
    press(&mut window, &format!("Go on: {}", first.title));
    assert!(!is_open(&window));
    assert_eq!(window.state().state().course().expect("it is open").place(), place);
    window.key_press(Key::S);
    window.run_ok();
    press(&mut window, &chapters()[0]);
    press(&mut window, &lessons(0)[0]);
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
    press(&mut window, &begin);
    for _ in 0..100 {
        ask(&mut window, LessonCommand::Forward);
    }
    ask(&mut window, LessonCommand::Close);
    window.key_press(Key::S);
    window.run_ok();
    window.get_by_label(&format!("Next lesson: {}", second.title));
}

fn three_clicks_lead_a_newcomer_to_the_first_reveal() {
    let text = "---\ntitle: Another first\norder: 1\nminutes: 3\n---\n\n## One step\n\nLook.\n\n### Predict\n\nWhich?\n\n\
                - [ ] this one\n- [x] that one\n\n### Reveal\n\nSee.\n";
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("rods.md"), text).expect("it is written");
    let mut state = newcomers();
    state.session.library = Some(Arc::new(Library::new(Some(folder.path())).expect("it is a lesson")));
    let mut window = window(state);
    for name in ["First lesson, 3 min", "that one", "Predict"] {
        assert!(!window.state().state().course().is_some_and(Course::is_revealed), "before {name}");
        press(&mut window, name);
    }
    assert!(window.state().state().course().is_some_and(Course::is_revealed));
}

fn a_click_on_a_card_of_the_start_page_shows_it() {
    let mut window = at(Overlay::Presets, [1280.0, 1600.0]);
    press(&mut window, "A globe");
    assert!(!is_open(&window) && open_lesson(&window).is_none());
    assert_eq!(window.state().state().document.preset.map(|preset| preset.name), Some("globe"));
    window.key_press(Key::S);
    window.run_ok();
    press(&mut window, &chapters()[0]);
    press(&mut window, &lessons(0)[2]);
    assert!(!is_open(&window));
    assert_eq!(open_lesson(&window), Some(Library::own().all()[2].name.clone()));
}

/// What has the keyboard, and where.
fn focused(window: &Harness<'_, App>) -> Option<(String, Rect)> {
    let node = window.root().children_recursive().find(|node| node.accesskit_node().is_focused())?;
    Some((node.accesskit_node().label()?, node.rect()))
}

/// Goes by the keyboard to `last`, and returns what it came by.
fn reached_by_keys(window: &mut Harness<'_, App>, last: &str) -> BTreeSet<String> {
    let mut reached = BTreeSet::new();
    while !reached.contains(last) {
        window.key_press(Key::Tab);
        window.run_steps(20);
        let (name, rect) = focused(window).expect("something has the keyboard");
        assert!(rect.min.y >= 0.0 && rect.max.y <= 601.0, "{name} is scrolled to: {rect:?}");
        assert!(reached.insert(name) && reached.len() < 60, "each once: {reached:?}");
    }
    reached
}

fn cards_of_the_start_page_are_reached_and_pressed_by_keys() {
    let mut window = at(Overlay::Start, [800.0, 600.0]);
    let last = chapters().pop().expect("there are some");
    let reached = reached_by_keys(&mut window, &last);
    assert!(ways_in().iter().chain(&chapters()).all(|name| reached.contains(name)), "{reached:?}");
    window.key_press(Key::Enter);
    window.run_ok();
    assert_eq!(page(&window), Some(Overlay::Chapter(chapters().len() - 1)));
    let last = lessons(chapters().len() - 1).pop().expect("there are some");
    reached_by_keys(&mut window, &last);
    let mut window = at(Overlay::Presets, [800.0, 600.0]);
    let last = presets().pop().expect("there are some");
    let reached = reached_by_keys(&mut window, &last);
    assert!(presets().iter().all(|name| reached.contains(name)), "{reached:?}");
    window.key_press(Key::Enter);
    window.run_ok();
    assert!(!is_open(&window));
    let last = Preset::all().last().map(|preset| preset.name);
    assert_eq!(window.state().state().document.preset.map(|preset| preset.name), last);
}

fn keys_change_nothing_behind_the_start_page() {
    let mut window = at(Overlay::Presets, [1120.0, 700.0]);
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
    let first = &presets()[0];
    let top = window.get_by_label(first).rect().min.y;
    window.key_press(Key::Home);
    window.run_steps(30);
    assert!(window.get_by_label(first).rect().min.y > top + 100.0);
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

/// Greatest mean difference of a shipped picture from what it shows, levels of 255: that of the compression,
/// and of edges that are drawn by other rays.
const MOST_LEVELS: f64 = 4.0;
/// Greatest size of all shipped pictures together, bytes.
const MOST_BYTES: usize = 600_000;

fn shipped_pictures_show_their_lessons_and_presets() {
    let library = Library::own();
    let mut bytes = 0;
    for lesson in library.all() {
        let name = &lesson.name;
        let file = card::shipped(lesson).and_then(|file| file.bytes(|| ())).expect("each has a file");
        bytes += file.len();
        let (size, pixels) = jpeg::decode(file, |_| Ok(())).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(size, card::SIZE, "{name}");
        let drawn = card::drawn(lesson, RendererChoice::Packets, 1).expect("it can be drawn");
        let levels = |pixels: &[[u8; 4]]| pixels.concat().into_iter().map(f64::from).collect::<Vec<_>>();
        let (shipped, drawn) = (levels(&pixels), levels(&drawn.rgba));
        let off: f64 = shipped.iter().zip(&drawn).map(|(a, b)| (a - b).abs()).sum();
        let mean = off / shipped.len() as f64;
        println!("{name}: {mean:.2}");
        assert!(mean < MOST_LEVELS, "{name} is {mean:.2} levels off: see assets/README.md, cards");
        let bright = pixels.iter().filter(|[red, green, blue, _]| red.max(green).max(blue) > &64).count();
        assert!(5 * bright > pixels.len(), "{name} is dark");
    }
    assert!(bytes < MOST_BYTES, "{bytes} bytes");
}

fn every_card_has_its_picture_at_once() {
    for (page, names) in [(Overlay::Presets, presets()), (Overlay::Chapter(0), lessons(0))] {
        let mut window = at(page, [1280.0, 1600.0]);
        let shown: BTreeSet<_> = pictures(&mut window, &names).into_iter().collect();
        assert_eq!(shown.len(), names.len(), "each looks another");
        assert_eq!(window.state().thumbnails().count(), 0, "none is drawn");
        assert!(window.run_ok().is_some_and(|frames| frames < 4), "nothing is under way");
    }
}

fn lessons_of_ones_own_have_pictures_that_are_drawn_while_somebody_looks() {
    let folder = tempfile::tempdir().expect("a folder");
    for number in 0..9 {
        let state = "```state\nscene = \"globe\"\n```";
        let text = format!("---\ntitle: Own {number}\n---\n\n## One\n\n{state}\n\nLook.\n");
        std::fs::write(folder.path().join(format!("own-{number}.md")), text).expect("it is written");
    }
    let mut state = State::open(Settings::default()).expect("a preset");
    state.session.library = Some(Arc::new(Library::new(Some(folder.path())).expect("they are lessons")));
    let mut window = window(state);
    let count = |window: &Harness<'_, App>| window.state().thumbnails().count();
    settle(&mut window);
    assert_eq!(count(&window), 0);
    window.state_mut().run(WindowCommand::Toggle(Overlay::Chapter(4)));
    window.run_steps(2);
    for _ in 0..2 {
        window.key_press(Key::Escape);
        window.run_steps(1);
    }
    settle(&mut window);
    // The one that was begun may be finished.
    let left = count(&window);
    assert!(left < 9, "{left}");
    for _ in 0..5 {
        window.step();
        assert!(window.state().thumbnails().is_settled(), "none is begun");
    }
    window.state_mut().run(WindowCommand::Toggle(Overlay::Chapter(4)));
    settle(&mut window);
    assert_eq!(count(&window), 9);
    // They are kept.
    for _ in 0..2 {
        window.state_mut().run(WindowCommand::Toggle(Overlay::Chapter(4)));
        window.run_ok();
    }
    settle(&mut window);
    assert_eq!(count(&window), 9);
}

/// The pixels at the upper edge of the page, which show the moving picture alone.
fn upper_edge(window: &mut Harness<'_, App>) -> Vec<[u8; 4]> {
    let image = window.render().expect("a picture");
    (50..90).flat_map(|y| (100..1000).map(move |x| (x, y))).map(|(x, y)| image.get_pixel(x, y).0).collect()
}

fn the_picture_of_the_start_page_moves_only_while_it_is_seen() {
    let mut window = window(newcomers());
    let animate = |window: &mut Harness<'_, App>, is_on: bool| {
        let value = if is_on { "on" } else { "off" }.to_owned();
        window.state_mut().run(SettingsCommand::Value { name: "animations", value });
    };
    animate(&mut window, true);
    let drawings = |window: &Harness<'_, App>| window.state().start_picture_drawings();
    // A slow machine draws one in a second.
    let run_until = |window: &mut Harness<'_, App>, count: u64| {
        let steps = (0..200).find(|_| {
            window.step();
            drawings(window) >= count
        });
        steps.expect("it is drawn")
    };
    run_until(&mut window, 2);
    let (first, before) = (upper_edge(&mut window), drawings(&window));
    // At most fifteen a second: a step of these windows is a sixteenth.
    assert!(run_until(&mut window, before + 5) >= 4);
    assert!(upper_edge(&mut window) != first, "it moves");
    let is_still = |window: &mut Harness<'_, App>, why: &str| {
        window.run_steps(2);
        let before = drawings(window);
        window.run_steps(30);
        assert_eq!(drawings(window), before, "{why}");
    };
    window.input_mut().focused = false;
    is_still(&mut window, "behind another window");
    window.input_mut().focused = true;
    animate(&mut window, false);
    is_still(&mut window, "where less motion is asked for");
    animate(&mut window, true);
    let chapter = chapters().remove(0);
    window.get_by_label(&chapter).click();
    is_still(&mut window, "on another page");
    window.key_press(Key::Escape);
    window.run_steps(2);
    window.key_press(Key::Escape);
    is_still(&mut window, "in the window itself");
}

fn the_start_page_fits_every_window() {
    for (size, present) in [
        ([360.0, 740.0], false),
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
        let mut window = window_of_size(state, size, 1.0);
        let whole = Rect::from_min_size(pos2(0.0, 0.0), Vec2::from(size));
        let ways: Vec<_> = ways_in().iter().map(|name| window.get_by_label(name).rect()).collect();
        assert!(ways.iter().all(|rect| whole.contains_rect(*rect)), "{size:?}: {ways:?}");
        let mut pages = vec![(Overlay::Start, [ways_in().to_vec(), chapters()].concat())];
        pages.extend((0..chapters().len()).map(|number| (Overlay::Chapter(number), lessons(number))));
        pages.push((Overlay::Presets, presets()));
        for (page, names) in pages {
            if page != Overlay::Start {
                window.state_mut().run(WindowCommand::Toggle(page));
                window.run_steps(2);
            }
            let places: Vec<_> = names.iter().map(|name| (name, window.get_by_label(name).rect())).collect();
            for (number, (name, rect)) in places.iter().enumerate() {
                assert!(rect.min.x >= 0.0 && rect.max.x <= size[0], "{size:?} {name}: {rect:?}");
                for (other, place) in &places[..number] {
                    assert!(!rect.intersects(*place), "{size:?} {name} covers {other}");
                }
            }
            for (name, rect) in places.iter().filter(|(name, _)| !ways_in().contains(name)) {
                assert!(
                    rect.width() > 140.0 && rect.height() > 0.6 * rect.width(),
                    "{size:?} {name}: {rect:?}"
                );
            }
        }
    }
}
