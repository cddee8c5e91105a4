//! Markers at the places where an eye sees the followed points, and their clocks.

use eframe::egui::{Color32, Painter, Pos2, Rect, Stroke, TextStyle, Ui, Vec2, vec2};
use relativity_render::{Motion, PreparedScene, View};

use crate::app::state::State;
use crate::app::state::points::Point;
use crate::app::views::dial::{self, DialPlacement};
use crate::app::views::layouts;
use crate::app::views::panes::EyePane;
use crate::app::widgets::{label_below, theme};
use crate::eye::Eye;
use crate::flags::choices::Form;

/// Radius of the marker of the selected point.
const LARGEST_RING: f32 = 6.0;

/// A coat of a marker's paint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coat {
    /// The halo that sets markers off from the picture.
    Halo,
    /// The markers themselves, and the clocks.
    Ring,
}

pub fn markers(ui: &Ui, painter: &Painter, state: &State, pane: EyePane, coat: Coat) {
    let view = state.view(pane.eye, pane.size);
    let (scene, visuals) = (&state.document.prepared, ui.visuals());
    for (index, point) in state.document.points.all().iter().enumerate() {
        let Some(marker) = Marker::new(state, point, &view, scene, pane.eye) else { continue };
        let radius = if index == state.document.points.selected_index() { LARGEST_RING } else { 4.5 };
        let place = pane.place(marker.pixel);
        if coat == Coat::Halo {
            let halo = Stroke::new(4.0, layouts::halo_colour(state, visuals));
            painter.circle_stroke(place, radius, halo);
            continue;
        }
        // Two clocks in one place could not be read.
        if pane.rect.contains(place) && can_be_read(state, pane) {
            clock(ui, state, pane, point, place);
        }
        let own = theme::point_colour(point.number, visuals);
        let [ring, dot] =
            if pane.is_shared { layouts::marker_colours(state, pane.eye, own, visuals) } else { [own; 2] };
        marker.paint(painter, place, radius, [ring, dot]);
        if pane.rect.contains(place) && can_be_read(state, pane) {
            distance(ui, painter, state, pane, point, place);
        }
    }
    if coat == Coat::Ring && can_be_read(state, pane) {
        dial::show_resting(ui, state, pane.eye, pane.rect);
    }
}

/// Returns the places in `pane` of what is marked there, with the clocks beside it: of every followed point
/// in the picture.
pub fn marked(state: &State, pane: EyePane) -> Vec<Rect> {
    let camera = state.view(pane.eye, pane.size).camera;
    let points = state.document.points.all().iter();
    let directions = points.filter_map(|point| Some((point, state.direction(point, pane.eye)?)));
    let places = directions.filter_map(|(point, direction)| {
        let place = pane.place(camera.pixel(direction)?);
        let is_inside = place.is_finite() && pane.rect.contains(place);
        is_inside.then(|| {
            let ring = Rect::from_center_size(place, Vec2::splat(2.0 * LARGEST_RING));
            let has_clock = state.dial(point, pane.eye).is_some();
            let with_clock = if has_clock {
                ring.union(dial::place(place, pane.rect, farther(state, pane, place)))
            } else {
                ring
            };
            let has_distance = state.document.settings.window.distances;
            if has_distance { with_clock.union(below(place)) } else { with_clock }
        })
    });
    places.collect()
}

/// Room below a marker at `place` for its distance.
fn below(place: Pos2) -> Rect {
    Rect::from_min_size(place + vec2(-70.0, 0.0), vec2(140.0, 2.0 * BELOW_MARKER + 8.0))
}

/// Whether a clock in `pane` does not stand where the other eye's does.
fn can_be_read(state: &State, pane: EyePane) -> bool {
    pane.takes_the_mouse() || state.document.settings.picture.layout.form() == Form::InTurn
}

/// The clock at `point`, which is marked at this `place`.
fn clock(ui: &Ui, state: &State, pane: EyePane, point: &Point, place: Pos2) {
    let Some(dial) = state.dial(point, pane.eye) else { return };
    let colour = theme::point_colour(point.number, ui.visuals());
    let drawn =
        DialPlacement { marker: place, view: pane.rect, farther: farther(state, pane, place), colour };
    let name = format!("Clock of {}, {}", state.name_of(point), pane.eye.name());
    dial::show(ui, dial, drawn, &name, dial::tip(state.measures().time, point.track.spin.is_some()));
}

/// Returns the distance, beyond the usual one, of a clock in `pane` from its marker at this `place` at which
/// it covers no moving body, points.
fn farther(state: &State, pane: EyePane, place: Pos2) -> f32 {
    let (view, scene) = (state.view(pane.eye, pane.size), &state.document.prepared);
    // In the published model no ray leads back from the right eye.
    let can_look = !state.sees_as_published(pane.eye);
    dial::farther(place, pane.rect, |place| {
        let hit = || scene.first_hit(&view, view.camera.line_of_sight(pane.pixel(place)));
        can_look && hit().is_some_and(|hit| scene.motion_of(hit.body) == Motion::Scene)
    })
}

/// Writes the seen distance of the point below its marker at `place`, if distances are switched on.
fn distance(ui: &Ui, painter: &Painter, state: &State, pane: EyePane, point: &Point, place: Pos2) {
    let is_on = state.document.settings.window.distances && state.shows_what_is_received(pane.eye);
    let Some(seen) = state.sighting(point, pane.eye).filter(|_| is_on) else { return };
    let away = state.measures().length.text(seen.distance, DISTANCE_DECIMALS);
    let text = format!("seen {away} away");
    let galley = painter.layout_no_wrap(text, TextStyle::Body.resolve(ui.style()), Color32::WHITE);
    label_below(painter, place + vec2(0.0, BELOW_MARKER), galley, pane.rect.shrink(6.0));
}

/// Decimals of the distance of a marked point in the scene's unit, and how far below it that is written.
const DISTANCE_DECIMALS: u8 = 1;
const BELOW_MARKER: f32 = 12.0;

/// A marker at the place where an eye sees a followed point.
struct Marker {
    pixel: [f64; 2],
    hidden: bool,
}

/// A surface this much nearer than the point, in parts of its distance, hides it. A picked point lies
/// on its surface only up to rounding.
const HIDING_MARGIN: f64 = 1e-4;

impl Marker {
    fn new(state: &State, point: &Point, view: &View, scene: &PreparedScene, eye: Eye) -> Option<Self> {
        let direction = state.direction(point, eye)?;
        let pixel = view.camera.pixel(direction)?;
        // In the published model no ray leads back from the right eye, so nothing is known to hide it.
        let seen_along_rays = !state.sees_as_published(eye);
        let first = direction.try_normalize().filter(|_| seen_along_rays);
        let first = first.and_then(|line_of_sight| scene.first_hit(view, line_of_sight));
        let hidden = first.is_some_and(|hit| hit.distance < direction.length() * (1.0 - HIDING_MARGIN));
        pixel.iter().all(|value| value.is_finite()).then_some(Self { pixel, hidden })
    }

    /// A ring, filled in the middle where the point is in sight and hollow where it is hidden.
    fn paint(&self, painter: &Painter, place: Pos2, radius: f32, [ring, dot]: [Color32; 2]) {
        painter.circle_stroke(place, radius, Stroke::new(2.0, ring));
        if !self.hidden {
            painter.circle_filled(place, 2.0, dot);
        }
    }
}
