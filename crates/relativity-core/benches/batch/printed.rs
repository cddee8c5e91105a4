//! The formulas as the literature prints them.

use num_traits::Float;

/// Writes the columns `[apparent_x, retarded_time, doppler_factor]` of the points `[x0, y, z]`, as an
/// aperture at (`aperture_x`, 0, 0) sees them at one `time`.
///
/// By the paper's eq. (1), corrected, its t' = T - R and D = 1/(gamma (1 + beta X/R)). For gamma >> 1 and X >
/// 0 the difference cancels, and so does 1 + beta X/R for X < 0.
pub fn sightings<F: Float>(beta: F, time: F, aperture_x: F, points: [&[F]; 3], outputs: [&mut [F]; 3]) {
    pulp::Arch::new().dispatch(
        #[inline(always)]
        || sightings_loop(beta, time, aperture_x, points, outputs),
    );
}

#[inline(always)]
#[expect(clippy::inline_always, reason = "what pulp dispatches must be inlined to use wider registers")]
fn sightings_loop<F: Float>(
    beta: F,
    time: F,
    aperture_x: F,
    [x0, y, z]: [&[F]; 3],
    [x, t, d]: [&mut [F]; 3],
) {
    let gamma = F::one() / (F::one() - beta * beta).sqrt();
    // One length for all lets the compiler drop the bounds checks.
    let rows = x0.len();
    let (y, z, x, t, d) = (&y[..rows], &z[..rows], &mut x[..rows], &mut t[..rows], &mut d[..rows]);
    for i in 0..rows {
        let s = x0[i] - aperture_x + beta * time;
        let rho_squared = y[i] * y[i] + z[i] * z[i];
        let apparent = gamma * gamma * s - gamma * beta * (gamma * gamma * s * s + rho_squared).sqrt();
        let r = (apparent * apparent + rho_squared).sqrt();
        x[i] = apparent;
        t[i] = time - r;
        d[i] = F::one() / (gamma * (F::one() + beta * apparent / r));
    }
}
