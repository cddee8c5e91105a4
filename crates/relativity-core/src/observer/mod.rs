//! An observer who moves: what two eyes see from a bicycle of their own.
//!
//! What an eye receives depends on its event, its velocity there and how the head is held, and on nothing
//! before. The light that arrives is the light that an eye at rest would receive at the same event; only its
//! direction, its colour and the distance that it seems to have come differ. So a moving observer needs no
//! light cone of its own: the point is seen as an eye at rest sees one that moves with the *relative*
//! velocity, in axes along that.
//!
//! # Conventions
//!
//! The observer's axes are the ground's, boosted along the velocity without turning. Apertures are given in
//! these axes, from the middle between the eyes, both at one time of the observer's clock: a head is rigid in
//! its own frame. On the ground eyes along the motion are Gamma d apart. Positions, distances and angles of
//! what is seen are in these axes; the retarded time is by the ground's clocks, and tau by the point's own,
//! as for an observer at rest.
//!
//! An accelerating observer sees at every moment what one sees who moves evenly at that moment's velocity.
//!
//! Reference: W. Rindler, *Introduction to Special Relativity* (1991), for the composition of velocities and
//! aberration. The forms that keep their accuracy were derived here.

mod error;
mod eye;
mod motion;
mod point;
mod relative;
mod relative_velocity;
mod times;
mod velocity;
mod wheel;

pub use self::error::ObserverError;
pub use self::motion::Observer;
pub use self::relative_velocity::RelativeVelocity;
pub use self::velocity::ObserverVelocity;

use self::eye::EyeOnGround;
use self::point::PointView;
use self::relative::RelativeMotion;
use self::times::Middle;
use self::wheel::WheelView;
use crate::aperture::Aperture;
use crate::apparent::{LightCone, Sighting, check_inputs};
use crate::cone_pair::Offset;
use crate::disparity::Disparity;
use crate::domain::check;
use crate::model::Model;
use crate::one_cone;
use crate::source::{Source, SourcePoint, WheelPoint};
use crate::speed::Speed;
use crate::stereo::{Stereo, StereoError, along_motion, meeting};

impl Observer {
    /// Returns the place on the ground of an eye that is at `aperture` in the observer's axes when the
    /// observer's clock shows 0, and T there.
    #[must_use]
    pub fn event_of(&self, aperture: Aperture) -> (Aperture, f64) {
        EyeOnGround::new(&Speed::REST, self, aperture).event(self)
    }

    /// Returns the point's speed past the observer, and its place in axes along that velocity: what eyes at
    /// rest see of this point at T is what the observer's eyes see of theirs when the observer's clock shows
    /// T, but for where the axes point.
    ///
    /// # Errors
    ///
    /// A relative Lorentz factor above [`MAX_GAMMA`](crate::MAX_GAMMA).
    pub fn relative_motion(
        &self,
        speed: &Speed,
        point: SourcePoint,
    ) -> Result<(Speed, SourcePoint), ObserverError> {
        if self.velocity.is_rest() {
            let [x, y, z] = self.place;
            let x0 = point.x0 + speed.beta() * self.time - x;
            return Ok((*speed, SourcePoint { x0, y: point.y - y, z: point.z - z }));
        }
        let RelativeMotion { speed, point, .. } = RelativeMotion::new(speed, self, point)?;
        Ok((speed, point))
    }

