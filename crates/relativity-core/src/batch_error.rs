//! Errors of a batch, with the column and the row.

use thiserror::Error;

use crate::aperture::Aperture;
use crate::apparent::check_inputs;
use crate::domain::DomainError;
use crate::real::Real;
use crate::source::SourcePoint;
use crate::speed::{Speed, SpeedError};

/// Why a batch was refused. The output columns are then partly written.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum BatchError {
    /// A column of another length than the first.
    #[error("column {column} has {found} rows instead of {expected}")]
    Length {
        /// The first column of another length.
        column: &'static str,
        /// Rows of the first column.
        expected: usize,
        /// Rows of this column.
        found: usize,
    },
    /// A row outside the domain.
    #[error("row {index}: {column} = {value:e} is not a number between -{limit:e} and {limit:e}")]
    Row {
        /// Index of the first such row.
        index: usize,
        /// The column with that value.
        column: &'static str,
        /// Value that is outside the domain.
        value: f64,
        /// Largest magnitude allowed, [`Real::MAX_COORDINATE`].
        limit: f64,
    },
    /// A row whose beta is not one.
    #[error("row {index}: {error}")]
    Speed {
        /// Index of the row.
        index: usize,
        /// Reason why its beta is refused.
        error: SpeedError,
    },
    /// A value common to all rows outside the domain.
    #[error(transparent)]
    Common(#[from] DomainError),
    /// A value too large for f32.
    #[error(
        "{0:e} is too large for f32: at most {length:e} as a coordinate or time, at most {gamma:e} as gamma",
        length = <f32 as Real>::MAX_COORDINATE, gamma = <f32 as Real>::MAX_GAMMA
    )]
    Single(f64),
}

pub(crate) fn check_lengths(expected: usize, columns: &[(&'static str, usize)]) -> Result<(), BatchError> {
    match columns.iter().find(|(_, found)| *found != expected) {
        Some(&(column, found)) => Err(BatchError::Length { column, expected, found }),
        None => Ok(()),
    }
}

pub(crate) fn check_common<F: Real>(
    speed: &Speed,
    point: SourcePoint,
    apertures: &[Aperture],
    observation_time: f64,
) -> Result<(), BatchError> {
    if speed.gamma() > F::MAX_GAMMA {
        return Err(BatchError::Single(speed.gamma()));
    }
    for &aperture in apertures {
        check_inputs(point, aperture, observation_time)?;
        let common = [point.x0, point.y, point.z, aperture.x, aperture.y, aperture.z, observation_time];
        if let Some(&value) = common.iter().find(|v| v.abs() > F::MAX_COORDINATE.into()) {
            return Err(BatchError::Single(value));
        }
    }
    Ok(())
}

/// The error of the first row with a value outside the domain.
#[cold]
pub(crate) fn first_outside<F: Real>(columns: &[(&'static str, &[F])]) -> Result<(), BatchError> {
    let outside = |value: &F| value.is_nan() || value.abs() > F::MAX_COORDINATE;
    let firsts = columns.iter().filter_map(|&(column, values)| {
        values.iter().position(outside).map(|index| (index, column, values[index]))
    });
    match firsts.min_by_key(|&(index, ..)| index) {
        Some((index, column, value)) => {
            Err(BatchError::Row { index, column, value: value.into(), limit: F::MAX_COORDINATE.into() })
        }
        None => Ok(()),
    }
}
