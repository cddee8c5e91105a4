//! What an audience is told below the views: the speed, so large that the last row reads it, and what is shown and why.

use eframe::egui::accesskit::Role;
use eframe::egui::text::LayoutJob;
use eframe::egui::{self, Align2, Color32, FontId, Rect, Sense, Ui};

use crate::app::state::State;
use crate::app::theme;
use crate::figures;

/// Largest and smallest sizes of the speed and of the caption at the usual scale of writing, points.
const SPEED_SIZES: [f32; 2] = [44.0, 12.0];
const CAPTION_SIZES: [f32; 2] = [17.0, 7.0]; // 11.2 for an audience
/// From one size that is tried to the next.
const STEP: f32 = 0.92;

/// Shows the speed.
pub fn speed(ui: &Ui, state: &State) {
    let speed = state.speed();
    let beta = figures::beta(&speed);
    let text = match state.measures().speed(&speed) {
        Some(speed) => format!("β = {beta}   {speed}"),
        None => format!("β = {beta}"),
    };
    write(ui, &text, SPEED_SIZES, ui.visuals().strong_text_color());
}

/// Shows what the preset shows and why.
pub fn caption(ui: &Ui, state: &State) {
    let Some(preset) = state.session.preset else { return };
    write(ui, &format!("{}. {}", preset.title, preset.caption), CAPTION_SIZES, ui.visuals().text_color());
}

/// Writes `text` into all the room there is, as large as it fits.
fn write(ui: &Ui, text: &str, [largest, smallest]: [f32; 2], colour: Color32) {
    let room = ui.max_rect();
    let scale = theme::text_scale(ui.style());
    let laid_out = |size: f32| {
        let font = FontId::proportional(scale * size);
        ui.painter().layout_job(LayoutJob::simple(text.to_owned(), font, colour, room.width()))
    };
    let sizes =
        std::iter::successors(Some(largest), |size| Some(size * STEP).filter(|size| *size > smallest));
    let fits = |size: &f32| laid_out(*size).size().y <= room.height();
    let galley = laid_out(sizes.into_iter().find(fits).unwrap_or(smallest));
    let place: Rect = Align2::LEFT_CENTER.anchor_size(room.left_center(), galley.size());
    ui.painter().galley(place.min, galley, colour);
    let response = ui.interact(room, ui.scope_id().with("text"), Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Label, true, text));
}
