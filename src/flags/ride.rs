//! A ride: its legs, and the speed at which it starts.

use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

use relativity_core::{Leg, RideMoment};

use super::{SpeedParameter, finite_number};

/// Greatest number of legs: a ride that is recorded from keys has one for each press.
const MOST_LEGS: usize = 1000;
/// Greatest rapidity at which a ride starts, and that its legs add: a Lorentz factor of 1.1e6.
const MAX_RIDER_RAPIDITY: f64 = 14.6;
/// Longest leg, and greatest proper acceleration.
const MOST_OF_A_LEG: f64 = 1e6;

/// The legs of a ride, written `DURATION@ACCELERATION,...`; `coast` has none, and `off` is no ride: the eyes
/// rest. An acceleration is a number, ahead, or up to three, `AHEAD:LEFT:UP`, along the axes of the head.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RideLegs(pub Option<Arc<[Leg]>>);

impl RideLegs {
    /// A ride with these legs.
    ///
    /// # Errors
    /// More than 1000 legs, or more rapidity than 14.6, in words.
    pub fn from_legs(legs: Vec<Leg>) -> Result<Self, String> {
        if legs.len() > MOST_LEGS {
            return Err(format!("a ride has at most {MOST_LEGS} legs"));
        }
        check_rapidities(&legs)?;
        Ok(Self(Some(legs.into())))
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_off(&self) -> bool {
        self.0.is_none()
    }
}

impl fmt::Display for RideLegs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.as_deref() {
            None => f.write_str("off"),
            Some([]) => f.write_str("coast"),
            Some(legs) => legs.iter().enumerate().try_for_each(|(number, leg)| {
                let separator = if number == 0 { "" } else { "," };
                write!(f, "{separator}{}@", leg.duration)?;
                write_acceleration(f, leg.acceleration)
            }),
        }
    }
}

impl RideLegs {
    /// Returns the legs with durations of few digits, to read: a leg that was pushed ends between two frames.
    #[must_use]
    pub fn rounded(&self) -> Self {
        let round = |leg: &Leg| Leg { duration: (1e3 * leg.duration).round() / 1e3, ..*leg };
        Self(self.0.as_ref().map(|legs| legs.iter().map(round).collect()))
    }
}

impl FromStr for RideLegs {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim() {
            "off" => Ok(Self(None)),
            "coast" => Self::from_legs(Vec::new()),
            legs => Self::from_legs(legs.split(',').map(leg).collect::<Result<Vec<_>, _>>()?),
        }
    }
}

/// Writes as few of the three numbers as needed: those to the left and up are left out where they are 0.
fn write_acceleration(f: &mut fmt::Formatter<'_>, acceleration: [f64; 3]) -> fmt::Result {
    let [ahead, left, up] = acceleration;
    match (left, up) {
        (0.0, 0.0) => write!(f, "{ahead}"),
        (_, 0.0) => write!(f, "{ahead}:{left}"),
        _ => write!(f, "{ahead}:{left}:{up}"),
    }
}

/// Whether the rapidity that `legs` add stays within bounds all along: during a leg it is nowhere greater
/// than at both ends.
fn check_rapidities(legs: &[Leg]) -> Result<(), String> {
    let mut moment = RideMoment::AT_REST;
    for leg in legs {
        let Leg { duration, acceleration } = leg;
        let gained = duration * leg.magnitude();
        // So much is too fast at the end, whatever it was before; more has no number.
        let is_within = gained <= 2.0 * MAX_RIDER_RAPIDITY;
        if is_within {
            moment = moment.after(*duration, *acceleration);
        }
        let rapidity = if is_within { moment.rapidity().abs() } else { gained };
        if rapidity > MAX_RIDER_RAPIDITY {
            return Err(format!(
                "the legs add a rapidity of {rapidity:.1}, which must be at most {MAX_RIDER_RAPIDITY}"
            ));
        }
    }
    Ok(())
}

fn leg(text: &str) -> Result<Leg, String> {
    let (duration, acceleration) = text
        .split_once('@')
        .ok_or("write off, coast, or legs like 2@0.5,4@0,1@0:0.5: durations and accelerations")?;
    let duration = finite_number(duration)?;
    if !(0.0..=MOST_OF_A_LEG).contains(&duration) {
        return Err("the duration of a leg must be between 0 and 1e6".to_owned());
    }
    Ok(Leg { duration, acceleration: parse_acceleration(acceleration)? })
}

