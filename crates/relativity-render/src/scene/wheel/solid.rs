//! Entries of rays into a body that turns about an axle, as the spokes and the valve of a wheel do.
//!
//! What a view shows along a straight ray it shows at times that pass evenly along it
//! (`GroupView::rate_along`). So in the frame that turns with the body, where the body rests, the ray is a
//! curve q(s), s being the length along the ray: at s it is turned back by the angle by which the body has
//! turned when it is shown there, which changes by k per length, |k| <= |omega|. With n the ray's direction
//! and rho the greatest distance from the axle,
//!
//! |q'| <= L = sqrt(`n_y`^2 + (`n_perp` + |k| rho)^2), |q''| <= K = 2 |k| `n_perp` + k^2 rho.
//!
//! The distance f(s) from a convex body is a convex function of q, so that its curvature along the ray is at
//! least -K: it lies above the parabola of that curvature that touches it at s, and there is nothing of the
//! body before this parabola's root. Steps from root to root never pass an entry, so it is the first that is
//! found. They converge as Newton's method does, from one side; where the ray grazes, they about halve what
//! is left. A ring is not convex: the distance from its middle circle has a curvature of at least -1/rho, rho
//! from the ring's own axis; that times L^2 comes to K, and in the ring's hole the steps are f/L.
//!
//! All of that happens inside the [`Sweep`], which holds the body at every angle: few rays get that far.

use glam::DVec3;
use relativity_core::math;

use crate::geometry::intersect::{Entry, Solid};
use crate::geometry::ray::Ray;
use crate::geometry::shape::flat::between_planes;
use crate::geometry::shape::questions::LocalRay;
use crate::geometry::shape::{PreparedShape, RingForm, Shape};
use crate::geometry::triangles::Triangles;
use crate::kinematics::spin::{Spin, about_y, turned_by};
use crate::view::group_view::GroupView;

/// Greatest number of steps to an entry. Grazing rays take about fifty.
const MAX_STEPS: u32 = 1000;
/// Nearer than this to the surface, in parts of how far the body reaches from the axle, is on it.
const ON_SURFACE: f64 = 4.0 * f64::EPSILON;
/// Relative margin of a sweep around its content: a ray begins outside the body.
const ROOM: f64 = 1e-9;

/// A body that turns and does not keep its place doing so.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TurningSolid {
    /// The body as it is at t' = 0.
    solid: Solid,
    spin: Spin,
    sweep: Sweep,
}

/// The sweep of a body as it turns: the space between two planes across the axle and two cylinders about it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Sweep {
    /// On the axle, halfway between the planes.
    middle: DVec3,
    /// From there to the planes.
    half_width: f64,
    /// Radius of the inner cylinder, 0 if there is none.
    inner: f64,
    /// Radius of the outer one.
    outer: f64,
}

impl TurningSolid {
    /// The `solid` of a body that turns so.
    pub fn new(solid: Solid, spin: Spin) -> Self {
        Self { solid, spin, sweep: Sweep::new(&solid, &spin) }
    }

    /// The `solid` of a body that turns so; of a model, whose `triangles` it is the box around, with the
    /// least sweep.
    pub fn of_body(solid: Solid, spin: Spin, triangles: Option<&Triangles>) -> Self {
        let Some(triangles) = triangles else { return Self::new(solid, spin) };
        let places = triangles.corners().map(|corner| solid.centre + solid.rest_from_box(corner));
        Self { solid, spin, sweep: Sweep::of_places(places, &spin) }
    }

    /// Whether it turns as `view` shows it.
    pub fn turns_in(&self, view: &GroupView) -> bool {
        self.spin.omega(view.on_ground.beta()) != 0.0
    }

    /// The middle of its sweep, on the axle.
    pub fn middle(&self) -> DVec3 {
        self.sweep.middle
    }

    /// A ball that holds it at every angle: its centre, on the axle, and its radius.
    pub fn ball_around(&self) -> (DVec3, f64) {
        (self.sweep.middle, math::hypot(self.sweep.half_width, self.sweep.outer))
    }

    /// A ring which it never leaves the hull of, at whatever angle.
    pub fn ring_around(&self) -> Shape {
        let Sweep { middle, half_width, outer, .. } = self.sweep;
        let axis = DVec3::Y.to_array();
        Shape::Ring { centre: middle.to_array(), axis, radius: outer, tube_radius: half_width }
    }

    /// A tyre as wide as it and as far from the axle.
    pub fn tyre(&self) -> Shape {
        let Sweep { middle, half_width, outer, .. } = self.sweep;
        let tube_radius = half_width.min(0.25 * outer);
        let axis = DVec3::Y.to_array();
        Shape::Ring { centre: middle.to_array(), axis, radius: outer - tube_radius, tube_radius }
    }

    /// The lowest and highest corner of a box that holds it at every angle.
    pub fn bounds(&self) -> [DVec3; 2] {
        let Sweep { middle, half_width, outer, .. } = self.sweep;
        let half = DVec3::new(outer, half_width, outer);
        [middle - half, middle + half]
    }

