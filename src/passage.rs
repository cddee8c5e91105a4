//! The observation times at which a passing point is seen at a given place.

use relativity_core::math;
use relativity_core::{DomainError, SourcePoint, Speed, equidistance_time};

/// The observation time at which `point` is seen at x = `ratio` R, R being its distance from the eyes as it
/// passes x = 0; `None` at rest.
///
/// # Errors
///
/// A coordinate outside the domain of the core.
pub fn time_seen_at(
    ratio: f64,
    speed: &Speed,
    point: SourcePoint,
    separation: f64,
) -> Result<Option<f64>, DomainError> {
    let at_origin = SourcePoint { x0: 0.0, ..point };
    let Some(distance) = equidistance_time(speed, at_origin, separation)? else { return Ok(None) };
    let emitted = (ratio * distance - point.x0) / speed.beta();
    Ok(Some(emitted + math::hypot(ratio, 1.0) * distance))
}

/// The observation times at which `point` is seen at x = -2 R and at x = +2 R; `None` at rest.
///
/// # Errors
///
/// A coordinate outside the domain of the core.
pub fn passage_times(
    speed: &Speed,
    point: SourcePoint,
    separation: f64,
) -> Result<Option<[f64; 2]>, DomainError> {
    let time = |ratio| time_seen_at(ratio, speed, point, separation);
    Ok(time(-2.0)?.zip(time(2.0)?).map(|(first, last)| [first, last]))
}
