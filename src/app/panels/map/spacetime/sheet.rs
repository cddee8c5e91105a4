//! The sheet that the parts of the face share: the diagram, and the place where it is drawn.

use eframe::egui::{Painter, Pos2, Rect, Ui};
use relativity_core::Event;

use crate::app::panels::map::canvas;
use crate::app::state::State;
use crate::app::state::points::Point;
use crate::map::{Chart, Diagram, StraightLine, along};

/// Distance from a line up to which the pointer counts as near, points.
pub const NEAR: f32 = 7.0;
/// Radius of the handle at the present, points.
pub const HANDLE: f32 = 8.0;

/// The diagram, and where it is drawn.
pub struct DiagramSheet<'a> {
    /// Interface that it is part of.
    pub ui: &'a Ui,
    /// Clipped to its room.
    pub painter: Painter,
    /// Chart that places events on screen.
    pub chart: Chart,
    /// State that is shown.
    pub state: &'a State,
    /// The events of the selected point.
    pub diagram: Diagram,
    /// The other followed points, and theirs.
    pub others: Vec<(&'a Point, Diagram)>,
}

impl DiagramSheet<'_> {
    /// Returns the place of an event on screen.
    pub fn place(&self, event: Event) -> Pos2 {
        canvas::place(&self.chart, [event.x, event.t])
    }

    /// The lowest and the highest x and t that are shown.
    pub fn corners(&self) -> [Event; 2] {
        let [[left, right], [first, last]] = self.chart.range();
        [Event { x: left, t: first }, Event { x: right, t: last }]
    }

    /// The room the sheet is drawn in.
    pub fn room(&self) -> Rect {
        canvas::rect(&self.chart)
    }

    /// The ground's times at which the worldline of a point is drawn.
    pub fn worldline_times(&self, diagram: &Diagram) -> Vec<f64> {
        let [low, high] = self.corners();
        diagram.times_within(low, high)
    }

    /// The ground's time at which the point's worldline comes nearest to `place`, and how far that is off in
    /// points.
    pub fn nearest_of_worldline(&self, place: Pos2) -> Option<(f64, f32)> {
        let to = [place.x, place.y].map(f64::from);
        let on_screen = |time: f64| {
            self.chart.screen({
                let Event { x, t } = self.diagram.point.at(time);
                [x, t]
            })
        };
        let times = self.worldline_times(&self.diagram);
        let pieces = times.windows(2).map(|ends| {
            let (part, off) = along(on_screen(ends[0]), on_screen(ends[1]), to);
            (ends[0] + part * (ends[1] - ends[0]), off as f32)
        });
        pieces.min_by(|(_, a), (_, b)| a.total_cmp(b))
    }

    /// The step of `line` at which it comes nearest to `place`, and how far that is off in points.
    pub fn nearest(&self, line: StraightLine, place: Pos2) -> (f64, f32) {
        let [x, t] = self.chart.world([place.x, place.y].map(f64::from));
        let Event { x: dx, t: dt } = line.step;
        let steps = ((x - line.through.x) * dx + (t - line.through.t) * dt) / (dx * dx + dt * dt);
        (steps, self.place(line.at(steps)).distance(place))
    }
}
