//! The studio, where pictures are made for files: a scene, settings and a renderer, and the record in each
//! file.

pub mod film;
mod layout;
mod painter;
mod sheet;
mod timings;
mod writing;

use std::path::Path;

use relativity_render::{HitImage, PreparedScene, View};

use self::painter::Painter;
pub use self::sheet::Sheet;
use self::sheet::{Ink, Labels};
use self::timings::Timings;
use crate::files::exr::{ChannelLight, Measurements};
use crate::files::png::Still;
use crate::files::provenance::Provenance;
use crate::files::whole::write_whole;
use crate::files::{exr, png};
use crate::flags::choices::FileKind;
use crate::flags::words::Shell;
use crate::scene::{Scene, Track};
use crate::settings::{Settings, Subject};

/// Names of the stages that draw the left and the right eye.
const EYES: [&str; 2] = ["left eye", "right eye"];
/// Names of the stages where both pictures are of the left eye.
const PICTURES: [&str; 2] = ["first picture", "second picture"];

/// A scene, and a renderer that draws it as the settings say.
pub struct Studio {
    scene: Scene,
    prepared: PreparedScene,
    /// Point that is tracked.
    pub tracked: Track,
    settings: Settings,
    painter: Painter,
    timings: Timings,
}

impl Studio {
    /// The scene that `settings` name, and the renderer that they choose.
    ///
    /// # Errors
    ///
    /// A scene or a renderer that cannot be had, the published geometry of a head that is tilted or turned,
    /// eyes that no ride can carry, or a comparison that there is not.
    pub fn new(settings: Settings) -> anyhow::Result<Self> {
        Self::check(&settings)?;
        let scene = Scene::open(&settings.scene)?;
        Self::showing(settings, scene)
    }

    /// A studio for this `scene` in place of that which `settings` name.
    ///
    /// # Errors
    ///
    /// As [`Self::new`].
    pub fn showing(settings: Settings, scene: Scene) -> anyhow::Result<Self> {
        Self::check(&settings)?;
        let scene = settings.furnished(scene);
        let tracked = settings.track(&scene);
        Self::of_scene(settings, scene, tracked)
    }

    /// Refuses settings that nothing draws.
    fn check(settings: &Settings) -> anyhow::Result<()> {
        settings.check_geometry()?;
        settings.check_eyes()?;
        Ok(settings.check_comparison()?)
    }

    /// Returns a studio for this `scene` with `settings`, with this point `tracked`, and the renderer that
    /// they choose.
    ///
    /// # Errors
    ///
    /// A renderer that cannot be had.
    pub fn of_scene(settings: Settings, scene: Scene, tracked: Track) -> anyhow::Result<Self> {
        let mut timings = Timings::default();
        let painter = timings.timed("set up", || Painter::new(&settings))?;
        let mut studio = Self { prepared: scene.prepared(), scene, tracked, settings, painter, timings };
        let [_, view] = studio.settings.views(studio.subject(), 0.0, studio.settings.picture.size.0);
        studio.choose(&view);
        Ok(studio)
    }

