//! Velocities of groups along x.

use glam::DVec3;
use relativity_core::{
    Aperture, Baseline, Boost, ConformalDisparity, Disparity, Event, Model, Observer, ObserverError,
    ObserverVelocity, PairError, Sighting, Source, SourcePoint, Speed, SpeedError, Stereo, StereoError,
    Turning, WheelPoint, aberration, math,
};

use super::spin::MaterialPoint;

/// A velocity along x.
///
/// # Examples
///
/// ```
/// use relativity_render::Velocity;
///
/// let oncoming = Velocity::from_beta(-0.6)?;
/// assert!(oncoming.is_backward && oncoming.speed.gamma() == 1.25);
/// // Its light is blueshifted from the side it comes from: sqrt((1 + 0.6)/(1 - 0.6)).
/// assert!((oncoming.doppler_factor([1.0, 0.0, 0.0].into()) - 2.0).abs() < 1e-15);
/// # Ok::<(), relativity_core::SpeedError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Velocity {
    /// Magnitude of the velocity.
    pub speed: Speed,
    /// Whether it points towards -x.
    pub is_backward: bool,
}

impl From<Velocity> for Boost {
    fn from(Velocity { speed, is_backward }: Velocity) -> Self {
        Self { speed, is_backward }
    }
}

impl From<Boost> for Velocity {
    fn from(Boost { speed, is_backward }: Boost) -> Self {
        Self { speed, is_backward }
    }
}

/// The motion of a group of bodies.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Motion {
    /// At the scene's speed along +x.
    #[default]
    Scene,
    /// At a velocity of its own; [`Velocity::REST`] rests on the ground.
    Own(Velocity),
    /// Along with the eyes, whatever they do: its places count from the middle between them, in their frame.
    WithEyes,
}

impl Velocity {
    /// The velocity at rest.
    pub const REST: Self = Self::forward(Speed::REST);

    /// At `speed` along +x.
    #[must_use]
    pub const fn forward(speed: Speed) -> Self {
        Self { speed, is_backward: false }
    }

    /// From beta in (-1, 1), negative towards -x.
    ///
    /// # Errors
    ///
    /// A beta out of range.
    pub fn from_beta(beta: f64) -> Result<Self, SpeedError> {
        let speed = Speed::from_beta(beta.abs()).map_err(|_| SpeedError::Beta(beta))?;
        Ok(Self { speed, is_backward: beta < 0.0 })
    }

    /// From the rapidity, negative towards -x; of one beyond [`MAX_GAMMA`](relativity_core::MAX_GAMMA) that.
    #[must_use]
    pub fn from_rapidity(rapidity: f64) -> Self {
        Boost::from_rapidity(rapidity).into()
    }

    /// v/c, negative towards -x.
    #[must_use]
    pub fn beta(&self) -> f64 {
        self.direction() * self.speed.beta()
    }

    /// 1 along +x, -1 towards -x.
    pub(crate) const fn direction(&self) -> f64 {
        if self.is_backward { -1.0 } else { 1.0 }
    }

    /// Returns beta, 1 - beta, 1/gamma and gamma for the shaders.
    pub(crate) fn packed_speed(&self) -> [f32; 4] {
        let speed = &self.speed;
        [speed.beta(), speed.one_minus_beta(), 1.0 / speed.gamma(), speed.gamma()].map(|v| v as f32)
    }

    /// Whether it is none.
    pub(crate) fn is_rest(&self) -> bool {
        self.speed == Speed::REST
    }

    /// `v` reflected where the velocity points towards -x: from the ground to where it points along +x, and
    /// back.
    pub(crate) fn reflected(&self, v: DVec3) -> DVec3 {
        DVec3::new(self.direction() * v.x, v.y, v.z)
    }

    /// The velocity of an observer who moves along x; `None` of one who does not.
    #[must_use]
    pub fn along_street(observer: &ObserverVelocity) -> Option<Self> {
        if observer.is_rest() {
            return Some(Self::REST);
        }
        let is_backward = observer.direction()[0] < 0.0;
        observer.is_along_street().then_some(Self { speed: *observer.speed(), is_backward })
    }

    /// The line of sight (unit vector) in the frame that moves so, of one on the ground.
    pub(crate) fn rest_from_ground(&self, line_of_sight: DVec3) -> DVec3 {
        let n = self.reflected(line_of_sight).to_array();
        self.reflected(aberration::rest_from_ground(n, &self.speed).into())
    }

