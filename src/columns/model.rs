//! The models that fill the columns.

use std::f64::consts::{PI, TAU};

use clap::Args;
use relativity_core::{
    Baseline, Disparity, MAX_COORDINATE, Model, ObserverError, Source, Stereo, StereoError, WheelPoint,
};

use super::error::{ObservationError, check_half_turn};
use super::names::{COLUMNS, CONFORMAL, MOVING, ROLL, TURN, TURNED, USUAL, WHEEL};
use super::observation::{GivenInputs, Observation};
use crate::flags::column_exponent;

/// The end of a command's help: what the columns and the models are.
pub const HELP: &str = "\
The columns appended, for the left and the right eye (x_left, x_right and so on):
  x          apparent x, measured from the eye
  t          time of emission of the light that arrives at T
  doppler    received over emitted frequency
  intensity  received over emitted intensity: doppler to the power of the intensity exponent
  phi        azimuth from +x towards +y
  theta      elevation from the x-y plane
and the disparities between the two:
  dphi       phi_left - phi_right
  dtheta     theta_left - theta_right
and for each eye again, on the clock that rides with the point:
  tau        proper time of that emission: gamma (t - beta x), x from between the eyes
and of a point on a wheel (wheel_radius, rho, angle; x0, y and z are the hub's, and the wheel rolls towards +x):
  angle      where on its wheel it is as that light leaves, from +x towards +z, -pi to pi
and with --stereo where two eyes place the point, which is where their lines of sight meet:
  stereo_gain  (x_left - x_right)/d: 1 for a point at rest; of a wheel's point as for a tilted head
  stereo_x     that place, from between the eyes; stereo_y and stereo_z too
A head that is tilted or turned (roll, turn, degrees) has its eyes at +-d/2 (cos roll cos turn, cos roll sin turn, sin roll). Their \
lines of sight pass each other: the place is the middle of their shortest connection, and empty where they do not meet in \
front; the gain is the component of the parallax along that of a resting point, divided by that; and with --stereo
  stereo_miss  length of that connection
The lines of sight to a point of a wheel pass each other too, since each eye sees it elsewhere: it has a stereo_miss as well.

An observer who moves (observer_beta, observer_gamma or observer_rapidity; observer_azimuth and observer_elevation, degrees; \
observer_x, observer_y, observer_z: where the middle between the eyes is on the ground at T) has x, phi, theta, dphi, dtheta, u and v \
in axes of their own frame, which are the ground's, boosted along the velocity without turning; d is measured there, too. \
t is still by the ground's clocks. Then there are also, for each eye
  y, z       where it sees the point, from the eye
  distance   how far away that is
and with --stereo a stereo_miss.

With --conformal the last columns are the conformal coordinates, in the axes of the head (X along the line between the eyes, Y \
ahead, Z up), for each eye:
  u          to the right, arsinh(X/hypot(Y, Z)), in units of rapidity: motion along that line slides u back by the rapidity
  v          up from straight ahead, atan2(Z, Y), radians
Both are empty for a point that the eye sees along the line between the eyes, infinitely far aside.

With one cone both eyes receive what the middle between them does: t, doppler and tau are those of that event; x, phi and \
theta lead from each eye to it.

The published models evaluate the right eye through the left eye's formula at a shifted time, and measure its \
angles from the left eye. They reproduce the paper (doi 10.1098/rspa.2019.0703) and leave parallax out.";

/// Flags that choose the model behind the columns.
#[derive(Debug, Clone, Copy, Args)]
pub struct ModelArgs {
    /// Model of the two eyes' views.
    #[arg(long, value_enum, default_value_t)]
    pub model: Model,
    /// Intensity = doppler^N: surface (4), photons (3), paper (2), or N.
    #[arg(long, value_name = "N", default_value = "surface", value_parser = column_exponent,
          allow_hyphen_values = true)]
    pub intensity_exponent: f64,
    /// Append where two eyes place the point: the stereo gain, and the stereo position.
    #[arg(long)]
    pub stereo: bool,
    /// Append the conformal coordinates u and v for each eye.
    #[arg(long)]
    pub conformal: bool,
}

