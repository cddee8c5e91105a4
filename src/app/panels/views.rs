//! What the two eyes see, side by side: pictures, markers of the followed points, and the mouse in
//! them.

use eframe::egui::{
    self, Align2, Color32, CursorIcon, Painter, Pos2, Rect, Response, Sense, Stroke, StrokeKind, TextStyle,
    TextureId, Ui, pos2, vec2,
};
use relativity_core::math;
use relativity_render::{Colour, Geometry, Method, PreparedScene, View};

use super::Asks;
use crate::app::command::{Command, Pick, Turn, Zoom};
use crate::app::dial::{self, Drawn};
use crate::app::eyes::Shown;
use crate::app::observer::Eye;
use crate::app::points::Point;
use crate::app::state::State;
use crate::app::widgets::pane_title;
use crate::app::{beyond, theme, under};
use crate::caption;
use crate::figures;

/// Zoom per point of scrolling.
const ZOOM_PER_SCROLL: f64 = 0.002;

/// Where an eye's picture is on screen, and how many pixels it has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EyePane {
    /// Whose.
    pub eye: Eye,
    /// In points; its edges lie on pixel edges, so that the picture is shown pixel for pixel.
    pub rect: Rect,
    /// Width and height in pixels, at least 1.
    pub size: [u32; 2],
}

impl EyePane {
    /// The pane of `eye` in `rect`, its picture being at most `largest` pixels wide or high.
    #[must_use]
    pub fn new(eye: Eye, rect: Rect, pixels_per_point: f32, largest: u32) -> Self {
        let snapped = |p: Pos2| (p.to_vec2() * pixels_per_point).round();
        let (min, max) = (snapped(rect.min), snapped(rect.max));
        let size = [max.x - min.x, max.y - min.y].map(|side| (side as u32).clamp(1, largest));
        let rect = Rect::from_min_max((min / pixels_per_point).to_pos2(), (max / pixels_per_point).to_pos2());
        Self { eye, rect, size }
    }

    fn pixel(&self, place: Pos2) -> [f64; 2] {
        let inside = (place - self.rect.min) / self.rect.size();
        [f64::from(inside.x) * f64::from(self.size[0]), f64::from(inside.y) * f64::from(self.size[1])]
    }

    /// Where a pixel of the picture is on screen.
    #[must_use]
    pub fn place(&self, [u, v]: [f64; 2]) -> Pos2 {
        let fraction = vec2((u / f64::from(self.size[0])) as f32, (v / f64::from(self.size[1])) as f32);
        self.rect.min + fraction * self.rect.size()
    }
}

/// Reads the mouse in `pane`.
pub fn interact(ui: &mut Ui, pane: EyePane, asks: &mut Asks) {
    let id = ui.scope_id().with(("view", pane.eye.index()));
    let response = ui.interact(pane.rect, id, Sense::click_and_drag()).on_hover_cursor(CursorIcon::Crosshair);
    let name = format!("{} view", pane.eye.name());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, &name));
    if response.double_clicked() {
        asks.push(Command::Frame);
    } else if let (true, Some(place)) = (response.clicked(), response.interact_pointer_pos()) {
        let add = ui.input(|input| input.modifiers.shift);
        asks.push(Command::Pick(Pick { eye: pane.eye, pixel: pane.pixel(place), size: pane.size, add }));
    }
    turn(&response, pane, asks);
    if response.hovered() {
        let scroll = f64::from(ui.input(|input| input.smooth_scroll_delta().y));
        let pinch = f64::from(ui.input(egui::InputState::zoom_delta));
        let factor = math::exp(-scroll * ZOOM_PER_SCROLL) / pinch;
        if factor != 1.0 && factor.is_finite() {
            let place = response.hover_pos().unwrap_or(pane.rect.center());
            asks.push(Command::Zoom(Zoom {
                eye: pane.eye,
                pixel: pane.pixel(place),
                size: pane.size,
                factor,
            }));
        }
    }
}

/// The scene follows the pointer: what is under it when a drag starts stays there.
fn turn(response: &Response, pane: EyePane, asks: &mut Asks) {
    let moved = response.drag_delta();
    let Some(place) = response.interact_pointer_pos().filter(|_| response.dragged()) else { return };
    if moved != egui::Vec2::ZERO {
        let [from, to] = [place - moved, place].map(|place| pane.pixel(place));
        asks.push(Command::Turn(Turn { eye: pane.eye, from, to, size: pane.size }));
    }
}

