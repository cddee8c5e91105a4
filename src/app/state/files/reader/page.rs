//! Files read in a page: scenes with their models in another instance of the program, which can be ended;
//! what is short, in a later task of the page's own thread.

use std::path::PathBuf;

use eframe::egui::Context;
use gamow_platform::files::{self, Sent};

use super::{Errand, ReadFile, Shown, Use, thread};
use crate::app::tools::worker::{BackgroundWork, StepOutcome, Wanted, Work};

/// The place where files are read.
pub struct Place {
    here: thread::Place,
    beside: BackgroundWork<SceneReading, (u64, PathBuf, Use)>,
}

impl Place {
    /// Creates a place that requests a repaint after each file it has read.
    pub fn new(ctx: &Context) -> Self {
        Self { here: thread::Place::new(ctx), beside: BackgroundWork::new(ctx, ()) }
    }

    /// Begins the errand of this number.
    pub fn begin(&self, number: u64, errand: Errand) {
        if errand.leads_to_scene() {
            self.beside.request((number, errand.path.clone(), errand.purpose), files::given(), errand);
        } else {
            self.here.begin(number, errand);
        }
    }

    /// Takes the files read since the last call, with the numbers of their errands.
    pub fn finished(&self) -> Vec<(u64, ReadFile)> {
        let scene = self.beside.result().map(|((number, path, purpose), shown)| {
            (number, ReadFile { path, purpose, contents: shown.map(Shown::into) })
        });
        self.here.finished().into_iter().chain(scene).collect()
    }

    /// Gives up what is being read to be opened.
    pub fn stop(&self) {
        self.beside.end();
    }
}

/// The reading of a file of a scene or of settings, in one step.
pub struct SceneReading(Errand);

impl Work for SceneReading {
    const NAME: &'static str = "reading";
    /// Files that only the asking instance of the program has.
    type Base = Sent;
    type Job = Errand;
    type Result = Result<Shown, String>;
    type Tools = ();

    fn begin(given: Sent, errand: Errand) -> Self {
        files::take_in_all(given);
        Self(errand)
    }

    fn step(&mut self, (): &mut (), _: &Wanted) -> StepOutcome<Self::Result> {
        StepOutcome::Last(Some(self.0.shown()))
    }
}
