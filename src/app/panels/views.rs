//! The views of the two eyes, side by side: pictures, markers of the followed points, and the mouse in
//! them.

use std::sync::Arc;

use eframe::egui::{
    self, Align2, Color32, CursorIcon, Event, EventFilter, Galley, Key, Painter, Pos2, Rect, Response, Sense,
    Stroke, StrokeKind, TextStyle, TextureId, Ui, pos2, vec2,
};
use relativity_core::math;
use relativity_render::{Camera, Colour, Geometry, Method, PreparedScene, Projection, StreetColours, View};

use super::Commands;
use crate::app::command::{Command, GazeCommand, LOOK_STEP};
use crate::app::lesson::predicted_place;
use crate::app::measuring::angle_ruler::{Lay, RulerCommand};
use crate::app::measuring::laid_ruler;
use crate::app::pointer::{Pick, Turn, Zoom};
use crate::app::state::State;
use crate::app::state::points::Point;
use crate::app::views::dial::{self, DialPlacement};
use crate::app::views::eyes::ShownPicture;
use crate::app::views::highlight;
use crate::app::views::hover;
use crate::app::views::layouts;
use crate::app::views::offscreen_arrows;
use crate::app::views::panes::EyePane;
use crate::app::views::slide;
use crate::app::widgets::pane_title;
use crate::app::{awake, theme};
use crate::caption;
use crate::eye::Eye;
use crate::flags::choices::Form;
use crate::number_text;
use crate::settings::Light;

/// Zoom per point of scrolling.
const ZOOM_PER_SCROLL: f64 = 0.002;

/// The pictures painted in an eye's pane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Painted {
    /// Picture of the scene.
    pub picture: Option<ShownPicture>,
    /// Heat map of its error, if it is shown.
    pub heat_map: Option<TextureId>,
}

/// Reads the mouse in `pane`, which assistive technology calls by this `name`.
pub fn interact(ui: &mut Ui, state: &State, pane: EyePane, name: &str, commands: &mut Commands) {
    let id = ui.scope_id().with(("view", pane.eye.index()));
    let response = ui.interact(pane.rect, id, Sense::click_and_drag()).on_hover_cursor(CursorIcon::Crosshair);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, name));
    let describe = |node: &mut egui::accesskit::Node| node.set_description(state.moment().sentence());
    ui.ctx().accesskit_node_builder(response.id, describe);
    if response.double_clicked() {
        commands.push(Command::Gaze(GazeCommand::WholeAgain));
    } else if response.triple_clicked() {
        // It is a double click that went on.
    } else if let (true, Some(place)) = (response.clicked(), response.interact_pointer_pos()) {
        let add = ui.input(|input| input.modifiers.shift);
        let EyePane { eye, is_second, size, .. } = pane;
        commands.push(Command::Pick(Pick { eye, is_second, pixel: pane.pixel(place), size, add }));
    }
    if response.has_focus() {
        keys(ui, &response, commands);
    }
    if state.scratch.angle_ruler.takes_drags() {
        measure(ui, &response, pane, commands);
    } else {
        turn(&response, pane, commands);
    }
    if response.hovered() {
        let scroll = f64::from(ui.input(|input| input.smooth_scroll_delta().y));
        let pinch = f64::from(ui.input(egui::InputState::zoom_delta));
        let factor = math::exp(-scroll * ZOOM_PER_SCROLL) / pinch;
        if factor != 1.0 && factor.is_finite() {
            let place = response.hover_pos().unwrap_or(pane.rect.center());
            commands.push(Command::Gaze(GazeCommand::Zoom(Zoom {
                eye: pane.eye,
                is_second: pane.is_second,
                pixel: pane.pixel(place),
                size: pane.size,
                factor,
            })));
        }
    }
}

/// Performs the keys of the view that has the keyboard focus.
fn keys(ui: &Ui, response: &Response, commands: &mut Commands) {
    let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
    let pressed = |event: &Event| match event {
        Event::Key { key, pressed: true, modifiers, .. } => command_of(*key, modifiers.shift),
        _ => None,
    };
    commands.extend(ui.input(|input| input.events.iter().filter_map(pressed).collect::<Vec<_>>()));
}

