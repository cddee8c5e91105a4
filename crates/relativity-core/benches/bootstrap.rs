//! The cost of a fit with 1,000 bootstrap replicates, against a naive bootstrap.
//!
//! ```text
//! cargo bench -p relativity-core --bench bootstrap
//! ```
//!
//! The naive bootstrap refits each resampled data set by the general solver, one after the other.
//! `bootstrap_scipy.py` does the same with `SciPy`.

#[path = "../tests/common/mod.rs"]
mod common;

use std::hint::black_box;
use std::time::Instant;

use rand::{RngExt as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use relativity_core::{
    Curves, FitOptions, Model, Observations, Passage, PublishedVariant, Sample, bootstrap, fit, fit_from,
};

const REPLICATES: usize = 1000;
const REPEATS: usize = 9;

fn main() {
    let case = common::Case { noise: 0.01, ..common::PAPER };
    println!("{} samples, {REPLICATES} replicates, {} threads", case.samples, rayon::current_num_threads());
    println!("model     curves x0     |  fit ms  bootstrap ms  both ms | naive bootstrap ms  ratio");
    for model in [Model::Exact, Model::Published(PublishedVariant::AppendixA)] {
        let samples = case.samples(model, 1);
        for curves in [Curves::Azimuth, Curves::Polar, Curves::Both] {
            for passage in [Passage::Known(0.0), Passage::Fitted] {
                row(
                    case.separation,
                    &samples,
                    &FitOptions { model, curves, passage, ..FitOptions::default() },
                );
            }
        }
    }
}

fn row(separation: f64, samples: &[Sample], options: &FitOptions) {
    let observations = Observations::of_pair(separation, samples.to_vec()).expect("usable samples");
    let best = fit(&observations, options).expect("a fit");
    let fit_ms = least_ms(REPEATS, || fit(&observations, options).expect("a fit"));
    let bootstrap_ms = least_ms(REPEATS, || bootstrap(&best, REPLICATES, 1).expect("replicates"));
    let naive_ms = least_ms(1, || naive(separation, samples, options, best.values));
    let x0 = if options.passage == Passage::Fitted { "fitted" } else { "known" };
    let sum = fit_ms + bootstrap_ms;
    println!(
        "{:9} {:6} {x0:6} | {fit_ms:7.2} {bootstrap_ms:13.1} {sum:8.1} | {naive_ms:18.0} {:6.1}",
        format!("{:?}", options.model),
        options.curves.name(),
        naive_ms / bootstrap_ms
    );
}

/// Refits resampled data one after the other, each from the original optimum.
fn naive(separation: f64, samples: &[Sample], options: &FitOptions, optimum: [f64; 4]) -> Vec<[f64; 4]> {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let mut replicate = || {
        let drawn = samples.iter().map(|_| samples[random.random_range(0..samples.len())]).collect();
        let observations = Observations::of_pair(separation, drawn).expect("usable samples");
        fit_from(&observations, options, optimum).map(|refit| refit.values)
    };
    (0..REPLICATES).filter_map(|_| replicate().ok()).collect()
}

/// Least time of `repeats` calls, in milliseconds: what the work costs when nothing else disturbs it.
fn least_ms<T>(repeats: usize, mut work: impl FnMut() -> T) -> f64 {
    let time = |_| {
        let start = Instant::now();
        black_box(work());
        start.elapsed().as_secs_f64() * 1e3
    };
    (0..repeats).map(time).fold(f64::INFINITY, f64::min)
}
