//! The two eyes before a scene: places, velocities, times, and what they see of a point. One source for the
//! window and for `gamow render`.

use glam::DVec3;
use relativity_core::{
    Aperture, Baseline, Disparity, Leg, Model, Observer, ObserverError, ObserverVelocity, PairError,
    PublishedVariant, Source, SourcePoint, Speed, Stereo, equidistance_time,
};
use relativity_render::{Geometry, MaterialPoint, Motion, RelativeVelocity, Velocity};
use thiserror::Error;

use super::all::Settings;
use super::rider::Rider;
use super::sections::{self, MapFrame};
use crate::flags::MAX_TIME;
use crate::scene::{Scene, SceneError, Track};
use crate::time_range;

/// Eyes that cannot ride, since they cannot keep their distance.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(
    "--ride: at a proper acceleration of {acceleration} eyes keep their distance only where --d is below \
     {most}, and it is {separation}", most = 2.0 / .acceleration
)]
pub struct EyesTooFarApart {
    separation: f64,
    acceleration: f64,
}

impl Settings {
    /// The scene that they name, with or without what rests around what moves; with a bicycle below eyes that
    /// ride along the street.
    ///
    /// # Errors
    /// A scene that cannot be had.
    pub fn opened_scene(&self) -> Result<Scene, SceneError> {
        Ok(self.furnished(Scene::open(&self.scene)?))
    }

