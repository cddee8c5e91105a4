//! The window: two eyes' views of a scene that rides past, controls, a timeline, plots and a readout.
//!
//! Three owners of state: [`settings`] are remembered, [`state`] lasts a session, and the GPU's part
//! lives in [`eyes`]. Panels read the state and ask for [`command::Command`]s; [`App`] applies them in
//! between, so that what follows a control follows it in the same frame.

pub mod args;
pub mod clock;
pub mod command;
pub mod curves;
mod eyes;
pub mod figures;
mod graphics;
mod icon;
pub mod launch;
mod layout;

pub mod observer;
mod panels;
pub mod points;
mod screenshot;
pub mod settings;
mod shortcuts;
pub mod speed_setting;
pub mod state;
mod theme;

use eframe::egui::{self, Rect, TextureId, Ui, UiBuilder};
use eframe::egui_wgpu::RenderState;

use command::Command;
use curves::{Curves, Key};
use eyes::EyePictures;
use layout::Layout;
use panels::{Asks, views::Pane};
use state::State;

/// The whole window.
pub struct App {
    state: State,
    curves: Vec<Curves>,
    eyes: Option<EyePictures>,
}

impl App {
    /// The window's content in `state`; without `render_state` there are no views.
    #[must_use]
    pub fn new(ctx: &egui::Context, render_state: Option<&RenderState>, state: State) -> Self {
        theme::install(ctx);
        Self { state, curves: Vec::new(), eyes: render_state.map(EyePictures::new) }
    }

    /// What it shows.
    #[must_use]
    pub const fn state(&self) -> &State {
        &self.state
    }

    /// Does what the user would have asked for.
    pub fn ask(&mut self, command: Command) {
        self.state.apply(command);
    }

    /// Lets T run by a `step` of the wall clock, seconds.
    fn advance(&mut self, step: f64) {
        if self.state.session.playing {
            let playback = self.state.settings.playback;
            let range = self.state.time_range();
            let tick = clock::advanced(self.state.session.time, step, playback.rate, playback.looping, range);
            self.state.session.time = tick.time;
            self.state.session.playing = tick.playing;
        }
    }

    /// Runs `panel` inside `rect` and does what it asks for.
    fn panel(&mut self, ui: &mut Ui, name: &str, rect: Rect, panel: impl FnOnce(&mut Ui, &State, &mut Asks)) {
        let mut asks = Asks::new();
        ui.scope_builder(UiBuilder::new().id_salt(name).max_rect(rect), |ui| {
            ui.set_clip_rect(rect.expand(2.0).intersect(ui.clip_rect()));
            panel(ui, &self.state, &mut asks);
        });
        self.apply(ui.ctx(), asks);
    }

    fn apply(&mut self, ctx: &egui::Context, asks: Asks) {
        if !asks.is_empty() {
            // Panels that were shown before this one show the change in the next frame.
            ctx.request_repaint();
        }
        for command in asks {
            self.ask(command);
        }
    }

    /// Brings the curves up to date; those that still hold are kept.
    fn update_curves(&mut self) {
        let keys: Vec<Key> =
            self.state.session.points.all().iter().map(|point| self.state.curve_key(point)).collect();
        self.curves = keys
            .into_iter()
            .map(|key| match self.curves.iter().position(|curves| *curves.key() == key) {
                Some(kept) => self.curves.swap_remove(kept),
                None => Curves::new(key),
            })
            .collect();
    }

    /// The up-to-date picture for `pane`.
    fn picture(&mut self, pane: Pane, light_window: bool) -> Option<TextureId> {
        let state = &self.state;
        let view = state.view(pane.eye, pane.size, state.gaze());
        let appearance = state.appearance(light_window);
        let eyes = self.eyes.as_mut()?;
        Some(eyes.picture(pane.eye.index(), &state.session.bodies, &view, &appearance))
    }

    /// Shows everything: first what changes the state, then what follows it.
    pub fn show(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        ctx.set_theme(self.state.settings.window.theme);
        let mut asks = shortcuts::asked(&ctx);
        asks.extend(dropped_scene(&ctx));
        panels::help::show(&ctx, &self.state, &mut asks);
        self.apply(&ctx, asks);

        let area = ui.max_rect();
        ui.painter().rect_filled(area, 0.0, ui.visuals().panel_fill);
        let layout = Layout::of(area, self.state.settings.window);
        let inset = |rect: Rect| rect.shrink2(egui::vec2(theme::GAP, theme::GAP / 2.0));
        self.panel(ui, "bar", inset(layout.bar), panels::bar::show);
        if let Some(rect) = layout.controls {
            self.panel(ui, "controls", inset(rect), panels::controls::show);
        }
        self.panel(ui, "timeline", inset(layout.timeline), panels::timeline::show);
        let largest = self.eyes.as_ref().map_or(1, EyePictures::largest_side);
        let panes = layout.views.map(|area| Pane::both(area, ctx.pixels_per_point(), largest));
        for pane in panes.into_iter().flatten() {
            self.panel(ui, pane.eye.name(), pane.rect, |ui, state, asks| {
                panels::views::interact(ui, state, pane, asks);
            });
        }
        if let Some(rect) = layout.plots {
            self.update_curves();
            let curves = std::mem::take(&mut self.curves);
            self.panel(ui, "plots", rect, |ui, state, asks| panels::plots::show(ui, state, &curves, asks));
            self.curves = curves;
        }
        if let Some(rect) = layout.readout {
            self.panel(ui, "readout", inset(rect), panels::readout::show);
        }
        for pane in panes.into_iter().flatten() {
            let picture = self.picture(pane, !ui.visuals().dark_mode);
            panels::views::paint(ui, &self.state, pane, picture);
        }
        if self.state.session.playing {
            ctx.request_repaint();
        }
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        self.advance(f64::from(ctx.input(|input| input.stable_dt)));
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.show(ui);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        eframe::set_value(storage, eframe::APP_KEY, &self.state.settings);
    }
}

/// A scene file dropped onto the window.
fn dropped_scene(ctx: &egui::Context) -> Option<Command> {
    ctx.input(|input| input.raw.dropped_files.first().map(|file| Command::OpenScene(file.path().to_owned())))
}