/// Draws `pane`: its picture and `heat_map` if there is one, the markers on it, title and frame.
pub fn paint(ui: &Ui, state: &State, pane: EyePane, picture: Option<Shown>, heat_map: Option<TextureId>) {
    let visuals = ui.visuals();
    let colour = theme::eye_colour(pane.eye, visuals);
    let painter = ui.painter();
    pane_title(ui, pane.rect, pane.eye.name(), colour);
    painter.rect_filled(pane.rect, 0.0, visuals.extreme_bg_color);
    for texture in picture.map(|picture| picture.texture).into_iter().chain(heat_map) {
        let uv = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        painter.image(texture, pane.rect, uv, Color32::WHITE);
    }
    let inside = painter.with_clip_rect(pane.rect);
    markers(ui, &inside, state, pane);
    beyond::paint(ui, &inside, pane.rect, &state.beyond(pane.eye, pane.size));
    write(ui, &inside, pane, Align2::LEFT_BOTTOM, note(state, pane.eye, picture, heat_map.is_some()));
    write(ui, &inside, pane, Align2::LEFT_TOP, unseen(ui, state, pane).unwrap_or_default());
    painter.rect_stroke(pane.rect, 0.0, Stroke::new(1.5, colour), StrokeKind::Outside);
    let pointer = under::pointer(ui, state, pane.rect);
    let under = pointer.and_then(|place| Some((place, state.under(pane.eye, pane.pixel(place), pane.size)?)));
    if let Some((place, under)) = under {
        under::show(ui, pane.rect, place, &under);
    }
}

/// What the picture is, where that is not what an eye would see, drawn exactly.
fn note(state: &State, eye: Eye, picture: Option<Shown>, with_heat_map: bool) -> String {
    let geometry = match state.settings.geometry() {
        Geometry::Seen | Geometry::Published => None,
        Geometry::OneCone => Some("one light cone for both eyes".to_owned()),
        Geometry::Contracted => Some("contracted only".to_owned()),
        Geometry::Rest => Some("at rest".to_owned()),
    };
    let model = state.sees_as_published(eye).then(|| "as published".to_owned());
    let colour = (state.settings.light.colour == Colour::False).then(|| "false colour".to_owned());
    let chosen = state.settings.quality.method();
    let method =
        picture.map(|picture| picture.method).filter(|&drawn| drawn != Method::Exact || drawn != chosen);
    let method = method.map(|drawn| match drawn {
        Method::Exact => "exact, until the reference is done".to_owned(),
        Method::Mesh { bound_px } => format!("mesh within {} px", figures::trimmed(bound_px, 3)),
        Method::Reference => "reference".to_owned(),
    });
    let heat_map = with_heat_map.then(|| "difference to the reference".to_owned());
    [geometry, model, colour, method, heat_map].into_iter().flatten().collect::<Vec<_>>().join("  ·  ")
}

/// Why something in the picture is dark that shines.
fn unseen(ui: &Ui, state: &State, pane: EyePane) -> Option<String> {
    let appearance = state.appearance(!ui.visuals().dark_mode);
    caption::notice(&state.session.prepared.received_shares(&state.view(pane.eye, pane.size), &appearance))
}

/// Writes `text` into a corner of the picture.
fn write(ui: &Ui, painter: &Painter, pane: EyePane, corner: Align2, text: String) {
    let font = TextStyle::Small.resolve(ui.style());
    let galley = painter.layout(text, font, Color32::WHITE, (pane.rect.width() - 24.0).max(1.0));
    let place = corner.align_size_within_rect(galley.size(), pane.rect.shrink(8.0));
    if galley.size().x > 0.0 {
        painter.rect_filled(place.expand2(vec2(5.0, 2.0)), 3.0, Color32::from_black_alpha(150));
        painter.galley(place.min, galley, Color32::WHITE);
    }
}

fn markers(ui: &Ui, painter: &Painter, state: &State, pane: EyePane) {
    let view = state.view(pane.eye, pane.size);
    let (scene, visuals) = (&state.session.prepared, ui.visuals());
    for (index, point) in state.session.points.all().iter().enumerate() {
        let Some(marker) = Marker::of(state, point, &view, scene, pane.eye) else { continue };
        let radius = if index == state.session.points.selected_index() { 6.0 } else { 4.5 };
        let (place, colour) = (pane.place(marker.pixel), theme::point_colour(point.number, visuals));
        if pane.rect.contains(place) {
            clock(ui, state, pane, point, place);
        }
        marker.paint(painter, place, radius, colour, theme::halo_colour(visuals));
    }
}

/// The clock at `point`, which is marked at this `place`.
fn clock(ui: &Ui, state: &State, pane: EyePane, point: &Point, place: Pos2) {
    let Some(dial) = state.dial(point, pane.eye) else { return };
    let colour = theme::point_colour(point.number, ui.visuals());
    let drawn = Drawn { marker: place, view: pane.rect, colour };
    let name = format!("Clock of point {}, {}", point.number, pane.eye.name());
    dial::show(ui, dial, drawn, &name, dial::tip(state.measures().time));
}

/// Where an eye sees a followed point.
struct Marker {
    pixel: [f64; 2],
    hidden: bool,
}

/// A surface this much nearer than the point, in parts of its distance, hides it. A picked point lies
/// on its surface only up to rounding.
const HIDING_MARGIN: f64 = 1e-4;

impl Marker {
    fn of(state: &State, point: &Point, view: &View, scene: &PreparedScene, eye: Eye) -> Option<Self> {
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
    fn paint(&self, painter: &Painter, place: Pos2, radius: f32, colour: Color32, halo: Color32) {
        painter.circle_stroke(place, radius, Stroke::new(4.0, halo));
        painter.circle_stroke(place, radius, Stroke::new(2.0, colour));
        if !self.hidden {
            painter.circle_filled(place, 2.0, colour);
        }
    }
}
