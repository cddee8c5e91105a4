//! When a passing point is seen at a given place.
//!
//! Reference: the paper, eq. (6).

use crate::aperture::Aperture;
use crate::apparent::check_inputs;
use crate::domain::{DomainError, MAX_COORDINATE, check};
use crate::one_cone::middle;
use crate::source::Source;
use crate::source::SourcePoint;
use crate::speed::Speed;

/// From this many times the nearest distance on a point is far ahead: its distance nearly cancels x.
const FAR_AHEAD: f64 = 2.0;

/// The observation time at which `point` is seen at `x` by the `pair` of apertures, all from the middle
/// between them: `(x - x0)/beta + sqrt(x^2 + y^2 + z^2 + d^2/4)`, d being the distance between the apertures.
///
/// That is when the point was at `x`, and the root mean square of the distances from there to both apertures.
/// One aperture (a pair in one place) sees the point at `x` exactly then; of two, each does a little before
/// or after, and where it is as far from both, both at once.
///
/// At rest (beta = 0) a point is seen at `x` always or never, so there is no such time: `None`.
/// Nor is there one if it is too far off for an f64, which takes an absurdly small beta.
///
/// # Accuracy
///
/// As [`crate::sighting`]. Measured for the paper's pair (`tests/oracle`, 15,000 inputs): median 0.2, 99 %
/// 1.1, worst 4 units.
///
/// # Errors
///
/// A coordinate outside the domain.
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, SourcePoint, Speed, observation_time_when_seen_at, sighting};
///
/// let speed = Speed::from_beta(0.6)?;
/// let point = SourcePoint { x0: 0.0, y: 4.0, z: 0.0 };
/// // It is at x = 3 at t = 3/0.6 = 5, and its light takes as long again.
/// let time = observation_time_when_seen_at(&speed, point, 3.0, Aperture::pair(0.0))?.ok_or("at rest")?;
/// assert!((time - 10.0).abs() < 1e-14);
/// let seen = sighting(&speed, point, Aperture::default(), time)?;
/// assert!((seen.position[0] - 3.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn observation_time_when_seen_at(
    speed: &Speed,
    point: SourcePoint,
    x: f64,
    pair: [Aperture; 2],
) -> Result<Option<f64>, DomainError> {
    check("x", x)?;
    check_inputs(point, pair[0], 0.0)?;
    check_inputs(point, pair[1], 0.0)?;
    Ok(if speed.beta() == 0.0 { None } else { time_when_seen_at(speed, point, x, pair) })
}

/// Returns that time for inputs that have been checked and a point that moves.
fn time_when_seen_at(speed: &Speed, point: SourcePoint, x: f64, pair: [Aperture; 2]) -> Option<f64> {
    let (point, half) = (point.relative_to(middle(pair)), baseline(pair).map(|along| along / 2.0));
    let half_squared = half[0] * half[0] + half[1] * half[1] + half[2] * half[2];
    let nearest = (half_squared + point.y * point.y + point.z * point.z).sqrt();
    let (beta, distance) = (speed.beta(), diagonal(x.abs(), nearest));
    let time = if x < -FAR_AHEAD * nearest {
        // x/beta + distance, of which at high speed little is left, without the subtraction.
        let lead = nearest * nearest / (distance - x) + x * (speed.one_minus_beta() / beta);
        lead - point.x0 / beta
    } else {
        (x - point.x0) / beta + distance
    };
    time.is_finite().then_some(time)
}

/// From the first to the second aperture.
fn baseline([primary, secondary]: [Aperture; 2]) -> [f64; 3] {
    [secondary.x - primary.x, secondary.y - primary.y, secondary.z - primary.z]
}

/// T0: the observation time at which `source` is seen equidistant from both apertures of a `pair`: the point
/// itself, of one of a wheel as [`WheelPoint::place_when_passing`](crate::WheelPoint::place_when_passing).
///
/// Both then receive one event, in the plane halfway between them: at x = -(`b_y` y + `b_z` z)/`b_x` from
/// their middle, b being from one aperture to the other. For the paper's pair that is at x = 0 (eq. 6 of the
/// paper, shifted by -x0/beta for a point not on x(0) = 0). Of a pair across the motion (`b_x` = 0) a point
/// is as far from both always or never: `None`. Two apertures in one place stand for the limit of the
/// paper's.
///
/// # Accuracy
///
/// As [`observation_time_when_seen_at`]; of pairs of any direction and separation median 0.2, 99 % 1.3, worst
/// 6.1 units.
///
/// # Errors
///
/// A coordinate outside the domain.
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, SourcePoint, Speed, equidistance_time};
///
/// // The paper's section 3 has 0.72.
/// let point = SourcePoint { x0: 0.0, y: 0.5, z: 0.5 };
/// let t0 = equidistance_time(&Speed::from_beta(0.9)?, point, Aperture::pair(0.3))?;
/// assert!((t0.ok_or("at rest")? - 0.7228).abs() < 5e-5);
/// assert_eq!(equidistance_time(&Speed::REST, point, Aperture::pair(0.3))?, None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn equidistance_time(
    speed: &Speed,
    source: impl Into<Source>,
    pair: [Aperture; 2],
) -> Result<Option<f64>, DomainError> {
    let source = source.into();
    for aperture in pair {
        check_inputs(source, aperture, 0.0)?;
    }
    let [bx, by, bz] = baseline(pair);
    let is_along = [by, bz] == [0.0; 2];
    let point = match source.simplest() {
        Source::Point(point) => point,
        Source::Wheel(wheel) => {
            let normal = if is_along { [1.0, 0.0, 0.0] } else { [bx, by, bz] };
            let Some(place) = wheel.place_when_passing(speed, middle(pair), normal) else { return Ok(None) };
            place
        }
    };
    if is_along {
        return observation_time_when_seen_at(speed, point, 0.0, pair);
    }
    let SourcePoint { y, z, .. } = point.relative_to(middle(pair));
    let x = -(by * y + bz * z) / bx;
    let exists = speed.beta() != 0.0 && x.abs() <= MAX_COORDINATE;
    Ok(if exists { time_when_seen_at(speed, point, x, pair) } else { None })
}

/// sqrt(a^2 + b^2) of two lengths: the longer one times a factor, which is the same for the same ratio of the
/// two.
fn diagonal(a: f64, b: f64) -> f64 {
    let (short, long) = if a < b { (a, b) } else { (b, a) };
    let ratio = if long > 0.0 { short / long } else { 0.0 };
    long * (1.0 + ratio * ratio).sqrt()
}
