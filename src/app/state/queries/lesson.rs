//! The lesson under way: its course, and the settings that it builds on.

use std::sync::Arc;

use crate::app::state::State;
use crate::lesson::{Course, Lesson, Library};
use crate::settings::{PictureSettings, Settings, WindowSettings};

impl State {
    /// The lessons that there are.
    #[must_use]
    pub fn library(&self) -> Arc<Library> {
        self.session.library.clone().unwrap_or_else(Library::own)
    }

    /// The way through the lesson that is gone through.
    #[must_use]
    pub fn course(&self) -> Option<&Course> {
        self.session.lesson.as_ref().map(|running| &running.course)
    }

    /// Returns the settings that the states of the lesson build on: defaults, in this window with the parts
    /// and the layout that it had before.
    #[must_use]
    pub fn lesson_base(&self) -> Settings {
        let now = self.document.settings.window;
        let before = self.session.lesson.as_ref().map_or(now, |running| running.before);
        let WindowSettings { side_share, strip_share, map_share, animations, units, theme, .. } = now;
        let window =
            WindowSettings { side_share, strip_share, map_share, animations, units, theme, ..before };
        let base = Settings::default().in_place_of(&self.document.settings);
        let layout = self.session.lesson.as_ref().map_or(base.picture.layout, |running| running.layout);
        Settings { window, picture: PictureSettings { layout, ..base.picture }, ..base }
    }

    /// The settings that the lesson has at its present place.
    #[must_use]
    pub fn lesson_settings(&self) -> Option<&Settings> {
        self.session.lesson.as_ref()?.told.as_ref().map(|told| &told.settings)
    }

    /// The lesson that comes after the one that is gone through.
    #[must_use]
    pub fn lesson_after(&self) -> Option<Arc<Lesson>> {
        self.library().after(&self.course()?.lesson().name).map(Arc::clone)
    }
}
