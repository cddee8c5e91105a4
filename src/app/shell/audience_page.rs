//! The page for an audience: the views, one plot, the map or the fit, and words, all large.

use eframe::egui::{Rect, Ui};

use crate::app::panels;
use crate::app::panels::plots::Plotted;
use crate::app::panels::presented::Words;
use crate::app::shell::App;
use crate::app::state::State;
use crate::app::views::halo;
use crate::app::views::window_layout::{Beside, LessonPart, Presentation};
use crate::settings::{PlotTab, Presence, WindowSettings};

impl App {
    /// Returns the panel to show beside the words for an audience.
    pub(in crate::app) fn beside_words(&self) -> Beside {
        let plot =
            if self.state.document.settings.plots.plot == PlotTab::Fit && self.state.sketched().is_none() {
                Beside::Fit
            } else {
                Beside::Plot
            };
        match (self.lesson_part(), self.state.shown_window()) {
            (LessonPart::Nothing, _) => plot,
            (_, WindowSettings { map: Presence::On, .. }) if !self.state.shows_sketch() => Beside::Map,
            (_, WindowSettings { plots: true, .. }) => plot,
            _ => Beside::Nothing,
        }
    }

    /// Shows the views, one plot and the words, large.
    pub(in crate::app) fn show_presented(&mut self, ui: &mut Ui, area: Rect) {
        let beside = self.beside_words();
        let what = self.words();
        let words = Words { what: &what, area, beside };
        let presentation = Presentation::new(area, &self.arranged(ui), beside, words.needed(ui.ctx()));
        self.measure_pictures(ui, &presentation.panes);
        self.choose_methods(ui, &presentation.panes);
        self.update_fit(ui.ctx(), beside == Beside::Fit);
        self.update_examination(ui, &presentation.panes, false);
        for &pane in &presentation.panes {
            self.interact(ui, pane);
        }
        self.state.frame_mut().shows_map = beside == Beside::Map && presentation.plot.is_some();
        if let Some(rect) = presentation.plot {
            self.beside(ui, beside, rect);
        }
        self.paint_all(ui, &presentation.panes);
        self.forget_composed(&presentation.panes);
        let views = presentation.panes.iter().map(|pane| pane.rect).reduce(Rect::union);
        self.message(ui.ctx(), views.unwrap_or(area), area);
        halo::paint(ui.ctx());
        if let Some(rect) = presentation.words {
            self.show_words(ui, rect, words);
        }
    }

    /// Tells which words an audience has.
    pub(in crate::app) fn words(&self) -> String {
        let State { document, session, .. } = &*self.state;
        let lesson = session.lesson.as_ref().map(panels::lesson::what_is_shown);
        lesson.or_else(|| document.preset.map(|preset| preset.name.to_owned())).unwrap_or_default()
    }

    /// Shows an audience the `words` of the lesson, else those of the preset.
    pub(in crate::app) fn show_words(&mut self, ui: &mut Ui, rect: Rect, words: Words<'_>) {
        self.show_panel(ui, "words", rect, |ui, state, commands| {
            words.show(ui, |ui| match state.session.lesson {
                Some(_) => panels::lesson::presented::show(ui, state, commands),
                None => panels::presented::preset(ui, state, words.beside),
            });
        });
    }

    /// Shows the panel `beside` the words for an audience, at `rect`.
    pub(in crate::app) fn beside(&mut self, ui: &mut Ui, beside: Beside, rect: Rect) {
        if beside == Beside::Map {
            self.show_panel(ui, "map", rect, panels::map::show_presented);
            return;
        }
        if !self.state.shows_sketch() {
            self.update_curves();
        }
        let (curves, fitting) = (std::mem::take(&mut self.curves), std::mem::take(&mut self.fitting));
        let plotted = Plotted { curves: &curves, fitting: &fitting, examination: None };
        self.show_panel(ui, "plots", rect, |ui, state, commands| {
            panels::plots::show_one(ui, state, plotted, commands);
        });
        (self.curves, self.fitting) = (curves, fitting);
    }
}
