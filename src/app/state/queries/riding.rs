//! The rider, the words about a ride, and the range of one that is under way.

use relativity_core::math;

use crate::app::state::State;
use crate::flags::MAX_TIME;
use crate::settings::{Preset, Rider};

/// The shortest range of a ride that is under way, and the number of steps in which it doubles.
const SHORTEST_RANGE: f64 = 8.0;
const STEPS_OF_DOUBLING: f64 = 2.0;

impl State {
    /// Returns the rider at the present time.
    #[must_use]
    pub fn rider(&self) -> Rider {
        self.document.settings.rider(self.document.time)
    }

    /// Returns the preset that is shown, as long as its words are about that: not where own data are, and not
    /// of a passage once somebody rides.
    #[must_use]
    pub fn told_preset(&self) -> Option<&'static Preset> {
        let is_told = |preset: &&Preset| {
            let rides = [&preset.settings, &*self.document.settings].map(|settings| settings.ride.is_on());
            rides[0] == rides[1] && self.session.data.is_none()
        };
        self.document.preset.filter(is_told)
    }

    /// The range of the ride that is under way, which grows with it in steps: a plot over it is not stretched
    /// in every frame.
    #[must_use]
    pub(in crate::app) fn range_of_ride(&self) -> Option<[f64; 2]> {
        let settings = &self.document.settings;
        let is_set = settings.playback.range.0.is_some();
        if !settings.ride.is_on() || !self.scratch.saddle.is_taken || is_set {
            return None;
        }
        let end = settings.ride.duration().max(self.document.time).max(SHORTEST_RANGE);
        let steps = (STEPS_OF_DOUBLING * math::log2(end / SHORTEST_RANGE)).ceil();
        let rounded = SHORTEST_RANGE * math::exp2(steps / STEPS_OF_DOUBLING);
        Some([0.0, rounded.min(MAX_TIME)])
    }
}
