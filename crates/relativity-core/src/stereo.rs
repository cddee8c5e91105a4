//! Where two eyes take a point to be: the place at which their lines of sight meet.
//!
//! Derived here; not in the paper. The paper's pair of apertures lies along the motion, so both see the same y and z, and
//! the lines from the left one at (-d/2, 0, 0) along (`X_l`, y, z) and from the right one at (d/2, 0, 0) along (`X_r`, y, z)
//! meet: at lambda = d/(`X_l` - `X_r`) of either. Beside a resting point lambda would be 1.

use crate::apparent::{Aperture, SourcePoint, check_inputs};
use crate::cone_pair::ConePair;
use crate::domain::{DomainError, check};
use crate::speed::Speed;

/// What two eyes make of one point.
///
/// When the point is inside both apertures (distance 0, `separation` 0) the gain is gamma^2 by definition, as the Doppler
/// factor is gamma there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stereo {
    /// (`X_left` - `X_right`)/d, above 0: how many times as far apart as they are the eyes would see the difference between
    /// them at a resting point. As d -> 0 it is gamma D.
    pub gain: f64,
    /// Where the lines of sight meet, from the middle between the eyes. As d -> 0 it is the apparent position over gamma D.
    pub position: [f64; 3],
}

impl Stereo {
    /// The distance at which two eyes take the point to be, from the middle between them. As d -> 0 it is the rest-frame
    /// distance over gamma.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.position.map(|along| along * along).iter().sum::<f64>().sqrt()
    }
}

/// Where the paper's pair of apertures, `separation` apart, takes `point` to be at `observation_time`.
///
/// Each aperture has a light cone of its own. Nothing changes where `separation` changes its sign, and a separation of 0
/// stands for the limit.
///
/// # Accuracy
///
/// As [`crate::sighting`], however close the apertures are, the unit's inputs being the speed, x0, y, z, T and d: the gain
/// is (`R_l` + `R_r`)/(`q_l` + `q_r`) with q = sqrt(S^2 + rho^2/gamma^2), in which there is nothing to subtract. Measured
/// for gain and position (`tests/oracle`, 15,000 inputs): median 0.2, 99 % 2.7, worst 5.5 units.
///
/// # Errors
///
/// A coordinate or time outside the domain.
///
/// # Examples
///
/// ```
/// use relativity_core::{SourcePoint, Speed, stereo};
///
/// // At beta = 0.6 it is seen at (-3, 4, 0), with D = 1/(1.25 0.64) and so a gain of 1/0.64 ...
/// let speed = Speed::from_beta(0.6)?;
/// let point = SourcePoint { x0: 0.0, y: 4.0, z: 0.0 };
/// let fused = stereo(&speed, point, 0.0, 0.0)?;
/// assert!((fused.gain - 1.5625).abs() < 1e-15);
/// // ... and taken to be in the same direction, 0.64 times as far.
/// assert!((fused.position[0] + 1.92).abs() < 1e-15 && (fused.position[1] - 2.56).abs() < 1e-15);
/// assert!((fused.distance() - 3.2).abs() < 1e-15);
/// // A resting point is taken to be where it is, whatever the separation.
/// assert_eq!(stereo(&Speed::REST, point, 0.5, 0.0)?.position, [0.0, 4.0, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn stereo(
    speed: &Speed,
    point: SourcePoint,
    separation: f64,
    observation_time: f64,
) -> Result<Stereo, DomainError> {
    check_inputs(point, Aperture::default(), observation_time)?;
    let [left, right] = Aperture::pair(check("d", separation)?);
    let pair = ConePair::new(&speed.coefficients(), point, left, right, observation_time);
    let gain = pair.gain().unwrap_or(speed.gamma() * speed.gamma());
    Ok(Stereo { gain, position: [pair.mean_x() / gain, point.y / gain, point.z / gain] })
}
