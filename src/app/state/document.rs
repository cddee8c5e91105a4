//! The document of the window: what is undone, saved and compared.

use std::path::PathBuf;

use relativity_render::PreparedScene;

use crate::app::state::files::reader::ReadyScene;
use crate::app::state::notice::Notice;
use crate::app::state::points::Points;
use crate::app::state::shared::Shared;
use crate::app::tools::clock;
use crate::flags::choices::ProjectionChoice;
use crate::scene::Scene;
use crate::settings::{LookSettings, Preset, Settings};

/// The document: what is shown, and the files and presets that it came from.
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    /// Remembered, but for T and the points, which are here.
    pub settings: Shared<Settings>,
    /// Scene at rest, as its file describes it.
    pub scene: Scene,
    /// The scene, ready to be drawn and picked from.
    pub prepared: PreparedScene,
    /// Observation time T.
    pub time: f64,
    /// Followed points.
    pub points: Points,
    /// The preset that is shown, until another scene or state is.
    pub preset: Option<&'static Preset>,
    /// The file with settings that is shown, if it is one.
    pub opened: Option<PathBuf>,
}

/// Changes a picture for a headset into a conformal one, and returns a message about it.
fn without_headset(look: &mut LookSettings) -> Option<Notice> {
    (look.projection == ProjectionChoice::Vr180).then(|| {
        look.projection = ProjectionChoice::Mercator;
        Notice::error("Half of the sky is for headsets: `gamow render --projection vr180` draws it. The window shows conformal pictures instead.")
    })
}

/// Returns the message about the models of `scene`, if it has any from files.
pub(in crate::app) fn report(scene: &Scene) -> Option<Notice> {
    let reports: Vec<_> = scene.reports().collect();
    (!reports.is_empty()).then(|| Notice::done(reports.join(". ")))
}

impl Document {
    /// Returns the document that shows `scene` with `settings`, and the message that is due, if there is one.
    /// By default the scene's own point is selected, and T is shortly before that passes.
    pub(in crate::app) fn new(mut settings: Settings, scene: ReadyScene) -> (Self, Option<Notice>) {
        let ReadyScene { scene, prepared } = scene;
        let notice = without_headset(&mut settings.look).or_else(|| report(&scene));
        let preset = Preset::matching(&settings);
        let tracked = settings.track(&scene);
        let points = Points::tracked(scene.track(None));
        let points = points.with_followed(&scene, settings.points.take()).with_selected(tracked);
        settings.point = None;
        let time = settings.time.take().unwrap_or_else(|| settings.time_of_approach(&tracked));
        let time = clock::bounded(time);
        let settings = Shared::from(settings);
        (Self { settings, scene, prepared, time, points, preset, opened: None }, notice)
    }
}
