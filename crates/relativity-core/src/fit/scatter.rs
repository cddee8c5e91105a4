//! The scatter of readings, which a few outliers do not move.

use crate::fit::problem::{PreparedSample, Problem};

/// Median magnitude of a normal deviate.
const NORMAL_MEDIAN: f64 = 0.674_489_750_196_082;
/// Least rough noise of a curve, as a part of its range without the highest and the lowest twentieth.
const LEAST_ROUGH: f64 = 0.02;
const TWENTIETH: f64 = 0.05;
/// Number of readings before and after one, in time, with which it is smoothed: by the median of all.
const NEIGHBOURS: usize = 2;

/// Returns the standard deviation of normal deviates of these magnitudes, from their median: larger by what a
/// fit of this number of `parameters` takes out of it; 0 of none.
#[must_use]
pub fn standard_deviation(magnitudes: impl Iterator<Item = f64>, parameters: usize) -> f64 {
    let mut sizes: Vec<f64> = magnitudes.collect();
    let free = sizes.len().saturating_sub(parameters).max(1) as f64;
    let count = sizes.len() as f64;
    median(&mut sizes) / NORMAL_MEDIAN * (count / free).sqrt()
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// The scatter of a curve before it is fitted, from the distance of each reading from the line between its
/// neighbours; large enough to search with.
pub(super) fn rough(rows: &[PreparedSample], pairs: usize, curve: usize) -> f64 {
    let mut bends = Vec::new();
    for chain in chains(rows, pairs, curve) {
        for [before, row, after] in chain.array_windows() {
            let share = (row.time - before.time) / (after.time - before.time);
            let [first, value, last] = [before, row, after].map(|row| row.values[curve]);
            let by_noise = (1.0 + share * share + (1.0 - share).powi(2)).sqrt();
            let bend = (value - first - share * (last - first)).abs() / by_noise;
            bends.extend(Some(bend).filter(|bend| bend.is_finite()));
        }
    }
    let mut values: Vec<f64> =
        rows.iter().filter(|row| row.is_read()[curve]).map(|row| row.values[curve]).collect();
    values.sort_by(f64::total_cmp);
    let end = (TWENTIETH * values.len() as f64) as usize;
    let range = values.get(values.len().saturating_sub(end + 1)).zip(values.get(end));
    let range = range.map_or(0.0, |(high, low)| (high - low).max(0.0));
    standard_deviation(bends.into_iter(), 0).max(LEAST_ROUGH * range)
}

/// `problem` with each reading replaced by the median of its neighbours, so that no few of them stand out.
pub(super) fn smoothed(problem: &Problem) -> Problem {
    let mut rows = Vec::new();
    for curve in 0..2 {
        for chain in chains(&problem.rows, problem.pairs.len(), curve) {
            for (place, row) in chain.iter().enumerate() {
                let near = place.saturating_sub(NEIGHBOURS)..(place + NEIGHBOURS + 1).min(chain.len());
                let mut values: Vec<f64> = chain[near].iter().map(|row| row.values[curve]).collect();
                let mut smoothed = PreparedSample { values: [0.0; 2], weights: [0.0; 2], ..**row };
                smoothed.values[curve] = median(&mut values);
                smoothed.weights[curve] = row.weights[curve];
                rows.push(smoothed);
            }
        }
    }
    Problem { rows, ..problem.clone() }
}

/// The readings of a curve by each pair of apertures, in the order of time.
fn chains(
    rows: &[PreparedSample],
    pairs: usize,
    curve: usize,
) -> impl Iterator<Item = Vec<&PreparedSample>> + use<'_> {
    (0..pairs).map(move |pair| {
        let of_pair = rows.iter().filter(|row| row.pair == pair && row.is_read()[curve]);
        let mut chain: Vec<&PreparedSample> = of_pair.collect();
        chain.sort_by(|a, b| a.time.total_cmp(&b.time));
        chain
    })
}
