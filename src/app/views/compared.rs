//! Two pictures of one eye in the window: questions about the second go to the state with the settings of that picture.

use crate::app::App;
use crate::app::state::State;
use crate::app::state::shared::Shared;
use crate::app::views::panes::EyePane;
use crate::settings::Settings;

impl State {
    /// Replaces the settings while a picture is drawn, and returns those before, which the caller puts back.
    pub(in crate::app) fn exchange(&mut self, settings: Shared<Settings>) -> Shared<Settings> {
        std::mem::replace(&mut self.document.settings, settings)
    }

    /// Has the settings of the second of two pictures of one eye, if it `is_second` and there is one; then those that it had.
    fn enter(&mut self, is_second: bool) -> Option<Shared<Settings>> {
        let second = if is_second { self.second_settings() } else { None }?;
        Some(self.exchange(second))
    }

    /// Has these settings again, if there are any.
    fn leave(&mut self, kept: Option<Shared<Settings>>) {
        if let Some(kept) = kept {
            self.exchange(kept);
        }
    }

    /// Calls `asked` with the settings of one picture of a comparison: of the second, which has changes, if `is_second`.
    pub(in crate::app) fn of_picture<R>(&mut self, is_second: bool, asked: impl FnOnce(&mut Self) -> R) -> R {
        let kept = self.enter(is_second);
        let found = asked(self);
        self.leave(kept);
        found
    }

    /// The title of `pane`.
    #[must_use]
    pub(in crate::app) fn title_of(&self, pane: EyePane) -> String {
        self.with_what_it_shows(pane.eye.name(), pane)
    }

    /// The name of `pane` for assistive technology.
    #[must_use]
    pub(in crate::app) fn name_of_view(&self, pane: EyePane) -> String {
        if pane.is_shared {
            return "Both eyes' view".to_owned();
        }
        self.with_what_it_shows(&format!("{} view", pane.eye.name()), pane)
    }

    /// Returns `name` followed by the difference between `pane` and the other picture of the eye.
    fn with_what_it_shows(&self, name: &str, pane: EyePane) -> String {
        match self.document.settings.compared_names() {
            Some(names) => format!("{name}: {}", names[pane.index()]),
            None => name.to_owned(),
        }
    }
}

impl App {
    /// Returns what is `done` with the settings of the picture in `pane`.
    pub(in crate::app) fn in_picture<R>(&mut self, pane: EyePane, done: impl FnOnce(&mut Self) -> R) -> R {
        let kept = self.state.enter(pane.is_second);
        let given = done(self);
        self.state.leave(kept);
        given
    }
}
