//! The file that is being read, where that takes long, and a way to give it up.

use eframe::egui::{Align2, Context, Spinner, Window};
use gamow_platform::files;

use super::{Commands, OnClick as _};
use crate::app::commands::FileCommand;
use crate::app::state::files::reader::Reader;

/// Above the lower edge of the window, points: above what is being saved.
const ABOVE: f32 = 130.0;

/// Shows it while something takes long.
pub fn show(ctx: &Context, reader: &Reader, commands: &mut Commands) {
    let Some(path) = reader.awaited() else { return };
    Window::new("Reading")
        .anchor(Align2::CENTER_BOTTOM, [0.0, -ABOVE])
        .title_bar(false)
        .resizable(false)
        .show(ctx, |ui| {
            ui.horizontal(|ui| {
                ui.add(Spinner::new());
                ui.label(format!("Reading {}", files::shown(path)));
                ui.button("Stop").on_click(commands, FileCommand::StopReading);
            });
        });
}
