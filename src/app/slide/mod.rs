//! The slide, drawn into conformal views: motion moves the resting picture back by the rapidity.
//!
//! A ruler along the lower edge is marked in rapidity, the spectrum above it stands still while what moves passes through, and
//! an outline shows where a resting body would be seen.

mod columns;
pub mod panorama;
mod resting;
mod ruler;
mod sliding_view;
mod spectrum;

use eframe::egui::{Painter, Ui};

use super::panes::EyePane;
use super::state::State;
use super::theme;

use columns::HEIGHT;
use sliding_view::SlidingView;

/// The height of the ruler and the spectrum in `pane`, points; `None` where they are not shown.
#[must_use]
pub fn ruler_height(ui: &Ui, state: &State, pane: EyePane) -> Option<f32> {
    let scale = theme::text_scale(ui.style());
    let is_shown = state.settings.window.ruler
        && pane.rect.height() >= scale * ruler::LEAST_VIEW
        && SlidingView::new(state, state.view(pane.eye, pane.size)).is_some();
    is_shown.then_some(scale * HEIGHT)
}

/// Draws into `pane` what is switched on.
pub fn paint(ui: &Ui, painter: &Painter, state: &State, pane: EyePane) {
    let Some(slide) = SlidingView::new(state, state.view(pane.eye, pane.size)) else { return };
    if state.settings.window.resting {
        resting::paint(painter, state, pane, &slide, theme::text_scale(ui.style()));
    }
    if ruler_height(ui, state, pane).is_some() {
        ruler::paint(ui, painter, state, pane, &slide);
    }
}
