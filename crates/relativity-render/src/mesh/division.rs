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
use crate::body::{Body, Shape};

/// The most segments a direction is divided into: bodies that touch the picture plane would need any number.
const MAX_SEGMENTS: f64 = 512.0;
/// Second derivatives between the samples may be this much larger than at them.
const SAFETY: f64 = 1.3;
/// Step of the second differences, radians or half lengths.
const STEP: f64 = 1e-2;
/// Where a body is sampled: along it, and turned around it (radians).
const ALONG: [f64; 5] = [-1.0, -0.5, 0.0, 0.5, 1.0];
const AROUND: [f64; 4] = [0.0, FRAC_PI_2, PI, 1.5 * PI];

/// The division of `body` that keeps `bound_px` under `map`.
pub fn division(body: &Body, map: &Map, bound_px: f64) -> Division {
    let curvature = Curvature { map, bound_px: 0.25 * bound_px };
    match body.shape {
        Shape::Sphere { center, radius } => {
            let surface = Tube::new(center.into(), DVec3::X, 0.0, radius);
            let arc = curvature.of_arcs(&surface);
            Division::Tube { around: segments(TAU * arc, 6), end: segments(FRAC_PI_2 * arc, 2), side: 0 }
        }
        Shape::Tube { from, to, radius } => {
            let (from, to) = (DVec3::from(from), DVec3::from(to));
            let axis = (to - from).try_normalize().unwrap_or(DVec3::X);
            let surface = Tube::new(0.5 * (from + to), axis, 0.5 * (to - from).length(), radius);
            let arc = curvature.of_arcs(&surface);
            let side = curvature.greatest(|t, angle, h| surface.side(t + h, angle));
            Division::Tube {
                around: segments(TAU * arc, 6),
                end: segments(FRAC_PI_2 * arc, 2),
                side: segments(2.0 * side, 1),
            }
        }
        Shape::Ring { center, axis, radius, tube_radius } => {
            let axis = DVec3::from(axis);
            let (across, side) = basis(axis);
            let surface = |turn: f64, angle: f64| {
                let outward = across * turn.cos() + side * turn.sin();
                DVec3::from(center)
                    + outward * (radius + tube_radius * angle.cos())
                    + axis * (tube_radius * angle.sin())
            };
            let around = curvature.greatest(|t, angle, h| surface(PI * t + h, angle));
            let tube = curvature.greatest(|t, angle, h| surface(PI * t, angle + h));
            Division::Ring { around: segments(TAU * around, 8), tube: segments(TAU * tube, 6) }
        }
    }
}

/// Two unit vectors across `axis`, as the renderer turns shapes around it.
pub fn basis(axis: DVec3) -> (DVec3, DVec3) {
    let across = axis.any_orthonormal_vector();
    (across, axis.cross(across))
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

struct Tube {
    center: DVec3,
    axis: DVec3,
    across: DVec3,
    side: DVec3,
    extent: f64,
    radius: f64,
}

impl Tube {
    fn new(center: DVec3, axis: DVec3, extent: f64, radius: f64) -> Self {
        let (across, side) = basis(axis);
        Self { center, axis, across, side, extent, radius }
    }

    /// On the side, `t` half lengths along the axis from the middle.
    fn side(&self, t: f64, angle: f64) -> DVec3 {
        let outward = self.across * angle.cos() + self.side * angle.sin();
        self.center + self.axis * (t * self.extent) + outward * self.radius
    }

    /// On the circle of the tube's radius through the axis, `t` half lengths along it, turned by `turn`.
    fn meridian(&self, t: f64, turn: f64, angle: f64) -> DVec3 {
        let outward = self.across * turn.cos() + self.side * turn.sin();
        let normal = self.axis * angle.cos() + outward * angle.sin();
        self.center + self.axis * (t * self.extent) + normal * self.radius
    }
}

/// Curvature of images, as segments per unit of a parameter.
struct Curvature<'a> {
    map: &'a Map,
    bound_px: f64,
}

impl Curvature<'_> {
    /// Of the circles around and along a tube.
    fn of_arcs(&self, tube: &Tube) -> f64 {
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
