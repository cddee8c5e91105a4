//! The resting picture: where all that moves would be seen by a camera that rides along, and the arrow by
//! which motion slides it.

use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Shape as Drawing, Stroke, pos2, vec2};
use glam::DVec3;
use relativity_render::geometry::shape::strokes::Onlooker;
use relativity_render::{Body, GroupView, MaterialPoint, Motion};

use super::sliding_view::{SlidingView, points_per_px};
use crate::app::state::State;
use crate::app::views::panes::EyePane;
use crate::app::widgets::theme;
use crate::number_text;

/// At most this many bodies are outlined; larger scenes are strided.
const MOST_BODIES: usize = 600;
const COLOUR: Color32 = Color32::from_rgb(255, 224, 130);
/// Length of the arrow's head, points.
const HEAD: f32 = 10.0;

/// Draws both into `pane`, for each group that moves, where writing is `scale` times as large as by default.
pub fn paint(painter: &Painter, state: &State, pane: EyePane, slide: &SlidingView, scale: f32) {
    let scene = &state.document.scene;
    let stride = scene.bodies.len().div_ceil(MOST_BODIES).max(1);
    let mut named_above = false;
    for group in &scene.groups {
        let velocity = state.document.settings.velocity(group.motion);
        if velocity.beta() == 0.0 {
            continue;
        }
        let seen = Resting { slide, group: slide.view.of_group(group.motion), pane, scale };
        for body in scene.bodies[group.bodies()].iter().step_by(stride) {
            seen.paint_outline(painter, body);
        }
        let anchor =
            anchor(state, group.motion).or_else(|| scene.bodies.get(group.bodies().start).map(place_on));
        let shift = slide.shift(&velocity);
        if let Some(from) = anchor.and_then(|point| seen.place(seen.group.place_when_shown(point))) {
            let name = format!(
                "{} = artanh {}",
                number_text::fixed(velocity.speed.rapidity(), 3),
                number_text::beta(&velocity.speed)
            );
            // Names of arrows that lie together stand on both sides.
            named_above = !named_above;
            seen.paint_arrow(painter, from, shift, &name, named_above);
        }
    }
}

/// The selected point, if it moves so.
fn anchor(state: &State, motion: Motion) -> Option<MaterialPoint> {
    let point = state.document.points.selected();
    (point.track.motion == motion).then(|| point.track.point())
}

/// A place on the outline of `body`; the middle of one whose outline depends on who looks.
fn place_on(body: &Body) -> MaterialPoint {
    let on_stroke = body.strokes().first().map(|stroke| stroke.path.at(0.0));
    let rest = on_stroke.unwrap_or_else(|| body.shape.ball_around().0.into());
    MaterialPoint { rest, spin: body.spin }
}

/// The view of a group as if it rested, from the same event.
struct Resting<'a> {
    slide: &'a SlidingView,
    group: GroupView,
    pane: EyePane,
    scale: f32,
}

impl Resting<'_> {
    /// Returns the place on the screen at which `rest` of the group would be seen, points.
    fn place(&self, rest: DVec3) -> Option<Pos2> {
        let mercator = &self.slide.mercator;
        let coordinates = mercator.coordinates(rest - self.group.origin)?;
        let place = self.pane.place(mercator.place_of(coordinates));
        let limit = self.pane.rect.expand(4.0 * self.pane.rect.width());
        limit.contains(place).then_some(place)
    }

    fn paint_outline(&self, painter: &Painter, body: &Body) {
        let stroke = Stroke::new(1.0, COLOUR.gamma_multiply(0.75));
        let shown = |rest| self.place(self.group.place_when_shown(MaterialPoint { rest, spin: body.spin }));
        let silhouette = body.silhouette(|_| Onlooker::At(self.group.origin));
        for path in body.strokes().into_iter().chain(silhouette).map(|stroke| stroke.path) {
            let parts = 4 * path.parts();
            let at = |part| path.at(f64::from(part) / f64::from(parts));
            if let Some(places) = (0..=parts).map(|part| shown(at(part))).collect() {
                painter.add(Drawing::line(places, stroke));
            }
        }
    }

    /// The arrow from where something would be seen at rest to where it is seen.
    fn paint_arrow(&self, painter: &Painter, from: Pos2, shift: f64, name: &str, is_above: bool) {
        let per_unit = self.slide.mercator.px_per_unit as f32 * points_per_px(self.pane).x;
        let to = pos2(from.x + shift as f32 * per_unit, from.y);
        if (to.x - from.x).abs() < 1.0 {
            return;
        }
        for stroke in [Stroke::new(4.0, Color32::from_black_alpha(150)), Stroke::new(2.0, COLOUR)] {
            painter.line_segment([from, to], stroke);
        }
        let back = HEAD * (from.x - to.x).signum();
        let head = vec![to, to + vec2(back, -0.5 * HEAD), to + vec2(back, 0.5 * HEAD)];
        painter.add(Drawing::convex_polygon(head, COLOUR, Stroke::new(1.0, Color32::from_black_alpha(150))));
        let shown = self.pane.rect.x_range();
        let ends = [from.x, to.x].map(|x| shown.clamp(x));
        let font = FontId::proportional(self.scale * theme::SMALL_SIZE);
        let galley = painter.layout_no_wrap(format!("η = {name}"), font, COLOUR);
        let middle = 0.5 * (ends[0] + ends[1]);
        let place = if is_above {
            Align2::CENTER_BOTTOM.anchor_size(pos2(middle, from.y - 5.0), galley.size())
        } else {
            Align2::CENTER_TOP.anchor_size(pos2(middle, from.y + 7.0), galley.size())
        };
        painter.rect_filled(place.expand2(vec2(4.0, 1.0)), 3.0, Color32::from_black_alpha(150));
        painter.galley(place.min, galley, COLOUR);
    }
}
