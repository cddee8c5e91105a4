//! Errors of lines of sight, arcseconds: of the forms of the formulas, and of the published binocular model.
//!
//! The stable form in f64 is the truth here: the crate's tests hold it to 8 units of 2^-53 against 115-digit
//! arithmetic, far below what is measured.

use std::hint::black_box;
use std::time::Instant;

use relativity_core::batch::{PointColumns, Real, SightingColumns, Threads, sightings_of_points};
use relativity_core::{Aperture, Model, PublishedVariant, SourcePoint, Speed, observation_time_when_seen_at};

use crate::printed;

const POINTS: usize = 1024;
/// Middle of the box that holds the points, in the rest frame: the front tyre of the paper's cyclist.
const MIDDLE: [f64; 3] = [0.0, 3.0, 2.0];
/// Half the width of the box.
const REACH: f64 = 1.5;
/// Distance between the eyes; points are sighted from the left one.
const SEPARATION: f64 = 0.1;
/// Speeds that f32 has too, so that their rounding is nobody's error; the last is about the greatest for
/// batches in f32.
const BETAS: [f32; 4] = [0.0, 0.9, 0.9999, 0.999_999_46];
/// Lorentz factors for batches in f64 alone.
const GAMMAS: [f64; 2] = [1e5, 1e7];
/// Places at which the middle is seen, as its x over its distance from the eyes as it passes.
const PLACES: [(&str, f64); 3] = [("approaching", -3.0), ("abreast", 0.0), ("receding", 3.0)];
/// Timed runs of a model.
const RUNS: u32 = 5;
const ARCSECONDS: f64 = 3600.0 * 180.0 / std::f64::consts::PI;

/// Prints the worst error of each form over gamma.
pub fn print_forms() {
    let speeds: Vec<_> = speeds().collect();
    println!("\nworst error of lines of sight, arcseconds, against the stable form in f64");
    print_row("gamma", speeds.iter().map(|speed| format!("{:.1}", speed.gamma())));
    let row = |name, max_gamma: f64, form: fn(&Sight) -> Vec<f64>| {
        let worst = |speed: &Speed| {
            let worst = |(_, ratio)| Sight::new(*speed, ratio).worst_arcseconds(form);
            PLACES.map(worst).into_iter().fold(0.0, f64::max)
        };
        let cell = |speed: &Speed| {
            if speed.gamma() <= max_gamma { format!("{:.1e}", worst(speed)) } else { "-".to_owned() }
        };
        print_row(name, speeds.iter().map(cell));
    };
    row("stable f32", <f32 as Real>::MAX_GAMMA, Sight::stable::<f32>);
    row("printed f64", <f64 as Real>::MAX_GAMMA, Sight::printed::<f64>);
    row("printed f32", <f32 as Real>::MAX_GAMMA, Sight::printed::<f32>);
}

/// Prints the median error of the right eye's lines of sight by the published model, and its cost.
pub fn print_published() {
    let speeds: Vec<_> = speeds().collect();
    println!("\nmedian error of the right eye's line of sight by the published model, arcseconds");
    print_row("gamma", speeds.iter().map(|speed| format!("{:.1}", speed.gamma())));
    let mut costs = Vec::new();
    for (place, ratio) in PLACES {
        let error = |speed: &Speed| {
            let sight = Sight::new(*speed, ratio);
            let (exact, exact_ns) = sight.right_eye(Model::Exact);
            let (published, published_ns) = sight.right_eye(Model::Published(PublishedVariant::AppendixA));
            costs.push(published_ns / exact_ns);
            let pairs = exact.into_iter().zip(published);
            format!("{:.0}", median(pairs.map(|(exact, published)| angle(exact, published)).collect()))
        };
        print_row(place, speeds.iter().map(error));
    }
    println!("cost of a disparity: {:.2} of the exact one's", median(costs));
}

fn print_row(name: &str, cells: impl Iterator<Item = String>) {
    print!("{name:12}");
    cells.for_each(|cell| print!("{cell:>12}"));
    println!();
}

fn speeds() -> impl Iterator<Item = Speed> {
    let slow = BETAS.map(|beta| Speed::from_beta(beta.into()));
    slow.into_iter().chain(GAMMAS.map(Speed::from_gamma)).map(|speed| speed.expect("it is a speed"))
}

/// Points around the middle, which is seen at one of the places; all numbers are numbers of f32.
struct Sight {
    speed: Speed,
    time: f64,
    points: [Vec<f64>; 3],
}

