//! The controls of what makes two eyes' pictures a pair: which way the eyes are from each other, where the
//! pictures lie, and what an audience can fuse.

use eframe::egui::Ui;

use super::{projection, screen};
use crate::app::commands::SettingsCommand;
use crate::app::panels::{Commands, on_change};
use crate::app::state::State;
use crate::app::widgets::{NumberRow, choice_of, row};
use crate::flags::HEAD_DEGREES;
use crate::settings::{MotionSettings, about};

/// Shows the controls of the two eyes.
pub fn show(ui: &mut Ui, state: &State, commands: &mut Commands) {
    let (mut motion, mut look) = (state.document.settings.motion, state.document.settings.look);
    head_rows(ui, &mut motion, state.defaults().motion);
    projection::show(ui, state, &mut look);
    screen::show(ui, state, commands);
    on_change(commands, &state.document.settings.motion, motion, SettingsCommand::Motion);
    on_change(commands, &state.document.settings.look, look, SettingsCommand::Look);
}

/// Shows the direction of the eyes from each other: a choice of three, and the tilt and turn of the head.
fn head_rows(ui: &mut Ui, motion: &mut MotionSettings, default: MotionSettings) {
    row(ui, "Eyes", HELD_TIP, |ui| {
        let mut held = [motion.roll, motion.turn];
        if choice_of(ui, &mut held, &HELD, HELD_TIP) {
            [motion.roll, motion.turn] = held;
        }
    });
    let angle = |name, tip| NumberRow::new(name, tip, -90.0..=90.0, HEAD_DEGREES).decimals(2).suffix("°");
    angle("Head tilted", about("roll")).show(ui, &mut motion.roll, default.roll);
    angle("Head turned", about("turn")).show(ui, &mut motion.turn, default.turn);
}

/// Tilt and turn of eyes that are along and across the motion.
const HELD: [([f64; 2], &str); 3] = [([0.0, 0.0], "Along"), ([90.0, 0.0], "Above"), ([0.0, 90.0], "Behind")];

const HELD_TIP: &str = "Chooses how the head is held: the eyes beside each other along the motion, as in the paper; the right eye above the left \
    one; or the right eye beyond the left one, along the line of sight of what is abreast.\nIs a body really turned? One eye cannot tell. Two \
    eyes along the motion see a rod abreast turned by arctan β and shortened to √(1 − β⁴); two eyes above each other see it contracted to 1/γ, and not turned.";
