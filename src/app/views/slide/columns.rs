//! The columns of a view on the screen, counted in rapidity.

use eframe::egui::Rect;

use super::sliding_view::{SlidingView, points_per_px};
use crate::app::views::panes::EyePane;

/// Shares of the band's height that the spectrum has, the ticks having the rest: in the window, where Doppler
/// factors are named in it, and before an audience.
const SPECTRUM_SHARE: f32 = 0.4;
const SPECTRUM_SHARE_FOR_AUDIENCE: f32 = 0.3;
/// Space between the picture and the spectrum, points: the picture's frame.
const FRAME: f32 = 1.5;

/// The columns of a view on the screen.
#[derive(Debug, Clone, Copy)]
pub struct PixelColumns {
    /// Place of the spectrum.
    pub strip: Rect,
    /// Place of the ticks below it.
    pub ticks: Rect,
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
        let [strip, ticks] = Self::parts(pane);
        let zero = f64::from(pane.rect.min.x) + slide.mercator.origin.x * per_px;
        Self { strip, ticks, zero, per_unit: slide.mercator.px_per_unit * per_px * slide.ahead, scale }
    }

    /// The places of the spectrum and of the ticks in the band of `pane`.
    pub fn parts(pane: EyePane) -> [Rect; 2] {
        let band = pane.band_rect();
        let is_in_window = pane.is_in_window();
        let share = if is_in_window { SPECTRUM_SHARE } else { SPECTRUM_SHARE_FOR_AUDIENCE };
        let middle = band.min.y + share * band.height();
        let top = (band.min.y + FRAME).min(middle);
        [band.with_min_y(top).with_max_y(middle), band.with_min_y(middle)]
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
