//! Each target of a click is easy to hit: it is 24 points wide and high, or a circle of that width about its
//! middle meets no other target (Web Content Accessibility Guidelines 2.2, 2.5.8).

use eframe::egui::Rect;
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT as _;
use gamow::app::commands::WindowCommand;
use gamow::app::shell::App;
use gamow::app::state::lesson::LessonCommand;
use gamow::app::state::overlay::Overlay;

use super::Test;
use super::support::{cyclist, window_without_pictures};

pub const TESTS: &[Test] = trials![what_is_clicked_is_24_points_wide_or_stands_apart];

/// Least width and height of a target, points.
const LEAST: f32 = 24.0;
/// Roles of what is clicked.
const CLICKED: &[Role] = &[
    Role::Button,
    Role::CheckBox,
    Role::ComboBox,
    Role::DisclosureTriangle,
    Role::Link,
    Role::RadioButton,
    Role::Slider,
    Role::SpinButton,
    Role::TextInput,
];

/// Beginnings of the names of a slider's ticks, which are a second way to what the slider does.
const TICKS: [&str; 2] = ["Go to ", "Set β to "];

/// The targets in the window, by their names.
fn targets(window: &Harness<'_, App>) -> Vec<(String, Rect)> {
    let screen = window.ctx.content_rect();
    let nodes =
        window.root().children_recursive().filter(|node| CLICKED.contains(&node.accesskit_node().role()));
    let targets = nodes.map(|node| (node.accesskit_node().label().unwrap_or_default(), node.rect()));
    let is_tick = |name: &str| TICKS.iter().any(|tick| name.starts_with(tick));
    targets
        .filter(|(name, rect)| rect.is_positive() && screen.contains_rect(*rect) && !is_tick(name))
        .collect()
}

/// Returns the targets that are too small, each with another that is too near.
fn crowded(targets: &[(String, Rect)]) -> Vec<String> {
    let is_small = |rect: &Rect| rect.size().min_elem() < LEAST;
    let is_near = |rect: &Rect, other: &Rect| {
        let middle = rect.center();
        other.distance_to_pos(middle) < 0.5 * LEAST
            || is_small(other) && middle.distance(other.center()) < LEAST
    };
    let small = targets.iter().enumerate().filter(|(_, (_, rect))| is_small(rect));
    let near = |(number, (name, rect)): (usize, &(String, Rect))| {
        let others = targets.iter().enumerate().filter(|(other, _)| *other != number);
        let near = others.filter(|(_, (_, other))| is_near(rect, other));
        near.map(|(_, (other, place))| format!("{name:?} at {rect:?}: {other:?} at {place:?}"))
            .collect::<Vec<_>>()
    };
    small.flat_map(near).collect()
}

fn what_is_clicked_is_24_points_wide_or_stands_apart() {
    let mut found = Vec::new();
    for size in [[360.0, 740.0], [1024.0, 600.0], [1280.0, 800.0]] {
        let mut window = window_without_pictures(cyclist(0.9), size);
        let mut look = |window: &mut Harness<'_, App>, what: &str| {
            window.run_steps(3);
            let all = targets(window);
            assert!(all.len() > 3, "{what} in {size:?}: {all:?}");
            found.extend(crowded(&all).into_iter().map(|crowd| format!("{what} in {size:?}: {crowd}")));
        };
        look(&mut window, "the window");
        for overlay in [Overlay::Start, Overlay::Presets] {
            window.state_mut().run(WindowCommand::Toggle(overlay));
            look(&mut window, "a page");
        }
        window.state_mut().run(WindowCommand::Toggle(Overlay::Presets));
        // On a phone the page of a lesson scrolls below its foot, and what is there has a place, too.
        if size[0] > 600.0 {
            window.state_mut().run(LessonCommand::Open("rods".to_owned()));
            look(&mut window, "a lesson");
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}
