//! Rectangles cut into parts.

use eframe::egui::{Rect, pos2, vec2};

use crate::app::widgets::theme::GAP;

/// Returns `rect`, unless it is too small for anything to be shown in it.
pub(in crate::app) fn large_enough(rect: Rect) -> Option<Rect> {
    let shrunk = rect.shrink(GAP / 2.0);
    (shrunk.width() >= 40.0 && shrunk.height() >= 40.0).then_some(shrunk)
}

/// Returns the upper part of `rect` with this `height`, and the rest.
pub(in crate::app) fn split_top(rect: Rect, height: f32) -> (Rect, Rect) {
    let y = rect.min.y + height.clamp(0.0, rect.height().max(0.0));
    (Rect::from_min_max(rect.min, pos2(rect.max.x, y)), Rect::from_min_max(pos2(rect.min.x, y), rect.max))
}

/// Returns the part on the left of `rect` with this `width`, and the rest.
pub(in crate::app) fn split_left(rect: Rect, width: f32) -> (Rect, Rect) {
    let x = rect.min.x + width;
    (Rect::from_min_max(rect.min, pos2(x, rect.max.y)), Rect::from_min_max(pos2(x, rect.min.y), rect.max))
}

/// Returns the rest of `rect`, and its part on the right with this `width`.
pub(in crate::app) fn split_right(rect: Rect, width: f32) -> (Rect, Option<Rect>) {
    let x = rect.max.x - width;
    (
        Rect::from_min_max(rect.min, pos2(x, rect.max.y)),
        Some(Rect::from_min_size(pos2(x, rect.min.y), vec2(width, rect.height()))),
    )
}
