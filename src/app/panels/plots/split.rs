//! A tab of two parts: a table on the right, and plots on the left where there is room for them.

use eframe::egui::{Rect, Ui, UiBuilder, pos2};

use crate::app::widgets::theme;

/// The table and the plots inside `area`: in one that leaves the plots less than `least_plots` there is the
/// table alone.
pub fn table_and_plots(area: Rect, table_width: f32, least_plots: f32) -> (Rect, Option<Rect>) {
    let split = area.max.x - table_width;
    let plots = Rect::from_min_max(area.min, pos2(split - theme::GAP, area.max.y));
    if plots.width() < least_plots {
        return (area, None);
    }
    (Rect::from_min_max(pos2(split, area.min.y), area.max), Some(plots))
}

/// Shows `contents` inside `rect`.
pub fn part(ui: &mut Ui, name: &str, rect: Rect, contents: impl FnOnce(&mut Ui)) {
    ui.scope_builder(UiBuilder::new().id_salt(name).max_rect(rect), |ui| {
        ui.set_clip_rect(rect.intersect(ui.clip_rect()));
        contents(ui);
    });
}
