//! A stopwatch in the first view: the observation time T between two presses, and the time in between of the
//! selected point's clock as it is seen.
//!
//! T stands still within a frame, and a press is noted in the next: each may be late by up to the step that T
//! took in its frame, and so the time between them is off by no more than the larger of both steps.

use crate::eye::Eye;
use crate::scene::Track;
use crate::settings::MotionSettings;

/// The tooltip of the stopwatch.
pub const TIP: &str = "Measures T between two presses, and the time that the selected point's clock is seen to show meanwhile. \
    The error is the step of T from one frame to the next.";

/// The state of the stopwatch.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Stopwatch {
    /// No stopwatch is shown.
    #[default]
    Hidden,
    /// Shown, and not started yet.
    Ready,
    /// Running since this press.
    Running(Box<PressMoment>),
    /// Stopped between two presses.
    Stopped(Box<[PressMoment; 2]>),
}

/// The moment of a press.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressMoment {
    /// T at the press.
    pub time: f64,
    /// The step that T took in the frame before.
    pub step: f64,
    /// The selected point's clock as it was seen, and whose that was.
    pub clock: Option<(Timed, SeenClock)>,
}

/// A clock that is timed: another one where any of this differs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Timed {
    /// The point that the clock is at.
    pub track: Track,
    /// The eye that sees the clock.
    pub eye: Eye,
    /// The motion of the scene, and the eyes' places.
    pub motion: MotionSettings,
}

/// A point's clock as an eye sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeenClock {
    /// Time that the clock shows.
    pub time: f64,
    /// Rate at which it is seen to run, relative to T: the Doppler factor.
    pub rate: f64,
}

/// A command about the stopwatch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StopwatchCommand {
    /// Shows, starts, stops or restarts the stopwatch.
    Press,
    /// Sets the stopwatch back to zero.
    Reset,
    /// Shows or hides the stopwatch.
    Toggle,
}

/// Times between two presses, each with its largest error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elapsed {
    /// The time T of the observer.
    pub time: [f64; 2],
    /// Time by the selected point's clock as it is seen; `None` if that has become another one, or is not
    /// seen. Its error is to first order in the step.
    pub clock: Option<[f64; 2]>,
}

impl Elapsed {
    /// Returns the times between two presses, from the earlier T to the later one: in between, T may have
    /// gone back.
    #[must_use]
    pub fn new([first, second]: &[PressMoment; 2]) -> Self {
        let [from, to] = if second.time < first.time { [second, first] } else { [first, second] };
        let time = [to.time - from.time, from.step.max(to.step)];
        let clock = from.clock.zip(to.clock).filter(|((first, _), (last, _))| first == last);
        let clock = clock.map(|((_, from_clock), (_, to_clock))| {
            let late = (from_clock.rate * from.step).max(to_clock.rate * to.step);
            [to_clock.time - from_clock.time, late]
        });
        Self { time, clock }
    }

    /// Mean rate at which the clock was seen to run: its time over that of T. `None` before any T has passed.
    #[must_use]
    pub fn mean_rate(&self) -> Option<f64> {
        let [clock, _] = self.clock?;
        (self.time[0] != 0.0).then(|| clock / self.time[0])
    }
}
