//! The slide, drawn into conformal views: motion moves the resting picture back by the rapidity.
//!
//! An outline in the picture shows where a resting body would be seen. The band below the picture has a
//! ruler, and the spectrum above its ticks, which stands still while what moves passes.

mod columns;
pub mod panorama;
mod resting;
mod ruler;
mod sliding_view;
mod spectrum;

use eframe::egui::{Align2, Color32, Painter, Rect, TextStyle, Ui, pos2};

use crate::app::state::State;
use crate::app::views::panes::{EyePane, PaneTitle};
use crate::app::widgets::theme;

use columns::PixelColumns;
use sliding_view::SlidingView;

/// Draws the resting outline into `pane` if it is switched on.
pub fn paint_resting(ui: &Ui, painter: &Painter, state: &State, pane: EyePane) {
    if !state.document.settings.window.resting {
        return;
    }
    if let Some(slide) = SlidingView::new(state, &state.view(pane.eye, pane.size)) {
        resting::paint(painter, state, pane, &slide, theme::text_scale(ui.style()));
    }
}

/// Draws the band below the picture in `pane`: the spectrum and the ruler, and before an audience the name of
/// one of several pictures, in the `colour` of its eye.
pub fn paint_band(ui: &Ui, state: &State, pane: EyePane, name: &str, colour: Color32) {
    if pane.band <= 0.0 {
        return;
    }
    let is_named = pane.title == PaneTitle::InBand;
    let room = PixelColumns::parts(pane)[1];
    let title = is_named.then(|| paint_title(ui, room, name, colour));
    let slide = SlidingView::new(state, &state.view(pane.eye, pane.size));
    if let Some(slide) = slide.filter(|_| state.document.settings.window.ruler) {
        let columns = PixelColumns::new(pane, &slide, theme::text_scale(ui.style()));
        ruler::paint(ui, state, pane, &slide, &columns, title);
    }
}

/// Writes the name of a picture at the left end of the `room` for ticks, and returns its place.
fn paint_title(ui: &Ui, room: Rect, name: &str, colour: Color32) -> Rect {
    let radius = 0.3 * room.height();
    let painter = ui.painter().with_clip_rect(room);
    painter.circle_filled(pos2(room.min.x + 2.0 * radius, room.center().y), radius, colour);
    let text = pos2(room.min.x + 4.0 * radius, room.center().y);
    let font = TextStyle::Small.resolve(ui.style());
    let place = painter.text(text, Align2::LEFT_CENTER, name, font, ui.visuals().text_color());
    room.with_max_x(place.max.x)
}
