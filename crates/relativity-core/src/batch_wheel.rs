//! Sightings of points of wheels over slices.

use crate::aperture::Aperture;
use crate::apparent::{check_inputs, rounded};
use crate::batch::{BatchError, Real, SightingColumns, Threads};
use crate::batch_error::{check_common, first_outside};
use crate::source::WheelPoint;
use crate::speed::{Coefficients, Speed};
use crate::threads::prelude::*;
use crate::wheel::{Circle, Hub, Seen};

/// Points per task: each takes a root.
const CHUNK: usize = 512;

/// Writes the sightings of one point of a wheel by `aperture` at many observation `times`.
///
/// # Accuracy
///
/// In f64 that of [`crate::sighting`], which it is; in f32 with the unit 2^-24, the wheel and the aperture being rounded to f32
/// first. An angle is then known to its rounding after many turns: about 1e-4 of a radian after 160.
///
/// # Errors
///
/// Columns of unequal length; a value outside the domain.
///
/// # Examples
///
/// ```
/// use relativity_core::batch::{SightingColumns, Threads};
/// use relativity_core::batch_wheel::wheel_sightings_over_time;
/// use relativity_core::{Aperture, SourcePoint, Speed, Turning, WheelPoint};
///
/// // Rolling at 0.6 c: the point that rests on the road at t = 0, 5 away.
/// let hub = SourcePoint { x0: 0.0, y: 3.0, z: -3.0 };
/// let angle = -std::f64::consts::FRAC_PI_2;
/// let point = WheelPoint { hub, radius: 1.0, rho: 1.0, angle, turning: Turning::Rolling };
/// let (mut x, mut t, mut d) = ([0.0_f64; 2], [0.0_f64; 2], [0.0_f64; 2]);
/// let out = SightingColumns { apparent_x: &mut x, retarded_time: &mut t, doppler_factor: &mut d };
/// let speed = Speed::from_beta(0.6)?;
/// wheel_sightings_over_time(&speed, &point, Aperture::default(), &[5.0, 9.0], out, Threads::One)?;
/// assert!(x[0].abs() < 1e-14 && t[0].abs() < 1e-14 && (d[0] - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn wheel_sightings_over_time<F: Real>(
    speed: &Speed,
    point: &WheelPoint,
    aperture: Aperture,
    times: &[F],
    out: SightingColumns<'_, F>,
    threads: Threads,
) -> Result<(), BatchError> {
    out.check_lengths(times.len())?;
    let SightingColumns { apparent_x, retarded_time, doppler_factor } = out;
    check_inputs(*point, aperture, 0.0)?;
    check_common::<F>(speed, point.hub, &[aperture], 0.0)?;
    let lengths = [point.radius, 1.0 / point.radius, point.angle];
    if let Some(&value) = lengths.iter().find(|value| value.abs() > F::MAX_COORDINATE.into()) {
        return Err(BatchError::Single(value));
    }
    let view = WheelBatch::new(speed, point, aperture);
    let is_inside = match threads {
        Threads::One => view.fill(times, [apparent_x, retarded_time, doppler_factor]),
        Threads::All => (
            times.par_chunks(CHUNK),
            apparent_x.par_chunks_mut(CHUNK),
            retarded_time.par_chunks_mut(CHUNK),
            doppler_factor.par_chunks_mut(CHUNK),
        )
            .into_par_iter()
            .all(|(times, x, t, d)| view.fill(times, [x, t, d])),
    };
    if is_inside { Ok(()) } else { first_outside(&[("T", times)]) }
}

/// A point of a wheel before an aperture, in the precision of a batch.
struct WheelBatch<F> {
    coefficients: Coefficients<F>,
    circle: Circle<F>,
    x0: F,
    aperture_x: F,
    /// The hub's x at t = 0, y and z, from the aperture.
    from: [F; 3],
}

impl<F: Real> WheelBatch<F> {
    fn new(speed: &Speed, point: &WheelPoint, aperture: Aperture) -> Self {
        let [x0, y, z] = rounded([point.hub.x0, point.hub.y, point.hub.z]);
        let [ax, ay, az] = rounded([aperture.x, aperture.y, aperture.z]);
        let from = [x0 - ax, y - ay, z - az];
        Self { coefficients: speed.coefficients(), circle: point.circle(speed), x0, aperture_x: ax, from }
    }

    /// Fills the columns `[apparent_x, retarded_time, doppler_factor]`; whether all times are inside the domain.
    fn fill(&self, times: &[F], [x, t, d]: [&mut [F]; 3]) -> bool {
        let mut is_inside = true;
        let [s0, y, z] = self.from;
        for (((&time, x), t), d) in times.iter().zip(x).zip(t).zip(d) {
            is_inside &= time.abs() <= F::MAX_COORDINATE;
            let from = [s0 + self.coefficients.beta * time, y, z];
            let hub = Hub { x0: self.x0, aperture_x: self.aperture_x, observation_time: time, from };
            let seen = Seen::new(&self.coefficients, &self.circle, &hub);
            *x = seen.cone.solution.x;
            *t = time - seen.cone.solution.r;
            *d = seen.cone.solution.doppler_factor * self.circle.own_doppler(seen.slope);
        }
        is_inside
    }
}
