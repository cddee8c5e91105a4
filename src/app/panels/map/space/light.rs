//! How light of the selected point comes to the eyes: the rays that arrive at T, the fronts that they belong to, and
//! fronts of light that left at regular times, which grow while time runs.

use eframe::egui::{Color32, Painter, Pos2, Shape, Stroke, Ui};
use glam::DVec3;

use super::{Sheet, canvas};
use crate::app::observer::Eye;
use crate::app::state::State;
use crate::app::theme;
use crate::map::{Event, Front, Projection, Ray, Worldline, fronts, rays};
use crate::plot::round_step;

/// Fronts that follow each other while light comes from where the point passes.
const FRONTS_ON_THE_WAY: f64 = 3.0;
/// Length of the arrow on a ray, points.
const ARROW: f32 = 8.0;

/// Draws it.
pub(super) fn paint(ui: &Ui, painter: &Painter, state: &State, sheet: &Sheet) {
    let (settings, time) = (&state.settings, state.session.time);
    let (track, frame) = (state.session.points.selected().track, settings.frame());
    let Ok(rays) = rays(settings, &track, time, frame) else { return };
    let worldline = Worldline::new(settings, &track, frame);
    let light = Light { painter, sheet, across: worldline.across() };
    let now = Event { x: 0.0, t: time }.in_frame(frame).t;
    let faint = ui.visuals().weak_text_color().gamma_multiply(0.35);
    for front in fronts(&worldline, now, period(state, &worldline)) {
        light.front(&front, Stroke::new(1.0, faint));
    }
    for (eye, ray) in Eye::BOTH.into_iter().zip(rays) {
        let colour = theme::eye_colour(eye, ui.visuals());
        light.front(&ray.front(), Stroke::new(1.2, colour.gamma_multiply(0.8)));
        light.ray(&ray, colour);
    }
}

/// The time from one front to the next, round in the unit that is shown.
fn period(state: &State, worldline: &Worldline) -> f64 {
    let unit = state.measures().time;
    let [y, z] = worldline.across();
    let distance = relativity_core::math::hypot(y, z).max(1.0);
    unit.in_scene(round_step(unit.shown(distance / FRONTS_ON_THE_WAY)))
}

/// What is drawn on.
struct Light<'a> {
    painter: &'a Painter,
    sheet: &'a Sheet,
    /// y and z of the point.
    across: [f64; 2],
}

impl Light<'_> {
    /// Where an event is whose y and z are these.
    fn place(&self, event: Event, [y, z]: [f64; 2]) -> Pos2 {
        canvas::place(&self.sheet.chart, self.sheet.projection.flat(DVec3::new(event.x, y, z)))
    }

    /// The circle in which a front meets the plane of the eyes, in which it reaches them.
    fn front(&self, front: &Front, stroke: Stroke) {
        let [y, z] = self.across;
        let from_plane = match self.sheet.projection {
            Projection::Plan => z,
            Projection::Side => y,
        };
        let Some(radius) = front.radius_in_plane(from_plane.abs()) else { return };
        let radius = (radius * self.sheet.chart.scale) as f32;
        self.painter.circle_stroke(self.place(front.left, self.across), radius, stroke);
    }

    /// The way of the light, with an arrow in the middle.
    fn ray(&self, ray: &Ray, colour: Color32) {
        let ends = [self.place(ray.left, self.across), self.place(ray.received, [0.0; 2])];
        self.painter.line_segment(ends, Stroke::new(1.2, colour));
        let along = (ends[1] - ends[0]).normalized();
        let tip = ends[0].lerp(ends[1], 0.5) + 0.5 * ARROW * along;
        let (back, aside) = (tip - ARROW * along, 0.4 * ARROW * along.rot90());
        let arrow = vec![tip, back + aside, back - aside];
        self.painter.add(Shape::convex_polygon(arrow, colour, Stroke::NONE));
    }
}
