//! Where the descent to the minimum starts: the best of several starts, and of a wheel of several numbers of turns.

use crate::fit::descent::{Descent, ROUNDING, START_PATIENCE, descents, ways};
use crate::fit::problem::{Free, Problem};
use crate::fit::{start, wheel_start};

/// Of a wheel: ways that are followed with other numbers of turns, how many turns more and less, and how often from the best.
const TURNED: usize = 2;
const TURNS: i32 = 8;
const ROUNDS: u32 = 4;

/// Where the best of several starts leads. All get a few steps against some of the data; those that promise
/// most, and are on different ways, are followed.
pub(super) fn best_start(problem: &Problem) -> Option<Free> {
    if problem.rolling.is_none() {
        return ways(problem).first().map(|best| best.free);
    }
    let hubs = Problem { rolling: None, ..problem.clone() };
    let from_hub = wheel_start::best_start(problem, &hubs, &ways(&hubs));
    let coarse = start::thinned(problem, start::GRID_SAMPLES);
    let turned = ways(problem).into_iter().take(TURNED).map(|way| otherwise_turned(problem, &coarse, way));
    let found = from_hub.into_iter().chain(turned);
    found.min_by(|a, b| a.cost.total_cmp(&b.cost)).map(|best| best.free)
}

/// The lowest of the minima that show the same passage with a wheel that has turned some times more or less before: each is
/// a way of its own, on which no descent leads to the next. `way` itself of what does not turn.
fn otherwise_turned(problem: &Problem, coarse: &Problem, mut way: Descent) -> Descent {
    for _ in 0..ROUNDS {
        let others = (-TURNS..=TURNS).filter(|&turns| turns != 0);
        let others: Vec<Free> =
            others.filter_map(|turns| problem.turned(&way.free, f64::from(turns))).collect();
        let glances = descents(coarse, others, START_PATIENCE);
        let promising = glances.iter().take(TURNED).map(|descent| descent.free).collect();
        match descents(problem, promising, START_PATIENCE).first() {
            Some(lower) if lower.cost < (1.0 - ROUNDING) * way.cost => way = *lower,
            _ => break,
        }
    }
    way
}
