//! Speed, kept so that no digit of 1 - beta is lost however it was given.

use num_traits::Float;
use thiserror::Error;

use crate::math;

/// Largest Lorentz factor accepted. Squares and fourth powers of it times squared coordinates stay
/// inside f64.
pub const MAX_GAMMA: f64 = 1e30;

/// A speed that is not one.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum SpeedError {
    /// beta outside `0 <= beta < 1`.
    #[error("beta = {0} is out of range: it must be at least 0 and below 1")]
    Beta(f64),
    /// gamma outside `1 <= gamma <= MAX_GAMMA`.
    #[error("gamma = {0} is out of range: it must be between 1 and {MAX_GAMMA:e}")]
    Gamma(f64),
    /// Rapidity negative, or with a gamma above `MAX_GAMMA`.
    #[error("rapidity = {0} is out of range: it must be between 0 and 69.77 (gamma = {MAX_GAMMA:e})")]
    Rapidity(f64),
}

/// A speed along +x, given as beta, gamma or rapidity.
///
/// beta alone cannot express what lies between 1 - 2^-53 and 1, so every function of the speed that
/// would need `1 - beta` or `gamma - 1` by subtraction is stored at construction instead.
///
/// # Accuracy
///
/// Each accessor is within [`crate::MAX_ERROR_UNITS`] units of `2^-53 (|f| + |x df/dx|)`, x being the
/// parameter it was built from. Measured (`tests/oracle`, 15,000 speeds): median 0.1, 99 % 2, worst 3.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Speed {
    beta: f64,
    gamma: f64,
    gamma_minus_one: f64,
    one_minus_beta: f64,
    inverse_gamma_squared: f64,
    rapidity: f64,
}

impl Speed {
    /// Speed 0.
    pub const REST: Self = Self {
        beta: 0.0,
        gamma: 1.0,
        gamma_minus_one: 0.0,
        one_minus_beta: 1.0,
        inverse_gamma_squared: 1.0,
        rapidity: 0.0,
    };