impl ModelArgs {
    /// The names of the columns.
    ///
    /// # Errors
    ///
    /// Stereo columns of a model that has none.
    pub fn columns(&self, given: GivenInputs) -> Result<Vec<&'static str>, StereoError> {
        let (default, stereo) = COLUMNS.split_at(USUAL);
        let turned = if given.on_wheel { &TURNED[..] } else { &[] };
        let moving = if given.is_riding { &MOVING[..] } else { &[] };
        let conformal = if self.conformal { &CONFORMAL[..] } else { &[] };
        match (self.stereo, self.model) {
            (true, Model::Published(_)) => Err(StereoError::Published(self.model.name())),
            (true, _) => Ok([default, turned, moving, &stereo[..given.stereo()], conformal].concat()),
            (false, _) => Ok([default, turned, moving, conformal].concat()),
        }
    }

    /// The values of the [`columns`](Self::columns), finite; NaN where there is none: lines of sight do not
    /// meet, or one is along the baseline.
    ///
    /// # Errors
    ///
    /// An input outside its domain, or an intensity that overflows. (One that underflows is 0.)
    pub fn values(
        &self,
        observation: &Observation,
        given: GivenInputs,
    ) -> Result<Vec<f64>, ObservationError> {
        let both = self.disparity(observation)?;
        let mut values = self.sightings(&both).to_vec();
        if let Some(index) = values.iter().position(|value| !value.is_finite()) {
            return Err(ObservationError::NotFinite { column: COLUMNS[index], value: values[index] });
        }
        let &Observation { ref speed, source, baseline, .. } = observation;
        if let Source::Wheel(wheel) = source {
            let proper_times = [both.primary, both.secondary].map(|seen| seen.proper_time);
            values.extend(
                proper_times.map(|proper_time| within_half_a_turn(wheel.angle_at(speed, proper_time))),
            );
        }
        if given.is_riding {
            let seen = [both.primary, both.secondary];
            values.extend(seen.map(|seen| seen.position[1]));
            values.extend(seen.map(|seen| seen.position[2]));
            values.extend(seen.map(|seen| seen.distance));
        }
        if self.stereo {
            values.extend(&self.found(observation, given)?[..given.stereo()]);
        }
        if self.conformal {
            let axes = baseline.axes();
            let seen = [both.primary, both.secondary].map(|seen| axes.conformal(seen.position));
            values.extend(seen.map(|seen| seen.map_or(f64::NAN, |seen| seen.u)));
            values.extend(seen.map(|seen| seen.map_or(f64::NAN, |seen| seen.v)));
        }
        Ok(values)
    }

    /// The values of the stereo columns alone; NaN where lines of sight do not meet.
    ///
    /// # Errors
    ///
    /// An input outside its domain, or a model that has no such columns.
    pub fn stereo_values(
        &self,
        observation: &Observation,
        given: GivenInputs,
    ) -> Result<Vec<f64>, ObservationError> {
        check(observation)?;
        Ok(self.found(observation, given)?[..given.stereo()].to_vec())
    }

    /// The gain, the place and the miss that two eyes find; NaN where their lines of sight do not meet.
    fn found(&self, observation: &Observation, given: GivenInputs) -> Result<[f64; 5], ObservationError> {
        let &Observation { ref speed, source, baseline, ref observer, clock } = observation;
        // What two eyes in one place make of a point is a limit, which depends on their direction and on the
        // motion.
        let pair = baseline.stereo_apertures(given.is_riding);
        match observer.stereo(self.model, speed, source, pair, clock) {
            Ok(Stereo { gain, position: [x, y, z], miss }) => Ok([gain, x, y, z, miss]),
            Err(ObserverError::Stereo(StereoError::Apart)) => Ok([f64::NAN; 5]),
            Err(error) => Err(error.into()),
        }
    }

    /// The values of the columns that are always there.
    fn sightings(&self, both: &Disparity) -> [f64; USUAL] {
        let &Disparity { primary, secondary, dphi, dtheta } = both;
        let exponent = self.intensity_exponent;
        [
            primary.position[0],
            secondary.position[0],
            primary.retarded_time,
            secondary.retarded_time,
            primary.doppler_factor,
            secondary.doppler_factor,
            primary.intensity(exponent),
            secondary.intensity(exponent),
            primary.phi(),
            secondary.phi(),
            primary.theta(),
            secondary.theta(),
            dphi,
            dtheta,
            primary.proper_time,
            secondary.proper_time,
        ]
    }

    /// The disparity, and what either eye sees.
    ///
    /// # Errors
    ///
    /// An input outside its domain.
    pub fn disparity(&self, observation: &Observation) -> Result<Disparity, ObservationError> {
        check(observation)?;
        let &Observation { ref speed, source, baseline, ref observer, clock } = observation;
        Ok(observer.disparity(self.model, speed, source, baseline.apertures(), clock)?)
    }
}

/// Refuses eyes and wheels that are none.
fn check(observation: &Observation) -> Result<(), ObservationError> {
    let Baseline { separation, roll, turn } = observation.baseline;
    if !(0.0..=MAX_COORDINATE).contains(&separation) {
        return Err(ObservationError::Separation(separation));
    }
    for (name, value) in [(ROLL, roll), (TURN, turn)] {
        check_half_turn(name, value)?;
    }
    match observation.source {
        Source::Wheel(wheel) => check_wheel(&wheel),
        Source::Point(_) => Ok(()),
    }
}

fn check_wheel(wheel: &WheelPoint) -> Result<(), ObservationError> {
    let [radius, rho, _] = WHEEL;
    let error = |name, value, range| Err(ObservationError::Wheel { name, value, range });
    match *wheel {
        WheelPoint { radius: value, .. } if value <= 0.0 => error(radius, value, "above 0"),
        WheelPoint { rho: value, .. } if !(0.0..=1.0).contains(&value) => {
            error(rho, value, "between 0 and 1")
        }
        _ => Ok(()),
    }
}

/// An angle, less the whole turns in it.
fn within_half_a_turn(angle: f64) -> f64 {
    (angle - TAU * (angle / TAU).round()).clamp(-PI, PI)
}
