//! A ride: an observer who accelerates, in legs of constant proper acceleration.
//!
//! Each leg is one closed step, and a ride keeps the moments at the ends of its legs: any moment is found by
//! bisection among them, whatever the length of the steps in which it is played. Time is the rider's own: at
//! a Lorentz factor of 1e12 one unit of it is 1e12 of the street's.
//!
//! # Conventions
//!
//! The proper acceleration a, what a balance on the bicycle shows, is along the axes of the head, constant
//! during a leg. With alpha = |a|, n its direction and H = alpha ds the rapidity gained in the proper time
//! ds, a rider at rest at first has moved by 2 sinh(H/2)^2/alpha along n when sinh(H)/alpha of the street's
//! time is over. A rider who moves already does so in the frame of the start of the step.
//!
//! The head is carried without turning, as a gyroscope would be. Where the acceleration is not along the
//! velocity, two pushes that do not turn it make up one that does (the Wigner rotation, for small steps the
//! Thomas precession): the turn of the head against the observer's axes is kept as a unit quaternion.
//!
//! Reference: W. Rindler, *Introduction to Special Relativity* (1991), for constant proper acceleration.

use std::sync::Arc;

use crate::math;
use crate::observer::{Observer, ObserverVelocity};
use crate::speed::SpeedError;

/// A part of a ride with one proper acceleration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// Duration by the rider's own clock, 0 or more.
    pub duration: f64,
    /// Proper acceleration along the axes of the head, in units of c per unit of proper time: ahead when
    /// riding towards +x, to the left, and up.
    pub acceleration: [f64; 3],
}

impl Leg {
    /// Magnitude of the proper acceleration, c per unit of proper time.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        length(self.acceleration)
    }
}

fn length([x, y, z]: [f64; 3]) -> f64 {
    math::hypot(x, math::hypot(y, z))
}

/// The velocity of a rider. Along the street it is kept as the rapidity, in which pushes add up exactly: who
/// brakes as long as they pedalled is at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RiderVelocity {
    /// Along the street, towards +x where the rapidity is above 0.
    AlongStreet {
        /// Rapidity towards +x, below 0 for the other way.
        rapidity: f64,
    },
    /// A velocity in any direction.
    Any {
        /// Proper velocity, Gamma times the velocity.
        proper: [f64; 3],
    },
}

/// A moment of a ride.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RideMoment {
    /// The rider's proper time.
    pub proper_time: f64,
    /// T, the time of the street's clock beside the rider.
    pub time: f64,
    /// Place of the rider on the ground.
    pub place: [f64; 3],
    /// Velocity on the ground.
    pub velocity: RiderVelocity,
    /// From the axes of the head to the observer's: a unit quaternion, its real part first.
    pub head: [f64; 4],
}

/// Two odometers of a rider, each right, which never count back; and how far the wheels have turned.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Odometers {
    /// The street that the wheels rolled over, as the rider measures it, contracted: the integral of |V| over
    /// proper time.
    pub by_wheel: f64,
    /// The street as it measures itself, counted by its lamps: the integral of Gamma |V|.
    pub by_lamps: f64,
    /// The signed count of `by_wheel`, which falls where one rides back: the integral of V. It is below 0
    /// before the start of who comes riding towards +x.
    pub rolled: f64,
}

/// A ride: where it starts, and its legs.
///
/// # Examples
///
/// ```
/// use relativity_core::ride::{Leg, Ride, RideMoment};
///
/// // Out and back in eight units of my proper time: 14.5 have gone by at home.
/// let leg = |acceleration| Leg { duration: 2.0, acceleration: [acceleration, 0.0, 0.0] };
/// let legs = vec![leg(1.0), leg(-1.0), leg(-1.0), leg(1.0)];
/// let there_and_back = Ride::new(RideMoment::AT_REST, legs);
/// let home = there_and_back.at(8.0);
/// assert!((home.time - 14.507_441_63).abs() < 1e-8 && home.place[0].abs() < 1e-14);
/// assert_eq!(home.observer()?.velocity.speed().gamma(), 1.0);
/// # Ok::<(), relativity_core::SpeedError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Ride {
    start: RideMoment,
    legs: Arc<[Leg]>,
    /// The moment and the odometers at the end of each leg.
    ends: Vec<(RideMoment, Odometers)>,
}

impl RideMoment {
    /// At rest at the ground's origin at T = 0, when the rider's clock shows 0.
    pub const AT_REST: Self = Self {
        proper_time: 0.0,
        time: 0.0,
        place: [0.0; 3],
        velocity: RiderVelocity::AlongStreet { rapidity: 0.0 },
        head: [1.0, 0.0, 0.0, 0.0],
    };

