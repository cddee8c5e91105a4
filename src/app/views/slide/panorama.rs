//! The line of a panorama that joins the selected point in both strips.

use eframe::egui::{Pos2, Stroke, Ui};

use crate::app::state::State;
use crate::app::views::panes::EyePane;
use crate::app::widgets::theme;

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
