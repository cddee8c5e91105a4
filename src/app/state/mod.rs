//! The state of the window, in parts by how long each lasts.

pub mod class;
pub mod defaults;
pub mod document;
pub mod files;
pub mod fitting;
pub(in crate::app) mod frame;
pub mod history;
pub mod lesson;
pub mod measuring;
pub mod notice;
pub mod orders;
pub mod overlay;
pub mod plots;
pub mod pointer;
pub mod points;
pub(in crate::app) mod queries;
pub mod riding;
pub mod sequence;
pub(in crate::app) mod shared;
pub mod stage;

use std::path::Path;
use std::sync::Arc;

use relativity_core::Speed;
use relativity_render::{Appearance, Emission, Geometry, Method, View};

use crate::accuracy::Choice;
use crate::app::state::class::ClassAnswers;
use crate::app::state::document::Document;
use crate::app::state::files::purpose::Purpose;
use crate::app::state::files::reader::ReadyScene;
use crate::app::state::files::recent::Recent;
use crate::app::state::frame::Frame;
use crate::app::state::history::History;
use crate::app::state::lesson::Running;
use crate::app::state::measuring::angle_ruler::AngleRuler;
use crate::app::state::measuring::stopwatch::Stopwatch;
use crate::app::state::notice::Notice;
use crate::app::state::orders::Order;
use crate::app::state::overlay::Overlay;
use crate::app::state::plots::look::Plotting;
use crate::app::state::pointer::Pick;
use crate::app::state::points::Point;
use crate::app::state::riding::comfort::RideComfort;
use crate::app::state::riding::saddle::Saddle;
use crate::app::state::sequence::RunningSequence;
use crate::app::state::shared::Shared;
use crate::app::state::stage::Stage;
use crate::caption::times::ObserverClock;
use crate::estimate::data_file::DataFile;
use crate::lesson::{Answers, Library};
use crate::map::Viewpoint;
use crate::scene::{Scene, SceneError};
use crate::settings::Settings;
use crate::units::Measures;

/// Everything the panels read, each part by how long it lasts. What a user does changes it through
/// [`crate::app::commands`]; that of a running window is in a private field of the shell.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Document that is shown: undone, saved and compared.
    pub document: Document,
    /// Scratch of the document, until another is shown.
    pub scratch: Scratch,
    /// Session of the window.
    pub session: Session,
    /// Frame with its measurements and choices.
    pub frame: Frame,
}

/// The scratch of a document: what is tried on it, and forgotten when another is shown.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Scratch {
    /// Whether playback runs.
    pub playing: bool,
    /// The state of the saddle: who steers, and which push is held.
    pub saddle: Saddle,
    /// Exposure and vignette, which follow a ride.
    pub comfort: RideComfort,
    /// The ruler for angles in the views.
    pub angle_ruler: AngleRuler,
    /// The stopwatch in the first view.
    pub stopwatch: Stopwatch,
    /// The click into a view that hit nothing, until something else is done.
    pub missed: Option<Pick>,
    /// The separation of the eyes before it was narrowed to be comfortable, and after.
    pub narrowed: Option<[f64; 2]>,
    /// The user's look at the map.
    pub map_view: Viewpoint,
    /// Zoomed parts, cursors and pins of the plots.
    pub plotting: Plotting,
    /// The message about the last thing that was done, or could not be.
    pub notice: Option<Notice>,
    /// The purpose for which a file is being chosen.
    pub chooser: Option<Purpose>,
}

/// The session: everything that lasts as long as the window.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Session {
    /// Overlay over the window.
    pub overlay: Option<Overlay>,
    /// Whether the views say what a click does: until the first.
    pub hint: bool,
    /// Temporary modes of the window.
    pub stage: Stage,
    /// Undo history.
    pub history: History,
    /// The measured disparities that are fitted in place of simulated ones.
    pub data: Option<Arc<DataFile>>,
    /// Requests that need more than the state.
    pub orders: Vec<Order>,
    /// The files that were opened.
    pub recent: Recent,
    /// The lesson that is gone through.
    pub lesson: Option<Running>,
    /// The name of the lesson to go on with: the last that was begun, or the one after it once that is over.
    pub next_lesson: Option<String>,
    /// Everything that was entered in lessons, in the open one too.
    pub answers: Answers,
    /// Answers that are handed in.
    pub class: ClassAnswers,
    /// The lessons that there are, where they are not the program's own alone.
    pub library: Option<Arc<Library>>,
    /// The sequence that is gone through with a presenter's two keys.
    pub sequence: Option<RunningSequence>,
}

