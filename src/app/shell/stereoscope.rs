//! The screen of a stereoscope in place of the window's parts.

use eframe::egui::{Color32, Id, Rect, Sense, Ui};

use crate::app::commands::{Command, PlaybackCommand, SettingsCommand};
use crate::app::panels::Commands;
use crate::app::panels::stereoscope::{self as menu, Known, MenuChoice};
use crate::app::shell::App;
use crate::app::state::shared::Shared;
use crate::app::views::halo;
use crate::app::views::panes::{Pane, PaneContent, PaneTitle};
use crate::app::views::stereoscope::card::{CardOutline, Match};
use crate::app::views::stereoscope::lenses;
use crate::app::views::stereoscope::orientation::Orientation;
use crate::app::views::stereoscope::viewer::{Stereoscope, StereoscopePage};
use crate::eye::Eye;
use crate::flags::{SCREEN_CM, ScreenWidth};
use crate::settings::{Head, ScreenSettings};

/// The pictures of a stereoscope on the screen.
struct Pictures {
    rects: [Rect; 2],
    /// Field of view of each, degrees.
    fov: f64,
}

impl App {
    /// Takes the orientation that the device reports: alpha, beta, gamma and the turn of the screen,
    /// degrees. Without a stereoscope it changes nothing.
    pub fn turn_device(&mut self, angles: [f64; 4]) {
        if let Some(stereoscope) = &mut self.stereoscope {
            stereoscope.device = Orientation::from_degrees(angles).or(stereoscope.device);
        }
    }

    /// Shows the stereoscope in all of `area`.
    pub(in crate::app) fn show_stereoscope(&mut self, ui: &mut Ui, area: Rect) {
        self.fitting.rest();
        self.update_examination(ui, &[], false);
        self.corrected = None;
        ui.painter().rect_filled(area, 0.0, Color32::BLACK);
        let entered = self.stereoscope.take();
        let mut stereoscope = entered.unwrap_or_else(|| Stereoscope::new(self.state.gaze()));
        match stereoscope.page {
            StereoscopePage::Card(mut card) => {
                let answer = card.show(ui, area);
                stereoscope.page =
                    if answer == Match::Open { StereoscopePage::Card(card) } else { StereoscopePage::Menu };
                if let Match::Found(points_per_mm) = answer {
                    self.measure_screen(ui, points_per_mm);
                }
            }
            StereoscopePage::Pictures | StereoscopePage::Menu => {
                self.show_pictures(ui, area, &mut stereoscope);
            }
        }
        self.stereoscope = Some(stereoscope);
        self.message(ui.ctx(), area, area);
    }

    /// Returns the size of a millimetre on the screen, points.
    fn points_per_mm(&self, ui: &Ui) -> f64 {
        0.1 / (self.state.frame.cm_per_pixel * f64::from(ui.pixels_per_point()))
    }

    /// Sets the width of the screen from the size of a millimetre on it, points.
    fn measure_screen(&mut self, ui: &Ui, points_per_mm: f64) {
        let Some(points) = ui.input(|input| input.viewport().monitor_size) else { return };
        let cm = (0.1 * f64::from(points.x) / points_per_mm).clamp(*SCREEN_CM.start(), *SCREEN_CM.end());
        let screen =
            ScreenSettings { screen_width: ScreenWidth(Some(cm)), ..self.state.document.settings.screen };
        self.run_all(ui.ctx(), vec![Command::Settings(SettingsCommand::Screen(screen))]);
    }

    /// Shows the pictures, and the menu or its button over them.
    fn show_pictures(&mut self, ui: &mut Ui, area: Rect, stereoscope: &mut Stereoscope) {
        let screen = self.state.document.settings.screen;
        let points_per_mm = self.points_per_mm(ui);
        let rects = lenses::pictures(area, (points_per_mm * screen.picture_distance) as f32);
        let width_mm = f64::from(rects[0].width()) / points_per_mm;
        let pictures = Pictures { rects, fov: lenses::field_of_view(width_mm, screen.lens_to_screen) };
        self.touch(ui, area, &pictures, stereoscope);
        self.paint_pictures(ui, &pictures, &stereoscope.head());
        let mut commands = Commands::new();
        let choice = if stereoscope.page == StereoscopePage::Menu {
            let known = Known {
                is_turned: stereoscope.device.is_some(),
                takes_card: ui.input(|input| input.viewport().monitor_size).is_some(),
                is_measured: screen.screen_width.0.is_some(),
            };
            menu::show(ui.ctx(), screen, known, &mut commands)
        } else {
            menu::button(ui.ctx())
        };
        stereoscope.page = match choice {
            MenuChoice::Pictures => StereoscopePage::Pictures,
            MenuChoice::Menu => StereoscopePage::Menu,
            MenuChoice::Card => StereoscopePage::Card(CardOutline::new(points_per_mm)),
        };
        self.run_all(ui.ctx(), commands);
    }

    /// Reads a finger on the pictures: a tap plays or pauses, a drag turns the head.
    fn touch(&mut self, ui: &Ui, area: Rect, pictures: &Pictures, stereoscope: &mut Stereoscope) {
        let response = ui.interact(area, Id::unique("stereoscope"), Sense::click_and_drag());
        if response.clicked() {
            if !self.state.scratch.playing && stereoscope.device.is_some() {
                stereoscope.look_along(self.state.gaze());
            }
            self.run_all(ui.ctx(), vec![Command::Playback(PlaybackCommand::Toggle)]);
        }
        if response.dragged() {
            let per_point = lenses::radians_per_point(pictures.rects[0].width(), pictures.fov);
            let moved = response.drag_delta();
            stereoscope.turn([moved.x, moved.y].map(|points| per_point * f64::from(points)));
        }
    }

    /// Draws both pictures as this `head` sees them. What the document shows stays as it is.
    fn paint_pictures(&mut self, ui: &mut Ui, pictures: &Pictures, head: &Head) {
        let settings = self.state.document.settings.before_head(head, pictures.fov);
        let own = self.state.exchange(Shared::from(settings));
        let panes = Eye::BOTH.map(|eye| Pane {
            content: PaneContent::Eye(eye),
            rect: pictures.rects[eye.index()],
            band: 0.0,
            title: PaneTitle::Nowhere,
        });
        self.measure_pictures(ui, &panes);
        self.choose_methods(ui, &panes);
        let eyes: Vec<_> = panes.iter().flat_map(|pane| self.eye_panes(ui, pane)).collect();
        for pane in eyes {
            self.paint_bare(ui, pane);
        }
        self.forget_composed(&panes);
        self.state.exchange(own);
        halo::paint(ui.ctx());
    }
}
