//! Views of both eyes: their gaze, field of view and zero parallax become two cameras.

use glam::DVec3;
use relativity_core::Aperture;
use relativity_core::math::{asinh, atan2, sinh, tan};
use relativity_render::{Camera, Framing, Gaze, Geometry, Motion, Outline, PreparedScene, Projection, View};

use super::all::Settings;
use super::rider::Rider;
use super::sections::{FOV_AHEAD, LookSettings, USUAL_FOV};
use crate::flags::FieldOfView;
use crate::flags::choices::{GazeChoice, ProjectionChoice, ZeroParallax};
use crate::scene::Track;

/// The most that one eye can be ahead of the other, in parts of their separation, for pictures ruled by the
/// line between them: further on, what is abreast would be seen along that line.
const MOST_AHEAD: f64 = 0.87;

/// The greatest part of a gaze along the line between the eyes that still counts as across it.
const ACROSS: f64 = 1e-3;

/// The field of view of a whole passage at least, degrees: u from -2.5 to 2.5 in a conformal picture.
const FOV_OF_PASSAGE: f64 = 161.23;
/// The share of a strip's height that the outline of what moves has at most.
const SHARE_OF_PASSAGE: f64 = 0.6;
/// Width of the pictures that fields of view are set for, in heights.
const USUAL_ASPECT: f64 = 16.0 / 9.0;
/// A resting picture that is further aside, as a rapidity, is left out of what is framed.
const FARTHEST_RESTING: f64 = 4.0;

/// Returns how many times as wide as usual a picture of this `size` is, relative to its height; at least 1.
fn wider([width, height]: [u32; 2]) -> f64 {
    (f64::from(width) / f64::from(height.max(1)) / USUAL_ASPECT).max(1.0)
}

/// The subject of gazes.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// Scene, with everything that moves.
    pub scene: &'a PreparedScene,
    /// The selected point, at which a gaze at a point looks.
    pub tracked: Track,
}

/// The size of a picture on the screen, which fields of view are fitted to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Canvas {
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Whether a picture wider than usual shows as much in height: before an audience.
    pub keeps_height: bool,
}

impl Settings {
    /// Returns the views of the left and the right eye at `observation_time`, `size` in pixels, as they look
    /// at `subject`.
    #[must_use]
    pub fn views(&self, subject: Subject, observation_time: f64, size: [u32; 2]) -> [View; 2] {
        self.views_with(&self.fixed_look(subject, observation_time, size), observation_time, size)
    }

    /// Returns the look of both eyes at `subject` at `observation_time` in pictures of this `size`, as a gaze
    /// that stays there and a field of view, in degrees, and a distance of zero parallax: the numbers from
    /// which a view is made, so that recorded ones give the same view to the last digit.
    ///
    /// Two pictures that are compared have the wider of their fields of view, and this is the gaze of the
    /// first.
    #[must_use]
    pub fn fixed_look(&self, subject: Subject, observation_time: f64, size: [u32; 2]) -> LookSettings {
        let look = self.own_look(subject, observation_time, size);
        match self.second() {
            Some(second) if self.look.set_fov().is_none() => {
                let other = second.own_look(subject, observation_time, size);
                let fov = if other.fov.0 > look.fov.0 { other.fov } else { look.fov };
                LookSettings { fov, ..look }
            }
            _ => look,
        }
    }

    /// Returns the same look as it is shown: on a canvas that keeps its height, a field of view that is set
    /// is that of a picture of 16:9, and a wider one shows as much in height and more at its sides.
    #[must_use]
    pub fn shown_look(
        &self,
        subject: Subject,
        observation_time: f64,
        Canvas { size, keeps_height }: Canvas,
    ) -> LookSettings {
        let look = self.fixed_look(subject, observation_time, size);
        match self.look.set_fov().filter(|_| keeps_height) {
            Some(fov) => LookSettings { fov: FieldOfView(Some(self.widened_fov(fov, size))), ..look },
            None => look,
        }
    }

    /// Returns a field of view of a picture of 16:9 as that of a wider one of this `size`, degrees.
    #[must_use]
    pub fn widened_fov(&self, fov: f64, size: [u32; 2]) -> f64 {
        self.scaled_fov(fov, wider(size))
    }

    /// Returns the field of view of a picture of this `size` as that of 16:9, if that is less wide, degrees.
    #[must_use]
    pub fn narrowed_fov(&self, fov: f64, size: [u32; 2]) -> f64 {
        self.scaled_fov(fov, 1.0 / wider(size))
    }

