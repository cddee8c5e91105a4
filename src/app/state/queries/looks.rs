//! Looks of the eyes in a frame: worked out once, for every question about a view.

use std::sync::Arc;

use relativity_render::{Framing, Outline};

use crate::app::state::State;
use crate::app::state::document::Document;
use crate::app::state::frame::Looked;
use crate::app::state::shared::Shared;
use crate::settings::{Canvas, LookSettings, Settings};

impl State {
    /// Works out how the eyes look in this frame, unless that is known: questions about views then cost
    /// little.
    pub(in crate::app) fn note_looks(&mut self) {
        let (document, canvas) = (&self.document, self.frame.picture);
        if self.frame.looks[0].as_ref().is_some_and(|first| first.is_of(document, canvas)) {
            return;
        }
        let first = Looked::new(document, &document.settings, canvas);
        let second = document.settings.second_of(self.subject(), &document.scene, document.time, canvas.size);
        // Its field of view is the first's, which may fit the size already.
        let keeps_height = canvas.keeps_height && document.settings.look.set_fov().is_some();
        let canvas = Canvas { keeps_height, ..canvas };
        let second = second.map(|second| Looked::new(document, &second.into(), canvas));
        self.frame.looks = [Some(first), second];
    }

    /// Brings up to date how the eyes look, where views are shown.
    pub(in crate::app) fn renew_looks(&mut self) {
        if self.frame.looks[0].is_some() {
            self.note_looks();
        }
    }

    /// Returns the look of both eyes now, as numbers.
    #[must_use]
    pub fn look(&self) -> LookSettings {
        let known = self.frame.looked(&self.document).map(|looked| looked.look);
        let Document { settings, time, .. } = &self.document;
        known.unwrap_or_else(|| settings.shown_look(self.subject(), *time, self.frame.picture))
    }

    /// The outline of all that moves, in both eyes together.
    #[must_use]
    pub fn outline(&self) -> Arc<Outline> {
        let known = self.frame.looked(&self.document).map(|looked| Arc::clone(&looked.outline));
        let Document { settings, prepared, time, .. } = &self.document;
        known.unwrap_or_else(|| Arc::new(settings.outline(prepared, *time)))
    }

    /// The framing of all that moves, in both eyes together; `None` where nothing is.
    #[must_use]
    pub fn framing(&self) -> Option<Framing> {
        let Document { settings, prepared, time, .. } = &self.document;
        let known = self.frame.looked(&self.document).map(Looked::framing);
        known.unwrap_or_else(|| settings.framing_of_all(prepared, *time))
    }

    /// The settings of the second of two pictures of one eye; `None` where there is no second.
    #[must_use]
    pub(in crate::app) fn second_settings(&self) -> Option<Shared<Settings>> {
        let (document, canvas) = (&self.document, self.frame.picture);
        if let [Some(first), second] = &self.frame.looks
            && first.is_of(document, canvas)
        {
            return second.as_ref().map(|second| second.settings.clone());
        }
        let second = document.settings.second_of(self.subject(), &document.scene, document.time, canvas.size);
        second.map(Shared::from)
    }
}
