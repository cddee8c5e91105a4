//! Where to start: trial objects that already look like the data, found without a guess.
//!
//! A coarse grid over beta, elevation and distance. Its distances are scaled by the largest disparity,
//! which falls as separation over distance; if the time of passage is unknown, each trial is moved in time
//! until its largest disparity is seen when the data's is.

use crate::apparent::Aperture;
use crate::fit::curve::Trial;
use crate::fit::problem::{Free, Problem, Row};
use crate::speed::Speed;

/// Samples that the grid is held against: enough to see the shape.
const GRID_SAMPLES: usize = 48;
/// Rapidities of the grid: beta = 0.05 to 0.9995, evenly in ln(rapidity), the parameter that is fitted.
const RAPIDITIES: [f64; 11] = [0.05, 0.08, 0.14, 0.25, 0.45, 0.7, 1.1, 1.6, 2.2, 3.0, 4.2];
/// tan(elevation) = z/y of the grid.
const SLOPES: [f64; 7] = [0.03, 0.15, 0.4, 0.9, 2.0, 6.0, 30.0];
/// Steps in distance, and the factor between them.
const DISTANCES: i32 = 16;
const DISTANCE_FACTOR: f64 = 1.45;
/// Points of passage x/rho at which the largest disparity of a trial is looked for.
const PASSAGE: [f64; 25] = [
    -8.0, -5.0, -3.5, -2.5, -1.8, -1.4, -1.1, -0.9, -0.7, -0.5, -0.35, -0.2, 0.0, 0.2, 0.35, 0.5, 0.7, 0.9, 1.1,
    1.4, 1.8, 2.5, 3.5, 5.0, 8.0,
];

/// A start, and how badly it fits.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    free: Free,
    cost: f64,
}

/// At most `count` starts from different regions, the best first.
pub(super) fn starts(problem: &Problem, count: usize) -> Vec<Free> {
    let features = Features::new(problem);
    let mut candidates = Vec::new();
    for rapidity in RAPIDITIES {
        for slope in SLOPES {
            for step in 0..DISTANCES {
                let distance = features.scale * DISTANCE_FACTOR.powi(step - DISTANCES * 5 / 8);
                candidates.extend(features.candidates(problem, rapidity, slope, distance));
            }
        }
    }
    candidates.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    distinct(&candidates, count)
}

/// The best candidates that are not neighbours of a better one.
fn distinct(candidates: &[Candidate], count: usize) -> Vec<Free> {
    let mut chosen: Vec<Free> = Vec::with_capacity(count);
    for candidate in candidates {
        let free = candidate.free;
        let is_neighbour = |other: &Free| {
            let ratio = (free[2].abs() / other[2].abs()).ln().abs();
            (free[0] - other[0]).abs() < 1.0
                && (free[1] - other[1]).abs() < 1.0
                && (free[2] * other[2] > 0.0 && ratio < 1.6)
        };
        if !chosen.iter().any(is_neighbour) {
            chosen.push(free);
        }
        if chosen.len() == count {
            break;
        }
    }
    chosen
}

/// What the data look like.
struct Features {
    rows: Vec<Row>,
    /// The curve with the largest disparity in it that is read for its extremum: 0 or 1.
    curve: usize,
    pair: [Aperture; 2],
    extremum_time: f64,
    /// Separation over largest disparity: of the order of the distance.
    scale: f64,
}

impl Features {
    fn new(problem: &Problem) -> Self {
        let curve = usize::from(problem.rows.iter().all(|row| row.weights[0] == 0.0));
        let read = |row: &&Row| row.weights[curve] > 0.0;
        let per_separation = |row: &Row| row.values[curve].abs() / separation(&problem.pairs[row.pair]);
        let extremum = problem
            .rows
            .iter()
            .filter(read)
            .max_by(|a, b| per_separation(a).total_cmp(&per_separation(b)))
            .copied()
            .unwrap_or(problem.rows[0]);
        let stride = problem.rows.len().div_ceil(GRID_SAMPLES);
        let mut rows: Vec<Row> = problem.rows.iter().step_by(stride).copied().collect();
        rows.push(extremum);
        Self {
            rows,
            curve,
            pair: problem.pairs[extremum.pair],
            extremum_time: extremum.time,
            scale: 1.0 / per_separation(&extremum).max(f64::MIN_POSITIVE.sqrt()),
        }
    }

    /// A trial object for each time at which it might have passed and each sign of z.
    fn candidates(&self, problem: &Problem, rapidity: f64, slope: f64, distance: f64) -> Vec<Candidate> {
        let Ok(speed) = Speed::from_rapidity(rapidity) else { return Vec::new() };
        let y = distance / slope.hypot(1.0);
        let trial = Trial { speed, y, z: slope * y, passage_time: 0.0, passage_x: problem.passage_x };
        let passage_times = if problem.fits_passage {
            self.extremum_times(problem, &trial).map(|time| self.extremum_time - time).to_vec()
        } else {
            vec![0.0]
        };
        let at = |passage_time| self.best_sign(problem, &Trial { passage_time, ..trial });
        passage_times.into_iter().map(at).collect()
    }

    /// When the largest and the smallest disparity of `trial` are seen.
    fn extremum_times(&self, problem: &Problem, trial: &Trial) -> [f64; 2] {
        let distance = trial.y.hypot(trial.z);
        let mut extrema = [(f64::NEG_INFINITY, 0.0), (f64::INFINITY, 0.0)];
        for x in PASSAGE.map(|x| x * distance) {
            let time = x / trial.speed.beta() + x.hypot(distance);
            let value = trial.angles(problem.model, &self.pair, time)[self.curve];
            if value > extrema[0].0 {
                extrema[0] = (value, time);
            }
            if value < extrema[1].0 {
                extrema[1] = (value, time);
            }
        }
        extrema.map(|(_, time)| time)
    }

    /// The trial or its mirror image at -z, for which Delta-theta has the other sign.
    fn best_sign(&self, problem: &Problem, trial: &Trial) -> Candidate {
        let mut costs = [0.0; 2];
        for row in &self.rows {
            let [dphi, dtheta] = trial.angles(problem.model, &problem.pairs[row.pair], row.time);
            let azimuthal = (row.weights[0] * (dphi - row.values[0])).powi(2);
            costs[0] += azimuthal + (row.weights[1] * (dtheta - row.values[1])).powi(2);
            costs[1] += azimuthal + (row.weights[1] * (-dtheta - row.values[1])).powi(2);
        }
        let (cost, z) = if costs[1] < costs[0] { (costs[1], -trial.z) } else { (costs[0], trial.z) };
        let free = Free::new(trial.speed.rapidity().ln(), trial.y.ln(), z, trial.passage_time);
        Candidate { free, cost }
    }
}

fn separation([primary, secondary]: &[Aperture; 2]) -> f64 {
    (secondary.x - primary.x).hypot(secondary.y - primary.y).hypot(secondary.z - primary.z)
}
