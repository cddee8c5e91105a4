//! The range of observation times in which a point is seen to pass.

use relativity_core::{DomainError, SourcePoint, Speed, equidistance_time};

/// The observation times at which `point` is seen at x = -2 R and at x = +2 R, R being its distance from
/// the eyes as it passes x = 0; `None` at rest.
///
/// # Errors
///
/// A coordinate outside the domain of the core.
pub fn passage_times(
    speed: &Speed,
    point: SourcePoint,
    separation: f64,
) -> Result<Option<[f64; 2]>, DomainError> {
    let at_origin = SourcePoint { x0: 0.0, ..point };
    let Some(distance) = equidistance_time(speed, at_origin, separation)? else { return Ok(None) };
    // Light from x = -2 R and +2 R leaves at these times, and travels sqrt(5) R.
    let time = |x: f64| (x * distance - point.x0) / speed.beta() + 5.0_f64.sqrt() * distance;
    Ok(Some([time(-2.0), time(2.0)]))
}
