//! Sampling of curves over T: even steps, ladders towards the times around which they bend, and every turn of
//! a wheel.

use super::Bends;
use crate::plot::{CurveSampling, even_times};

/// Number of intervals at first.
const FIRST_INTERVALS: u32 = 64;
/// Halvings of the distance to each point of interest: features narrower than 2^-40 of the range show
/// as steps.
const RUNGS: i32 = 40;
/// Greatest number of rungs of all ladders together, on each side.
const MOST_RUNGS: f64 = 2000.0;

impl Bends {
    /// Returns the way that a curve with these bends is sampled over a range of T.
    #[must_use]
    pub fn sampling(&self, [from, to]: [f64; 2]) -> CurveSampling {
        let inside = |time: &f64| (from..=to).contains(time);
        let mut times: Vec<f64> = even_times([from, to], FIRST_INTERVALS)
            .chain(self.ladders(to - from))
            .chain(self.turns.iter().copied())
            .filter(inside)
            .collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        CurveSampling { times, oscillates: !self.turns.is_empty(), dense_from: self.blurred_until }
    }

    /// A ladder towards each bend but turns, from both sides, in a range so wide. Very many are short, and
    /// reach to each other only.
    fn ladders(&self, width: f64) -> impl Iterator<Item = f64> {
        let count = self.passage.len().max(1) as f64;
        let rungs = RUNGS.min((MOST_RUNGS / count) as i32);
        let width = if rungs < RUNGS { width / count } else { width };
        self.passage.iter().flat_map(move |anchor| {
            let rungs = (1..=rungs).map(move |k| width * 0.5f64.powi(k));
            [*anchor].into_iter().chain(rungs.flat_map(move |rung| [anchor - rung, anchor + rung]))
        })
    }
}
