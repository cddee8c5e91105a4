//! Whoever rides, at a moment of the ride: place, velocity, clocks, and the head.
//!
//! The head is carried along without being turned, as a gyroscope would be. On a straight ride its axes are
//! the observer's, which are the ground's, boosted without turning; who is pushed aside has a head that turns
//! against these (the Wigner rotation). The line between the eyes and the gaze are set in the axes of the
//! head, and what is seen is told in the observer's.

use glam::{DQuat, DVec3};
use relativity_core::{Aperture, Baseline, Boost, Event, Observer, ObserverVelocity, RideMoment, math};
use relativity_render::{Gaze, Velocity};

use super::ride::Riding;
use crate::flags::MAX_TIME;
use crate::time_range;

/// A moment of a ride, or of resting eyes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rider {
    /// Velocity along the line of the ride; off it its magnitude.
    pub velocity: Velocity,
    /// Place x on the street.
    pub x: f64,
    /// Places y and z beside the middle between eyes that rest, and above.
    pub aside: [f64; 2],
    /// The time of the street's clock there.
    pub street_time: f64,
    /// Velocity on the ground, with its direction.
    on_ground: ObserverVelocity,
    /// From the axes of the head to the observer's, which are the ground's, boosted without turning.
    head: DQuat,
    /// Direction in which the rider moves, in the axes of the head: a unit vector along the line of the ride,
    /// to its left and up, along the line at rest. It is up to the sign of the velocity that it is ahead.
    pub ahead: [f64; 3],
}

/// The direction of the line of a ride in its own axes.
const AHEAD: [f64; 3] = [1.0, 0.0, 0.0];

impl Riding {
    /// The observer when the clock of the ride shows `time`; at rest at this T without a ride.
    #[must_use]
    pub fn rider(&self, time: f64) -> Rider {
        let Some(course) = self.course() else { return Rider::at_rest(time) };
        let moment = course.ride.at(time);
        let rider =
            if course.is_straight { Rider::on_line(moment, self) } else { Rider::off_line(&moment, self) };
        if self.stands { rider.standing() } else { rider }
    }

    /// Returns when the clock of the ride shows that light arrives between the eyes which left `place`, from
    /// between resting eyes, at the ground's time `t`: to the last digit, by bisection, since legs have no
    /// formula for it.
    #[must_use]
    pub fn received(&self, place: DVec3, t: f64) -> f64 {
        let has_arrived = |time: f64| {
            let rider = self.rider(time);
            let [y, z] = rider.aside;
            rider.street_time - t >= place.distance(DVec3::new(rider.x, y, z))
        };
        time_range::first_time([-MAX_TIME, MAX_TIME], has_arrived)
    }
}

impl Rider {
    /// At rest at the ground's origin.
    const fn at_rest(time: f64) -> Self {
        let (on_ground, head) = (ObserverVelocity::REST, DQuat::IDENTITY);
        Self {
            velocity: Velocity::REST,
            x: 0.0,
            aside: [0.0; 2],
            street_time: time,
            on_ground,
            head,
            ahead: AHEAD,
        }
    }

    /// Whoever stands where this rider is, with the head held alike.
    const fn standing(self) -> Self {
        Self { velocity: Velocity::REST, on_ground: ObserverVelocity::REST, ..self }
    }

    /// The `moment` of a straight ride, which has the line of `riding` as x.
    fn on_line(moment: RideMoment, riding: &Riding) -> Self {
        let velocity = Velocity::from_rapidity(moment.rapidity());
        let ([x, ..], street_time) = (moment.place, moment.time);
        let at_origin = Self { velocity, street_time, ..Self::at_rest(street_time) };
        if !riding.has_own_direction() {
            return Self { x, on_ground: velocity.into(), ..at_origin };
        }
        let [along_x, y, z] = riding.direction().map(|part| part * x);
        let ahead = riding.heading(velocity.speed);
        let on_ground = match (velocity == Velocity::REST, velocity.is_backward) {
            (true, _) => ObserverVelocity::REST,
            (_, true) => ahead.opposite(),
            (_, false) => ahead,
        };
        Self { x: riding.ride_from + along_x, aside: [y, z], on_ground, ..at_origin }
    }

