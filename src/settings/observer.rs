//! Views of a scene by the two eyes with these settings: the one source for the window and for `gamow render`.

use glam::DVec3;
use relativity_core::math::{asinh, sinh};
use relativity_core::{
    Aperture, Baseline, Disparity, Model, PairError, PublishedVariant, Source, SourcePoint, Speed, Stereo,
    StereoError, equidistance_time,
};
use relativity_render::exposure::automatic_ev;
use relativity_render::{
    Appearance, Camera, Framing, Gaze, Geometry, MaterialPoint, Motion, Outline, PreparedScene, Projection,
    Velocity, View,
};

use super::all::Settings;
use super::sections::{self, Daylight, FOV_AHEAD, Frame, Light, Look, Theme, USUAL_FOV};
use crate::flags::choices::{GazeChoice, ProjectionChoice, ZeroParallax};
use crate::flags::{Exposure, FieldOfView, MAX_TIME};
use crate::scene::{Scene, SceneError, Track};
use crate::time_range;

/// The most that one eye can be ahead of the other, in parts of their separation, for pictures ruled by the line between them:
/// further on, what is abreast would be seen along that line.
const MOST_AHEAD: f64 = 0.87;

/// The field of view of a whole passage at least, degrees: u from -2.5 to 2.5 in a conformal picture.
const FOV_OF_PASSAGE: f64 = 161.23;
/// The share of a strip's height that the outline of what moves has at most: the ruler takes some of the rest.
const SHARE_OF_PASSAGE: f64 = 0.6;
/// A resting picture that is further aside, as a rapidity, is left out of what is framed.
const FARTHEST_RESTING: f64 = 4.0;

/// The subject of gazes.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// Scene, with everything that moves.
    pub scene: &'a PreparedScene,
    /// The point that is tracked.
    pub tracked: Track,
}

impl Settings {
    /// The scene that they name, with or without what rests around what moves.
    ///
    /// # Errors
    /// A scene that cannot be had.
    pub fn opened_scene(&self) -> Result<Scene, SceneError> {
        let scene = Scene::open(&self.scene)?;
        Ok(if self.light.surroundings { scene } else { scene.without_surroundings() })
    }

    /// The point of `scene` that is tracked. One that is among the followed points moves with its body.
    #[must_use]
    pub fn track(&self, scene: &Scene) -> Track {
        let followed = self.points.iter().flat_map(|points| &points.0);
        let found = self.point.and_then(|place| followed.clone().find(|point| point.place == place));
        found
            .and_then(|point| scene.track_at(point.place, point.body))
            .unwrap_or_else(|| scene.track(self.point))
    }

    /// The speed of the scene.
    #[must_use]
    pub const fn speed(&self) -> Speed {
        self.motion.speed.speed()
    }

    /// Returns the places of the left and the right eye, in the scene's coordinates: it passes further away or higher where they
    /// stand back or lower.
    #[must_use]
    pub fn apertures(&self) -> [Aperture; 2] {
        let sections::Motion { depth_shift, height_shift, .. } = self.motion;
        self.pair().map(|Aperture { x, y, z }| Aperture { x, y: y - depth_shift, z: z - height_shift })
    }

    /// From the left to the right eye.
    #[must_use]
    pub const fn baseline(&self) -> Baseline {
        let sections::Motion { d, roll, turn, .. } = self.motion;
        Baseline { separation: d, roll: roll.to_radians(), turn: turn.to_radians() }
    }

    /// Returns the places of both eyes, from the point between them.
    #[must_use]
    pub fn pair(&self) -> [Aperture; 2] {
        self.baseline().apertures()
    }

    /// Unit vector from the left eye to the right one, where they are in one place too.
    #[must_use]
    pub fn baseline_direction(&self) -> DVec3 {
        self.baseline().direction().into()
    }

    /// The place `rest` in the scene, from the point between the eyes.
    #[must_use]
    pub fn rest_place(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        [x, y + self.motion.depth_shift, z + self.motion.height_shift]
    }

