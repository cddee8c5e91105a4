//! The stereo position: the place at which the lines of sight of two eyes meet, where a person with two eyes
//! would place the point.
//!
//! Derived here; not in the paper. The paper's pair of apertures lies along the motion, so both see the same
//! y and z, and the lines from the left one at (-d/2, 0, 0) along (`X_l`, y, z) and from the right one at
//! (d/2, 0, 0) along (`X_r`, y, z) meet: at lambda = d/(`X_l` - `X_r`) of either. Beside a resting point
//! lambda would be 1.
//!
//! Any other pair, b from one to the other, has lines of sight `P_l` and `P_r` that differ by b + w, w being
//! -beta (`R_l` - `R_r`) along x, and pass each other. With P their mean, the shortest connection of the two
//! lies along n = `P_l` x `P_r` = (b + w) x P and is |w.n|/|n| long. It leaves the lines at the fractions (b
//! x P).n/n^2 +- (w x b).n/(2 n^2) of their lengths.
//!
//! A point of a wheel is elsewhere when the other eye sees it, in height too: its w has a part in z.

use thiserror::Error;

use crate::aperture::Aperture;
use crate::apparent::check_inputs;
use crate::cone_pair::{ConePair, Offset, SightPair};
use crate::domain::DomainError;
use crate::one_cone::middle;
use crate::source::Source;
use crate::speed::Speed;

/// Why there is no stereo position.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum StereoError {
    /// A coordinate or time outside the domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A published model, of this name, whose two directions start from one aperture.
    #[error("the model {0} has no stereo position: it measures both eyes' angles from the left eye")]
    Published(&'static str),
    /// Lines of sight that are parallel, or diverge.
    #[error("the lines of sight of both eyes do not meet in front of them")]
    Apart,
}

/// The stereo position of one point, and how its parallax differs from a resting point's.
///
/// When the point is inside both apertures (distance 0, the apertures in one place) the gain is gamma^2 by
/// definition, as the Doppler factor is gamma there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stereo {
    /// Stereo gain, above 0: the factor by which the eyes would have to be further apart to see this parallax
    /// at a resting point in the same place. It is the part of the parallax across the line of sight in the
    /// direction that a resting point's has, over that. (The line of sight is the mean of both.) For eyes
    /// along x and a point that moves along x that is all of it, (`X_left` - `X_right`)/d, and near gamma D as
    /// d -> 0.
    pub gain: f64,
    /// The middle of the shortest connection of both lines of sight, from the middle between the eyes. Of
    /// eyes along x it is, as d -> 0, the apparent position over gamma D.
    pub position: [f64; 3],
    /// Length of that connection: the distance by which the lines of sight miss each other. 0 for eyes along
    /// x.
    pub miss: f64,
}

impl Stereo {
    /// The distance at which two eyes place the point, from the middle between them. Of eyes along x it is,
    /// as d -> 0, the rest-frame distance over gamma.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.position.map(|along| along * along).iter().sum::<f64>().sqrt()
    }
}

/// Returns the stereo position of `source` for the `pair` of apertures at `observation_time`.
///
/// Each aperture has a light cone of its own. Nothing changes where the apertures swap their places, and two
/// in one place stand for the limit of those along x.
///
/// # Accuracy
///
/// As [`crate::sighting`], however close the apertures are: the gain of apertures along x is (`R_l` +
/// `R_r`)/(`q_l` + `q_r`) with q = sqrt(S^2 + rho^2/gamma^2), in which there is nothing to subtract, and of
/// others no difference of two sightings is formed either. For the paper's pair the unit's inputs are the
/// speed, x0, y, z, T and d; for others each aperture's place stands for d, and what is as near as they are
/// apart is known to the rounding of that. Measured for gain, position and miss (`tests/oracle`, 15,000
/// inputs each): median 0.2, 99 % 2.7, worst 5.5 units.
///
/// # Errors
///
/// A coordinate or time outside the domain; lines of sight that do not meet in front of both apertures, which
/// those of apertures along x always do.
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, Baseline, SourcePoint, Speed, stereo};
///
/// // At beta = 0.6 it is seen at (-3, 4, 0), with D = 1/(1.25 0.64) and so a gain of 1/0.64 ...
/// let speed = Speed::from_beta(0.6)?;
/// let point = SourcePoint { x0: 0.0, y: 4.0, z: 0.0 };
/// let fused = stereo(&speed, point, Aperture::pair(0.0), 0.0)?;
/// assert!((fused.gain - 1.5625).abs() < 1e-15);
/// // ... and taken to be in the same direction, 0.64 times as far.
/// assert!((fused.position[0] + 1.92).abs() < 1e-15 && (fused.position[1] - 2.56).abs() < 1e-15);
/// assert!((fused.distance() - 3.2).abs() < 1e-15);
/// // Eyes above each other take it to be where it is seen.
/// let above = Baseline { roll: std::f64::consts::FRAC_PI_2, ..Baseline::straight(0.01) };
/// let fused = stereo(&speed, point, above.apertures(), 0.0)?;
/// assert!((fused.distance() - 5.0).abs() < 1e-4 && fused.miss == 0.0);
/// // A resting point is taken to be where it is, whatever the separation.
/// assert_eq!(stereo(&Speed::REST, point, Aperture::pair(0.5), 0.0)?.position, [0.0, 4.0, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn stereo(
    speed: &Speed,
    source: impl Into<Source>,
    pair: [Aperture; 2],
    observation_time: f64,
) -> Result<Stereo, StereoError> {
    let source = source.into();
    let [left, right] = checked(pair, source, observation_time)?;
    let point = match source.simplest() {
        Source::Point(point) => point,
        Source::Wheel(wheel) => return wheel.stereo(speed, pair, observation_time),
    };
    let cones = ConePair::new(&speed.coefficients(), point, left, right, observation_time);
    if let Some(fused) = along_motion(speed, &cones) {
        return Ok(fused);
    }
    let Aperture { y, z, .. } = middle(pair);
    let lines = cones.lines_of_sight(point.y - y, point.z - z).ok_or(StereoError::Apart)?;
    let Offset { s, y, z } = cones.offset;
    meeting(&lines, [s, y, z]).ok_or(StereoError::Apart)
}

