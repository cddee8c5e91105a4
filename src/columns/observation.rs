//! An observation, and the inputs that describe one.

use relativity_core::{Baseline, Observer, ObserverVelocity, Source, Speed};

use super::names::{COLUMNS, USUAL};

/// The inputs that are given, which decide the columns of the output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GivenInputs {
    /// A head that is tilted or turned.
    pub is_turned: bool,
    /// Whether points are on wheels.
    pub on_wheel: bool,
    /// Whether the observer may move.
    pub is_riding: bool,
}

impl GivenInputs {
    /// Returns the number of columns that `--stereo` adds.
    pub(super) const fn stereo(self) -> usize {
        let has_miss = self.is_turned || self.on_wheel || self.is_riding;
        COLUMNS.len() - USUAL - !has_miss as usize
    }
}

/// An observation: one point at one observation time, before a pair of eyes.
#[derive(Debug, Clone, Copy)]
pub struct Observation {
    /// Speed of the point.
    pub speed: Speed,
    /// Place of the point at t = 0, or the wheel it is on.
    pub source: Source,
    /// The apertures: their separation d, 0 or more, and its direction.
    pub baseline: Baseline,
    /// The observer, at the event from which the clock counts.
    pub observer: Observer,
    /// Reading of the observer's clock; of one at rest T counts from there.
    pub clock: f64,
}

impl Observation {
    /// The observation at T = `time` of eyes at rest on either side of the ground's origin.
    #[must_use]
    pub const fn at_rest(speed: Speed, source: Source, baseline: Baseline, time: f64) -> Self {
        let observer = Observer { velocity: ObserverVelocity::REST, place: [0.0; 3], time };
        Self { speed, source, baseline, observer, clock: 0.0 }
    }
}
