//! The ride of the observer: a section of the settings, and the observer at each moment of it.
//!
//! While one rides, the time of everything is the rider's clock. It shows 0 where the ride starts, and so does the street's
//! clock there.

use clap::Args;
use relativity_core::{
    Aperture, Boost, Event, Leg, Observer, ObserverVelocity, Odometers, RideMoment, RiderVelocity, Speed,
    math,
};
use relativity_render::Velocity;
use serde::Serialize;

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

/// The ride of the observer along a straight line, the street unless another is chosen.
#[derive(Debug, Clone, PartialEq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Ride")]
pub struct Riding {
    /// Ride of the eyes, along the street unless another direction is chosen, in place of resting beside it. Legs are durations by the rider's clock at proper accelerations, in c
    /// per unit of that clock: `2@0.5,4@0,2@-0.5` speeds up for 2, coasts for 4 and brakes for 2; after the last, one coasts. `coast` keeps its first
    /// speed. T is the rider's clock then.
    #[arg(long, value_name = "off|coast|DURATION@ACCELERATION,...", allow_hyphen_values = true)]
    pub ride: RideLegs,
    /// Speed at which the ride starts: v/c, or like `gamma:10` and `rapidity:2`; below 0 towards -x.
    #[arg(long, value_name = "BETA|gamma:G|rapidity:R", allow_hyphen_values = true)]
    pub ride_speed: StreetVelocity,
    /// Place x on the street where the ride starts, when the rider's clock and the street's clock there show 0.
    #[arg(long, value_name = "X", value_parser = within(-MAX_LENGTH..=MAX_LENGTH), allow_hyphen_values = true)]
    pub ride_from: f64,
    /// Direction of the ride, degrees from +x, along the street, towards +y, across it. Speeds and accelerations are along it; in any direction but 0 and
    /// 180 there is neither a bicycle nor a map.
    #[arg(long, value_name = "DEGREES", value_parser = within(AZIMUTH), allow_hyphen_values = true)]
    pub ride_azimuth: f64,
    /// Direction of the ride, degrees above the street; 90 is straight up.
    #[arg(long, value_name = "DEGREES", value_parser = within(ELEVATION), allow_hyphen_values = true)]
    pub ride_elevation: f64,
    /// Proper acceleration of a push on the pedals or the brakes in the window, c per unit of the rider's clock: what an accelerometer on the bicycle
    /// shows.
    #[arg(long, value_name = "A", value_parser = within(PUSH), allow_hyphen_values = true)]
    pub push: f64,
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
        }
    }
}

impl Riding {
    /// The observer when the clock of the ride shows `time`; at rest at this T without a ride.
    #[must_use]
    pub fn rider(&self, time: f64) -> Rider {
        let Some(legs) = self.ride.0.as_deref() else { return Rider::at_rest(time) };
        Rider::new(self.start().along(legs, time), self)
    }

    /// Returns the velocity at `speed` in the direction of the ride.
    fn heading(&self, speed: Speed) -> ObserverVelocity {
        ObserverVelocity::new(speed, self.ride_azimuth.to_radians(), self.ride_elevation.to_radians())
    }

    /// Whether the ride is along the street, one way or the other.
    #[must_use]
    pub fn is_along_street(&self) -> bool {
        self.heading(Speed::REST).is_along_street()
    }

    /// The unit vector along the ride.
    #[must_use]
    pub fn direction(&self) -> [f64; 3] {
        self.heading(Speed::REST).direction()
    }

    fn start(&self) -> RideMoment {
        // Along the line of the ride, whichever way that leads.
        let velocity = RiderVelocity::AlongStreet { rapidity: self.ride_speed.rapidity() };
        let from = if self.has_own_line() { 0.0 } else { self.ride_from };
        RideMoment { velocity, place: [from, 0.0, 0.0], ..RideMoment::AT_REST }
    }

    /// Whether the line of the ride is another than the street towards +x.
    fn has_own_line(&self) -> bool {
        self.direction() != [1.0, 0.0, 0.0]
    }

    /// Whether the eyes ride.
    #[must_use]
    pub const fn is_on(&self) -> bool {
        !self.ride.is_off()
    }

    /// Whether the eyes ride on a bicycle: one faces along the street, and would be dragged aside on any other way.
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

    /// Two odometers of the rider when the clock of the ride shows `time`.
    #[must_use]
    pub fn odometers(&self, time: f64) -> Odometers {
        self.start().odometers(self.ride.0.as_deref().unwrap_or_default(), time)
    }

    /// Returns this ride as it was until `time`, and from then on with a push of this proper `acceleration` for
    /// `duration`. A push that continues another is one leg with it.
    ///
    /// # Errors
    /// A ride that is full, or would be too fast, in words.
    pub fn pushed(&self, time: f64, duration: f64, acceleration: f64) -> Result<Self, String> {
        let mut legs: Vec<Leg> = Vec::new();
        let mut left = time.max(0.0);
        for leg in self.ride.0.as_deref().unwrap_or_default() {
            legs.push(Leg { duration: leg.duration.min(left), ..*leg });
            left -= leg.duration;
            if left <= 0.0 {
                break;
            }
        }
        // The clock of the window adds up its steps, and so do the legs: what rounding leaves between is no leg.
        if left > ROUNDING * time.abs() {
            legs.push(Leg { duration: left, acceleration: [0.0; 3] });
        }
        let acceleration = [acceleration, 0.0, 0.0];
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

/// A moment of a ride, or of resting eyes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rider {
    /// Velocity along the line of the ride.
    pub velocity: Velocity,
    /// Place x on the street.
    pub x: f64,
    /// Places y and z beside the middle between eyes that rest, and above.
    pub aside: [f64; 2],
    /// The time of the street's clock there.
    pub street_time: f64,
    /// Velocity on the ground.
    on_ground: ObserverVelocity,
}

impl Rider {
    /// At rest at the ground's origin.
    const fn at_rest(time: f64) -> Self {
        let on_ground = ObserverVelocity::REST;
        Self { velocity: Velocity::REST, x: 0.0, aside: [0.0; 2], street_time: time, on_ground }
    }

