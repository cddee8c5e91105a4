//! The baseline: the places of the two eyes of a head that may be tilted or turned.

use crate::aperture::Aperture;
use crate::math;

/// From the left to the right aperture of a pair.
///
/// # Examples
///
/// ```
/// use relativity_core::{Aperture, Baseline};
/// use std::f64::consts::FRAC_PI_2;
///
/// assert_eq!(Baseline::straight(0.1).apertures(), Aperture::pair(0.1));
/// // A head laid on its left side: the right eye is above the left one.
/// let [left, right] = Baseline { roll: FRAC_PI_2, ..Baseline::straight(2.0) }.apertures();
/// assert_eq!([left, right], [Aperture { z: -1.0, ..left }, Aperture { x: 0.0, y: 0.0, z: 1.0 }]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Baseline {
    /// Distance between the apertures.
    pub separation: f64,
    /// Tilt of the head, radians: the right aperture is the higher one between 0 and pi.
    pub roll: f64,
    /// Turn of the head about the vertical, radians: azimuths increase with it, to the left.
    pub turn: f64,
}

impl Baseline {
    /// The paper's: along x, the direction of motion.
    #[must_use]
    pub const fn straight(separation: f64) -> Self {
        Self { separation, roll: 0.0, turn: 0.0 }
    }

    /// Returns the direction of the baseline, a unit vector: (cos roll cos turn, cos roll sin turn, sin
    /// roll). What rounding leaves of 0 at a multiple of a quarter turn is 0.
    #[must_use]
    pub fn direction(&self) -> [f64; 3] {
        let ([sin_roll, cos_roll], [sin_turn, cos_turn]) =
            (sine_and_cosine(self.roll), sine_and_cosine(self.turn));
        [cos_roll * cos_turn, cos_roll * sin_turn, sin_roll]
    }

    /// Returns the axes of the head, with this direction to its right.
    #[must_use]
    pub fn axes(&self) -> HeadAxes {
        let ([sin_roll, cos_roll], [sin_turn, cos_turn]) =
            (sine_and_cosine(self.roll), sine_and_cosine(self.turn));
        HeadAxes {
            right: self.direction(),
            ahead: [0.0 - sin_turn, cos_turn, 0.0],
            up: [0.0 - sin_roll * cos_turn, 0.0 - sin_roll * sin_turn, cos_roll],
        }
    }

    /// Returns whether the baseline lies along x, as in published models.
    #[must_use]
    pub fn is_along_motion(&self) -> bool {
        let [_, y, z] = self.direction();
        [y, z] == [0.0; 2]
    }

    /// The apertures, but those that are in one place a hair apart: what two eyes make of a point has a limit
    /// there, which depends on the direction. (The pair along x stands for its limit itself.)
    #[must_use]
    pub fn apertures_or_limit(&self) -> [Aperture; 2] {
        if self.is_along_motion() { self.apertures() } else { self.apart().apertures() }
    }

    /// Returns the apertures of which a stereo position is found, for an observer who `moves` or rests. While
    /// the observer moves, no pair in one place stands for its limit.
    #[must_use]
    pub fn stereo_apertures(&self, moves: bool) -> [Aperture; 2] {
        if moves { self.apart().apertures() } else { self.apertures_or_limit() }
    }

    /// Returns this pair, a hair apart if both apertures are in one place.
    #[must_use]
    pub fn apart(&self) -> Self {
        Self { separation: if self.separation == 0.0 { HAIR } else { self.separation }, ..*self }
    }

    /// Both apertures, left (primary) and right (secondary), from the middle between them.
    #[must_use]
    pub fn apertures(&self) -> [Aperture; 2] {
        let half = self.separation / 2.0;
        let [x, y, z] = self.direction().map(|along| half * along);
        // 0 - 0 is 0, not -0.
        [Aperture { x: 0.0 - x, y: 0.0 - y, z: 0.0 - z }, Aperture { x: 0.0 + x, y: 0.0 + y, z: 0.0 + z }]
    }
}

/// The axes of a head, unit vectors.
///
/// # Examples
///
/// ```
/// use relativity_core::Baseline;
/// use std::f64::consts::FRAC_PI_2;
///
/// // A head that is turned to the left looks against the motion; its right is ahead on the ground.
/// let axes = Baseline { turn: FRAC_PI_2, ..Baseline::straight(0.1) }.axes();
/// assert_eq!((axes.right, axes.ahead, axes.up), ([0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeadAxes {
    /// Along the baseline, from the left to the right aperture.
    pub right: [f64; 3],
    /// Straight ahead, level on the ground.
    pub ahead: [f64; 3],
    /// Unit vector from the middle of the eyes to the crown.
    pub up: [f64; 3],
}

impl HeadAxes {
    /// Returns a vector on the ground along these axes: to the right, ahead and up.
    #[must_use]
    pub fn along(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        [self.right, self.ahead, self.up].map(|axis| x * axis[0] + y * axis[1] + z * axis[2])
    }

    /// Returns these axes in a mirror across x.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mirrored = |[x, y, z]: [f64; 3]| [0.0 - x, y, z];
        Self { right: mirrored(self.right), ahead: mirrored(self.ahead), up: mirrored(self.up) }
    }
}

/// A separation whose square counts as nothing.
const HAIR: f64 = 1e-12;

/// Sine and cosine, exactly 0 where only rounding leaves something at a multiple of a quarter turn.
pub(crate) fn sine_and_cosine(angle: f64) -> [f64; 2] {
    let (sine, cosine) = math::sin_cos(angle);
    let is_far_round = angle.abs() > 1.0;
    [sine, cosine].map(|part| if is_far_round && part.abs() < f64::EPSILON { 0.0 } else { part })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        let direction = |roll: f64, turn: f64| {
            Baseline { separation: 1.0, roll: roll.to_radians(), turn: turn.to_radians() }.direction()
        };
        assert_eq!(direction(90.0, 0.0), [0.0, 0.0, 1.0]);
        assert_eq!(direction(-90.0, 30.0), [0.0, 0.0, -1.0]);
        assert_eq!(direction(0.0, 90.0), [0.0, 1.0, 0.0]);
        assert_eq!(direction(0.0, -90.0), [0.0, -1.0, 0.0]);
        assert_eq!(direction(0.0, 180.0), [-1.0, 0.0, 0.0]);
        assert_eq!(direction(180.0, 0.0), [-1.0, 0.0, 0.0]);
    }

    #[test]
    fn the_separation_is_its_length_whatever_the_direction() {
        for roll in [-2.0, -0.3, 0.0, 0.7, 3.0] {
            for turn in [-3.0, -1.2, 0.0, 0.4, 2.0] {
                let baseline = Baseline { separation: 0.3, roll, turn };
                let [left, right] = baseline.apertures();
                let length = math::hypot(right.x - left.x, math::hypot(right.y - left.y, right.z - left.z));
                assert!((length - 0.3).abs() < 1e-15, "{baseline:?}");
                assert!(
                    (right.z - left.z).signum() == math::sin(roll).signum() || roll == 0.0,
                    "{baseline:?}"
                );
            }
        }
    }
}