fn command_of(key: Key, with_shift: bool) -> Option<Command> {
    match key {
        Key::ArrowLeft => Some(Command::Gaze(GazeCommand::Aside([-LOOK_STEP, 0.0]))),
        Key::ArrowRight => Some(Command::Gaze(GazeCommand::Aside([LOOK_STEP, 0.0]))),
        Key::ArrowUp => Some(Command::Gaze(GazeCommand::Aside([0.0, LOOK_STEP]))),
        Key::ArrowDown => Some(Command::Gaze(GazeCommand::Aside([0.0, -LOOK_STEP]))),
        Key::Enter => Some(Command::FollowNext(if with_shift { -1 } else { 1 })),
        Key::Space => Some(Command::TogglePlaying),
        _ => None,
    }
}

/// The scene follows the pointer: what is under it when a drag starts stays there.
fn turn(response: &Response, pane: EyePane, commands: &mut Commands) {
    let moved = response.drag_delta();
    let Some(place) = response.interact_pointer_pos().filter(|_| response.dragged()) else { return };
    if moved != egui::Vec2::ZERO {
        let [from, to] = [place - moved, place].map(|place| pane.pixel(place));
        let EyePane { eye, is_second, size, .. } = pane;
        commands.push(Command::Gaze(GazeCommand::Turn(Turn { eye, is_second, from, to, size })));
    }
}

/// A drag lays a ruler.
fn measure(ui: &Ui, response: &Response, pane: EyePane, commands: &mut Commands) {
    let from = ui.input(|input| input.pointer.press_origin());
    let to = response.interact_pointer_pos();
    if let Some((from, to)) = from.zip(to).filter(|_| response.dragged()) {
        let EyePane { eye, is_second, size, .. } = pane;
        let ends = [from, to].map(|place| pane.pixel(place));
        commands.push(Command::Ruler(RulerCommand::Lay(Lay { eye, is_second, ends, size })));
    }
    if response.drag_stopped() {
        commands.push(Command::Ruler(RulerCommand::Settle));
    }
}

/// Draws `pane`: what is `painted` there, the markers on it, its `title` and frame.
pub fn paint(ui: &Ui, state: &State, pane: EyePane, title: &str, painted: Painted) {
    let Painted { picture, heat_map } = painted;
    let colour = theme::eye_colour(pane.eye, ui.visuals());
    pane_title(ui, pane.rect, title, colour);
    ui.painter().rect_filled(pane.rect, 0.0, ui.visuals().extreme_bg_color);
    for texture in picture.map(|picture| picture.texture).into_iter().chain(heat_map) {
        image(ui, pane.rect, texture);
    }
    state.scratch.comfort.paint(ui.painter(), pane.rect);
    let inside = ui.painter().with_clip_rect(pane.rect);
    for coat in [Coat::Halo, Coat::Ring] {
        markers(ui, &inside, state, pane, coat);
    }
    predicted_place::paint(ui, &inside, state, pane);
    laid_ruler::paint(ui, &inside, state, pane);
    words(ui, state, pane, note(state, pane.eye, picture, heat_map.is_some()));
    ui.painter().rect_stroke(pane.rect, 0.0, Stroke::new(1.5, colour), StrokeKind::Outside);
    hover(ui, state, pane);
    missed(ui, state, pane);
}

/// Draws `pane` with nothing but its `picture` in it: what is written beside it would be in each eye's at another place.
pub fn paint_bare(ui: &Ui, state: &State, pane: EyePane, picture: Option<ShownPicture>) {
    let id = ui.scope_id().with(("lens", pane.eye.index()));
    let response = ui.interact(pane.rect, id, Sense::hover());
    let name = format!("{} through its lens", pane.eye.name());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, &name));
    if let Some(ShownPicture { texture, .. }) = picture {
        image(ui, pane.rect, texture);
    }
    state.scratch.comfort.paint(ui.painter(), pane.rect);
}