    /// Returns the observer of this moment, whose own clock counts from it.
    ///
    /// # Errors
    ///
    /// A Lorentz factor above [`crate::MAX_GAMMA`].
    pub fn observer(&self) -> Result<Observer, SpeedError> {
        let velocity = ObserverVelocity::from_proper(self.proper_velocity())?;
        Ok(Observer { velocity, place: self.place, time: self.time })
    }

    /// Gamma times the velocity on the ground.
    #[must_use]
    pub fn proper_velocity(&self) -> [f64; 3] {
        match self.velocity {
            RiderVelocity::AlongStreet { rapidity } => [math::sinh(rapidity), 0.0, 0.0],
            RiderVelocity::Any { proper } => proper,
        }
    }

    /// The rapidity on the ground: along the street below 0 towards -x, in any other direction its magnitude.
    #[must_use]
    pub fn rapidity(&self) -> f64 {
        match self.velocity {
            RiderVelocity::AlongStreet { rapidity } => rapidity,
            RiderVelocity::Any { proper } => math::asinh(length(proper)),
        }
    }

    /// Returns the moment after `duration` of proper time with this proper `acceleration` along the axes of
    /// the head.
    #[must_use]
    pub fn after(&self, duration: f64, acceleration: [f64; 3]) -> Self {
        match (self.velocity, acceleration) {
            (RiderVelocity::AlongStreet { rapidity }, [along, 0.0, 0.0])
                if self.head == Self::AT_REST.head =>
            {
                self.along_street(rapidity, duration, along)
            }
            _ => self.anywhere(duration, acceleration),
        }
    }

    /// Along the street rapidities add up; T and x grow by sums of products, in which nothing cancels at any
    /// speed.
    fn along_street(&self, rapidity: f64, duration: f64, acceleration: f64) -> Self {
        let gained = acceleration * duration;
        let mean = rapidity + 0.5 * gained;
        // 2 sinh(H/2)/alpha, the proper time itself where hardly anything is gained.
        let length = duration * sinh_over(0.5 * gained);
        let [x, y, z] = self.place;
        Self {
            proper_time: self.proper_time + duration,
            time: self.time + math::cosh(mean) * length,
            place: [x + math::sinh(mean) * length, y, z],
            velocity: RiderVelocity::AlongStreet { rapidity: rapidity + gained },
            ..*self
        }
    }

    fn anywhere(&self, duration: f64, acceleration: [f64; 3]) -> Self {
        let alpha = length(acceleration);
        let gained = alpha * duration;
        let ahead = if alpha > 0.0 { acceleration.map(|part| part / alpha) } else { [1.0, 0.0, 0.0] };
        let n = turned(self.head, ahead);
        let w = self.proper_velocity();
        let size = length(w);
        let gamma = math::hypot(1.0, size);
        let along: f64 = (0..3).map(|i| w[i] * n[i]).sum();

        // In the frame of the start: dt' = sinh(H)/alpha, dr' = 2 sinh(H/2)^2/alpha.
        let half = sinh_over(0.5 * gained);
        let (later, further) = (duration * sinh_over(gained), 0.5 * gained * duration * half * half);
        let (sine, cosine) = (math::sinh(gained), math::cosh(gained));
        let per_place = later + along * further / (gamma + 1.0);
        let per_velocity = cosine + along * sine / (gamma + 1.0);
        let h1 = w.map(|part| part / (gamma + 1.0));
        let h2 = n.map(|part| part * math::tanh(0.5 * gained));
        Self {
            proper_time: self.proper_time + duration,
            time: self.time + gamma * later + along * further,
            place: std::array::from_fn(|i| self.place[i] + n[i] * further + w[i] * per_place),
            velocity: RiderVelocity::Any {
                proper: std::array::from_fn(|i| n[i] * sine + w[i] * per_velocity),
            },
            head: normalized(product(wigner(h1, h2), self.head)),
        }
    }
}

impl Odometers {
    /// Returns the readings after a `leg` that starts with this `rapidity` along the street.
    fn after(self, rapidity: f64, Leg { duration, acceleration }: Leg) -> Self {
        let gained = duration * acceleration[0];
        let end = rapidity + gained;
        if gained == 0.0 {
            return self.and(Self::of_part(rapidity.abs(), 0.0, duration), rapidity);
        }
        // Where it turns round it is at rest.
        let turn = if rapidity * end < 0.0 { 0.0 } else { end };
        [(rapidity, turn), (turn, end)].into_iter().fold(self, |total, (from, to)| {
            let share = (to - from) / (end - rapidity);
            let part = Self::of_part(from.abs().min(to.abs()), (to - from).abs(), share * duration);
            total.and(part, from + to)
        })
    }

