//! Observations: disparities of one moving point, sample by sample, and the apertures that measured them.

use std::f64::consts::TAU;

use crate::aperture::Aperture;
use crate::domain::check;
use crate::fit::error::FitError;

/// A measured angle, with its uncertainty.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Reading {
    /// Measured angle, radians.
    pub value: f64,
    /// Standard deviation of the angle, radians, above 0; `None` if unknown.
    pub sigma: Option<f64>,
}

/// Readings of one pair of apertures at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sample {
    /// T: when the light was received.
    pub time: f64,
    /// Number of the pair of apertures, among the observation's, that measured the sample.
    pub pair: usize,
    /// Delta-phi, if it was measured.
    pub dphi: Option<Reading>,
    /// Delta-theta, if it was measured.
    pub dtheta: Option<Reading>,
}

impl Sample {
    /// Returns the readings of both curves: Delta-phi and Delta-theta.
    #[must_use]
    pub const fn readings(&self) -> [Option<Reading>; 2] {
        [self.dphi, self.dtheta]
    }
}

/// The samples of one moving point, and the pairs of apertures (primary, secondary) they refer to.
///
/// N apertures give up to N (N - 1)/2 pairs; those that share the primary are enough.
///
/// # Examples
///
/// ```
/// use relativity_core::{FitError, Observations, Reading, Sample};
///
/// let reading = |value| Some(Reading { value, sigma: Some(1e-3) });
/// let sample = |time, dphi| Sample { time, pair: 0, dphi: reading(dphi), dtheta: None };
/// let observed = Observations::of_pair(0.1, vec![sample(0.0, -0.02), sample(1.0, -0.03)])?;
/// assert_eq!(observed.samples().len(), 2);
///
/// let refused = Observations::of_pair(0.1, vec![sample(f64::NAN, -0.02)]);
/// assert!(matches!(refused, Err(FitError::Sample { index: 0, quantity: "T", .. })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Observations {
    pub(super) pairs: Vec<[Aperture; 2]>,
    pub(super) samples: Vec<Sample>,
}

impl Observations {
    /// Checks that every number is one, that every sample names a pair, and that both apertures of a
    /// pair differ.
    ///
    /// # Errors
    ///
    /// [`FitError::Sample`], [`FitError::Pair`] and [`FitError::Domain`] name what is wrong.
    pub fn new(pairs: Vec<[Aperture; 2]>, samples: Vec<Sample>) -> Result<Self, FitError> {
        for (index, [primary, secondary]) in pairs.iter().enumerate() {
            for aperture in [primary, secondary] {
                check("aperture x", aperture.x)?;
                check("aperture y", aperture.y)?;
                check("aperture z", aperture.z)?;
            }
            if primary == secondary {
                return Err(FitError::Pair { pair: index, problem: "its two apertures are one" });
            }
        }
        for (index, sample) in samples.iter().enumerate() {
            check_sample(sample, pairs.len()).map_err(|(quantity, value)| FitError::Sample {
                index,
                quantity,
                value,
            })?;
        }
        Ok(Self { pairs, samples })
    }

    /// Samples of the paper's pair of apertures, `separation` apart on the x axis.
    ///
    /// # Errors
    ///
    /// As [`Self::new`].
    pub fn of_pair(separation: f64, samples: Vec<Sample>) -> Result<Self, FitError> {
        Self::new(vec![Aperture::pair(separation)], samples)
    }

    /// The samples, in the order given.
    #[must_use]
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// The pairs of apertures.
    #[must_use]
    pub fn pairs(&self) -> &[[Aperture; 2]] {
        &self.pairs
    }
}

fn check_sample(sample: &Sample, pairs: usize) -> Result<(), (&'static str, f64)> {
    check("T", sample.time).map_err(|error| (error.name, error.value))?;
    if sample.pair >= pairs {
        return Err(("pair", sample.pair as f64));
    }
    let curves = [("dphi", "sigma_dphi", sample.dphi), ("dtheta", "sigma_dtheta", sample.dtheta)];
    for (name, sigma_name, reading) in curves {
        let Some(Reading { value, sigma }) = reading else { continue };
        // The difference of two angles, each in a range of a whole turn.
        if !(-TAU..=TAU).contains(&value) {
            return Err((name, value));
        }
        // The square of a weight, 1/sigma^2, must be a number.
        if let Some(sigma) = sigma.filter(|sigma| !(1e-150..1e150).contains(sigma)) {
            return Err((sigma_name, sigma));
        }
    }
    Ok(())
}