    /// The line of sight (unit vector) on the ground, of one in the frame that moves so.
    pub(crate) fn ground_from_rest(&self, line_of_sight: DVec3) -> DVec3 {
        let n = self.reflected(line_of_sight).to_array();
        self.reflected(aberration::ground_from_rest(n, &self.speed).into())
    }

    /// Doppler factor of light from what moves so, received along the ground's `line_of_sight` (unit vector).
    #[must_use]
    pub fn doppler_factor(&self, line_of_sight: DVec3) -> f64 {
        aberration::doppler_factor(self.reflected(line_of_sight).to_array(), &self.speed)
    }

    /// The worldline of `point`, at rest in the frame that moves so or turning there, reflected to move along
    /// +x.
    #[must_use]
    pub fn reflected_source(&self, point: impl Into<MaterialPoint>) -> Source {
        let MaterialPoint { rest, spin } = point.into();
        let Some(spin) = spin else { return self.reflected_point(rest.to_array()).into() };
        let off_axle = self.reflected(spin.off_axle(rest));
        let hub = self.reflected_point((rest - spin.off_axle(rest)).to_array());
        let turning = match spin.turning {
            Turning::Rolling => Turning::Rolling,
            Turning::RimSpeed(speed) => Turning::RimSpeed(self.direction() * speed),
        };
        // What is on the rim by rounding is.
        let rho = (math::hypot(off_axle.x, off_axle.z) / spin.radius).min(1.0);
        let angle = math::atan2(off_axle.z, off_axle.x);
        WheelPoint { hub, radius: spin.radius, rho, angle, turning }.into()
    }

    /// The worldline of the point at `rest` in the frame that moves so, reflected to move along +x.
    pub(crate) fn reflected_point(&self, rest: [f64; 3]) -> SourcePoint {
        SourcePoint::from_rest(self.reflected(rest.into()).to_array(), &self.speed)
    }

    /// The `pair` of apertures before which a [`Self::reflected_source`] moves.
    #[must_use]
    pub fn reflected_pair(&self, pair: [Aperture; 2]) -> [Aperture; 2] {
        pair.map(|aperture| Aperture { x: self.direction() * aperture.x, ..aperture })
    }

    /// Returns the disparity of `point`, in the frame with this velocity, for the `pair` of apertures (left,
    /// right) in this `model`.
    ///
    /// # Errors
    ///
    /// A coordinate or time outside the domain of the core; a pair that the model does not know.
    pub fn disparity(
        &self,
        model: Model,
        point: impl Into<MaterialPoint>,
        pair: [Aperture; 2],
        observation_time: f64,
    ) -> Result<Disparity, PairError> {
        let (point, pair) = (self.reflected_source(point), self.reflected_pair(pair));
        Ok(self.reflected_disparity(model.disparity(&self.speed, point, pair, observation_time)?))
    }

    /// Returns the disparity before the eyes of an `observer` who moves, at the event of the observer: the
    /// `pair` and all that is seen are in the observer's axes.
    ///
    /// # Errors
    ///
    /// A coordinate or time outside the domain of the core; a model that does not know such eyes; a relative
    /// Lorentz factor above [`MAX_GAMMA`](relativity_core::MAX_GAMMA).
    pub fn disparity_before(
        &self,
        observer: &Observer,
        model: Model,
        point: impl Into<MaterialPoint>,
        pair: [Aperture; 2],
    ) -> Result<Disparity, ObserverError> {
        let (point, pair) = (self.reflected_source(point), self.reflected_pair(pair));
        let there = self.reflected_observer(observer).disparity(model, &self.speed, point, pair, 0.0)?;
        Ok(self.reflected_disparity(there))
    }

    /// The observer before whom a [`Self::reflected_source`] moves.
    fn reflected_observer(&self, observer: &Observer) -> Observer {
        if self.is_backward { observer.mirrored() } else { *observer }
    }

    /// In the mirror azimuths count from the other side.
    fn reflected_disparity(&self, there: Disparity) -> Disparity {
        if !self.is_backward {
            return there;
        }
        let sighting = |seen: Sighting| {
            let [x, y, z] = seen.position;
            Sighting { position: [-x, y, z], ..seen }
        };
        let (primary, secondary) = (sighting(there.primary), sighting(there.secondary));
        Disparity { primary, secondary, dphi: -there.dphi, dtheta: there.dtheta }
    }

