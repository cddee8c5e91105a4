//! How far a picture or a film has come that is being saved, and a way to stop it.

use eframe::egui::{Align2, Context, ProgressBar, Window};

use super::Asks;
use crate::app::command::Command;
use crate::app::saving::{Progress, Saver};

const WIDTH: f32 = 300.0;
/// Above the lower edge of the window, points.
const ABOVE: f32 = 60.0;

/// Shows it while something takes long.
pub fn show(ctx: &Context, saver: &Saver, asks: &mut Asks) {
    let Some(Progress { name, drawn: [drawn, all] }) = saver.progress(ctx) else { return };
    Window::new("Saving")
        .anchor(Align2::CENTER_BOTTOM, [0.0, -ABOVE])
        .title_bar(false)
        .resizable(false)
        .show(ctx, |ui| {
            ui.set_width(WIDTH);
            ui.label(format!("Saving {name}"));
            ui.horizontal(|ui| {
                let bar = ProgressBar::new(drawn as f32 / all.max(1) as f32).desired_width(WIDTH - 70.0);
                ui.add(bar.text(format!("{drawn} of {all}")));
                if ui.button("Stop").clicked() {
                    asks.push(Command::StopSaving);
                }
            });
        });
}
