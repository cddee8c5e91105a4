//! The spacetime face: x against t, with c = 1, of the selected point and both eyes.
//!
//! The point passes beside the eyes, not through them. So what is drawn of an eye's past light cone is its
//! cut by the point's own plane, in which y and z are the point's: a hyperbola, whose asymptotes are light
//! that runs along x.

use glam::DVec3;
use relativity_core::{Aperture, Event, Observer, ObserverError, ObserverVelocity, SourcePoint, math};
use relativity_render::Velocity;

use super::light::{ReceivedRay, rays};
use super::straight_line::StraightLine;
use super::worldline::PointWorldline;
use super::{Chart, Viewpoint};
use crate::scene::Track;
use crate::settings::Settings;
use crate::time_range;

/// The past light cone of an eye, cut by the plane in which the point moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PastCone {
    /// The event of reception, or that between the eyes where one cone serves both.
    pub apex: Event,
    /// Distance at which the point passes the line along x through the event.
    pub distance: f64,
}

impl PastCone {
    /// Pieces of a drawn curve: enough for one of a few hundred pixels.
    const PIECES: i32 = 64;

    /// The latest t at `x` from which light still reaches the eye.
    #[must_use]
    pub fn time(&self, x: f64) -> f64 {
        self.apex.t - math::hypot(x - self.apex.x, self.distance)
    }

    /// Returns the range in which it is later than `t`; `None` where that is nowhere.
    #[must_use]
    pub fn later_than(&self, t: f64) -> Option<[f64; 2]> {
        let ago = self.apex.t - t;
        let reach = ((ago - self.distance) * (ago + self.distance)).sqrt();
        (ago > self.distance).then_some([self.apex.x - reach, self.apex.x + reach])
    }

    /// The curve from `low` to `high`: events that lie close together where it bends.
    #[must_use]
    pub fn curve(&self, [low, high]: [f64; 2]) -> Vec<Event> {
        let [low, high] = [low - self.apex.x, high - self.apex.x];
        // x - a = rho sinh u, R = rho cosh u; where rho is nothing beside the reach, two straight lines.
        let bend = self.distance.max(1e-3 * low.abs().max(high.abs()));
        if !(bend > 0.0 && bend.is_finite()) {
            return Vec::new();
        }
        let [first, last] = [low, high].map(|end| math::asinh(end / bend));
        let place = |piece| {
            let u = first + (last - first) * f64::from(piece) / f64::from(Self::PIECES);
            let x = self.apex.x + bend * math::sinh(u);
            Event { x, t: self.time(x) }
        };
        (0..=Self::PIECES).map(place).collect()
    }

    /// Light that runs along x and reaches the eye from the left, and from the right.
    #[must_use]
    pub fn asymptotes(&self) -> [StraightLine; 2] {
        [1.0, -1.0].map(|x| StraightLine { through: self.apex, step: Event { x, t: 1.0 } })
    }
}

/// The spacetime face: the events of a point at T.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Diagram {
    /// The frame it is drawn in, by its velocity on the ground.
    pub frame: ObserverVelocity,
    /// The velocity of the other frame beside the ground's: that in which the scene rests, or whoever rides
    /// does at this moment.
    pub other: ObserverVelocity,
    /// Worldline of the point.
    pub point: PointWorldline,
    /// The light that the eyes receive at T.
    pub rays: [ReceivedRay; 2],
    /// The middle between the eyes at T.
    pub present: Event,
    /// The time of the ground's clocks there: T, of eyes that rest.
    pub time: f64,
    /// The time of the settings: T, or the clock of who rides.
    pub clock: f64,
    /// The middle between the eyes on the ground, and its velocity.
    pub observer: Observer,
}

impl Diagram {
    /// Returns the diagram of `point` when the eyes receive light at `time`, in the frame that moves at
    /// `frame`.
    ///
    /// # Errors
    ///
    /// A time outside the domain of the core.
    pub fn new(
        settings: &Settings,
        point: &Track,
        time: f64,
        frame: ObserverVelocity,
    ) -> Result<Self, ObserverError> {
        let observer = settings.rider(time).observer();
        Ok(Self {
            frame,
            other: if settings.ride.is_on() {
                observer.velocity
            } else {
                ObserverVelocity::along_street(settings.speed())
            },
            point: PointWorldline::new(settings, point, frame),
            rays: rays(settings, point, time, frame)?,
            present: frame.event_at(observer.place, observer.time),
            time: observer.time,
            clock: time,
            observer,
        })
    }

