//! The panel of the lesson under way: the present place, its text and question, and the way on.

mod cards;
mod end;
mod foot;
mod form;
mod head;
mod notes;
mod observed;
mod page;
pub mod presented;
mod shown;

use eframe::egui::{self, StrokeKind, Ui, UiBuilder, vec2};

pub use page::what_is_shown;

use super::Commands;
use crate::app::state::State;
use crate::app::widgets::{self, fitted, theme};

/// Sizes of most writing, points: as large as fits.
const SIZES: [f32; 2] = [theme::BODY_SIZE, 12.0];
/// Space between the border of the panel and what is in it.
const AROUND: egui::Vec2 = vec2(14.0, 10.0);
/// Part of the page that a lecturer's notes take while there is a projector's window.
const NOTES_SHARE: f32 = 0.45;
/// Height of the buttons below the page.
const FOOT_HEIGHT: f32 = 74.0;

/// Shows the panel, or the strip that it is folded to.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let Some(running) = &state.session.lesson else { return };
    let rect = ui.max_rect();
    let visuals = ui.visuals();
    let line = visuals.widgets.noninteractive.bg_stroke;
    ui.painter().rect(rect, 8.0, visuals.window_fill, line, StrokeKind::Inside);
    if running.is_folded {
        let inside = rect.shrink2(vec2(4.0, AROUND.y));
        ui.scope_builder(UiBuilder::new().max_rect(inside), |ui| head::folded(ui, &running.course, commands));
        return;
    }
    let inside = rect.shrink2(AROUND.min(0.1 * rect.size()));
    ui.scope_builder(UiBuilder::new().max_rect(inside), |ui| {
        head::show(ui, &running.course, commands);
        ui.add_space(8.0);
        let page = ui.available_rect_before_wrap();
        let foot_height = FOOT_HEIGHT.min(0.5 * page.height()).max(0.0);
        let page = page.with_max_y(page.max.y - foot_height);
        let foot = inside.with_min_y(page.max.y);
        let has_notes = state.session.stage.projector;
        let notes = page.with_min_y(page.max.y - if has_notes { NOTES_SHARE * page.height() } else { 0.0 });
        let page = page.with_max_y(notes.min.y);
        ui.scope_builder(UiBuilder::new().id_salt("page").max_rect(page), |ui| {
            widgets::read_out(ui.ctx(), ui.unique_id());
            fitted::show(ui, what_is_shown(running), SIZES, |ui| page::show(ui, state, running, commands));
        });
        if has_notes {
            ui.scope_builder(UiBuilder::new().id_salt("notes").max_rect(notes), |ui| {
                fitted::show(ui, what_is_shown(running), SIZES, |ui| notes::show(ui, running));
            });
        }
        ui.scope_builder(UiBuilder::new().id_salt("foot").max_rect(foot), |ui| {
            foot::show(ui, state, running, commands);
        });
    });
}
