//! A stopwatch in the first view: the observer's time T between two presses, and the time in between of the selected point's clock
//! as it is seen.
//!
//! T stands still within a frame, and a press is noted in the next: each may be late by up to the step that T took in its frame, and
//! so the time between them is off by no more than the larger of both steps.

use crate::scene::Track;

/// A stopwatch.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Stopwatch {
    /// There is none.
    #[default]
    Hidden,
    /// It shows nothing yet.
    Ready,
    /// It runs since then.
    Running(Mark),
    /// It was stopped.
    Stopped([Mark; 2]),
}

/// A press.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mark {
    /// T then.
    pub time: f64,
    /// The step that T took in the frame before.
    pub step: f64,
    /// The selected point, and its clock as it was seen.
    pub clock: Option<(Track, Clock)>,
}

/// A point's clock as an eye sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock {
    /// What it shows.
    pub time: f64,
    /// How many times as fast as T it is seen to run.
    pub rate: f64,
}

/// Something to do with the stopwatch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StopwatchCommand {
    /// Shows it, starts it, stops it, or starts it again.
    Press,
    /// Has it at nothing.
    Reset,
    /// Shows it, or takes it away.
    Toggle,
}

/// What it shows: each number with its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elapsed {
    /// Of T.
    pub time: [f64; 2],
    /// Of the selected point's clock as it is seen, where that is one and the same from first to last.
    pub clock: Option<[f64; 2]>,
}

impl Elapsed {
    /// What passes between two presses.
    #[must_use]
    pub fn new([from, to]: [Mark; 2]) -> Self {
        let time = [to.time - from.time, from.step.max(to.step)];
        let clock = from.clock.zip(to.clock).filter(|((first, _), (last, _))| first == last);
        let clock = clock.map(|((_, from_clock), (_, to_clock))| {
            let late = (from_clock.rate * from.step).max(to_clock.rate * to.step);
            [to_clock.time - from_clock.time, late]
        });
        Self { time, clock }
    }

    /// How fast the clock was seen to run in the mean: its time over that of T. `None` before any T has passed.
    #[must_use]
    pub fn mean_rate(&self) -> Option<f64> {
        let [clock, _] = self.clock?;
        (self.time[0] != 0.0).then(|| clock / self.time[0])
    }
}
