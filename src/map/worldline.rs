//! The worldline of a point: straight, or that of a point of a wheel, which winds about the axle's.

use std::f64::consts::TAU;

use glam::DVec3;
use relativity_core::{Boost, Event, Observer, ObserverVelocity, Worldline, math};
use relativity_render::{MaterialPoint, Motion, Velocity};

use super::present::{Present, measured_by};
use super::straight_line::StraightLine;
use crate::scene::Track;
use crate::settings::{Riding, Settings};

/// Pieces of a drawn turn.
const PIECES_OF_A_TURN: f64 = 48.0;
/// Greatest number of pieces that are drawn: a line of more turns than these make up is drawn as straight.
const MOST_PIECES: f64 = 4096.0;

/// The worldline of a point, in the frame of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointWorldline {
    /// The velocity of the point's group on the ground.
    velocity: Velocity,
    /// The frame of the map, by its velocity on the ground.
    frame: ObserverVelocity,
    /// The point in the frame of its group, from the point between the eyes.
    point: MaterialPoint,
    /// Place of the axle; of the point itself, if it does not turn.
    axle: DVec3,
    /// Whether the frame of its group is that of the map, too.
    pub rests: bool,
}

impl PointWorldline {
    /// Returns the worldline of `point` in the frame that moves at `frame`.
    #[must_use]
    pub fn new(settings: &Settings, point: &Track, frame: ObserverVelocity) -> Self {
        let velocity = settings.velocity(point.motion);
        let axle = settings.rest_place(point.axle()).into();
        let point = settings.from_between_eyes(point);
        Self { velocity, frame, point, axle, rests: Velocity::along_street(&frame) == Some(velocity) }
    }

    /// Returns the event of the worldline at the ground's time `t`.
    #[must_use]
    pub fn at(&self, t: f64) -> Event {
        let place = self.place(t);
        if self.rests {
            return Event { x: place.x, t: self.now(t).proper_time(place) };
        }
        let Event { x, t } = self.clock_at(place).at(t);
        self.frame.event_at([x, place.y, place.z], t)
    }

    /// Returns the place in the frame of its group at the ground's time `t`, from the point between the eyes.
    #[must_use]
    pub fn place(&self, t: f64) -> DVec3 {
        self.now(t).place(self.point)
    }

    /// Returns the time of a clock at the point at the ground's time `t`, all clocks of its group's frame
    /// being set alike there.
    #[must_use]
    pub fn proper_time(&self, t: f64) -> f64 {
        self.now(t).proper_time(self.place(t))
    }

    /// The ground's time `t`.
    const fn now(&self, t: f64) -> Present {
        Present { on_ground: self.velocity, relative: self.velocity, time: t }
    }

    /// The ground's time of its event at the time `t` of the map's frame.
    #[must_use]
    pub fn ground_time(&self, t: f64) -> f64 {
        let velocity = self.frame;
        Velocity::along_street(&velocity).map_or_else(
            || self.ground_time_aslant(&Observer { velocity, ..Observer::at_rest(0.0) }.at(t)),
            |frame| self.ground_time_in(frame, t),
        )
    }

    /// The ground's time of its event at the present of `observer`.
    pub(super) fn ground_time_at(&self, observer: &Observer) -> f64 {
        let here = Event { x: observer.place[0], t: observer.time };
        Velocity::along_street(&observer.velocity).map_or_else(
            || self.ground_time_aslant(observer),
            |frame| self.ground_time_in(frame, here.in_frame(frame).t),
        )
    }

    /// The ground's time of its event at the time `t` of the frame that moves at `frame`.
    fn ground_time_in(&self, frame: Velocity, t: f64) -> f64 {
        if frame == Velocity::REST {
            return t;
        }
        let relative = self.velocity.seen_from(frame);
        let then = Present { on_ground: self.velocity, relative, time: t };
        let place = then.place(self.point);
        self.clock_at(place).at_proper_time(then.proper_time(place)).t
    }

    /// The same of one who does not move along the street.
    fn ground_time_aslant(&self, observer: &Observer) -> f64 {
        let (speed, here) = (self.velocity.speed, DVec3::from(observer.place));
        let view = measured_by(observer, here, speed).of_group(Motion::Own(self.velocity));
        let place = view.place_when_shown(self.point);
        observer.ground_time_of(&self.clock_at(place), [place.y, place.z])
    }

    /// The worldline on the ground, along x, of a clock at `place` in the frame of its group.
    fn clock_at(&self, place: DVec3) -> Worldline {
        Worldline::at_rest(self.velocity, place.x)
    }

    /// When light that leaves it at the ground's time `t` is received between the eyes, by the clock of
    /// whoever rides if they are on this `ride`.
    #[must_use]
    pub fn received(&self, ride: &Riding, t: f64) -> f64 {
        let place = self.place(t);
        let clock = self.clock_at(place);
        if ride.is_on() {
            return ride.received(DVec3 { x: clock.at(t).x, ..place }, t);
        }
        clock.reception(t, math::hypot(place.y, place.z))
    }

    /// The worldline of the axle that it turns about, from the ground's time `time` on, a step for each unit
    /// of that; its own, if it does not turn.
    #[must_use]
    pub fn straight(&self, time: f64) -> StraightLine {
        let axle = MaterialPoint { rest: self.axle, spin: None };
        StraightLine { through: Self { point: axle, ..*self }.at(time), step: self.step() }
    }

    /// The step that the axle makes in a unit of the ground's time, in the frame of the map.
    fn step(&self) -> Event {
        let Some(frame) = Velocity::along_street(&self.frame) else {
            return self.frame.event_at([self.velocity.beta(), 0.0, 0.0], 1.0);
        };
        Boost::from(self.velocity).unit_step_in(frame)
    }

    /// The ground's times at which it is drawn between two of them, those included: as close together as its
    /// bends ask for.
    #[must_use]
    pub fn times(&self, [first, last]: [f64; 2]) -> Vec<f64> {
        let Some(spin) = self.point.spin else { return vec![first, last] };
        // Even steps of its own clock, in which it turns evenly.
        let [from, to] = [first, last].map(|t| self.proper_time(t));
        let omega = spin.omega(self.velocity.beta());
        let pieces = (PIECES_OF_A_TURN * omega.abs() * (to - from) / TAU).ceil();
        if !(1.0..=MOST_PIECES).contains(&pieces) {
            return vec![first, last];
        }
        let between = |piece: u32| {
            let own = from + (to - from) * f64::from(piece) / pieces;
            self.clock_at(spin.turned(self.point.rest, omega * own)).at_proper_time(own).t
        };
        let inner = (1..pieces as u32).map(between);
        [first].into_iter().chain(inner).chain([last]).collect()
    }

    /// The velocity of the point's group on the ground.
    #[must_use]
    pub const fn velocity(&self) -> Velocity {
        self.velocity
    }

    /// Returns the distance at which the point, or its axle, passes the line along x through the eyes.
    #[must_use]
    pub fn distance(&self) -> f64 {
        math::hypot(self.axle.y, self.axle.z)
    }

    /// Returns the distance of the point from the axle.
    #[must_use]
    pub fn reach(&self) -> f64 {
        math::hypot(self.point.rest.x - self.axle.x, self.point.rest.z - self.axle.z)
    }
}
