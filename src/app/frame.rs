//! What each frame of the window measures, chooses and works out once.

use std::sync::Arc;

use relativity_render::{Geometry, Outline, PreparedScene};

use super::shared::Shared;
use super::state::{Document, State};
use crate::accuracy::Choice;
use crate::scene::Track;
use crate::settings::{Look, Settings, Subject};

/// What a frame measures, chooses and works out.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// Width and height of an eye's picture, which a field of view is fitted to, pixels.
    pub picture_size: [u32; 2],
    /// The size of a pixel of the screen, cm.
    pub cm_per_pixel: f64,
    /// What automatic quality has chosen for views of each geometry that is shown.
    pub choices: Vec<(Geometry, Choice)>,
    /// Whether the map is shown.
    pub shows_map: bool,
    /// The step that T took; 0 while it stands still.
    pub step: f64,
    /// How the eyes look, in the first picture of one eye and in the second.
    looks: [Option<Looked>; 2],
}

/// How both eyes look at a document, and at what.
#[derive(Debug, Clone, PartialEq)]
struct Looked {
    settings: Shared<Settings>,
    prepared: PreparedScene,
    time: f64,
    tracked: Track,
    size: [u32; 2],
    look: Look,
    outline: Arc<Outline>,
}

impl Looked {
    fn new(document: &Document, settings: &Shared<Settings>, size: [u32; 2]) -> Self {
        let (prepared, tracked) = (document.prepared.clone(), document.points.selected().track);
        let subject = Subject { scene: &prepared, tracked };
        let look = settings.fixed_look(subject, document.time, size);
        let outline = Arc::new(settings.outline(&prepared, document.time));
        Self { settings: settings.clone(), prepared, time: document.time, tracked, size, look, outline }
    }

    fn is_of(&self, document: &Document, size: [u32; 2]) -> bool {
        self.settings.is_same(&document.settings)
            && self.prepared == document.prepared
            && (self.time, self.size) == (document.time, size)
            && self.tracked == document.points.selected().track
    }
}

impl Frame {
    /// Returns the frame before the first: pictures are as large as `settings` have those of files.
    pub(super) fn before_the_first(settings: &Settings) -> Self {
        Self {
            picture_size: settings.picture.size.0,
            cm_per_pixel: settings.screen.cm_per_point(None),
            choices: Vec::new(),
            shows_map: false,
            step: 0.0,
            looks: [None, None],
        }
    }

    fn looked(&self, document: &Document) -> Option<&Looked> {
        self.looks.iter().flatten().find(|looked| looked.is_of(document, self.picture_size))
    }
}

impl State {
    /// Works out how the eyes look in this frame, unless that is known: questions about views then cost little.
    pub(super) fn note_looks(&mut self) {
        let (document, size) = (&self.document, self.frame.picture_size);
        if self.frame.looks[0].as_ref().is_some_and(|first| first.is_of(document, size)) {
            return;
        }
        let first = Looked::new(document, &document.settings, size);
        let second = document.settings.second_of(self.subject(), &document.scene, document.time, size);
        let second = second.map(|second| Looked::new(document, &second.into(), size));
        self.frame.looks = [Some(first), second];
    }

    /// Brings up to date how the eyes look, where views are shown.
    pub(super) fn renew_looks(&mut self) {
        if self.frame.looks[0].is_some() {
            self.note_looks();
        }
    }

    /// Where both eyes look now and how wide, as numbers.
    #[must_use]
    pub fn look(&self) -> Look {
        let known = self.frame.looked(&self.document).map(|looked| looked.look);
        let Document { settings, time, .. } = &self.document;
        known.unwrap_or_else(|| settings.fixed_look(self.subject(), *time, self.frame.picture_size))
    }

    /// The outline of all that moves, in both eyes together.
    #[must_use]
    pub fn outline(&self) -> Arc<Outline> {
        let known = self.frame.looked(&self.document).map(|looked| Arc::clone(&looked.outline));
        let Document { settings, prepared, time, .. } = &self.document;
        known.unwrap_or_else(|| Arc::new(settings.outline(prepared, *time)))
    }

    /// The settings of the second of two pictures of one eye; `None` where there is no second.
    #[must_use]
    pub(super) fn second_settings(&self) -> Option<Shared<Settings>> {
        let (document, size) = (&self.document, self.frame.picture_size);
        if let [Some(first), second] = &self.frame.looks
            && first.is_of(document, size)
        {
            return second.as_ref().map(|second| second.settings.clone());
        }
        let second = document.settings.second_of(self.subject(), &document.scene, document.time, size);
        second.map(Shared::from)
    }
}