    /// Returns the settings of the studio.
    #[must_use]
    pub const fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Returns the scene that is drawn.
    #[must_use]
    pub const fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Returns the subject of the eyes' gaze.
    fn subject(&self) -> Subject<'_> {
        Subject { scene: &self.prepared, tracked: self.tracked }
    }

    /// Has what draws views like this one chosen where that is automatic, and notes it, so that files record
    /// what drew them.
    fn choose(&mut self, view: &View) {
        let Self { painter, prepared, settings, .. } = self;
        settings.quality = painter.choose(settings.quality, prepared, view, settings.picture.eyes().len());
    }

    /// The frame at `time`, or at the T that the settings say.
    ///
    /// # Errors
    ///
    /// A T outside the domain of the core.
    pub fn frame(&self, time: Option<f64>) -> anyhow::Result<StudioFrame> {
        let settings = Settings { time: time.or(self.settings.time), ..self.settings.clone() };
        let settings = settings.resolved(self.subject()).exposed_for(&self.scene);
        let time = settings.time.unwrap_or_default();
        settings.disparity(&self.tracked, time)?;
        Ok(StudioFrame { settings, time })
    }

    /// Returns the provenance that the file of `frame` at `path` records.
    fn provenance(&self, frame: &StudioFrame, path: &Path) -> Provenance {
        self.scene.provenance(frame.settings.relative_to(path).command(Shell::RECORDED))
    }

    /// Whether `path` is a whole file of this `kind` and of just this `frame`.
    #[must_use]
    pub fn has_made(&self, frame: &StudioFrame, kind: FileKind, path: &Path) -> bool {
        let provenance = self.provenance(frame, path);
        match kind {
            FileKind::Png => png::is_made(path, &provenance.texts()),
            FileKind::Exr => exr::is_made(path, &provenance.comments()),
        }
    }

    /// Makes the file of `frame` at `path`, whole or not at all.
    ///
    /// # Errors
    ///
    /// Those of the renderer and of the file system.
    pub fn make_file(&mut self, frame: &StudioFrame, kind: FileKind, path: &Path) -> anyhow::Result<()> {
        match kind {
            FileKind::Png => {
                let provenance = self.provenance(frame, path);
                let still = self.still(frame)?;
                let texts = provenance.texts();
                self.timings.timed("file", || write_whole(path, |file| still.write(&texts, file)))
            }
            FileKind::Exr => {
                let measurements = self.measurements(frame, path)?;
                self.timings.timed("file", || write_whole(path, |file| measurements.write(file)))
            }
        }
    }

    /// Measures the pixels of `frame`, for a file at `path`.
    ///
    /// # Errors
    ///
    /// Those of the renderer; a comparison, which shows one eye alone.
    pub fn measurements(&mut self, frame: &StudioFrame, path: &Path) -> anyhow::Result<Measurements> {
        let provenance = self.provenance(frame, path);
        let hits = self.hits(frame)?;
        let appearance = frame.settings.appearance(&self.scene, frame.time, false);
        let Self { prepared, timings, .. } = self;
        let light = ChannelLight { scene: prepared, appearance };
        Ok(timings.timed("file", || Measurements::of_eyes(&hits, light, &provenance.comments())))
    }

    /// Returns the contents of a PNG file of `frame`, as it would be at `path`.
    ///
    /// # Errors
    ///
    /// Those of the renderer.
    pub fn png(&mut self, frame: &StudioFrame, path: &Path) -> anyhow::Result<Vec<u8>> {
        let provenance = self.provenance(frame, path);
        let mut bytes = Vec::new();
        self.still(frame)?.write(&provenance.texts(), &mut bytes)?;
        Ok(bytes)
    }

    /// Draws the picture for the file of `frame`.
    ///
    /// # Errors
    ///
    /// Those of the renderer.
    pub fn still(&mut self, frame: &StudioFrame) -> anyhow::Result<Still> {
        let StudioFrame { settings, time, .. } = frame;
        let picture = &settings.picture;
        let pictures = settings.pictures(self.subject(), &self.scene, *time);
        let stages = if settings.is_comparing() { PICTURES } else { EYES };
        let Self { painter, prepared, timings, .. } = self;
        let eye = |&eye: &usize| {
            let (view, appearance) = &pictures[eye];
            timings.timed(stages[eye], || painter.picture(prepared, view, appearance))
        };
        let eyes = picture.eyes().iter().map(eye).collect::<Result<_, _>>()?;
        // What it took may speak for another in the next frame.
        let [_, (last, appearance)] = pictures;
        self.choose(&last);
        let Self { timings, .. } = self;
        let labels = picture
            .labels
            .then(|| Labels { ink: Ink::beside(appearance.light), compared: settings.compared_names() });
        let picture_mm = settings.screen.picture_distance;
        Ok(timings.timed("layout", || layout::still(picture, eyes, labels, picture_mm)))
    }

    /// Returns the hits of every pixel of the left and the right eye.
    fn hits(&mut self, frame: &StudioFrame) -> anyhow::Result<[HitImage; 2]> {
        let StudioFrame { settings, time, .. } = frame;
        anyhow::ensure!(
            !settings.is_comparing(),
            "--compare makes two pictures of one eye, and an .exr file holds those of two eyes: leave one of both out"
        );
        let [left, right] = settings.views(self.subject(), *time, settings.picture.size.0);
        let Self { painter, prepared, timings, .. } = self;
        Ok([
            timings.timed(EYES[0], || painter.hits(prepared, &left))?,
            timings.timed(EYES[1], || painter.hits(prepared, &right))?,
        ])
    }

    /// Returns a report: the renderer, the device, and the time of each stage.
    #[must_use]
    pub fn report(&self) -> String {
        let size = self.settings.picture.size;
        let [_, view] = self.settings.views(self.subject(), 0.0, size.0);
        format!("{}; {size} per eye\n{}", self.painter.description(&view), self.timings)
    }
}

/// A frame: one observation time of a studio's scene.
#[derive(Debug, Clone)]
pub struct StudioFrame {
    /// The settings, with nothing left to be found out.
    settings: Settings,
    time: f64,
}
