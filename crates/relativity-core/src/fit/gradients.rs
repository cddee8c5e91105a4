//! Derivatives of what one aperture sees with respect to the parameters of a trial object.

use crate::apparent::LightCone;

/// Partial derivatives with respect to beta, y, z and t0.
pub(crate) type Gradient = [f64; 4];

pub(super) const D_Y: Gradient = [0.0, 1.0, 0.0, 0.0];
pub(super) const D_Z: Gradient = [0.0, 0.0, 1.0, 0.0];

/// Delta-phi and Delta-theta, and their gradients.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slopes {
    pub angles: [f64; 2],
    pub gradients: [Gradient; 2],
}

#[inline]
pub(super) fn x_gradient(beta: f64, cone: &LightCone<f64>, ds: Gradient, dz: Gradient) -> Gradient {
    let r = cone.solution.r;
    let inverse_q = 1.0 / cone.solution.q;
    let along = r * inverse_q;
    let across = -beta * inverse_q;
    std::array::from_fn(|i| {
        let dbeta = if i == 0 { r } else { 0.0 };
        along * (ds[i] - dbeta) + across * (cone.y * D_Y[i] + cone.z * dz[i])
    })
}

/// d(atan2(y, X)) and d(atan2(z, h)).
#[inline]
pub(super) fn angle_gradients(cone: &LightCone<f64>, dx: Gradient, dz: Gradient) -> [Gradient; 2] {
    let LightCone { y, z, solution, .. } = *cone;
    let x = solution.x;
    let h_squared = x * x + y * y;
    let h = h_squared.sqrt();
    let inverse_h_squared = 1.0 / h_squared;
    let inverse_r_squared = 1.0 / (h_squared + z * z);
    let slope = -z * inverse_r_squared / h;
    let dphi = std::array::from_fn(|i| (x * D_Y[i] - y * dx[i]) * inverse_h_squared);
    let dtheta = std::array::from_fn(|i| h * dz[i] * inverse_r_squared + slope * (x * dx[i] + y * D_Y[i]));
    [dphi, dtheta]
}

/// Gradient of Delta T, by which light from the event that the primary sees takes longer to the secondary.
pub(super) fn delay_gradient(
    primary: &LightCone<f64>,
    to_secondary: f64,
    dx: Gradient,
    dz: Gradient,
) -> Gradient {
    let LightCone { y, z, solution, .. } = *primary;
    let distance = (to_secondary * to_secondary + y * y + z * z).sqrt();
    std::array::from_fn(|i| {
        let transverse = y * D_Y[i] + z * dz[i];
        (to_secondary * dx[i] + transverse) / distance - (solution.x * dx[i] + transverse) / solution.r
    })
}