    /// `point` in the frame of its group, from the point between the eyes.
    #[must_use]
    pub fn from_between_eyes(&self, point: &Track) -> MaterialPoint {
        point.point().moved(self.rest_place([0.0; 3]))
    }

    /// The velocity of what moves so.
    #[must_use]
    pub const fn velocity(&self, motion: Motion) -> Velocity {
        match motion {
            Motion::Scene => Velocity::forward(self.speed()),
            Motion::Own(velocity) => velocity,
        }
    }

    /// The velocity of the frame that the map is drawn in.
    #[must_use]
    pub const fn frame(&self) -> Velocity {
        match self.map.frame {
            Frame::Ground => Velocity::REST,
            Frame::Bicycle => Velocity::forward(self.speed()),
        }
    }

    /// The worldline of `point` from the point between the eyes, reflected to move along +x.
    #[must_use]
    pub fn source(&self, point: &Track) -> Source {
        self.velocity(point.motion).reflected_source(self.from_between_eyes(point))
    }

    /// Returns the source that `point` rides along with: the hub that it turns about, or itself.
    #[must_use]
    pub fn carrier(&self, point: &Track) -> SourcePoint {
        self.source(point).place()
    }

    /// Returns the place where `point` is measured at `time`, from the point between the eyes.
    #[must_use]
    pub fn measured_place(&self, point: &Track, time: f64) -> [f64; 3] {
        let velocity = self.velocity(point.motion);
        let SourcePoint { x0, y, z } = self.source(point).place_when_measured(&velocity.speed, time);
        let x = x0 + velocity.speed.beta() * time;
        [if velocity.is_backward { -x } else { x }, y, z]
    }

    /// The geometry that is shown: the one set, or as seen in place of the published one, which has both eyes along the
    /// motion, where the head is tilted or turned.
    #[must_use]
    pub fn geometry(&self) -> Geometry {
        match self.look.geometry {
            Geometry::Published if !self.baseline().is_along_motion() => Geometry::Seen,
            geometry => geometry,
        }
    }

    /// Whether the geometry that is set can be shown.
    ///
    /// # Errors
    /// The published one with the head tilted or turned.
    pub fn check_geometry(&self) -> Result<(), PairError> {
        let published = Model::Published(PublishedVariant::AppendixA);
        if self.geometry() == self.look.geometry { Ok(()) } else { Err(PairError::OffTheMotion(published)) }
    }

    /// The binocular model of what the views show.
    #[must_use]
    pub fn shown_model(&self) -> Model {
        match self.geometry() {
            Geometry::Published => Model::Published(PublishedVariant::AppendixA),
            _ => self.model(),
        }
    }

    /// Returns the binocular model that descriptions use: one light cone for both eyes where the views show that,
    /// else the exact one. (The paper's has a right eye that is nowhere.)
    #[must_use]
    pub fn model(&self) -> Model {
        match self.geometry() {
            Geometry::OneCone => Model::OneCone,
            Geometry::Seen | Geometry::Contracted | Geometry::Rest | Geometry::Published => Model::Exact,
        }
    }

    /// Returns the disparity of `point` at `observation_time`, by the [`Self::model`].
    ///
    /// # Errors
    /// A time outside the domain of the core.
    pub fn disparity(&self, point: &Track, observation_time: f64) -> Result<Disparity, PairError> {
        self.disparity_by(self.model(), point, observation_time)
    }

    /// The same by the [`Self::shown_model`]: what the views show.
    ///
    /// # Errors
    /// A time outside the domain of the core.
    pub fn shown_disparity(&self, point: &Track, observation_time: f64) -> Result<Disparity, PairError> {
        self.disparity_by(self.shown_model(), point, observation_time)
    }

    fn disparity_by(&self, model: Model, point: &Track, time: f64) -> Result<Disparity, PairError> {
        self.velocity(point.motion).disparity(model, self.from_between_eyes(point), self.pair(), time)
    }