    /// From `beta` = v/c in [0, 1).
    ///
    /// # Examples
    ///
    /// ```
    /// use relativity_core::Speed;
    ///
    /// let speed = Speed::from_beta(0.6)?;
    /// assert!((speed.gamma() - 1.25).abs() < 1e-15);
    /// assert!((speed.head_on_doppler_factor() - 2.0).abs() < 1e-15);
    /// // An everyday speed keeps its digits: gamma - 1 is beta^2/2.
    /// let cyclist = Speed::from_beta(2e-8)?;
    /// assert!((cyclist.gamma_minus_one() / 2e-16 - 1.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_beta(beta: f64) -> Result<Self, SpeedError> {
        if !(0.0..1.0).contains(&beta) {
            return Err(SpeedError::Beta(beta));
        }
        let beta = beta.abs(); // -0.0 is rest too
        Ok(Self { rapidity: math::atanh(beta), ..Self::but_for_rapidity(beta) })
    }

    /// Returns the speed `beta` in [0, 1) without its rapidity, which takes as long as all that a row of a
    /// batch needs of a speed.
    #[inline]
    fn but_for_rapidity(beta: f64) -> Self {
        let inverse_gamma_squared = (-beta).mul_add(beta, 1.0); // rounded once
        let inverse_gamma = inverse_gamma_squared.sqrt();
        Self {
            beta,
            gamma: 1.0 / inverse_gamma,
            gamma_minus_one: beta * beta / (inverse_gamma * (1.0 + inverse_gamma)),
            one_minus_beta: 1.0 - beta,
            inverse_gamma_squared,
            rapidity: f64::NAN,
        }
    }

    /// From the Lorentz factor in [1, [`MAX_GAMMA`]].
    ///
    /// # Examples
    ///
    /// ```
    /// use relativity_core::Speed;
    ///
    /// let speed = Speed::from_gamma(1e12)?;
    /// assert_eq!(speed.beta(), 1.0); // rounded
    /// assert!((speed.one_minus_beta() / 5e-25 - 1.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_gamma(gamma: f64) -> Result<Self, SpeedError> {
        if !(1.0..=MAX_GAMMA).contains(&gamma) {
            return Err(SpeedError::Gamma(gamma));
        }
        // gamma - 1 is exact for gamma < 2, and gamma beta keeps its digits for all.
        let gamma_beta = (gamma - 1.0).sqrt() * (gamma + 1.0).sqrt();
        Ok(Self {
            beta: gamma_beta / gamma,
            gamma,
            gamma_minus_one: gamma - 1.0,
            one_minus_beta: 1.0 / (gamma * (gamma + gamma_beta)),
            inverse_gamma_squared: 1.0 / gamma / gamma,
            rapidity: math::asinh(gamma_beta),
        })
    }

    /// From the rapidity atanh(beta), 0 or more.
    ///
    /// # Examples
    ///
    /// ```
    /// use relativity_core::Speed;
    ///
    /// // Rapidities add up where betas do not: 0.5 and 0.5 make 0.8.
    /// let half = Speed::from_beta(0.5)?.rapidity();
    /// assert!((Speed::from_rapidity(half + half)?.beta() - 0.8).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_rapidity(rapidity: f64) -> Result<Self, SpeedError> {
        let gamma = math::cosh(rapidity);
        if !(rapidity >= 0.0 && gamma <= MAX_GAMMA) {
            return Err(SpeedError::Rapidity(rapidity));
        }
        let half_sinh = math::sinh(rapidity / 2.0);
        Ok(Self {
            beta: math::tanh(rapidity),
            gamma,
            gamma_minus_one: 2.0 * half_sinh * half_sinh,
            one_minus_beta: 2.0 / (math::exp(2.0 * rapidity) + 1.0),
            inverse_gamma_squared: 1.0 / gamma / gamma,
            rapidity: rapidity.abs(),
        })
    }

    /// From the proper velocity gamma beta, 0 or more.
    pub(crate) fn from_proper(proper: f64) -> Result<Self, SpeedError> {
        let gamma = math::hypot(1.0, proper);
        if !(proper >= 0.0 && gamma <= MAX_GAMMA) {
            return Err(SpeedError::Gamma(gamma));
        }
        Ok(Self {
            beta: proper / gamma,
            gamma,
            gamma_minus_one: proper * (proper / (gamma + 1.0)),
            one_minus_beta: 1.0 / (gamma * (gamma + proper)),
            inverse_gamma_squared: 1.0 / gamma / gamma,
            rapidity: math::asinh(proper),
        })
    }

    /// Proper velocity gamma beta, to full relative accuracy.
    #[must_use]
    pub fn proper(&self) -> f64 {
        self.gamma * self.beta
    }

    /// v/c, rounded to f64: from gamma of about 1e8 it is the last number before 1, or 1 itself.
    #[must_use]
    pub const fn beta(&self) -> f64 {
        self.beta
    }

    /// Returns the Lorentz factor gamma.
    #[must_use]
    pub const fn gamma(&self) -> f64 {
        self.gamma
    }

    /// gamma - 1, to full relative accuracy: the kinetic energy over the rest energy.
    #[must_use]
    pub const fn gamma_minus_one(&self) -> f64 {
        self.gamma_minus_one
    }

    /// 1 - beta, to full relative accuracy.
    #[must_use]
    pub const fn one_minus_beta(&self) -> f64 {
        self.one_minus_beta
    }

    /// 1/gamma^2 = 1 - beta^2, to full relative accuracy.
    #[must_use]
    pub const fn inverse_gamma_squared(&self) -> f64 {
        self.inverse_gamma_squared
    }

    /// Returns the rapidity, atanh(beta).
    #[must_use]
    pub const fn rapidity(&self) -> f64 {
        self.rapidity
    }

    /// The Doppler factor of a source approaching head-on, sqrt((1 + beta)/(1 - beta)).
    #[must_use]
    pub fn head_on_doppler_factor(&self) -> f64 {
        self.gamma * (1.0 + self.beta)
    }

    /// The coefficients of the light-cone solution, rounded once to `F`.
    #[inline]
    pub(crate) fn coefficients<F: Float>(&self) -> Coefficients<F> {
        let to = |v: f64| F::from(v).unwrap_or_else(F::infinity);
        Coefficients {
            beta: to(self.beta),
            gamma: to(self.gamma),
            gamma_minus_one: to(self.gamma_minus_one),
            one_minus_beta: to(self.one_minus_beta),
            inverse_gamma: to(1.0 / self.gamma),
            inverse_gamma_squared: to(self.inverse_gamma_squared),
            smallest_q: F::min_positive_value().sqrt(),
        }
    }
}

impl<F: Float> Coefficients<F> {
    /// Returns the coefficients of the speed `beta`. Outside [0, 1) their gamma is infinite or not a number.
    #[inline]
    pub(crate) fn of_beta(beta: f64) -> Self {
        // -0.0 is rest too.
        let beta = if beta >= 0.0 { beta.abs() } else { f64::NAN };
        Speed::but_for_rapidity(beta).coefficients()
    }
}

/// The numbers of a speed that the light-cone solution needs, in the precision it runs in.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Coefficients<F> {
    pub beta: F,
    pub gamma: F,
    pub gamma_minus_one: F,
    pub one_minus_beta: F,
    pub inverse_gamma: F,
    pub inverse_gamma_squared: F,
    /// The smallest length whose square does not underflow.
    pub smallest_q: F,
}
