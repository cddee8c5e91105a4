//! The controls of what makes two eyes' pictures a pair: which way the eyes are from each other, where the
//! pictures lie, and what an audience can fuse.

use eframe::egui::Ui;

use super::{projection, screen};
use crate::app::command::Command;
use crate::app::panels::Commands;
use crate::app::state::State;
use crate::app::widgets::{NumberRow, choice, row};
use crate::flags::HEAD_DEGREES;
use crate::settings::Motion;

/// Shows the controls of the two eyes.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let (mut motion, mut look) = (state.document.settings.motion, state.document.settings.look);
    head_rows(ui, &mut motion, state.defaults().motion);
    projection::show(ui, state, &mut look);
    screen::show(ui, state, commands);
    if motion != state.document.settings.motion {
        commands.push(Command::Motion(motion));
    }
    if look != state.document.settings.look {
        commands.push(Command::Look(look));
    }
}

/// Shows the direction of the eyes from each other: a choice of three, and the tilt and turn of the head.
fn head_rows(ui: &mut Ui, motion: &mut Motion, default: Motion) {
    row(
        ui,
        "Eyes",
        "Chooses how the head is held. Is a body really turned? One eye cannot tell. Two eyes can, but \
            what they see depends on how they are placed.",
        |ui| {
            let mut held = [motion.roll, motion.turn];
            if choice(ui, &mut held, &HELD) {
                [motion.roll, motion.turn] = held;
            }
        },
    );
    let tilted = NumberRow {
        name: "Head tilted",
        tip: "Tilts the head: above 0° the right eye is the higher one, at 90° straight above the left \
            one.\nEyes above each other see a rod abreast contracted, and not turned; eyes along the \
            motion see it turned.",
        slider: -90.0..=90.0,
        typed: HEAD_DEGREES,
        decimals: 2,
        suffix: "°",
    };
    let turned = NumberRow {
        name: "Head turned",
        tip: "Turns the head, above 0° to the left: at 90° the right eye is straight beyond the left \
            one.\nLines of sight then need not meet.",
        ..tilted.clone()
    };
    tilted.show(ui, &mut motion.roll, default.roll);
    turned.show(ui, &mut motion.turn, default.turn);
}

/// Tilt and turn of eyes that are along and across the motion.
const HELD: [([f64; 2], &str, &str); 3] = [
    (
        [0.0, 0.0],
        "Along",
        "Beside each other, along the motion: the paper's. Two eyes see a rod abreast turned by arctan β and \
        shortened to √(1 − β⁴).",
    ),
    (
        [90.0, 0.0],
        "Above",
        "The right eye above the left one: two eyes see a rod abreast not turned, contracted to 1/γ.",
    ),
    (
        [0.0, 90.0],
        "Behind",
        "The right eye beyond the left one, across the motion and along the line of sight of what is \
        abreast. Lines of sight need not meet.",
    ),
];
