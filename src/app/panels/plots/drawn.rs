//! A curve as the plots over T draw it.

use eframe::egui::{Color32, Visuals};
use egui_plot::{Line, LineStyle, PlotPoint, PlotResponse, PlotUi, Points};

use super::chart::Trace;
use crate::plot::{Dash, LabelPlaces};

/// Returns the toolkit's style of a line with these dashes.
pub(super) fn style(dash: Dash) -> LineStyle {
    match dash {
        Dash::Solid => LineStyle::Solid,
        Dash::Dashed(length) => LineStyle::Dashed { length: f32::from(length) },
        Dash::Dotted => LineStyle::dotted_dense(),
    }
}

/// Returns the colour in the notation of CSS: `#RRGGBB`.
pub(super) fn css(colour: Color32) -> String {
    let [r, g, b, _] = colour.to_srgba_unmultiplied();
    format!("#{r:02X}{g:02X}{b:02X}")
}

/// The weight of a dot among what labels should not cover.
const DOT: f32 = 12.0;

impl<'a> Trace<'a> {
    /// Draws the trace, T being `now`.
    pub fn draw(&self, plot: &mut PlotUi<'a>, visuals: &Visuals, now: f64) {
        let (width, colour) = (self.width(), self.colour(visuals));
        for piece in self.pieces {
            // Bands would draw steep parts of a densely sampled curve thinner than the rest.
            let line = Line::new(self.name.clone(), piece.as_slice()).allow_band(false).allow_hover(false);
            plot.line(line.color(colour).width(width).style(style(self.dash)));
        }
        if let Some(value) = self.drawn_at(now).filter(|_| self.dot) {
            let dot = Points::new("now", vec![[now, value]]).color(colour).radius(4.0);
            plot.points(dot.allow_hover(false));
        }
    }

    /// Has `labels` in the plot avoid the trace, T being `now`.
    pub fn keep_clear(&self, labels: &mut LabelPlaces, response: &PlotResponse<()>, now: f64) {
        let place = |point: &PlotPoint| response.transform.position_from_point(point);
        for piece in self.pieces {
            labels.avoid(piece.iter().map(place), 1.0);
        }
        if let Some(value) = self.drawn_at(now).filter(|_| self.dot) {
            labels.avoid([place(&[now, value].into())], DOT);
        }
    }

    /// Returns the value drawn at `time`; `None` where there is none.
    fn drawn_at(&self, time: f64) -> Option<f64> {
        self.pieces.iter().find_map(|piece| value_at(piece, time))
    }
}

/// Linear interpolation in a drawn curve, so that the dot lies on it; `None` outside it.
fn value_at(points: &[PlotPoint], time: f64) -> Option<f64> {
    let after = points.partition_point(|point| point.x < time);
    let (b, a) = (points.get(after)?, points.get(after.checked_sub(1)?)?);
    Some(if b.x > a.x { a.y + (b.y - a.y) * (time - a.x) / (b.x - a.x) } else { b.y })
}
