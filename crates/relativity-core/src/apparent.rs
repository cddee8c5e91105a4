//! Apparent position, retarded time and Doppler factor of a moving point: one aperture's light cone.
//!
//! References: the paper, eq. (1) with gamma beta before the root (as its Appendix A prints it; the
//! gamma/c of the text is a misprint, see [`crate::printed_apparent_x`]); Mathews and Lakshmanan 1972.

use num_traits::Float;

use crate::aperture::Aperture;
use crate::domain::{DomainError, check};
use crate::doppler::intensity_factor;
use crate::math;
use crate::source::{Source, SourcePoint};
use crate::speed::{Coefficients, Speed};

/// A sighting: one point as one aperture sees it at one observation time.
///
/// When the point is inside the aperture (distance 0) the line of sight does not exist; by
/// definition phi = theta = 0 and the Doppler factor is gamma, the mean of its limits
/// gamma (1 + beta) before and gamma (1 - beta) after the passage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sighting {
    /// Apparent position (X, Y, Z) from the aperture.
    pub position: [f64; 3],
    /// Distance R from the aperture to the event of emission.
    pub distance: f64,
    /// Retarded time t = T - R: when the light was emitted.
    pub retarded_time: f64,
    /// tau = gamma (t - beta x) = t/gamma - beta gamma x0 of the event of emission, x from the ground's
    /// origin: what the clock there shows that moves with the point, if all clocks of its rest frame are set
    /// alike in that frame and the one at the origin shows 0 at t = 0. So two clocks that are not abreast
    /// differ at one ground time. As seen, it runs at D.
    pub proper_time: f64,
    /// Doppler factor D = received / rest frequency.
    pub doppler_factor: f64,
}

impl Sighting {
    /// Azimuth from +x towards +y, in (-pi, pi].
    #[must_use]
    pub fn phi(&self) -> f64 {
        let [x, y, _] = self.position;
        math::atan2(y, x)
    }

    /// Elevation from the x-y plane, in [-pi/2, pi/2].
    #[must_use]
    pub fn theta(&self) -> f64 {
        let [x, y, z] = self.position;
        math::atan2(z, (x * x + y * y).sqrt())
    }

    /// Received over rest intensity, D^`exponent`; see [`intensity_factor`].
    #[must_use]
    pub fn intensity(&self, exponent: f64) -> f64 {
        intensity_factor(self.doppler_factor, exponent)
    }
}

/// Returns the sighting of `source` by `aperture` at `observation_time`.
///
/// # Accuracy
///
/// Every quantity is within [`crate::MAX_ERROR_UNITS`] units of `2^-53 (|f| + sum |x_i df/dx_i|)`, the `x_i`
/// being the inputs. Measured (`tests/oracle`, 15,000 inputs drawn towards trouble): X, t, tau, R, D, phi and
/// theta median 0.2, 99 % 1.5, worst 3 units.
///
/// # Errors
///
/// A coordinate or time outside the domain ([`crate::MAX_COORDINATE`]).
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, SourcePoint, Speed, sighting};
///
/// let speed = Speed::from_beta(0.6)?;
/// let point = SourcePoint { x0: 0.0, y: 4.0, z: 0.0 };
/// // Light from (-3, 4, 0) takes 5; it left when the point was there, at t = -3/0.6 = -5.
/// let seen = sighting(&speed, point, Aperture::default(), 0.0)?;
/// assert!((seen.position[0] + 3.0).abs() < 1e-15);
/// assert!((seen.distance - 5.0).abs() < 1e-15 && (seen.retarded_time + 5.0).abs() < 1e-15);
/// // Its own clock showed gamma (t - beta x) = 1.25 (-5 + 0.6 3) then.
/// assert!((seen.proper_time + 4.0).abs() < 1e-15);
/// // D = 1/(gamma (1 + beta n_x)) with gamma = 1.25 and n_x = -0.6.
/// assert!((seen.doppler_factor - 1.0 / (1.25 * 0.64)).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sighting(
    speed: &Speed,
    source: impl Into<Source>,
    aperture: Aperture,
    observation_time: f64,
) -> Result<Sighting, DomainError> {
    let source = source.into();
    check_inputs(source, aperture, observation_time)?;
    Ok(match source.simplest() {
        Source::Point(point) => sighting_inside_domain(speed, point, aperture, observation_time),
        Source::Wheel(wheel) => {
            let seen = wheel.seen(speed, aperture, observation_time);
            wheel.sighting(speed, &seen, observation_time)
        }
    })
}

/// [`sighting`] of inputs that have been checked.
pub(crate) fn sighting_inside_domain(
    speed: &Speed,
    point: SourcePoint,
    aperture: Aperture,
    observation_time: f64,
) -> Sighting {
    let cone = LightCone::new(speed, point, aperture, observation_time);
    cone.sighting(speed, point.x0, aperture.x, observation_time)
}

pub(crate) fn check_inputs(
    source: impl Into<Source>,
    aperture: Aperture,
    observation_time: f64,
) -> Result<(), DomainError> {
    let source = source.into();
    let point = source.place();
    check("T", observation_time)?;
    check("x0", point.x0)?;
    check("y", point.y)?;
    check("z", point.z)?;
    check("aperture x", aperture.x)?;
    check("aperture y", aperture.y)?;
    check("aperture z", aperture.z)?;
    match source {
        Source::Point(_) => Ok(()),
        Source::Wheel(wheel) => wheel.check(),
    }
}

