//! Wheels of a model: parts of it that turn, each about the middle of the smallest circle around it as it is
//! seen along the axle.
//!
//! That circle is the outline of a wheel whatever is inside, and however many corners it has. The axle lies
//! along y.

use glam::{DVec2, DVec3};
use relativity_core::Turning;
use relativity_render::{Body, RawModel, Spin, Triangles};

use crate::scene::convex_hull;

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
/// The farthest corner of the convex hull that the circle does not hold joins those that it goes through, and
/// the smallest circle around these few is the next one, until none is outside.
///
/// Reference: B. Gärtner, *Fast and robust smallest enclosing balls* (1999): the farthest place is the pivot,
/// and the circle becomes larger with each.
fn smallest_circle(places: Vec<DVec2>) -> Circle {
    let hull = convex_hull(places);
    let mut on: Vec<DVec2> = hull.iter().take(1).copied().collect();
    let mut circle = Circle::around(&on);
    loop {
        let distance = |place: &&DVec2| circle.middle.distance_squared(**place);
        let farthest = hull.iter().max_by(|a, b| distance(a).total_cmp(&distance(b)));
        let Some(&farthest) = farthest.filter(|place| !circle.holds(**place)) else { return circle };
        on.push(farthest);
        let Some((larger, kept)) = Circle::smallest_around(&on) else { return circle };
        // Where rounding lets it grow no more it is the smallest.
        if larger.radius <= circle.radius {
            return circle;
        }
        (circle, on) = (larger, kept);
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

    /// Returns the smallest circle around at most four `places`, and those of them that it goes through.
    fn smallest_around(places: &[DVec2]) -> Option<(Self, Vec<DVec2>)> {
        let subsets = (1_u32..1 << places.len()).filter(|subset| subset.count_ones() <= 3);
        let through = subsets.map(|subset| {
            let on = (0..places.len()).filter(|place| subset & 1 << place != 0);
            let on: Vec<_> = on.map(|place| places[place]).collect();
            (Self::around(&on), on)
        });
        let around_all = through.filter(|(circle, _)| places.iter().all(|place| circle.holds(*place)));
        around_all.min_by(|(a, _), (b, _)| a.radius.total_cmp(&b.radius))
    }

    fn holds(&self, place: DVec2) -> bool {
        self.middle.distance(place) <= self.radius * (1.0 + ROOM)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::scene::tests::random;

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
    /// The smallest of all circles on two or three of the places that hold all.
    fn by_trial(places: &[DVec2]) -> f64 {
        let mut radius = f64::INFINITY;
        for (i, &a) in places.iter().enumerate() {
            for (j, &b) in places[..i].iter().enumerate() {
                for on in places[..=j].iter().map(|&c| if c == b { vec![a, b] } else { vec![a, b, c] }) {
                    let circle = Circle::around(&on);
                    if circle.radius < radius && places.iter().all(|place| circle.holds(*place)) {
                        radius = circle.radius;
                    }
                }
            }
        }
        radius
    }

    #[test]
    fn no_smaller_circle_is_around_them() {
        let mut random = random();
        for count in [2, 3, 4, 5, 9, 14] {
            for _ in 0..30 {
                let places: Vec<_> = (0..count).map(|_| DVec2::new(random(), 0.3 * random())).collect();
                let circle = smallest_circle(places.clone());
                assert!(places.iter().all(|place| circle.holds(*place)), "{circle:?} {places:?}");
                assert!(circle.radius <= by_trial(&places) * (1.0 + ROOM), "{circle:?} {places:?}");
            }
        }
    }

    /// Whatever the order of the corners: each of these lies outside of the circle around those before it.
    #[test]
    fn many_corners_take_no_long_time() {
        let places = (0..200_000).map(|i| {
            let (sine, cosine) = (2.4 * f64::from(i)).sin_cos();
            (1.0 + 1e-5 * f64::from(i)) * DVec2::new(cosine, sine)
        });
        let circle = smallest_circle(places.collect());
        assert!((circle.radius - 3.0).abs() < 1e-3, "{circle:?}");
    }
}
