//! The ruler for angles in the views: how a drag lays it, and how it is drawn.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Color32, Painter, Pos2, Rect, Sense, Shape, Stroke, TextStyle, Ui, WidgetInfo, vec2,
};
use glam::DVec3;

use crate::app::measuring::angle_ruler::{AngleRuler, Laid, PARTS, RulerCommand, laid};
use crate::app::state::State;
use crate::app::views::panes::EyePane;

impl State {
    /// Applies a command about the ruler.
    pub(in crate::app) fn apply_to_ruler(&mut self, command: RulerCommand) {
        self.scratch.angle_ruler = match (command, self.scratch.angle_ruler) {
            (RulerCommand::Toggle, AngleRuler::Off) => AngleRuler::Armed,
            (RulerCommand::Toggle, _) => AngleRuler::Off,
            (RulerCommand::Settle, AngleRuler::Laid(laid)) => {
                AngleRuler::Laid(Laid { is_held: false, ..laid })
            }
            (RulerCommand::Settle, ruler) => ruler,
            (RulerCommand::Lay(lay), ruler) => {
                let camera = self.of_picture(lay.is_second, |state| state.view(lay.eye, lay.size).camera);
                laid(&camera, lay).map_or(ruler, AngleRuler::Laid)
            }
        };
    }
}

/// Returns the hint in the views while a drag would lay it.
pub(in crate::app) fn hint(state: &State) -> Option<String> {
    let is_armed = state.scratch.angle_ruler == AngleRuler::Armed;
    is_armed.then(|| "Drag from one place to another to measure the angle between them.".to_owned())
}

/// Half the length of the bars at both ends, points.
const BAR: f32 = 7.0;
/// Strokes of it, above what sets them off from the picture.
const STROKES: [(f32, Color32); 2] = [(4.5, Color32::from_black_alpha(190)), (2.0, Color32::WHITE)];
const TIP: &str = "The angle between the lines of sight to both ends. The error is half a pixel at each end, as it was when the ruler was \
    laid.";

/// Draws it into `pane`, if it is there.
pub(in crate::app) fn paint(ui: &Ui, painter: &Painter, state: &State, pane: EyePane) {
    let AngleRuler::Laid(laid) = state.scratch.angle_ruler else { return };
    if (laid.eye, laid.is_second) != (pane.eye, pane.is_second) {
        return;
    }
    let camera = state.view(pane.eye, pane.size).camera;
    let place =
        |direction: DVec3| Some(pane.place(camera.pixel(direction)?)).filter(|place| place.is_finite());
    let line: Vec<_> = (0..=PARTS).map(|part| place(laid.along(part))).collect();
    for (width, colour) in STROKES {
        let stroke = Stroke::new(width, colour);
        // What is behind the camera parts the line.
        for shown in line.split(Option::is_none) {
            let shown: Vec<Pos2> = shown.iter().copied().flatten().collect();
            for end in bars(&line, &shown) {
                painter.line_segment(end, stroke);
            }
            painter.add(Shape::line(shown, stroke));
        }
    }
    tell(ui, painter, pane, &line, &laid.text());
}

/// The bars across both ends of the whole `line` that are among the `shown` places.
fn bars(line: &[Option<Pos2>], shown: &[Pos2]) -> Vec<[Pos2; 2]> {
    let [first, .., before, last] = shown else { return Vec::new() };
    let second = shown[1];
    let bar = |end: Pos2, next: Pos2| {
        let across = BAR * (next - end).normalized().rot90();
        [end - across, end + across]
    };
    let is_end = |end: &Pos2, of: Option<&Option<Pos2>>| of == Some(&Some(*end));
    let ends = [(is_end(first, line.first()), *first, second), (is_end(last, line.last()), *last, *before)];
    ends.into_iter().filter(|(is_end, ..)| *is_end).map(|(_, end, next)| bar(end, next)).collect()
}

