//! The thing under the pointer: its name, its place and its time; a click selects it.

use eframe::egui::{Painter, Pos2, Response, Stroke, Ui};
use glam::DVec3;

use super::light::ChartLight;
use super::sheet::{SpaceSheet, colour};
use crate::app::commands::PointsCommand;
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::app::state::pointer::Select;
use crate::eye::Eye;
use crate::map::{BodyPicture, MapInstant, Nearest, OutlineLines, PointWorldline};
use crate::quantity::Quantity;
use crate::scene::Track;
use crate::settings::MapFrame;

/// Distance up to which the pointer counts as near, points.
const REACH: f64 = 9.0;

/// Describes what is near the pointer, and turns clicks there into commands.
pub(super) fn read(
    ui: &Ui,
    painter: &Painter,
    response: &Response,
    state: &State,
    lines: &OutlineLines,
    sheet: &SpaceSheet,
    commands: &mut Commands,
) {
    let Some(pointer) = response.hover_pos().or(response.interact_pointer_pos()) else { return };
    let Some(nearest) = nearest(lines, sheet, pointer) else {
        if let Some(text) = eye_told(state, sheet, pointer)
            .or_else(|| ChartLight::new(state, sheet)?.hover_text(state, pointer))
        {
            response.clone().on_hover_text_at_pointer(text);
        }
        return;
    };
    let place = sheet.on_screen(nearest.vertex.place);
    painter.circle_stroke(place, 6.0, Stroke::new(1.5, colour(nearest.line.picture, ui.visuals())));
    let body = nearest.line.body;
    let Some(track) = state.document.scene.track_at(nearest.surface.to_array(), body) else { return };
    if response.clicked() {
        let add = ui.input(|input| input.modifiers.shift);
        commands.push(PointsCommand::Choose(Select { track, body, add }).into());
    }
    response.clone().on_hover_text_at_pointer(text(state, &nearest, &track));
}

fn nearest<'a>(lines: &'a OutlineLines, sheet: &SpaceSheet, pointer: Pos2) -> Option<Nearest<'a>> {
    let pointer = [f64::from(pointer.x), f64::from(pointer.y)];
    lines.nearest((sheet.projection, &sheet.chart), pointer, REACH)
}

/// Describes the eye at `pointer`: its place, and the time when it receives light.
fn eye_told(state: &State, sheet: &SpaceSheet, pointer: Pos2) -> Option<String> {
    let now = state.document.time;
    let eyes = MapInstant::new(&state.document.settings, now).eyes();
    let far = |at: DVec3| sheet.on_screen(at).distance(pointer);
    let nearest = Eye::BOTH.into_iter().zip(eyes).min_by(|(_, a), (_, b)| far(*a).total_cmp(&far(*b)));
    let (eye, at) = nearest.filter(|&(_, at)| f64::from(far(at)) <= REACH)?;
    let received = time_text(state, state.clock().received.name, now);
    Some(format!("{}\n{}\n{received}", eye.name(), place_text(state, at)))
}

/// Describes the nearest thing: its name, its place, and its time.
fn text(state: &State, nearest: &Nearest, track: &Track) -> String {
    let line = nearest.line;
    let name = state.document.scene.name_of(line.body);
    let what = if line.rests { "at rest on the ground" } else { line.picture.words() };
    [format!("{name}, {what}"), place_text(state, nearest.vertex.place)]
        .into_iter()
        .chain(times(state, line.picture, track))
        .collect::<Vec<_>>()
        .join("\n")
}

fn place_text(state: &State, place: DVec3) -> String {
    let length = state.measures().length;
    let [x, y, z] = place.to_array().map(|value| length.number(value, 3));
    format!("x = {x},  y = {y},  z = {z}{}", length.suffix())
}

fn time_text(state: &State, name: &str, value: f64) -> String {
    format!("{name} = {}", state.measures().time.text(value, 3))
}

/// When it is there, as far as that is one event.
fn times(state: &State, picture: BodyPicture, track: &Track) -> Vec<String> {
    let time = |name: &str, value: f64| time_text(state, name, value);
    let now = state.document.time;
    let (frame, street) = (state.document.settings.frame(now), state.rider().street_time);
    match (picture, state.document.settings.map_frame()) {
        (BodyPicture::Seen(eye), MapFrame::Ground | MapFrame::Rider) => {
            let Ok(both) = state.document.settings.disparity(track, now) else { return Vec::new() };
            let seen = [both.primary, both.secondary][eye];
            let times = [now, seen.retarded_time, seen.proper_time];
            state.clock().names().into_iter().zip(times).map(|(name, value)| time(name, value)).collect()
        }
        (BodyPicture::Measured, MapFrame::Ground) => {
            let own = PointWorldline::new(&state.document.settings, track, frame).proper_time(street);
            vec![time("now t", street), time(Quantity::ProperTime.row().name, own)]
        }
        (BodyPicture::Measured, MapFrame::Rider) => vec![time("now, by my clock", now)],
        // On board all clocks agree.
        (BodyPicture::Measured, MapFrame::Bicycle) => {
            vec![time(Quantity::ProperTime.row().name, frame.event_at([0.0; 3], now).t)]
        }
        // From two events, each with times of its own.
        (BodyPicture::Stereo, _) => vec![time(state.clock().received.name, now)],
        (BodyPicture::Seen(_), MapFrame::Bicycle) => Vec::new(),
    }
}
