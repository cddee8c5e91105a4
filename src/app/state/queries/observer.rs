//! The two eyes before the document: sightings of the followed points, gaze, cameras, markers.

use glam::DVec3;
use relativity_core::{Disparity, ObserverError, Parameter, Sighting, Source, Speed, Stereo};
use relativity_render::{Gaze, Geometry, Velocity, View};

use crate::app::state::State;
use crate::app::state::document::Document;
use crate::app::state::fitting::FitOutcome;
use crate::app::state::frame::Frame;
use crate::app::state::plots::curves::SeenPoint;
use crate::app::state::points::Point;
use crate::caption::Moment;
use crate::comfort::Comfort;
use crate::estimate::samples::{FitKey, Samples, Simulated};
use crate::eye::Eye;
use crate::scene::Track;
use crate::settings::{PlotTab, Settings, Subject};

/// The correction of a picture by a speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpeedCorrection {
    /// Speed of the correction.
    pub speed: Speed,
    /// Whether the speed was found by the fit; otherwise it is the scene's own.
    pub is_fitted: bool,
}

/// Distances from the pointer within which something counts as pointed at, pixels, and the directions of the
/// search.
const REACHES: [f64; 4] = [2.0, 4.0, 7.0, 10.0];
const DIRECTIONS: [[f64; 2]; 8] = {
    let slant = std::f64::consts::FRAC_1_SQRT_2;
    [
        [1.0, 0.0],
        [slant, slant],
        [0.0, 1.0],
        [-slant, slant],
        [-1.0, 0.0],
        [-slant, -slant],
        [0.0, -1.0],
        [slant, -slant],
    ]
};

impl State {
    /// The speed found by `fit`, or the scene's own without one.
    #[must_use]
    pub fn correction(&self, fit: Option<&FitOutcome>) -> SpeedCorrection {
        let beta = fit.and_then(|outcome| outcome.fitted.as_ref().ok()?.value(Parameter::Beta));
        match beta.and_then(|beta| Speed::from_beta(beta).ok()) {
            Some(speed) => SpeedCorrection { speed, is_fitted: true },
            None => SpeedCorrection { speed: self.speed(), is_fitted: false },
        }
    }

    /// The velocity of `point`.
    #[must_use]
    pub fn velocity(&self, point: &Point) -> Velocity {
        self.document.settings.velocity(point.track.motion)
    }

    /// The worldline of the selected point from between the eyes, reflected to move along +x.
    #[must_use]
    pub fn selected_source(&self) -> Source {
        self.document.settings.source(&self.document.points.selected().track)
    }

    /// Returns the sighting of `point` by `eye` now; `None` outside the domain of the core.
    #[must_use]
    pub fn sighting(&self, point: &Point, eye: Eye) -> Option<Sighting> {
        let both = self.disparity(point)?;
        Some(match eye {
            Eye::Left => both.primary,
            Eye::Right => both.secondary,
        })
    }

    /// Returns the moment of the selected point.
    #[must_use]
    pub fn moment(&self) -> Moment {
        let point = self.document.points.selected();
        let name = point.noun(&self.document.scene);
        let moment = Moment::new(
            &self.document.settings,
            &point.track,
            name,
            self.emission(point),
            self.document.time,
        );
        moment.with_measures(self.measures())
    }

    /// The disparity of `point` now, in the binocular model of what the views show.
    #[must_use]
    pub fn disparity(&self, point: &Point) -> Option<Disparity> {
        self.document.settings.shown_disparity(&point.track, self.document.time).ok()
    }

    /// Returns the stereo position and gain of `point` now.
    ///
    /// # Errors
    ///
    /// Lines of sight that do not meet; a time outside the domain of the core.
    pub fn stereo(&self, point: &Point) -> Result<Stereo, ObserverError> {
        self.document.settings.stereo(&point.track, self.document.time)
    }

    /// T0 of `point`: when both eyes see it at the same distance. `None` at rest, and of eyes across the
    /// motion.
    #[must_use]
    pub fn equidistance_time(&self, point: &Point) -> Option<f64> {
        self.document.settings.equidistance_time(&point.track)
    }

    /// When `point` is measured beside the eyes: at x = 0, where it is seen only later. `None` at rest.
    #[must_use]
    pub fn abreast_time(&self, point: &Point) -> Option<f64> {
        self.document.settings.abreast_time(&point.track)
    }

    /// Whether `eye` sees what the published model has the right eye see, measured from the left aperture.
    #[must_use]
    pub fn sees_as_published(&self, eye: Eye) -> bool {
        eye == Eye::Right && self.document.settings.geometry() == Geometry::Published
    }

    /// From the aperture of `eye` to where the shown geometry has `point` now.
    #[must_use]
    pub fn direction(&self, point: &Point, eye: Eye) -> Option<DVec3> {
        self.document.settings.directions(&point.track, self.document.time)[eye.index()]
    }

    /// The point of the scene at a `pixel` of the picture of `eye`, which has this `size`, and the body it is
    /// on; none where nothing is, and in the published right eye's picture, into which no ray leads back.
    #[must_use]
    pub fn point_at(&self, eye: Eye, pixel: [f64; 2], size: [u32; 2]) -> Option<(Track, usize)> {
        if self.sees_as_published(eye) {
            return None;
        }
        let view = self.view(eye, size);
        let hit = self.document.prepared.first_hit(&view, view.camera.line_of_sight(pixel))?;
        let track = self.document.scene.track_at(hit.material_position.to_array(), hit.body)?;
        Some((track, hit.body))
    }

