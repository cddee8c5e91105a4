//! Progress of a picture or a film that is being saved, with a button that stops it.

use eframe::egui::{Align2, Context, Label, ProgressBar, Window};

use super::{Commands, OnClick as _};
use crate::app::commands::FileCommand;
use crate::app::commands::saving::{Progress, Saver};
use crate::number_text;

const WIDTH: f32 = 300.0;
/// Above the lower edge of the window, points.
const ABOVE: f32 = 60.0;

/// Shows it while something takes long.
pub fn show(ctx: &Context, saver: &Saver, commands: &mut Commands) {
    let Some(progress) = saver.progress(ctx) else { return };
    let Progress { name, written, frames } = progress;
    Window::new("Saving")
        .anchor(Align2::CENTER_BOTTOM, [0.0, -ABOVE])
        .title_bar(false)
        .resizable(false)
        .show(ctx, |ui| {
            ui.set_width(WIDTH);
            // Each line is there from the first frame on: nothing may move Stop away from under the pointer.
            ui.add(Label::new(format!("Saving {name}")).truncate());
            let size = progress.expected_bytes().map(|bytes| number_text::bytes(bytes, 2));
            let size = size.map_or_else(
                || "…".to_owned(),
                |size| format!("about {size} in all, judging by the frames so far"),
            );
            ui.add(Label::new(size).truncate());
            ui.horizontal(|ui| {
                let bar =
                    ProgressBar::new(written.drawn as f32 / frames.max(1) as f32).desired_width(WIDTH - 70.0);
                ui.add(bar.text(format!("{} of {frames}", written.drawn)));
                ui.button("Stop").on_click(commands, FileCommand::StopSaving);
            });
        });
}
