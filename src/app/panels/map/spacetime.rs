//! Spacetime: x against t.

use eframe::egui::{Rect, Ui};

use crate::app::panels::Asks;
use crate::app::state::State;

/// Shows it in `rect`.
pub fn show(ui: &mut Ui, _state: &State, rect: Rect, _asks: &mut Asks) {
    ui.painter().rect_filled(rect, 0.0, ui.visuals().extreme_bg_color);
}
