//! From starts to the minimum of the sum of squares, by Levenberg and Marquardt.

use levenberg_marquardt::{LevenbergMarquardt, TerminationReason};

use crate::fit::error::{FitError, NotConverged};
use crate::fit::problem::{At, Free, Problem};
use crate::fit::start;
use crate::fit::trial::Trial;
use crate::math;
use crate::threads::prelude::*;

// What is lost with other values was counted in 100 to 150 noisy curves of Delta-phi alone, over beta 0.1 to
// 0.99, y and |z| 0.3 to 10, d 0.05 to 0.5, and noise of 0.1 to 2 % of each curve's range.

/// Evaluations per parameter that every start gets (with 1 a minimum is lost, with 4 no more is found), that
/// those followed get (3 lose none either), and that the minimum gets: the solver's own number.
const GLANCE: usize = 2;
pub(super) const START_PATIENCE: usize = 6;
const PATIENCE: usize = 100;
/// Descents that are followed after a glance: with 1 two minima are lost, with 3 none.
const FOLLOWED: usize = 6;
/// Descents closer than this in ln(rapidity) and ln(y) are on the way to the same minimum. If all were
/// followed, they would crowd other ways out: a minimum is lost.
const NEAR: f64 = 0.25;
/// ln(rapidity) above which speeds are all near that of light.
const FAST: f64 = 1.6;
/// |z|/y below which z = 0 is tried where only |z| matters.
const NEAR_GROUND: f64 = 1e-2;
/// |z|/y from which a way up is looked for there: at z = 0 the sum of squares has no slope.
const LIFT: f64 = 0.1;
/// Share of a sum of squares by which two may differ by rounding.
pub(super) const ROUNDING: f64 = 1e-12;

/// A minimum of the sum of squares.
pub(super) struct Minimum {
    pub free: Free,
    pub trial: Trial,
    pub cost: f64,
}

/// Follows the best starts of a point that does not turn; the lowest minimum comes first.
pub(super) fn ways(problem: &Problem) -> Vec<Descent> {
    let coarse = start::thinned(problem, start::GRID_SAMPLES);
    let glances = descents(&coarse, start::starts(problem, &coarse), GLANCE);
    let followed = glances.iter().take(FOLLOWED).map(|descent| lifted(problem, descent.free)).collect();
    descents(problem, followed, START_PATIENCE)
}

/// The place to which a few steps from a start led.
#[derive(Debug, Clone, Copy)]
pub(super) struct Descent {
    pub free: Free,
    pub cost: f64,
}

impl Descent {
    /// Returns whether both are on their way to the same minimum, judged by speed and depth.
    fn is_near(&self, other: &Self) -> bool {
        let speed = |descent: &Self| descent.free[0].min(FAST);
        let apart = (speed(self) - speed(other)).abs().max((self.free[1] - other.free[1]).abs());
        apart < NEAR
    }
}

/// Goes a few steps from a start.
pub(super) fn descent(problem: &Problem, start: Free, patience: usize) -> Descent {
    descended(At { problem, free: start, keeps_speed: false }, patience)
}

/// Goes a few steps from a `start` whose speed is kept.
pub(super) fn descent_at_speed(problem: &Problem, start: Free, patience: usize) -> Descent {
    descended(At { problem, free: start, keeps_speed: true }, patience)
}

fn descended(start: At<'_>, patience: usize) -> Descent {
    let (at, report) = LevenbergMarquardt::new().with_patience(patience).minimize(start);
    Descent { free: at.free, cost: report.objective_function }
}

/// Goes a few steps from each start. Returns the results, the lowest first, without those that are near a
/// lower one.
pub(super) fn descents(problem: &Problem, starts: Vec<Free>, patience: usize) -> Vec<Descent> {
    let mut descents: Vec<_> =
        starts.into_par_iter().map(|start| descent(problem, start, patience)).collect();
    descents.retain(|descent| descent.cost.is_finite());
    descents.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    let mut distinct: Vec<Descent> = Vec::new();
    for descent in descents {
        if !distinct.iter().any(|lower| lower.is_near(&descent)) {
            distinct.push(descent);
        }
    }
    distinct
}

/// `free`, off z = 0 where only |z| matters: no descent could leave it.
fn lifted(problem: &Problem, mut free: Free) -> Free {
    if problem.is_even_in_z() {
        free[2] = free[2].abs().max(LIFT * math::exp(free[1]));
    }
    free
}

/// The minimum downhill of `start`. Where only |z| matters, the way to z = 0 is endless and there is none
/// back, so that near it z = 0 is tried as well, and a way up.
pub(super) fn minimum(problem: &Problem, start: Free) -> Result<Minimum, FitError> {
    let (minimum, end) = refined(problem, start);
    if !problem.is_even_in_z() || end[2].abs() > NEAR_GROUND * math::exp(end[1]) {
        return minimum;
    }
    let mut on_ground = end;
    on_ground[2] = 0.0;
    // Of equals, but for rounding, the lower z: z = 0 before what only approaches it.
    let lower = |lowest: Minimum, next: Minimum| {
        let margin = if next.free[2].abs() < lowest.free[2].abs() { 1.0 + ROUNDING } else { 1.0 - ROUNDING };
        if next.cost < margin * lowest.cost { next } else { lowest }
    };
    [on_ground, lifted(problem, end)].into_iter().fold(minimum, |lowest, start| {
        match (lowest, refined(problem, start).0) {
            (Ok(lowest), Ok(next)) => Ok(lower(lowest, next)),
            (Err(_), next) => next,
            (lowest, Err(_)) => lowest,
        }
    })
}

/// The minimum downhill of `start`, to the last digit that the sum of squares holds.
fn refined(problem: &Problem, start: Free) -> (Result<Minimum, FitError>, Free) {
    let solver = LevenbergMarquardt::new().with_patience(PATIENCE);
    let (At { free, .. }, report) = solver.minimize(At { problem, free: start, keeps_speed: false });
    let minimum = match (report.termination, problem.trial(&free)) {
        (TerminationReason::LostPatience, _) => {
            Err(NotConverged::StillFalling { evaluations: report.number_of_evaluations })
        }
        // No improvement possible: the solver's tolerance is finer than rounding allows here.
        (reason, Some(trial))
            if reason.was_successful() || matches!(reason, TerminationReason::NoImprovementPossible(_)) =>
        {
            Ok(Minimum { free, trial, cost: 2.0 * report.objective_function })
        }
        _ => Err(NotConverged::NotFinite),
    };
    (minimum.map_err(FitError::NotConverged), free)
}
