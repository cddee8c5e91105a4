//! The frame: everything that is measured, chosen and worked out once for each picture of the window.

use std::sync::{Arc, OnceLock};

use relativity_render::{Framing, Geometry, Outline, PreparedScene};

use crate::accuracy::Choice;
use crate::app::state::document::Document;
use crate::app::state::shared::Shared;
use crate::scene::Track;
use crate::settings::{Canvas, LookSettings, Settings, Subject};

/// The measurements and choices of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// The canvas of an eye's picture.
    pub picture: Canvas,
    /// The size of a pixel of the screen, cm.
    pub cm_per_pixel: f64,
    /// Automatic choice for views of each geometry that is shown.
    pub choices: Vec<(Geometry, Choice)>,
    /// Whether the map is shown.
    pub shows_map: bool,
    /// Step of T; 0 while T is paused.
    pub step: f64,
    /// Whether a picture waits until what draws it is made; T waits with it.
    pub is_getting_ready: bool,
    /// Looks of the eyes, in the first picture of one eye and in the second.
    pub(in crate::app) looks: [Option<Looked>; 2],
}

/// The look of both eyes at a document.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::app) struct Looked {
    pub(in crate::app) settings: Shared<Settings>,
    prepared: PreparedScene,
    time: f64,
    tracked: Track,
    canvas: Canvas,
    pub(in crate::app) look: LookSettings,
    pub(in crate::app) outline: Arc<Outline>,
    /// The framing of all that moves. It costs much in a scene of thousands of bodies, and is seldom needed:
    /// so it is empty until it is asked for.
    framing: OnceLock<Option<Framing>>,
}

impl Looked {
    pub(in crate::app) fn new(document: &Document, settings: &Shared<Settings>, canvas: Canvas) -> Self {
        let (prepared, tracked) = (document.prepared.clone(), document.points.selected().track);
        let subject = Subject { scene: &prepared, tracked };
        let look = settings.shown_look(subject, document.time, canvas);
        let outline = Arc::new(settings.outline(&prepared, document.time));
        let framing = OnceLock::new();
        Self {
            settings: settings.clone(),
            prepared,
            time: document.time,
            tracked,
            canvas,
            look,
            outline,
            framing,
        }
    }

    /// The framing of all that moves, in both eyes together.
    pub(in crate::app) fn framing(&self) -> Option<Framing> {
        *self.framing.get_or_init(|| self.settings.framing_of_all(&self.prepared, self.time))
    }

    pub(in crate::app) fn is_of(&self, document: &Document, canvas: Canvas) -> bool {
        self.settings.is_same(&document.settings)
            && self.prepared == document.prepared
            && (self.time, self.canvas) == (document.time, canvas)
            && self.tracked == document.points.selected().track
    }
}

impl Frame {
    /// Returns the frame before the first: pictures are as large as `settings` have those of files.
    pub(in crate::app) fn before_the_first(settings: &Settings) -> Self {
        Self {
            picture: Canvas { size: settings.picture.size.0, keeps_height: false },
            cm_per_pixel: settings.screen.cm_per_point(None),
            choices: Vec::new(),
            shows_map: false,
            step: 0.0,
            is_getting_ready: false,
            looks: [None, None],
        }
    }

    pub(in crate::app) fn looked(&self, document: &Document) -> Option<&Looked> {
        self.looks.iter().flatten().find(|looked| looked.is_of(document, self.picture))
    }
}
