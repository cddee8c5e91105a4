//! The range of coordinates and times in which every result is finite.

use thiserror::Error;

/// Largest magnitude of a coordinate or time.
///
/// With gamma up to [`crate::MAX_GAMMA`] the largest intermediate is a product of two apparent
/// positions, `(gamma^2 S)^2 <= (4e120)^2`, well inside f64.
pub const MAX_COORDINATE: f64 = 1e60;

/// An input outside the domain.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("{name} = {value:e} is not a number between -{MAX_COORDINATE:e} and {MAX_COORDINATE:e}")]
pub struct DomainError {
    /// The input's name, as in the documentation.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
}

/// Passes `value` through if it is inside the domain.
pub fn check(name: &'static str, value: f64) -> Result<f64, DomainError> {
    if value.abs() <= MAX_COORDINATE { Ok(value) } else { Err(DomainError { name, value }) }
}
