//! The faces of a die.

use glam::DVec3;
use relativity_core::math::hypot;

use super::coverage::{SampleShifts, disc, rim};

/// Radius of a pip, in half edges of the smaller edge of its face.
pub const PIP_RADIUS: f64 = 0.19;
/// Distance of pips from the middle of a face, in half edges.
pub const PIP_PLACE: f64 = 0.52;
/// Width of the dark rim of a face, in half edges of the smaller edge.
pub const RIM: f64 = 0.035;

/// Returns the darkness of a die's face at `place`.
pub fn face(half: DVec3, place: DVec3, normal: DVec3, covered: SampleShifts) -> f64 {
    let [axis, a, b] = if normal.x.abs() > normal.y.abs().max(normal.z.abs()) {
        [DVec3::X, DVec3::Y, DVec3::Z]
    } else if normal.y.abs() > normal.z.abs() {
        [DVec3::Y, DVec3::Z, DVec3::X]
    } else {
        [DVec3::Z, DVec3::X, DVec3::Y]
    };
    let number = axis.dot(DVec3::new(1.0, 2.0, 3.0));
    let number = if axis.dot(normal) > 0.0 { number } else { 7.0 - number };
    let [half_a, half_b] = [a, b].map(|axis| half.dot(axis));
    let [at_a, at_b] = [a, b].map(|axis| place.dot(axis));
    let smaller = half_a.min(half_b);
    let pip = |off_a: f64, off_b: f64| {
        let distance = hypot(off_a, off_b);
        let gradient = (a * off_a + b * off_b) / distance.max(1e-30);
        disc(distance, PIP_RADIUS * smaller, covered.range(gradient))
    };
    let corner_a = at_a - (PIP_PLACE * half_a).copysign(at_a);
    let corner_b = at_b - (PIP_PLACE * half_b).copysign(at_b);
    let on_first_diagonal = at_a * at_b > 0.0;
    let has_corner = if on_first_diagonal { number > 1.5 } else { number > 3.5 };
    let rim = rim(half_a - at_a.abs(), RIM * smaller, covered.range(a));
    let rims = rim.max(self::rim(half_b - at_b.abs(), RIM * smaller, covered.range(b)));
    let corners = if has_corner { pip(corner_a, corner_b) } else { 0.0 };
    let middle = if number % 2.0 > 0.5 { pip(at_a, at_b) } else { 0.0 };
    let sides = if number > 5.5 { pip(corner_a, at_b) } else { 0.0 };
    rims.max(corners).max(middle).max(sides)
}
