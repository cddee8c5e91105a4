//! The projector's window: the views, while the controls stay on the lecturer's screen.

use eframe::egui::{Context, Ui, ViewportBuilder, ViewportClass, ViewportCommand, ViewportId};

use super::command::Command;
use super::eyes::EyePictures;
use super::{App, actions, halo, layout};

/// What it is called among windows.
fn id() -> ViewportId {
    ViewportId::from_hash_of("projector")
}

/// How it opens: to be moved to the projector's screen, and made as large as that by F11.
fn window() -> ViewportBuilder {
    ViewportBuilder::default()
        .with_title("Gamow: views")
        .with_inner_size([1024.0, 520.0])
        .with_min_inner_size([240.0, 160.0])
}

/// Whether `command` is about this window alone, and then done: what it says of the whole screen is said of its own.
fn takes(ctx: &Context, command: &Command) -> bool {
    let is_full = ctx.input(|input| input.viewport().fullscreen).unwrap_or_default();
    let is_taken = match command {
        Command::ToggleFullScreen => true,
        Command::Close => is_full,
        _ => false,
    };
    if is_taken {
        ctx.send_viewport_cmd(ViewportCommand::Fullscreen(!is_full));
    }
    is_taken
}

impl App {
    /// Shows the projector's window while there is one.
    pub(super) fn update_projector(&mut self, ctx: &Context) {
        if !self.state.session.stage.projector {
            self.projected.iter_mut().for_each(EyePictures::forget);
            return;
        }
        let is_closed = ctx.show_viewport_immediate(id(), window(), |ui, class| {
            if class == ViewportClass::Immediate {
                self.read_projector_keys(ui.ctx());
            }
            self.show_projected(ui);
            ui.input(|input| input.viewport().close_requested())
        });
        if is_closed {
            self.apply(ctx, vec![Command::ToggleProjector]);
        }
    }

    /// Has the keys work in a window of its own, too.
    fn read_projector_keys(&mut self, ctx: &Context) {
        let asks = actions::asked(ctx).into_iter().filter(|command| !takes(ctx, command));
        self.apply(ctx, asks.collect());
    }

    /// Shows the views, and nothing else, in a window whose `ui` this is.
    fn show_projected(&mut self, ui: &mut Ui) {
        if self.projected.is_none() {
            self.projected = self.eyes.as_ref().map(EyePictures::another);
        }
        let area = ui.max_rect();
        ui.painter().rect_filled(area, 0.0, ui.visuals().panel_fill);
        let panes = layout::views(area, &self.arranged(ui).without_corrected());
        // What is off is examined in pictures of the other window's size.
        let (size, examination) = (self.state.session.picture_size, self.examination.take());
        let choices = self.state.session.choices.clone();
        std::mem::swap(&mut self.eyes, &mut self.projected);
        self.measure_pictures(ui, &panes);
        self.choose_methods(ui, &panes);
        for &pane in &panes {
            self.interact(ui, pane);
        }
        self.paint_all(ui, &panes);
        self.forget_composed(&panes);
        std::mem::swap(&mut self.eyes, &mut self.projected);
        (self.state.session.picture_size, self.examination) = (size, examination);
        self.state.session.choices = choices;
        halo::paint(ui.ctx());
    }
}