fn parse_acceleration(text: &str) -> Result<[f64; 3], String> {
    let parts = text.split(':').map(finite_number).collect::<Result<Vec<_>, _>>()?;
    if parts.len() > 3 {
        return Err(format!("{text} has more parts than AHEAD:LEFT:UP"));
    }
    if parts.iter().any(|part| part.abs() > MOST_OF_A_LEG) {
        return Err("the acceleration of a leg must be between -1e6 and 1e6".to_owned());
    }
    Ok(std::array::from_fn(|axis| parts.get(axis).copied().unwrap_or(0.0)))
}

/// A velocity along the street in the parameter that it was given in, below 0 towards -x: written `0.9`,
/// `gamma:10` or `rapidity:-2`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StreetVelocity {
    parameter: SpeedParameter,
    value: f64,
    rapidity: f64,
}

impl StreetVelocity {
    /// Velocity 0, given as beta.
    pub const REST: Self = Self { parameter: SpeedParameter::Beta, value: 0.0, rapidity: 0.0 };

    /// The velocity whose `parameter` has this `value`, with the sign of its direction.
    ///
    /// # Errors
    /// A value out of range, in words.
    pub fn new(parameter: SpeedParameter, value: f64) -> Result<Self, String> {
        let speed = parameter.speed(value.abs()).map_err(|error| error.to_string())?;
        if speed.rapidity() > MAX_RIDER_RAPIDITY {
            return Err(format!("the rapidity of a ride must be at most {MAX_RIDER_RAPIDITY}"));
        }
        Ok(Self { parameter, value, rapidity: speed.rapidity().copysign(value) })
    }

    /// Returns the rapidity, below 0 towards -x.
    #[must_use]
    pub const fn rapidity(&self) -> f64 {
        self.rapidity
    }
}

impl fmt::Display for StreetVelocity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.parameter {
            SpeedParameter::Beta => write!(f, "{}", self.value),
            parameter => write!(f, "{}:{}", parameter.name(), self.value),
        }
    }
}

impl FromStr for StreetVelocity {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, value) = text.split_once(':').unwrap_or(("beta", text));
        let parameter = SpeedParameter::ALL.into_iter().find(|parameter| parameter.name() == name.trim());
        let parameter = parameter.ok_or("write 0.9, gamma:10 or rapidity:2, below 0 for the other way")?;
        Self::new(parameter, finite_number(value)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn legs_are_read_as_they_are_written() {
        for text in ["off", "coast", "2@0.5", "2@1,2@-1,0.25@0", "1@0:0.5,1@1:0:-2,3@-1:0.25:1"] {
            assert_eq!(text.parse::<RideLegs>().map(|legs| legs.to_string()), Ok(text.to_owned()));
        }
        for text in [
            "",
            "on",
            "2",
            "2@",
            "-1@1",
            "1@nan",
            "1@1,",
            "1e7@1",
            "1@2e6",
            "8@2",
            "1@1:",
            "1@1:2:3:4",
            "8@0:2",
            "1e6@1e6:1e6",
            "10@1,10@-1:5",
        ] {
            assert!(text.parse::<RideLegs>().is_err(), "{text}");
        }
        let many = vec!["1@0"; MOST_LEGS + 1].join(",");
        assert!(many.parse::<RideLegs>().is_err());
    }

    #[test]
    fn velocities_keep_their_parameter_and_their_sign() {
        for (text, beta) in [("0.9", 0.9_f64), ("-0.6", -0.6), ("gamma:-1.25", -0.6), ("0", 0.0)] {
            let velocity: StreetVelocity = text.parse().expect("a velocity");
            assert!((velocity.rapidity().tanh() - beta).abs() < 1e-15, "{text}");
            assert_eq!(velocity.to_string(), text);
        }
        for text in ["1", "-1", "gamma:0.5", "speed:2", "rapidity:15", "gamma:", "nan"] {
            assert!(text.parse::<StreetVelocity>().is_err(), "{text}");
        }
    }
}
