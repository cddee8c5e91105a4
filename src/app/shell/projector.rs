//! The projector's window: what an audience sees, while the controls stay on the lecturer's screen.

use eframe::egui::{Context, Ui, ViewportBuilder, ViewportClass, ViewportCommand, ViewportId};

use crate::app::commands::actions;
use crate::app::commands::{Command, WindowCommand};
use crate::app::panels::presented;
use crate::app::shell::App;
use crate::app::shell::other_screen::{Screen, other_screen};
use crate::app::views::eyes::EyePictures;
use crate::app::views::halo;
use crate::app::widgets::name_window;
use crate::app::widgets::theme;

/// The name of the projector's window.
const TITLE: &str = "Gamow: views";

/// Returns the name of the projector's window among windows.
fn id() -> ViewportId {
    ViewportId::from_hash_of("projector")
}

/// Builds the projector's window: on the whole of the other `screen` if there is one; else for the lecturer
/// to move to the projector and to enlarge with F11.
fn window(screen: Screen) -> ViewportBuilder {
    let window = ViewportBuilder::default()
        .with_title(TITLE)
        .with_inner_size([1120.0, 700.0])
        .with_min_inner_size([240.0, 160.0]);
    match screen {
        Screen::Other(number) => window.with_monitor(number),
        Screen::Same | Screen::NotChosen => window,
    }
}

/// Returns whether `command` is about this window alone, and performs it then: one about the whole screen is
/// about its own.
fn takes(ctx: &Context, command: &Command) -> bool {
    let is_full = ctx.input(|input| input.viewport().fullscreen).unwrap_or_default();
    let is_taken = match command {
        Command::Window(WindowCommand::ToggleFullScreen) => true,
        Command::Window(WindowCommand::Close) => is_full,
        _ => false,
    };
    if is_taken {
        ctx.send_viewport_cmd(ViewportCommand::Fullscreen(!is_full));
    }
    is_taken
}

impl App {
    /// Chooses the screen of the projector's window as that opens: a window does not move because another one
    /// does.
    pub(in crate::app) fn choose_screen(&mut self, frame: &eframe::Frame) {
        self.screen = match (self.state.session.stage.projector, self.screen) {
            (false, _) => Screen::NotChosen,
            (true, Screen::NotChosen) => other_screen(frame).map_or(Screen::Same, Screen::Other),
            (true, chosen) => chosen,
        };
    }

    /// Shows the projector's window while there is one.
    pub(in crate::app) fn update_projector(&mut self, ctx: &Context) {
        if !self.state.session.stage.projector {
            self.projected.iter_mut().for_each(EyePictures::forget);
            return;
        }
        let is_closed = ctx.show_viewport_immediate(id(), window(self.screen), |ui, class| {
            if class == ViewportClass::Immediate {
                self.read_projector_keys(ui.ctx());
            }
            self.show_projected(ui);
            ui.input(|input| input.viewport().close_requested())
        });
        if is_closed {
            self.run_all(ctx, vec![Command::Window(WindowCommand::ToggleProjector)]);
        }
    }

    /// Has the keys work in a window of its own, too.
    fn read_projector_keys(&mut self, ctx: &Context) {
        let commands = actions::asked(ctx, &self.state).into_iter().filter(|command| !takes(ctx, command));
        self.run_all(ctx, commands.collect());
    }

    /// Shows what an audience sees in the window of this `ui`: the picture, the panel beside it, and words.
    fn show_projected(&mut self, ui: &mut Ui) {
        if self.projected.is_none() {
            self.projected = self.eyes.as_ref().map(|eyes| eyes.another(ui.ctx()));
        }
        name_window(ui.ctx(), TITLE);
        let area = ui.max_rect();
        ui.painter().rect_filled(area, 0.0, ui.visuals().panel_fill);
        let scale = presented::scale(ui.ctx(), area);
        theme::set_body_size(ui.style_mut(), theme::BODY_SIZE * scale);
        let presentation = self.presentation(ui, area);
        let panes = presentation.panes.clone();
        // What is off is examined in pictures of the other window's size.
        let picture = self.state.frame.picture;
        let examination = self.examination.take();
        let choices = self.state.frame.choices.clone();
        let mut swap_pictures = || {
            std::mem::swap(&mut self.eyes, &mut self.projected);
            std::mem::swap(&mut self.state.frame_mut().looks, &mut self.projected_looks);
        };
        swap_pictures();
        let fade = std::mem::take(&mut self.fade);
        self.measure_pictures(ui, &panes);
        self.choose_methods(ui, &panes);
        for &pane in &panes {
            self.interact(ui, pane);
        }
        self.paint_all(ui, &panes);
        self.forget_composed(&panes);
        std::mem::swap(&mut self.eyes, &mut self.projected);
        (self.examination, self.fade) = (examination, fade);
        self.state.frame_mut().picture = picture;
        self.state.frame_mut().choices = choices;
        self.show_beside_picture(ui, &presentation);
        self.show_words(ui, &presentation);
        halo::paint(ui.ctx());
    }
}