    /// Returns `scene` as it is shown: without surroundings that are left out, with the bicycle that is
    /// ridden.
    #[must_use]
    pub fn furnished(&self, scene: Scene) -> Scene {
        let scene = if self.light.surroundings { scene } else { scene.without_surroundings() };
        if self.ride.has_bicycle() { scene.with_own_bicycle() } else { scene }
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

    /// The observer when the clock of the ride shows `time`; at rest at this T without a ride.
    #[must_use]
    pub fn rider(&self, time: f64) -> Rider {
        self.ride.rider(time)
    }

    /// Returns the places of the left and the right eye, in the scene's coordinates: it passes further away
    /// or higher where they stand back or lower.
    #[must_use]
    pub fn apertures(&self) -> [Aperture; 2] {
        let sections::MotionSettings { depth_shift, height_shift, .. } = self.motion;
        self.pair().map(|Aperture { x, y, z }| Aperture { x, y: y - depth_shift, z: z - height_shift })
    }

    /// From the left to the right eye.
    #[must_use]
    pub const fn baseline(&self) -> Baseline {
        let sections::MotionSettings { d, roll, turn, .. } = self.motion;
        Baseline { separation: d, roll: roll.to_radians(), turn: turn.to_radians() }
    }

    /// The same at `time` in the observer's axes, in which the head of who is pushed aside turns.
    #[must_use]
    pub fn baseline_at(&self, time: f64) -> Baseline {
        self.rider(time).baseline(self.baseline())
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

    /// Returns this place of the scene at rest, relative to the middle of the eyes.
    #[must_use]
    pub fn rest_place(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        [x, y + self.motion.depth_shift, z + self.motion.height_shift]
    }

    /// `point` in the frame of its group, from the point between the eyes.
    #[must_use]
    pub fn from_between_eyes(&self, point: &Track) -> MaterialPoint {
        point.point().moved(self.rest_place([0.0; 3]))
    }

    /// The velocity on the ground of what moves so; none of what rides along with the eyes, which has no
    /// point to follow.
    #[must_use]
    pub const fn velocity(&self, motion: Motion) -> Velocity {
        match motion {
            Motion::Scene => Velocity::forward(self.speed()),
            Motion::Own(velocity) => velocity,
            Motion::WithEyes => Velocity::REST,
        }
    }

    /// The velocity on the ground of the frame that the map is drawn in at `time`.
    #[must_use]
    pub fn frame(&self, time: f64) -> ObserverVelocity {
        match self.map.frame {
            MapFrame::Ground => ObserverVelocity::REST,
            MapFrame::Bicycle => ObserverVelocity::along_street(self.speed()),
            MapFrame::Rider => self.rider(time).observer().velocity,
        }
    }

    /// The frame that the map is drawn in: that of the ground for that of eyes that do not ride.
    #[must_use]
    pub fn map_frame(&self) -> MapFrame {
        if self.map.frame == MapFrame::Rider && !self.ride.is_on() {
            MapFrame::Ground
        } else {
            self.map.frame
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

    /// Returns where `point` is at `time`, relative to the middle of the eyes. While riding: in the rider's
    /// rest frame, and for a point on a wheel its hub.
    #[must_use]
    pub fn measured_place(&self, point: &Track, time: f64) -> [f64; 3] {
        let velocity = self.velocity(point.motion);
        if self.ride.is_on() {
            let (rider, place) = (self.rider(time), self.rest_place(point.axle()));
            if !self.ride.is_along_street() {
                return past_aslant(velocity, &rider.observer(), place);
            }
            let past = velocity.past(&rider.observer(), place).map_or(f64::NAN, |(_, there)| there.x0);
            let [_, y, z] = place;
            return [if velocity.seen_from(rider.along_street()).is_backward { -past } else { past }, y, z];
        }
        let there = self.source(point).place_when_measured(&velocity.speed, time);
        let x = there.worldline(&velocity.speed).at(time).x;
        [if velocity.is_backward { -x } else { x }, there.y, there.z]
    }

    /// The geometry that is shown: the one set, or as seen in place of the published one, which has both eyes
    /// at rest along the motion, where they ride or the head is tilted or turned.
    #[must_use]
    pub fn geometry(&self) -> Geometry {
        match self.look.geometry {
            Geometry::Published if self.ride.is_on() || !self.baseline().is_along_motion() => Geometry::Seen,
            geometry => geometry,
        }
    }

    /// Whether the geometry that is set can be shown.
    ///
    /// # Errors
    /// The published one of eyes that ride, or with the head tilted or turned.
    pub fn check_geometry(&self) -> Result<(), ObserverError> {
        let published = Model::Published(PublishedVariant::AppendixA);
        if self.geometry() == self.look.geometry {
            Ok(())
        } else if self.ride.is_on() {
            Err(ObserverError::Published(published))
        } else {
            Err(PairError::OffTheMotion(published).into())
        }
    }

    /// Whether both eyes can keep their distance during the ride. The horizon of a proper acceleration a is
    /// 1/a behind: no eye is there.
    ///
    /// # Errors
    /// A leg at which the eyes are too far apart.
    pub fn check_eyes(&self) -> Result<(), EyesTooFarApart> {
        let legs = self.ride.ride.0.as_deref().unwrap_or_default();
        let separation = self.motion.d;
        let greatest = legs.iter().map(Leg::magnitude).fold(0.0, f64::max);
        if 0.5 * separation * greatest < 1.0 {
            Ok(())
        } else {
            Err(EyesTooFarApart { separation, acceleration: greatest })
        }
    }

    /// The binocular model of what the views show.
    #[must_use]
    pub fn shown_model(&self) -> Model {
        match self.geometry() {
            Geometry::Published => Model::Published(PublishedVariant::AppendixA),
            _ => self.model(),
        }
    }

    /// Returns the binocular model that descriptions use: one light cone for both eyes where the views show
    /// that, else the exact one. (The paper's has a right eye that is nowhere.)
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
    pub fn disparity(&self, point: &Track, observation_time: f64) -> Result<Disparity, ObserverError> {
        self.disparity_by(self.model(), point, observation_time)
    }

    /// Returns the disparity of `point` by the [`Self::shown_model`]: what the views show.
    ///
    /// # Errors
    /// A time outside the domain of the core.
    pub fn shown_disparity(&self, point: &Track, observation_time: f64) -> Result<Disparity, ObserverError> {
        self.disparity_by(self.shown_model(), point, observation_time)
    }

    fn disparity_by(&self, model: Model, point: &Track, time: f64) -> Result<Disparity, ObserverError> {
        let place = self.from_between_eyes(point);
        let rider = self.rider(time);
        let pair = rider.baseline(self.baseline()).apertures();
        self.velocity(point.motion).disparity_before(&rider.observer(), model, place, pair)
    }

    /// Returns the stereo position of `point` at `observation_time`, by the [`Self::model`] of the views.
    ///
    /// # Errors
    /// A time outside the domain of the core; lines of sight that do not meet.
    pub fn stereo(&self, point: &Track, observation_time: f64) -> Result<Stereo, ObserverError> {
        let place = self.from_between_eyes(point);
        let rider = self.rider(observation_time);
        // Of eyes in one place the limit.
        let pair = rider.baseline(self.baseline()).stereo_apertures(self.ride.is_on());
        self.velocity(point.motion).stereo_before(&rider.observer(), self.model(), place, pair)
    }

    /// Returns the velocity at which `point`, or the hub that it turns about, passes the observer, and its
    /// place by the observer's clock, reflected to move along +x. `None` where the observer's velocity
    /// changes, or is not along the street.
    #[must_use]
    pub fn passage(&self, point: &Track) -> Option<(Velocity, SourcePoint)> {
        let velocity = self.velocity(point.motion);
        if !self.ride.is_on() {
            return Some((velocity, self.carrier(point)));
        }
        let place = self.rest_place(point.axle());
        let rider = self.rider(0.0);
        let seen = velocity.seen_from(rider.along_street());
        let coasts = self.ride.coasts_along_street();
        let (speed, there) = velocity.past(&rider.observer(), place).filter(|_| coasts)?;
        let [_, y, z] = place;
        Some((Velocity { speed, ..seen }, SourcePoint { y, z, ..there }))
    }

    /// T0 of `point`, also of one that turns: when both eyes see it at the same distance. `None` at rest, and
    /// where that is always or never so.
    #[must_use]
    pub fn equidistance_time(&self, point: &Track) -> Option<f64> {
        let (velocity, place) = self.passage(point)?;
        let pair = velocity.reflected_pair(self.baseline().apertures_or_limit());
        let source = if self.ride.is_on() { place.into() } else { self.source(point) };
        equidistance_time(&velocity.speed, source, pair).ok().flatten()
    }

    /// When `point` is measured beside the eyes: at x = 0, where it is seen only later. `None` at rest.
    #[must_use]
    pub fn abreast_time(&self, point: &Track) -> Option<f64> {
        if self.ride.is_on() {
            let (velocity, place) = self.passage(point)?;
            return Source::Point(place).time_at_origin(&velocity.speed);
        }
        self.source(point).time_at_origin(&self.velocity(point.motion).speed)
    }

    /// First and last T of the scrubber and the plots: those that are set, else all legs of the ride, or else
    /// as `point`, or the hub that it turns about, passes.
    #[must_use]
    pub fn time_range(&self, point: &Track) -> [f64; 2] {
        let fitted = || {
            let Some((velocity, place)) = self.passage(point) else { return self.range_of_ride(point) };
            let pair = velocity.reflected_pair(self.pair());
            let range = time_range::fitted_range(&velocity.speed, place, pair);
            range.map(|time| time.clamp(-MAX_TIME, MAX_TIME))
        };
        self.playback.range.0.unwrap_or_else(fitted)
    }

    /// First and last time of the legs of a ride; of one that only coasts, as `point` passes.
    fn range_of_ride(&self, point: &Track) -> [f64; 2] {
        let (velocity, observer) = (self.velocity(point.motion), self.rider(0.0).observer());
        let past = velocity.past(&observer, self.rest_place(point.axle()));
        let Some((speed, place)) = past.filter(|_| self.ride.coasts()) else {
            return [0.0, self.ride.duration()];
        };
        let axes = RelativeVelocity::new(velocity, &observer.velocity);
        let pair = self.pair().map(|eye| {
            let DVec3 { x, y, z } = axes.motion_from_camera(DVec3::new(eye.x, eye.y, eye.z));
            Aperture { x, y, z }
        });
        time_range::fitted_range(&speed, place, pair).map(|time| time.clamp(-MAX_TIME, MAX_TIME))
    }

    /// The T of a picture for which none is given: when `point`, or the hub that it turns about, is seen 45
    /// degrees before it is abreast.
    #[must_use]
    pub fn time_of_approach(&self, point: &Track) -> f64 {
        let Some((Velocity { speed, .. }, place)) = self.passage(point) else { return 0.0 };
        // Settings lie inside the domain of the core.
        time_range::time_of_approach(&speed, place, self.pair()).unwrap_or_default()
    }
}

/// The place in the axes of `observer`, when its clock shows 0, of what is at `place` in the frame that moves
/// at `velocity`.
fn past_aslant(velocity: Velocity, observer: &Observer, place: [f64; 3]) -> [f64; 3] {
    let Some((_, SourcePoint { x0, y, z })) = velocity.past(observer, place) else { return [f64::NAN; 3] };
    let axes = RelativeVelocity::new(velocity, &observer.velocity);
    axes.camera_from_motion(DVec3::new(x0, y, z)).to_array()
}