/// Coordinates in the precision `F`.
#[inline]
pub(crate) fn rounded<F: Float>(coordinates: [f64; 3]) -> [F; 3] {
    coordinates.map(|v| F::from(v).unwrap_or_else(F::infinity))
}

/// The light cone of one aperture, solved for one point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LightCone<F> {
    /// S = x0 - a + beta T: where the point objectively is at T, from the aperture.
    pub s: F,
    pub y: F,
    pub z: F,
    pub solution: Solution<F>,
}

impl LightCone<f64> {
    pub fn new(speed: &Speed, point: SourcePoint, aperture: Aperture, time: f64) -> Self {
        let s = (point.x0 - aperture.x) + speed.beta() * time;
        Self::at(&speed.coefficients(), s, point.y - aperture.y, point.z - aperture.z)
    }

    /// Returns the sighting from an aperture at `aperture_x`, `x0` being the point's x at t = 0.
    pub fn sighting(&self, speed: &Speed, x0: f64, aperture_x: f64, observation_time: f64) -> Sighting {
        Sighting {
            position: [self.solution.x, self.y, self.z],
            distance: self.solution.r,
            retarded_time: observation_time - self.solution.r,
            proper_time: self.proper_time(&speed.coefficients(), x0, aperture_x, observation_time),
            doppler_factor: self.solution.doppler_factor,
        }
    }
}

impl<F: Float> LightCone<F> {
    #[inline(always)]
    #[expect(
        clippy::inline_always,
        reason = "batches are dispatched to wider registers, which needs inlining"
    )]
    pub fn at(coefficients: &Coefficients<F>, s: F, y: F, z: F) -> Self {
        Self { s, y, z, solution: coefficients.solution(s, y * y + z * z) }
    }

    /// In the rest frame the light arrives at gamma (T - beta a), from gamma q away.
    ///
    /// For a point far past the aperture that cancels at high speed. There q = S + (rho/gamma)^2/(q + S)
    /// leaves 1 - beta as a factor of what has come far, T + a.
    pub fn proper_time(&self, coefficients: &Coefficients<F>, x0: F, a: F, time: F) -> F {
        let &Coefficients { beta, gamma, one_minus_beta, inverse_gamma_squared, .. } = coefficients;
        let (s, q) = (self.s, self.solution.q);
        if beta * (s + s) <= q {
            return gamma * (time - beta * a - q);
        }
        let beyond = (self.y * self.y + self.z * self.z) * inverse_gamma_squared / (q + s);
        gamma * (one_minus_beta * (time + a) - x0 - beyond)
    }
}

/// The light-cone solution for one point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Solution<F> {
    /// q = sqrt(S^2 + rho^2/gamma^2), the rest-frame distance over gamma.
    pub q: F,
    /// Apparent X, from the aperture.
    pub x: F,
    /// Distance R from the aperture to the emission event.
    pub r: F,
    pub doppler_factor: F,
}

impl<F: Float> Coefficients<F> {
    /// Solves the light cone for a point objectively at `s` along x, at squared distance
    /// `rho_squared` from the line through the aperture along x.
    ///
    /// With c = S/q (the cosine in the rest frame), D = gamma (1 - beta c). Close to 1 it is best formed as
    /// 1 + ((gamma - 1) - gamma beta c), rounded once. Where gamma beta c is large that cancels; then
    /// 1 - beta^2 c^2 = (1 + beta^2 rho^2/q^2)/gamma^2 gives D as a quotient of sums of positive terms.
    /// R = gamma q D in either case.
    ///
    /// X = S - beta R is a sum of negative terms for S <= 0. For S > 0 it is (S^2 - beta^2 rho^2)/(S + beta
    /// q); where that cancels, S^2 rounds by no more than the roundings of S and rho that X depends on there.
    /// The squares are at hand, while factors of their difference would need the root of rho^2.
    #[inline(always)]
    #[expect(
        clippy::inline_always,
        reason = "batches are dispatched to wider registers, which needs inlining"
    )]
    pub fn solution(&self, s: F, rho_squared: F) -> Solution<F> {
        let Self { beta, gamma, gamma_minus_one, inverse_gamma, inverse_gamma_squared, smallest_q, .. } =
            *self;
        let (zero, one) = (F::zero(), F::one());
        let q = (s * s + rho_squared * inverse_gamma_squared).sqrt();
        // q = 0 only inside the aperture; a tiny divisor then makes c = 0 and D = gamma.
        let divisor = if q > smallest_q { q } else { smallest_q };
        // One division serves both 1/q and the quotient of the receding case.
        let divisor_and_s = divisor + beta * s.abs();
        let shared = one / (divisor * divisor_and_s);
        let gamma_beta_cosine = gamma * beta * (s * (divisor_and_s * shared));
        // Both cases are computed and one chosen, so that loops over points vectorise.
        let receding = (divisor * divisor + beta * beta * rho_squared) * shared * inverse_gamma;
        let otherwise = one + (gamma_minus_one - gamma_beta_cosine);
        let doppler_factor = if gamma_beta_cosine + gamma_beta_cosine > one { receding } else { otherwise };
        let r = gamma * q * doppler_factor;
        let past = (s * s - beta * beta * rho_squared) / (s + beta * q);
        let x = if s > zero { past } else { s - beta * r };
        Solution { q, x, r, doppler_factor }
    }
}
