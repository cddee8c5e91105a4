//! Values of whoever rides: the instruments, and what clocks along the street show by the rider's reckoning.

use relativity_core::math;

use super::here::{Here, Value, value};
use crate::settings::Rider;
use crate::time_range;

/// Values of a ride.
pub const VALUES: &[Value] = &[
    value("my_beta", "speed of the rider, c", |here| Some(here.rider().velocity.beta())),
    value("my_gamma", "the rider's Lorentz factor", |here| Some(here.rider().velocity.speed.gamma())),
    value(
        "my_contraction",
        "1/gamma of the rider: the street as measured by the rider over its length at rest",
        |here| Some(1.0 / here.rider().velocity.speed.gamma()),
    ),
    value("s", "the clock on the handlebar", |here| Some(here.time)),
    value("street_time", "what the street's clock beside the rider shows", |here| {
        Some(here.rider().street_time)
    }),
    value("my_x", "where the rider is on the street", |here| Some(here.rider().x)),
    value("by_wheel", "way that the rider's wheel has counted", |here| {
        Some(here.settings.ride.odometers(here.time)?.by_wheel)
    }),
    value("by_lamps", "the same way by the lamps of the street", |here| {
        Some(here.settings.ride.odometers(here.time)?.by_lamps)
    }),
    value(
        "street_gain",
        "by how much its own clock goes on as the left eye sees it, over the range that is played",
        |here| {
            let [from, to] = here.settings.time_range(&here.track);
            let shows = |time| Some(here.settings.disparity(&here.track, time).ok()?.primary.proper_time);
            Some(shows(to)? - shows(from)?)
        },
    ),
    value(
        "street_distance",
        "how far ahead of the rider it is along the street, as the street measures it",
        |here| Some(here.place_on_street()? - here.rider().x),
    ),
    value("s_beside", "when the rider is beside it, by the clock on the handlebar", |here| {
        here.time_beside()
    }),
    value(
        "passed_by",
        "how far the rider has passed it on the street when it is seen at a right angle to the way",
        |here| Some(here.rider().velocity.speed.proper() * here.aside()),
    ),
    value("passed_by_mine", "the same way as the rider measures it", |here| {
        Some(here.rider().velocity.speed.beta() * here.aside())
    }),
    value(
        "reckoned",
        "what a clock there that is set as the street's shows now, by the rider's reckoning",
        |here| {
            let (rider, [place, _, _]) = (here.rider(), here.settings.rest_place(here.track.axle()));
            Some(rider.event().simultaneous_at(place, rider.velocity).t)
        },
    ),
    value(
        "from_ahead",
        "by how many degrees from straight ahead, along the street, the left eye sees it",
        |here| {
            let [x, y, z] = here.left()?.position;
            Some(math::atan2(math::hypot(y, z), x).to_degrees())
        },
    ),
    value("from_ahead_at_rest", "the same for an eye at rest there, of what rests on the street", |here| {
        let [_, y, z] = here.settings.rest_place(here.track.axle());
        let [left, _] = here.settings.baseline_at(here.time).apertures();
        let eye = here.rider().event_on_street(left).x;
        let aside = math::hypot(y - left.y, z - left.z);
        Some(math::atan2(aside, here.place_on_street()? - eye).to_degrees())
    }),
];

impl Here<'_> {
    fn rider(&self) -> Rider {
        self.settings.rider(self.time)
    }

    /// Place x of what rests on the street; `None` of what moves.
    fn place_on_street(&self) -> Option<f64> {
        let [x, _, _] = self.settings.rest_place(self.track.axle());
        (self.settings.velocity(self.track.motion).beta() == 0.0).then_some(x)
    }

    /// Distance at which the rider passes the point.
    fn aside(&self) -> f64 {
        let [_, y, z] = self.settings.rest_place(self.track.axle());
        math::hypot(y, z)
    }

    /// When the rider is beside it in the range that is played, if the way leads there.
    fn time_beside(&self) -> Option<f64> {
        let place = self.place_on_street()?;
        let is_before = |time: f64| self.settings.rider(time).x < place;
        let range = self.settings.time_range(&self.track);
        let [before, after] = range.map(is_before);
        (before && !after).then(|| time_range::first_time(range, |time| !is_before(time)))
    }
}
