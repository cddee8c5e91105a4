//! The panorama's own marks: the line that joins the selected point in both strips, and the button that offers the panorama.

use eframe::egui::{Align, Pos2, Rect, Stroke, Ui};

use crate::app::actions::with_keys;
use crate::app::command::{Command, Switch};
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::app::theme;
use crate::app::views::panes::EyePane;
use crate::app::widgets::strip_button;
use crate::flags::choices::{Form, ProjectionChoice};

/// A views' area at least this many times as wide as high offers the panorama.
const WIDE: f32 = 2.4;

/// From the left end of a title to beyond the longest name of an eye, points.
const AFTER_NAME: f32 = 100.0;

/// Joins the selected point's places in the two `panes` of a panorama. The line leans by the disparity.
pub fn join(ui: &Ui, state: &State, panes: [EyePane; 2]) {
    let point = state.document.points.selected();
    let place = |pane: EyePane| -> Option<Pos2> {
        let camera = state.view(pane.eye, pane.size).camera;
        let pixel = camera.pixel(state.direction(point, pane.eye)?)?;
        Some(pane.place(pixel)).filter(|place| pane.rect.contains(*place))
    };
    let [Some(upper), Some(lower)] = panes.map(place) else { return };
    let colour = theme::point_colour(point.number, ui.visuals());
    let area = panes[0].rect.union(panes[1].rect);
    let painter = ui.painter().with_clip_rect(area);
    painter.line_segment([upper, lower], Stroke::new(1.0, colour));
}

/// Whether a views' area of this shape has the button that changes to the panorama and back.
pub fn is_offered(state: &State, area: Rect) -> bool {
    let settings = &state.document.settings;
    let is_wide = area.width() >= WIDE * area.height();
    let can_be = settings.projection() == ProjectionChoice::Mercator
        && matches!(settings.picture.layout.form(), Form::Beside | Form::Above);
    // Two pictures of one eye have a title that needs the room.
    let can_be = can_be && !settings.is_comparing();
    let is_presented = state.session.stage.is_presented();
    can_be && (settings.is_panorama() || is_presented || is_wide && !settings.window.simple)
}

/// Shows the button in the title strip `strip`, after the name of the left eye.
pub fn offer(ui: &mut Ui, state: &State, strip: Rect, commands: &mut Commands) {
    let is_panorama = state.document.settings.is_panorama();
    let (name, tip) = if is_panorama {
        ("Two views", "Leaves the panorama.")
    } else {
        (
            "Panorama",
            "Shows the whole passage at once, the left eye's strip above the right eye's. The columns of a point differ by its \
             disparity.",
        )
    };
    let after_name = strip.with_min_x(strip.min.x + theme::text_scale(ui.style()) * AFTER_NAME);
    if strip_button(ui, after_name, Align::Min, name)
        .on_hover_text(with_keys(tip, &[Command::Switch(Switch::Panorama)]))
        .clicked()
    {
        commands.push(Command::Switch(Switch::Panorama));
    }
}
