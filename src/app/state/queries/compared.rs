//! Two pictures of one eye in the window: questions about the second go to the state with the settings of
//! that picture.

use crate::app::state::State;
use crate::app::state::shared::Shared;
use crate::settings::Settings;

impl State {
    /// Replaces the settings while a picture is drawn, and returns those before, which the caller puts back.
    pub(in crate::app) fn exchange(&mut self, settings: Shared<Settings>) -> Shared<Settings> {
        std::mem::replace(&mut self.document.settings, settings)
    }

    /// Puts the settings of the second of two pictures of one eye in place of its own, if it `is_second` and
    /// there is one; returns its own.
    pub(in crate::app) fn enter(&mut self, is_second: bool) -> Option<Shared<Settings>> {
        let second = if is_second { self.second_settings() } else { None }?;
        Some(self.exchange(second))
    }

    /// Puts back the settings that [`Self::enter`] returned, if any.
    pub(in crate::app) fn leave(&mut self, kept: Option<Shared<Settings>>) {
        if let Some(kept) = kept {
            self.exchange(kept);
        }
    }

    /// Calls `query` with the settings of one picture of a comparison: of the second, which has changes, if
    /// `is_second`.
    pub(in crate::app) fn of_picture<R>(&mut self, is_second: bool, query: impl FnOnce(&mut Self) -> R) -> R {
        let kept = self.enter(is_second);
        let found = query(self);
        self.leave(kept);
        found
    }
}
