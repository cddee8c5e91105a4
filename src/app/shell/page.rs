//! The page with all the parts of the window that there is room for, and the start page in their place.

use eframe::egui::{self, Rect, Ui};

use crate::app::panels::plots::Plotted;
use crate::app::panels::{self, Commands};
use crate::app::shell::{App, INSET};
use crate::app::state::State;
use crate::app::state::lesson::Running;
use crate::app::state::stage::WindowPart;
use crate::app::views::panes::PaneContent;
use crate::app::views::start_picture::StartPicture;
use crate::app::views::window_layout::{self, LessonPart, WindowLayout};
use crate::app::widgets::theme;
use crate::lesson::Course;

impl App {
    /// Shows the start page, below the bar where there is one.
    pub(in crate::app) fn show_start(&mut self, ui: &mut Ui, area: Rect) {
        self.fitting.rest();
        self.update_examination(ui, &[], false);
        self.corrected = None;
        let mut page = area;
        if !self.state.session.stage.is_presented() {
            let bar;
            (bar, page) = window_layout::below_bar(area);
            self.show_panel(ui, "bar", bar.shrink2(INSET), panels::bar::show);
        }
        let mut thumbnails = std::mem::take(&mut self.thumbnails);
        let new = || StartPicture::new(ui.ctx(), self.eyes.as_ref()?.another(ui.ctx()));
        let mut head = self.start_picture.take().or_else(new);
        self.show_panel(ui, "start", page, |ui, state, commands| {
            let pictures = panels::start::Pictures { head: head.as_mut(), cards: &mut thumbnails };
            panels::start::show(ui, state, pictures, commands);
        });
        thumbnails.go_on(ui.ctx());
        (self.thumbnails, self.start_picture) = (thumbnails, head);
        self.message(ui.ctx(), page, area);
    }

    /// Returns the part of a lesson that is shown.
    pub(in crate::app) fn lesson_part(&self) -> LessonPart {
        match &self.state.session.lesson {
            None => LessonPart::Nothing,
            Some(Running { is_folded: true, .. }) => LessonPart::Strip,
            Some(_) => LessonPart::Panel,
        }
    }

    /// Shows all the parts that there is room for.
    pub(in crate::app) fn show_parts(&mut self, ui: &mut Ui, area: Rect) {
        let ctx = ui.ctx().clone();
        let (mut window, plots) = (self.state.shown_window(), self.state.document.settings.plots);
        // There is room for the views or for the plot that is drawn in.
        window.views &= !(self.state.shows_sketch() && window_layout::is_narrow(area));
        let lesson = self.lesson_part();
        let layout = WindowLayout::new(area, lesson, window, &self.arranged(ui), plots.plot);
        let layout = layout.with_only(area, self.state.session.stage.maximised);
        // Its numbers would tell what is being predicted.
        let is_asked = self.state.course().and_then(Course::asked).is_some();
        let layout = if is_asked { layout.without_readout() } else { layout };
        self.measure_pictures(ui, &layout.panes);
        self.choose_methods(ui, &layout.panes);
        self.state.frame_mut().shows_map = layout.map.is_some();
        let inset = |rect: Rect| rect.shrink2(INSET);
        self.show_panel(ui, "bar", inset(layout.bar), panels::bar::show);
        if let Some(rect) = layout.lesson {
            self.show_lesson(ui, rect, area);
        }
        if let Some(rect) = layout.controls {
            self.show_panel(ui, "controls", inset(rect), panels::controls::show);
        }
        if let Some(rect) = layout.speed {
            self.show_panel(ui, "speed", inset(rect), panels::controls::show_speed);
        }
        self.show_panel(ui, "timeline", inset(layout.timeline), panels::timeline::show);
        self.titles(ui, &layout);
        for &pane in &layout.panes {
            self.interact(ui, pane);
        }
        if let Some(rect) = layout.map {
            self.show_panel(ui, "map", rect, panels::map::show);
        }
        let plots_are_shown = layout.plots.is_some() && !self.state.shows_sketch();
        self.update_fit(&ctx, plots_are_shown);
        self.update_examination(ui, &layout.panes, plots_are_shown);
        if let Some(rect) = layout.plots {
            self.show_plots(ui, rect, plots_are_shown);
        }
        if let Some(rect) = layout.readout {
            self.show_panel(ui, "readout", inset(rect), panels::readout::show);
        }
        self.paint_all(ui, &layout.panes);
        if let Some(rect) = layout.spectrum {
            self.show_panel(ui, "spectrum", rect, |ui, state, _| panels::spectrum::show(ui, state));
        }
        if let Some(rect) = layout.sentence {
            self.show_panel(ui, "sentence", rect, |ui, state, _| panels::sentence::show(ui, state));
        }
        for &border in &layout.borders {
            self.show_panel(ui, "borders", area, |ui, state, commands| {
                panels::borders::show(ui, state, border, commands);
            });
        }
        self.message(&ctx, layout.message_room(area), area);
        self.corrected.take_if(|_| !layout.shows(PaneContent::Corrected));
        self.forget_composed(&layout.panes);
    }

