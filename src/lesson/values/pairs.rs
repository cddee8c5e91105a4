//! Values of two eyes.

use relativity_core::math;

use super::here::{Here, Value, value};

/// Values of what two eyes see.
pub const VALUES: &[Value] = &[
    value("t_left", "when what the left eye receives happened, by the ground's clocks", |here| {
        Some(here.disparity()?.primary.retarded_time)
    }),
    value("t_right", "when what the right eye receives happened, by the ground's clocks", |here| {
        Some(here.disparity()?.secondary.retarded_time)
    }),
    value("t_before", "by how much what the right eye receives happened earlier", |here| {
        let both = here.disparity()?;
        Some(both.primary.retarded_time - both.secondary.retarded_time)
    }),
    value("moved", "how far it moved on the ground from one of these events to the other", |here| {
        let both = here.disparity()?;
        let speed = here.settings.velocity(here.track.motion).speed;
        Some(speed.beta() * (both.secondary.retarded_time - both.primary.retarded_time).abs())
    }),
    value("T_right", "when the right eye receives what the left eye receives at T", |here| {
        let (seen, [left, right]) = (here.left()?, here.settings.baseline_at(here.time).apertures());
        let from_right = [left.x - right.x, left.y - right.y, left.z - right.z];
        let [x, y, z] = [0, 1, 2].map(|axis| seen.position[axis] + from_right[axis]);
        Some(seen.retarded_time + math::hypot(math::hypot(x, y), z))
    }),
    value(
        "tau_now",
        "what its own clock, or that of the hub it turns about, shows when the ground's clocks show T",
        |here| {
            let speed = here.settings.velocity(here.track.motion).speed;
            Some(here.settings.carrier(&here.track).worldline(&speed).proper_time(here.time))
        },
    ),
    value("dphi", "disparity across, radians", |here| Some(here.disparity()?.dphi)),
    value("dphi_size", "its size, without its sign", |here| Some(here.disparity()?.dphi.abs())),
    value("dtheta", "disparity in elevation, radians", |here| Some(here.disparity()?.dtheta)),
    value("dphi_published", "disparity across by the published model, radians", |here| {
        Some(here.published()?.dphi)
    }),
    value(
        "gain",
        "how many times as far apart as they are the eyes would have to be for a point at rest",
        |here| Some(here.stereo()?.gain),
    ),
    value("stereo_x", "where two eyes place it: along the motion", |here| Some(here.stereo()?.position[0])),
    value("stereo_y", "how far ahead of them two eyes place it", |here| Some(here.stereo()?.position[1])),
    value("stereo_z", "how high two eyes place it", |here| Some(here.stereo()?.position[2])),
    value("stereo_distance", "how far away two eyes place it", |here| Some(here.stereo()?.distance())),
    value("distance", "how far away the left eye sees it", |here| Some(here.left()?.distance)),
    value("y", "how far ahead of the eyes it passes", |here| Some(here.settings.carrier(&here.track).y)),
    value("z", "how high above the eyes it passes", |here| Some(here.settings.carrier(&here.track).z)),
    value("d", "how far apart the eyes are", |here| Some(here.settings.motion.d)),
    value("T0", "when it is seen abreast: both eyes then see it at one distance", |here| {
        here.settings.equidistance_time(&here.track)
    }),
];

impl Here<'_> {
    fn stereo(&self) -> Option<relativity_core::Stereo> {
        self.settings.stereo(&self.track, self.time).ok()
    }

    fn published(&self) -> Option<relativity_core::Disparity> {
        let published = relativity_core::Model::Published(relativity_core::PublishedVariant::AppendixA);
        let (point, pair) = (self.settings.source(&self.track), self.settings.pair());
        published.disparity(&self.settings.velocity(self.track.motion).speed, point, pair, self.time).ok()
    }
}
