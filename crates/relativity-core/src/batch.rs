//! Sightings and disparities over slices: sightings of many points at one time, disparities of observations
//! that differ in anything.
//!
//! They compute the same solution as the scalar functions, in f64 or f32, on one thread or on all. Plain
//! loops without branches, which the compiler vectorises.

use crate::aperture::Aperture;
use crate::apparent::{LightCone, rounded};
pub use crate::batch_error::BatchError;
use crate::batch_error::{check_common, check_lengths, first_outside};
pub use crate::observation_batch::{Column, DisparityColumns, ObservationColumns, Speeds};
pub use crate::real::Real;
use crate::source::SourcePoint;
use crate::speed::{Coefficients, Speed};
use crate::threads::prelude::*;

/// Points per task: enough to hide the cost of a task, and few enough to stay in a core's cache.
const CHUNK: usize = 4096;

/// Number of threads that a batch uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Threads {
    /// The caller's thread alone.
    One,
    /// Every thread of rayon's pool.
    All,
}

/// Points, a column for each coordinate.
#[derive(Debug, Clone, Copy)]
pub struct PointColumns<'a, F> {
    /// Objective x at t = 0.
    pub x0: &'a [F],
    /// Depths y, ahead of the eyes.
    pub y: &'a [F],
    /// Heights z, above the eyes.
    pub z: &'a [F],
}

/// Columns that sightings are written to. The apparent Y and Z are the point's own, less the aperture's.
#[derive(Debug)]
pub struct SightingColumns<'a, F> {
    /// Apparent X from the aperture.
    pub apparent_x: &'a mut [F],
    /// Retarded times t, when the light left.
    pub retarded_time: &'a mut [F],
    /// Doppler factors D: received over emitted frequency.
    pub doppler_factor: &'a mut [F],
}

impl<F> SightingColumns<'_, F> {
    /// An error unless each has `rows`.
    pub(crate) fn check_lengths(&self, rows: usize) -> Result<(), BatchError> {
        let Self { apparent_x, retarded_time, doppler_factor } = self;
        check_lengths(
            rows,
            &[
                ("apparent_x", apparent_x.len()),
                ("retarded_time", retarded_time.len()),
                ("doppler_factor", doppler_factor.len()),
            ],
        )
    }
}

/// Writes the sightings of many points by `aperture` at one `observation_time`.
///
/// # Accuracy
///
/// As [`crate::sighting`], with the unit of f32 (2^-24) for f32. The aperture is rounded to `F` first.
///
/// # Errors
///
/// Columns of unequal length; a value outside the domain.
///
/// # Examples
///
/// ```
/// use relativity_core::batch::{PointColumns, SightingColumns, Threads, sightings_of_points};
/// use relativity_core::{Aperture, Speed};
///
/// let speed = Speed::from_beta(0.6)?;
/// let points = PointColumns { x0: &[0.0, 0.0_f32], y: &[4.0, 8.0], z: &[0.0, 0.0] };
/// let (mut x, mut t, mut d) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// let out = SightingColumns { apparent_x: &mut x, retarded_time: &mut t, doppler_factor: &mut d };
/// sightings_of_points(&speed, points, Aperture::default(), 0.0, out, Threads::One)?;
/// assert!((x[0] + 3.0).abs() < 1e-6 && (x[1] + 6.0).abs() < 1e-6);
/// assert!((t[0] + 5.0).abs() < 1e-6 && (t[1] + 10.0).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sightings_of_points<F: Real>(
    speed: &Speed,
    points: PointColumns<'_, F>,
    aperture: Aperture,
    observation_time: F,
    out: SightingColumns<'_, F>,
    threads: Threads,
) -> Result<(), BatchError> {
    let PointColumns { x0, y, z } = points;
    let rows = x0.len();
    check_lengths(rows, &[("y", y.len()), ("z", z.len())])?;
    out.check_lengths(rows)?;
    let SightingColumns { apparent_x, retarded_time, doppler_factor } = out;
    let origin = SourcePoint { x0: 0.0, y: 0.0, z: 0.0 };
    check_common::<F>(speed, origin, &[aperture], observation_time.into())?;
    let view = PointBatch {
        coefficients: speed.coefficients(),
        aperture: rounded([aperture.x, aperture.y, aperture.z]),
    };
    let is_inside = match threads {
        Threads::One => (x0.chunks(CHUNK).zip(y.chunks(CHUNK)).zip(z.chunks(CHUNK)))
            .zip(
                apparent_x
                    .chunks_mut(CHUNK)
                    .zip(retarded_time.chunks_mut(CHUNK))
                    .zip(doppler_factor.chunks_mut(CHUNK)),
            )
            .all(|(((x0, y), z), ((x, t), d))| view.points(observation_time, [x0, y, z], [x, t, d])),
        Threads::All => (
            x0.par_chunks(CHUNK),
            y.par_chunks(CHUNK),
            z.par_chunks(CHUNK),
            apparent_x.par_chunks_mut(CHUNK),
            retarded_time.par_chunks_mut(CHUNK),
            doppler_factor.par_chunks_mut(CHUNK),
        )
            .into_par_iter()
            .all(|(x0, y, z, x, t, d)| view.points(observation_time, [x0, y, z], [x, t, d])),
    };
    if is_inside { Ok(()) } else { first_outside(&[("x0", x0), ("y", y), ("z", z)]) }
}

