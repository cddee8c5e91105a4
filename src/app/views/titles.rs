//! Titles of the panes, and their names for assistive technology.

use crate::app::state::State;
use crate::app::views::panes::EyePane;

impl State {
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