    /// Returns the first entry of `ray` as `view` shows the body, in front of the camera; and its distance
    /// along the ray, or that of the place where the ray passes near it if it does not enter. A ray that only
    /// `touches` the curve of what is seen has its times from there: how far along it that is.
    ///
    /// # Accuracy
    ///
    /// `tests/reference_wheels.rs`: the position lies on the surface within 1e-12 of how far the body reaches
    /// from the axle.
    pub fn entry(&self, ray: &Ray, view: &GroupView, touches: Option<f64>) -> (Option<Entry>, f64) {
        let (local, from_start) = self.local_ray(ray);
        let turned_at = touches.map_or_else(|| local.behind.max(0.0), |along| along - from_start);
        let (found, s) = self.passage(&local, view, turned_at);
        let entry = found.map(|normal| Entry {
            distance: from_start + s,
            position: self.sweep.middle + (local.start + ray.direction * s),
            normal,
            triangle: None,
        });
        (entry, from_start + s)
    }

    /// `ray` from its point nearest to the sweep's middle, and how far along it that is.
    pub fn local_ray(&self, ray: &Ray) -> (LocalRay, f64) {
        let (start, from_start) = ray.nearest_to(self.sweep.middle);
        (LocalRay { start, direction: ray.direction, behind: -ray.from_camera - from_start }, from_start)
    }

    /// Between which parameters a ray is among what it sweeps, and in front of the camera.
    pub fn reach_along(&self, ray: &LocalRay) -> Option<[f64; 2]> {
        let mut parts = self.sweep.parts(ray).into_iter().flatten();
        let first = parts.next()?;
        Some([first[0], parts.next().unwrap_or(first)[1]])
    }

    /// The normal where a ray from near the sweep's middle enters, if it does, and at which parameter it does
    /// or is nearest.
    fn passage(&self, ray: &LocalRay, view: &GroupView, turned_at: f64) -> (Option<DVec3>, f64) {
        let mut nearest = (f64::INFINITY, ray.behind.max(0.0));
        for part in self.sweep.parts(ray).into_iter().flatten() {
            let course = TurningRay::new(self, ray, view, turned_at);
            if let Some(s) = course.first_entry(part, &mut nearest) {
                return (Some(course.normal(s)), s);
            }
        }
        (None, nearest.1)
    }
}

impl Sweep {
    fn new(solid: &Solid, spin: &Spin) -> Self {
        let (ends, radius) = solid.core();
        let [from, to] = ends.map(|end| spin.off_axle(end));
        let along = to - from;
        let closest = (-from.dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        let outer = from.length().max(to.length()) + radius;
        let inner = (from + along * closest).length() - radius;
        let [low, high] = [ends[0].y.min(ends[1].y) - radius, ends[0].y.max(ends[1].y) + radius];
        let [x, _, z] = spin.hub;
        Self {
            middle: DVec3::new(x, 0.5 * (low + high), z),
            half_width: 0.5 * (high - low) + ROOM * outer,
            inner: (inner - ROOM * outer).max(0.0),
            outer: outer * (1.0 + ROOM),
        }
    }

    /// The sweep of what lies between these places.
    fn of_places(places: impl Iterator<Item = DVec3>, spin: &Spin) -> Self {
        let none = (0.0_f64, [f64::INFINITY, f64::NEG_INFINITY]);
        let (outer, [low, high]) = places.fold(none, |(outer, [low, high]), place| {
            (outer.max(spin.off_axle(place).length()), [low.min(place.y), high.max(place.y)])
        });
        let [x, _, z] = spin.hub;
        Self {
            middle: DVec3::new(x, 0.5 * (low + high), z),
            half_width: 0.5 * (high - low) + ROOM * outer,
            inner: 0.0,
            outer: outer * (1.0 + ROOM),
        }
    }

    /// The parts of a ray inside, in front of the camera: all before the inner cylinder, and all after it.
    fn parts(&self, ray: &LocalRay) -> [Option<[f64; 2]>; 2] {
        let LocalRay { start, direction, behind } = *ray;
        let Some([enters, leaves]) = between_planes(start.y, direction.y, self.half_width) else {
            return [None; 2];
        };
        let across_squared = direction.x * direction.x + direction.z * direction.z;
        let lateral = start.x * direction.z - start.z * direction.x;
        let along = start.x * direction.x + start.z * direction.z;
        // Half the length that lies within `radius` of the axle, times `across_squared`.
        let half_chord = |radius: f64| {
            let squared = radius * radius * across_squared - lateral * lateral;
            (squared >= 0.0).then(|| squared.sqrt())
        };
        let of_chord = |half: f64| [-along - half, -along + half].map(|s| s / across_squared);
        let whole = [f64::NEG_INFINITY, f64::INFINITY];
        let [mut outer, mut inner] = [Some(whole), None];
        if across_squared > 0.0 {
            outer = half_chord(self.outer).map(of_chord);
            inner = half_chord(self.inner).map(of_chord);
        } else if math::hypot(start.x, start.z) > self.outer {
            outer = None;
        }
        let Some([first, last]) = outer else { return [None; 2] };
        let (first, last) = (first.max(enters).max(behind), last.min(leaves));
        let part = |from: f64, to: f64| (from <= to).then_some([from, to]);
        match inner {
            Some([hole_from, hole_to]) => [part(first, last.min(hole_from)), part(first.max(hole_to), last)],
            None => [part(first, last), None],
        }
    }
}

/// A ray as the curve that it is in the frame that turns with a body.
pub(super) struct TurningRay<'a> {
    body: &'a TurningSolid,
    ray: &'a LocalRay,
    /// Centre of the body at t' = 0, from the sweep's middle.
    centre: DVec3,
    /// The angle by which the body has turned where it is shown at the parameter `turned_at`.
    turn: f64,
    turned_at: f64,
    /// k, the change of that angle per length along the ray.
    rate: f64,
    /// L: q is no faster.
    speed: f64,
    /// K: q is bent no more.
    pub curvature: f64,
}

