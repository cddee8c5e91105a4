//! The batch forms: in f64 the scalar functions bit by bit, in f32 against the oracle.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use relativity_core::batch::{
    Column, DisparityColumns, ObservationColumns, PointColumns, SightingColumns, Speeds, Threads,
    disparities, sightings_of_points,
};
use relativity_core::{Aperture, MAX_ERROR_UNITS, SourcePoint, Speed, disparity, sighting};

use crate::arithmetic::{UNIT_F32, error_units};
use crate::draw::{self, program_speed};
use crate::model;
use crate::tally::{Case, Tally};

/// More than one chunk, and not a multiple of anything.
const ROWS: usize = 10_007;

fn bits<const N: usize>(values: [f64; N]) -> [u64; N] {
    values.map(f64::to_bits)
}

fn speeds() -> [Speed; 4] {
    [(1e-14, false), (0.9, false), (7.0, true), (1e12, true)].map(|(value, is_gamma)| {
        if is_gamma { Speed::from_gamma(value) } else { Speed::from_beta(value) }.expect("a speed")
    })
}

#[test]
fn f64_columns_of_points_equal_the_scalar_function() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let [x0, y, z] = [(); 3].map(|()| (0..ROWS).map(|_| draw::length(&mut rng)).collect::<Vec<_>>());
    let aperture = Aperture { x: -0.05, y: 0.25, z: 1.5 };
    for (speed, threads) in speeds().into_iter().zip([Threads::One, Threads::All, Threads::One, Threads::All])
    {
        let [mut x, mut t, mut d] = [(); 3].map(|()| vec![f64::NAN; ROWS]);
        let out = SightingColumns { apparent_x: &mut x, retarded_time: &mut t, doppler_factor: &mut d };
        let points = PointColumns { x0: &x0, y: &y, z: &z };
        sightings_of_points(&speed, points, aperture, 1.5, out, threads).expect("inside the domain");
        for i in 0..ROWS {
            let point = SourcePoint { x0: x0[i], y: y[i], z: z[i] };
            let seen = sighting(&speed, point, aperture, 1.5).expect("inside the domain");
            let expected = [seen.position[0], seen.retarded_time, seen.doppler_factor];
            assert_eq!(bits([x[i], t[i], d[i]]), bits(expected), "{point:?}");
        }
    }
    let mut none = [0.0; 0];
    let out =
        SightingColumns { apparent_x: &mut none, retarded_time: &mut [0.0], doppler_factor: &mut [0.0] };
    let points = PointColumns { x0: &[0.0], y: &[3.0], z: &[2.0] };
    let error = sightings_of_points(&Speed::REST, points, aperture, 0.0, out, Threads::One);
    assert_eq!(error.expect_err("short").to_string(), "column apparent_x has 0 rows instead of 1");
}

#[test]
fn f64_disparities_of_observations_equal_the_scalar_function() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let [x0, y, z, times] = [(); 4].map(|()| (0..ROWS).map(|_| draw::length(&mut rng)).collect::<Vec<_>>());
    let betas: Vec<f64> =
        (0..ROWS).map(|row| [0.0, -0.0, 1e-14, 0.755, 1.0 - f64::EPSILON][row % 5]).collect();
    let apertures = Aperture::pair(0.1);
    let [same, each] = [[0.5, 3.0, 2.0].map(Column::Same), [&x0, &y, &z].map(|all| Column::Each(all))];
    let speeds = speeds().map(Speeds::Same).into_iter().chain([Speeds::Each(&betas)]);
    for (speeds, places) in speeds.flat_map(|speeds| [(speeds, same), (speeds, each)]) {
        let ([x0, y, z], times) = (places, Column::Each(&times));
        let observations = ObservationColumns { speeds, x0, y, z, times, apertures };
        for threads in [Threads::One, Threads::All] {
            let [mut dphi, mut dtheta] = [(); 2].map(|()| vec![f64::NAN; ROWS]);
            let out = DisparityColumns { dphi: &mut dphi, dtheta: &mut dtheta };
            disparities(&observations, out, threads).expect("inside the domain");
            for i in 0..ROWS {
                let speed = match speeds {
                    Speeds::Same(speed) => speed,
                    Speeds::Each(betas) => Speed::from_beta(betas[i]).expect("a speed"),
                };
                let (point, time) = (SourcePoint { x0: x0.at(i), y: y.at(i), z: z.at(i) }, times.at(i));
                let both =
                    disparity(&speed, point, apertures[0], apertures[1], time).expect("inside the domain");
                let expected = bits([both.dphi, both.dtheta]);
                assert_eq!(bits([dphi[i], dtheta[i]]), expected, "{speed:?} {point:?} at T = {time}");
            }
        }
    }
}

