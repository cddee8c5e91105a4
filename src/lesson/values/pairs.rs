//! Values of two eyes.

use relativity_core::math;

use super::here::{Here, Value};

/// Values of what two eyes see.
pub const VALUES: &[Value] = &[
    Value {
        name: "t_left",
        what: "when what the left eye receives happened, by the ground's clocks",
        work_out: |here| Some(here.disparity()?.primary.retarded_time),
    },
    Value {
        name: "t_right",
        what: "when what the right eye receives happened, by the ground's clocks",
        work_out: |here| Some(here.disparity()?.secondary.retarded_time),
    },
    Value {
        name: "t_before",
        what: "by how much what the right eye receives happened earlier",
        work_out: |here| {
            let both = here.disparity()?;
            Some(both.primary.retarded_time - both.secondary.retarded_time)
        },
    },
    Value {
        name: "moved",
        what: "how far it moved on the ground from one of these events to the other",
        work_out: |here| {
            let both = here.disparity()?;
            let speed = here.settings.velocity(here.track.motion).speed;
            Some(speed.beta() * (both.secondary.retarded_time - both.primary.retarded_time).abs())
        },
    },
    Value {
        name: "T_right",
        what: "when the right eye receives what the left eye receives at T",
        work_out: |here| {
            let (seen, [left, right]) = (here.left()?, here.settings.baseline_at(here.time).apertures());
            let from_right = [left.x - right.x, left.y - right.y, left.z - right.z];
            let [x, y, z] = [0, 1, 2].map(|axis| seen.position[axis] + from_right[axis]);
            Some(seen.retarded_time + math::hypot(math::hypot(x, y), z))
        },
    },
    Value {
        name: "tau_now",
        what: "what its own clock, or that of the hub it turns about, shows when the ground's clocks show T",
        work_out: |here| {
            let speed = here.settings.velocity(here.track.motion).speed;
            Some(here.settings.carrier(&here.track).worldline(&speed).proper_time(here.time))
        },
    },
    Value { name: "dphi", what: "disparity across, radians", work_out: |here| Some(here.disparity()?.dphi) },
    Value {
        name: "dphi_size",
        what: "its size, without its sign",
        work_out: |here| Some(here.disparity()?.dphi.abs()),
    },
    Value {
        name: "dtheta",
        what: "disparity in elevation, radians",
        work_out: |here| Some(here.disparity()?.dtheta),
    },
    Value {
        name: "dphi_published",
        what: "disparity across by the published model, radians",
        work_out: |here| Some(here.published()?.dphi),
    },
    Value {
        name: "gain",
        what: "how many times as far apart as they are the eyes would have to be for a point at rest",
        work_out: |here| Some(here.stereo()?.gain),
    },
    Value {
        name: "stereo_x",
        what: "where two eyes place it: along the motion",
        work_out: |here| Some(here.stereo()?.position[0]),
    },
    Value {
        name: "stereo_y",
        what: "how far ahead of them two eyes place it",
        work_out: |here| Some(here.stereo()?.position[1]),
    },
    Value {
        name: "stereo_z",
        what: "how high two eyes place it",
        work_out: |here| Some(here.stereo()?.position[2]),
    },
    Value {
        name: "stereo_distance",
        what: "how far away two eyes place it",
        work_out: |here| Some(here.stereo()?.distance()),
    },
    Value {
        name: "distance",
        what: "how far away the left eye sees it",
        work_out: |here| Some(here.left()?.distance),
    },
    Value {
        name: "y",
        what: "how far ahead of the eyes it passes",
        work_out: |here| Some(here.settings.carrier(&here.track).y),
    },
    Value {
        name: "z",
        what: "how high above the eyes it passes",
        work_out: |here| Some(here.settings.carrier(&here.track).z),
    },
    Value { name: "d", what: "how far apart the eyes are", work_out: |here| Some(here.settings.motion.d) },
    Value {
        name: "T0",
        what: "when it is seen abreast: both eyes then see it at one distance",
        work_out: |here| here.settings.equidistance_time(&here.track),
    },
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
