//! Steps and leaps in time, and playback.

use crate::app::state::State;
use crate::app::tools::clock;
use crate::flags::MAX_TIME;
use crate::time_range::time_within;

/// A command about T.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlaybackCommand {
    /// Goes to this T.
    GoTo(f64),
    /// Goes to the first (0) or the last (1) T, or in between.
    GoToPart(f64),
    /// Makes steps of the scrubber, forwards or back.
    Step(i32),
    /// Plays T, or pauses it if it runs.
    Toggle,
}

impl State {
    /// Performs a command about T.
    pub(super) fn perform_playback(&mut self, command: PlaybackCommand) {
        match command {
            PlaybackCommand::GoTo(time) => self.document.time = clock::bounded(time),
            PlaybackCommand::GoToPart(part) => {
                self.document.time = clock::bounded(time_within(self.time_range(), part));
            }
            PlaybackCommand::Step(steps) => self.step_in_time(steps),
            PlaybackCommand::Toggle => self.toggle_playing(),
        }
    }

    fn step_in_time(&mut self, steps: i32) {
        let size = clock::step_size(self.time_range());
        // Onto the multiples of the step, so that stepping gives round times.
        let next = (self.document.time / size).round() + f64::from(steps);
        self.document.time = clock::bounded(next * size);
        self.scratch.playing = false;
    }

    /// Lets T run by a `step` of the wall clock, seconds. Where somebody pushes the pedals, the push that
    /// follows lasts as long as the frame's step; T does not run besides.
    pub(in crate::app) fn advance(&mut self, step: f64, is_pushed: bool) {
        let before = self.document.time;
        self.run_lesson(step);
        self.frame.step = (self.document.time - before).abs();
        let playback = self.document.settings.playback;
        if is_pushed {
            (self.scratch.playing, self.frame.step) = (true, step * playback.rate);
            return;
        }
        self.scratch.saddle.push = None;
        if self.scratch.playing {
            let [from, to] = self.time_range();
            // Who sits in the saddle rides on.
            let to = if self.scratch.saddle.is_taken { MAX_TIME } else { to };
            let tick = clock::advanced(self.document.time, step, playback.rate, playback.looping, [from, to]);
            self.frame.step = step * playback.rate;
            (self.document.time, self.scratch.playing) = (tick.time, tick.playing);
        }
    }

    fn toggle_playing(&mut self) {
        let [from, to] = self.time_range();
        self.scratch.playing = !self.scratch.playing;
        // Play at the end means play again.
        if self.scratch.playing && self.document.time >= to {
            self.document.time = from;
        }
    }
}
