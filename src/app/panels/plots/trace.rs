//! A curve as the plots over T draw it.

use eframe::egui::Color32;
use egui_plot::{Line, LineStyle, PlotPoint, PlotUi, Points};
use relativity_core::Model;

use crate::app::state::State;

/// What curves are called that are not the exact ones, and these beside them.
pub(super) const ONE_CONE: &str = "one light cone";
const TWO_CONES: &str = "two light cones (exact)";

/// A curve to draw.
pub(super) struct Trace<'a> {
    pub name: String,
    pub points: &'a [PlotPoint],
    pub colour: Color32,
    pub style: LineStyle,
    pub wide: bool,
    /// Whether a dot shows where it is at T.
    pub dot: bool,
}

impl<'a> Trace<'a> {
    /// A curve in the model of what the views show, or where that is another, the exact one beside it.
    pub fn of_model(
        name: String,
        points: &'a [PlotPoint],
        colour: Color32,
        state: &State,
        is_exact_beside: bool,
    ) -> Self {
        let (name, style) = match (state.settings.shown_model(), is_exact_beside) {
            (_, true) => (format!("{name}, {TWO_CONES}"), LineStyle::dotted_dense()),
            (Model::OneCone, false) => (format!("{name}, {ONE_CONE}"), LineStyle::Solid),
            (Model::Published(_), false) => (format!("{name}, published"), LineStyle::Solid),
            (Model::Exact, false) => (name, LineStyle::Solid),
        };
        Self { name, points, colour, style, wide: !is_exact_beside, dot: !is_exact_beside }
    }

    /// Draws it, T being `now`.
    pub fn draw(self, plot: &mut PlotUi<'a>, now: f64) {
        let width = if self.wide { 2.0 } else { 1.2 };
        // Bands would draw steep parts of a densely sampled curve thinner than the rest.
        let line = Line::new(self.name, self.points).allow_band(false);
        plot.line(line.color(self.colour).width(width).style(self.style));
        if let (true, Some(value)) = (self.dot, value_at(self.points, now)) {
            let dot = Points::new("now", vec![[now, value]]).color(self.colour).radius(4.0);
            plot.points(dot.allow_hover(false));
        }
    }
}

/// Linear interpolation in a drawn curve, so that the dot lies on it; `None` outside it.
fn value_at(points: &[PlotPoint], time: f64) -> Option<f64> {
    let after = points.partition_point(|point| point.x < time);
    let (b, a) = (points.get(after)?, points.get(after.checked_sub(1)?)?);
    Some(if b.x > a.x { a.y + (b.y - a.y) * (time - a.x) / (b.x - a.x) } else { b.y })
}
