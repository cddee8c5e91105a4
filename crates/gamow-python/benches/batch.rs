//! Time of a million points by the batch forms that the Python package calls, without Python: `batch.py` sets
//! both beside each other.
//!
//! `cargo bench -p gamow-python --bench batch`. Prints milliseconds of processor time on all threads, the
//! best of several: the disparities of one point at a million times by the core, the same at a million
//! speeds, at one speed by the columns of the program, and everything that both eyes see. Other programs on
//! the machine change processor time least. It is Linux that tells it; elsewhere this needs a clock of its
//! own.

use std::fs;
use std::hint::black_box;

use csv::ByteRecord;
use gamow::columns::{Batch, Column, Header, ModelArgs, WantedColumns};
use relativity_core::batch::{self, DisparityColumns, ObservationColumns, Speeds, Threads};
use relativity_core::{Aperture, Model, Speed};

const ROWS: usize = 1_000_000;
const REPETITIONS: usize = 15;

fn main() {
    let times: Vec<f64> = (0..ROWS).map(|row| -20.0 + 40.0 * row as f64 / (ROWS - 1) as f64).collect();
    let betas: Vec<f64> = (0..ROWS).map(|row| row as f64 / ROWS as f64).collect();
    let speed = Speed::from_beta(0.9).expect("0.9 is a speed");
    println!("disparity {:.3}", best(disparities(Speeds::Same(speed), &times)));
    println!("speeds {:.3}", best(disparities(Speeds::Each(&betas), &times)));
    println!("columns {:.3}", best(columns(WantedColumns::Disparity, &times)));
    println!("sightings {:.3}", best(columns(WantedColumns::All, &times)));
}

/// Milliseconds of the fastest repetition of `work`.
fn best(mut work: impl FnMut()) -> f64 {
    let milliseconds = |_| {
        let start = processor_ms();
        work();
        processor_ms() - start
    };
    (0..REPETITIONS).map(milliseconds).fold(f64::INFINITY, f64::min)
}

/// Processor time of all threads so far, milliseconds: the first number of each one's `schedstat`, ns.
fn processor_ms() -> f64 {
    let threads = fs::read_dir("/proc/self/task").expect("this is Linux");
    let nanoseconds = threads.filter_map(|thread| {
        let text = fs::read_to_string(thread.ok()?.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse::<f64>().ok()
    });
    nanoseconds.sum::<f64>() / 1e6
}

fn disparities(speeds: Speeds<'_, f64>, times: &[f64]) -> impl FnMut() {
    let [mut dphi, mut dtheta] = [(); 2].map(|()| vec![0.0; ROWS]);
    move || {
        let out = DisparityColumns { dphi: &mut dphi, dtheta: &mut dtheta };
        // Unknown to the compiler, as they are to the program: it would work out beforehand what constants
        // decide.
        let observations = black_box(ObservationColumns {
            speeds,
            x0: Column::Same(0.0),
            y: Column::Same(3.0),
            z: Column::Same(2.0),
            times: Column::Each(times),
            apertures: Aperture::pair(0.1),
        });
        batch::disparities(&observations, out, Threads::All).expect("inside the domain");
        black_box((&dphi, &dtheta));
    }
}

fn columns(wanted: WantedColumns, times: &[f64]) -> impl FnMut() {
    let model = ModelArgs { model: Model::Exact, intensity_exponent: 4.0, stereo: false, conformal: false };
    let names = ByteRecord::from(vec!["beta", "d", "y", "z", "T"]);
    let header = Header::new(names, |_| Ok(Vec::new())).expect("all are there");
    let columns = wanted.columns(&model, header.given()).expect("no stereo").len();
    let mut out = vec![vec![0.0; ROWS]; columns];
    move || {
        let [beta, d, y, z] = [0.9, 0.1, 3.0, 2.0].map(Column::Same);
        let inputs = [beta, d, y, z, Column::Each(times)];
        let batch = Batch { header: &header, inputs: &inputs, rows: ROWS };
        let out = out.iter_mut().map(Vec::as_mut_slice).collect();
        batch.fill(wanted, &model, out).expect("inside the domain");
    }
}
