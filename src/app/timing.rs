//! The stopwatch in the window: what is noted at a press.

use super::eye::Eye;
use super::points::Point;
use super::state::State;
use super::stopwatch::{Clock, Elapsed, Mark, Stopwatch, StopwatchCommand};

impl State {
    /// Does what was asked about the stopwatch.
    pub(super) fn apply_to_stopwatch(&mut self, command: StopwatchCommand) {
        let now = self.mark();
        self.session.stopwatch = match (command, self.session.stopwatch) {
            (StopwatchCommand::Press, Stopwatch::Running(from)) => Stopwatch::Stopped([from, now]),
            (StopwatchCommand::Press, _) => Stopwatch::Running(now),
            (StopwatchCommand::Reset, _) | (StopwatchCommand::Toggle, Stopwatch::Hidden) => Stopwatch::Ready,
            (StopwatchCommand::Toggle, _) => Stopwatch::Hidden,
        };
    }

    /// What passed by the stopwatch, or has passed so far.
    #[must_use]
    pub fn elapsed(&self) -> Option<Elapsed> {
        match self.session.stopwatch {
            Stopwatch::Hidden | Stopwatch::Ready => None,
            Stopwatch::Running(from) => Some(Elapsed::new([from, self.mark()])),
            Stopwatch::Stopped(marks) => Some(Elapsed::new(marks)),
        }
    }

    fn mark(&self) -> Mark {
        let point = self.session.points.selected();
        let clock = self.seen_clock(point, self.timed_eye()).map(|clock| (point.track, clock));
        Mark { time: self.session.time, step: self.session.step, clock }
    }

    /// The eye in whose view the stopwatch is.
    #[must_use]
    pub fn timed_eye(&self) -> Eye {
        let eye = self.settings.picture.eyes().first().copied().unwrap_or_default();
        if self.settings.is_comparing() { Eye::Left } else { Eye::BOTH[eye] }
    }

    /// The clock at `point` as `eye` sees it; none where no light is shown that it receives.
    fn seen_clock(&self, point: &Point, eye: Eye) -> Option<Clock> {
        let seen = self.sighting(point, eye).filter(|_| self.shows_what_is_received(eye))?;
        let time = self.slowed(point, seen.own_time) * seen.own_time;
        let rate = seen.doppler_factor;
        (time.is_finite() && rate.is_finite()).then_some(Clock { time, rate })
    }
}
