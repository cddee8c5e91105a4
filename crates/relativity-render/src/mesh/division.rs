//! How finely a body must be divided for its triangles to keep a bound on the picture.
//!
//! Between its corners a triangle is flat where the image P(u, v) of the surface is curved. Interpolation over
//! a triangle of a grid with steps g along u and h along v is off by at most
//!
//! ```text
//! (g^2 |P_uu| + 2 g h |P_uv| + h^2 |P_vv|)/8
//! ```
//!
//! Each direction gets a quarter of the bound, so that the mixed term, no larger than the geometric mean of the
//! others on these shapes, has the other half. The derivatives come from second differences of the apparent
//! position in f64 at places all over the body: so the count follows from what the speed makes of the shape.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DVec2, DVec3};

use super::map::Map;
use super::template::Division;
use crate::surface::{Surface, TubeSurface};

/// The most segments a direction is divided into: bodies that touch the picture plane would need any number.
const MAX_SEGMENTS: f64 = 512.0;
/// Second derivatives between the samples may be this much larger than at them: with it, `tests/gpu_mesh.rs` finds
/// the bound kept at all speeds.
const SAFETY: f64 = 1.3;
/// Step of the second differences, radians or half lengths: their error is a 1e-5th of the derivative, and rounding
/// costs 1e-12 of the position.
const STEP: f64 = 1e-2;
/// Where a body is sampled: along it, and turned around it (radians).
const ALONG: [f64; 5] = [-1.0, -0.5, 0.0, 0.5, 1.0];
const AROUND: [f64; 4] = [0.0, FRAC_PI_2, PI, 1.5 * PI];

/// The division of a body's `surface` that keeps `bound_px` under `map`; where that would do with less, no coarser than
/// normals between corners look round.
pub fn division(surface: &Surface, map: &Map, bound_px: f64) -> Division {
    let curvature = Curvature { map, bound_px: 0.25 * bound_px };
    match surface {
        Surface::Tube(tube) => {
            let arc = curvature.of_arcs(tube);
            let side = || curvature.greatest(|t, angle, h| tube.side(t + h, angle));
            let side = if tube.half_length == 0.0 { 0 } else { segments(2.0 * side(), 1) };
            Division::Tube { around: segments(TAU * arc, 6), end: segments(FRAC_PI_2 * arc, 2), side }
        }
        Surface::Ring(ring) => {
            let around = curvature.greatest(|t, angle, h| ring.at(PI * t + h, angle));
            let tube = curvature.greatest(|t, angle, h| ring.at(PI * t, angle + h));
            Division::Ring { around: segments(TAU * around, 8), tube: segments(TAU * tube, 6) }
        }
    }
}

/// The number of segments, on a ladder so that bodies share templates.
fn segments(needed: f64, least: u32) -> u32 {
    let needed = needed.min(MAX_SEGMENTS).ceil().max(f64::from(least)) as u32;
    if needed <= 4 {
        return needed;
    }
    // 5, 6, 7, 8, 10, 12, 14, 16, 20, ...: steps of at most a quarter.
    let step = (needed.next_power_of_two() / 8).max(1);
    needed.next_multiple_of(step)
}

/// Curvature of images, as segments per unit of a parameter.
struct Curvature<'a> {
    map: &'a Map,
    bound_px: f64,
}

impl Curvature<'_> {
    /// Of the circles around and along a tube.
    fn of_arcs(&self, tube: &TubeSurface) -> f64 {
        let around = self.greatest(|t, angle, h| tube.side(t, angle + h));
        let meridians = [0.0, FRAC_PI_2]
            .map(|turn| self.greatest(|t, angle, h| tube.meridian(t.signum(), turn, angle + h)));
        meridians.into_iter().fold(around, f64::max)
    }

    /// The most segments per unit that any place of `surface` (a place along in [-1, 1], an angle, and the
    /// step of the parameter in question) needs.
    fn greatest(&self, surface: impl Fn(f64, f64, f64) -> DVec3) -> f64 {
        let places = ALONG.iter().flat_map(|t| AROUND.iter().map(move |turn| (*t, *turn)));
        let needed = places.map(|(t, angle)| self.segments(|h| surface(t, angle, h)));
        SAFETY * needed.fold(0.0, f64::max)
    }

    /// Segments per unit of h that the curve needs at h = 0.
    fn segments(&self, curve: impl Fn(f64) -> DVec3) -> f64 {
        let [before, at, after] = [-STEP, 0.0, STEP].map(|h| self.map.apparent(curve(h)));
        let second = (before - 2.0 * at + after) / (STEP * STEP);
        (self.image_of_change(at, second).length() / (8.0 * self.bound_px)).sqrt()
    }

    /// How far a change of an apparent position moves its image, px.
    fn image_of_change(&self, at: DVec3, change: DVec3) -> DVec2 {
        let axes = self.map.axes;
        let depth = at.dot(axes.forward);
        if depth <= 0.0 {
            return DVec2::ZERO;
        }
        let image = DVec2::new(at.dot(axes.right), at.dot(axes.up)) / depth;
        let moved = DVec2::new(change.dot(axes.right), change.dot(axes.up));
        (moved - image * change.dot(axes.forward)) * (self.map.focal_length_px / depth)
    }
}
