//! The columns of a view on the screen, counted in rapidity.

use eframe::egui::{Rect, pos2};

use super::sliding_view::{SlidingView, points_per_px};
use crate::app::views::panes::EyePane;

/// Height of the ruler and the spectrum above it where writing is of the default size, points.
const HEIGHT: f32 = 30.0;

/// The columns of a view on the screen.
#[derive(Debug, Clone, Copy)]
pub struct PixelColumns {
    /// The rectangle of the ruler and the spectrum above it.
    pub rect: Rect,
    /// x of u = 0 ahead, and points per unit of u; below 0 where the picture runs against the motion.
    zero: f64,
    pub per_unit: f64,
    /// Text size relative to the default.
    pub scale: f32,
}

impl PixelColumns {
    /// The columns of `pane`, where writing is `scale` times as large as by default.
    pub fn new(pane: EyePane, slide: &SlidingView, scale: f32) -> Self {
        let per_px = f64::from(points_per_px(pane).x);
        let rect = Rect::from_min_max(pos2(pane.rect.min.x, pane.rect.max.y - scale * HEIGHT), pane.rect.max);
        let zero = f64::from(rect.min.x) + slide.mercator.origin.x * per_px;
        Self { rect, zero, per_unit: slide.mercator.px_per_unit * per_px * slide.ahead, scale }
    }

    /// u along the motion at `x`.
    pub fn u(&self, x: f32) -> f64 {
        (f64::from(x) - self.zero) / self.per_unit
    }

    /// x of `u` along the motion.
    pub fn x(&self, u: f64) -> f32 {
        (self.zero + u * self.per_unit) as f32
    }
}