    /// Returns the disparity of `source`, which moves along +x at `speed`, when the observer's clock shows
    /// `proper_time`.
    ///
    /// The `pair` of apertures (left, right) is in the observer's axes, from the middle between the eyes; so
    /// are the positions of both sightings, each from its eye. An observer at rest at the origin has the
    /// numbers of [`Model::disparity`] bit for bit.
    ///
    /// # Accuracy
    ///
    /// Positions, distances, D, phi, theta, tau, dphi, dtheta and the stereo position as [`crate::sighting`],
    /// if the directions of the observer's axes and of the head count as inputs that are known to a rounding.
    /// Measured for Lorentz factors to 1e6 each (`tests/oracle`, 5,000 inputs): median 0.2, 99 % 2, worst 4
    /// units; t 99 % 1.4, worst 201 units, where the eyes' own offset on the ground, Gamma V d, dwarfs it. An
    /// observer at rest anywhere: worst 3.7 units. Of
    /// a point of a wheel, for Lorentz factors to 10: 99 % 4, worst 9 units, but dphi and dtheta worst 1,220,
    /// a relative 1.4e-13.
    ///
    /// # Errors
    ///
    /// A coordinate or time outside the domain; a relative Lorentz factor above
    /// [`MAX_GAMMA`](crate::MAX_GAMMA); a published model, or a pair that the model does not know.
    ///
    /// # Examples
    ///
    /// ```
    /// use relativity_core::{Aperture, Model, Observer, ObserverVelocity, SourcePoint, Speed};
    ///
    /// // From a bicycle at 0.9 c a lamp 3 aside and 2 up is seen ahead, and blue, while one is beside it
    /// // already.
    /// let velocity = ObserverVelocity::along_street(Speed::from_beta(0.9)?);
    /// let rider = Observer { velocity, place: [0.0; 3], time: 0.0 };
    /// let lamp = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };
    /// let both = rider.disparity(Model::Exact, &Speed::REST, lamp, Aperture::pair(0.1), 0.0)?;
    /// assert!((both.primary.phi() - 0.371_015_232_6).abs() < 1e-10);
    /// assert!((both.primary.doppler_factor - 2.359_812_302).abs() < 1e-9);
    /// assert!((both.dphi + 0.024_509_901_86).abs() < 1e-11);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn disparity(
        &self,
        model: Model,
        speed: &Speed,
        source: impl Into<Source>,
        pair: [Aperture; 2],
        proper_time: f64,
    ) -> Result<Disparity, ObserverError> {
        let source = source.into();
        if self.velocity.is_rest() {
            return self.disparity_at_rest(model, speed, source, pair, proper_time);
        }
        let observer = self.checked(model, source, pair, proper_time)?;
        let view = match source.simplest() {
            Source::Point(point) => PointView::new(speed, self, point, pair, proper_time)?,
            Source::Wheel(wheel) if model == Model::OneCone => {
                return Ok(one_event(pair, observer.seen_by_middle(speed, &wheel, pair)));
            }
            Source::Wheel(wheel) => return Ok(WheelView::new(speed, &observer, &wheel, pair).disparity()),
        };
        Ok(if model == Model::OneCone { one_event(pair, view.seen_by_middle()) } else { view.disparity() })
    }

    /// Returns the stereo position of `source`, from the middle between the eyes, in the observer's axes;
    /// inputs and errors as for [`Self::disparity`].
    ///
    /// # Errors
    ///
    /// Also lines of sight that do not meet in front of both eyes.
    pub fn stereo(
        &self,
        model: Model,
        speed: &Speed,
        source: impl Into<Source>,
        pair: [Aperture; 2],
        proper_time: f64,
    ) -> Result<Stereo, ObserverError> {
        let source = source.into();
        if self.velocity.is_rest() {
            self.check_place()?;
            let (source, pair) = self.seen_from_place(source, pair);
            let fused = model.stereo(speed, source, pair, self.time + proper_time);
            return fused.map_err(ObserverError::from);
        }
        let observer = self.checked(model, source, pair, proper_time)?;
        // With one cone both look at one event, which they take to be where it is.
        let at_event = |seen: Sighting| Some(Stereo { gain: 1.0, position: seen.position, miss: 0.0 });
        let fused = match (source.simplest(), model) {
            (Source::Point(point), _) => {
                let view = PointView::new(speed, self, point, pair, proper_time)?;
                if model == Model::OneCone { at_event(view.seen_by_middle()) } else { view.stereo() }
            }
            (Source::Wheel(wheel), Model::OneCone) => at_event(observer.seen_by_middle(speed, &wheel, pair)),
            (Source::Wheel(wheel), _) => WheelView::new(speed, &observer, &wheel, pair).stereo(),
        };
        fused.ok_or(ObserverError::Stereo(StereoError::Apart))
    }

    /// The point of a wheel as the middle between the apertures sees it, at the event of this observer.
    fn seen_by_middle(&self, speed: &Speed, point: &WheelPoint, pair: [Aperture; 2]) -> Sighting {
        let (eye, time) = EyeOnGround::new(speed, self, one_cone::middle(pair)).event(self);
        let seen = point.sighting(speed, &point.seen(speed, eye, time), time);
        wheel::in_observer_frame(&self.velocity, seen)
    }

    /// The disparity of `source` for an observer at rest.
    fn disparity_at_rest(
        &self,
        model: Model,
        speed: &Speed,
        source: Source,
        pair: [Aperture; 2],
        proper_time: f64,
    ) -> Result<Disparity, ObserverError> {
        self.check_place()?;
        let ([x, y, z], time) = (self.place, self.time + proper_time);
        let on_ground = pair.map(|eye| Aperture { x: x + eye.x, y: y + eye.y, z: z + eye.z });
        let there = model.disparity(speed, source, on_ground, time)?;
        if self.place == [0.0; 3] {
            return Ok(there);
        }
        let (source, pair) = self.seen_from_place(source, pair);
        let mut seen = model.disparity(speed, source, pair, time)?;
        // The point's own clock is set on the ground.
        seen.primary.proper_time = there.primary.proper_time;
        seen.secondary.proper_time = there.secondary.proper_time;
        Ok(seen)
    }

    /// The source and the eyes as seen from the place of an observer at rest: far from the origin the sum of
    /// that place and an eye would lose the digits of what lies between the eyes. A wheel has turned by where
    /// it is on the ground, and keeps its x.
    fn seen_from_place(&self, source: Source, pair: [Aperture; 2]) -> (Source, [Aperture; 2]) {
        let [x, y, z] = self.place;
        match source.simplest() {
            Source::Point(point) => (point.relative_to(Aperture { x, y, z }).into(), pair),
            Source::Wheel(wheel) => {
                let hub = wheel.hub.relative_to(Aperture { x: 0.0, y, z });
                let beside = |eye: Aperture| Aperture { x: x + eye.x, ..eye };
                (WheelPoint { hub, ..wheel }.into(), pair.map(beside))
            }
        }
    }

    fn check_place(&self) -> Result<(), ObserverError> {
        for (name, value) in ["observer_x", "observer_y", "observer_z"].into_iter().zip(self.place) {
            check(name, value)?;
        }
        Ok(())
    }

    /// Checks all inputs; returns the observer at the event of the observation.
    fn checked(
        &self,
        model: Model,
        source: Source,
        pair: [Aperture; 2],
        proper_time: f64,
    ) -> Result<Self, ObserverError> {
        check("clock", proper_time)?;
        let observer = self.at(proper_time);
        self.check_place()?;
        observer.check_place()?;
        for aperture in pair {
            check_inputs(source, aperture, self.time)?;
        }
        check("T", observer.time)?;
        if matches!(model, Model::Published(_)) {
            return Err(ObserverError::Published(model));
        }
        Ok(observer)
    }
}

