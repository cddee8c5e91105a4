//! What is under the pointer: its name, where it is and when; a click selects it.

use eframe::egui::{Painter, Pos2, Response, Stroke, Ui};

use super::{Sheet, canvas, colour, light};
use crate::app::command::{Command, Select};
use crate::app::panels::Asks;
use crate::app::state::State;
use crate::figures;
use crate::map::{Lines, Nearest, Picture};
use crate::scene::Track;
use crate::settings::Frame;

/// How near the pointer has to be, points.
const REACH: f64 = 9.0;

/// Reads it.
pub(super) fn read(
    ui: &Ui,
    painter: &Painter,
    response: &Response,
    state: &State,
    lines: &Lines,
    sheet: &Sheet,
    asks: &mut Asks,
) {
    let Some(pointer) = response.hover_pos().or(response.interact_pointer_pos()) else { return };
    let Some(nearest) = nearest(lines, sheet, pointer) else {
        if let Some(text) = light::told(state, sheet, pointer) {
            response.clone().on_hover_text_at_pointer(text);
        }
        return;
    };
    let place = canvas::place(&sheet.chart, sheet.projection.flat(nearest.vertex.place));
    painter.circle_stroke(place, 6.0, Stroke::new(1.5, colour(nearest.line.picture, ui.visuals())));
    let body = nearest.line.body;
    let motion = state.session.prepared.motion_of(body);
    let track = Track { rest: nearest.surface.to_array(), motion };
    if response.clicked() {
        let add = ui.input(|input| input.modifiers.shift);
        asks.push(Command::Select(Select { track, body, add }));
    }
    response.clone().on_hover_text_at_pointer(text(state, &nearest, &track));
}

fn nearest<'a>(lines: &'a Lines, sheet: &Sheet, pointer: Pos2) -> Option<Nearest<'a>> {
    let pointer = [f64::from(pointer.x), f64::from(pointer.y)];
    lines.nearest((sheet.projection, &sheet.chart), pointer, REACH)
}

/// What it is, where, and when.
fn text(state: &State, nearest: &Nearest, track: &Track) -> String {
    let line = nearest.line;
    let name = state.session.scene.name_of(line.body);
    let what = if line.rests { "at rest on the ground" } else { line.picture.words() };
    let length = state.measures().length;
    let [x, y, z] = nearest.vertex.place.to_array().map(|value| length.number(value, 3));
    let place = format!("x = {x},  y = {y},  z = {z}{}", length.suffix());
    [format!("{name}, {what}"), place]
        .into_iter()
        .chain(times(state, line.picture, track))
        .collect::<Vec<_>>()
        .join("\n")
}

/// When it is there, as far as that is one event.
fn times(state: &State, picture: Picture, track: &Track) -> Option<String> {
    let time = state.measures().time;
    let text = |value: f64| time.text(value, 3);
    let received = state.session.time;
    let seen = || state.settings.exact_disparity(track, received).ok();
    match (picture, state.settings.map.frame) {
        (Picture::Seen(eye), Frame::Ground) => {
            let both = seen()?;
            let seen = if eye == 0 { both.primary } else { both.secondary };
            Some(format!(
                "received T = {}\nhappened t = {}\nown clock τ = {}",
                text(received),
                text(seen.retarded_time),
                text(seen.own_time)
            ))
        }
        (Picture::Measured, Frame::Ground) => Some(format!("now, at t = T = {}", text(received))),
        (Picture::Measured, Frame::Bicycle) => {
            let now = state.speed().gamma() * received;
            let number = if now.is_finite() { text(now) } else { figures::NONE.to_owned() };
            Some(format!("now, at t′ = γT = {number}"))
        }
        _ => None,
    }
}
