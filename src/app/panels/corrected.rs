//! The corrected picture beside those of the eyes, and by which speed it was corrected.

use eframe::egui::{
    self, Color32, Pos2, Rect, Sense, Stroke, StrokeKind, TextureHandle, Ui, accesskit::Role, pos2, vec2,
};

use crate::app::state::queries::observer::SpeedCorrection;
use crate::app::views::panes::{Pane, PaneTitle};
use crate::app::widgets::pane_title;
use crate::number_text;

/// Draws the corrected picture into `pane`.
pub fn show(ui: &Ui, pane: Pane, correction: &SpeedCorrection, picture: Option<&TextureHandle>) {
    let colour = ui.visuals().text_color();
    let by = if correction.is_fitted { "fitted" } else { "set" };
    let text = format!("Corrected by the {by} β {}", number_text::beta(&correction.speed));
    let rect = pane.rect;
    let below = vec2(0.0, rect.height() + pane.band);
    let named = if pane.title == PaneTitle::InBand { rect.translate(below) } else { rect };
    pane_title(ui, named, &text, colour);
    let painter = ui.painter();
    painter.rect_filled(rect, 0.0, ui.visuals().extreme_bg_color);
    if let Some(picture) = picture {
        let uv = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));
        painter.image(picture.id(), rect, uv, Color32::WHITE);
    }
    painter.rect_stroke(rect, 0.0, Stroke::new(1.5, colour), StrokeKind::Outside);
    let id = ui.scope_id().with("corrected view");
    let response = ui.interact(rect, id, Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Image, true, &text));
    response.on_hover_text(
        "The left eye's picture with the distortion undone: straight and in its own colours, as a camera \
            that rides along would take it at this event, provided that this β is right.\nDirections \
            de-aberrated, λ × D, intensity / Dⁿ, D = 1/(γ(1 + β nₓ))\nWhile the Fit tab is shown, β is the \
            fitted one. The darker part lies outside the eye's picture.",
    );
}