/// Draws the one `picture` of both eyes, whose `panes` are in it in the order of the layout, or of the one whose turn it is;
/// over each its heat map, if there is one.
pub fn paint_both(
    ui: &Ui,
    state: &State,
    panes: &[EyePane],
    picture: Option<ShownPicture>,
    heat_maps: &[Option<TextureId>],
) {
    let colour = ui.visuals().text_color();
    let rect = panes.iter().map(|pane| pane.rect).reduce(Rect::union).unwrap_or(Rect::NOTHING);
    pane_title(ui, rect, &layouts::title(&state.document.settings.picture), colour);
    ui.painter().rect_filled(rect, 0.0, ui.visuals().extreme_bg_color);
    if let Some(ShownPicture { texture, .. }) = picture {
        image(ui, rect, texture);
    }
    for (pane, heat_map) in panes.iter().zip(heat_maps) {
        if let Some(texture) = *heat_map {
            image(ui, pane.rect, texture);
        }
        state.scratch.comfort.paint(ui.painter(), pane.rect);
    }
    // All halos first: markers that the eyes see in one place would hide each other.
    for coat in [Coat::Halo, Coat::Ring] {
        for &pane in panes {
            markers(ui, &ui.painter().with_clip_rect(pane.rect), state, pane, coat);
        }
    }
    for &pane in panes {
        let inside = ui.painter().with_clip_rect(pane.rect);
        predicted_place::paint(ui, &inside, state, pane);
        laid_ruler::paint(ui, &inside, state, pane);
    }
    for (&pane, heat_map) in panes.iter().zip(heat_maps) {
        if pane.takes_the_mouse() || panes.len() == 1 {
            words(ui, state, pane, note(state, pane.eye, picture, heat_map.is_some()));
            missed(ui, state, pane);
        }
    }
    ui.painter().rect_stroke(rect, 0.0, Stroke::new(1.5, colour), StrokeKind::Outside);
    // Where both are in one place, the left eye tells what is under the pointer, as it takes the clicks.
    let told = |pane: &EyePane| if pane.is_shared { EyePane { eye: Eye::Left, ..*pane } } else { *pane };
    let pointed = panes.iter().find(|pane| hover::pointer(ui, state, pane.rect).is_some());
    if let Some(pane) = pointed.map(told) {
        hover(ui, state, pane);
    }
}

fn image(ui: &Ui, rect: Rect, texture: TextureId) {
    let uv = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
    ui.painter().image(texture, rect, uv, Color32::WHITE);
}

/// Says in the picture of `pane` what is beyond it, what it is, and why a part of it is dark.
fn words(ui: &Ui, state: &State, pane: EyePane, note: String) {
    let inside = ui.painter().with_clip_rect(pane.rect);
    let ruler = slide::paint(ui, &inside, state, pane);
    let pane = EyePane { rect: pane.rect.with_max_y(pane.rect.max.y - ruler), ..pane };
    offscreen_arrows::paint(ui, &inside, pane.rect, &state.offscreen_arrows(pane.eye, pane.size));
    let note = write(ui, &inside, pane, Align2::LEFT_BOTTOM, note);
    let handlebar = handlebar(ui, &inside, state, pane);
    // Beside the instruments, where they are.
    let beside = if handlebar.is_positive() { handlebar.min.x } else { pane.rect.max.x };
    let free = EyePane { rect: pane.rect.with_max_x(beside), ..pane };
    let unseen = write(ui, &inside, free, Align2::LEFT_TOP, unseen(ui, state, pane).unwrap_or_default());
    let hint = predicted_place::hint(state)
        .or_else(|| laid_ruler::hint(state))
        .or_else(|| newcomers_hint(ui, state));
    if let Some(hint) = hint.filter(|_| pane.takes_the_mouse()) {
        let corner = free_corner(ui, &inside, pane, &hint, [note, unseen, handlebar]);
        let place = write(ui, &inside, pane, corner, hint.clone());
        let response = ui.interact(place, ui.scope_id().with(("hint", pane.eye.index())), Sense::hover());
        response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Label, true, &hint));
    }
}

/// The greatest part of a picture's height that the instruments cover.
const SHARE_OF_INSTRUMENTS: f32 = 0.35;