    /// The point at T on the ground's clocks: where it is measured then.
    #[must_use]
    pub fn measured(&self) -> Event {
        self.point.at(self.time)
    }

    /// The ground's time at which the point is, when on the clocks of the other frame it is as late there as
    /// it is between the eyes at T.
    #[must_use]
    pub fn other_now(&self) -> f64 {
        // All of that frame's now has the t' of the eyes' event.
        self.point.ground_time_at(&Observer { velocity: self.other, ..self.observer })
    }

    /// The ground's times at which the point's worldline is to be drawn between these corners, later and
    /// later; none where it passes them by.
    #[must_use]
    pub fn times_within(&self, low: Event, high: Event) -> Vec<f64> {
        let reach = self.point.reach();
        let wider = |event: Event, by: f64| event.plus(Event { x: by, t: by });
        let part = self.worldline().part_within(wider(low, -reach), wider(high, reach));
        part.map_or_else(Vec::new, |part| self.point.times(part.map(|steps| self.time + steps)))
    }

    /// The point's worldline, or that of the axle that it turns about.
    #[must_use]
    pub fn worldline(&self) -> StraightLine {
        self.point.straight(self.time)
    }

    /// The worldlines of the eyes, a step for each unit of their clock; of eyes that accelerate, as they
    /// would coast on.
    #[must_use]
    pub fn eyes(&self) -> [StraightLine; 2] {
        let own = Event { x: 0.0, t: 1.0 };
        let velocity = &self.observer.velocity;
        let step = if let Some(relative) = self.frame_seen_from(velocity) {
            own.in_frame(relative)
        } else if self.frame == *velocity {
            own
        } else {
            self.frame.event_at(velocity.proper(), velocity.speed().gamma())
        };
        self.rays.map(|ray| StraightLine { through: ray.received, step })
    }

    /// The velocity of the frame that is drawn as one sees it that moves at `of`, both along the street.
    fn frame_seen_from(&self, of: &ObserverVelocity) -> Option<Velocity> {
        Some(Velocity::along_street(&self.frame)?.seen_from(Velocity::along_street(of)?))
    }

    /// Returns the present by the ground's clocks, and that by the clocks of the other frame. That of one who
    /// moves aslant of the street is cut by the plane in which the point moves, and so need not pass the
    /// eyes.
    #[must_use]
    pub fn nows(&self) -> [StraightLine; 2] {
        [(ObserverVelocity::REST, self.time), (self.other, self.other_now())].map(|(of, then)| {
            let along_x = Event { x: 1.0, t: 0.0 };
            let through = self.present;
            if let Some(relative) = self.frame_seen_from(&of) {
                return StraightLine { through, step: along_x.in_frame(relative) };
            }
            if of == self.frame {
                return StraightLine { through, step: along_x };
            }
            // T + V.(r - o) at r, above or below the place of the eyes, and V.x for each unit of x.
            let here = DVec3::from(self.observer.place);
            let abreast = DVec3 { x: here.x, ..self.point.place(then) };
            let slope = of.speed().beta() * DVec3::from(of.direction());
            let t = self.time + slope.dot(abreast - here);
            let step = self.frame.event_at([1.0, 0.0, 0.0], slope.x);
            StraightLine { through: self.frame.event_at(abreast.into(), t), step }
        })
    }

    /// The past light cones of the eyes at T; `None` in the frame of one who moves aslant of the street, in
    /// which the point changes its y and z.
    #[must_use]
    pub fn cones(&self) -> Option<[PastCone; 2]> {
        let cones = self.rays.map(|ray| PastCone { apex: ray.apex, distance: ray.aside });
        self.frame.is_along_street().then_some(cones)
    }

    /// Whether the other frame moves aslant of the street, so that its present passes the point's plane
    /// elsewhere than the eyes.
    #[must_use]
    pub fn is_aslant(&self) -> bool {
        !self.other.is_along_street()
    }
}

/// The places of the left (0) or the right (1) eye in the frame that moves at `frame`, at evenly spread times
/// of the clock in this range.
#[must_use]
pub fn worldline_of_eye(
    settings: &Settings,
    frame: &ObserverVelocity,
    eye: usize,
    range: [f64; 2],
) -> Vec<Event> {
    let event = |piece: i32| {
        let time = time_range::time_within(range, f64::from(piece) / f64::from(PastCone::PIECES));
        let aperture = settings.baseline_at(time).apertures()[eye];
        let (Aperture { x, y, z }, t) = settings.rider(time).event_of(aperture);
        frame.event_at([x, y, z], t)
    };
    (0..=PastCone::PIECES).map(event).collect()
}