impl Sight {
    fn new(speed: Speed, ratio: f64) -> Self {
        let [_, y, z] = MIDDLE;
        let middle = SourcePoint::from_rest(MIDDLE, &speed);
        let time = observation_time_when_seen_at(&speed, middle, ratio * y.hypot(z), Aperture::pair(0.0));
        // At rest it is nowhere else.
        let time = time.expect("inside the domain").unwrap_or(0.0);
        // Spread evenly, by the golden ratio and its kin.
        let coordinate = |axis: usize, i: usize| {
            let step = [0.819_172_5, 0.671_043_6, 0.549_700_5][axis];
            let rest = MIDDLE[axis] + ((i as f64 * step).fract() - 0.5) * 2.0 * REACH;
            f64::from(if axis == 0 { rest / speed.gamma() } else { rest } as f32)
        };
        let points = std::array::from_fn(|axis| (0..POINTS).map(|i| coordinate(axis, i)).collect());
        Self { speed, time: f64::from(time as f32), points }
    }

    /// The greatest error of a form that gives these apparent X.
    fn worst_arcseconds(&self, apparent_x: fn(&Self) -> Vec<f64>) -> f64 {
        let [_, y, z] = &self.points;
        let pairs = self.stable::<f64>().into_iter().zip(apparent_x(self)).enumerate();
        let errors = pairs.map(|(i, (true_x, x))| angle([true_x, y[i], z[i]], [x, y[i], z[i]]));
        // Where a form breaks down altogether (0/0), its line of sight is as wrong as can be.
        errors.map(|error| if error.is_nan() { 180.0 * 3600.0 } else { error }).fold(0.0, f64::max)
    }

    /// Apparent X by the batch form.
    fn stable<F: Real>(&self) -> Vec<f64> {
        let [x0, y, z] = &self.columns::<F>();
        let [mut x, mut t, mut d] = [(); 3].map(|()| vec![F::zero(); POINTS]);
        let out = SightingColumns { apparent_x: &mut x, retarded_time: &mut t, doppler_factor: &mut d };
        let points = PointColumns { x0, y, z };
        sightings_of_points(&self.speed, points, left(), rounded(self.time), out, Threads::One)
            .expect("inside the domain");
        x.into_iter().map(Into::into).collect()
    }

    /// Apparent X as printed.
    fn printed<F: Real>(&self) -> Vec<f64> {
        let columns = self.columns::<F>();
        let mut outputs = [(); 3].map(|()| vec![F::zero(); POINTS]);
        let [beta, time, aperture_x] = [self.speed.beta(), self.time, left().x].map(rounded);
        let inputs = columns.each_ref().map(Vec::as_slice);
        printed::sightings(beta, time, aperture_x, inputs, outputs.each_mut().map(Vec::as_mut_slice));
        let [x, ..] = outputs;
        x.into_iter().map(Into::into).collect()
    }

    fn columns<F: Real>(&self) -> [Vec<F>; 3] {
        self.points.each_ref().map(|column| column.iter().copied().map(rounded).collect())
    }

    /// Returns the positions at which a model has the right eye see the points, and nanoseconds per point,
    /// the least of several.
    fn right_eye(&self, model: Model) -> (Vec<[f64; 3]>, f64) {
        let [x0, y, z] = &self.points;
        let position = |i: usize| {
            let point = SourcePoint { x0: x0[i], y: y[i], z: z[i] };
            let disparity = model.disparity(&self.speed, point, Aperture::pair(SEPARATION), self.time);
            disparity.expect("inside the domain").secondary.position
        };
        let timed = |_| {
            let start = Instant::now();
            let positions: Vec<_> = black_box((0..POINTS).map(position).collect());
            (positions, start.elapsed().as_secs_f64() * 1e9 / POINTS as f64)
        };
        (0..RUNS).map(timed).min_by(|(_, a), (_, b)| a.total_cmp(b)).expect("there are runs")
    }
}

/// The left eye, at numbers of f32.
fn left() -> Aperture {
    Aperture { x: f64::from((-0.5 * SEPARATION) as f32), ..Aperture::default() }
}

fn rounded<F: Real>(value: f64) -> F {
    F::from(value).expect("f64 converts to any float")
}

/// The angle between two directions, arcseconds: accurate also where it is tiny.
fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let [[ax, ay, az], [bx, by, bz]] = [a, b];
    let cross = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
    let sine = cross.map(|part| part * part).into_iter().sum::<f64>().sqrt();
    ARCSECONDS * sine.atan2(ax * bx + ay * by + az * bz)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