    /// The `moment` of a ride along the line of `riding`, which it has as x.
    fn new(moment: RideMoment, riding: &Riding) -> Self {
        let rapidity = match moment.velocity {
            RiderVelocity::AlongStreet { rapidity } => rapidity,
            RiderVelocity::Any { proper: [along, ..] } => math::asinh(along),
        };
        let velocity = Velocity::from_rapidity(rapidity);
        let ([x, ..], street_time) = (moment.place, moment.time);
        if !riding.has_own_line() {
            return Self { velocity, x, aside: [0.0; 2], street_time, on_ground: velocity.into() };
        }
        let [along_x, y, z] = riding.direction().map(|part| part * x);
        let ahead = riding.heading(velocity.speed);
        let on_ground = match (velocity == Velocity::REST, velocity.is_backward) {
            (true, _) => ObserverVelocity::REST,
            (_, true) => ahead.opposite(),
            (_, false) => ahead,
        };
        Self { velocity, x: riding.ride_from + along_x, aside: [y, z], street_time, on_ground }
    }

    /// The part of the velocity that is along the street.
    #[must_use]
    pub fn along_street(&self) -> Velocity {
        Velocity::along_street(&self.on_ground).unwrap_or_else(|| {
            let [ahead, ..] = self.on_ground.direction();
            Velocity::from_beta(ahead * self.on_ground.speed().beta()).unwrap_or(Velocity::REST)
        })
    }

    /// The event of the middle between the eyes, on the street.
    #[must_use]
    pub const fn event(&self) -> Event {
        Event { x: self.x, t: self.street_time }
    }

    /// The event of an eye that is at `aperture` from the middle between the eyes, in the rider's frame: its place on the ground,
    /// and the time of the street's clock there.
    #[must_use]
    pub fn event_of(&self, aperture: Aperture) -> (Aperture, f64) {
        let Some(velocity) = Velocity::along_street(&self.on_ground) else {
            return self.observer().event_of(aperture);
        };
        let Event { x, t } = self.event().plus(Boost::from(velocity).simultaneous_step(aperture.x));
        let [y, z] = self.aside;
        (Aperture { x, y: y + aperture.y, z: z + aperture.z }, t)
    }

    /// The event of such an eye, in the street's one dimension.
    #[must_use]
    pub fn event_on_street(&self, aperture: Aperture) -> Event {
        let (Aperture { x, .. }, t) = self.event_of(aperture);
        Event { x, t }
    }

    /// The observer of this moment.
    #[must_use]
    pub fn observer(&self) -> Observer {
        let [y, z] = self.aside;
        Observer { velocity: self.on_ground, place: [self.x, y, z], time: self.street_time }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn riding(ride: &str, speed: &str) -> Riding {
        Riding {
            ride: ride.parse().expect("legs"),
            ride_speed: speed.parse().expect("a velocity"),
            ..Riding::default()
        }
    }

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
                    ride = ride.pushed(time, step, push).expect("there is room");
                    time += step;
                }
            }
            let legs = ride.ride.0.as_deref().expect("it is on");
            assert_eq!(legs.iter().map(|leg| leg.acceleration[0]).collect::<Vec<_>>(), [0.0, 0.5, -0.5]);
            let rider = ride.rider(time);
            assert!(rider.velocity.beta().abs() < 1e-14, "{steps}: {legs:?}");
        }
        // What was planned after a push is given up.
        let again = riding("2@1,2@-1", "0").pushed(1.0, 0.5, 0.25).expect("there is room");
        assert_eq!(again.ride.to_string(), "1@1,0.5@0.25");
        assert!(riding("14@1", "0").pushed(14.0, 1.0, 1.0).is_err());
    }

    #[test]
    fn eyes_along_the_motion_are_gamma_d_apart_on_the_street() {
        let rider = riding("coast", "gamma:-10").rider(0.0);
        let [near, far] = [-0.05, 0.05].map(|x| rider.event_of(Aperture { x, y: 0.0, z: 0.0 }));
        assert!((far.0.x - near.0.x - 1.0).abs() < 1e-14);
        assert!((far.1 - near.1 + 0.99_f64.sqrt()).abs() < 1e-14);
    }

    #[test]
    fn without_a_ride_the_eyes_rest_where_they_are() {
        let rider = Riding::default().rider(2.5);
        let eye = Aperture { x: -0.05, y: 0.0, z: 0.0 };
        assert_eq!(rider.event_of(eye), (eye, 2.5));
        assert_eq!(rider.observer(), Observer::at_rest(2.5));
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
