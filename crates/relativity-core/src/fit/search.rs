//! The start of the descent to the minimum: the best of several starts, and for a wheel the best of several
//! numbers of turns.

use crate::fit::descent::{Descent, ROUNDING, START_PATIENCE, descent, descents, ways};
use crate::fit::problem::{Free, Problem};
use crate::fit::{start, wheel_start};
use crate::threads::prelude::*;

/// Number of ways of a wheel that are followed with other numbers of turns, the turns more and less, and the
/// repetitions from the best.
const TURNED: usize = 2;
const TURNS: i32 = 8;
const ROUNDS: u32 = 4;
/// For a wheel on the other side of z = 0: the parts of a turn that are tried, and how many turns more and
/// less.
const PARTS: i32 = 8;
const MIRRORED_TURNS: i32 = 2;

/// The starts of the descents that end a search.
pub(super) struct Starts {
    /// The lowest of all that were tried.
    pub best: Free,
    /// The lowest beyond z = 0, of a wheel in Delta-phi alone, whose hub's curve is the same on both sides.
    pub other_side: Option<Free>,
}

/// Searches for where to start. All starts get a few steps against some of the data; those that promise most,
/// and are on different ways, are followed.
pub(super) fn best_starts(problem: &Problem) -> Option<Starts> {
    if problem.rolling.is_none() {
        return ways(problem).first().map(|best| Starts { best: best.free, other_side: None });
    }
    let hubs = Problem { rolling: None, ..problem.clone() };
    let from_hub = wheel_start::best_start(problem, &hubs, &ways(&hubs));
    let coarse = start::thinned(problem, start::GRID_SAMPLES);
    let turned = ways(problem).into_iter().take(TURNED).map(|way| otherwise_turned(problem, &coarse, way));
    let mut best = lowest(from_hub.into_iter().chain(turned))?;
    let mut other_side = hubs.is_even_in_z().then(|| mirrored(problem, &coarse, &best)).flatten();
    if let Some(other) = other_side.as_mut().filter(|other| other.cost < best.cost) {
        std::mem::swap(&mut best, other);
    }
    Some(Starts { best: best.free, other_side: other_side.map(|other| other.free) })
}

fn lowest(descents: impl Iterator<Item = Descent>) -> Option<Descent> {
    descents.min_by(|a, b| a.cost.total_cmp(&b.cost))
}

/// The lowest minimum on the other side of z = 0. The hub's own curve is the same on both sides, and that of
/// its wheel has minima at other turns there, between which no descent leads: the wheel is tried in parts of
/// a turn.
fn mirrored(problem: &Problem, coarse: &Problem, way: &Descent) -> Option<Descent> {
    let samples = start::thinned(problem, wheel_start::SAMPLES);
    let mut other = way.free;
    other[2] = -other[2];
    let turned = |part: i32| problem.turned(&other, f64::from(part) / f64::from(PARTS));
    let starts: Vec<Free> = (-PARTS * MIRRORED_TURNS..=PARTS * MIRRORED_TURNS).filter_map(turned).collect();
    let glances = starts.into_par_iter().map(|start| descent(&samples, start, START_PATIENCE)).collect();
    let promising =
        wheel_start::lowest(glances, wheel_start::FOLLOWED).iter().map(|descent| descent.free).collect();
    let lowest = *descents(problem, promising, START_PATIENCE).first()?;
    Some(otherwise_turned(problem, coarse, lowest))
}

/// The lowest of the minima that show the same passage with a wheel that has turned some times more or less
/// before: each is a way of its own, on which no descent leads to the next. `way` itself of what does not
/// turn.
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
