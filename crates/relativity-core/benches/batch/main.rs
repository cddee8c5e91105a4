//! The formulas in their stable form and as printed: time per point, and error over gamma; then the published
//! binocular model against the exact one.
//!
//! `cargo bench -p relativity-core --bench batch`. Times are those of the batch forms, and of a copy of the
//! same bytes, all in one run, since only ratios carry over between machines. The printed formulas lose
//! digits; they are here to show how many, and what keeping them costs.

mod errors;
mod printed;

use std::hint::black_box;
use std::time::Instant;

use num_traits::Float;
use relativity_core::batch::{PointColumns, Real, SightingColumns, Threads, sightings_of_points};
use relativity_core::{Aperture, Speed};

const MANY: usize = 10_000_000;
const IN_CACHE: usize = 1024;
const REPETITIONS: usize = 7;
const BETA: f64 = 0.9;
const TIME: f64 = 1.5;
const APERTURE: Aperture = Aperture { x: -0.05, y: 0.0, z: 0.0 };

fn main() {
    println!(
        "ns per point, the best of {REPETITIONS}; ratios to the printed form and to a copy of the same bytes\n"
    );
    println!(
        "{:8}{:>10}{:>12}{:>8}{:>9}{:>8}{:>11}{:>8}",
        "", "points", "threads", "stable", "printed", "copy", "/ printed", "/ copy"
    );
    for rows in [MANY, IN_CACHE] {
        bench::<f64>("f64", rows, Threads::One);
        bench::<f32>("f32", rows, Threads::One);
    }
    bench::<f64>("f64", MANY, Threads::All);
    bench::<f32>("f32", MANY, Threads::All);
    errors::print_forms();
    errors::print_published();
}

struct Table<F> {
    inputs: [Vec<F>; 3],
    outputs: [Vec<F>; 3],
}

fn bench<F: Real>(name: &str, rows: usize, threads: Threads) {
    let to = |v: f64| F::from(v).expect("f64 converts to any float");
    let coordinate = |i: usize, step: f64| to(((i as f64 * step).fract() - 0.5) * 20.0);
    let inputs =
        [0.618_034, 0.324_718, 0.220_744].map(|step| (0..rows).map(|i| coordinate(i, step)).collect());
    let mut table = Table { inputs, outputs: [(); 3].map(|()| vec![F::zero(); rows]) };
    let speed = Speed::from_beta(BETA).expect("it is a speed");
    let stable = best(rows, || stable(&speed, &mut table, threads));
    let printed = best(rows, || printed(&mut table));
    let copy = best(rows, || copy(&mut table));
    let label = format!("{threads:?}");
    println!(
        "{name:8}{rows:>10}{label:>12}{stable:8.2}{printed:9.2}{copy:8.2}{:11.2}{:8.2}",
        stable / printed,
        stable / copy
    );
}

/// Nanoseconds per row of the fastest repetition.
fn best(rows: usize, mut work: impl FnMut()) -> f64 {
    let passes = (200_000 / rows).max(1);
    let nanoseconds = |_| {
        let start = Instant::now();
        (0..passes).for_each(|_| work());
        start.elapsed().as_secs_f64() * 1e9 / (rows * passes) as f64
    };
    (0..REPETITIONS).map(nanoseconds).fold(f64::INFINITY, f64::min)
}

#[inline(never)]
fn stable<F: Real>(speed: &Speed, table: &mut Table<F>, threads: Threads) {
    let [x0, y, z] = &table.inputs;
    let [apparent_x, retarded_time, doppler_factor] = &mut table.outputs;
    let out = SightingColumns { apparent_x, retarded_time, doppler_factor };
    let time = F::from(TIME).expect("f64 converts to any float");
    sightings_of_points(speed, PointColumns { x0, y, z }, APERTURE, time, out, threads)
        .expect("inside the domain");
    black_box(&table.outputs);
}

fn printed<F: Float>(table: &mut Table<F>) {
    let to = |v: f64| F::from(v).expect("f64 converts to any float");
    let inputs = table.inputs.each_ref().map(Vec::as_slice);
    let outputs = table.outputs.each_mut().map(Vec::as_mut_slice);
    printed::sightings(to(BETA), to(TIME), to(APERTURE.x), inputs, outputs);
    black_box(&table.outputs);
}

#[inline(never)]
fn copy<F: Float>(table: &mut Table<F>) {
    for (to, from) in table.outputs.iter_mut().zip(&table.inputs) {
        to.copy_from_slice(from);
    }
    black_box(&table.outputs);
}
