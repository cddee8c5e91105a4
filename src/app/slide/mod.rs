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

pub use columns::HEIGHT;
use sliding_view::SlidingView;

/// Whether the ruler stands in `pane`.
#[must_use]
pub fn has_ruler(state: &State, pane: EyePane) -> bool {
    state.settings.window.ruler
        && pane.rect.height() >= ruler::LEAST_VIEW
        && SlidingView::new(state, state.view(pane.eye, pane.size)).is_some()
}

/// Draws into `pane` what is switched on.
pub fn paint(ui: &Ui, painter: &Painter, state: &State, pane: EyePane) {
    let Some(slide) = SlidingView::new(state, state.view(pane.eye, pane.size)) else { return };
    if state.settings.window.resting {
        resting::paint(painter, state, pane, &slide);
    }
    if has_ruler(state, pane) {
        ruler::paint(ui, painter, state, pane, &slide);
    }
}
