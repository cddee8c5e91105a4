//! What must be so whatever was done.

use eframe::egui::accesskit::Role;
use eframe::egui::{Pos2, Rect, Shape};
use gamow::app::commands::Command;
use gamow::app::state::State;
use gamow::settings::Settings;

use super::hands::Window;
use super::nodes::all;

/// What every frame must hold to; settings that were `checked` are so still.
pub fn of_a_frame(window: &Window, checked: &mut Option<Settings>) {
    state(window.state().state(), checked);
    let typed =
        |state: &State| state.scratch.notice.as_ref().map(|notice| notice.text.clone()).unwrap_or_default();
    let typed = typed(window.state().state());
    for found in all(window) {
        let rect = found.rect;
        assert!(found.rect == Rect::NOTHING || is_finite(rect), "{:?} is at {rect:?}", found.name);
        // What was typed is shown as it was typed, and quoted. (A text that is no input is the name or value
        // of another node, too.)
        if matches!(found.role, Role::TextInput | Role::TextRun | Role::SpinButton) {
            continue;
        }
        let is_quoted =
            |text: &str| text.contains(['“', '`']) || text.contains("must") || typed.contains(text);
        for text in [&found.name, &found.value].into_iter().filter(|text| !is_quoted(text)) {
            let is_broken = text
                .split(|letter: char| !letter.is_alphanumeric())
                .any(|word| word == "NaN" || word == "inf");
            assert!(!is_broken, "{:?} says {text:?}", found.role);
        }
    }
    for clipped in &window.output().shapes {
        shape(&clipped.shape);
    }
}

fn is_finite(rect: Rect) -> bool {
    rect.min.is_finite() && rect.max.is_finite()
}

/// Whether all of a drawing is somewhere.
fn shape(drawn: &Shape) {
    let points = |points: &[Pos2]| assert!(points.iter().all(|point| point.is_finite()), "{drawn:?}");
    match drawn {
        Shape::Vec(all) => all.iter().for_each(shape),
        Shape::Path(path) => points(&path.points),
        Shape::LineSegment { points: ends, .. } => points(ends),
        Shape::Circle(circle) => points(&[circle.center]),
        Shape::Text(text) => points(&[text.pos]),
        Shape::Mesh(mesh) => assert!(mesh.vertices.iter().all(|vertex| vertex.pos.is_finite()), "a mesh"),
        Shape::Rect(rect) if rect.rect != Rect::NOTHING => {
            assert!(!rect.rect.any_nan(), "{drawn:?}");
        }
        _ => {}
    }
}

fn state(state: &State, checked: &mut Option<Settings>) {
    assert!(state.document.time.is_finite(), "T = {}", state.document.time);
    for view in state.document.settings.views(state.subject(), state.document.time, state.frame.picture.size)
    {
        let camera = view.camera;
        let direction = camera.line_of_sight([0.0, 0.0]);
        let is_finite = camera.horizontal_fov.is_finite() && direction.is_finite();
        assert!(is_finite, "a view is {view:?}");
    }
    let shown = Settings { time: None, ..state.shown() };
    if checked.as_ref() == Some(&shown) {
        return;
    }
    *checked = Some(shown.clone());
    let toml = shown.to_toml();
    let read = Settings::default().with_toml(&toml, "x");
    match read {
        Ok(read) => assert_eq!(read, shown, "settings that are written and read are others"),
        Err(error) => panic!("settings that are written cannot be read: {error}"),
    }
    for line in toml.lines() {
        let value = line.split_once('=').map_or("", |(_, value)| value.trim());
        assert!(!value.contains("nan") && !value.contains("NaN"), "{line}");
    }
}

/// What the plots hold.
pub fn of_plots(window: &mut Window) {
    let csv = window.state_mut().plots_csv();
    for (number, line) in csv.lines().enumerate().filter(|(_, line)| !line.starts_with('#')) {
        let is_broken = line.split(',').any(|cell| ["NaN", "inf", "-inf"].contains(&cell.trim()));
        assert!(!is_broken, "line {} of the plots: {line}", number + 1);
    }
    let svg = window.state_mut().plots_svg();
    let broken =
        svg.split(|letter: char| !letter.is_alphanumeric()).find(|word| ["NaN", "inf"].contains(word));
    assert!(broken.is_none(), "the plots as a drawing hold {broken:?}");
}

/// Undoes all there is; how many steps that were.
pub fn undo_all(window: &mut Window) -> usize {
    let mut steps = 0;
    while window.state().state().session.history.can_undo() {
        window.state_mut().run(Command::Undo);
        steps += 1;
        assert!(steps <= 200, "more steps than are kept");
    }
    steps
}

/// Undoing all there is leads to the settings and points of `start`, and doing it again leads back.
pub fn of_the_way_back(window: &mut Window, start: &State) {
    let shown = |window: &Window| {
        let state = window.state().state();
        (state.document.settings.clone(), state.document.points.clone())
    };
    let before = shown(window);
    // The last action may have undone something itself.
    let could_redo = window.state().state().session.history.can_redo();
    let steps = undo_all(window);
    let first = shown(window);
    if steps < 200 {
        assert_eq!(first.0, start.document.settings, "after {steps} steps back");
        assert_eq!(first.1, start.document.points, "after {steps} steps back");
    }
    for _ in 0..steps {
        window.state_mut().run(Command::Redo);
    }
    assert_eq!(window.state().state().session.history.can_redo(), could_redo);
    let again = shown(window);
    assert_eq!(again.0, before.0, "after {steps} steps back and forward again");
    assert_eq!(again.1, before.1, "after {steps} steps back and forward again");
}