/// Disparity of an event that the middle between the eyes receives, and that both look at from two sides.
fn one_event(pair: [Aperture; 2], seen: Sighting) -> Disparity {
    one_cone::disparity_of_event(&one_cone::cones_to_place(seen.position, pair), seen)
}

impl PointView<'_> {
    /// Each eye with a light cone of its own.
    fn disparity(&self) -> Disparity {
        let cones = self.cones();
        let lines = self.relative.lines_of_sight(self.pair, &cones, self.proper_time);
        let (dphi, dtheta) = lines.map_or((0.0, 0.0), |lines| lines.angle_differences());
        let [left, right] = self.pair;
        let middle = Middle::new(self);
        let seen = |eye, cone: &LightCone<f64>| self.sighting(&middle, eye, cone);
        Disparity { primary: seen(left, &cones.left), secondary: seen(right, &cones.right), dphi, dtheta }
    }

    /// The sighting by the middle between the eyes.
    fn seen_by_middle(&self) -> Sighting {
        let between = one_cone::middle(self.pair);
        self.sighting(&Middle::new(self), between, &self.line_of_sight(between).0)
    }

    /// The stereo position; `None` where the lines of sight do not meet. It is found in the axes of the
    /// relative motion, where no digit of nearly parallel lines is lost, and turned then.
    fn stereo(&self) -> Option<Stereo> {
        let cones = self.cones();
        if let Some(there) = along_motion(&self.relative.speed, &cones) {
            return Some(Stereo { position: self.relative.in_observer_axes(there.position), ..there });
        }
        let Offset { s, y, z } = cones.offset;
        let there = meeting(&self.relative.lines_of_sight_there(self.pair, &cones)?, [s, y, z])?;
        Some(Stereo { position: self.relative.in_observer_axes(there.position), ..there })
    }

    /// The sighting by the aperture at `eye` through its `cone`.
    fn sighting(&self, middle: &Middle, eye: Aperture, cone: &LightCone<f64>) -> Sighting {
        let position = self.relative.line_of_sight(eye, cone, self.proper_time);
        let times = middle.times_of_eye(self, eye, cone, position);
        Sighting {
            position,
            distance: cone.solution.r,
            retarded_time: times.retarded_time,
            proper_time: times.proper_time,
            doppler_factor: cone.solution.doppler_factor,
        }
    }
}
