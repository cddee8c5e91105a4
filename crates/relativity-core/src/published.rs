//! The published binocular model: the paper's, as printed, so that it can be reproduced and compared.
//!
//! The paper evaluates the right eye through the left eye's formula at a shifted time and measures
//! both angles from the left aperture, so that ordinary parallax is left out. It is an approximation
//! by construction; [`crate::disparity()`] is exact. Reference: the paper, eqs. (1) and (5), Appendix A.

use crate::aperture::Aperture;
use crate::apparent::{LightCone, Sighting, check_inputs};
use crate::cone_pair::{ConePair, Offset};
use crate::disparity::Disparity;
use crate::domain::{DomainError, check};
use crate::source::SourcePoint;
use crate::speed::Speed;

/// The sign of the delay `Delta T` (eq. 5), on which the paper disagrees with itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PublishedVariant {
    /// `X_S = X(T - Delta T)`, as Appendix A prints it; right to first order.
    AppendixA,
    /// `X_S = X(T + Delta T)`, as the text of section 3 writes.
    TextSign,
}

impl PublishedVariant {
    /// The sign with which Delta T goes into the right eye's time.
    pub(crate) const fn delay_sign(self) -> f64 {
        match self {
            Self::AppendixA => -1.0,
            Self::TextSign => 1.0,
        }
    }
}

/// Disparity of `point` in the published model, for the paper's pair of apertures.
///
/// The secondary sighting is the left aperture's at the shifted time, measured from the left aperture, as
/// published, its proper time that of the event seen then. A point not on x(0) = 0 is brought there by a
/// shift of both times.
///
/// # Accuracy
///
/// As [`crate::disparity()`], towards the published formulas, at any separation. Measured (`tests/oracle`,
/// 15,000 inputs): median 0.2, 99 % 2.1, worst 6.3 units.
///
/// # Errors
///
/// A coordinate or time outside the domain.
///
/// # Examples
///
/// ```
/// use relativity_core::{PublishedVariant, SourcePoint, Speed, published_disparity};
///
/// // The paper's section 3: Appendix A's difference in azimuth falls to -0.3295 and rises to 0.0712.
/// let speed = Speed::from_beta(0.9)?;
/// let point = SourcePoint { x0: 0.0, y: 0.5, z: 0.5 };
/// let (mut least, mut largest) = (0.0_f64, 0.0_f64);
/// for step in 0..10_000 {
///     let time = f64::from(step) * 5e-4;
///     let seen = published_disparity(&speed, point, 0.3, time, PublishedVariant::AppendixA)?;
///     (least, largest) = (least.min(seen.dphi), largest.max(seen.dphi));
/// }
/// assert!((least + 0.3295).abs() < 5e-5 && (largest - 0.0712).abs() < 5e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn published_disparity(
    speed: &Speed,
    point: SourcePoint,
    separation: f64,
    observation_time: f64,
    variant: PublishedVariant,
) -> Result<Disparity, DomainError> {
    check_inputs(point, Aperture::default(), observation_time)?;
    check("d", separation)?;
    let (pair, shift) = cone_pair(speed, point, separation, observation_time, variant);
    let ConePair { left, right, .. } = pair;
    let (dphi, dtheta) = pair.angle_differences();
    let primary = left.sighting(speed, point.x0, -separation / 2.0, observation_time);
    let retarded_time = match variant {
        PublishedVariant::TextSign if left.solution.x > 0.0 => {
            receding_text_time(speed, point.x0, separation, &primary, &right)
        }
        _ => later_time(&left, &right, primary.retarded_time, observation_time + shift, shift),
    };
    let proper_time = retarded_time / speed.gamma() - speed.beta() * speed.gamma() * point.x0;
    let shifted = right.sighting(speed, point.x0, -separation / 2.0, observation_time + shift);
    Ok(Disparity { primary, secondary: Sighting { retarded_time, proper_time, ..shifted }, dphi, dtheta })
}

