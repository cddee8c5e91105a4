//! Events along x, and how they lie in another frame.

use relativity_render::Velocity;

/// An event: its place along x and its time, from the point between the eyes at T = 0. Scene units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// Place along x.
    pub x: f64,
    /// When, by the clocks of the frame.
    pub t: f64,
}

impl Event {
    /// Returns the event in the frame that moves at `frame`, its origin being the same event. A step from one event to another
    /// is one, too.
    ///
    /// t - x and t + x are only scaled by the head-on Doppler factor, so neither spoils the other at great speeds.
    #[must_use]
    pub fn in_frame(self, frame: Velocity) -> Self {
        let factor = frame.speed.head_on_doppler_factor();
        if factor == 1.0 {
            return self;
        }
        let factor = if frame.is_backward { 1.0 / factor } else { factor };
        let (outgoing, incoming) = (factor * (self.t - self.x), (self.t + self.x) / factor);
        Self { x: 0.5 * (incoming - outgoing), t: 0.5 * (incoming + outgoing) }
    }

    /// Returns the event a `step` away.
    #[must_use]
    pub fn plus(self, step: Self) -> Self {
        Self { x: self.x + step.x, t: self.t + step.t }
    }
}

/// A straight line of spacetime: a worldline, or all that is at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StraightLine {
    /// An event on the straight line.
    pub through: Event,
    /// A step along the straight line.
    pub step: Event,
}

impl StraightLine {
    /// From how many to how many steps it lies in the rectangle from `low` to `high`; `None` if it passes that by.
    #[must_use]
    pub fn part_within(&self, low: Event, high: Event) -> Option<[f64; 2]> {
        let sides =
            [(self.through.x, self.step.x, low.x, high.x), (self.through.t, self.step.t, low.t, high.t)];
        let mut part = [f64::NEG_INFINITY, f64::INFINITY];
        for (from, step, low, high) in sides {
            if step == 0.0 {
                if !(low..=high).contains(&from) {
                    return None;
                }
                continue;
            }
            let [a, b] = [(low - from) / step, (high - from) / step];
            part = [part[0].max(a.min(b)), part[1].min(a.max(b))];
        }
        (part[0] < part[1]).then_some(part)
    }

    /// The two ends of that part.
    #[must_use]
    pub fn within(&self, low: Event, high: Event) -> Option<[Event; 2]> {
        self.part_within(low, high).map(|part| part.map(|steps| self.at(steps)))
    }

    /// Returns the event this number of `steps` from [`Self::through`].
    #[must_use]
    pub fn at(&self, steps: f64) -> Event {
        self.through.plus(Event { x: steps * self.step.x, t: steps * self.step.t })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use relativity_core::Speed;

    #[test]
    fn another_frame_agrees_with_the_textbook() {
        for beta in [-0.9, -1e-9, 0.3, 0.999] {
            let frame = Velocity::from_beta(beta).expect("in range");
            let gamma = frame.speed.gamma();
            for event in [Event { x: 3.0, t: -2.0 }, Event { x: 0.0, t: 5.0 }, Event { x: 1e3, t: 1e3 }] {
                let there = event.in_frame(frame);
                let scale = 1e-14 * gamma * (event.x.abs() + event.t.abs());
                assert!((there.x - gamma * (event.x - beta * event.t)).abs() < scale, "{beta}: {there:?}");
                assert!((there.t - gamma * (event.t - beta * event.x)).abs() < scale, "{beta}: {there:?}");
                let back = there.in_frame(Velocity { is_backward: !frame.is_backward, ..frame });
                assert!((back.x - event.x).abs() < scale && (back.t - event.t).abs() < scale);
            }
        }
    }

    #[test]
    fn the_ground_is_the_ground_and_the_greatest_speed_is_finite() {
        let event = Event { x: 0.1, t: 0.7 };
        assert_eq!(event.in_frame(Velocity::REST), event);
        let frame = Velocity::forward(Speed::from_gamma(1e30).expect("in range"));
        let there = event.in_frame(frame);
        assert!(there.x.is_finite() && there.t.is_finite());
    }
}