    /// Returns the conformal disparity of `point` in the frame that moves so, in this `model`, for the eyes
    /// at the ends of `baseline`; `None` where one sees it along the baseline.
    ///
    /// # Errors
    ///
    /// A coordinate or time outside the domain of the core; a baseline that the model does not know.
    pub fn conformal(
        &self,
        model: Model,
        point: impl Into<MaterialPoint>,
        baseline: &Baseline,
        observation_time: f64,
    ) -> Result<Option<ConformalDisparity>, PairError> {
        let source = self.reflected_source(point);
        self.conformal_of(model, &self.speed, source, baseline, observation_time)
    }

    /// Returns the conformal disparity of `point` resting where it is at `observation_time` in the frame that
    /// moves so, for eyes gamma d apart in place of d: of a `baseline` along the motion that of the moving
    /// point. `None` of a point that turns, of another baseline, and of a point on the baseline.
    ///
    /// # Errors
    ///
    /// A coordinate or time outside the domain of the core.
    pub fn resting_conformal(
        &self,
        point: impl Into<MaterialPoint>,
        baseline: &Baseline,
        observation_time: f64,
    ) -> Result<Option<ConformalDisparity>, PairError> {
        let Source::Point(point) = self.reflected_source(point) else { return Ok(None) };
        if !baseline.is_along_motion() {
            return Ok(None);
        }
        let here = Event { x: 0.0, t: observation_time };
        let resting = SourcePoint { x0: point.worldline(&self.speed).rest_distance_from(here), ..point };
        let wide = Baseline { separation: self.speed.gamma() * baseline.separation, ..*baseline };
        self.conformal_of(Model::Exact, &Speed::REST, resting.into(), &wide, observation_time)
    }

    /// Returns the disparity in a conformal picture of what is reflected already.
    fn conformal_of(
        &self,
        model: Model,
        speed: &Speed,
        source: Source,
        baseline: &Baseline,
        time: f64,
    ) -> Result<Option<ConformalDisparity>, PairError> {
        let axes = if self.is_backward { baseline.axes().mirrored() } else { baseline.axes() };
        model.conformal(speed, source, self.reflected_pair(baseline.apertures()), &axes, time)
    }

    /// Returns the stereo position of `point`, in the frame with this velocity, for the `pair` of apertures
    /// (left, right) in this `model`, from the middle between them.
    ///
    /// # Errors
    ///
    /// A coordinate or time outside the domain of the core; lines of sight that do not meet; a published
    /// model.
    pub fn stereo(
        &self,
        model: Model,
        point: impl Into<MaterialPoint>,
        pair: [Aperture; 2],
        observation_time: f64,
    ) -> Result<Stereo, StereoError> {
        let (point, pair) = (self.reflected_source(point), self.reflected_pair(pair));
        let there = model.stereo(&self.speed, point, pair, observation_time)?;
        Ok(Stereo { position: self.reflected(there.position.into()).to_array(), ..there })
    }

    /// Returns the stereo position before the eyes of an `observer` who moves, as [`Self::disparity_before`].
    ///
    /// # Errors
    ///
    /// As there; lines of sight that do not meet; a published model.
    pub fn stereo_before(
        &self,
        observer: &Observer,
        model: Model,
        point: impl Into<MaterialPoint>,
        pair: [Aperture; 2],
    ) -> Result<Stereo, ObserverError> {
        let (point, pair) = (self.reflected_source(point), self.reflected_pair(pair));
        let there = self.reflected_observer(observer).stereo(model, &self.speed, point, pair, 0.0)?;
        Ok(Stereo { position: self.reflected(there.position.into()).to_array(), ..there })
    }

    /// Returns the speed at which a point at `place`, at rest in the frame that moves so, passes an
    /// `observer`, and its place by the observer's clock, both reflected to move along +x. `None` beyond
    /// [`MAX_GAMMA`](relativity_core::MAX_GAMMA).
    #[must_use]
    pub fn past(&self, observer: &Observer, place: [f64; 3]) -> Option<(Speed, SourcePoint)> {
        self.reflected_observer(observer).relative_motion(&self.speed, self.reflected_point(place)).ok()
    }

    /// Returns the rapidity along +x, below 0 for the other way.
    #[must_use]
    pub fn rapidity(&self) -> f64 {
        Boost::from(*self).rapidity()
    }

    /// This velocity as a camera sees it that moves at `camera`.
    #[must_use]
    pub fn seen_from(self, camera: Self) -> Self {
        Boost::from(self).seen_from(camera).into()
    }
}

impl From<Velocity> for ObserverVelocity {
    fn from(velocity: Velocity) -> Self {
        let along = Self::along_street(velocity.speed);
        if velocity.is_backward { along.mirrored() } else { along }
    }
}
