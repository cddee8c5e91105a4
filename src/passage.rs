//! Where a passing point is shown: places by its distance from the eyes as it passes x = 0.

use relativity_core::{DomainError, SourcePoint, Speed, equidistance_time, observation_time_when_seen_at};

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
    // Light from x = 0 at t = 0 arrives after R.
    let Some(distance) = equidistance_time(speed, SourcePoint { x0: 0.0, ..point }, separation)? else {
        return Ok(None);
    };
    observation_time_when_seen_at(speed, point, ratio * distance, separation)
}

/// The observation times from which to which `point` is seen to pass: at x = -2 R and at x = +2 R; `None` at rest.
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