/// Both light cones of the published model, and by how much the second is later.
pub(crate) fn cone_pair(
    speed: &Speed,
    point: SourcePoint,
    separation: f64,
    observation_time: f64,
    variant: PublishedVariant,
) -> (ConePair<f64>, f64) {
    // The same s0 goes into all that follows, so that its rounding acts like one of the inputs.
    let s0 = point.x0 + speed.beta() * observation_time;
    let left = LightCone::at(&speed.coefficients(), s0 + separation / 2.0, point.y, point.z);
    let Delay { delay, right_distance } = delay(speed, s0, separation, &left);
    let s = match variant {
        PublishedVariant::AppendixA => appendix_a_s(speed, s0, separation, &left, delay, right_distance),
        PublishedVariant::TextSign => text_s(speed, separation, &left, delay),
    };
    let shift = variant.delay_sign() * delay;
    let shifted = speed.beta() * shift;
    let right = LightCone::at(&speed.coefficients(), s, left.y, left.z);
    let offset = Offset { s: -shifted, y: 0.0, z: 0.0 };
    let pair = ConePair { beta: speed.beta(), left, right, offset, sum_s: left.s + right.s };
    (pair, shift)
}

/// Returns the model's shift of time: the right view shows a place this much later than the left view does,
/// whose light cone is `left`.
pub(crate) fn shift(speed: &Speed, separation: f64, left: &LightCone<f64>, variant: PublishedVariant) -> f64 {
    variant.delay_sign() * delay(speed, left.s - separation / 2.0, separation, left).delay
}

/// When the light was emitted that the right eye sees.
///
/// Both events lie on one worldline, so `t_S` = t + (`X_S` - X)/beta; or it is the shifted time less the
/// distance. Of the two sums, the one with the smaller terms.
fn later_time(
    left: &LightCone<f64>,
    right: &LightCone<f64>,
    left_time: f64,
    shifted_time: f64,
    shift: f64,
) -> f64 {
    if shifted_time.abs() < left_time.abs() {
        return shifted_time - right.solution.r;
    }
    let (sum_r, sum_q) = (left.solution.r + right.solution.r, left.solution.q + right.solution.q);
    if sum_q == 0.0 { left_time } else { left_time + shift * (sum_r / sum_q) }
}

/// Returns the emission time that the right eye sees, for the text's sign and a point that the left aperture
/// sees recede.
///
/// The shifted time is t + R'. With it the light cone's quadratic for `t_S` has the constant
/// t^2/gamma^2 + 2 t (R' - beta (d - X)) - 2 d x0, each term as small at high speed as `t_S` becomes.
fn receding_text_time(speed: &Speed, x0: f64, d: f64, primary: &Sighting, right: &LightCone<f64>) -> f64 {
    let ([x, ..], t, beta) = (primary.position, primary.retarded_time, speed.beta());
    let (ahead, rho_squared) = (d - x, right.y * right.y + right.z * right.z);
    let right_distance = (ahead * ahead + rho_squared).sqrt();
    let excess = if ahead > 0.0 && right_distance > 0.0 {
        (rho_squared + ahead * ahead * speed.inverse_gamma_squared()) / (right_distance + beta * ahead)
    } else {
        right_distance - beta * ahead
    };
    let constant = t * (t * speed.inverse_gamma_squared() + 2.0 * excess) - 2.0 * d * x0;
    let shifted_time = t + right_distance;
    let divisor = shifted_time * speed.inverse_gamma_squared() + beta * right.s + right.solution.q;
    if shifted_time < 0.0 || divisor == 0.0 {
        return shifted_time - right.solution.r;
    }
    constant / divisor
}

/// Delta T (eq. 5), and the distance from the right aperture to the event that the left one sees.
struct Delay {
    delay: f64,
    right_distance: f64,
}

