//! Where to start: trial objects that already look like the data, found without a guess.
//!
//! A coarse grid over beta, elevation and distance. Its distances are scaled by the largest disparity,
//! which falls as separation over distance; if the time of passage is unknown, each trial is moved in time
//! until it shows a feature of the data (an extremum, the onset) when they do.

use rayon::prelude::*;

use crate::apparent::Aperture;
use crate::fit::curve::Trial;
use crate::fit::problem::{Free, Problem, Row};
use crate::speed::Speed;

/// Samples that the grid is held against: enough to see the shape.
const GRID_SAMPLES: usize = 48;
/// Rapidities of the grid: beta = 0.05 to 0.9995, evenly in ln(rapidity), the parameter that is fitted.
const RAPIDITIES: [f64; 12] = [0.05, 0.08, 0.14, 0.25, 0.45, 0.7, 1.0, 1.4, 1.9, 2.5, 3.2, 4.2];
/// tan(elevation) = z/y of the grid.
const SLOPES: [f64; 8] = [0.03, 0.15, 0.4, 0.9, 2.0, 5.0, 12.0, 30.0];
/// Steps in distance, and the factor between them.
const DISTANCES: i32 = 16;
const DISTANCE_FACTOR: f64 = 1.45;
/// The step at which the distance is the scale of the data.
const MIDDLE: i32 = 10;
/// Points of passage x/rho at which the largest disparity of a trial is looked for.
const PASSAGE: [f64; 25] = [
    -8.0, -5.0, -3.5, -2.5, -1.8, -1.4, -1.1, -0.9, -0.7, -0.5, -0.35, -0.2, 0.0, 0.2, 0.35, 0.5, 0.7, 0.9,
    1.1, 1.4, 1.8, 2.5, 3.5, 5.0, 8.0,
];

/// A start, and how badly it fits.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    free: Free,
    cost: f64,
}

/// The best start of each speed, the slowest first. All are worth following: a coarse grid misjudges the
/// sharp features of high speeds, and speed is what separates one minimum from another.
pub(super) fn starts(problem: &Problem) -> Vec<Free> {
    let features = Features::new(problem);
    let best_of_speed = |&rapidity: &f64| {
        let candidates = features.candidates(problem, rapidity).into_iter();
        candidates.min_by(|a, b| a.cost.total_cmp(&b.cost)).map(|best| best.free)
    };
    RAPIDITIES.par_iter().filter_map(best_of_speed).collect()
}

/// What the data look like.
struct Features {
    rows: Vec<Row>,
    /// The curve with the largest disparity in it that is read for its extremum: 0 or 1.
    curve: usize,
    pair: [Aperture; 2],
    extremum_time: f64,
    onset_time: f64,
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
        let of_pair = problem.rows.iter().filter(read).filter(|row| row.pair == extremum.pair);
        let mut seen: Vec<[f64; 2]> = of_pair.map(|row| [row.time, row.values[curve]]).collect();
        seen.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let stride = problem.rows.len().div_ceil(GRID_SAMPLES);
        let mut rows: Vec<Row> = problem.rows.iter().step_by(stride).copied().collect();
        rows.push(extremum);
        Self {
            rows,
            curve,
            pair: problem.pairs[extremum.pair],
            extremum_time: extremum.time,
            onset_time: onset(&seen, extremum.values[curve].abs()),
            scale: 1.0 / per_separation(&extremum).max(f64::MIN_POSITIVE.sqrt()),
        }
    }

    /// The trial objects of one speed.
    fn candidates(&self, problem: &Problem, rapidity: f64) -> Vec<Candidate> {
        let Ok(speed) = Speed::from_rapidity(rapidity) else { return Vec::new() };
        let distances = (0..DISTANCES).map(|step| self.scale * DISTANCE_FACTOR.powi(step - MIDDLE));
        let shapes = distances.flat_map(|distance| SLOPES.map(|slope| (distance, slope)));
        let trials = shapes.map(|(distance, slope)| {
            let y = distance / slope.hypot(1.0);
            Trial { speed, y, z: slope * y, passage_time: 0.0, passage_x: problem.passage_x }
        });
        trials.flat_map(|trial| self.in_time(problem, trial)).collect()
    }

    /// `trial` at each time at which it might have passed.
    fn in_time(&self, problem: &Problem, trial: Trial) -> Vec<Candidate> {
        let at = |passage_time| self.best_sign(problem, &Trial { passage_time, ..trial });
        if problem.fits_passage {
            self.passage_times(problem, &trial).map(at).to_vec()
        } else {
            vec![at(0.0)]
        }
    }

    /// Times of passage at which `trial` shows a feature of the data when they do: its largest or its
    /// smallest disparity, or the first time at which the disparity reaches half its extreme.
    fn passage_times(&self, problem: &Problem, trial: &Trial) -> [f64; 3] {
        let distance = trial.y.hypot(trial.z);
        let seen: [[f64; 2]; PASSAGE.len()] = PASSAGE.map(|x| {
            let time = distance * (x / trial.speed.beta() + x.hypot(1.0));
            [time, trial.angles(problem.model, &self.pair, time)[self.curve]]
        });
        let [mut largest, mut smallest] = [seen[0]; 2];
        for point in seen {
            if point[1] > largest[1] {
                largest = point;
            }
            if point[1] < smallest[1] {
                smallest = point;
            }
        }
        let onset = onset(&seen, largest[1].max(-smallest[1]));
        [self.extremum_time - largest[0], self.extremum_time - smallest[0], self.onset_time - onset]
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

/// When the magnitude of a curve of (time, value) first reaches half of `extreme`, between points by
/// linear interpolation.
fn onset(curve: &[[f64; 2]], extreme: f64) -> f64 {
    let half = 0.5 * extreme;
    let Some(index) = curve.iter().position(|[_, value]| value.abs() >= half) else { return 0.0 };
    let [time, value] = curve[index];
    let [time_before, value_before] = curve[index.saturating_sub(1)];
    let rise = value.abs() - value_before.abs();
    if rise > 0.0 { time - (time - time_before) * (value.abs() - half) / rise } else { time }
}

fn separation([primary, secondary]: &[Aperture; 2]) -> f64 {
    (secondary.x - primary.x).hypot(secondary.y - primary.y).hypot(secondary.z - primary.z)
}
