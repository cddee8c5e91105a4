//! The passage of a point: places by its distance from the eyes as it passes x = 0.

use relativity_core::math;
use relativity_core::{Aperture, DomainError, SourcePoint, Speed, observation_time_when_seen_at};

/// The observation time at which `point` is seen at x = `ratio` R by the `pair`, R being its distance from
/// the eyes as it passes x = 0; `None` at rest.
///
/// # Errors
///
/// A coordinate outside the domain of the core.
pub fn time_seen_at(
    ratio: f64,
    speed: &Speed,
    point: SourcePoint,
    pair: [Aperture; 2],
) -> Result<Option<f64>, DomainError> {
    // Light from x = 0 at t = 0 arrives after R.
    let passing = SourcePoint { x0: 0.0, ..point };
    let Some(distance) = observation_time_when_seen_at(speed, passing, 0.0, pair)? else {
        return Ok(None);
    };
    observation_time_when_seen_at(speed, point, ratio * distance, pair)
}

/// The T at a `fraction` of the way from the first to the last of a range: exact at both ends.
#[must_use]
pub fn time_within([from, to]: [f64; 2], fraction: f64) -> f64 {
    from * (1.0 - fraction) + to * fraction
}

/// The observation times from which to which `point` is seen to pass: at x = -2 R and at x = +2 R; `None` at
/// rest.
///
/// # Errors
///
/// A coordinate outside the domain of the core.
pub fn passage_times(
    speed: &Speed,
    point: SourcePoint,
    pair: [Aperture; 2],
) -> Result<Option<[f64; 2]>, DomainError> {
    let time = |ratio| time_seen_at(ratio, speed, point, pair);
    Ok(time(-2.0)?.zip(time(2.0)?).map(|(first, last)| [first, last]))
}

/// When `point` is seen 45 degrees before it is abreast: near enough to look at, and still approaching. Slow
/// passages take so long that it lies before the [`fitted_range`]; then it is the first T of that. 0 at rest.
///
/// # Errors
///
/// A coordinate outside the domain of the core.
pub fn time_of_approach(speed: &Speed, point: SourcePoint, pair: [Aperture; 2]) -> Result<f64, DomainError> {
    if speed.beta() == 0.0 {
        return Ok(0.0);
    }
    let [from, to] = fitted_range(speed, point, pair);
    Ok(time_seen_at(-1.0, speed, point, pair)?.map_or(from, |time| time.clamp(from, to)))
}

/// Slowest beta that the fitted range makes room for; slower passages are shown in part.
const SLOWEST_FITTED_BETA: f64 = 0.2;
/// Smallest passing distance that the fitted range makes room for.
const NEAREST_FITTED_DISTANCE: f64 = 0.05;

/// First and last T of a range that shows `point` approaching, abreast and receding, to the middle between
/// the `pair` and to both of them.
#[must_use]
pub fn fitted_range(speed: &Speed, point: SourcePoint, pair: [Aperture; 2]) -> [f64; 2] {
    let slowest = Speed::from_beta(SLOWEST_FITTED_BETA).expect("it is below 1");
    let speed = if speed.beta() < slowest.beta() { slowest } else { *speed };
    let [from, to] = range_of(&speed, point, Aperture::default(), [-2.0, 3.0]);
    // Eyes near each other are shown enough by that.
    pair.map(|eye| range_of(&speed, point, eye, [-1.0, 1.0]))
        .into_iter()
        .fold([from, to], |[from, to], [first, last]| [first.min(from), last.max(to)])
}

/// The T at which the `eye` sees `point` abreast, and these numbers of passing distances sooner and later.
fn range_of(speed: &Speed, point: SourcePoint, eye: Aperture, distances: [f64; 2]) -> [f64; 2] {
    let nearest = math::hypot(point.y - eye.y, point.z - eye.z).max(NEAREST_FITTED_DISTANCE);
    let passing = SourcePoint { y: eye.y + nearest, z: eye.z, ..point };
    // What is shown lies inside the domain of the core.
    let abreast =
        observation_time_when_seen_at(speed, passing, 0.0, [eye; 2]).ok().flatten().unwrap_or_default();
    distances.map(|distances| abreast + distances * nearest / speed.beta())
}

