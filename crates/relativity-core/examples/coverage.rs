//! How often the 95 % intervals of a fit hold the truth: the table of `docs/accuracy.md`.
//!
//! ```text
//! cargo run --release -p relativity-core --example coverage -- 200
//! ```
//!
//! Each row has this many sets of readings with normal noise, of points at 0.3 to 0.95 c, y of 1 to 5 and |z|
//! of 0.3 to 4; a set whose fit is refused counts for nothing. A share of 200 is off by chance by up to 0.03.

#[path = "../tests/common/mod.rs"]
mod common;

use std::env;

use common::{Case, PAPER};
use rand::{RngExt as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use relativity_core::{Curves, FitOptions, Model, Parameter, Passage, bootstrap, fit};

/// Replicates of each set.
const REPLICATES: usize = 1000;

fn main() {
    let sets = env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(200);
    println!("| curves | x0 | readings of a curve | noise | fits | beta | y | z | x0 |");
    println!("|---|---|---|---|---|---|---|---|---|");
    for curves in [Curves::Azimuth, Curves::Polar, Curves::Both] {
        for passage in [Passage::Known(0.0), Passage::Fitted] {
            for (samples, noise) in [(20, 0.003), (41, 0.003), (41, 0.02), (240, 0.01)] {
                row(sets, &FitOptions { curves, passage, ..FitOptions::default() }, samples, noise);
            }
        }
    }
}

/// Counts `sets` of so many `samples` with this noise, a share of each curve's range.
fn row(sets: u64, options: &FitOptions, samples: usize, noise: f64) {
    let (mut fits, mut held) = (0_u32, [0_u32; 4]);
    let first = 100_000 * samples as u64 + (1e7 * noise) as u64;
    for seed in first..first + sets {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let [beta, y, height] = [0.3..0.95, 1.0..5.0, 0.3..4.0].map(|range| random.random_range(range));
        let z = if random.random_bool(0.5) { height } else { -height };
        let case = Case { beta, y, z, samples, noise, ..PAPER };
        let Ok(best) = fit(&case.observations(Model::Exact, seed), options) else { continue };
        let Ok(replicates) = bootstrap(&best, REPLICATES, seed) else { continue };
        fits += 1;
        let truth = if options.curves == Curves::Azimuth { [beta, y, height, 0.0] } else { case.truth() };
        for &parameter in best.parameters() {
            let [low, high] = replicates.interval_95(parameter);
            let index = parameter as usize;
            held[index] += u32::from((low..=high).contains(&truth[index]));
        }
    }
    let share = |parameter: Parameter| {
        let is_fitted = parameter != Parameter::X0 || options.passage == Passage::Fitted;
        let share = f64::from(held[parameter as usize]) / f64::from(fits.max(1));
        if is_fitted { format!("{share:.3}") } else { String::new() }
    };
    let (curves, passage) =
        (options.curves.name(), if options.passage == Passage::Fitted { "fitted" } else { "known" });
    let shares = Parameter::ALL.map(share).join(" | ");
    println!("| {curves} | {passage} | {samples} | {} % | {fits} | {shares} |", 100.0 * noise);
}
