//! The window from picture to picture: commands are done, then all is shown.

use std::path::PathBuf;

use eframe::egui::{self, Rect, Ui, UiBuilder};
use gamow_platform::wishes;

use crate::app::commands::{Command, FileCommand, ShowCommand, actions};
use crate::app::panels;
use crate::app::panels::Commands;
use crate::app::shell::{App, TITLE, dropped};
use crate::app::state::State;
use crate::app::state::lesson::Running;
use crate::app::state::notice::Notice;
use crate::app::state::overlay::Overlay;
use crate::app::tools::watch::Watch;
use crate::app::views::eyes::EyePictures;
use crate::app::views::panes::Arrangement;
use crate::app::views::start_picture::StartPicture;
use crate::app::widgets::{self, focus, theme};

/// Enlargement of the start page's text for an audience.
const PRESENTED_START_SCALE: f32 = 1.6;

impl App {
    /// Runs `panel` inside `rect` and does what it asks for.
    pub(in crate::app) fn show_panel(
        &mut self,
        ui: &mut Ui,
        name: &str,
        rect: Rect,
        panel: impl FnOnce(&mut Ui, &State, &mut Commands),
    ) {
        let mut commands = Commands::new();
        ui.scope_builder(UiBuilder::new().id_salt(name).max_rect(rect), |ui| {
            ui.set_clip_rect(rect.expand(2.0).intersect(ui.clip_rect()));
            panel(ui, &self.state, &mut commands);
        });
        self.run_all(ui.ctx(), commands);
    }

    pub(in crate::app) fn run_all(&mut self, ctx: &egui::Context, commands: Commands) {
        ctx.input(|input| self.state.hear(input));
        if !commands.is_empty() {
            // Panels that were shown before this one show the change in the next frame.
            ctx.request_repaint();
        }
        for command in commands {
            self.run(command);
        }
        self.state.renew_looks();
    }

    /// Returns those of the shown files that have changed on disk.
    fn changed_files(&mut self, ctx: &egui::Context) -> Vec<PathBuf> {
        let shown = self.state.shown_files();
        if self.watch.as_ref().is_none_or(|watch| watch.paths() != shown) {
            self.watch = (!shown.is_empty()).then(|| Watch::new(ctx.clone(), shown));
        }
        self.watch.as_ref().map(Watch::changed).unwrap_or_default()
    }

    /// Shows everything: first what changes the state, then what follows it.
    pub fn show(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        widgets::name_window(&ctx, TITLE);
        let window = self.state.document.settings.window;
        ctx.set_theme(theme::preference(window.theme));
        theme::set_animations(&ctx, window.animations && !wishes::less_motion());
        theme::set_contrast(&ctx, wishes::more_contrast());
        let mut commands = self.next_asked(&ctx);
        if self.shows_start() {
            commands.retain(panels::start::lets_through);
        }
        commands.extend(dropped::take(&ctx).map(|path| Command::File(FileCommand::Open(path))));
        panels::palette::show(&ctx, &self.state, &mut commands);
        panels::help::show(&ctx, &self.state, &mut commands);
        panels::handed_in::show(&ctx, &self.state, &mut commands);
        self.chooser.update(&self.state, &mut commands);
        panels::file_dialog::show(&ctx, &self.state, &mut self.chooser, &mut commands);
        panels::saving::show(&ctx, &self.saver, &mut commands);
        panels::reading::show(&ctx, &self.reader, &mut commands);
        self.run_all(&ctx, commands);
        // A file that the user has just given up is not among these.
        let read =
            self.reader.finished().into_iter().map(|file| Command::File(FileCommand::Show(Box::new(file))));
        let changed =
            self.changed_files(&ctx).into_iter().map(|path| Command::File(FileCommand::Reload(path)));
        self.run_all(&ctx, read.chain(changed).collect());
        self.set_stage(&ctx);

        let area = ui.max_rect();
        ui.painter().rect_filled(area, 0.0, ui.visuals().panel_fill);
        self.thumbnails.receive(&ctx);
        if !self.state.session.stage.stereoscope {
            self.stereoscope = None;
        }
        if !self.shows_start() {
            self.start_picture.take().into_iter().for_each(StartPicture::forget);
        }
        if self.shows_start() {
            self.show_start(ui, area);
        } else if self.state.session.stage.stereoscope {
            self.show_stereoscope(ui, area);
        } else if self.state.session.stage.is_presented() {
            self.show_presented(ui, area);
        } else {
            self.show_parts(ui, area);
        }
        focus::paint(&ctx);
        self.update_projector(&ctx);
        self.report_gpu_errors(&ctx);
        #[cfg(feature = "desktop")]
        if let Some(text) = self.system_fonts.newly_missing() {
            self.state.tell(Notice::error(text));
            ctx.request_repaint();
        }
        self.fulfil_orders(ui);
        if self.state.scratch.playing || self.state.session.lesson.as_ref().is_some_and(Running::is_running) {
            ctx.request_repaint();
        }
    }