impl State {
    /// Returns the state that shows `scene` with `settings`. By default the scene's own point is selected,
    /// and T is shortly before that passes.
    #[must_use]
    pub fn new(settings: Settings, scene: Scene) -> Self {
        Self::in_scene(settings, scene.into())
    }

    /// The state with these settings in a scene that is ready to be drawn.
    pub(in crate::app) fn in_scene(settings: Settings, scene: ReadyScene) -> Self {
        let (document, notice) = Document::new(settings, scene);
        let frame = Frame::before_the_first(&document.settings);
        let scratch = Scratch { notice, ..Scratch::default() };
        Self { document, scratch, session: Session::default(), frame }
    }

    /// Shows what `settings` say, in their `scene`. T runs on unless they give one.
    pub(in crate::app) fn show_in(&mut self, settings: Settings, scene: ReadyScene) {
        let playing = self.scratch.playing && settings.time.is_none();
        let (document, notice) = Document::new(settings, scene);
        self.document = document;
        self.scratch = Scratch { playing, notice, ..Scratch::default() };
    }

    /// Leaves a message, in place of the one before.
    pub(in crate::app) fn tell(&mut self, notice: Notice) {
        self.scratch.notice = Some(notice);
    }

    /// Asks no longer which file to open or to write.
    pub(in crate::app) fn close_chooser(&mut self) {
        self.scratch.chooser = None;
    }

    /// Takes the requests that need more than the state.
    pub(in crate::app) fn take_orders(&mut self) -> Vec<Order> {
        std::mem::take(&mut self.session.orders)
    }

    /// Notes what the system makes of the window: whether it has the whole screen, and the size of a pixel,
    /// cm.
    pub(in crate::app) fn note_screen(&mut self, full_screen: bool, cm_per_pixel: f64) {
        (self.session.stage.full_screen, self.frame.cm_per_pixel) = (full_screen, cm_per_pixel);
    }

    /// Opens the scene that `settings` name.
    ///
    /// # Errors
    /// A scene that cannot be had.
    pub fn open(settings: Settings) -> Result<Self, SceneError> {
        let scene = settings.opened_scene()?;
        Ok(Self::new(settings, scene))
    }

    /// Has these settings, which name a scene that can be had: T stays, and so do the points that are still
    /// there.
    ///
    /// # Errors
    /// A scene that cannot be had; then nothing changes.
    pub fn set(&mut self, settings: impl Into<Shared<Settings>>) -> Result<(), SceneError> {
        let settings = settings.into();
        let shown = &self.document.settings;
        let is_same = settings.scene == shown.scene
            && settings.light.surroundings == shown.light.surroundings
            && settings.ride.has_bicycle() == shown.ride.has_bicycle();
        if !is_same {
            self.show_scene(settings.opened_scene()?.into());
        }
        self.document.settings = settings;
        Ok(())
    }

    /// Applies these settings by [`Self::set`], and shows an error as a notice.
    pub(in crate::app) fn set_or_tell(&mut self, settings: Settings) {
        if let Err(error) = self.set(settings) {
            self.tell(Notice::error(error));
        }
    }

    /// Shows `scene` in place of another version of it, with the points that are still there.
    pub(in crate::app) fn show_scene(&mut self, scene: ReadyScene) {
        let ReadyScene { scene, prepared } = scene;
        self.document.prepared = prepared;
        self.document.points = self.document.points.carried(&self.document.scene, &scene);
        self.document.scene = scene;
    }

    /// The file of the scene, if it is in one.
    #[must_use]
    pub fn scene_file(&self) -> Option<&Path> {
        Scene::preset(&self.document.settings.scene)
            .is_none()
            .then(|| Path::new(&self.document.settings.scene))
    }

