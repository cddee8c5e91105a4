//! The stopwatch in the window: what is noted at a press.

use crate::app::state::State;
use crate::app::state::measuring::stopwatch::{
    Elapsed, PressMoment, SeenClock, Stopwatch, StopwatchCommand, Timed,
};
use crate::app::state::points::Point;
use crate::eye::Eye;

impl State {
    /// Performs a command about the stopwatch.
    pub(super) fn perform_stopwatch(&mut self, command: StopwatchCommand) {
        let now = self.mark();
        self.scratch.stopwatch = match (command, &self.scratch.stopwatch) {
            (StopwatchCommand::Press, Stopwatch::Running(from)) => {
                Stopwatch::Stopped(Box::new([**from, now]))
            }
            (StopwatchCommand::Press, _) => Stopwatch::Running(Box::new(now)),
            (StopwatchCommand::Reset, _) | (StopwatchCommand::Toggle, Stopwatch::Hidden) => Stopwatch::Ready,
            (StopwatchCommand::Toggle, _) => Stopwatch::Hidden,
        };
    }

    /// Returns the times that the stopwatch shows, up to now while it runs.
    #[must_use]
    pub fn elapsed(&self) -> Option<Elapsed> {
        match &self.scratch.stopwatch {
            Stopwatch::Hidden | Stopwatch::Ready => None,
            Stopwatch::Running(from) => Some(Elapsed::new(&[**from, self.mark()])),
            Stopwatch::Stopped(marks) => Some(Elapsed::new(marks)),
        }
    }

    fn mark(&self) -> PressMoment {
        let point = self.document.points.selected();
        let timed =
            Timed { track: point.track, eye: self.timed_eye(), motion: self.document.settings.motion };
        let clock = self.seen_clock(point, timed.eye).map(|clock| (timed, clock));
        PressMoment { time: self.document.time, step: self.frame.step, clock }
    }

    /// The eye in whose view the stopwatch is.
    #[must_use]
    pub fn timed_eye(&self) -> Eye {
        let eye = self.document.settings.picture.eyes().first().copied().unwrap_or_default();
        if self.document.settings.is_comparing() { Eye::Left } else { Eye::BOTH[eye] }
    }

    /// The clock at `point` as `eye` sees it; none where no light is shown that it receives.
    fn seen_clock(&self, point: &Point, eye: Eye) -> Option<SeenClock> {
        let seen = self.sighting(point, eye).filter(|_| self.shows_what_is_received(eye))?;
        let time = self.slowed(point, seen.proper_time) * seen.proper_time;
        let rate = seen.doppler_factor;
        (time.is_finite() && rate.is_finite()).then_some(SeenClock { time, rate })
    }
}