    /// The `moment` of a ride that is pushed aside, in the axes of the line of `riding`.
    fn off_line(moment: &RideMoment, riding: &Riding) -> Self {
        let axes = riding.axes();
        let [x, y, z] = (axes * DVec3::from(moment.place)).to_array();
        let proper = (axes * DVec3::from(moment.proper_velocity())).to_array();
        // The legs of a ride are within bounds.
        let on_ground = ObserverVelocity::from_proper(proper).unwrap_or(ObserverVelocity::REST);
        let [real, i, j, k] = moment.head;
        let turned = axes * DVec3::new(i, j, k);
        let to_head = DQuat::from_xyzw(i, j, k, real).conjugate();
        let moving = (to_head * DVec3::from(moment.proper_velocity())).try_normalize();
        Self {
            velocity: Velocity::forward(*on_ground.speed()),
            x: riding.ride_from + x,
            aside: [y, z],
            street_time: moment.time,
            on_ground,
            head: DQuat::from_xyzw(turned.x, turned.y, turned.z, real),
            ahead: moving.map_or(AHEAD, Into::into),
        }
    }

    /// `vector`, in the axes of the head, in the observer's.
    #[must_use]
    pub fn from_head(&self, vector: DVec3) -> DVec3 {
        if self.head == DQuat::IDENTITY { vector } else { self.head * vector }
    }

    /// `vector`, in the observer's axes, in those of the head.
    #[must_use]
    pub fn to_head(&self, vector: DVec3) -> DVec3 {
        if self.head == DQuat::IDENTITY { vector } else { self.head.conjugate() * vector }
    }

    /// `gaze`, in the axes of the head, in the observer's.
    #[must_use]
    pub fn gaze_from_head(&self, gaze: Gaze) -> Gaze {
        self.gaze_turned(gaze, Self::from_head)
    }

    /// `gaze`, in the observer's axes, in those of the head.
    #[must_use]
    pub fn gaze_to_head(&self, gaze: Gaze) -> Gaze {
        self.gaze_turned(gaze, Self::to_head)
    }

    /// `gaze` turned as its direction is; to the last digit itself if the head is not turned.
    fn gaze_turned(&self, gaze: Gaze, turned: fn(&Self, DVec3) -> DVec3) -> Gaze {
        let is_turned = self.head != DQuat::IDENTITY;
        if is_turned { Gaze::along(turned(self, gaze.axes().forward).into()) } else { gaze }
    }

