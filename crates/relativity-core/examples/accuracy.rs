//! Errors of the printed formulas (naive) and of this crate's stable forms, on the same inputs.
//!
//! `cargo run --release -p relativity-core --example accuracy -- [cases]`. Errors are in units of
//! `2^-53 (|f| + sum |x_i df/dx_i|)`, against 115-digit arithmetic, for inputs drawn towards trouble.

#[path = "../tests/oracle/arithmetic.rs"]
#[expect(dead_code, reason = "shared with the oracle tests, which use more of it")]
mod arithmetic;
#[path = "../tests/oracle/draw.rs"]
#[expect(dead_code, reason = "shared with the oracle tests, which use more of it")]
mod draw;
#[path = "../tests/oracle/model.rs"]
#[expect(dead_code, reason = "shared with the oracle tests, which use more of it")]
mod model;
#[path = "../tests/oracle/tally.rs"]
#[expect(dead_code, reason = "shared with the oracle tests, which use more of it")]
mod tally;

use arithmetic::{UNIT_F64, error_units};
use relativity_core::{Aperture, MAX_ERROR_UNITS, SourcePoint, Speed, disparity};
use tally::{Case, Tally};

/// Errors above this count as failures.
const FAILURE_UNITS: f64 = 16.0;
const NAMES: [&str; 5] = ["X", "t", "D", "dphi", "dtheta"];

fn main() {
    let cases = std::env::args().nth(1).map_or(2000, |n| n.parse().expect("the number of cases"));
    let both = Tally::new([""; 10], cases, |rng| {
        let (parameter, value) = draw::speed(rng);
        let speed = draw::program_speed(parameter, value);
        let [x0, y, z] = [(); 3].map(|()| draw::length(rng));
        let rho = y.hypot(z);
        let d = draw::separation(rng, rho);
        let time = draw::time(rng, speed.beta(), [x0, y, rho.hypot(d / 2.0)], UNIT_F64);
        let point = SourcePoint { x0, y, z };
        let inputs = vec![value, x0, y, z, time, d];
        let model = |inputs: &[_]| model::pair_views(parameter, inputs);
        let units = |computed| error_units(model, &inputs, computed, UNIT_F64, MAX_ERROR_UNITS);
        let errors = [units(stable(&speed, point, d, time)), units(naive(&speed, point, d, time))].concat();
        Case { errors: std::array::from_fn(|k| errors[k]), parameter, inputs }
    });
    println!(
        "{cases} cases; median, 99 % and worst error in units, and the share above {FAILURE_UNITS} units\n"
    );
    println!("{:8}{:>44}{:>44}", "", "stable", "naive");
    for (k, name) in NAMES.iter().enumerate() {
        println!("{name:8}{}{}", summary(&both.sorted(k)), summary(&both.sorted(k + NAMES.len())));
    }
}

fn summary(sorted: &[f64]) -> String {
    let count = sorted.len();
    let failures = count - sorted.partition_point(|&error| error <= FAILURE_UNITS);
    let share = 100.0 * failures as f64 / count as f64;
    format!(
        "{:10.2}{:12.3e}{:12.3e}{share:8.1} %",
        sorted[count / 2],
        sorted[count * 99 / 100],
        sorted[count - 1]
    )
}

/// X, t, D of the left eye, and both disparities.
fn stable(speed: &Speed, point: SourcePoint, d: f64, time: f64) -> [f64; 5] {
    let [left, right] = Aperture::pair(d);
    let both = disparity(speed, point, left, right, time).expect("inside the domain");
    let seen = both.primary;
    [seen.position[0], seen.retarded_time, seen.doppler_factor, both.dphi, both.dtheta]
}

/// The same by the formulas as printed.
fn naive(speed: &Speed, point: SourcePoint, d: f64, time: f64) -> [f64; 5] {
    let (beta, gamma) = (speed.beta(), speed.gamma());
    let view = |aperture: f64| {
        let s = point.x0 - aperture + beta * time;
        let rho_squared = point.y * point.y + point.z * point.z;
        let x = gamma * gamma * s - gamma * beta * (gamma * gamma * s * s + rho_squared).sqrt();
        let r = (x * x + rho_squared).sqrt();
        let doppler = 1.0 / (gamma * (1.0 + beta * x / r));
        (x, time - r, doppler, point.y.atan2(x), point.z.atan2(x.hypot(point.y)))
    };
    let (x, t, doppler, phi, theta) = view(-d / 2.0);
    let (.., right_phi, right_theta) = view(d / 2.0);
    [x, t, doppler, phi - right_phi, theta - right_theta]
}
