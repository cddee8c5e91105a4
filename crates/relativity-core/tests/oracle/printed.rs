//! The formulas as the literature prints them, on the inputs of the other tests: how often they lose more
//! than four bits of what the inputs permit. They do in 28 % of X, t and D, and in 68 % of the disparities.

use crate::tally::Tally;
use crate::{case, cases, model, pair_inputs};

/// The loss of four bits, in units of what the inputs permit.
const LOSS_UNITS: f64 = 16.0;
/// Shares that lose more, percent, as the head of this file states them: of X, t and D, and of dphi and
/// dtheta.
const STATED: [f64; 2] = [28.0, 68.0];
/// Three standard errors of a share of 600 cases, percent.
const UNCERTAIN: f64 = 6.0;

#[test]
fn the_printed_formulas_lose_digits_as_often_as_is_stated() {
    let names = ["X", "t", "D", "dphi", "dtheta"];
    let tally = Tally::new(names, cases(), |rng| {
        let (parameter, speed, inputs) = pair_inputs(rng);
        let model = |inputs: &[_]| model::pair_views(parameter, inputs);
        let computed = printed(speed.beta(), speed.gamma(), &inputs);
        case(parameter, inputs, model, computed)
    });
    let shares: Vec<f64> = (0..names.len())
        .map(|k| {
            let errors = tally.sorted(k);
            let kept = errors.partition_point(|&error| error <= LOSS_UNITS);
            100.0 - 100.0 * kept as f64 / errors.len() as f64
        })
        .collect();
    println!("lost more than {LOSS_UNITS} units, %: {names:?} {shares:.1?}");
    for (shares, stated) in [&shares[..3], &shares[3..]].into_iter().zip(STATED) {
        let mean = shares.iter().sum::<f64>() / shares.len() as f64;
        assert!((mean - stated).abs() < UNCERTAIN, "{mean} %, stated {stated} %");
    }
}

/// X, t and D of the left eye, and both disparities; `inputs`: speed parameter, x0, y, z, T, d.
fn printed(beta: f64, gamma: f64, inputs: &[f64]) -> [f64; 5] {
    let &[_, x0, y, z, time, d] = inputs else { panic!("six inputs") };
    let view = |aperture: f64| {
        let s = x0 - aperture + beta * time;
        let rho_squared = y * y + z * z;
        let x = gamma * gamma * s - gamma * beta * (gamma * gamma * s * s + rho_squared).sqrt();
        let r = (x * x + rho_squared).sqrt();
        let doppler = 1.0 / (gamma * (1.0 + beta * x / r));
        (x, time - r, doppler, y.atan2(x), z.atan2(x.hypot(y)))
    };
    let (x, t, doppler, phi, theta) = view(-d / 2.0);
    let (.., right_phi, right_theta) = view(d / 2.0);
    [x, t, doppler, phi - right_phi, theta - right_theta]
}