    /// Returns the readings after a part of this `duration`, in which the rapidity grows from `slower`, 0 or
    /// more, by `gained`.
    fn of_part(slower: f64, gained: f64, duration: f64) -> Self {
        let length = duration * sinh_over(0.5 * gained);
        let by_lamps = math::sinh(slower + 0.5 * gained) * length;
        if gained == 0.0 {
            return Self { by_wheel: duration * math::tanh(slower), by_lamps, rolled: 0.0 };
        }
        // ln(cosh(slower + gained)/cosh(slower)), all of whose terms are above 0.
        let half = math::sinh(0.5 * gained);
        let grown = math::ln_1p(2.0 * half * half + math::tanh(slower) * math::sinh(gained));
        Self { by_wheel: duration * (grown / gained), by_lamps, rolled: 0.0 }
    }

    /// Adds a `part` that is ridden towards +x if `direction` is above 0, towards -x if it is below.
    fn and(self, part: Self, direction: f64) -> Self {
        Self {
            by_wheel: self.by_wheel + part.by_wheel,
            by_lamps: self.by_lamps + part.by_lamps,
            rolled: self.rolled + part.by_wheel.copysign(direction),
        }
    }
}

impl Ride {
    /// A ride from `start` with these `legs`, in order; after the last the rider coasts.
    #[must_use]
    pub fn new(start: RideMoment, legs: impl Into<Arc<[Leg]>>) -> Self {
        let legs: Arc<[Leg]> = legs.into();
        let first = (start, Odometers::default());
        let ends = legs.iter().scan(first, |(moment, odometers), leg| {
            if let RiderVelocity::AlongStreet { rapidity } = moment.velocity {
                *odometers = odometers.after(rapidity, *leg);
            }
            *moment = moment.after(leg.duration, leg.acceleration);
            Some((*moment, *odometers))
        });
        let ends = ends.collect();
        Self { start, legs, ends }
    }

    /// Duration of all legs by the rider's own clock.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.legs.iter().map(|leg| leg.duration).sum()
    }

    /// Returns the odometers when the rider's clock shows `proper_time`, at 0 at the start; at 0 all along
    /// where the velocity there is not along the street.
    #[must_use]
    pub fn odometers(&self, proper_time: f64) -> Odometers {
        let (moment, odometers, leg) = self.leg_at(proper_time);
        match moment.velocity {
            RiderVelocity::AlongStreet { rapidity } if leg.duration < 0.0 => {
                Odometers { rolled: leg.duration * math::tanh(rapidity), ..Odometers::default() }
            }
            RiderVelocity::AlongStreet { rapidity } => odometers.after(rapidity, leg),
            RiderVelocity::Any { .. } => Odometers::default(),
        }
    }

    /// Returns the moment when the rider's clock shows `proper_time`; before the start that moves as at it.
    #[must_use]
    pub fn at(&self, proper_time: f64) -> RideMoment {
        let (moment, _, leg) = self.leg_at(proper_time);
        moment.after(leg.duration, leg.acceleration)
    }

    /// Returns the moment and the odometers at the start of the leg that is ridden when the rider's clock
    /// shows `proper_time`, and the part of that leg until then. Before the start that has a duration below
    /// 0.
    fn leg_at(&self, proper_time: f64) -> (RideMoment, Odometers, Leg) {
        let number = self.ends.partition_point(|(end, _)| end.proper_time < proper_time);
        let before = number.checked_sub(1).map(|before| self.ends[before]);
        let (moment, odometers) = before.unwrap_or((self.start, Odometers::default()));
        let duration = proper_time - moment.proper_time;
        let pushed = self.legs.get(number).filter(|_| duration >= 0.0);
        let acceleration = pushed.map_or([0.0; 3], |leg| leg.acceleration);
        (moment, odometers, Leg { duration, acceleration })
    }
}

/// sinh(x)/x, which is 1 at 0.
fn sinh_over(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { math::sinh(x) / x }
}

/// The Wigner rotation of two boosts, whose vectors are tanh of half the rapidity long, as an unnormalised
/// quaternion: (1 + `h1.h2`, `h2` x `h1`).
fn wigner(h1: [f64; 3], h2: [f64; 3]) -> [f64; 4] {
    let [x, y, z] = crate::stereo::cross(h2, h1);
    [1.0 + h1[0] * h2[0] + h1[1] * h2[1] + h1[2] * h2[2], x, y, z]
}

fn product([a, b, c, d]: [f64; 4], [e, f, g, h]: [f64; 4]) -> [f64; 4] {
    [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]
}

fn normalized(q: [f64; 4]) -> [f64; 4] {
    let length = q.iter().map(|part| part * part).sum::<f64>().sqrt();
    q.map(|part| part / length)
}

/// Returns this vector turned by the unit quaternion `q`.
fn turned(q: [f64; 4], [x, y, z]: [f64; 3]) -> [f64; 3] {
    let [a, b, c, d] = q;
    let [_, x, y, z] = product(product(q, [0.0, x, y, z]), [a, -b, -c, -d]);
    [x, y, z]
}
