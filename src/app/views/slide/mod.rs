//! The slide, drawn into conformal views: motion moves the resting picture back by the rapidity.
//!
//! A ruler along the lower edge is marked in rapidity, the spectrum above it stands still while what moves
//! passes through, and an outline shows where a resting body would be seen.

mod columns;
pub mod panorama;
mod resting;
mod ruler;
mod sliding_view;
mod spectrum;

use eframe::egui::{Painter, Ui};

use crate::app::state::State;
use crate::app::views::panes::EyePane;
use crate::app::widgets::theme;

use columns::PixelColumns;
use sliding_view::SlidingView;

/// Draws into `pane` what is switched on, and returns the height of the ruler and the spectrum there, points.
pub fn paint(ui: &Ui, painter: &Painter, state: &State, pane: EyePane) -> f32 {
    let Some(slide) = SlidingView::new(state, &state.view(pane.eye, pane.size)) else { return 0.0 };
    let scale = theme::text_scale(ui.style());
    if state.document.settings.window.resting {
        resting::paint(painter, state, pane, &slide, scale);
    }
    if !state.document.settings.window.ruler || pane.rect.height() < scale * ruler::LEAST_VIEW {
        return 0.0;
    }
    let columns = PixelColumns::new(pane, &slide, scale);
    ruler::paint(ui, painter, state, pane, &slide, &columns);
    columns.rect.height()
}
