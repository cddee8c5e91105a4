//! The ride of the observer: a section of the settings.
//!
//! While one rides, the time of everything is the rider's clock. It shows 0 where the ride starts, and so
//! does the street's clock there.

use std::sync::Arc;

use clap::Args;
use glam::{DMat3, DVec3};
use relativity_core::{Leg, ObserverVelocity, Odometers, RideMoment, RiderVelocity, Speed};
use serde::Serialize;

use super::course::{Course, KeptCourse, RideStart};
use super::sections::MAX_LENGTH;
use crate::flags::{RideLegs, StreetVelocity, within};

/// Gentlest and hardest pedalling, units of c per unit of the rider's clock.
pub const PUSH: std::ops::RangeInclusive<f64> = 1e-6..=100.0;

/// Directions of a ride along the ground, degrees from +x towards +y.
pub const AZIMUTH: std::ops::RangeInclusive<f64> = -360.0..=360.0;
/// Directions of a ride above the ground, degrees.
pub const ELEVATION: std::ops::RangeInclusive<f64> = -90.0..=90.0;

/// Why a picture that was taken on a ride is refused by what knows eyes at rest.
pub const ON_A_RIDE: &str = "it was taken on a ride, and this needs pictures taken by eyes at rest";

/// A shorter part of the time is rounding.
const ROUNDING: f64 = 1e-12;

/// The ride of the observer: along a straight line, the street unless another is chosen, until a leg pushes
/// aside.
#[derive(Debug, Clone, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Ride")]
pub struct Riding {
    /// Ride of the eyes, along the street unless another direction is chosen, in place of resting beside it.
    /// Legs are durations by the rider's clock at proper accelerations, in c per unit of that clock:
    /// `2@0.5,4@0,2@-0.5` speeds up for 2, coasts for 4 and brakes for 2; after the last, one coasts.
    /// `1@0.5:0.2` pushes to the left as well, by the axes of the head, which is carried along without being
    /// turned, and `1@0:0:1` up. `coast` keeps its first speed. T is the rider's clock then.
    #[arg(long, value_name = "off|coast|DURATION@ACCELERATION,...", allow_hyphen_values = true)]
    pub ride: RideLegs,
    /// Speed at which the ride starts: v/c, or like `gamma:10` and `rapidity:2`; below 0 towards -x.
    #[arg(long, value_name = "BETA|gamma:G|rapidity:R", allow_hyphen_values = true)]
    pub ride_speed: StreetVelocity,
    /// Place x on the street where the ride starts, when the rider's clock and the street's clock there
    /// show 0.
    #[arg(long, value_name = "X", value_parser = within(-MAX_LENGTH..=MAX_LENGTH), allow_hyphen_values = true)]
    pub ride_from: f64,
    /// Direction of the ride, degrees from +x, along the street, towards +y, across it. Speeds and
    /// accelerations are along it; in any direction but 0 and 180 there is no bicycle.
    #[arg(long, value_name = "DEGREES", value_parser = within(AZIMUTH), allow_hyphen_values = true)]
    pub ride_azimuth: f64,
    /// Direction of the ride, degrees above the street; 90 is straight up.
    #[arg(long, value_name = "DEGREES", value_parser = within(ELEVATION), allow_hyphen_values = true)]
    pub ride_elevation: f64,
    /// Proper acceleration of a push on the pedals or the brakes in the window, c per unit of the rider's
    /// clock: what an accelerometer on the bicycle shows.
    #[arg(long, value_name = "A", value_parser = within(PUSH), allow_hyphen_values = true)]
    pub push: f64,
    /// Whether the eyes stand wherever the ride has led them: those of the picture beside the rider's.
    #[arg(skip)]
    #[serde(skip)]
    pub stands: bool,
    /// The ride that these settings make, once it was worked out.
    #[arg(skip)]
    #[serde(skip)]
    pub kept: KeptCourse,
}

impl Default for Riding {
    /// No ride: the eyes rest.
    fn default() -> Self {
        Self {
            ride: RideLegs::default(),
            ride_speed: StreetVelocity::REST,
            ride_from: 0.0,
            ride_azimuth: 0.0,
            ride_elevation: 0.0,
            push: 0.25,
            stands: false,
            kept: KeptCourse::default(),
        }
    }
}

impl Riding {
    /// Returns the velocity at `speed` in the direction of the ride.
    pub(super) fn heading(&self, speed: Speed) -> ObserverVelocity {
        ObserverVelocity::new(speed, self.ride_azimuth.to_radians(), self.ride_elevation.to_radians())
    }