/// Returns the delay between the eyes: the additional time that light from the event which the left eye sees
/// takes to the right eye.
///
/// The difference of the two distances is `-2 u d` over their sum, u being the event's x. That is X - d/2,
/// sharing X's rounding; where this cancels, it comes from s0, the point's objective x at the observation
/// time.
fn delay(speed: &Speed, s0: f64, separation: f64, left: &LightCone<f64>) -> Delay {
    let (x, rho_squared) = (left.solution.x, left.y * left.y + left.z * left.z);
    let u = if x.abs() > separation.abs() {
        x - separation / 2.0
    } else {
        s0 - speed.beta() * (x * x + rho_squared).sqrt()
    };
    let to_right = u - separation / 2.0;
    let right_distance = (to_right * to_right + rho_squared).sqrt();
    let sum = left.solution.r + right_distance;
    let delay = if sum == 0.0 { 0.0 } else { -2.0 * u * separation / sum };
    Delay { delay, right_distance }
}

/// `S + beta Delta T`: where the text has the point when the right eye sees it, from the left aperture.
///
/// Since S = X + beta R this is X + beta R', in which an error of X > 0 cancels at high speed as it should,
/// if R' is formed from the same X.
fn text_s(speed: &Speed, d: f64, left: &LightCone<f64>, delay: f64) -> f64 {
    let x = left.solution.x;
    if x <= 0.0 {
        return left.s + speed.beta() * delay;
    }
    x + speed.beta() * ((x - d) * (x - d) + left.y * left.y + left.z * left.z).sqrt()
}

/// `S - beta Delta T`: where Appendix A has the point when the right eye sees it, from the left aperture.
///
/// `s0` is its objective x at the observation time. Where s0 is small against the separation d, the two
/// terms nearly cancel at high speed. With R' - 3 R and then beta d - 4 R as quotients of their squares'
/// differences, what remains is each of s0, 1 - beta, rho^2 and 1/gamma^2 with a factor of its own.
fn appendix_a_s(
    speed: &Speed,
    s0: f64,
    d: f64,
    left: &LightCone<f64>,
    delay: f64,
    right_distance: f64,
) -> f64 {
    let beta = speed.beta();
    let (q, r) = (left.solution.q, left.solution.r);
    let fourfold = right_distance + 3.0 * r;
    if left.s <= 0.0 || s0.abs() > d.abs() / 4.0 || fourfold == 0.0 {
        return left.s - beta * delay;
    }
    let rho_squared = left.y * left.y + left.z * left.z;
    let slack = rho_squared * (4.0 - beta * d * speed.inverse_gamma_squared() / (q + left.s));
    let excess = s0 * (beta * d * (1.0 + beta) - 4.0 * (s0 + d));
    let deficit = d * d * speed.one_minus_beta() * (1.0 + beta / 2.0) + slack - excess;
    let by_s0 = s0 * (r + right_distance + 2.0 * beta * d - d * d / fourfold);
    let beta_d_minus_4r = -deficit / (q + beta * left.s);
    let by_d = d * r * (2.0 * speed.inverse_gamma_squared() + beta_d_minus_4r / fourfold);
    (by_s0 + by_d) / (r + right_distance)
}

/// Apparent X by eq. (1) as printed, with gamma/c before the root instead of gamma beta.
///
/// Shown for comparison only: with it, a resting point would not appear where it is.
///
/// # Errors
///
/// A coordinate or time outside the domain.
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, SourcePoint, Speed, printed_apparent_x};
///
/// // At rest at x = 3, as printed it would appear at x = 3 - 5.
/// let point = SourcePoint { x0: 3.0, y: 4.0, z: 0.0 };
/// let x = printed_apparent_x(&Speed::REST, point, Aperture::default(), 0.0)?;
/// assert_eq!(x, -2.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn printed_apparent_x(
    speed: &Speed,
    point: SourcePoint,
    aperture: Aperture,
    observation_time: f64,
) -> Result<f64, DomainError> {
    check_inputs(point, aperture, observation_time)?;
    let cone = LightCone::new(speed, point, aperture, observation_time);
    let gamma = speed.gamma();
    let gamma_squared = gamma * gamma;
    // gamma^2 (S - q); for S > 0 the difference is -(rho/gamma)^2/(S + q).
    Ok(if cone.s > 0.0 {
        -(cone.y * cone.y + cone.z * cone.z) / (cone.s + cone.solution.q)
    } else {
        gamma_squared * (cone.s - cone.solution.q)
    })
}
