//! Steps and leaps in time, and playback.

use crate::app::clock;
use crate::app::state::State;
use crate::time_range::time_within;

impl State {
    pub(super) fn step_in_time(&mut self, steps: i32) {
        let size = clock::step_size(self.time_range());
        // Onto the multiples of the step, so that stepping gives round times.
        let next = (self.document.time / size).round() + f64::from(steps);
        self.document.time = clock::bounded(next * size);
        self.scratch.playing = false;
    }

    pub(super) fn go_within_range(&mut self, fraction: f64) {
        self.document.time = clock::bounded(time_within(self.time_range(), fraction));
    }

    pub(super) fn toggle_playing(&mut self) {
        let [from, to] = self.time_range();
        self.scratch.playing = !self.scratch.playing;
        // Play at the end means play again.
        if self.scratch.playing && self.document.time >= to {
            self.document.time = from;
        }
    }
}