    /// Whether no leg pushes aside, so that all of the ride is on one line.
    #[must_use]
    pub fn is_straight(&self) -> bool {
        self.course().is_none_or(|course| course.is_straight)
    }

    /// Whether the ride is along the street, one way or the other.
    #[must_use]
    pub fn is_along_street(&self) -> bool {
        self.heading(Speed::REST).is_along_street() && self.is_straight()
    }

    /// The unit vector along the ride, as it starts.
    #[must_use]
    pub fn direction(&self) -> [f64; 3] {
        self.heading(Speed::REST).direction()
    }

    /// From the axes of the line (ahead, left, up) to the ground's.
    pub(super) fn axes(&self) -> DMat3 {
        let level = ObserverVelocity::new(Speed::REST, self.ride_azimuth.to_radians(), 0.0);
        let ([x, y, _], ahead) = (level.direction(), DVec3::from(self.direction()));
        let left = DVec3::new(-y, x, 0.0);
        DMat3::from_cols(ahead, left, ahead.cross(left))
    }

    /// Returns the ride, worked out; `None` without one.
    pub(super) fn course(&self) -> Option<Arc<Course>> {
        let legs = self.ride.0.as_ref()?;
        let start = RideStart {
            speed: self.ride_speed,
            numbers: [self.ride_from, self.ride_azimuth, self.ride_elevation],
        };
        Some(self.kept.of(start, legs, |is_straight| self.start(self.has_own_direction() || !is_straight)))
    }

    /// Returns the start of the ride, along its line, whichever way that leads.
    pub(super) fn start(&self, has_own_line: bool) -> RideMoment {
        let velocity = RiderVelocity::AlongStreet { rapidity: self.ride_speed.rapidity() };
        let from = if has_own_line { 0.0 } else { self.ride_from };
        RideMoment { velocity, place: [from, 0.0, 0.0], ..RideMoment::AT_REST }
    }

    /// Whether the ride starts in another direction than towards +x or back.
    pub(super) fn has_own_direction(&self) -> bool {
        self.direction() != [1.0, 0.0, 0.0]
    }

    /// Returns the eyes that stand, at each moment, where this ride has led them.
    pub(super) fn standing(&self) -> Self {
        Self { stands: true, ..self.clone() }
    }

    /// Whether the eyes ride.
    #[must_use]
    pub const fn is_on(&self) -> bool {
        !self.ride.is_off()
    }

    /// Whether the eyes ride another way than along the street.
    #[must_use]
    pub fn leaves_street(&self) -> bool {
        self.is_on() && !self.is_along_street()
    }

    /// Whether the eyes ride on a bicycle: one faces along the street, and would be dragged aside on any
    /// other way.
    #[must_use]
    pub fn has_bicycle(&self) -> bool {
        self.is_on() && self.is_along_street()
    }

    /// Whether all of the ride has one velocity.
    #[must_use]
    pub fn coasts(&self) -> bool {
        let is_idle = |leg: &Leg| leg.acceleration == [0.0; 3] || leg.duration == 0.0;
        self.ride.0.as_deref().is_some_and(|legs| legs.iter().all(is_idle))
    }

    /// Whether all of the ride has one velocity, along the street.
    #[must_use]
    pub fn coasts_along_street(&self) -> bool {
        self.coasts() && self.is_along_street()
    }

    /// Two odometers of the rider when the clock of the ride shows `time`, at 0 without a ride; `None` off its
    /// line, where nothing rolls.
    #[must_use]
    pub fn odometers(&self, time: f64) -> Option<Odometers> {
        match self.course() {
            None => Some(Odometers::default()),
            Some(course) => course.is_straight.then(|| course.ride.odometers(time)),
        }
    }

    /// Returns this ride as it was until `time`, and from then on with a push of this proper `acceleration`
    /// along the axes of the head for `duration`. A push that continues another is one leg with it.
    ///
    /// # Errors
    /// A ride that is full, or would be too fast, in words.
    pub fn pushed(&self, time: f64, duration: f64, acceleration: [f64; 3]) -> Result<Self, String> {
        let mut legs: Vec<Leg> = Vec::new();
        let mut left = time.max(0.0);
        for leg in self.ride.0.as_deref().unwrap_or_default() {
            legs.push(Leg { duration: leg.duration.min(left), ..*leg });
            left -= leg.duration;
            if left <= 0.0 {
                break;
            }
        }
        // The clock of the window adds up its steps, and so do the legs: what rounding leaves between is no
        // leg.
        if left > ROUNDING * time.abs() {
            legs.push(Leg { duration: left, acceleration: [0.0; 3] });
        }
        match legs.last_mut().filter(|last| last.acceleration == acceleration) {
            Some(last) => last.duration += duration,
            None => legs.push(Leg { duration, acceleration }),
        }
        Ok(Self { ride: RideLegs::from_legs(legs)?, ..self.clone() })
    }

