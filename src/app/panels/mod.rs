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

use eframe::egui::{Align2, Context, Response, Ui, Window};

use super::commands::{Command, WindowCommand};
use super::state::overlay::Overlay;
use super::widgets::STEREOSCOPE_TIP;

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

/// Shows a window in the middle for `overlay`, which the user may close.
fn show_overlay(
    ctx: &Context,
    title: &str,
    overlay: Overlay,
    commands: &mut Commands,
    contents: impl FnOnce(&mut Ui, &mut Commands),
) {
    let mut is_open = true;
    middle_window(title).open(&mut is_open).show(ctx, |ui| contents(ui, commands));
    if !is_open {
        commands.push(WindowCommand::Toggle(overlay).into());
    }
}

/// A window in the middle that keeps its place and its size.
fn middle_window(title: &str) -> Window<'_> {
    Window::new(title).anchor(Align2::CENTER_CENTER, [0.0, 0.0]).collapsible(false).resizable(false)
}

/// The button that makes the window a stereoscope.
fn stereoscope_button(ui: &mut Ui, commands: &mut Commands) {
    ui.button("Stereoscope")
        .on_hover_text(STEREOSCOPE_TIP)
        .on_click(commands, WindowCommand::ToggleStereoscope);
}

/// Written between two notes on a picture.
const BETWEEN_NOTES: &str = "  ·  ";