/// A part of a passage: from where to where the point is seen to pass, in distances at which it does; and, of
/// slow passages, how long before and after it is seen abreast, in the same.
type PassagePart = ([f64; 2], f64);
/// Part shown at first, and the largest.
const AT_FIRST: PassagePart = ([-1.2, 0.2], 1.0);
const AT_MOST: PassagePart = ([-2.5, 2.2], 3.0);
/// The smallest distance that is made room for.
const NEAREST: f64 = 0.05;

/// Lowest and highest x and t to show of `point` at `time`, in the frame that moves at `frame`: its passage.
/// That stays as it is while T is in the middle of it, grows where T is not, and follows the eyes in the end.
///
/// # Errors
///
/// A time outside the domain of the core.
pub fn home(
    settings: &Settings,
    point: &Track,
    time: f64,
    frame: ObserverVelocity,
) -> Result<[Event; 2], ObserverError> {
    // It holds still while a point of a wheel turns.
    let point = &Track { rest: point.axle(), spin: None, ..*point };
    let [first, last] = shown_times(settings, point, AT_FIRST)?;
    let [earliest, latest] = shown_times(settings, point, AT_MOST)?;
    let shown = if settings.ride.is_on() { time } else { time.clamp(earliest.min(first), latest.max(last)) };
    let mut low = Event { x: f64::INFINITY, t: f64::INFINITY };
    let mut high = Event { x: f64::NEG_INFINITY, t: f64::NEG_INFINITY };
    for shown in [first, last, shown] {
        let diagram = Diagram::new(settings, point, shown, frame)?;
        let is_ground = frame.is_rest() || settings.ride.is_on();
        let here = if frame == diagram.other && !is_ground { diagram.present } else { diagram.measured() };
        let ends = diagram.rays.iter().flat_map(|ray| [ray.left, ray.received]);
        let aslant = diagram.is_aslant().then(|| diagram.point.at(diagram.other_now()));
        for event in ends.chain([here]).chain(aslant) {
            low = Event { x: low.x.min(event.x), t: low.t.min(event.t) };
            high = Event { x: high.x.max(event.x), t: high.t.max(event.t) };
        }
    }
    let onward = frame.event_at([0.0; 3], time - shown);
    Ok([low.plus(onward), high.plus(onward)])
}

/// Margins for labels at the left, at the right, above and below, points.
const MARGINS: [f64; 4] = [44.0, 16.0, 22.0, 26.0];

/// The chart in a rectangle (left, top, width, height, points) that holds all from `low` to `high`, as the
/// user looks at it. One scale serves both axes, so that light runs at 45 degrees.
#[must_use]
pub fn chart([left, top, width, height]: [f64; 4], [low, high]: [Event; 2], viewpoint: &Viewpoint) -> Chart {
    let [before, behind, above, below] = MARGINS;
    let free = [(width - before - behind).max(0.4 * width), (height - above - below).max(0.4 * height)];
    let fitted = (free[0] / (high.x - low.x)).min(free[1] / (high.t - low.t));
    let aside = [0.5 * (before - behind) / fitted, 0.5 * (below - above) / fitted];
    let centre = [0.5 * (low.x + high.x), 0.5 * (low.t + high.t)];
    Chart {
        middle: [left + 0.5 * width, top + 0.5 * height],
        half: [0.5 * width, 0.5 * height],
        centre: [0, 1].map(|axis| centre[axis] - aside[axis] + viewpoint.shift[axis]),
        scale: fitted * viewpoint.zoom,
    }
}

/// First and last T of a part of the passage of `point`.
fn shown_times(
    settings: &Settings,
    point: &Track,
    ([from, to], longest): PassagePart,
) -> Result<[f64; 2], ObserverError> {
    if settings.ride.is_on() {
        return Ok(settings.time_range(point));
    }
    let speed = settings.velocity(point.motion).speed;
    let source = settings.carrier(point);
    let distance = math::hypot(source.y, source.z).max(NEAREST);
    let passing = SourcePoint { y: distance, z: 0.0, ..source };
    let seen = |ratio| time_range::time_seen_at(ratio, &speed, passing, Aperture::pair(0.0));
    let abreast = seen(0.0)?.unwrap_or_default();
    let longest = longest * distance;
    let first = seen(from)?.map_or(abreast - longest, |first| first.max(abreast - longest));
    let last = seen(to)?.map_or(abreast + longest, |last| last.min(abreast + longest));
    Ok([first, last])
}

#[cfg(test)]
mod tests;
