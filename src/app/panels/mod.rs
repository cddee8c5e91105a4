//! The parts of the window, a file each, or a folder that holds the parts of one. Each reads the state and
//! asks for commands; none calls another, and all are made of [`super::widgets`].

pub mod bar;
pub mod borders;
pub mod controls;
pub mod corrected;
pub mod file_dialog;
pub mod fusing;
pub mod handed_in;
pub mod help;
pub mod lesson;
pub mod map;
pub mod message;
pub mod palette;
pub mod panorama;
pub mod plots;
pub mod presented;
pub mod reading;
pub mod readout;
pub mod saving;
pub mod sentence;
pub mod spectrum;
pub mod start;
pub mod stereoscope;
pub mod stopwatch;
pub mod timeline;
pub mod views;

use eframe::egui::Response;

use super::commands::Command;

/// The commands that a panel asks for while it is shown.
pub type Commands = Vec<Command>;

/// A widget that asks for a command when it is clicked.
pub trait OnClick {
    /// Asks for `command` if the widget was clicked.
    fn on_click(&self, commands: &mut Commands, command: impl Into<Command>);
}

impl OnClick for Response {
    fn on_click(&self, commands: &mut Commands, command: impl Into<Command>) {
        if self.clicked() {
            commands.push(command.into());
        }
    }
}

/// Asks for what `command` makes of a value that is `now` another than `before`.
pub fn on_change<T: PartialEq, C: Into<Command>>(
    commands: &mut Commands,
    before: &T,
    now: T,
    command: impl FnOnce(T) -> C,
) {
    if now != *before {
        commands.push(command(now).into());
    }
}

/// Written between two notes on a picture.
const BETWEEN_NOTES: &str = "  ·  ";