    /// The line between the eyes, `baseline` in the axes of the head, in the observer's.
    #[must_use]
    pub fn baseline(&self, baseline: Baseline) -> Baseline {
        if self.head == DQuat::IDENTITY {
            return baseline;
        }
        let DVec3 { x, y, z } = self.from_head(baseline.direction().into());
        let (roll, turn) = (math::atan2(z, math::hypot(x, y)), math::atan2(y, x));
        Baseline { roll, turn, ..baseline }
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

    /// The event of an eye that is at `aperture` from the middle between the eyes, in the rider's frame: its
    /// place on the ground, and the time of the street's clock there.
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
    use crate::settings::ride::riding;
    use crate::settings::{Preset, Settings};

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

    /// Rows 2 and 3 of the derivation's table: W. Rindler's uniform acceleration, then one to the left by the
    /// axes of the head.
    #[test]
    fn pushes_aside_turn_the_head() {
        for (legs, time, clock, place, proper, turned) in [
            (
                "2@1,1@0:1",
                3.0,
                8.048_197_275,
                [7.024_486_372, 0.543_080_634_8],
                [5.596_538_061, 1.175_201_194],
                -38.778_603_27_f64,
            ),
            (
                "1@1,1@0:1,1@-1,1@0:-1",
                4.0,
                6.858_719_506,
                [3.624_642_879, 3.217_306_610],
                [-0.103_382_115_3, 0.984_838_826_3],
                -78.014_801_94,
            ),
        ] {
            for azimuth in [0.0_f64, 90.0, -120.0] {
                let ride = Riding { ride_azimuth: azimuth, ride_from: 3.0, ..riding(legs, "0") };
                let rider = ride.rider(time);
                let (sine, cosine) = azimuth.to_radians().sin_cos();
                let turn = |[x, y]: [f64; 2]| [cosine * x - sine * y, sine * x + cosine * y];
                let observer = rider.observer();
                let ([x, y], [u, v]) = (turn(place), turn(proper));
                let moves =
                    observer.velocity.direction().map(|part| part * observer.velocity.speed().proper());
                for (found, expected) in observer.place.into_iter().zip([3.0 + x, y, 0.0]) {
                    assert!((found - expected).abs() < 2e-9, "{azimuth}: {:?}", observer.place);
                }
                for (found, expected) in moves.into_iter().zip([u, v, 0.0]) {
                    assert!((found - expected).abs() < 2e-9, "{azimuth}: {moves:?}");
                }
                assert!((rider.street_time - clock).abs() < 1e-8);
                let head = rider.from_head(DVec3::X);
                assert!((head.y.atan2(head.x).to_degrees() - turned).abs() < 1e-7, "{head}");
                assert!(rider.to_head(head).abs_diff_eq(DVec3::X, 1e-15));
            }
        }
    }

    /// Vectors of spacetime, (T, x, y, z), with the metric (-, +, +, +).
    type Four = [f64; 4];

    fn sum(a: Four, scale: f64, b: Four) -> Four {
        std::array::from_fn(|i| a[i] + scale * b[i])
    }

    fn product(a: Four, b: Four) -> f64 {
        a[1] * b[1] + a[2] * b[2] + a[3] * b[3] - a[0] * b[0]
    }

    /// An event, the velocity there, and three axes of a head that no torque turns.
    type Carried = [Four; 5];

    /// Fermi and Walker's transport: the velocity changes by the push along the axes, and each axis by as
    /// much along the velocity.
    fn rate(carried: &Carried, acceleration: [f64; 3]) -> Carried {
        let [_, u, axes @ ..] = *carried;
        let push = (0..3).fold([0.0; 4], |push, i| sum(push, acceleration[i], axes[i]));
        let [x, y, z] = acceleration.map(|part| u.map(|along| part * along));
        [u, push, x, y, z]
    }

    /// Takes one step of Runge and Kutta's fourth order.
    fn stepped(carried: &Carried, acceleration: [f64; 3], step: f64) -> Carried {
        let along = |scale: f64, rate: &Carried| -> Carried {
            std::array::from_fn(|i| sum(carried[i], scale, rate[i]))
        };
        let first = rate(carried, acceleration);
        let second = rate(&along(0.5 * step, &first), acceleration);
        let third = rate(&along(0.5 * step, &second), acceleration);
        let fourth = rate(&along(step, &third), acceleration);
        std::array::from_fn(|i| {
            let middle = sum(second[i], 1.0, third[i]);
            sum(carried[i], step / 6.0, sum(sum(first[i], 2.0, middle), 1.0, fourth[i]))
        })
    }

    /// The axes of a gyroscope along the ride, found by small steps, and light that arrives there from a lamp
    /// at rest: where each eye sees it in the axes of the head.
    #[test]
    fn eyes_see_a_lamp_in_the_axes_of_a_gyroscope() {
        const STEPS: u32 = 2000;
        let mut settings = Preset::named("ride-lamps").expect("a preset").settings.clone();
        for (legs, azimuth, elevation) in [
            ("2@0.8,2@0:0.9,1@-0.5:-1", 0.0, 0.0),
            ("1@0:1,2@1:0:0.7,2@0:-0.6:-1", 0.0, 0.0),
            ("2@0.8,2@0:0.9,1@-0.5:-1", 140.0, 0.0),
            ("2@0.8,2@0:0.9,1@-0.5:-1:0.5", 35.0, 25.0),
            ("3@0.6,2@-0.6", 70.0, 0.0),
        ] {
            settings.ride = Riding {
                ride_azimuth: azimuth,
                ride_elevation: elevation,
                ride_from: -3.0,
                ..riding(legs, "0")
            };
            let axes = settings.ride.axes();
            let at = |v: DVec3| [0.0, v.x, v.y, v.z];
            let [ahead, left, up] = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| at(axes * axis));
            let start: Carried = [at(DVec3::new(-3.0, 0.0, 0.0)), [1.0, 0.0, 0.0, 0.0], ahead, left, up];
            let end = settings.ride.ride.0.as_deref().expect("legs").iter().fold(start, |start, leg| {
                let step = leg.duration / f64::from(STEPS);
                (0..STEPS).fold(start, |carried, _| stepped(&carried, leg.acceleration, step))
            });
            let [here, u, head @ ..] = end;
            let time = settings.ride.duration();
            let rider = settings.rider(time);
            let scene = settings.opened_scene().expect("a scene");
            let lamp = settings.track(&scene);
            let [x, y, z] = settings.rest_place(lamp.axle());
            let both = settings.disparity(&lamp, time).expect("in the domain");
            let seen = settings.directions(&lamp, time).map(|direction| direction.expect("it is seen"));
            for (eye, (from_middle, sighting)) in
                settings.pair().into_iter().zip([both.primary, both.secondary]).enumerate()
            {
                // The eyes are told in the axes of the observer at the start, the legs in those of the line.
                let from_middle = axes.transpose() * DVec3::new(from_middle.x, from_middle.y, from_middle.z);
                let event = (0..3).fold(here, |event, i| sum(event, from_middle[i], head[i]));
                let ways = [x - event[1], y - event[2], z - event[3]];
                let distance = ways.iter().map(|way| way * way).sum::<f64>().sqrt();
                let light = [-distance, ways[0], ways[1], ways[2]];
                let expected = axes * DVec3::from(head.map(|axis| product(axis, light)));
                assert!((product(u, light) - expected.length()).abs() < 1e-9 * expected.length());
                let found = rider.to_head(seen[eye]);
                assert!((found - expected).length() < 1e-9 * expected.length(), "{legs}: {found} {expected}");
                let of_sighting = rider.to_head(sighting.position.into());
                assert!(
                    (of_sighting - expected).length() < 1e-9 * expected.length(),
                    "{legs}: {of_sighting}"
                );
                assert!((sighting.doppler_factor - expected.length() / distance).abs() < 1e-9);
            }
        }
    }

