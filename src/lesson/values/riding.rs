//! Values of whoever rides: the instruments, and what clocks along the street show by the rider's reckoning.

use relativity_core::math;

use super::here::{Here, Value};
use crate::settings::Rider;
use crate::time_range;

/// Values of a ride.
pub const VALUES: &[Value] = &[
    Value {
        name: "my_beta",
        what: "speed of the rider, c",
        work_out: |here| Some(here.rider().velocity.beta()),
    },
    Value {
        name: "my_gamma",
        what: "the rider's Lorentz factor",
        work_out: |here| Some(here.rider().velocity.speed.gamma()),
    },
    Value {
        name: "my_contraction",
        what: "1/gamma of the rider: the street as measured by the rider over its length at rest",
        work_out: |here| Some(1.0 / here.rider().velocity.speed.gamma()),
    },
    Value { name: "s", what: "the clock on the handlebar", work_out: |here| Some(here.time) },
    Value {
        name: "street_time",
        what: "what the street's clock beside the rider shows",
        work_out: |here| Some(here.rider().street_time),
    },
    Value { name: "my_x", what: "where the rider is on the street", work_out: |here| Some(here.rider().x) },
    Value {
        name: "by_wheel",
        what: "way that the rider's wheel has counted",
        work_out: |here| Some(here.settings.ride.odometers(here.time)?.by_wheel),
    },
    Value {
        name: "by_lamps",
        what: "the same way by the lamps of the street",
        work_out: |here| Some(here.settings.ride.odometers(here.time)?.by_lamps),
    },
    Value {
        name: "street_gain",
        what: "by how much its own clock goes on as the left eye sees it, over the range that is played",
        work_out: |here| {
            let [from, to] = here.settings.time_range(&here.track);
            let shows = |time| Some(here.settings.disparity(&here.track, time).ok()?.primary.proper_time);
            Some(shows(to)? - shows(from)?)
        },
    },
    Value {
        name: "street_distance",
        what: "how far ahead of the rider it is along the street, as the street measures it",
        work_out: |here| Some(here.place_on_street()? - here.rider().x),
    },
    Value {
        name: "s_beside",
        what: "when the rider is beside it, by the clock on the handlebar",
        work_out: |here| here.time_beside(),
    },
    Value {
        name: "passed_by",
        what: "how far the rider has passed it on the street when it is seen at a right angle to the way",
        work_out: |here| Some(here.rider().velocity.speed.proper() * here.aside()),
    },
    Value {
        name: "passed_by_mine",
        what: "the same way as the rider measures it",
        work_out: |here| Some(here.rider().velocity.speed.beta() * here.aside()),
    },
    Value {
        name: "reckoned",
        what: "what a clock there that is set as the street's shows now, by the rider's reckoning",
        work_out: |here| {
            let (rider, [place, _, _]) = (here.rider(), here.settings.rest_place(here.track.axle()));
            Some(rider.event().simultaneous_at(place, rider.velocity).t)
        },
    },
    Value {
        name: "from_ahead",
        what: "by how many degrees from straight ahead, along the street, the left eye sees it",
        work_out: |here| {
            let [x, y, z] = here.left()?.position;
            Some(math::atan2(math::hypot(y, z), x).to_degrees())
        },
    },
    Value {
        name: "from_ahead_at_rest",
        what: "the same for an eye at rest there, of what rests on the street",
        work_out: |here| {
            let [_, y, z] = here.settings.rest_place(here.track.axle());
            let [left, _] = here.settings.baseline_at(here.time).apertures();
            let eye = here.rider().event_on_street(left).x;
            let aside = math::hypot(y - left.y, z - left.z);
            Some(math::atan2(aside, here.place_on_street()? - eye).to_degrees())
        },
    },
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
