//! A point before the eyes of a moving observer.

use super::error::ObserverError;
use super::motion::Observer;
use super::relative::RelativeMotion;
use crate::aperture::Aperture;
use crate::apparent::LightCone;
use crate::cone_pair::ConePair;
use crate::domain::check;
use crate::source::SourcePoint;
use crate::speed::Speed;

/// A point before the eyes of a moving observer.
pub(super) struct PointView<'a> {
    pub speed: &'a Speed,
    pub point: SourcePoint,
    /// The observer at the moment of the observation.
    pub observer: Observer,
    pub proper_time: f64,
    pub relative: RelativeMotion,
    /// The apertures, in the observer's axes.
    pub pair: [Aperture; 2],
}

impl<'a> PointView<'a> {
    pub fn new(
        speed: &'a Speed,
        observer: &Observer,
        point: SourcePoint,
        pair: [Aperture; 2],
        proper_time: f64,
    ) -> Result<Self, ObserverError> {
        let relative = RelativeMotion::new(speed, observer, point)?;
        check("observer_x", relative.point.x0)?;
        check("observer_y", relative.point.y)?;
        Ok(Self { speed, point, observer: observer.at(proper_time), proper_time, relative, pair })
    }

    /// The light cones of both eyes, in the axes of the relative motion.
    pub fn cones(&self) -> ConePair<f64> {
        let RelativeMotion { speed, point, .. } = &self.relative;
        let [left, right] = self.pair.map(|eye| self.relative.aperture(eye));
        ConePair::new(&speed.coefficients(), *point, left, right, self.proper_time)
    }

    /// The light cone of an aperture in the observer's axes, and its line of sight.
    pub fn line_of_sight(&self, eye: Aperture) -> (LightCone<f64>, [f64; 3]) {
        let RelativeMotion { speed, point, .. } = &self.relative;
        let cone = LightCone::new(speed, *point, self.relative.aperture(eye), self.proper_time);
        (cone, self.relative.line_of_sight(eye, &cone, self.proper_time))
    }
}