/// Writes the instruments of who rides into the corner of the picture, as many as have room; where that is.
fn handlebar(ui: &Ui, painter: &Painter, state: &State, pane: EyePane) -> Rect {
    let Some(lines) = state.instruments() else { return Rect::ZERO };
    let line = ui.text_style_height(&TextStyle::Small);
    let room = (SHARE_OF_INSTRUMENTS * pane.rect.height() / line) as usize;
    let shown = lines[..room.clamp(1, lines.len())].join("\n");
    let instruments = lines.join("\n");
    let place = write(ui, painter, pane, Align2::RIGHT_TOP, shown);
    let response = ui.interact(place, ui.scope_id().with(("handlebar", pane.eye.index())), Sense::hover());
    response.widget_info(|| {
        egui::WidgetInfo::labeled(
            egui::accesskit::Role::Label,
            true,
            format!("{}, instruments: {instruments}", pane.eye.name()),
        )
    });
    place
}

/// Tells what is under the pointer in `pane`.
fn hover(ui: &Ui, state: &State, pane: EyePane) {
    let pointer = hover::pointer(ui, state, pane.rect);
    let hovered =
        pointer.and_then(|place| Some((place, state.hovered(pane.eye, pane.pixel(place), pane.size)?)));
    if let Some((place, hovered)) = hovered {
        let outline = state.outline_of(hovered.body, pane.eye, hovered.pixel, pane.size);
        highlight::paint(&ui.painter().with_clip_rect(pane.rect), pane, &outline);
        hover::show(ui, pane.rect, place, &hovered);
    }
}

/// Says where a click into `pane` hit nothing.
fn missed(ui: &Ui, state: &State, pane: EyePane) {
    if let Some(missed) =
        state.scratch.missed.filter(|missed| (missed.eye, missed.is_second) == (pane.eye, pane.is_second))
    {
        hover::show_nothing(ui, pane.rect, pane.place(missed.pixel));
    }
}

/// Returns a note on the picture, where it is not what an eye would see, drawn exactly.
fn note(state: &State, eye: Eye, picture: Option<ShownPicture>, with_heat_map: bool) -> String {
    let geometry = match state.document.settings.geometry() {
        Geometry::Seen | Geometry::Published => None,
        Geometry::OneCone => Some("one light cone for both eyes".to_owned()),
        Geometry::Contracted => Some("contracted only".to_owned()),
        Geometry::Rest => Some("at rest".to_owned()),
    };
    let projection = projection_note(&state.view(eye, state.frame.picture_size).camera);
    let model = state.sees_as_published(eye).then(|| "as published".to_owned());
    let colour =
        colour_note(&state.document.settings.light, state.document.settings.geometry()).map(str::to_owned);
    let method = picture.and_then(|picture| drawn_by(state, eye, picture.method));
    let heat_map = with_heat_map.then(|| "difference to the reference".to_owned());
    let street = street_note(state).map(str::to_owned);
    [geometry, model, projection, colour, street, method, heat_map]
        .into_iter()
        .flatten()
        .collect::<Vec<_>>()
        .join("  ·  ")
}

/// Names the light where it is not that of the bodies alone.
fn colour_note(light: &Light, geometry: Geometry) -> Option<&'static str> {
    let on_street = light.doppler_shift && geometry.has_doppler_effect();
    match light.colour {
        Colour::OneWavelength | Colour::Glowing => None,
        Colour::StreetDaylight if on_street => Some("lit by the street's daylight"),
        Colour::White | Colour::StreetDaylight => Some("daylight rides along"),
        Colour::False => Some("false colour"),
    }
}

/// Names the street's colours where they are not those that are received.
fn street_note(state: &State) -> Option<&'static str> {
    let settings = &state.document.settings;
    let Light { colour, street_colours, doppler_shift, .. } = settings.light;
    let is_seen = settings.ride.is_on() && settings.geometry().has_doppler_effect();
    match street_colours {
        _ if !is_seen || colour == Colour::False => None,
        StreetColours::Received => None,
        StreetColours::Shifted if doppler_shift => Some("street evenly bright"),
        StreetColours::Shifted | StreetColours::Painted => Some("street as painted"),
    }
}

/// Names the projection where a picture of another one would look different.
fn projection_note(camera: &Camera) -> Option<String> {
    let stretch = camera.stretch();
    let times = number_text::trimmed(stretch, 1);
    let note = match camera.projection {
        Projection::Mercator { .. } => "conformal".to_owned(),
        Projection::Gaze => format!("camera: corners stretched {times} times"),
        Projection::Parallel { .. } => format!("flat screens: corners stretched {times} times"),
        Projection::Vr180 { .. } => return None,
    };
    (stretch > NOTICEABLE_STRETCH).then_some(note)
}

