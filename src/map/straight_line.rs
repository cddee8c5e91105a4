//! Straight lines of spacetime, and the parts of them that a chart shows.

use relativity_core::Event;

/// A straight line of spacetime: a worldline, or all that is at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StraightLine {
    /// An event on the straight line.
    pub through: Event,
    /// A step along the straight line.
    pub step: Event,
}

impl StraightLine {
    /// From how many to how many steps it lies in the rectangle from `low` to `high`; `None` if it passes
    /// that by.
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