/// Writes `text` beside the middle of what of the `line` is in sight.
fn tell(ui: &Ui, painter: &Painter, pane: EyePane, line: &[Option<Pos2>], text: &str) {
    let inside: Vec<_> = line.iter().flatten().filter(|place| pane.rect.contains(**place)).collect();
    let Some(middle) = inside.get(inside.len() / 2).map(|place| **place) else { return };
    let galley = painter.layout_no_wrap(text.to_owned(), TextStyle::Body.resolve(ui.style()), Color32::WHITE);
    let room = pane.rect.shrink(6.0);
    let place = Align2::CENTER_TOP.anchor_size(middle + vec2(0.0, BAR + 4.0), galley.size());
    let corner = place.min.clamp(room.min, (room.max - galley.size()).max(room.min));
    let place = Rect::from_min_size(corner, galley.size()).expand2(vec2(5.0, 1.0));
    painter.rect_filled(place, 3.0, Color32::from_black_alpha(190));
    painter.galley(corner, galley, Color32::WHITE);
    let name = format!("Ruler, {}: {text}", pane.eye.name());
    let response = ui.interact(place.intersect(pane.rect), ui.scope_id().with("angle ruler"), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &name));
    response.on_hover_text(TIP);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::measuring::angle_ruler::Lay;
    use crate::eye::Eye;
    use crate::flags::FieldOfView;
    use crate::flags::choices::ProjectionChoice;
    use crate::settings::Settings;

    const SIZE: [u32; 2] = [800, 600];

    fn state(projection: ProjectionChoice) -> State {
        let mut settings = Settings { scene: "globe".to_owned(), time: Some(-1.0), ..Settings::default() };
        settings.look.projection = projection;
        settings.look.fov = FieldOfView(Some(90.0));
        State::open(settings).expect("a preset")
    }

    fn lay(state: &mut State, ends: [[f64; 2]; 2]) -> Laid {
        state.apply_to_ruler(RulerCommand::Lay(Lay { eye: Eye::Left, is_second: false, ends, size: SIZE }));
        let AngleRuler::Laid(laid) = state.scratch.angle_ruler else { panic!("it is laid") };
        laid
    }

    /// A ruler that is laid by `state` is the same one where the picture has another projection or gaze, and its error is half a
    /// pixel of the picture that it was laid in, twice.
    #[test]
    fn it_keeps_its_directions_and_its_angle() {
        let mut state = state(ProjectionChoice::Gaze);
        let camera = state.view(Eye::Left, SIZE).camera;
        let ends = [[400.0, 300.0], [560.0, 300.0]];
        let laid = lay(&mut state, ends);
        // A flat picture 90 degrees wide: its plane is half a width ahead.
        let expected = (160.0_f64 / 400.0).atan();
        assert!((laid.angle() - expected).abs() < 1e-12, "{}", laid.angle());
        // Along the row 1 / 400 in the middle, and cos^2 of that at the other end.
        let error = 0.5 / 400.0 * (1.0 + expected.cos().powi(2));
        assert!((laid.error / error - 1.0).abs() < 1e-4, "{} for {error}", laid.error);
        state.document.settings.look.projection = ProjectionChoice::Mercator;
        let other = state.view(Eye::Left, SIZE).camera;
        for (end, pixel) in laid.ends.into_iter().zip(ends) {
            let before = camera.pixel(end).expect("in front");
            assert!((before[0] - pixel[0]).abs() + (before[1] - pixel[1]).abs() < 1e-9);
            let now = other.pixel(end).expect("in front");
            assert!((now[0] - pixel[0]).abs() > 1.0 && other.line_of_sight(now).distance(end) < 1e-12);
        }
        assert_eq!(state.scratch.angle_ruler, AngleRuler::Laid(laid));
    }

    #[test]
    fn a_toggle_arms_it_and_takes_it_away() {
        let mut state = state(ProjectionChoice::Mercator);
        state.apply_to_ruler(RulerCommand::Toggle);
        assert!(state.scratch.angle_ruler.takes_drags());
        // A press without a movement lays none.
        let still = Lay { eye: Eye::Left, is_second: false, ends: [[5.0, 5.0]; 2], size: SIZE };
        state.apply_to_ruler(RulerCommand::Lay(still));
        assert_eq!(state.scratch.angle_ruler, AngleRuler::Armed);
        lay(&mut state, [[5.0, 5.0], [6.0, 5.0]]);
        assert!(state.scratch.angle_ruler.takes_drags(), "it is being laid");
        state.apply_to_ruler(RulerCommand::Settle);
        assert!(!state.scratch.angle_ruler.takes_drags());
        state.apply_to_ruler(RulerCommand::Toggle);
        assert_eq!(state.scratch.angle_ruler, AngleRuler::Off);
    }
}
