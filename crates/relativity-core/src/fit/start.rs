//! Starts of a fit: trial objects that already look like the data, found without a guess.
//!
//! A coarse grid over beta, elevation and distance. Its distances are those at which a trial's largest
//! disparity is about the data's; if the time of passage is unknown, each trial is moved in time until it
//! shows a feature of the data (an extremum, the onset) when they do.

use crate::aperture::Aperture;
use crate::fit::problem::{Free, PreparedSample, Problem};
use crate::fit::scatter;
use crate::fit::trial::Trial;
use crate::math;
use crate::speed::Speed;
use crate::threads::prelude::*;

/// Samples that the grid is held against: enough to see the shape. A prime, since alternating pairs or
/// curves would be in step with most strides.
pub(super) const GRID_SAMPLES: usize = 47;
/// Rapidities of the grid: beta = 0.05 to 0.9995, evenly in ln(rapidity), the parameter that is fitted.
const RAPIDITIES: [f64; 14] = [0.05, 0.08, 0.14, 0.25, 0.45, 0.7, 1.0, 1.35, 1.7, 2.05, 2.4, 2.8, 3.4, 4.2];
/// tan(elevation) = z/y of the grid: low, middle and high.
const SLOPES: [&[f64]; 3] = [&[0.03, 0.1, 0.25, 0.5], &[0.85, 1.3, 2.0], &[4.0, 10.0, 30.0]];
/// Steps in distance, and the factor between them.
const DISTANCES: i32 = 16;
const DISTANCE_FACTOR: f64 = 1.25;
/// The step at which a trial's largest disparity is the data's. Most are nearer: the data may lack the
/// extremum.
const MIDDLE: i32 = 10;
/// Points of passage x/rho at which the largest disparity of a trial is looked for.
const PASSAGE: [f64; 25] = [
    -8.0, -5.0, -3.5, -2.5, -1.8, -1.4, -1.1, -0.9, -0.7, -0.5, -0.35, -0.2, 0.0, 0.2, 0.35, 0.5, 0.7, 0.9,
    1.1, 1.4, 1.8, 2.5, 3.5, 5.0, 8.0,
];

/// Features by which the time of passage is found.
const FEATURES: usize = 3;
/// Greatest number of starts. A quarter of them loses no minimum in 100 noisy curves; the rest is for the
/// worst.
const STARTS: usize = 56;

/// A start, and how badly it fits.
#[derive(Debug, Clone, Copy)]
struct StartCandidate {
    free: Free,
    cost: f64,
}

/// `problem` with at most `most` of its rows.
pub(super) fn thinned(problem: &Problem, most: usize) -> Problem {
    let all = &problem.rows;
    let count = all.len().min(most);
    Problem { rows: (0..count).map(|index| all[index * all.len() / count]).collect(), ..problem.clone() }
}

/// Returns the best starts of each speed, elevation band and feature, in the order of their fit to `coarse`,
/// the best first. Many are worth following: a coarse grid misjudges the sharp features of high speeds.
pub(super) fn starts(problem: &Problem, coarse: &Problem) -> Vec<Free> {
    let smoothed = problem.loss.is_robust().then(|| scatter::smoothed(problem));
    let features = Features::new(smoothed.as_ref().unwrap_or(problem), coarse);
    let best_of_speed = |&rapidity: &f64| SLOPES.map(|slopes| features.best_of(problem, rapidity, slopes));
    let best = RAPIDITIES.par_iter().flat_map_iter(best_of_speed);
    let mut best: Vec<StartCandidate> = best.flatten_iter().flatten().collect();
    best.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    best.iter().take(STARTS).map(|candidate| candidate.free).collect()
}

/// The features of a trial object's curve.
struct CurveFeatures {
    /// When its disparity is largest, smallest, and first reaches half its extreme, in units of the distance,
    /// from the time of passage.
    times: [f64; FEATURES],
    /// Distance at which the curve is as large as the data.
    distance: f64,
}

/// Features of the data that starts are made of: when and how large its extremum is, and when it sets in.
struct Features {
    rows: Vec<PreparedSample>,
    /// The curve with the largest disparity in it that is read for its extremum: 0 or 1.
    curve: usize,
    pair: [Aperture; 2],
    extremum_time: f64,
    onset_time: f64,
    /// Largest disparity in the data.
    extreme: f64,
    /// Separation over largest disparity: of the order of the distance.
    scale: f64,
}

