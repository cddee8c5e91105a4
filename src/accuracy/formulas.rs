//! The formulas for one point: precision and form against cost and error.
//!
//! The core's stable form in f64 is the truth here: its tests hold it to 8 units of 2^-53 against 115-digit
//! arithmetic, far below what is measured.

use std::fmt;
use std::hint::black_box;

use gamow_platform::clock::Instant;
use glam::DVec3;
use relativity_core::batch::{BatchError, PointColumns, Real, SightingColumns, Threads, sightings_of_points};
use relativity_core::{Aperture, SourcePoint, Speed};

use super::difference::{ARCSECONDS, angle};
use super::spread::Spread;
use super::views::TrackedPlace;

/// Points in a batch: few enough for a core's cache, so that arithmetic is timed and not memory.
const POINTS: usize = 1024;
/// Least time of one timed run.
const RUN_MS: f64 = 2.0;
/// Half the width of the box around the tracked point that holds the points, in the rest frame.
const REACH: f64 = 1.5;

/// A form of the light-cone solution, in a precision.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ConeFormula {
    /// The core's, in f64.
    StableF64,
    /// The core's, in f32.
    StableF32,
    /// The literature's form, in f64.
    NaiveF64,
    /// The literature's form, in f32.
    NaiveF32,
}

impl ConeFormula {
    /// Every form and precision.
    pub const ALL: [Self; 4] = [Self::StableF64, Self::StableF32, Self::NaiveF64, Self::NaiveF32];

    /// Largest Lorentz factor that the form is meant for.
    #[must_use]
    pub const fn max_gamma(self) -> f64 {
        match self {
            Self::StableF64 | Self::NaiveF64 => <f64 as Real>::MAX_GAMMA,
            Self::StableF32 | Self::NaiveF32 => <f32 as Real>::MAX_GAMMA,
        }
    }
}

impl fmt::Display for ConeFormula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::StableF64 => "stable f64",
            Self::StableF32 => "stable f32",
            Self::NaiveF64 => "naive f64",
            Self::NaiveF32 => "naive f32",
        })
    }
}

/// Cost and error of a formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FormulaAccuracy {
    /// Nanoseconds per point, one thread.
    pub point_ns: f64,
    /// Angle between the lines of sight, arcseconds.
    pub line_of_sight_arcseconds: Option<Spread>,
    /// Relative error of the Doppler factor.
    pub doppler_relative: Option<Spread>,
}

/// Measures `formula` for an aperture at (`aperture_x`, 0, 0) that sees points around the rest-frame point
/// `tracked`, itself seen at `place`.
///
/// All inputs are rounded to numbers that f32 has too, so that their rounding is nobody's error; the speed where
/// f32 is meant for it.
///
/// # Errors
///
/// Points outside the domain of the core.
pub fn formula_error(
    formula: ConeFormula,
    speed: &Speed,
    place: TrackedPlace,
    tracked: [f64; 3],
    aperture_x: f64,
) -> Result<FormulaAccuracy, BatchError> {
    let speed = &rounded_down(speed);
    let time = place.observation_time(speed, SourcePoint::from_rest(tracked, speed));
    let batch = FormulaBatch {
        speed: *speed,
        points: points(tracked, speed),
        aperture_x: f64::from(aperture_x as f32),
        time: f64::from(time as f32),
    };
    let (truth, _) = batch.stable::<f64>()?;
    let (seen, point_ns) = match formula {
        ConeFormula::StableF64 => batch.stable::<f64>()?,
        ConeFormula::StableF32 => batch.stable::<f32>()?,
        ConeFormula::NaiveF64 => batch.naive::<f64>(),
        ConeFormula::NaiveF32 => batch.naive::<f32>(),
    };
    Ok(batch.error(&truth, &seen, point_ns))
}

/// The next lower speed that f32 can express as beta; the same where that is beyond f32.
fn rounded_down(speed: &Speed) -> Speed {
    if speed.gamma() > <f32 as Real>::MAX_GAMMA {
        return *speed;
    }
    let nearest = speed.beta() as f32;
    let below = if f64::from(nearest) > speed.beta() { nearest.next_down() } else { nearest };
    Speed::from_beta(below.into()).unwrap_or(*speed)
}

