//! The start of a fit to a point on a wheel: speed and passage of the hub, closely enough to know how far the
//! wheel has turned.
//!
//! The hub's own curve is smooth, so that it is found as a point that does not turn; the wheel's wiggle about
//! it is what that leaves over, and by which it may be off. The wheel may turn through tens of radians while
//! it passes: each of many speeds about that of the smooth curve (with the hub that fits best at that speed)
//! and times of passage is tried, in steps of a small part of a turn.

use std::f64::consts::{FRAC_PI_4, TAU};

use crate::fit::descent::{Descent, descent, descent_at_speed};
use crate::fit::problem::{Free, PreparedSample, Problem};
use crate::fit::start;
use crate::fit::trial::Trial;
use crate::threads::prelude::*;

/// Largest turn of the wheel between one start and the next, radians.
const STEP: f64 = FRAC_PI_4;
/// Greatest number of such steps in the time of passage, either way.
const MOST_TURNS: f64 = 10.0;
/// Greatest number of the largest steps by which the range of speeds is found.
const WIDE: usize = 20;
/// Greatest number of steps in ln(rapidity) either way, and the largest step.
const SPEEDS: usize = 120;
const LARGEST_STEP: f64 = 0.1;
/// ln(rapidity) of the fastest start: the motion of the wheel is then too slow to see.
const FASTEST: f64 = 1.6;
/// A speed is given up where the best hub leaves this many times what the wheel and the noise explain.
const LEFT_OVER: f64 = 2.0;
/// Share of the largest disparity above which a reading shows how far the wheel has turned.
const TELLING: f64 = 0.2;
/// Ways of what does not turn whose speeds are tried, and evaluations per parameter for the hub at another
/// speed.
const HUBS: usize = 2;
const HUB_PATIENCE: usize = 2;
/// Times of passage of each speed that are kept.
const PASSAGES: usize = 3;
/// Samples that starts are held against.
pub(super) const SAMPLES: usize = 97;
/// Rounds of the search: the number of best starts, and the evaluations per parameter that each of them gets.
/// Those that are left are followed with all samples.
const GLANCES: [(usize, usize); 2] = [(64, 1), (20, 3)];
pub(super) const FOLLOWED: usize = 5;
const PATIENCE: usize = 8;
/// Share of a sum of squares by which descents differ that are in different places.
const SAME: f64 = 1e-4;

/// Returns the descent from the best of many starts. `ways` are those of `hubs`, the same problem without a
/// turn, the lowest first.
pub(super) fn best_start(problem: &Problem, hubs: &Problem, ways: &[Descent]) -> Option<Descent> {
    let [coarse, hubs] = [problem, hubs].map(|all| start::thinned(all, SAMPLES));
    let speeds = speeds(&coarse, &hubs, ways);
    let starts = speeds.into_par_iter().flat_map_iter(|hub| passages(&coarse, hub)).collect();
    let mut left: Vec<Descent> = starts;
    for (count, patience) in GLANCES {
        let starts = lowest(left, count).into_par_iter();
        left = starts.map(|start| descent(&coarse, start.free, patience)).collect();
    }
    let followed = lowest(left, FOLLOWED).into_par_iter();
    let ends = followed.map(|glance| descent(problem, glance.free, PATIENCE)).collect();
    lowest(ends, 1).pop()
}

/// The lowest of `descents`, at most `count`, each once.
pub(super) fn lowest(mut descents: Vec<Descent>, count: usize) -> Vec<Descent> {
    descents.retain(|descent| descent.cost.is_finite());
    descents.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    descents.dedup_by(|higher, lower| higher.cost - lower.cost <= SAME * lower.cost);
    descents.truncate(count);
    descents
}