/// Returns the first time within `range` at which something `has_come`, to the last digit, by bisection:
/// before that time it never has, and from then on it always has. The end of the range, if it has not come
/// until then.
#[must_use]
pub fn first_time([mut before, mut after]: [f64; 2], has_come: impl Fn(f64) -> bool) -> f64 {
    loop {
        let middle = before.midpoint(after);
        if middle <= before || middle >= after {
            return after;
        }
        *(if has_come(middle) { &mut after } else { &mut before }) = middle;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use relativity_core::sighting;

    const TRACKED: SourcePoint = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };

    #[test]
    fn fitted_range_shows_approach_and_recession() {
        for beta in [0.2, 0.6, 0.9, 0.9999] {
            let speed = Speed::from_beta(beta).expect("in range");
            let [from, to] = fitted_range(&speed, TRACKED, Aperture::pair(0.1));
            let x = |time| {
                sighting(&speed, TRACKED, Aperture::default(), time).expect("in the domain").position[0]
            };
            let distance = 13f64.sqrt();
            assert!(x(from) < -2.0 * distance && x(to) > 0.8 * distance, "beta = {beta}");
        }
    }

    /// Eyes wide apart see it pass one long after the other; eyes near each other leave the range as it is.
    #[test]
    fn the_fitted_range_shows_the_passage_to_both_eyes() {
        for beta in [0.2, 0.9, 0.9999] {
            let speed = Speed::from_beta(beta).expect("in range");
            let alone = fitted_range(&speed, TRACKED, Aperture::pair(0.0));
            for d in [1e-3, 0.1, 2.0] {
                assert_eq!(fitted_range(&speed, TRACKED, Aperture::pair(d)), alone, "beta = {beta}, d = {d}");
            }
            for pair in [
                Aperture::pair(1000.0),
                Aperture::pair(20.0),
                [-40.0, 40.0].map(|y| Aperture { x: 0.0, y, z: 0.0 }),
            ] {
                let [from, to] = fitted_range(&speed, TRACKED, pair);
                assert!(from <= alone[0] && to >= alone[1]);
                for eye in pair {
                    let x = |time| sighting(&speed, TRACKED, eye, time).expect("in the domain").position[0];
                    assert!(x(from) < 0.0 && x(to) > 0.0, "beta = {beta}, {eye:?}: {} to {}", x(from), x(to));
                }
            }
        }
    }

    #[test]
    fn approach_is_seen_at_45_degrees() {
        let speed = Speed::from_beta(0.9).expect("in range");
        let time = time_of_approach(&speed, TRACKED, Aperture::pair(0.0)).expect("in the domain");
        let seen = sighting(&speed, TRACKED, Aperture::default(), time).expect("in the domain");
        assert!((seen.position[0] + 13f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn the_time_of_approach_is_in_the_fitted_range_and_0_at_rest() {
        for beta in [1e-300, 0.01, 0.19, 0.2, 0.9] {
            for x0 in [-10.0, 0.0, 10.0] {
                let (speed, point) =
                    (Speed::from_beta(beta).expect("in range"), SourcePoint { x0, ..TRACKED });
                let [from, to] = fitted_range(&speed, point, Aperture::pair(10.0));
                let time = time_of_approach(&speed, point, Aperture::pair(10.0)).expect("in the domain");
                assert!((from..=to).contains(&time), "beta = {beta}, x0 = {x0}: {time}");
            }
        }
        assert_eq!(time_of_approach(&Speed::REST, TRACKED, Aperture::pair(0.1)), Ok(0.0));
    }
}
