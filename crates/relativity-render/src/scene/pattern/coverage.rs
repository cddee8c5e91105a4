//! Coverage of a surface by a sample of a picture, and the averages of lines, bands and discs over it.

use glam::{DQuat, DVec3};
use relativity_core::math::hypot;

/// Least and greatest coverage of a pixel that is distinguished, in steps: f32 has no more digits, and beyond
/// a few steps there is only an average.
pub const COVERED: [f64; 2] = [1e-4, 1e3];
/// Least cosine between a ray and the normal: at the outline itself a pixel covers without end.
pub const GRAZING: f64 = 1e-3;

/// The coverage of a sample of a picture: the shifts on the surface towards the next sample to
/// the right, and below.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampleShifts {
    right: DVec3,
    down: DVec3,
}

impl SampleShifts {
    /// The coverage of a point.
    pub const NOTHING: Self = Self { right: DVec3::ZERO, down: DVec3::ZERO };

    /// On a surface with this `normal`, met by a ray along `direction` (unit vectors), which moves there by
    /// `right` and `down` (but for what is along it).
    pub fn new(direction: DVec3, normal: DVec3, [right, down]: [DVec3; 2]) -> Self {
        let cosine = direction.dot(normal).min(-GRAZING);
        let on_surface = |shift: DVec3| shift - direction * (shift.dot(normal) / cosine);
        Self { right: on_surface(right), down: on_surface(down) }
    }

    /// Returns the coverage in other axes.
    pub fn turned(self, turn: DQuat) -> Self {
        Self { right: turn * self.right, down: turn * self.down }
    }

    /// Returns the coverage of a body that has turned by this angle about +y (radians) as it is before that.
    pub fn turned_back(self, turn: f64) -> Self {
        if turn == 0.0 { self } else { self.turned(DQuat::from_rotation_y(-turn)) }
    }

    /// Returns the range of a coordinate with this gradient that is covered.
    pub fn range(&self, gradient: DVec3) -> f64 {
        hypot(gradient.dot(self.right), gradient.dot(self.down))
    }
}

/// Share of what is `covered` at `distance` from the middle of a disc of this `radius` that lies on it.
pub fn disc(distance: f64, radius: f64, covered: f64) -> f64 {
    let wide = radius.max(0.5 * covered);
    let share = ((wide - distance) / covered.max(1e-30) + 0.5).clamp(0.0, 1.0);
    share * (radius / wide) * (radius / wide)
}

/// Share of what is `covered` at `distance` from an edge that lies within `width` of it.
pub fn rim(distance: f64, width: f64, covered: f64) -> f64 {
    let covered = covered.max(1e-6 * width);
    let [low, high] = [-0.5, 0.5].map(|side| distance + side * covered);
    ((high.min(width) - low.max(0.0)) / covered).max(0.0)
}

/// Share of what is `covered` around `x` that lies within `half_width` of a whole number, or twice that of
/// every `quarter`-th.
pub fn line(x: f64, half_width: f64, quarter: f64, covered: f64) -> f64 {
    let nearest = x.round();
    let from_quarter = (nearest - quarter * (nearest / quarter).round()).abs();
    let half_width = (if from_quarter < 0.5 { 2.0 * half_width } else { half_width }).min(0.5);
    let before = |x: f64| 2.0 * half_width * x.round() + (x - x.round()).clamp(-half_width, half_width);
    average(before, x - nearest, covered)
}

/// 1 from 0 to 1, -1 from there to 2, and so on, on average over what is `covered` around `x`.
pub fn wave(x: f64, covered: f64) -> f64 {
    let sawtooth = |x: f64| (x - 2.0 * (0.5 * x).round()).abs();
    average(sawtooth, x - 2.0 * (0.5 * x).round(), covered)
}

/// Returns the average of a function with this `integral`, over the range `covered` around `x`, all in steps.
fn average(integral: impl Fn(f64) -> f64, x: f64, covered: f64) -> f64 {
    let covered = covered.clamp(COVERED[0], COVERED[1]);
    (integral(x + 0.5 * covered) - integral(x - 0.5 * covered)) / covered
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The average of `value` from `x - covered/2` to `x + covered/2`, by many samples.
    fn sampled(value: impl Fn(f64) -> f64, x: f64, covered: f64) -> f64 {
        const SAMPLES: u32 = 20_000;
        let at = |i| x + covered * ((f64::from(i) + 0.5) / f64::from(SAMPLES) - 0.5);
        (0..SAMPLES).map(|i| value(at(i))).sum::<f64>() / f64::from(SAMPLES)
    }

    #[test]
    fn lines_and_waves_are_averaged_over_what_is_covered() {
        let half_width = 0.1;
        let is_line = |x: f64| f64::from(u8::from((x - x.round()).abs() < half_width));
        let sign = |x: f64| if x.rem_euclid(2.0) < 1.0 { 1.0 } else { -1.0 };
        for covered in [0.01, 0.3, 0.9, 2.5, 7.3] {
            for i in 0..40 {
                let x = 5.0 + 0.17 * f64::from(i);
                let (found, expected) = (line(x, half_width, 100.0, covered), sampled(is_line, x, covered));
                assert!((found - expected).abs() < 1e-3, "{covered} around {x}: {found} for {expected}");
                let (found, expected) = (wave(x, covered), sampled(sign, x, covered));
                assert!((found - expected).abs() < 1e-3, "{covered} around {x}: {found} for {expected}");
            }
        }
    }

    #[test]
    fn a_surface_seen_aslant_covers_more_of_it() {
        let normal = DVec3::new(0.6, -0.8, 0.0);
        let covered = SampleShifts::new(DVec3::Y, normal, [DVec3::X, DVec3::Z]);
        // Along the surface, within the plane of ray and normal, a pixel is 1/cos wide.
        let along = DVec3::new(0.8, 0.6, 0.0);
        assert!((covered.range(along) - 1.0 / 0.8).abs() < 1e-15);
        assert!((covered.range(DVec3::Z) - 1.0).abs() < 1e-15);
        assert!(covered.range(normal) < 1e-15);
    }
}