#[test]
fn the_first_row_outside_the_domain_is_named() {
    let wrong = |betas: [f64; 3], y: [f64; 3]| {
        let observations = ObservationColumns {
            speeds: Speeds::Each(&betas),
            x0: Column::Same(0.0),
            y: Column::Each(&y),
            z: Column::Same(1.0),
            times: Column::Same(0.0),
            apertures: Aperture::pair(0.1),
        };
        let [mut dphi, mut dtheta] = [[0.0; 3]; 2];
        let out = DisparityColumns { dphi: &mut dphi, dtheta: &mut dtheta };
        disparities(&observations, out, Threads::One).map_err(|error| error.to_string())
    };
    assert_eq!(wrong([0.0, 0.5, 0.9], [1.0; 3]), Ok(()));
    let beta = "row 1: beta = 1 is out of range: it must be at least 0 and below 1";
    assert_eq!(wrong([0.0, 1.0, 0.9], [1.0; 3]), Err(beta.into()));
    assert_eq!(wrong([0.0, 1.0, 0.9], [1.0, 1.0, f64::NAN]), Err(beta.into()));
    for beta in [-0.5, f64::NAN, f64::INFINITY] {
        assert!(wrong([0.0, 0.5, beta], [1.0; 3]).expect_err("no speed").starts_with("row 2: beta = "));
    }
    let y = "row 0: y = NaN is not a number between";
    assert!(wrong([0.0, 1.0, 0.9], [f64::NAN, 1.0, 1.0]).expect_err("no place").starts_with(y));
}

/// Returns the f64 of a single f32 number.
fn single(value: f64) -> f64 {
    f64::from(value as f32)
}

#[test]
fn f32_sightings_are_as_accurate_as_f32_inputs() {
    Tally::new(["f32 X", "f32 t", "f32 D"], crate::cases(), |rng| {
        let (parameter, value) = draw::slower_speed(rng);
        let speed = program_speed(parameter, value);
        let at: [f64; 6] = std::array::from_fn(|_| single(draw::length(rng)));
        let rho = (at[1] - at[4]).hypot(at[2] - at[5]);
        let time = single(draw::time(rng, speed.beta(), [at[0] - at[3], at[1] - at[4], rho], UNIT_F32));
        let aperture = Aperture { x: at[3], y: at[4], z: at[5] };
        let [mut x, mut t, mut d] = [[f32::NAN]; 3];
        let points = PointColumns { x0: &[at[0] as f32], y: &[at[1] as f32], z: &[at[2] as f32] };
        let out = SightingColumns { apparent_x: &mut x, retarded_time: &mut t, doppler_factor: &mut d };
        sightings_of_points(&speed, points, aperture, time as f32, out, Threads::One)
            .expect("inside the domain");
        let inputs = [&[value], &at[..], &[time]].concat();
        let model = |inputs: &[_]| {
            let [x, t, _, _, d, ..] =
                model::sighting(parameter, &[inputs, &[crate::arithmetic::big(1.0)]].concat());
            [x, t, d]
        };
        let computed = [x[0].into(), t[0].into(), d[0].into()];
        let errors = error_units(model, &inputs, computed, UNIT_F32, MAX_ERROR_UNITS);
        Case { errors, parameter, inputs }
    })
    .assert_within(MAX_ERROR_UNITS);
}

#[test]
fn f32_disparities_are_as_accurate_as_f32_inputs() {
    Tally::new(["f32 dphi", "f32 dtheta"], crate::cases(), |rng| {
        let (parameter, value) = draw::slower_speed(rng);
        let speed = program_speed(parameter, value);
        let [x0, y, z]: [f64; 3] = std::array::from_fn(|_| single(draw::ordinary_length(rng)));
        let d = single(draw::separation(rng, y.hypot(z)));
        let time = single(draw::time(rng, speed.beta(), [x0, y, y.hypot(z).hypot(d / 2.0)], UNIT_F32));
        let [mut dphi, mut dtheta] = [[f32::NAN]; 2];
        let out = DisparityColumns { dphi: &mut dphi, dtheta: &mut dtheta };
        let [x, y_, z_, times] = [x0, y, z, time].map(|value| Column::Same(value as f32));
        let (speeds, apertures) = (Speeds::Same(speed), Aperture::pair(d));
        let observations = ObservationColumns { speeds, x0: x, y: y_, z: z_, times, apertures };
        disparities(&observations, out, Threads::One).expect("inside the domain");
        let inputs = vec![value, x0, y, z, time, d];
        let computed = [dphi[0].into(), dtheta[0].into()];
        let model = |inputs: &[_]| model::pair_disparity(parameter, inputs);
        let errors = error_units(model, &inputs, computed, UNIT_F32, MAX_ERROR_UNITS);
        Case { errors, parameter, inputs }
    })
    .assert_within(MAX_ERROR_UNITS);
}