/// Writes the disparities of `observations`, as many as `out` has rows.
///
/// # Accuracy
///
/// As [`crate::disparity()`], with the unit of f32 (2^-24) for f32. The apertures are rounded to `F` first.
///
/// # Errors
///
/// Columns of unequal length; a value outside the domain.
///
/// # Examples
///
/// ```
/// use relativity_core::batch::{Column, DisparityColumns, ObservationColumns, Speeds, Threads};
/// use relativity_core::{Aperture, batch};
///
/// // At rest the disparity is that of parallax; a second later a fast rider is past.
/// let observations = ObservationColumns {
///     speeds: Speeds::Each(&[0.0, 0.9]),
///     x0: Column::Same(0.0),
///     y: Column::Same(3.0),
///     z: Column::Same(0.0),
///     times: Column::Each(&[0.0, 4.0]),
///     apertures: Aperture::pair(0.1),
/// };
/// let (mut dphi, mut dtheta) = ([0.0; 2], [0.0; 2]);
/// let out = DisparityColumns { dphi: &mut dphi, dtheta: &mut dtheta };
/// batch::disparities(&observations, out, Threads::One)?;
/// assert!((dphi[0] + 2.0 * (0.05_f64 / 3.0).atan()).abs() < 1e-15);
/// # Ok::<(), batch::BatchError>(())
/// ```
pub fn disparities<F: Real>(
    observations: &ObservationColumns<'_, F>,
    out: DisparityColumns<'_, F>,
    threads: Threads,
) -> Result<(), BatchError> {
    observations.check(out.dphi.len(), out.dtheta.len())?;
    let DisparityColumns { dphi, dtheta } = out;
    let is_inside = match threads {
        Threads::One => F::disparities(observations, DisparityColumns { dphi, dtheta }),
        Threads::All => (dphi.par_chunks_mut(CHUNK), dtheta.par_chunks_mut(CHUNK))
            .into_par_iter()
            .enumerate()
            .all(|(chunk, (dphi, dtheta))| {
                let first = chunk * CHUNK;
                let rows = first..first + dphi.len();
                F::disparities(&observations.rows(rows), DisparityColumns { dphi, dtheta })
            }),
    };
    if is_inside { Ok(()) } else { observations.first_outside() }
}

impl<F: Real> ObservationColumns<'_, F> {
    /// An error unless each column has as many rows as those of the output, and what all rows share is inside
    /// the domain.
    fn check(&self, dphi: usize, dtheta: usize) -> Result<(), BatchError> {
        let lengths = self.each().map(|(name, values)| (name, values.len()));
        check_lengths(dphi, &lengths.chain([("dtheta", dtheta)]).collect::<Vec<_>>())?;
        let speed = match self.speeds {
            Speeds::Same(speed) => speed,
            Speeds::Each(_) => Speed::REST,
        };
        let common = |column: Column<'_, F>| match column {
            Column::Same(value) => value.into(),
            Column::Each(_) => 0.0,
        };
        let point = SourcePoint { x0: common(self.x0), y: common(self.y), z: common(self.z) };
        check_common::<F>(&speed, point, &self.apertures, common(self.times))
    }

    /// The error of the first row with a value outside the domain.
    #[cold]
    fn first_outside(&self) -> Result<(), BatchError> {
        let no_speed = |(index, &beta): (usize, &F)| match Speed::from_beta(beta.into()) {
            Ok(speed) if speed.gamma() <= F::MAX_GAMMA => None,
            Ok(speed) => Some((index, BatchError::Single(speed.gamma()))),
            Err(error) => Some((index, BatchError::Speed { index, error })),
        };
        let betas = self.speeds.each().unwrap_or_default();
        let outside = |rows: &Self| first_outside(&rows.each().collect::<Vec<_>>());
        match betas.iter().enumerate().find_map(no_speed) {
            Some((row, error)) => outside(&self.rows(0..row)).and(Err(error)),
            None => outside(self),
        }
    }
}

/// A speed and an aperture in the precision of a batch.
struct PointBatch<F> {
    coefficients: Coefficients<F>,
    aperture: [F; 3],
}

impl<F: Real> PointBatch<F> {
    /// Fills the columns `[apparent_x, retarded_time, doppler_factor]`; whether all points are inside the
    /// domain.
    fn points(&self, time: F, inputs: [&[F]; 3], outputs: [&mut [F]; 3]) -> bool {
        pulp::Arch::new().dispatch(
            #[inline(always)]
            || self.points_loop(time, inputs, outputs),
        )
    }

    #[inline(always)]
    #[expect(clippy::inline_always, reason = "what pulp dispatches must be inlined to use wider registers")]
    fn points_loop(&self, time: F, [x0, y, z]: [&[F]; 3], [x, t, d]: [&mut [F]; 3]) -> bool {
        let (moved, limit) = (self.coefficients.beta * time, F::MAX_COORDINATE);
        // One length for all lets the compiler drop the bounds checks.
        let rows = x0.len();
        let (y, z, x, t, d) = (&y[..rows], &z[..rows], &mut x[..rows], &mut t[..rows], &mut d[..rows]);
        let mut is_inside = true;
        for i in 0..rows {
            is_inside &= (x0[i].abs() <= limit) & (y[i].abs() <= limit) & (z[i].abs() <= limit);
            let s = (x0[i] - self.aperture[0]) + moved;
            let cone = LightCone::at(&self.coefficients, s, y[i] - self.aperture[1], z[i] - self.aperture[2]);
            x[i] = cone.solution.x;
            t[i] = time - cone.solution.r;
            d[i] = cone.solution.doppler_factor;
        }
        is_inside
    }
}
