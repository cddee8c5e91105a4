//! A tab of two parts: a table on the right, and plots on the left where there is room for them, or above.

use eframe::egui::{Rect, Ui, UiBuilder, pos2};

use crate::app::widgets::theme;

/// Height of the plots where they stand above the table, as a share of both, and least height of both.
const SHARE_ABOVE: f32 = 0.55;
const LEAST_TOGETHER: f32 = 170.0;

/// The table and the plots inside `area`: in one that leaves the plots beside the table less than
/// `least_plots` they stand above it, and in one that is low as well there is the table alone.
pub fn table_and_plots(area: Rect, table_width: f32, least_plots: f32) -> (Rect, Option<Rect>) {
    let split = area.max.x - table_width;
    let plots = Rect::from_min_max(area.min, pos2(split - theme::GAP, area.max.y));
    if plots.width() >= least_plots {
        return (area.with_min_x(split), Some(plots));
    }
    if area.height() < LEAST_TOGETHER {
        return (area, None);
    }
    let middle = area.min.y + SHARE_ABOVE * area.height();
    (area.with_min_y(middle), Some(area.with_max_y(middle - theme::GAP)))
}

/// Shows `contents` inside `rect`.
pub fn part(ui: &mut Ui, name: &str, rect: Rect, contents: impl FnOnce(&mut Ui)) {
    ui.scope_builder(UiBuilder::new().id_salt(name).max_rect(rect), |ui| {
        ui.set_clip_rect(rect.intersect(ui.clip_rect()));
        contents(ui);
    });
}