    /// Returns everything that is shown, as settings with T and points.
    #[must_use]
    pub fn shown(&self) -> Settings {
        let points = &self.document.points;
        Settings {
            time: Some(self.document.time),
            point: (points.selected_index() != 0).then_some(points.selected().track.rest),
            points: points.followed(),
            ..Settings::clone(&self.document.settings)
        }
    }

    /// Returns the name of `point` in lists and plots: the body that it is on, with its number where another
    /// is on that too.
    #[must_use]
    pub fn name_of(&self, point: &Point) -> String {
        let what = point.what(&self.document.scene);
        let is_on_it = |other: &&Point| other.what(&self.document.scene) == what;
        match self.document.points.all().iter().filter(is_on_it).count() {
            0 | 1 => what.to_owned(),
            _ => format!("{what} ({})", point.number),
        }
    }

    /// The speed of the scene.
    #[must_use]
    pub fn speed(&self) -> Speed {
        self.document.settings.speed()
    }

    /// The clock by which whoever looks counts.
    #[must_use]
    pub fn clock(&self) -> &'static ObserverClock {
        ObserverClock::new(self.document.settings.ride.is_on())
    }

    /// The units that lengths and times are shown and typed in.
    #[must_use]
    pub fn measures(&self) -> Measures {
        self.document.settings.window.units.measures(&self.document.scene)
    }

    /// First and last T of the scrubber and the plots.
    #[must_use]
    pub fn time_range(&self) -> [f64; 2] {
        if let Some(range) = self.range_of_ride() {
            return range;
        }
        self.document.settings.time_range(&self.document.points.selected().track)
    }

    /// The light of `point`: of the body it was picked on, else of the one that it lies on, else of the
    /// first.
    #[must_use]
    pub fn emission(&self, point: &Point) -> Emission {
        let body = point.body.or_else(|| self.document.scene.body_at(point.track.rest)).unwrap_or(0);
        self.document.prepared.bodies().get(body).map_or(Emission::WHITE, |body| body.emission)
    }

    /// Wavelength of that light at rest, nm; white light has none.
    #[must_use]
    pub fn rest_wavelength_nm(&self, point: &Point) -> Option<f64> {
        self.emission(point).wavelength_nm()
    }

    /// Returns the method that draws `view`: the one set, else the automatic choice.
    #[must_use]
    pub fn method(&self, view: &View) -> Method {
        let chosen = || self.choice(view.geometry).map(|choice| choice.method);
        self.document.settings.quality.method().or_else(chosen).unwrap_or(Method::Rays)
    }

    /// Returns the automatic choice for views of this `geometry`.
    #[must_use]
    pub fn choice(&self, geometry: Geometry) -> Option<&Choice> {
        self.frame.choices.iter().find_map(|(of, choice)| (*of == geometry).then_some(choice))
    }

    /// Returns the appearance of its light, in a light window or a dark one.
    #[must_use]
    pub fn appearance(&self, light_window: bool) -> Appearance {
        let Document { settings, scene, time, .. } = &self.document;
        // Whoever stands beside the rider has the exposure of the street at rest.
        let is_automatic = settings.light.exposure.0.is_none() && !settings.ride.stands;
        match self.scratch.comfort.exposure_ev.filter(|_| is_automatic) {
            Some(exposure_ev) => settings.appearance_at(exposure_ev, scene, light_window),
            None => settings.appearance(scene, *time, light_window),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Another scene keeps or resets each group of fields as a whole. The state is taken apart by name, so
    /// that a field beside the groups does not compile.
    #[test]
    fn another_scene_forgets_the_scratch_and_keeps_the_session() {
        let mut state = State::open(Settings::default()).expect("the usual scene");
        (state.scratch.playing, state.scratch.narrowed, state.session.hint) = (true, Some([0.2, 0.1]), true);
        let before = state.clone();
        let settings = Settings::default().with_scene("globe".to_owned());
        let scene = settings.opened_scene().expect("a preset");
        state.show_in(settings, scene.into());
        let State { document, frame, scratch, session } = state;
        assert_ne!(document, before.document);
        assert_eq!((frame, session), (before.frame, before.session));
        assert_eq!((scratch.playing, scratch.narrowed), (true, None), "T runs on");
    }
}
