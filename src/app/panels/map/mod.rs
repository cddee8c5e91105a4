//! The map: what happens, beside what is seen. A strip to choose its face and its frame, and below it that
//! face, a file each.

mod axes;
mod canvas;
mod labels;
mod space;
mod spacetime;
mod times;

use eframe::egui::{Rect, RichText, Ui, UiBuilder, vec2};

use super::{Commands, on_change};
use crate::app::commands::SettingsCommand;
use crate::app::state::State;
use crate::app::widgets::{choice, explained_lazily};
use crate::caption::capitalised;
use crate::settings::{MapFace, MapFrame, MapFraming, meaning};

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
        MapFrame::Ground => "the ground".to_owned(),
        MapFrame::Bicycle => format!("the {}", state.document.scene.rider),
        MapFrame::Rider => "the one who rides".to_owned(),
    };
    let told = ui.label(RichText::new(format!("Map, in the frame of {whose}")).small().strong());
    let below = ui.max_rect().with_min_y(told.rect.max.y);
    face(ui, state, below, commands);
}

fn face(ui: &mut Ui, state: &State, below: Rect, commands: &mut Commands) {
    match state.document.settings.map.face {
        MapFace::Space => space::show(ui, state, below, commands),
        MapFace::Spacetime => spacetime::show(ui, state, below, commands),
    }
}

const FACES: [(MapFace, &str); 2] = [(MapFace::Space, "Space"), (MapFace::Spacetime, "Spacetime")];

fn strip(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let mut map = state.document.settings.map;
    let rider = capitalised(&state.document.scene.rider);
    let frames = [(MapFrame::Ground, "Ground"), (MapFrame::Bicycle, &rider), (MapFrame::Rider, "Mine")];
    let frames = if state.document.settings.ride.is_on() { &frames[..] } else { &frames[..2] };
    ui.horizontal_centered(|ui| {
        choice(ui, &mut map.face, &FACES);
        ui.separator();
        choice(ui, &mut map.frame, frames);
        ui.separator();
        let mut is_close_up = map.framing == MapFraming::CloseUp;
        let close_up = ui.toggle_value(&mut is_close_up, "Close-up");
        explained_lazily(close_up, || meaning(&MapFraming::CloseUp));
        map.framing = if is_close_up { MapFraming::CloseUp } else { MapFraming::Passage };
    });
    on_change(commands, &state.document.settings.map, map, SettingsCommand::Map);
}
