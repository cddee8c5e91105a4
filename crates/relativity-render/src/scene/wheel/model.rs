//! Entries of rays into models of triangles that turn about an axle: wheels of models.
//!
//! In the frame that turns with the model the ray is a curve q(s) with |q''| <= K (see `solid.rs`). It is cut
//! into arcs. An arc of the length h is nowhere farther than K h^2/8 from its chord at the same s, so that
//! the triangles it may meet are among those whose boxes, larger by that on all sides, the chord meets. How
//! far q is from the plane of a triangle with the unit normal n is a function g(s) with |g''| <= K |n'|, n'
//! being the part of n across the axle: where |g'| in the middle of a part of the arc is larger than that
//! times half the part, g has one root there at most, which Newton's method finds between ends with different
//! signs; where |g| is larger than it can change, none; else the part is halved. So no crossing is passed,
//! but for two that are nearer to each other than [`LEAST_PART`] of the model's reach.

use glam::{DMat3, DVec3};

use super::solid::{TurningRay, TurningSolid};
use crate::geometry::hierarchy::Slabs;
use crate::geometry::intersect::Entry;
use crate::geometry::ray::Ray;
use crate::geometry::shape::PreparedShape;
use crate::geometry::triangle_point::TrianglePoint;
use crate::geometry::triangles::{Triangles, facing};
use crate::kinematics::spin::about_y;
use crate::view::group_view::GroupView;

/// Greatest distance of an arc from its chord, in parts of how far the model reaches from the axle, and
/// greatest number of arcs: with that many they may be farther from their chords.
const BULGE: f64 = 0.01;
const MOST_ARCS: f64 = 1000.0;
/// Weights of corners that are below 0 by no more than this are 0: rays that pass two triangles at their
/// common edge are rounded alike only in one frame.
const EDGE: f64 = 1e-9;
/// A part of an arc that is not halved, in parts of how far the model reaches from the axle.
const LEAST_PART: f64 = 1e-9;
/// Greatest number of steps to a root. A step halves what is left where Newton's method would leave it.
const MOST_STEPS: u32 = 100;

/// A crossing of a triangle.
struct TriangleCrossing {
    /// Parameter of the ray at the crossing.
    s: f64,
    point: TrianglePoint,
    /// Normal of the triangle along the axes of the model, not of unit length, and the direction in which the
    /// ray passes it there.
    across: DVec3,
    direction: DVec3,
}

/// A search along a curve among triangles.
struct CurveSearch<'a> {
    course: &'a TurningRay<'a>,
    triangles: &'a Triangles,
    /// Turn from the axes of the model to those of the rest frame, and the axle along the former.
    axes: DMat3,
    axle: DVec3,
    /// Length of a part that is not halved.
    least: f64,
}

impl TurningSolid {
    /// Returns the first crossing of `ray` with `triangles` in the box that is its solid, as [`Self::entry`]
    /// does with that.
    ///
    /// # Accuracy
    ///
    /// `tests/rolling_models.rs`: the position lies in the triangle's plane within 1e-13 of how far the model
    /// reaches from the axle, and the triangle is the one that a search in small steps finds.
    pub fn triangle_entry(
        &self,
        triangles: &Triangles,
        ray: &Ray,
        view: &GroupView,
        touches: Option<f64>,
    ) -> (Option<Entry>, f64) {
        let (local, from_start) = self.local_ray(ray);
        let turned_at = touches.map_or_else(|| local.behind.max(0.0), |along| along - from_start);
        let found = self.reach_along(&local).and_then(|ends| {
            let course = TurningRay::new(self, &local, view, turned_at);
            let crossing = CurveSearch::new(&course, triangles)?.first(ends)?;
            let turn = course.turn_at(crossing.s);
            let normal = course.axes()? * facing(crossing.across, crossing.direction);
            Some((crossing, about_y(normal, turn)))
        });
        let Some((crossing, normal)) = found else { return (None, from_start) };
        let along = from_start + crossing.s;
        let position = self.middle() + (local.start + ray.direction * crossing.s);
        (Some(Entry { distance: along, position, normal, triangle: Some(crossing.point) }), along)
    }
}

impl TurningRay<'_> {
    fn axes(&self) -> Option<DMat3> {
        if let PreparedShape::Box(cuboid) = self.solid().form { Some(cuboid.axes) } else { None }
    }
}

impl<'a> CurveSearch<'a> {
    /// Returns the search along `course`; `None` where its body has no axes.
    fn new(course: &'a TurningRay<'a>, triangles: &'a Triangles) -> Option<Self> {
        let axes = course.axes()?;
        let axle = axes.transpose() * DVec3::Y;
        Some(Self { course, triangles, axes, axle, least: LEAST_PART * course.reach() })
    }

    /// The place and the direction of the curve at `s`, along the axes of the model from its middle.
    fn at(&self, s: f64) -> [DVec3; 2] {
        self.course.at(s).map(|v| self.axes.transpose() * v)
    }