/// The least stretch at which pictures of two projections look different.
const NOTICEABLE_STRETCH: f64 = 1.15;

/// Returns the method that has drawn the picture, where that was set or is further off than can be seen.
fn drawn_by(state: &State, eye: Eye, drawn: Method) -> Option<String> {
    let geometry = state.view(eye, state.frame.picture_size).geometry;
    let Some(set) = state.document.settings.quality.method() else {
        let choice = state.choice(geometry)?;
        return (choice.error_px > UNSEEN_PX || !choice.holds).then(|| format!("automatic: {choice}"));
    };
    match drawn {
        Method::Rays if set == Method::Rays => None,
        Method::Rays => Some("rays, until the reference is done".to_owned()),
        Method::Packets => Some("packets".to_owned()),
        Method::Mesh { bound_px } => Some(format!("mesh within {} px", number_text::trimmed(bound_px, 3))),
        Method::Reference => Some("reference".to_owned()),
    }
}

/// Greatest error that is not mentioned in the picture, pixels.
const UNSEEN_PX: f64 = 0.1;

/// Returns the note on light that eyes do not see.
fn unseen(ui: &Ui, state: &State, pane: EyePane) -> Option<String> {
    let appearance = state.appearance(!ui.visuals().dark_mode);
    let shares = state.document.prepared.received_shares(&state.view(pane.eye, pane.size), &appearance);
    caption::notice(&shares, state.document.settings.light.invisible)
}

/// The hint for newcomers in the views, and its duration in seconds.
const HINT: &str = "Click a point to follow it.";
const HINT_TIME: f64 = 12.0;

/// Returns the hint for a newcomer who has not clicked yet: for a while, and never before an audience.
fn newcomers_hint(ui: &Ui, state: &State) -> Option<String> {
    let is_shown = state.session.hint && !state.session.stage.is_presented();
    (is_shown && awake::is_new(ui.ctx(), HINT, HINT_TIME)).then(|| HINT.to_owned())
}

/// The first corner in which `text` covers none of the `others`.
fn free_corner(ui: &Ui, painter: &Painter, pane: EyePane, text: &str, others: [Rect; 3]) -> Align2 {
    const CORNERS: [Align2; 4] =
        [Align2::CENTER_BOTTOM, Align2::RIGHT_BOTTOM, Align2::RIGHT_TOP, Align2::CENTER_CENTER];
    let is_free = |corner: &Align2| {
        let place = written(ui, painter, pane, *corner, text.to_owned()).1.expand(6.0);
        others.iter().all(|other| !other.is_positive() || !other.expand(6.0).intersects(place))
    };
    CORNERS.into_iter().find(is_free).unwrap_or(Align2::CENTER_CENTER)
}

/// `text` laid out in a corner of the picture, and where that is.
fn written(ui: &Ui, painter: &Painter, pane: EyePane, corner: Align2, text: String) -> (Arc<Galley>, Rect) {
    let font = TextStyle::Small.resolve(ui.style());
    let galley = painter.layout(text, font, Color32::WHITE, (pane.rect.width() - 24.0).max(1.0));
    let place = corner.align_size_within_rect(galley.size(), pane.rect.shrink(8.0));
    (galley, place)
}

/// Writes `text` into a corner of the picture; where that is.
fn write(ui: &Ui, painter: &Painter, pane: EyePane, corner: Align2, text: String) -> Rect {
    let (galley, place) = written(ui, painter, pane, corner, text);
    if galley.size().x > 0.0 {
        painter.rect_filled(place.expand2(vec2(5.0, 2.0)), 3.0, Color32::from_black_alpha(150));
        painter.galley(place.min, galley, Color32::WHITE);
    }
    place
}

/// A coat of a marker's paint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Coat {
    /// The halo that sets markers off from the picture.
    Halo,
    /// The markers themselves, and the clocks.
    Ring,
}