    /// Returns the stereo position of `point` at `observation_time`, by the [`Self::model`] of the views.
    ///
    /// # Errors
    /// A time outside the domain of the core; lines of sight that do not meet.
    pub fn stereo(&self, point: &Track, observation_time: f64) -> Result<Stereo, StereoError> {
        let place = self.from_between_eyes(point);
        self.velocity(point.motion).stereo(
            self.model(),
            place,
            self.baseline().apertures_or_limit(),
            observation_time,
        )
    }

    /// T0 of `point`, also of one that turns: when both eyes see it at the same distance. `None` at rest, and where that is always
    /// or never so.
    #[must_use]
    pub fn equidistance_time(&self, point: &Track) -> Option<f64> {
        let velocity = self.velocity(point.motion);
        let pair = velocity.reflected_pair(self.baseline().apertures_or_limit());
        equidistance_time(&velocity.speed, self.source(point), pair).ok().flatten()
    }

    /// When `point` is measured beside the eyes: at x = 0, where it is seen only later. `None` at rest.
    #[must_use]
    pub fn abreast_time(&self, point: &Track) -> Option<f64> {
        self.source(point).time_at_origin(&self.velocity(point.motion).speed)
    }

    /// First and last T of the scrubber and the plots: those that are set, else as `point`, or the hub that it turns about,
    /// passes.
    #[must_use]
    pub fn time_range(&self, point: &Track) -> [f64; 2] {
        let fitted = || {
            let velocity = self.velocity(point.motion);
            let pair = velocity.reflected_pair(self.pair());
            let range = time_range::fitted_range(&velocity.speed, self.carrier(point), pair);
            range.map(|time| time.clamp(-MAX_TIME, MAX_TIME))
        };
        self.playback.range.0.unwrap_or_else(fitted)
    }

    /// The T of a picture for which none is given: when `point`, or the hub that it turns about, is seen 45 degrees before it is
    /// abreast.
    #[must_use]
    pub fn time_of_approach(&self, point: &Track) -> f64 {
        let speed = self.velocity(point.motion).speed;
        // Settings lie inside the domain of the core.
        time_range::time_of_approach(&speed, self.carrier(point), self.pair()).unwrap_or_default()
    }

    /// Returns the views of the left and the right eye at `observation_time`, `size` in pixels, as they look at `subject`.
    #[must_use]
    pub fn views(&self, subject: Subject, observation_time: f64, size: [u32; 2]) -> [View; 2] {
        self.views_with(&self.fixed_look(subject, observation_time, size), observation_time, size)
    }

    /// Returns the look of both eyes at `subject` at `observation_time` in pictures of this `size`, as a gaze that stays there and
    /// a field of view, in degrees, and a distance of zero parallax: the numbers from which a view is made, so that
    /// recorded ones give the same view to the last digit.
    ///
    /// Two pictures that are compared have the wider of their fields of view, and this is the gaze of the first.
    #[must_use]
    pub fn fixed_look(&self, subject: Subject, observation_time: f64, size: [u32; 2]) -> Look {
        let look = self.own_look(subject, observation_time, size);
        match self.second() {
            Some(second) if self.look.set_fov().is_none() => {
                let other = second.own_look(subject, observation_time, size);
                let fov = if other.fov.0 > look.fov.0 { other.fov } else { look.fov };
                Look { fov, ..look }
            }
            _ => look,
        }
    }