    /// The field of view of a picture so many times as wide on the same scale, degrees.
    fn scaled_fov(&self, fov: f64, times: f64) -> f64 {
        if times == 1.0 {
            return fov;
        }
        let half = tan(0.5 * fov.to_radians());
        let half = match self.projection() {
            ProjectionChoice::Mercator => sinh(times * asinh(half)),
            _ => times * half,
        };
        let range = self.look.fov_range();
        (2.0 * atan2(half, 1.0)).to_degrees().clamp(*range.start(), *range.end())
    }

    /// Returns the look of both eyes at `subject` in a picture that is not compared with another.
    fn own_look(&self, subject: Subject, observation_time: f64, size: [u32; 2]) -> LookSettings {
        let framing = match self.look.gaze {
            GazeChoice::Whole | GazeChoice::Passage => self.framing(subject.scene, observation_time),
            _ => None,
        };
        let rider = self.rider(observation_time);
        let gaze = match self.look.gaze {
            GazeChoice::Point => self.gaze_at(&subject.tracked, observation_time),
            other => other.fixed().or(framing.map(|framing| rider.gaze_to_head(framing.gaze))),
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
        let zero_parallax =
            self.zero_parallax(&LookSettings { gaze, ..self.look }, &steady, observation_time);
        let look = LookSettings { gaze, zero_parallax, ..self.look };
        let whole = whole.map(|framing| framing.shifted(self.shifts(&look)));
        let fitted = || match self.look.gaze {
            GazeChoice::Passage => self.passage_fov(framing, size),
            _ => whole.map_or(USUAL_FOV, |whole| whole.horizontal_fov(size).to_degrees()),
        };
        let fov = FieldOfView(Some(self.look.set_fov().unwrap_or_else(fitted)));
        let look = LookSettings {
            gaze: whole.map_or(gaze, |whole| fixed_at(Some(rider.gaze_to_head(whole.gaze)))),
            fov,
            ..look
        };
        // Where pictures turn with the gaze, the shift has turned a little, too.
        let unshifted = LookSettings { zero_parallax: self.look.zero_parallax, ..look };
        LookSettings { zero_parallax: self.zero_parallax(&unshifted, &steady, observation_time), ..look }
    }

    /// The framing of what moves with the `scene`; of its resting picture, too, where that is outlined.
    fn framing(&self, scene: &PreparedScene, observation_time: f64) -> Option<Framing> {
        let framing = self.framing_of_all(scene, observation_time)?;
        let rapidity = self.velocity(Motion::Scene).rapidity();
        let slides = self.baseline().is_along_motion() && self.geometry() == Geometry::Seen;
        let is_outlined = self.window.resting && slides && rapidity.abs() <= FARTHEST_RESTING;
        Some(if is_outlined { framing.and_slid(rapidity) } else { framing })
    }

    /// The field of view of the whole passage, degrees: u from -2.5 to 2.5, or as far as pictures of this
    /// `size` have to reach for what moves to have room in their height, as the `framing` has it.
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

    /// Returns the zero parallax of eyes with this `look`, whose gaze is fixed: a distance instead of
    /// `point`.
    fn zero_parallax(&self, look: &LookSettings, point: &Track, observation_time: f64) -> ZeroParallax {
        let is_followed = look.zero_parallax == ZeroParallax::Point;
        if !look.projection.is_fused() || !is_followed {
            return look.zero_parallax;
        }
        let [camera, _] = self.cameras_with(look, [1, 1]);
        let along_baseline = self.rows_along_baseline(look);
        let columns = self.directions_from_head(point, observation_time).map(|direction| {
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

    /// The framing of all that moves in the `scene`, in both eyes together.
    #[must_use]
    pub fn framing_of_all(&self, scene: &PreparedScene, observation_time: f64) -> Option<Framing> {
        scene.framing(&self.views_ahead(observation_time))
    }

    /// The gaze at `point`: as far to the left of it in one picture as to the right in the other.
    fn gaze_at(&self, point: &Track, observation_time: f64) -> Option<Gaze> {
        let [left, right] = self.directions_from_head(point, observation_time);
        let directions = [left?, right?];
        if self.projection() == ProjectionChoice::Gaze {
            return Gaze::towards(directions);
        }
        // It is the columns that have a mean. Both directions are cut off equally far from the line through
        // the eyes; then they are tangents, and of a conformal picture their arsinh.
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

    /// The same directions in the axes of the head.
    fn directions_from_head(&self, point: &Track, observation_time: f64) -> [Option<DVec3>; 2] {
        let rider = self.rider(observation_time);
        self.directions(point, observation_time).map(|direction| direction.map(|there| rider.to_head(there)))
    }

    /// The views of eyes that look straight ahead, in pictures of no matter what size.
    pub(crate) fn views_ahead(&self, observation_time: f64) -> [View; 2] {
        self.views_with(&LookSettings { gaze: GazeChoice::Ahead, ..self.look }, observation_time, [1, 1])
    }

    /// The views of eyes with this `look`, which follows nothing.
    #[must_use]
    pub fn views_with(&self, look: &LookSettings, observation_time: f64, size: [u32; 2]) -> [View; 2] {
        let geometry = self.geometry();
        let rider = self.rider(observation_time);
        let odometers = self.ride.odometers(observation_time).filter(|_| self.ride.is_on());
        let rolled = odometers.map_or(0.0, |odometers| odometers.rolled);
        let [left, mut right] = self.cameras_with(look, size);
        // The published right eye's view is from where the left eye is.
        if geometry == Geometry::Published {
            (right.aperture, right.off_middle) = (left.aperture, left.off_middle);
        }
        let [_, behind, below] = self.rest_place([0.0; 3]);
        [(left, geometry.of_left_eye()), (right, geometry)].map(|(camera, geometry)| {
            let camera = carried(camera, &rider);
            let DVec3 { x, y, z } = camera.off_middle;
            let (eye, observation_time) = rider.event_of(Aperture { x, y, z });
            let aperture = Aperture { y: eye.y - behind, z: eye.z - below, ..eye };
            let camera = Camera { aperture, velocity: rider.observer().velocity, rolled, ..camera };
            View { camera, speed: self.speed(), observation_time, geometry }
        })
    }

    /// The projection of both pictures: none along the baseline suits both eyes where one is behind the
    /// other.
    #[must_use]
    pub fn projection(&self) -> ProjectionChoice {
        // Who rides looks where that leads, and who stands across the street.
        let ahead = if self.ride.is_on() { DVec3::from(self.ride.direction()) } else { DVec3::Y };
        let ahead = DVec3::from(self.baseline().direction()).dot(ahead);
        match self.look.projection {
            ProjectionChoice::Parallel if self.looks_across_baseline() => ProjectionChoice::Parallel,
            fused if fused.is_fused() && ahead.abs() > MOST_AHEAD => ProjectionChoice::Gaze,
            projection => projection,
        }
    }

    /// Whether the pictures have a ruler below them, of the rapidity by which motion slides what is seen:
    /// conformal ones of a head along the motion.
    #[must_use]
    pub fn has_ruler(&self) -> bool {
        let slides = self.baseline().is_along_motion() && self.projection() == ProjectionChoice::Mercator;
        self.window.ruler && slides
    }

    /// Whether both eyes have a fixed gaze across the line between them, wherever that is.
    fn looks_across_baseline(&self) -> bool {
        let is_fixed = matches!(self.look.gaze, GazeChoice::Fixed(_));
        let gaze = self.look.gaze.fixed().filter(|_| is_fixed);
        gaze.is_some_and(|gaze| gaze.axes().forward.dot(self.baseline_direction()).abs() < ACROSS)
    }

    /// The cameras of eyes with this `look`, which follows nothing.
    fn cameras_with(&self, look: &LookSettings, size: [u32; 2]) -> [Camera; 2] {
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

    /// The image shifts of the left and the right eye's pictures with this `look`: what the left eye has
    /// further to the right comes together with what the right eye has.
    fn shifts(&self, look: &LookSettings) -> [f64; 2] {
        let half = 0.5 * look.zero_parallax.shift(self.motion.d);
        [-half, half].map(|shift| shift * self.rows_along_baseline(look))
    }

    /// 1 where the rows of pictures run as the baseline does, -1 where they run against it, behind the head.
    fn rows_along_baseline(&self, look: &LookSettings) -> f64 {
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
}

/// `camera`, whose directions are in the axes of the head of `rider`, with them in the observer's.
fn carried(camera: Camera, rider: &Rider) -> Camera {
    let turned = |right| rider.from_head(right);
    let projection = match camera.projection {
        Projection::Gaze => Projection::Gaze,
        Projection::Parallel { right, shift } => Projection::Parallel { right: turned(right), shift },
        Projection::Mercator { right, shift } => Projection::Mercator { right: turned(right), shift },
        Projection::Vr180 { right } => Projection::Vr180 { right: turned(right) },
    };
    let (gaze, off_middle) = (rider.gaze_from_head(camera.gaze), turned(camera.off_middle));
    Camera { gaze, off_middle, projection, ..camera }
}