/// The stereo position for apertures along the motion, whose lines of sight always meet; `None` for others.
pub(crate) fn along_motion(speed: &Speed, cones: &ConePair<f64>) -> Option<Stereo> {
    if cones.offset.y != 0.0 || cones.offset.z != 0.0 {
        return None;
    }
    let gain = cones.gain().unwrap_or(speed.gamma() * speed.gamma());
    let [y, z] = [cones.left.y, cones.left.z].map(|across| across / gain);
    Some(Stereo { gain, position: [cones.mean_x() / gain, y, z], miss: 0.0 })
}

/// The apertures, after a check of all inputs.
fn checked(pair: [Aperture; 2], source: Source, observation_time: f64) -> Result<[Aperture; 2], DomainError> {
    for aperture in pair {
        check_inputs(source, aperture, observation_time)?;
    }
    Ok(pair)
}

/// Returns the closest approach of two lines of sight from apertures with this `baseline` from the left to
/// the right; `None` if it is not in front of both.
pub(crate) fn meeting(lines: &SightPair<f64>, baseline: [f64; 3]) -> Option<Stereo> {
    let SightPair { mean, difference, excess, .. } = *lines;
    let at_rest = cross(baseline, mean);
    let (normal, length) = direction_and_length(lines.normal)?;
    let (direction_at_rest, length_at_rest) = direction_and_length(at_rest)?;
    let by_excess = cross(excess, mean);
    let fraction = near_one(-dot(by_excess, normal) / length, dot(at_rest, normal) / length);
    let apart = dot(cross(excess, baseline), normal) / length;
    if !(fraction.is_finite() && apart.abs() < 2.0 * fraction) {
        return None;
    }
    let gain = near_one(
        dot(by_excess, direction_at_rest) / length_at_rest,
        dot(direction_at_rest, normal) * (length / length_at_rest),
    );
    let connection = -dot(excess, normal);
    // From where the connection leaves the shorter line of sight: of lines of very different lengths the mean
    // is little but the longer one.
    let [left, right] = lines.each;
    let is_left = dot(left, left) < dot(right, right);
    let (shorter, side) = if is_left { (left, -0.5) } else { (right, 0.5) };
    let position = std::array::from_fn(|i| {
        let from_shorter =
            [side * baseline[i], (fraction - side * apart) * shorter[i], -side * connection * normal[i]];
        smallest_terms(&[fraction * mean[i], 0.25 * apart * difference[i], 0.0], &from_shorter)
    });
    let is_finite = [gain, connection].iter().chain(&position).all(|value| value.is_finite());
    (is_finite && gain > 0.0).then_some(Stereo { gain, position, miss: connection.abs() })
}

/// Returns that of two sums for the same number in which less cancels.
pub(crate) fn smallest_terms(a: &[f64], b: &[f64]) -> f64 {
    let [size_a, size_b] = [a, b].map(|terms| terms.iter().map(|term| term.abs()).sum::<f64>());
    // An overflow is larger than anything.
    if size_b < size_a { b.iter().sum() } else { a.iter().sum() }
}

/// A number that is known as its `excess` over 1 and in another way, by that in which less cancels.
fn near_one(excess: f64, otherwise: f64) -> f64 {
    if excess > -0.5 && excess.is_finite() { 1.0 + excess } else { otherwise }
}

/// A vector's unit vector and length, without squares that overflow; none of one that has no direction.
fn direction_and_length(v: [f64; 3]) -> Option<([f64; 3], f64)> {
    let size = v.iter().fold(0.0_f64, |size, part| size.max(part.abs()));
    if !(size > 0.0 && size.is_finite()) {
        return None;
    }
    let scaled = v.map(|part| part / size);
    let length = dot(scaled, scaled).sqrt();
    Some((scaled.map(|part| part / length), size * length))
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