    /// Returns the commands of keys for this frame. A clicker's press, with all keys after it, waits until
    /// the result of the one before is shown: so nothing is passed over unseen.
    fn next_asked(&mut self, ctx: &egui::Context) -> Commands {
        let is_getting_ready = std::mem::take(&mut self.state.frame_mut().is_getting_ready);
        let mut commands = std::mem::take(&mut self.waiting);
        commands.extend(actions::asked(ctx, &self.state));
        let is_next = |command: &Command| matches!(command, Command::Show(ShowCommand::Next(_)));
        let mut nexts = (0..commands.len()).filter(|&place| is_next(&commands[place]));
        let first = nexts.next();
        let waiting = if is_getting_ready { first } else { nexts.next() };
        if let Some(place) = waiting {
            self.waiting = commands.split_off(place);
            ctx.request_repaint();
        }
        commands
    }

    /// Says once what the graphics device could not do; closes the window that has lost it.
    fn report_gpu_errors(&mut self, ctx: &egui::Context) {
        if self.loss().is_some() {
            ctx.send_viewport_cmd(egui::ViewportCommand::Close);
            return;
        }
        let eyes = [&mut self.eyes, &mut self.projected].into_iter().flatten();
        let refusal = eyes.filter_map(EyePictures::take_refusal).last().cloned();
        if let Some(text) = self.gpu_errors.take_new(refusal) {
            self.state.tell(Notice::error(text));
            ctx.request_repaint();
        }
    }

    /// Has the system and the writing follow what is made of the window, and notes what of its screen counts.
    fn set_stage(&mut self, ctx: &egui::Context) {
        let State { document, session, .. } = &*self.state;
        let full_screen = self.full_screen.update(ctx, session.stage.full_screen);
        let scale = match session.stage.is_presented() {
            // Its cards have pictures, and are to be in sight.
            true if session.overlay.is_some_and(Overlay::is_page) => PRESENTED_START_SCALE,
            true => panels::presented::scale(ctx, ctx.content_rect()),
            false => 1.0,
        };
        if scale != self.text_scale {
            self.text_scale = scale;
            theme::scale_text(ctx, scale);
            // What is shown of this frame is written as it was before.
            ctx.request_repaint();
        }
        let width = ctx.input(|input| input.viewport().monitor_size).map(|size| f64::from(size.x));
        let cm_per_pixel = document.settings.screen.cm_per_point(width) / f64::from(ctx.pixels_per_point());
        self.state.note_screen(full_screen, cm_per_pixel);
    }

    /// Whether the start page takes the place of the parts.
    fn shows_start(&self) -> bool {
        self.state.session.overlay.is_some_and(Overlay::is_page)
    }

    /// Shows the message, if there is one, at the top of `room`.
    pub(in crate::app) fn message(&mut self, ctx: &egui::Context, room: Rect, area: Rect) {
        let mut commands = Commands::new();
        panels::message::show(ctx, &self.state, room, area, &mut commands);
        self.run_all(ctx, commands);
    }

    /// Returns the arrangement of the views' area.
    pub(in crate::app) fn arranged(&self, ui: &Ui) -> Arrangement {
        let State { document, frame, .. } = &*self.state;
        let cm_per_point = frame.cm_per_pixel * f64::from(ui.pixels_per_point());
        Arrangement::new(&document.settings, cm_per_point, theme::text_scale(ui.style()))
    }
}