    /// When its velocity changes: at the ends of its legs.
    pub fn turns(&self) -> impl Iterator<Item = f64> {
        let legs = self.ride.0.as_deref().unwrap_or_default().iter();
        legs.scan(0.0, |end, leg| {
            *end += leg.duration;
            Some(*end)
        })
    }

    /// Duration of the riding's legs.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.turns().last().unwrap_or_default()
    }
}

/// A ride with these legs that starts at this speed, for tests.
#[cfg(test)]
pub(super) fn riding(ride: &str, speed: &str) -> Riding {
    Riding {
        ride: ride.parse().expect("legs"),
        ride_speed: speed.parse().expect("a velocity"),
        ..Riding::default()
    }
}

#[cfg(test)]
mod tests {
    use relativity_render::Velocity;

    use super::*;

    /// The twin of W. Rindler's textbook: eight units of one's own clock, 14.507 at home.
    #[test]
    fn a_ride_out_and_back_ends_at_home_when_more_has_gone_by_there() {
        let there = riding("2@1,2@-1,2@-1,2@1", "0").rider(8.0);
        assert!((there.street_time - 14.507_441_630_9).abs() < 1e-9 && there.x.abs() < 1e-14);
        assert_eq!(there.velocity, Velocity::REST);
    }

    /// However finely a push is cut, it is one leg, and braking as long ends at rest.
    #[test]
    fn pushes_are_recorded_as_legs() {
        for steps in [5_u32, 120, 3] {
            let mut ride = riding("coast", "0");
            let mut time = 1.5;
            for push in [0.5, -0.5] {
                for _ in 0..2 * steps {
                    let step = 1.0 / f64::from(steps);
                    ride = ride.pushed(time, step, [push, 0.0, 0.0]).expect("there is room");
                    time += step;
                }
            }
            let legs = ride.ride.0.as_deref().expect("it is on");
            assert_eq!(legs.iter().map(|leg| leg.acceleration[0]).collect::<Vec<_>>(), [0.0, 0.5, -0.5]);
            let rider = ride.rider(time);
            assert!(rider.velocity.beta().abs() < 1e-14, "{steps}: {legs:?}");
        }
        // What was planned after a push is given up.
        let again = riding("2@1,2@-1", "0").pushed(1.0, 0.5, [0.25, 0.0, 0.0]).expect("there is room");
        assert_eq!(again.ride.to_string(), "1@1,0.5@0.25");
        let aside = again.pushed(1.5, 2.0, [-0.5, 0.25, 0.0]).expect("there is room");
        assert_eq!(aside.ride.to_string(), "1@1,0.5@0.25,2@-0.5:0.25");
        assert!(aside.is_along_street() != again.is_along_street());
        assert!(riding("14@1", "0").pushed(14.0, 1.0, [1.0, 0.0, 0.0]).is_err());
    }

    /// The same clocks and distances as along the street, whichever way one rides.
    #[test]
    fn a_ride_leads_any_way() {
        let along = riding("2@1,1@-0.5", "0.3");
        for (azimuth, elevation, direction) in [
            (90.0, 0.0, [0.0, 1.0, 0.0]),
            (-90.0, 0.0, [0.0, -1.0, 0.0]),
            (0.0, 90.0, [0.0, 0.0, 1.0]),
            (180.0, 0.0, [-1.0, 0.0, 0.0]),
            (60.0, 0.0, [0.5, 0.75_f64.sqrt(), 0.0]),
        ] {
            let ride = Riding { ride_azimuth: azimuth, ride_elevation: elevation, ..along.clone() };
            assert_eq!(ride.is_along_street(), direction[0].abs() == 1.0);
            for time in [0.0, 1.5, 4.0] {
                let (there, expected) = (ride.rider(time), along.rider(time));
                let observer = there.observer();
                assert_eq!((there.velocity, there.street_time), (expected.velocity, expected.street_time));
                for (i, part) in direction.into_iter().enumerate() {
                    assert!((observer.place[i] - part * expected.x).abs() < 1e-14, "{observer:?}");
                    assert!((observer.velocity.direction()[i] - part).abs() < 1e-15, "{observer:?}");
                }
            }
        }
        let back = Riding { ride_azimuth: 90.0, ..riding("coast", "-0.6") }.rider(1.0);
        assert_eq!(back.observer().velocity.direction()[1], -1.0);
        assert!((back.aside[0] + 0.75).abs() < 1e-15 && back.along_street().beta() == 0.0);
    }
}
