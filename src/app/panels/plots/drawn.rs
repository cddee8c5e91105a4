//! A curve as the plots over T draw it.

use eframe::egui::Visuals;
use egui_plot::{Line, LineStyle, PlotPoint, PlotUi, Points};

use super::chart::{Dash, Trace};

impl Dash {
    /// Returns the toolkit's style of the line.
    pub fn style(self) -> LineStyle {
        match self {
            Self::Solid => LineStyle::Solid,
            Self::Dashed(length) => LineStyle::Dashed { length: f32::from(length) },
            Self::Dotted => LineStyle::dotted_dense(),
        }
    }
}

impl<'a> Trace<'a> {
    /// Draws the trace, T being `now`.
    pub fn draw(&self, plot: &mut PlotUi<'a>, visuals: &Visuals, now: f64) {
        let (width, colour) = (if self.wide { 2.0 } else { 1.2 }, self.colour(visuals));
        for piece in self.pieces {
            // Bands would draw steep parts of a densely sampled curve thinner than the rest.
            let line = Line::new(self.name.clone(), piece.as_slice()).allow_band(false).allow_hover(false);
            plot.line(line.color(colour).width(width).style(self.dash.style()));
        }
        if let Some(value) = self.drawn_at(now).filter(|_| self.dot) {
            let dot = Points::new("now", vec![[now, value]]).color(colour).radius(4.0);
            plot.points(dot.allow_hover(false));
        }
    }

    /// Returns the value drawn at `time`; `None` where there is none.
    pub fn drawn_at(&self, time: f64) -> Option<f64> {
        self.pieces.iter().find_map(|piece| value_at(piece, time))
    }
}

/// Linear interpolation in a drawn curve, so that the dot lies on it; `None` outside it.
fn value_at(points: &[PlotPoint], time: f64) -> Option<f64> {
    let after = points.partition_point(|point| point.x < time);
    let (b, a) = (points.get(after)?, points.get(after.checked_sub(1)?)?);
    Some(if b.x > a.x { a.y + (b.y - a.y) * (time - a.x) / (b.x - a.x) } else { b.y })
}
