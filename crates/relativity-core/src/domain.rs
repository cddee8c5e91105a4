//! The range of coordinates and times in which every result is finite.

use std::ops::RangeInclusive;

use thiserror::Error;

/// Largest magnitude of a coordinate or time.
///
/// With gamma up to [`crate::MAX_GAMMA`] the largest intermediate is a product of two apparent
/// positions, `(gamma^2 S)^2 <= (4e120)^2`, well inside f64.
pub const MAX_COORDINATE: f64 = 1e60;

/// An input outside the domain.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("{name} = {value:e} is not a number between {least:e} and {most:e}")]
pub struct DomainError {
    /// The input's name, as in the documentation.
    pub name: &'static str,
    /// Value that is outside the domain.
    pub value: f64,
    /// The least value inside the domain.
    pub least: f64,
    /// The greatest value inside the domain.
    pub most: f64,
}

/// Passes `value` through if it is inside the domain of coordinates and times.
pub fn check(name: &'static str, value: f64) -> Result<f64, DomainError> {
    check_in(name, value, -MAX_COORDINATE..=MAX_COORDINATE)
}

/// Passes `value` through if it is inside `range`.
pub(crate) fn check_in(
    name: &'static str,
    value: f64,
    range: RangeInclusive<f64>,
) -> Result<f64, DomainError> {
    let (least, most) = range.into_inner();
    if (least..=most).contains(&value) { Ok(value) } else { Err(DomainError { name, value, least, most }) }
}