    /// Shows the lesson inside `rect`.
    fn show_lesson(&mut self, ui: &mut Ui, rect: Rect, area: Rect) {
        let rect = rect.with_max_y(rect.max.y - theme::GAP).with_min_x(rect.min.x + theme::GAP);
        // Beside a panel on the left are the views, which have a margin of their own.
        let rect = rect.with_max_x(rect.max.x.min(area.max.x - theme::GAP));
        self.show_panel(ui, "lesson", rect, panels::lesson::show);
    }

    /// Shows the plots inside `rect`; where the lesson's plot is drawn in instead, the curves need not be up
    /// to date.
    fn show_plots(&mut self, ui: &mut Ui, rect: Rect, plots_are_shown: bool) {
        if plots_are_shown {
            self.update_curves();
        }
        self.show_plotted(ui, rect, panels::plots::show);
    }

    /// Shows inside `rect` what `show` makes of the data of the plots.
    pub(in crate::app) fn show_plotted(
        &mut self,
        ui: &mut Ui,
        rect: Rect,
        show: impl FnOnce(&mut Ui, &State, Plotted<'_>, &mut Commands),
    ) {
        let (curves, fitting) = (std::mem::take(&mut self.curves), std::mem::take(&mut self.fitting));
        let examination = self.examination.take();
        let plotted = Plotted { curves: &curves, fitting: &fitting, examination: examination.as_ref() };
        self.show_panel(ui, "plots", rect, |ui, state, commands| show(ui, state, plotted, commands));
        (self.curves, self.fitting, self.examination) = (curves, fitting, examination);
    }

    /// Maximises the part of the window whose title is double-clicked, or restores all others. Widgets in a
    /// title are above it and take clicks first.
    fn titles(&mut self, ui: &mut Ui, layout: &WindowLayout) {
        let height = theme::TITLE_HEIGHT;
        let panes = layout.panes.iter().enumerate().map(|(number, pane)| {
            let number = self.state.session.stage.maximised_pane().unwrap_or(number);
            let title =
                Rect::from_min_max(pane.rect.left_top() - egui::vec2(0.0, height), pane.rect.right_top());
            (WindowPart::Pane(number), title)
        });
        let strip = |rect: Rect| rect.with_max_y((rect.min.y + height).min(rect.max.y));
        let map = layout.map.map(|rect| (WindowPart::Map, strip(rect)));
        let plots = layout.plots.map(|rect| (WindowPart::Plots, strip(rect)));
        for (part, title) in panes.chain(map).chain(plots).collect::<Vec<_>>() {
            self.show_panel(ui, "titles", title, |ui, _, commands| {
                panels::borders::title(ui, part, commands);
            });
        }
    }
}
