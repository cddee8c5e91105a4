//! The map: what happens, beside what is seen. A strip to choose its face and its frame, and below it that face, a file
//! each.

mod axes;
mod canvas;
mod labels;
mod space;
mod spacetime;
mod times;

use eframe::egui::{Rect, RichText, Ui, UiBuilder, vec2};

use super::Commands;
use crate::app::command::Command;
use crate::app::state::State;
use crate::app::widgets::choice;
use crate::caption::capitalised;
use crate::settings::{Face, Frame, Framing};

/// Height of the strip.
const STRIP_HEIGHT: f32 = 26.0;

/// Shows the map with its controls.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    if state.document.settings.window.simple {
        return show_presented(ui, state, commands);
    }
    let rect = ui.max_rect();
    let height = STRIP_HEIGHT.min(rect.height());
    let above = Rect::from_min_size(rect.min, vec2(rect.width(), height));
    ui.scope_builder(UiBuilder::new().max_rect(above), |ui| strip(ui, state, commands));
    face(ui, state, Rect::from_min_max(above.left_bottom(), rect.max), commands);
}

/// Shows it before an audience or among few controls: the frame is named, and nothing is chosen.
pub fn show_presented(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let whose = match state.document.settings.map_frame() {
        Frame::Ground => "the ground".to_owned(),
        Frame::Bicycle => format!("the {}", state.document.scene.rider),
        Frame::Rider => "the one who rides".to_owned(),
    };
    let told = ui.label(RichText::new(format!("Map, in the frame of {whose}")).small().strong());
    let below = ui.max_rect().with_min_y(told.rect.max.y);
    face(ui, state, below, commands);
}

fn face(ui: &mut Ui, state: &State, below: Rect, commands: &mut Commands) {
    match state.document.settings.map.face {
        Face::Space => space::show(ui, state, below, commands),
        Face::Spacetime => spacetime::show(ui, state, below, commands),
    }
}

const FACES: [(Face, &str, &str); 2] = [
    (Face::Space, "Space", "Where everything is, from above and from the side."),
    (Face::Spacetime, "Spacetime", "When everything happens: x against t, light at 45 degrees."),
];

const CLOSE_UP: &str = "Follows the selected body: in space where it is seen and where two eyes place it, with the length of a \
                        rod; in spacetime where the followed points are now, with their clocks.";

fn strip(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let mut map = state.document.settings.map;
    let rider = capitalised(&state.document.scene.rider);
    let frames = [
        (Frame::Ground, "Ground", "In the frame of the street, where eyes and houses rest.   Key: G"),
        (Frame::Bicycle, &rider, "In the frame of who rides along: eyes and street ride past.   Key: G"),
        (
            Frame::Rider,
            "Mine",
            "In the frame in which I rest at this moment, counted from me: the street rides past.   Key: G",
        ),
    ];
    let frames = if state.document.settings.ride.is_on() { &frames[..] } else { &frames[..2] };
    ui.horizontal_centered(|ui| {
        choice(ui, &mut map.face, &FACES);
        ui.separator();
        choice(ui, &mut map.frame, frames);
        ui.separator();
        let mut is_close_up = map.framing == Framing::CloseUp;
        ui.toggle_value(&mut is_close_up, "Close-up").on_hover_text(CLOSE_UP);
        map.framing = if is_close_up { Framing::CloseUp } else { Framing::Passage };
    });
    if map != state.document.settings.map {
        commands.push(Command::Map(map));
    }
}
