//! Light that leaves the selected point: the events at which it left for each eye, the ray from there, and its wave
//! fronts.

use relativity_core::{Model, PairError, math};
use relativity_render::Velocity;

use super::event::{Event, StraightLine};
use crate::scene::Track;
use crate::settings::Settings;

/// How a point moves, in the frame of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worldline {
    /// The velocity of the point on the ground.
    velocity: Velocity,
    /// The frame of the map, by its velocity on the ground.
    frame: Velocity,
    /// Where the point rests in its own frame, from the point between the eyes.
    rest: [f64; 3],
    /// Whether that is the frame of the map, too.
    rests: bool,
}

impl Worldline {
    /// That of `point` in the frame that moves at `frame`.
    #[must_use]
    pub fn new(settings: &Settings, point: &Track, frame: Velocity) -> Self {
        let velocity = settings.velocity(point.motion);
        Self { velocity, frame, rest: settings.rest_place(point.rest), rests: velocity == frame }
    }

    /// It as the ground has it: from t = 0 on, a step for each unit of time.
    #[must_use]
    pub fn on_ground(&self) -> StraightLine {
        let through = Event { x: self.rest[0] / self.velocity.speed.gamma(), t: 0.0 };
        StraightLine { through, step: Event { x: self.velocity.beta(), t: 1.0 } }
    }

    /// Its event at the ground's time `t`.
    #[must_use]
    pub fn at(&self, t: f64) -> Event {
        if self.rests {
            return Event { x: self.rest[0], t: self.own_time(t) };
        }
        self.on_ground().at(t).in_frame(self.frame)
    }

    /// What a clock at the point shows at the ground's time `t`, all clocks of its frame being set alike there.
    #[must_use]
    pub fn own_time(&self, t: f64) -> f64 {
        t / self.velocity.speed.gamma() - self.velocity.beta() * self.rest[0]
    }

    /// The ground's time of its event at the time `t` of the map's frame.
    #[must_use]
    pub fn ground_time(&self, t: f64) -> f64 {
        (t - self.at(0.0).t) / self.step().t
    }

    /// When light that leaves it at the ground's time `t` is received between the eyes.
    #[must_use]
    pub fn received(&self, t: f64) -> f64 {
        let [y, z] = self.across();
        t + math::hypot(self.on_ground().at(t).x, math::hypot(y, z))
    }

    /// The step that it makes in a unit of the ground's time.
    #[must_use]
    pub fn step(&self) -> Event {
        self.step_in(self.frame)
    }

    /// That step in the frame that moves at `frame`: a unit of the ground's time is 1/gamma of its own, which that
    /// frame's clocks have as gamma of the velocity between the two.
    pub(super) fn step_in(&self, frame: Velocity) -> Event {
        let relative = self.velocity.seen_from(frame);
        let t = relative.speed.gamma() / self.velocity.speed.gamma();
        Event { x: relative.beta() * t, t }
    }

    /// The velocity of the point on the ground.
    #[must_use]
    pub const fn velocity(&self) -> Velocity {
        self.velocity
    }

    /// Whether the point rests in the frame of the map.
    #[must_use]
    pub const fn rests(&self) -> bool {
        self.rests
    }

    /// y and z of the point from the eyes.
    #[must_use]
    pub const fn across(&self) -> [f64; 2] {
        [self.rest[1], self.rest[2]]
    }
}

/// Light that reaches an eye at T.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Where and when it left the point.
    pub left: Event,
    /// Where and when the eye receives it.
    pub received: Event,
    /// The event in whose past light cone it left: of reception, or where one cone serves both eyes, that between them.
    pub apex: Event,
    /// How far from the line along x through that event the point passes.
    pub aside: f64,
    /// y and z of the eye.
    pub eye: [f64; 2],
    /// When it left, on the ground's clocks.
    pub happened: f64,
    /// What the point's own clock showed then.
    pub own_time: f64,
}

/// The rays to the left and to the right eye that arrive at `time`, the ground's, as the frame that moves at `frame`
/// has them, by the binocular model of what the views show.
///
/// # Errors
///
/// A time outside the domain of the core.
pub fn rays(settings: &Settings, point: &Track, time: f64, frame: Velocity) -> Result<[Ray; 2], PairError> {
    let worldline = Worldline::new(settings, point, frame);
    let both = settings.disparity(point, time)?;
    let [left, right] = settings.pair();
    let one_cone = settings.model() == Model::OneCone;
    Ok([(both.primary, left), (both.secondary, right)].map(|(seen, eye)| {
        // Where and when it rests is known better than by its place on the ground.
        let left = if worldline.rests {
            Event { x: worldline.rest[0], t: seen.own_time }
        } else {
            Event { x: eye.x + seen.position[0], t: seen.retarded_time }.in_frame(frame)
        };
        let received = Event { x: eye.x, t: time }.in_frame(frame);
        let between = Event { x: 0.0, t: time }.in_frame(frame);
        let apex = if one_cone { between } else { received };
        let [y, z] = if one_cone { worldline.across() } else { [seen.position[1], seen.position[2]] };
        Ray {
            left,
            received,
            apex,
            aside: math::hypot(y, z),
            eye: [eye.y, eye.z],
            happened: seen.retarded_time,
            own_time: seen.own_time,
        }
    }))
}

/// Light that left the point at one event, now: a sphere about the place of that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Front {
    /// Where along x and when it left.
    pub left: Event,
    /// When that was on the ground's clocks.
    pub happened: f64,
    /// What the point's own clock showed then.
    pub own_time: f64,
    /// How far it has come.
    pub radius: f64,
}

impl Front {
    /// Radius of the circle in which it meets a plane that passes the point at this `distance`; `None` until it does.
    ///
    /// In the plane of the eyes this circle reaches an eye exactly when the eye receives the light.
    #[must_use]
    pub fn radius_in_plane(&self, distance: f64) -> Option<f64> {
        let square = (self.radius - distance) * (self.radius + distance);
        (self.radius > 0.0 && square >= 0.0).then(|| square.sqrt())
    }
}

impl Ray {
    /// The front that it belongs to, as it reaches the eye.
    #[must_use]
    pub fn front(&self) -> Front {
        let Self { left, apex, happened, own_time, .. } = *self;
        Front { left, happened, own_time, radius: apex.t - left.t }
    }
}

/// How many fronts there are at most.
const MOST_FRONTS: i32 = 10;

/// The fronts of light that left the point at the multiples of `period` of the time of the worldline's frame, as they are
/// at its time `now`; the last ones first.
pub fn fronts(worldline: &Worldline, now: f64, period: f64) -> impl Iterator<Item = Front> {
    let last = (now / period).floor();
    let number = if last.is_finite() { MOST_FRONTS } else { 0 };
    (0..number).map(move |back| {
        let t = (last - f64::from(back)) * period;
        let happened = worldline.ground_time(t);
        let left = Event { t, ..worldline.at(happened) };
        Front { left, happened, own_time: worldline.own_time(happened), radius: now - t }
    })
}