/// Returns starts for the hub at speeds on both sides of those of `ways`, as far as the fit is no worse than
/// the wheel's own wiggle explains.
fn speeds(problem: &Problem, hubs: &Problem, ways: &[Descent]) -> Vec<Free> {
    let Some(best) = ways.first() else { return Vec::new() };
    let limit = LEFT_OVER * (cost(hubs, &best.free) + wiggle(problem, &best.free));
    let mut speeds = Vec::new();
    let at_speed = |mut free: Free, change: f64| {
        free[0] = (free[0] + change).min(FASTEST);
        Some(descent_at_speed(hubs, free, HUB_PATIENCE))
            .filter(|best| best.cost <= limit)
            .map(|best| best.free)
    };
    for hub in ways.iter().take(HUBS).filter_map(|way| at_speed(way.free, 0.0)) {
        speeds.push(hub);
        for direction in [-1.0, 1.0] {
            let wide = std::iter::successors(Some(hub), |free| at_speed(*free, direction * LARGEST_STEP));
            let least = LARGEST_STEP * wide.take(WIDE).count() as f64 / SPEEDS as f64;
            let mut free = hub;
            for _ in 0..SPEEDS {
                match at_speed(free, direction * step(problem, &free).max(least)) {
                    Some(next) if next[0] != free[0] => free = next,
                    _ => break,
                }
                speeds.push(free);
            }
        }
    }
    if hubs.is_even_in_z() {
        let mirrored = |free: &Free| Free::new(free[0], free[1], -free[2], free[3]);
        speeds.extend(speeds.clone().iter().map(mirrored));
    }
    speeds
}

/// The sum of squares of what the wheel's point shows beside its hub.
fn wiggle(problem: &Problem, free: &Free) -> f64 {
    let Some(trial) = problem.trial(free) else { return 0.0 };
    let hub = Trial { rolling: None, ..trial };
    let of_row = |row| {
        let (seen, of_hub) = (problem.angles(&trial, row), problem.angles(&hub, row));
        (0..2).map(|curve| (row.weights[curve] * (seen[curve] - of_hub[curve])).powi(2)).sum::<f64>()
    };
    0.5 * problem.rows.iter().map(of_row).sum::<f64>()
}

/// The step in ln(rapidity) by which no telling reading shows the wheel turned by more than [`STEP`].
fn step(problem: &Problem, free: &Free) -> f64 {
    const SMALL: f64 = 1e-4;
    let largest = |curve: usize| {
        problem.rows.iter().map(|row| row.weights[curve] * row.values[curve].abs()).fold(0.0, f64::max)
    };
    let largest = [largest(0), largest(1)];
    let mut faster = *free;
    faster[0] += SMALL;
    let (Some(trial), Some(faster)) = (problem.trial(free), problem.trial(&faster)) else {
        return LARGEST_STEP;
    };
    let is_telling = |curve: usize, row: &PreparedSample| {
        row.weights[curve] > 0.0 && row.weights[curve] * row.values[curve].abs() >= TELLING * largest[curve]
    };
    let telling = problem.rows.iter().filter(|row| (0..2).any(|curve| is_telling(curve, row)));
    let changes = telling.map(|row| {
        let pair = &problem.pairs[row.pair];
        (faster.turn(pair, row.time) - trial.turn(pair, row.time)) / SMALL
    });
    let (low, high) = changes
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), change| (change.min(low), change.max(high)));
    let most = if problem.fits_passage { 0.5 * (high - low) } else { high.max(-low) };
    (STEP / most).min(LARGEST_STEP)
}

/// `hub`, and if the time of passage is unknown the best of such times at which the wheel has turned
/// otherwise.
fn passages(problem: &Problem, hub: Free) -> Vec<Descent> {
    let Some(trial) = problem.trial(&hub) else { return Vec::new() };
    let of_step = STEP / TAU * problem.passage_of_turn(&trial);
    let turned = |steps: i32| {
        let free = hub + Free::new(0.0, 0.0, 0.0, of_step * f64::from(steps));
        Descent { free, cost: cost(problem, &free) }
    };
    // The point is at most a radius from the hub, in the time of which the wheel turns by about gamma
    // radians: twice that.
    let most = (2.0 * trial.speed.gamma() / STEP).ceil().min(MOST_TURNS) as i32;
    let turns = if problem.fits_passage { most } else { 0 };
    lowest((-turns..=turns).map(turned).collect(), PASSAGES)
}

/// Half the sum of squares, as the solver counts it.
fn cost(problem: &Problem, free: &Free) -> f64 {
    let Some(trial) = problem.trial(free) else { return f64::INFINITY };
    let of_row = |row| {
        let angles = problem.angles(&trial, row);
        (0..2).map(|curve| (row.weights[curve] * (angles[curve] - row.values[curve])).powi(2)).sum::<f64>()
    };
    0.5 * problem.rows.iter().map(of_row).sum::<f64>()
}