    /// The first crossing between these ends.
    fn first(&self, [from, to]: [f64; 2]) -> Option<TriangleCrossing> {
        let length = to - from;
        let bulges = length * (self.course.curvature / (8.0 * BULGE * self.course.reach())).sqrt();
        let count = bulges.ceil().clamp(1.0, MOST_ARCS);
        let end = |i: u32| from + length * (f64::from(i) / count);
        let mut last = self.at(from)[0];
        for i in 0..count as u32 {
            let next = self.at(end(i + 1))[0];
            if let Some(crossing) = self.first_in_arc([end(i), end(i + 1)], [last, next]) {
                return Some(crossing);
            }
            last = next;
        }
        None
    }

    /// The first crossing in the arc between these parameters, which begins and ends at these places. Of
    /// crossings in one place that of the lowest number.
    fn first_in_arc(&self, [from, to]: [f64; 2], [begin, end]: [DVec3; 2]) -> Option<TriangleCrossing> {
        let middle = 0.5 * (from + to);
        let at_middle = self.at(middle);
        let bulge = 0.125 * self.course.curvature * (to - from) * (to - from);
        let length = begin.distance(end);
        // What f32 may be off by along the chord, of boxes beside triangles.
        let room = bulge + 1e-6 * self.triangles.half().length();
        let mut first: Option<TriangleCrossing> = None;
        let slabs = Slabs::of_chord([begin, end], room);
        self.triangles.hierarchy().along(&slabs, |candidate| {
            let until = first.as_ref().map_or(to, |first| first.s);
            let found = self.crossing(candidate.body, [from, until], middle, at_middle);
            if let Some(found) = found
                && first
                    .as_ref()
                    .is_none_or(|first| (found.s, found.point.triangle) < (first.s, first.point.triangle))
            {
                first = Some(found);
            }
            first.as_ref().map_or(f32::INFINITY, |first| {
                (length * ((first.s - from) / (to - from).max(f64::MIN_POSITIVE)) + room) as f32
            })
        });
        first
    }

    /// The first crossing of a triangle between these parameters, of an arc that is `there` in its `middle`.
    fn crossing(
        &self,
        triangle: u32,
        ends: [f64; 2],
        middle: f64,
        there: [DVec3; 2],
    ) -> Option<TriangleCrossing> {
        let [a, b, c] = self.triangles.corners_of(triangle);
        let across = (b - a).cross(c - a);
        let normal = across.normalize();
        let curvature = self.course.curvature * normal.reject_from_normalized(self.axle).length();
        let off = |[place, direction]: [DVec3; 2]| [normal.dot(place - a), normal.dot(direction)];
        let [from, to] = ends;
        // Most candidates are nowhere near.
        let ([value, slope], far) = (off(there), (to - middle).max(middle - from));
        if value.abs() > slope.abs() * far + 0.5 * curvature * far * far {
            return None;
        }
        let mut waiting = vec![ends];
        while let Some([from, to]) = waiting.pop() {
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            let [value, slope] = off(self.at(middle));
            if value.abs() > slope.abs() * half + 0.5 * curvature * half * half {
                continue;
            }
            if slope.abs() <= curvature * half {
                if half > self.least {
                    waiting.extend([[middle, to], [from, middle]]);
                }
                continue;
            }
            let Some(s) = root([from, to], |s| off(self.at(s))) else { continue };
            let [place, direction] = self.at(s);
            let is_seen = self.triangles.is_two_sided || across.dot(direction) < 0.0;
            let weights = weights_at(place - a, [b - a, c - a], across).filter(|_| is_seen);
            if let Some(weights) = weights.filter(|weights| self.triangles.is_solid(triangle, *weights)) {
                let point = TrianglePoint { triangle, weights: weights.map(|weight| weight as f32) };
                return Some(TriangleCrossing { s, point, across, direction });
            }
        }
        None
    }
}

/// The root between these ends of a function that is monotonic there, given its value and its slope; `None`
/// without a change of sign.
fn root([mut from, mut to]: [f64; 2], function: impl Fn(f64) -> [f64; 2]) -> Option<f64> {
    let [first, _] = function(from);
    let [last, _] = function(to);
    if first == 0.0 {
        return Some(from);
    }
    if last == 0.0 {
        return Some(to);
    }
    if (first > 0.0) == (last > 0.0) {
        return None;
    }
    let mut s = from + (to - from) * (first / (first - last));
    for _ in 0..MOST_STEPS {
        let [value, slope] = function(s);
        if value == 0.0 {
            break;
        }
        if (value > 0.0) == (first > 0.0) {
            from = s;
        } else {
            to = s;
        }
        let newton = s - value / slope;
        let next = if newton > from && newton < to { newton } else { 0.5 * (from + to) };
        if (next - s).abs() <= f64::EPSILON * s.abs().max(to - from) {
            break;
        }
        s = next;
    }
    Some(s)
}

/// The weights of the second and the third corner at `place`, from the first, of a triangle with these edges
/// from there; `None` beside it.
fn weights_at(place: DVec3, [second, third]: [DVec3; 2], across: DVec3) -> Option<[f64; 2]> {
    let scale = 1.0 / across.length_squared();
    let weights = [place.cross(third).dot(across) * scale, second.cross(place).dot(across) * scale];
    let is_inside = weights.iter().all(|weight| *weight >= -EDGE) && weights[0] + weights[1] <= 1.0 + EDGE;
    is_inside.then_some(weights)
}
