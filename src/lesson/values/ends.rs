//! Values of a body with two ends, such as a rod: where two eyes place these.

use relativity_core::math;

use super::here::{Here, Value, value};

/// Values of a body's ends.
pub const VALUES: &[Value] = &[
    value("stereo_length", "length at which two eyes place a body with two ends, such as a rod", |here| {
        let [dx, dy, dz] = here.stereo_span()?;
        Some(math::hypot(math::hypot(dx, dy), dz))
    }),
    value("stereo_turn", "its turn from the motion as two eyes place it, degrees", |here| {
        let [dx, dy, _] = here.stereo_span()?;
        Some(math::atan2(dy.abs(), dx.abs()).to_degrees())
    }),
    value(
        "seen_length",
        "how many times as long along the motion as at rest, between where the left eye sees its ends",
        |here| {
            let [from, to] = here.ends()?;
            let seen = |end| {
                let end = here.scene.track_at(end, here.body?)?;
                Some(here.settings.disparity(&end, here.time).ok()?.primary.position[0])
            };
            Some((seen(to)? - seen(from)?) / (to[0] - from[0]))
        },
    ),
    value("rest_length", "how long it is at rest, from end to end", |here| {
        let [from, to] = here.ends()?;
        let [dx, dy, dz] = [0, 1, 2].map(|axis| to[axis] - from[axis]);
        Some(math::hypot(math::hypot(dx, dy), dz))
    }),
];

impl Here<'_> {
    /// Returns the span from where two eyes place one end to where they place the other.
    fn stereo_span(&self) -> Option<[f64; 3]> {
        let place = |end| {
            let end = self.scene.track_at(end, self.body?)?;
            Some(self.settings.stereo(&end, self.time).ok()?.position)
        };
        let [from, to] = self.ends()?.map(place);
        let (from, to) = (from?, to?);
        Some([0, 1, 2].map(|axis| to[axis] - from[axis]))
    }

    /// The middles of both ends, at rest.
    fn ends(&self) -> Option<[[f64; 3]; 2]> {
        self.scene.bodies.get(self.body?)?.shape.ends()
    }
}