    /// The same of a picture that is not compared with another.
    fn own_look(&self, subject: Subject, observation_time: f64, size: [u32; 2]) -> Look {
        let framing = match self.look.gaze {
            GazeChoice::Whole | GazeChoice::Passage => self.framing(subject.scene, observation_time),
            _ => None,
        };
        let gaze = match self.look.gaze {
            GazeChoice::Point => self.gaze_at(&subject.tracked, observation_time),
            other => other.fixed().or(framing.map(|framing| framing.gaze)),
        };
        // Inside an aperture, and where nothing is, there is no direction to follow.
        let fixed_at = |gaze: Option<Gaze>| GazeChoice::fixed_at(gaze.unwrap_or(Gaze::STRAIGHT_AHEAD));
        let (gaze, whole) = match self.look.gaze {
            GazeChoice::Fixed(degrees) => (GazeChoice::Fixed(degrees), None),
            GazeChoice::Passage => (fixed_at(gaze.map(|gaze| self.abreast(gaze))), None),
            _ => (fixed_at(gaze), framing),
        };
        // A point that turns would have the pictures sway with each turn.
        let steady = subject.tracked.carrier();
        let zero_parallax = self.zero_parallax(&Look { gaze, ..self.look }, &steady, observation_time);
        let look = Look { gaze, zero_parallax, ..self.look };
        let whole = whole.map(|framing| framing.shifted(self.shifts(&look)));
        let fitted = || match self.look.gaze {
            GazeChoice::Passage => self.passage_fov(framing, size),
            _ => whole.map_or(USUAL_FOV, |whole| whole.horizontal_fov(size).to_degrees()),
        };
        let fov = FieldOfView(Some(self.look.set_fov().unwrap_or_else(fitted)));
        let look = Look { gaze: whole.map_or(gaze, |whole| fixed_at(Some(whole.gaze))), fov, ..look };
        // Where pictures turn with the gaze, the shift has turned a little, too.
        let unshifted = Look { zero_parallax: self.look.zero_parallax, ..look };
        Look { zero_parallax: self.zero_parallax(&unshifted, &steady, observation_time), ..look }
    }

    /// The framing of what moves with the `scene`; of its resting picture, too, where that is outlined.
    fn framing(&self, scene: &PreparedScene, observation_time: f64) -> Option<Framing> {
        let framing = self.outline(scene, observation_time).framing()?;
        let rapidity = self.velocity(Motion::Scene).rapidity();
        let slides = self.baseline().is_along_motion() && self.geometry() == Geometry::Seen;
        let is_outlined = self.window.resting && slides && rapidity.abs() <= FARTHEST_RESTING;
        Some(if is_outlined { framing.and_slid(rapidity) } else { framing })
    }

    /// The field of view of the whole passage, degrees: u from -2.5 to 2.5, or as far as pictures of this `size` have to reach
    /// for what moves to have room in their height, as the `framing` has it.
    fn passage_fov(&self, framing: Option<Framing>, size: [u32; 2]) -> f64 {
        if self.projection() != ProjectionChoice::Mercator {
            return FOV_AHEAD;
        }
        let by_height = framing.map(|framing| framing.fov_by_height(size, SHARE_OF_PASSAGE).to_degrees());
        by_height.unwrap_or(0.0).max(FOV_OF_PASSAGE)
    }

    /// The gaze across the line between the eyes that is as high above it as `gaze`.
    fn abreast(&self, gaze: Gaze) -> Gaze {
        let across = gaze.axes().forward.reject_from_normalized(self.baseline_direction());
        across.try_normalize().map_or(gaze, |across| Gaze::along(across.to_array()))
    }

    /// Returns the zero parallax of eyes with this `look`, whose gaze is fixed: a distance instead of `point`.
    fn zero_parallax(&self, look: &Look, point: &Track, observation_time: f64) -> ZeroParallax {
        let is_followed = look.zero_parallax == ZeroParallax::Point;
        if !look.projection.is_fused() || !is_followed {
            return look.zero_parallax;
        }
        let [camera, _] = self.cameras_with(look, [1, 1]);
        let along_baseline = self.rows_along_baseline(look);
        let columns = self.directions(point, observation_time).map(|direction| {
            let place = direction.and_then(|direction| camera.coordinates(direction));
            // There is no place behind the picture plane.
            place.map_or(f64::NAN, |[aside, _]| aside * along_baseline)
        });
        ZeroParallax::of_columns(self.motion.d, columns)
    }

    /// The outline of all that moves in the `scene`, in both eyes together.
    #[must_use]
    pub fn outline(&self, scene: &PreparedScene, observation_time: f64) -> Outline {
        scene.outline(&self.views_ahead(observation_time))
    }