fn markers(ui: &Ui, painter: &Painter, state: &State, pane: EyePane, coat: Coat) {
    let view = state.view(pane.eye, pane.size);
    let (scene, visuals) = (&state.document.prepared, ui.visuals());
    for (index, point) in state.document.points.all().iter().enumerate() {
        let Some(marker) = Marker::new(state, point, &view, scene, pane.eye) else { continue };
        let radius = if index == state.document.points.selected_index() { 6.0 } else { 4.5 };
        let place = pane.place(marker.pixel);
        if coat == Coat::Halo {
            Marker::paint_halo(painter, place, radius, layouts::halo_colour(state, visuals));
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
    }
    if coat == Coat::Ring && can_be_read(state, pane) {
        dial::show_resting(ui, state, pane.eye, pane.rect);
    }
}

/// Whether a clock in `pane` does not stand where the other eye's does.
fn can_be_read(state: &State, pane: EyePane) -> bool {
    pane.takes_the_mouse() || is_in_turn(state)
}

/// Whether the eyes are shown one after the other.
fn is_in_turn(state: &State) -> bool {
    state.document.settings.picture.layout.form() == Form::InTurn
}

/// The clock at `point`, which is marked at this `place`.
fn clock(ui: &Ui, state: &State, pane: EyePane, point: &Point, place: Pos2) {
    let Some(dial) = state.dial(point, pane.eye) else { return };
    let colour = theme::point_colour(point.number, ui.visuals());
    let drawn = DialPlacement { marker: place, view: pane.rect, colour };
    let name = format!("Clock of {}, {}", state.name_of(point), pane.eye.name());
    dial::show(ui, dial, drawn, &name, dial::tip(state.measures().time, point.track.spin.is_some()));
}

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

    fn paint_halo(painter: &Painter, place: Pos2, radius: f32, colour: Color32) {
        painter.circle_stroke(place, radius, Stroke::new(4.0, colour));
    }

    /// A ring, filled in the middle where the point is in sight and hollow where it is hidden.
    fn paint(&self, painter: &Painter, place: Pos2, radius: f32, [ring, dot]: [Color32; 2]) {
        painter.circle_stroke(place, radius, Stroke::new(2.0, ring));
        if !self.hidden {
            painter.circle_filled(place, 2.0, dot);
        }
    }
}

#[cfg(test)]
mod tests {

    use super::*;
    use crate::accuracy::Choice;
    use crate::flags::Goal;
    use crate::flags::choices::RendererChoice;
    use crate::scene::Scene;
    use crate::settings::Settings;

    /// The note appears where an error can be seen, and where a goal is not kept.
    #[test]
    fn a_view_says_what_automatic_quality_costs_it() {
        let mut state = State::new(Settings::default(), Scene::default());
        let mesh = Method::Mesh { bound_px: 0.5 };
        let (goal, is_measured) = (Goal::Budget(16.0), true);
        let choice = Choice { method: mesh, error_px: 0.5, ms: 4.0, is_measured, goal, holds: true };
        let said = |state: &mut State, choice: Choice| {
            state.frame.choices = vec![(Geometry::Seen, choice)];
            drawn_by(state, Eye::Left, choice.method)
        };
        assert_eq!(said(&mut state, choice).as_deref(), Some("automatic: mesh, 4.0 ms of 16, within 0.5 px"));
        let exact = Choice { method: Method::Packets, error_px: 0.002, ..choice };
        assert_eq!(said(&mut state, exact), None);
        let late = Choice { ms: 40.0, holds: false, ..exact };
        let expected = "automatic: packets, 40 ms, within 0.002 px; no method keeps 16 ms";
        assert_eq!(said(&mut state, late).as_deref(), Some(expected));
        // What is set is said unless it is the rays.
        state.document.settings.quality.renderer = RendererChoice::Packets;
        assert_eq!(drawn_by(&state, Eye::Left, Method::Packets).as_deref(), Some("packets"));
        state.document.settings.quality.renderer = RendererChoice::Rays;
        assert_eq!(drawn_by(&state, Eye::Left, Method::Rays), None);
        // The packets stand in for the rays where a device has no room for a scene's models.
        assert_eq!(drawn_by(&state, Eye::Left, Method::Packets).as_deref(), Some("packets"));
    }
}