/// x0, y, z of points spread evenly (golden ratio and its kin) over a box around `tracked`.
fn points(tracked: [f64; 3], speed: &Speed) -> [Vec<f64>; 3] {
    let coordinate = |axis: usize, i: usize| {
        let step = [0.819_172_5, 0.671_043_6, 0.549_700_5][axis];
        let rest = tracked[axis] + ((i as f64 * step).fract() - 0.5) * 2.0 * REACH;
        f64::from(if axis == 0 { rest / speed.gamma() } else { rest } as f32)
    };
    std::array::from_fn(|axis| (0..POINTS).map(|i| coordinate(axis, i)).collect())
}

/// Apparent X and Doppler factor of every point.
struct SeenPoints {
    apparent_x: Vec<f64>,
    doppler_factor: Vec<f64>,
}

struct FormulaBatch {
    speed: Speed,
    points: [Vec<f64>; 3],
    aperture_x: f64,
    time: f64,
}

impl FormulaBatch {
    fn stable<F: Precision>(&self) -> Result<(SeenPoints, f64), BatchError> {
        let [x0, y, z] = &self.columns::<F>();
        let aperture = Aperture { x: self.aperture_x, ..Aperture::default() };
        let mut out = OutputColumns::new();
        let mut result = Ok(());
        let point_ns = point_ns(|| {
            let points = PointColumns { x0, y, z };
            let time = F::rounded(self.time);
            result = sightings_of_points(&self.speed, points, aperture, time, out.sightings(), Threads::One);
            black_box(&out);
        });
        result.map(|()| (out.seen(), point_ns))
    }

    fn naive<F: Precision>(&self) -> (SeenPoints, f64) {
        let columns = &self.columns::<F>();
        let [beta, time, aperture_x] = [self.speed.beta(), self.time, self.aperture_x].map(F::rounded);
        let mut out = OutputColumns::new();
        let point_ns = point_ns(|| {
            let outputs = out.0.each_mut().map(Vec::as_mut_slice);
            pulp::Arch::new().dispatch(
                #[inline(always)]
                || naive_sightings(beta, time, aperture_x, columns, outputs),
            );
            black_box(&out);
        });
        (out.seen(), point_ns)
    }

    fn columns<F: Precision>(&self) -> [Vec<F>; 3] {
        self.points.each_ref().map(|column| column.iter().map(|&v| F::rounded(v)).collect())
    }

    fn error(&self, truth: &SeenPoints, seen: &SeenPoints, point_ns: f64) -> FormulaAccuracy {
        let [_, y, z] = &self.points;
        let direction = |seen: &SeenPoints, i: usize| DVec3::new(seen.apparent_x[i], y[i], z[i]);
        // Where a form breaks down altogether (0/0), its line of sight is as wrong as can be.
        let or_worst = |error: f64, worst: f64| if error.is_finite() { error } else { worst };
        let sight = |i| or_worst(ARCSECONDS * angle(direction(truth, i), direction(seen, i)), 180.0 * 3600.0);
        let doppler =
            |i: usize| or_worst((seen.doppler_factor[i] / truth.doppler_factor[i] - 1.0).abs(), f64::MAX);
        FormulaAccuracy {
            point_ns,
            line_of_sight_arcseconds: Spread::from_errors((0..POINTS).map(sight).collect()),
            doppler_relative: Spread::from_errors((0..POINTS).map(doppler).collect()),
        }
    }
}

/// A precision that f64 can be rounded to.
trait Precision: Real {
    fn rounded(value: f64) -> Self;
}

impl Precision for f32 {
    fn rounded(value: f64) -> Self {
        value as Self
    }
}

impl Precision for f64 {
    fn rounded(value: f64) -> Self {
        value
    }
}

/// Output columns: apparent X, retarded time, Doppler factor.
struct OutputColumns<F>([Vec<F>; 3]);