    /// The pixel of the picture of `eye`, which has this `size`, that somebody means who points at `pixel`:
    /// it, or if nothing is there the nearest of those around it where something is, since spokes are thin.
    #[must_use]
    pub fn meant(&self, eye: Eye, pixel: [f64; 2], size: [u32; 2]) -> Option<[f64; 2]> {
        if self.sees_as_published(eye) {
            return None;
        }
        let view = self.view(eye, size);
        let hits = |pixel: &[f64; 2]| {
            self.document.prepared.first_hit(&view, view.camera.line_of_sight(*pixel)).is_some()
        };
        let around = REACHES.into_iter().flat_map(|reach| {
            DIRECTIONS.map(|[across, down]| [pixel[0] + reach * across, pixel[1] + reach * down])
        });
        let is_inside = |[u, v]: &[f64; 2]| {
            (0.0..f64::from(size[0])).contains(u) && (0.0..f64::from(size[1])).contains(v)
        };
        std::iter::once(pixel).chain(around.filter(is_inside)).find(hits)
    }

    /// Returns `point` as it moves and is seen, for its curves.
    #[must_use]
    pub fn seen_point(&self, point: &Point) -> SeenPoint {
        let stereo = self.document.settings.plots.plot == PlotTab::Stereo;
        // The paper's lines of sight meet nowhere.
        let model =
            if stereo { self.document.settings.model() } else { self.document.settings.shown_model() };
        SeenPoint {
            ride: self.document.settings.ride.clone(),
            velocity: self.velocity(point),
            point: self.document.settings.from_between_eyes(&point.track),
            baseline: self.document.settings.baseline(),
            model,
        }
    }

    /// Returns the key of the fit: of the own data if there are any, else of the selected point.
    #[must_use]
    pub fn fit_key(&self) -> FitKey {
        let setup = self.document.settings.fit;
        let samples = match &self.session.data {
            Some(file) => Samples::Measured(file.clone(), self.document.settings.baseline()),
            None => Samples::Simulated(Simulated::new(
                &self.document.settings,
                &self.document.points.selected().track,
            )),
        };
        FitKey { samples, setup }
    }

    /// Returns the gaze of both eyes now, in parallel, in the axes of the head.
    #[must_use]
    pub fn gaze(&self) -> Gaze {
        self.rider().gaze_to_head(self.view(Eye::Left, [1, 1]).camera.gaze)
    }

    /// The picture of `eye`, `size` in pixels: one look for both eyes, however their panes are rounded to
    /// pixels.
    #[must_use]
    pub fn view(&self, eye: Eye, size: [u32; 2]) -> View {
        let Document { settings, time, .. } = &self.document;
        settings.views_with(&self.look(), *time, size)[eye.index()]
    }

    /// The picture that is corrected: what the left eye sees, whichever geometry is shown.
    #[must_use]
    pub fn view_to_correct(&self, size: [u32; 2]) -> View {
        let mut settings = Settings::clone(&self.document.settings);
        settings.look.geometry = Geometry::Seen;
        self.views_of(&settings, size)[Eye::Left.index()]
    }

    /// Returns the comfort of the views for eyes `separation` apart; `None` where they show no body.
    #[must_use]
    pub fn comfort(&self, separation: f64) -> Option<Comfort> {
        let (Document { settings, scene, .. }, Frame { picture, cm_per_pixel, .. }) =
            (&self.document, &self.frame);
        let views = if separation == settings.motion.d {
            Eye::BOTH.map(|eye| self.view(eye, picture.size))
        } else {
            let mut settings = Settings::clone(settings);
            settings.motion.d = separation;
            self.views_of(&settings, picture.size)
        };
        Comfort::new(scene, &views, settings.screen.viewing_distance / cm_per_pixel)
    }

    /// The views that other `settings` would show now.
    fn views_of(&self, settings: &Settings, size: [u32; 2]) -> [View; 2] {
        let time = self.document.time;
        let look = settings.shown_look(self.subject(), time, self.frame.picture);
        settings.views_with(&look, time, size)
    }

    /// Returns the subject that gazes turn to.
    #[must_use]
    pub fn subject(&self) -> Subject<'_> {
        Subject { scene: &self.document.prepared, tracked: self.document.points.selected().track }
    }

    /// Returns the rate of a clock at `point`, relative to the own clock of its body, at that proper time:
    /// below 1 where it turns.
    #[must_use]
    pub fn slowed(&self, point: &Point, proper_time: f64) -> f64 {
        let turning = self.on_wheel(&point.track, proper_time).map_or(0.0, |wheel| wheel.turning);
        ((1.0 - turning) * (1.0 + turning)).sqrt()
    }

    /// Whether the picture of `eye` is made of the light that it receives at T.
    #[must_use]
    pub fn shows_what_is_received(&self, eye: Eye) -> bool {
        let is_worked_out =
            matches!(self.document.settings.look.geometry, Geometry::Contracted | Geometry::Rest);
        !is_worked_out && !self.sees_as_published(eye)
    }
}
