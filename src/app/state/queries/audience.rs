//! The contents of the window before an audience: one eye's picture or both, and the panel beside it.

use crate::app::state::State;
use crate::app::state::stage::SidePanel;
use crate::settings::{PlotSettings, PlotTab, Presence, Settings, WindowSettings};

impl State {
    /// Whether both eyes have a picture: before an audience one is shown large in place of two that are
    /// apart.
    #[must_use]
    pub fn has_both_eyes(&self) -> bool {
        let settings = &self.document.settings;
        let is_one_left_out = self.may_leave_an_eye_out() && !self.session.stage.audience.both_eyes;
        settings.picture.layout.has_both() && (!is_one_left_out || settings.is_comparing())
    }

    /// Whether the layout stays where one eye is left out: before an audience, of two pictures apart.
    #[must_use]
    pub fn may_leave_an_eye_out(&self) -> bool {
        self.session.stage.is_presented() && self.document.settings.picture.layout.shows_two_apart()
    }

    /// Returns the panel beside the picture for an audience now.
    #[must_use]
    pub fn side_panel(&self) -> SidePanel {
        let settings = &self.document.settings;
        match self.session.stage.audience.panel {
            Some(SidePanel::Plot) => self.plot_panel(),
            Some(panel) => panel,
            None if self.shows_sketch() => SidePanel::Plot,
            None if self.session.lesson.is_some() => panel_of(&self.shown_window(), settings.plots),
            None if settings.plots != PlotSettings::default() => self.plot_panel(),
            None => SidePanel::Nothing,
        }
    }

    /// Returns the panel whose room the picture leaves free in all phases of the present step of a lesson:
    /// the picture keeps its place.
    #[must_use]
    pub fn reserved_panel(&self) -> SidePanel {
        let told = self.session.lesson.as_ref().and_then(|running| running.told.as_ref());
        let of_step = told.map(|told| told.panel).filter(|_| self.session.stage.audience.panel.is_none());
        of_step.unwrap_or(SidePanel::Nothing).max(self.side_panel())
    }

    /// Whether a lesson's questions stand beside the picture, in the room for what another phase shows there.
    #[must_use]
    pub fn asks_beside_picture(&self) -> bool {
        self.session.lesson.is_some()
            && self.side_panel() == SidePanel::Nothing
            && self.reserved_panel() != SidePanel::Nothing
    }

    /// Whether followed points are marked before an audience, over the picture: where something else shows
    /// them too, or several are to be told apart.
    #[must_use]
    pub fn has_markers_for_audience(&self) -> bool {
        self.session.lesson.is_some()
            || self.document.settings.ride.is_on()
            || self.side_panel() != SidePanel::Nothing
            || self.document.points.all().len() > 1
    }

    /// The panel of the plots' tab.
    fn plot_panel(&self) -> SidePanel {
        if self.sketched().is_some() {
            SidePanel::Plot
        } else {
            panel_of_tab(self.document.settings.plots.plot)
        }
    }
}

/// Returns the panel that a lesson with these settings has beside the picture.
fn panel_of(window: &WindowSettings, plots: PlotSettings) -> SidePanel {
    match (window.map, window.plots) {
        (Presence::On, _) => SidePanel::Map,
        (_, true) => panel_of_tab(plots.plot),
        (_, false) => SidePanel::Nothing,
    }
}

/// Returns the panel that shows this `tab` of the plots.
const fn panel_of_tab(tab: PlotTab) -> SidePanel {
    match tab {
        PlotTab::Fit => SidePanel::Fit,
        _ => SidePanel::Plot,
    }
}

/// Returns the panel of a step of a lesson that has these settings before its reveal and after it.
#[must_use]
pub(in crate::app) fn panel_of_step(phases: &[Settings]) -> SidePanel {
    let panels = phases.iter().map(|settings| panel_of(&settings.window, settings.plots));
    panels.max().unwrap_or(SidePanel::Nothing)
}