impl<'a> TurningRay<'a> {
    pub fn new(body: &'a TurningSolid, ray: &'a LocalRay, view: &GroupView, turned_at: f64) -> Self {
        let TurningSolid { solid, spin, sweep } = body;
        let place = sweep.middle + (ray.start + ray.direction * turned_at);
        let rate = spin.omega(view.on_ground.beta()) * view.rate_along(place, ray.direction);
        let across = math::hypot(ray.direction.x, ray.direction.z);
        let own_speed = rate.abs() * sweep.outer;
        Self {
            body,
            ray,
            centre: solid.centre - sweep.middle,
            turn: view.turn_at(spin, place),
            turned_at,
            rate,
            speed: math::hypot(ray.direction.y, across + own_speed),
            curvature: rate.abs() * (2.0 * across + own_speed),
        }
    }

    /// The angle by which the body has turned where it is shown at `s`.
    pub fn turn_at(&self, s: f64) -> f64 {
        self.turn + self.rate * (s - self.turned_at)
    }

    /// Returns the body that it may enter, as it is at t' = 0.
    pub fn solid(&self) -> &Solid {
        &self.body.solid
    }

    /// Returns the greatest distance of the body from the axle.
    pub fn reach(&self) -> f64 {
        self.body.sweep.outer
    }

    /// Returns the place q in the body at the ray's parameter `s`, from the body's centre, and its derivative
    /// q'.
    pub fn at(&self, s: f64) -> [DVec3; 2] {
        let back = math::sin_cos(-self.turn_at(s));
        let place = turned_by(self.ray.start + self.ray.direction * s, back);
        let own = DVec3::Y.cross(place) * self.rate;
        [place - self.centre, turned_by(self.ray.direction, back) - own]
    }

    /// Outward, where the surface is entered.
    fn normal(&self, s: f64) -> DVec3 {
        about_y(self.body.solid.form.answers().normal(self.at(s)[0]), self.turn_at(s))
    }

    /// The first entry of the curve between these ends; what is `nearest` to the body so far (distance and
    /// parameter) learns of all places that were looked at.
    fn first_entry(&self, [from, to]: [f64; 2], nearest: &mut (f64, f64)) -> Option<f64> {
        let form = self.body.solid.form.answers();
        let mut distance_at = |s: f64| {
            let [place, slope] = self.at(s);
            let (distance, outward) = form.distance(place);
            if distance < nearest.0 {
                *nearest = (distance, s);
            }
            (distance, outward.dot(slope), place)
        };
        if distance_at(0.5 * (from + to)).0 > 0.5 * (to - from) * self.speed {
            return None;
        }
        let on_surface = ON_SURFACE * self.body.sweep.outer;
        let mut s = from;
        let mut was_outside = false;
        for _ in 0..MAX_STEPS {
            let (distance, slope, place) = distance_at(s);
            let is_outside = distance > on_surface;
            if was_outside && !is_outside {
                return Some(s);
            }
            was_outside = is_outside;
            let next = if is_outside {
                s + self.step(distance, slope, place)
            } else {
                // The camera is inside: on until it is out.
                s + (-distance / self.speed).max(ROOM * self.body.sweep.outer)
            };
            if next > to {
                return None;
            }
            if next == s {
                break;
            }
            s = next;
        }
        was_outside.then_some(s)
    }

    /// Returns the length of a step along which there is nothing of the body, from a place at this
    /// `distance`, which grows with this `slope`.
    fn step(&self, distance: f64, slope: f64, place: DVec3) -> f64 {
        let mut curvature = self.curvature;
        let mut most = f64::INFINITY;
        if let PreparedShape::Ring(RingForm { axis, radius, tube_radius }) = self.body.solid.form {
            // Within the step the place is at least half the hole's radius from the ring's axis.
            let hole = radius - tube_radius;
            if place.cross(axis).length() < 0.75 * hole {
                return distance / self.speed;
            }
            curvature += 2.0 * self.speed * self.speed / hole;
            most = 0.25 * hole / self.speed;
        }
        let root = (slope * slope + 2.0 * curvature * distance).sqrt();
        let to_root = if slope > 0.0 { (slope + root) / curvature } else { 2.0 * distance / (root - slope) };
        to_root.min(most)
    }
}