    /// The gaze at `point`: as far to the left of it in one picture as to the right in the other.
    fn gaze_at(&self, point: &Track, observation_time: f64) -> Option<Gaze> {
        let [left, right] = self.directions(point, observation_time);
        let directions = [left?, right?];
        if self.projection() == ProjectionChoice::Gaze {
            return Gaze::towards(directions);
        }
        // It is the columns that have a mean. Both directions are cut off equally far from the line through the eyes; then
        // they are tangents, and of a conformal picture their arsinh.
        let baseline = self.baseline_direction();
        let [left, right] = directions.map(|direction| {
            let off_baseline = direction.reject_from_normalized(baseline);
            (off_baseline.normalize(), direction.dot(baseline) / off_baseline.length())
        });
        let aside = match self.projection() {
            ProjectionChoice::Mercator => 2.0 * sinh(0.5 * (asinh(left.1) + asinh(right.1))),
            _ => left.1 + right.1,
        };
        Gaze::towards([left.0 + right.0 + baseline * aside; 2])
    }

    /// From each eye to where the shown geometry has `point`; `None` outside the domain of the core.
    #[must_use]
    pub fn directions(&self, point: &Track, observation_time: f64) -> [Option<DVec3>; 2] {
        let place = |view: View| view.of_group(point.motion).apparent_position(point.point());
        self.views_ahead(observation_time).map(place)
    }

    /// The views of eyes that look straight ahead, in pictures of no matter what size.
    pub(crate) fn views_ahead(&self, observation_time: f64) -> [View; 2] {
        self.views_with(&Look { gaze: GazeChoice::Ahead, ..self.look }, observation_time, [1, 1])
    }

    /// The views of eyes with this `look`, which follows nothing.
    #[must_use]
    pub fn views_with(&self, look: &Look, observation_time: f64, size: [u32; 2]) -> [View; 2] {
        let geometry = self.geometry();
        let [left, mut right] = self.cameras_with(look, size);
        // The published right eye's view is from where the left eye is.
        if geometry == Geometry::Published {
            (right.aperture, right.off_middle) = (left.aperture, left.off_middle);
        }
        [(left, geometry.of_left_eye()), (right, geometry)].map(|(camera, geometry)| View {
            camera,
            speed: self.speed(),
            observation_time,
            geometry,
        })
    }

    /// The projection of both pictures: none along the baseline suits both eyes where one is behind the other.
    #[must_use]
    pub fn projection(&self) -> ProjectionChoice {
        let [_, ahead, _] = self.baseline().direction();
        match self.look.projection {
            fused if fused.is_fused() && ahead.abs() > MOST_AHEAD => ProjectionChoice::Gaze,
            projection => projection,
        }
    }

    /// The cameras of eyes with this `look`, which follows nothing.
    fn cameras_with(&self, look: &Look, size: [u32; 2]) -> [Camera; 2] {
        let gaze = look.gaze.fixed().unwrap_or(Gaze::STRAIGHT_AHEAD);
        let horizontal_fov = look.set_fov().unwrap_or(USUAL_FOV).to_radians();
        let right = self.baseline_direction();
        let half_separation = 0.5 * self.motion.d;
        let shifts = self.shifts(look);
        let camera = |eye: usize, aperture, side: f64| Camera {
            off_middle: right * (side * half_separation),
            projection: match self.projection() {
                ProjectionChoice::Mercator => Projection::Mercator { right, shift: shifts[eye] },
                ProjectionChoice::Parallel => Projection::Parallel { right, shift: shifts[eye] },
                ProjectionChoice::Gaze => Projection::Gaze,
                ProjectionChoice::Vr180 => Projection::Vr180 { right },
            },
            ..Camera::new(aperture, gaze, horizontal_fov, size)
        };
        let [left, right] = self.apertures();
        [camera(0, left, -1.0), camera(1, right, 1.0)]
    }

    /// The image shifts of the left and the right eye's pictures with this `look`: what the left eye has further to
    /// the right comes together with what the right eye has.
    fn shifts(&self, look: &Look) -> [f64; 2] {
        let half = 0.5 * look.zero_parallax.shift(self.motion.d);
        [-half, half].map(|shift| shift * self.rows_along_baseline(look))
    }

