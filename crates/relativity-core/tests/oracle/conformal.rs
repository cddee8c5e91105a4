//! Conformal coordinates and their disparities.

use std::f64::consts::PI;

use rand::RngExt as _;
use rand_chacha::ChaCha8Rng;
use relativity_core::{Aperture, Baseline, Conformal, MAX_ERROR_UNITS, Model, sighting};

use crate::tally::Tally;
use crate::{aperture_at, case, cases, draw, model, pair_inputs, point_at, sighting_inputs};

/// Roll and turn of a head: level, nearly so, or anything.
fn head(rng: &mut ChaCha8Rng) -> [f64; 2] {
    [(); 2].map(|()| match rng.random_range(0..3) {
        0 => 0.0,
        1 => draw::log_uniform(rng, -12.0, 0.0),
        _ => rng.random_range(-0.5 * PI..0.5 * PI),
    })
}

#[test]
fn conformal_coordinates_of_any_head_keep_their_digits() {
    Tally::new(["u", "v"], cases(), |rng| {
        loop {
            let (parameter, speed, mut inputs) = sighting_inputs(rng);
            let seen = sighting(&speed, point_at(&inputs[1..]), aperture_at(&inputs[4..]), inputs[7])
                .expect("inside the domain");
            let [roll, turn] = head(rng);
            inputs.extend([roll, turn]);
            let axes = Baseline { roll, turn, ..Baseline::straight(0.0) }.axes();
            // What is on the baseline is drawn again.
            let Some(seen) = axes.conformal(seen.position) else { continue };
            return case(
                parameter,
                inputs,
                |inputs| model::conformal_view(parameter, inputs),
                [seen.u, seen.v],
            );
        }
    })
    .assert_within(MAX_ERROR_UNITS);
}

#[test]
fn conformal_disparities_of_the_papers_pair_keep_their_digits_however_close_the_apertures() {
    Tally::new(["du"], cases(), |rng| {
        loop {
            let (parameter, speed, inputs) = pair_inputs(rng);
            let head = Baseline::straight(inputs[5]);
            let both = Model::Exact
                .conformal(&speed, point_at(&inputs[1..]), head.apertures(), &head.axes(), inputs[4])
                .expect("inside the domain");
            let Some(both) = both else { continue };
            assert_eq!(both.dv, 0.0);
            return case(
                parameter,
                inputs,
                |inputs| model::conformal_disparity(parameter, inputs),
                [both.du],
            );
        }
    })
    .assert_within(MAX_ERROR_UNITS)
    .assert_as_documented(include_str!("../../src/conformal.rs"), &["du"]);
}

/// From the baseline itself places are known to the rounding of the apertures alone: what is nearer to it
/// than this is drawn again.
const LEAST_OFF_BASELINE: f64 = 1e-3;

#[test]
fn conformal_disparities_of_any_head_keep_their_digits() {
    Tally::new(["any du", "any dv"], cases() / 4, |rng| {
        loop {
            let (parameter, speed, inputs) = pair_inputs(rng);
            let [roll, turn] = head(rng);
            let head = Baseline { separation: inputs[5], roll, turn };
            let pair = head.apertures();
            let both = Model::Exact
                .conformal(&speed, point_at(&inputs[1..]), pair, &head.axes(), inputs[4])
                .expect("inside the domain");
            let is_off = |of: &Conformal| of.u.cosh() < 1.0 / LEAST_OFF_BASELINE;
            let Some(both) = both.filter(|both| is_off(&both.primary) && is_off(&both.secondary)) else {
                continue;
            };
            let apertures = pair.map(|Aperture { x, y, z }| [x, y, z]);
            let inputs = [&inputs[..5], apertures.as_flattened(), &[roll, turn]].concat();
            let model = |inputs: &[_]| model::conformal_disparity_of_head(parameter, inputs);
            return case(parameter, inputs, model, [both.du, both.dv]);
        }
    })
    .assert_within(MAX_ERROR_UNITS);
}
