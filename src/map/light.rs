//! Light that leaves the selected point: the events at which it left for each eye, the ray from there, and
//! its wave fronts.

use glam::DVec3;
use relativity_core::{Aperture, Event, Model, ObserverError, ObserverVelocity, math};

use super::worldline::PointWorldline;
use crate::scene::Track;
use crate::settings::Settings;

/// Light that reaches an eye at T.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReceivedRay {
    /// Event where the light left the point.
    pub left: Event,
    /// y and z of the point there.
    pub across: [f64; 2],
    /// Event where the eye receives the ray.
    pub received: Event,
    /// The event in whose past light cone it left: of reception, or where one cone serves both eyes, that
    /// between them.
    pub apex: Event,
    /// Distance from the point there to the line along x through that event.
    pub aside: f64,
    /// y and z of the eye on the ground.
    pub eye: [f64; 2],
    /// When the ray left, on the ground's clocks.
    pub happened: f64,
    /// Proper time of the point at that event.
    pub proper_time: f64,
}

/// The rays to the left and to the right eye that arrive at `time`, as the frame that moves at `frame`
/// has them, by the binocular model of what the views show.
///
/// # Errors
///
/// A time outside the domain of the core.
pub fn rays(
    settings: &Settings,
    point: &Track,
    time: f64,
    frame: ObserverVelocity,
) -> Result<[ReceivedRay; 2], ObserverError> {
    let worldline = PointWorldline::new(settings, point, frame);
    let both = settings.disparity(point, time)?;
    let ([left, right], rider) = (settings.baseline_at(time).apertures(), settings.rider(time));
    let one_cone = settings.model() == Model::OneCone;
    let event = |eye| {
        let (Aperture { x, y, z }, t) = rider.event_of(eye);
        (DVec3::new(x, y, z), t)
    };
    Ok([(both.primary, left), (both.secondary, right)].map(|(seen, eye)| {
        // Where and when it rests is known better than by its place on the ground.
        let place = worldline.place(seen.retarded_time);
        let left = if worldline.rests {
            Event { x: place.x, t: seen.proper_time }
        } else {
            worldline.at(seen.retarded_time)
        };
        let (eye, received) = event(eye);
        let (apex, apex_time) = if one_cone { event(Aperture::default()) } else { (eye, received) };
        ReceivedRay {
            left,
            across: [place.y, place.z],
            received: frame.event_at(eye.into(), received),
            apex: frame.event_at(apex.into(), apex_time),
            aside: math::hypot(place.y - apex.y, place.z - apex.z),
            eye: [eye.y, eye.z],
            happened: seen.retarded_time,
            proper_time: seen.proper_time,
        }
    }))
}

/// Light that left the point at one event, now: a sphere about the place of that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Front {
    /// Place along x and time at which the light left.
    pub left: Event,
    /// y and z of the point there.
    pub across: [f64; 2],
    /// When that was on the ground's clocks.
    pub happened: f64,
    /// Proper time of the point at that event.
    pub proper_time: f64,
    /// Radius of the wave front.
    pub radius: f64,
}

impl Front {
    /// Radius of the circle in which it meets a plane that passes the point at this `distance`; `None` until
    /// it does.
    ///
    /// In the plane of the eyes this circle reaches an eye exactly when the eye receives the light.
    #[must_use]
    pub fn radius_in_plane(&self, distance: f64) -> Option<f64> {
        let square = (self.radius - distance) * (self.radius + distance);
        (self.radius > 0.0 && square >= 0.0).then(|| square.sqrt())
    }
}

impl ReceivedRay {
    /// The front that the ray belongs to, as it reaches the eye.
    #[must_use]
    pub fn front(&self) -> Front {
        let Self { left, across, apex, happened, proper_time, .. } = *self;
        Front { left, across, happened, proper_time, radius: apex.t - left.t }
    }
}

/// Greatest number of wave fronts.
const MOST_FRONTS: i32 = 10;

/// The fronts of light that left the point at the multiples of `period` of the time of the worldline's frame,
/// as they are at its time `now`; the last ones first.
pub fn fronts(worldline: &PointWorldline, now: f64, period: f64) -> impl Iterator<Item = Front> {
    let last = (now / period).floor();
    let number = if last.is_finite() { MOST_FRONTS } else { 0 };
    (0..number).map(move |back| {
        let t = (last - f64::from(back)) * period;
        let happened = worldline.ground_time(t);
        let left = Event { t, ..worldline.at(happened) };
        let place = worldline.place(happened);
        Front {
            left,
            across: [place.y, place.z],
            happened,
            proper_time: worldline.proper_time(happened),
            radius: now - t,
        }
    })
}
