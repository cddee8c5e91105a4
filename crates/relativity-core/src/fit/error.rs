//! Why a fit has no result, in words and with the numbers.

use thiserror::Error;

use crate::domain::DomainError;

/// Why there is no result.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FitError {
    /// A coordinate outside the domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A sample holds something that is not a measurement.
    #[error("sample {index}: {quantity} = {value} is not usable")]
    Sample {
        /// Number of the sample, from 0.
        index: usize,
        /// Field of the sample that is not usable.
        quantity: &'static str,
        /// Value of that field.
        value: f64,
    },
    /// A pair of apertures that measures nothing, or that the model does not cover.
    #[error("pair {pair} of apertures: {problem}")]
    Pair {
        /// Number of the pair, from 0.
        pair: usize,
        /// Problem with the pair, in words.
        problem: &'static str,
    },
    /// Some readings of a curve have a sigma and some have none, so that they cannot be weighed.
    #[error("{with} of {of} readings of {curve} have a sigma: give it for all or for none")]
    MixedSigma {
        /// Name of the curve, dphi or dtheta.
        curve: &'static str,
        /// Readings with a sigma.
        with: usize,
        /// Number of readings.
        of: usize,
    },
    /// Fewer samples than the parameters need.
    #[error("{samples} samples of {curves} are too few: {parameters} parameters need at least {needed}")]
    TooFew {
        /// Number of usable samples.
        samples: usize,
        /// Names of the curves that were to be fitted.
        curves: &'static str,
        /// Number of fitted parameters.
        parameters: usize,
        /// Least number of samples.
        needed: usize,
    },
    /// The curve does not change by more than its noise.
    #[error("the curve of {curves} is flat: it varies by {range:e} rad, no more than its noise")]
    Flat {
        /// Names of the curves that were to be fitted.
        curves: &'static str,
        /// Largest minus smallest value, radians.
        range: f64,
    },
    /// A guess that is not an object in front of the apertures.
    #[error("no guess: beta = {beta} must lie between 0 and 1, y = {y} above 0, and z and x0 be numbers")]
    Guess {
        /// Speed beta of the best trial.
        beta: f64,
        /// Depth y of the best trial.
        y: f64,
    },
    /// The search ended before a minimum was found.
    #[error("not converged: {0}")]
    NotConverged(NotConverged),
    /// The best fit leaves most of the data's variation unexplained.
    #[error(
        "no object fits by this model: the best fit leaves {:.0} % of the curve's variation unexplained", 100.0 * .share
    )]
    Unexplained {
        /// Unexplained share of the sum of squares, 0 to 1.
        share: f64,
    },
    /// Parameters that the data do not separate.
    #[error(
        "the data cannot tell {parameter} from {partner}: {parameter} = {value:.3e} {}, correlation {correlation:.6}",
        spread(*.standard_error)
    )]
    Indistinguishable {
        /// The parameter that is least determined.
        parameter: &'static str,
        /// Best value, which means nothing.
        value: f64,
        /// Standard error; infinite if the data do not depend on the parameter.
        standard_error: f64,
        /// The parameter whose change can compensate for this one.
        partner: &'static str,
        /// Correlation between the two parameters.
        correlation: f64,
    },
    /// The best fit is where the data do not depend on a parameter.
    #[error(
        "the data cannot tell {parameter}: near {parameter} = {value:.3e}, where they fit best, they do not depend on it"
    )]
    Insensitive {
        /// The parameter on which nothing depends there.
        parameter: &'static str,
        /// Best value, which means nothing.
        value: f64,
    },
    /// Too many bootstrap replicates have no fit.
    #[error(
        "{failed} of {replicates} bootstrap replicates have no fit: the model may be wrong for these data, or the data \
         too few or too noisy"
    )]
    Bootstrap {
        /// Replicates without a fit.
        failed: usize,
        /// Number of replicates drawn.
        replicates: usize,
    },
}

/// A standard error in words; where it is infinite there is no number to give.
fn spread(standard_error: f64) -> String {
    if standard_error.is_finite() {
        format!("+- {standard_error:.1e}")
    } else {
        "or anything else".to_owned()
    }
}

/// Why the search for a minimum ended without one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NotConverged {
    /// None of the objects tried at first shows finite disparities.
    #[error("no starting point of the search has finite disparities")]
    NoStart,
    /// The sum of squares was still falling.
    #[error("after {evaluations} evaluations of the curves the sum of squares still falls")]
    StillFalling {
        /// Evaluations of all curves since the last start.
        evaluations: usize,
    },
    /// The search came to an object whose disparities are not finite.
    #[error("the search leads to objects whose disparities are not finite")]
    NotFinite,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_infinite_standard_error_is_said_in_words() {
        let told = |standard_error| {
            let (parameter, value, partner, correlation) = ("z", -118.7, "beta", 1.0);
            let error =
                FitError::Indistinguishable { parameter, value, standard_error, partner, correlation };
            error.to_string()
        };
        let begin = "the data cannot tell z from beta: z = -1.187e2 ";
        assert_eq!(told(2000.0), format!("{begin}+- 2.0e3, correlation 1.000000"));
        assert_eq!(told(f64::INFINITY), format!("{begin}or anything else, correlation 1.000000"));
    }
}
