//! Wheels of a model: parts of it that turn, each about the middle of the smallest circle around it as it is
//! seen along the axle.
//!
//! That circle is the outline of a wheel whatever is inside, and however many corners it has. The axle lies
//! along y.

use glam::{DVec2, DVec3};
use relativity_core::Turning;
use relativity_render::{Body, RawModel, Spin, Triangles};

/// Least radius of a wheel.
const LEAST_RADIUS: f64 = 1e-6;
/// Relative room for rounding in the search for the circle.
const ROOM: f64 = 1e-9;

/// A circle, from its middle.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Circle {
    middle: DVec2,
    radius: f64,
}

/// Returns the body of the wheel that is this `model`, in the axes of the scene.
///
/// # Errors
///
/// A model that there cannot be, or with no extent across the axle, in one line.
pub(super) fn wheel(model: RawModel, turning: Option<Turning>) -> Result<Body, String> {
    let used = model.triangles.iter().flatten().filter_map(|&corner| model.corners.get(corner as usize));
    let middle = smallest_circle(used.map(|&[x, _, z]| DVec2::new(x, z)).collect()).middle;
    let triangles = model.prepared().map_err(|error| error.to_string())?;
    let hub = DVec3::new(middle.x, triangles.middle().y, middle.y);
    let radius = reach(&triangles, hub);
    if radius < LEAST_RADIUS {
        return Err("it has no extent across its axle, which lies along y".to_owned());
    }
    let body = Body::of_triangles(triangles);
    Ok(match turning {
        Some(turning) => body.turning(Spin { hub: hub.to_array(), radius, turning }),
        None => body,
    })
}

/// Returns the greatest distance of `triangles`, as they are drawn, from the axle through `hub`.
fn reach(triangles: &Triangles, hub: DVec3) -> f64 {
    let off = |corner: DVec3| (triangles.middle() + corner - hub).with_y(0.0).length();
    triangles.corners().map(off).fold(0.0, f64::max)
}

/// Returns the smallest circle around `places`, if there are any; else one of no size.
///
/// Reference: E. Welzl, *Smallest enclosing disks (balls and ellipsoids)* (1991), in the incremental form: in
/// the order of chance the expected time grows as the number of places.
fn smallest_circle(mut places: Vec<DVec2>) -> Circle {
    shuffle(&mut places);
    let mut circle = Circle::around(&places[..places.len().min(1)]);
    for i in 1..places.len() {
        if circle.holds(places[i]) {
            continue;
        }
        circle = Circle::around(&[places[i]]);
        for j in 0..i {
            if circle.holds(places[j]) {
                continue;
            }
            circle = Circle::around(&[places[i], places[j]]);
            for k in 0..j {
                if !circle.holds(places[k]) {
                    circle = Circle::around(&[places[i], places[j], places[k]]);
                }
            }
        }
    }
    circle
}

/// Puts `places` into an order of chance, the same each time.
fn shuffle(places: &mut [DVec2]) {
    let mut state = 1_u64;
    for i in (1..places.len()).rev() {
        // The generator of Knuth's MMIX.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        places.swap(i, (state >> 33) as usize % (i + 1));
    }
}

impl Circle {
    /// Returns the circle through these places, at most three. Of three on a line it is that on the two which
    /// are farthest apart.
    fn around(places: &[DVec2]) -> Self {
        let on_diameter = |a: DVec2, b: DVec2| Self { middle: 0.5 * (a + b), radius: 0.5 * a.distance(b) };
        match *places {
            [] => Self { middle: DVec2::ZERO, radius: 0.0 },
            [a] => Self { middle: a, radius: 0.0 },
            [a, b] => on_diameter(a, b),
            [a, b, c, ..] => {
                let (u, v) = (b - a, c - a);
                let twice = 2.0 * u.perp_dot(v);
                let from_first = (v.perp() * u.length_squared() - u.perp() * v.length_squared()) / -twice;
                if from_first.is_finite() {
                    return Self { middle: a + from_first, radius: from_first.length() };
                }
                let pairs = [on_diameter(a, b), on_diameter(b, c), on_diameter(c, a)];
                pairs
                    .into_iter()
                    .fold(pairs[0], |most, pair| if pair.radius > most.radius { pair } else { most })
            }
        }
    }

    fn holds(&self, place: DVec2) -> bool {
        self.middle.distance(place) <= self.radius * (1.0 + ROOM)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn the_circle_around_a_polygon_is_through_its_corners_whatever_is_inside() {
        let middle = DVec2::new(3.0, -1.0);
        for corners in [3, 5, 7, 16, 33] {
            let corner = |i: u32, radius: f64| {
                let (sine, cosine) = (TAU * f64::from(i) / f64::from(corners)).sin_cos();
                middle + radius * DVec2::new(cosine, sine)
            };
            let outside = (0..corners).map(|i| corner(i, 0.5));
            let places: Vec<_> = outside.chain((0..400).map(|i| corner(i, f64::from(i) / 1000.0))).collect();
            let circle = smallest_circle(places);
            assert!((circle.radius - 0.5).abs() < 1e-8, "{corners}: {circle:?}");
            assert!(circle.middle.distance(middle) < 1e-8, "{corners}: {circle:?}");
        }
        let on_line = smallest_circle((0..9).map(|i| DVec2::splat(f64::from(i))).collect());
        assert!(on_line.middle.distance(DVec2::splat(4.0)) < 1e-8);
    }
}