    /// 1 where the rows of pictures run as the baseline does, -1 where they run against it, behind the head.
    fn rows_along_baseline(&self, look: &Look) -> f64 {
        let gaze = look.gaze.fixed().unwrap_or(Gaze::STRAIGHT_AHEAD);
        let (right, plain) = (self.baseline_direction(), Camera::new(Aperture::default(), gaze, 1.0, [1, 1]));
        let camera = Camera { projection: Projection::Parallel { right, shift: 0.0 }, ..plain };
        camera.axes().right.dot(right).signum()
    }

    /// The cameras that took the pictures, `size` in pixels, with which these settings were recorded.
    ///
    /// # Errors
    /// The flag that they lack: that of something that follows what is not recorded.
    pub fn recorded_cameras(&self, size: [u32; 2]) -> Result<[Camera; 2], &'static str> {
        let look = &self.look;
        if look.gaze.fixed().is_none() {
            return Err("--gaze");
        }
        if look.set_fov().is_none() {
            return Err("--fov");
        }
        if look.projection.is_fused() && look.zero_parallax == ZeroParallax::Point {
            return Err("--zero-parallax");
        }
        Ok(self.cameras_with(look, size))
    }

    /// Returns the appearance of `scene`, in a light window or a dark one.
    #[must_use]
    pub fn appearance(&self, scene: &Scene, light_window: bool) -> Appearance {
        let exposure_ev = self.light.exposure.0.unwrap_or_else(|| self.automatic_ev(scene));
        Appearance { exposure_ev, ..self.unexposed(scene, light_window) }
    }

    /// The same without exposure.
    fn unexposed(&self, scene: &Scene, light_window: bool) -> Appearance {
        let light = &self.light;
        Appearance {
            colour: light.colour,
            temperature_k: light.temperature,
            doppler_shift: light.doppler_shift,
            intensity_exponent: light.intensity_exponent.0,
            exposure_ev: 0.0,
            invisible: light.invisible,
            shading: light.shading,
            ground_z: scene.ground_z.filter(|_| light.ground),
            road: scene.street.map(|[near, far, _]| [near, far]),
            fronts: scene.street.map(|[_, _, fronts]| fronts).filter(|_| light.surroundings),
            sky: light.sky,
            light: match light.light {
                Daylight::Theme => light_window,
                Daylight::On => true,
                Daylight::Off => false,
            },
        }
    }

    /// The exposure that is found for `scene`, factors of 2.
    #[must_use]
    pub fn automatic_ev(&self, scene: &Scene) -> f64 {
        let lights = scene.groups.iter().flat_map(|group| {
            let velocity = self.velocity(group.motion);
            scene.bodies[group.bodies()].iter().map(move |body| (velocity, body.emission))
        });
        automatic_ev(lights, self.geometry(), &self.unexposed(scene, false))
    }

    /// These settings with the exposure that `scene` gets by them; where two pictures are compared, each has its own.
    #[must_use]
    pub fn exposed_for(self, scene: &Scene) -> Self {
        if self.is_comparing() {
            return self;
        }
        let exposure = Exposure(self.light.exposure.0.or_else(|| Some(self.automatic_ev(scene))));
        Self { light: Light { exposure, ..self.light }, ..self }
    }

    /// These settings with nothing left to be found out: everything that decides the picture that `self` makes of this
    /// `subject`.
    #[must_use]
    pub fn resolved(&self, subject: Subject) -> Self {
        let time = self.time.unwrap_or_else(|| self.time_of_approach(&subject.tracked));
        let mut resolved = Self { time: Some(time), ..self.clone() };
        // One gaze could not be that of both pictures that are compared: each follows what it shows.
        if !self.is_comparing() {
            resolved.look = self.fixed_look(subject, time, self.picture.size.0);
        }
        if self.light.light == Daylight::Theme {
            resolved.light.light =
                if self.window.theme == Theme::Light { Daylight::On } else { Daylight::Off };
        }
        resolved
    }
}