    /// Light that left a lamp at the retarded time of a sighting is received at the time of that sighting.
    #[test]
    fn light_arrives_when_it_is_received() {
        let mut settings = Preset::named("ride-lamps").expect("a preset").settings.clone();
        let lamp = settings.track(&settings.opened_scene().expect("a scene"));
        let place = DVec3::from(settings.rest_place(lamp.axle()));
        // In one place both eyes are between themselves.
        settings.motion.d = 0.0;
        for (legs, speed, azimuth) in
            [("coast", "0.9", 0.0), ("2@0.8,2@0:0.9", "0", 35.0), ("3@1,3@-2", "-0.5", 90.0)]
        {
            settings.ride = Riding { ride_azimuth: azimuth, ..riding(legs, speed) };
            for time in [-4.0, 0.5, 3.0, 12.0] {
                let seen = settings.disparity(&lamp, time).expect("in the domain").primary;
                let received = settings.ride.received(place, seen.retarded_time);
                assert!((received - time).abs() < 1e-11, "{legs} at {time}: {received}");
            }
        }
    }

    #[test]
    fn a_head_that_is_not_turned_has_what_is_set_to_the_last_digit() {
        let rider = riding("2@1,2@-0.5", "0.3").rider(3.0);
        let (gaze, line) = (Gaze { azimuth: 0.1, elevation: -0.3 }, Settings::default().baseline());
        assert_eq!(
            (rider.gaze_from_head(gaze), rider.gaze_to_head(gaze), rider.baseline(line)),
            (gaze, gaze, line)
        );
    }
}