impl Features {
    fn new(problem: &Problem, coarse: &Problem) -> Self {
        let curve = usize::from(problem.rows.iter().all(|row| row.weights[0] == 0.0));
        let read = |row: &&PreparedSample| row.weights[curve] > 0.0;
        let per_separation =
            |row: &PreparedSample| row.values[curve].abs() / separation(&problem.pairs[row.pair]);
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
        let mut rows = coarse.rows.clone();
        rows.push(extremum);
        // The largest first: a trial that misses them is given up at once.
        rows.sort_by(|a, b| per_separation(b).total_cmp(&per_separation(a)));
        Self {
            rows,
            curve,
            pair: problem.pairs[extremum.pair],
            extremum_time: extremum.time,
            onset_time: onset(&seen, extremum.values[curve].abs()),
            extreme: extremum.values[curve].abs().max(f64::MIN_POSITIVE.sqrt()),
            scale: 1.0 / per_separation(&extremum).max(f64::MIN_POSITIVE.sqrt()),
        }
    }

    /// Returns the best trial object of one speed and some elevations, for each feature that may give its
    /// time of passage.
    fn best_of(
        &self,
        problem: &Problem,
        rapidity: f64,
        slopes: &[f64],
    ) -> [Option<StartCandidate>; FEATURES] {
        let mut best = [None; FEATURES];
        let Ok(speed) = Speed::from_rapidity(rapidity) else { return best };
        let ways = if problem.fits_passage { FEATURES } else { 1 };
        for &slope in slopes {
            let shape = self.shape(problem, speed, slope);
            for step in 0..DISTANCES {
                let distance = shape.distance * DISTANCE_FACTOR.powi(step - MIDDLE);
                let trial = object(problem, speed, slope, distance);
                for (feature, best) in best.iter_mut().enumerate().take(ways) {
                    let passage_time = self.passage_time(problem, &shape, distance, feature);
                    *best = self.better(problem, Trial { passage_time, ..trial }, *best);
                }
            }
        }
        best
    }

    /// Returns the features of an object of that speed and elevation at the distance at which it is as large
    /// as the data: from afar disparities fall as separation over distance, so that a second look is enough.
    fn shape(&self, problem: &Problem, speed: Speed, slope: f64) -> CurveFeatures {
        let from_afar = self.shape_at(problem, speed, slope, self.scale);
        self.shape_at(problem, speed, slope, from_afar.distance)
    }

    fn shape_at(&self, problem: &Problem, speed: Speed, slope: f64, distance: f64) -> CurveFeatures {
        let trial = Trial { passage_x: 0.0, rolling: None, ..object(problem, speed, slope, distance) };
        let seen: [[f64; 2]; PASSAGE.len()] = PASSAGE.map(|x| {
            let time = x / speed.beta() + math::hypot(x, 1.0);
            [time, trial.angles(problem.model, &self.pair, distance * time)[self.curve]]
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
        let extreme = largest[1].max(-smallest[1]);
        CurveFeatures {
            times: [largest[0], smallest[0], onset(&seen, extreme)],
            distance: (distance * extreme / self.extreme).clamp(1e-3 * self.scale, 1e3 * self.scale),
        }
    }

    /// Time of passage at which an object of `shape` at `distance` shows a feature of the data when they do.
    fn passage_time(&self, problem: &Problem, shape: &CurveFeatures, distance: f64, feature: usize) -> f64 {
        let seen = [self.extremum_time, self.extremum_time, self.onset_time][feature];
        if problem.fits_passage { seen - distance * shape.times[feature] } else { 0.0 }
    }

    /// `trial`, or its mirror image at -z, for which Delta-theta has the other sign unless it turns; `best`
    /// if that fits better.
    fn better(
        &self,
        problem: &Problem,
        trial: Trial,
        best: Option<StartCandidate>,
    ) -> Option<StartCandidate> {
        let limit = best.map_or(f64::INFINITY, |best| best.cost);
        let mut costs = [0.0; 2];
        for row in &self.rows {
            let [dphi, dtheta] = problem.angles(&trial, row);
            let mirrored = match trial.rolling {
                None => [dphi, -dtheta],
                Some(_) => problem.angles(&Trial { z: -trial.z, ..trial }, row),
            };
            for (cost, angles) in costs.iter_mut().zip([[dphi, dtheta], mirrored]) {
                let residual = |i: usize| row.weights[i] * (angles[i] - row.values[i]);
                *cost += (0..2).map(|i| problem.loss.cost(residual(i))).sum::<f64>();
            }
            if costs[0].min(costs[1]) >= limit {
                return best;
            }
        }
        let (cost, z) = if costs[1] < costs[0] { (costs[1], -trial.z) } else { (costs[0], trial.z) };
        Some(StartCandidate {
            free: Free::new(math::ln(trial.speed.rapidity()), math::ln(trial.y), z, trial.passage_time),
            cost,
        })
    }
}

fn object(problem: &Problem, speed: Speed, slope: f64, distance: f64) -> Trial {
    let y = distance / math::hypot(slope, 1.0);
    Trial {
        speed,
        y,
        z: slope * y,
        passage_time: 0.0,
        passage_x: problem.passage_x,
        rolling: problem.rolling,
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
    math::hypot(math::hypot(secondary.x - primary.x, secondary.y - primary.y), secondary.z - primary.z)
}
