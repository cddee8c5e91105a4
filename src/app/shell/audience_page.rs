//! The page for an audience: the picture, perhaps beside it a plot, the map or the fit, and words, all large.

use eframe::egui::{Rect, Ui};

use crate::app::panels;
use crate::app::panels::presented;
use crate::app::shell::App;
use crate::app::state::stage::SidePanel;
use crate::app::views::halo;
use crate::app::views::window_layout::Presentation;

/// Margin around a question beside the picture, in widths.
const MARGIN: f32 = 0.04;

impl App {
    /// Lays out a window with this inner `area` for an audience.
    pub(in crate::app) fn presentation(&self, ui: &Ui, area: Rect) -> Presentation {
        let state = &*self.state;
        let arranged = self.arranged(ui).for_audience(state.session.stage.audience.both_eyes);
        Presentation::new(area, &arranged, state.session.lesson.is_some(), state.reserved_panel())
    }

    /// Shows the picture, the panel beside it and the words, large.
    pub(in crate::app) fn show_presented(&mut self, ui: &mut Ui, area: Rect) {
        let presentation = self.presentation(ui, area);
        let panel = self.state.side_panel();
        self.measure_pictures(ui, &presentation.panes);
        self.choose_methods(ui, &presentation.panes);
        self.update_fit(ui.ctx(), panel == SidePanel::Fit);
        self.update_examination(ui, &presentation.panes, false);
        for &pane in &presentation.panes {
            self.interact(ui, pane);
        }
        self.state.frame_mut().shows_map = panel == SidePanel::Map && presentation.panel.is_some();
        self.show_beside_picture(ui, &presentation);
        self.paint_all(ui, &presentation.panes);
        self.forget_composed(&presentation.panes);
        let views = presentation.panes.iter().map(|pane| pane.rect).reduce(Rect::union);
        self.message(ui.ctx(), views.unwrap_or(area), area);
        halo::paint(ui.ctx());
        self.show_words(ui, &presentation);
    }

    /// Shows an audience the words of the lesson, else those of the preset.
    pub(in crate::app) fn show_words(&mut self, ui: &mut Ui, presentation: &Presentation) {
        let Some(rect) = presentation.words else { return };
        let pane = self.first_eye_pane(ui, &presentation.panes);
        let notes = pane.map(|pane| panels::views::note_for_audience(ui, &self.state, pane));
        self.show_panel(ui, "words", rect, |ui, state, commands| {
            let lesson = state.session.lesson.as_ref().map(panels::lesson::what_is_shown);
            let lesson = lesson.map(|key| (key, panels::lesson::presented::show));
            presented::show(ui, state, &notes.unwrap_or_default(), lesson, commands);
        });
    }

    /// Shows the panel beside the picture for an audience.
    pub(in crate::app) fn show_beside_picture(&mut self, ui: &mut Ui, presentation: &Presentation) {
        let (panel, Some(rect)) = (self.state.side_panel(), presentation.panel) else { return };
        match panel {
            SidePanel::Nothing => {
                let key = self.state.session.lesson.as_ref().map(panels::lesson::what_is_shown);
                let room = rect.shrink(rect.width() * MARGIN);
                self.show_panel(ui, "question", room, |ui, state, commands| {
                    presented::fitting(ui, key.unwrap_or_default(), |ui| {
                        panels::lesson::presented::show_beside(ui, state, commands);
                    });
                });
            }
            SidePanel::Map => self.show_panel(ui, "map", rect, panels::map::show_presented),
            SidePanel::Plot | SidePanel::Fit => self.show_one_plot(ui, rect),
        }
    }

    /// Shows a single plot, or the fit, at `rect`.
    fn show_one_plot(&mut self, ui: &mut Ui, rect: Rect) {
        if !self.state.shows_sketch() {
            self.update_curves();
        }
        self.show_plotted(ui, rect, panels::plots::show_one);
    }
}
