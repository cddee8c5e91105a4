//! Aberration: the line of sight in the ground frame and in the object's rest frame.
//!
//! A line of sight is a unit vector from the aperture to the source. Reference: A. Einstein, *Zur
//! Elektrodynamik bewegter Koerper* (1905), section 7; R. Penrose, *The apparent shape of a
//! relativistically moving sphere* (1959).
//!
//! # Accuracy
//!
//! As [`crate::sighting`], for the direction of the vector given. Measured (`tests/oracle`, 15,000
//! directions, uniform and close to the axis): median 0.1, 99 % 2.2, worst 4.3 units.

use crate::speed::Speed;

/// The rest-frame line of sight of the ground's `line_of_sight` (a unit vector).
///
/// # Examples
///
/// ```
/// use relativity_core::Speed;
/// use relativity_core::aberration::{ground_from_rest, rest_from_ground};
///
/// let speed = Speed::from_beta(0.6)?;
/// // What is seen straight ahead along y shows the object turned: (beta, 1/gamma, 0).
/// let [x, y, _] = rest_from_ground([0.0, 1.0, 0.0], &speed);
/// assert!((x - 0.6).abs() < 1e-15 && (y - 0.8).abs() < 1e-15);
/// let [x, y, _] = ground_from_rest([x, y, 0.0], &speed);
/// assert!(x.abs() < 1e-15 && (y - 1.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn rest_from_ground(line_of_sight: [f64; 3], speed: &Speed) -> [f64; 3] {
    aberrated(line_of_sight, speed)
}

/// The ground's line of sight of the rest frame's `line_of_sight` (a unit vector).
#[must_use]
pub fn ground_from_rest([x, y, z]: [f64; 3], speed: &Speed) -> [f64; 3] {
    let [x, y, z] = aberrated([-x, y, z], speed);
    [-x, y, z]
}

/// Doppler factor D = 1/(gamma (1 + beta `n_x`)) of light received along the ground's `line_of_sight`.
///
/// # Examples
///
/// ```
/// use relativity_core::Speed;
/// use relativity_core::aberration::doppler_factor;
///
/// let speed = Speed::from_beta(0.6)?;
/// let of = |x: f64, y: f64| doppler_factor([x, y, 0.0], &speed);
/// assert!((of(-1.0, 0.0) - 2.0).abs() < 1e-15); // coming: sqrt((1 + beta)/(1 - beta))
/// assert!((of(0.0, 1.0) - 0.8).abs() < 1e-15); // abreast: 1/gamma
/// assert!((of(1.0, 0.0) - 0.5).abs() < 1e-15); // going
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn doppler_factor(line_of_sight: [f64; 3], speed: &Speed) -> f64 {
    1.0 / (speed.gamma() * one_plus_beta_x(line_of_sight, speed))
}

/// `1 + beta n_x` as a sum of positive terms.
fn one_plus_beta_x([x, y, z]: [f64; 3], speed: &Speed) -> f64 {
    if x < 0.0 {
        // 1 + n_x = (n_y^2 + n_z^2)/(1 - n_x) for a unit vector.
        speed.one_minus_beta() + speed.beta() * (y * y + z * z) / (1.0 - x)
    } else {
        1.0 + speed.beta() * x
    }
}

/// ((`n_x` + beta), `n_y`/gamma, `n_z`/gamma) / (1 + beta `n_x`).
fn aberrated(n: [f64; 3], speed: &Speed) -> [f64; 3] {
    let [x, y, z] = n;
    let denominator = one_plus_beta_x(n, speed);
    let numerator = if x < -0.5 {
        // (1 + n_x) - (1 - beta): for directions nearly backward the difference of two small numbers.
        (y * y + z * z) / (1.0 - x) - speed.one_minus_beta()
    } else {
        x + speed.beta()
    };
    let transverse = 1.0 / (speed.gamma() * denominator);
    [numerator / denominator, y * transverse, z * transverse]
}