impl<F: Precision> OutputColumns<F> {
    fn new() -> Self {
        Self([(); 3].map(|()| vec![F::zero(); POINTS]))
    }

    fn sightings(&mut self) -> SightingColumns<'_, F> {
        let [apparent_x, retarded_time, doppler_factor] = &mut self.0;
        SightingColumns { apparent_x, retarded_time, doppler_factor }
    }

    fn seen(self) -> SeenPoints {
        let [apparent_x, _, doppler_factor] =
            self.0.map(|column| column.into_iter().map(Into::into).collect());
        SeenPoints { apparent_x, doppler_factor }
    }
}

/// The paper's eq. (1), corrected, its t' = T - R and D = 1/(gamma (1 + beta X/R)), as printed. For gamma >> 1 and
/// X > 0 the difference cancels, and so does 1 + beta X/R for X < 0.
#[inline(always)]
#[expect(clippy::inline_always, reason = "what pulp dispatches must be inlined to use wider registers")]
fn naive_sightings<F: Precision>(
    beta: F,
    time: F,
    aperture_x: F,
    [x0, y, z]: &[Vec<F>; 3],
    [x, t, d]: [&mut [F]; 3],
) {
    let gamma = F::one() / (F::one() - beta * beta).sqrt();
    // One length for all lets the compiler drop the bounds checks.
    let (x0, y, z) = (&x0[..POINTS], &y[..POINTS], &z[..POINTS]);
    let (x, t, d) = (&mut x[..POINTS], &mut t[..POINTS], &mut d[..POINTS]);
    for i in 0..POINTS {
        let s = x0[i] - aperture_x + beta * time;
        let rho_squared = y[i] * y[i] + z[i] * z[i];
        let apparent = gamma * gamma * s - gamma * beta * (gamma * gamma * s * s + rho_squared).sqrt();
        let r = (apparent * apparent + rho_squared).sqrt();
        x[i] = apparent;
        t[i] = time - r;
        d[i] = F::one() / (gamma * (F::one() + beta * apparent / r));
    }
}

/// Nanoseconds per point of `work`: the fastest of three runs of some milliseconds.
fn point_ns(mut work: impl FnMut()) -> f64 {
    let mut run = || {
        let start = Instant::now();
        let mut passes = 0_usize;
        while start.elapsed_ms() < RUN_MS {
            work();
            passes += 1;
        }
        start.elapsed().as_secs_f64() * 1e9 / (passes * POINTS) as f64
    };
    (0..3).map(|_| run()).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn worst_arcseconds(formula: ConeFormula, beta: f64, place: TrackedPlace) -> f64 {
        let speed = Speed::from_beta(beta).expect("it is a speed");
        let error = formula_error(formula, &speed, place, [0.5, 3.0, 2.0], -0.05).expect("inside the domain");
        error.line_of_sight_arcseconds.expect("there are points").worst
    }

    #[test]
    fn the_naive_form_in_f32_fails_at_high_speed_and_the_stable_one_does_not() {
        for place in TrackedPlace::ALL {
            assert!(worst_arcseconds(ConeFormula::StableF32, 0.9999, place) < 0.2);
        }
        assert!(worst_arcseconds(ConeFormula::NaiveF32, 0.9999, TrackedPlace::Receding) > 20.0);
    }

    #[test]
    fn the_naive_form_in_f64_fails_at_extreme_speed() {
        let speed = Speed::from_gamma(1e7).expect("it is a speed");
        let error =
            formula_error(ConeFormula::NaiveF64, &speed, TrackedPlace::Receding, [0.5, 3.0, 2.0], -0.05);
        let worst =
            error.expect("inside the domain").line_of_sight_arcseconds.expect("there are points").worst;
        assert!(worst > 20.0, "{worst}");
    }

    #[test]
    fn at_rest_both_forms_see_a_point_where_it_is() {
        for formula in ConeFormula::ALL {
            assert!(worst_arcseconds(formula, 0.0, TrackedPlace::Abreast) < 0.1, "{formula}");
        }
    }
}
