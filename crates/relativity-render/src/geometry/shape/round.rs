//! Geometry of round shapes: arcs, circles, turns, and corners of triangles around an axis.

use std::f64::consts::TAU;

use glam::{DQuat, DVec3};
use relativity_core::math::{atan2, hypot, sin_cos};

use crate::geometry::corners::{Coarseness, Corner, Template};

/// An arc along an axis, from the beginning, and its gradient.
pub(crate) type Arc = (f64, DVec3);

/// The arc of a circle of this `radius` from its outermost place up to where `off` and `z` lead from its
/// middle.
pub(crate) fn arc(off: f64, outward: DVec3, z: f64, radius: f64) -> Arc {
    let gradient = (DVec3::Z * off - outward * z) / hypot(off, z).max(1e-30);
    (radius * atan2(z, off), gradient)
}

/// Entry into a ball at the origin, by the discriminant r^2 - |start x direction|^2.
pub(crate) fn ball_entry(start: DVec3, direction: DVec3, radius: f64) -> Option<f64> {
    let discriminant = radius * radius - start.cross(direction).length_squared();
    (discriminant >= 0.0).then(|| -start.dot(direction) - discriminant.sqrt())
}

/// The step, radians, of an even number of squares around a circle of this `radius`, each about `step` wide.
pub(crate) fn closing(radius: f64, step: f64) -> f64 {
    TAU / (2.0 * (0.5 * TAU * radius / step).round()).max(2.0)
}

/// Returns `count` places on the circle about `axis`, evenly spread.
pub(crate) fn circle(centre: DVec3, axis: DVec3, radius: f64, count: u32) -> Vec<DVec3> {
    let (across, up) = axis.normalize_or(DVec3::Z).any_orthonormal_pair();
    let place = |step| {
        let (sin, cos) = sin_cos(TAU * f64::from(step) / f64::from(count));
        centre + radius * (cos * across + sin * up)
    };
    (0..count).map(place).collect()
}

/// Unit vector off the z axis, `angle` from the x axis.
pub(crate) fn outward(angle: f64) -> DVec3 {
    let (sine, cosine) = sin_cos(angle);
    DVec3::new(cosine, sine, 0.0)
}

/// Returns the reach along x, y and z of a disc of radius 1 about `axis`.
pub(crate) fn disc(axis: DVec3) -> DVec3 {
    DVec3::from(axis.to_array().map(|along| (1.0 - along * along).max(0.0).sqrt()))
}

/// The shortest turn of the z axis into the direction of `axis`, which fixes the other two; to -z it is half
/// a turn about x. None where it has no direction.
pub(crate) fn turn_to(axis: DVec3) -> DQuat {
    let Some(DVec3 { x, y, z }) = axis.try_normalize() else { return DQuat::IDENTITY };
    // 1 + z, without the difference.
    let real = if z < 0.0 { (x * x + y * y) / (1.0 - z) } else { 1.0 + z };
    let turn = DQuat::from_xyzw(-y, x, 0.0, real);
    if turn.length() == 0.0 { DQuat::from_xyzw(1.0, 0.0, 0.0, 0.0) } else { turn.normalize() }
}

/// Number of segments around a round body in its finest grid.
pub(super) const ROUND: u32 = 64;
/// Segments of the finest grid around a body with two ends, along each end and along its side.
const SEGMENTS: [u32; 3] = [ROUND, 16, 128];
/// Segments of the coarsest grid in the same three ways.
const LEAST: [u32; 3] = [4, 1, 1];

/// The grid over a body with two ends, whose `profile` has so many segments along an end and along the side.
pub(super) fn grid_with_ends(profile: fn(u32, u32) -> Vec<[f32; 4]>, coarseness: Coarseness) -> Template {
    let [around, end, side] = [0, 1, 2].map(|way| coarseness.segments(way, SEGMENTS[way], LEAST[way]));
    grid(&profile(end, side), around)
}

/// `profile` turned around the axis: corners and triangles, counter-clockwise as seen from outside.
pub(crate) fn grid(profile: &[[f32; 4]], around: u32) -> Template {
    let rows = profile.len() as u32;
    let turn = |j: u32| {
        let (sine, cosine) = sin_cos(TAU * f64::from(j) / f64::from(around));
        [cosine as f32, sine as f32]
    };
    let corners = (0..=around)
        .flat_map(|j| profile.iter().map(move |&profile| Corner { profile, turn: turn(j) }))
        .collect();
    let triangles = (0..around)
        .flat_map(|j| (0..rows - 1).map(move |i| j * rows + i))
        .flat_map(|low| [low, low + rows, low + 1, low + 1, low + rows, low + rows + 1])
        .collect();
    Template { corners, triangles }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_z_axis_is_turned_into_any_axis() {
        for axis in [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [1e-9, 0.0, -1.0], [-3.0, 1.0, -2.0], [1.0, 0.0, 0.0]]
        {
            let axis = DVec3::from(axis).normalize();
            let turn = turn_to(axis);
            assert!((turn.length() - 1.0).abs() < 1e-15);
            assert!((turn * DVec3::Z).distance(axis) < 1e-15, "{axis}: {}", turn * DVec3::Z);
        }
    }

    #[test]
    fn the_turn_is_the_shortest() {
        let turn = turn_to(DVec3::X);
        assert!((turn * DVec3::Y).distance(DVec3::Y) < 1e-15);
        assert!((turn_to(DVec3::Y) * DVec3::X).distance(DVec3::X) < 1e-15);
        assert!((turn_to(DVec3::NEG_Z) * DVec3::X).distance(DVec3::X) < 1e-15);
    }
}
