//! A torus, the shape of a tyre.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DQuat, DVec2, DVec3};
use relativity_core::math::{cos, hypot, sin, sin_cos};

use super::questions::{CentredShape, Foot, LocalRay, PackedForm, PackedShape, PlacedShape};
use super::round::{Arc, ROUND, arc, circle, closing, disc, grid, outward, turn_to};
use super::strokes::{Path, Stroke};
use crate::geometry::capsule::Capsule;
use crate::geometry::corners::{Coarseness, Template};
use crate::geometry::kind::Kind;
use crate::geometry::polynomial::first_descent;
use crate::kinematics::spin::Spin;

/// Samples around a ring.
const AROUND: u32 = 12;
/// Half the length of a wheel's shadow along it and half its width across, in parts of its radius.
pub(crate) const SHADOW: [f64; 2] = [1.3, 0.5];

/// A ring where it is placed.
pub(super) struct Ring {
    pub centre: DVec3,
    pub axis: DVec3,
    pub radius: f64,
    pub tube_radius: f64,
}

impl PlacedShape for Ring {
    fn name(&self) -> &'static str {
        "ring"
    }

    fn kind(&self) -> Kind {
        Kind::Ring
    }

    fn numbers(&self) -> Vec<f64> {
        let sizes = [self.radius, self.tube_radius];
        [&self.centre.to_array()[..], &self.axis.to_array(), &sizes].concat()
    }

    fn is_round_about(&self, spin: &Spin) -> bool {
        spin.is_on_axle(self.centre) && self.axis.x == 0.0 && self.axis.z == 0.0
    }

    fn turn(&self) -> DQuat {
        turn_to(self.axis)
    }

    fn distance(&self, place: DVec3) -> f64 {
        let off = place - self.centre;
        let along = off.dot(self.axis);
        let across = (off - along * self.axis).length();
        hypot(across - self.radius, along) - self.tube_radius
    }

    fn ball_around(&self) -> ([f64; 3], f64) {
        (self.centre.to_array(), self.radius + self.tube_radius)
    }

    fn forward_most(&self) -> DVec3 {
        let in_plane =
            DVec3::X.reject_from_normalized(self.axis).normalize_or(self.axis.any_orthonormal_vector());
        self.centre + self.radius * in_plane + self.tube_radius * DVec3::X
    }

    /// Around its middle line.
    fn samples(&self) -> Vec<DVec3> {
        circle(self.centre, self.axis, self.radius, AROUND)
    }

    fn strokes(&self) -> Vec<Stroke> {
        let path = Path::circle(self.centre, self.axis, self.radius);
        vec![Stroke { path, radius: self.tube_radius }]
    }

    /// Returns the ring's arcs, each in a capsule along its chord, moved outwards by half the sagitta.
    fn capsules(&self) -> Vec<Capsule> {
        let Self { centre, axis, radius, tube_radius } = *self;
        // Half the sagitta, radius angle^2/16, adds no more than half the tube's radius. A thick ring has
        // eight arcs nevertheless, lest its hole be covered; the thinnest has no more than thirty-two, each
        // worth a rectangle.
        let angle = (8.0 * tube_radius / radius).sqrt().clamp(0.2, 0.8);
        let count = (TAU / angle).ceil();
        let half_angle = PI / count;
        let half_sagitta = 0.5 * radius * (1.0 - cos(half_angle));
        let (u, v) = axis.any_orthonormal_pair();
        let point = |middle: f64, end: f64| {
            let outward = u * cos(middle) + v * sin(middle);
            let along = v * cos(middle) - u * sin(middle);
            centre
                + outward * (radius * cos(half_angle) + half_sagitta)
                + along * (end * radius * sin(half_angle))
        };
        let arc = |i| {
            let middle = 2.0 * half_angle * f64::from(i);
            Capsule { from: point(middle, -1.0), to: point(middle, 1.0), radius: tube_radius + half_sagitta }
        };
        (0..count as u32).map(arc).collect()
    }

    /// None of one that lies flat.
    fn foot(&self) -> Option<Foot> {
        let down = (self.axis * self.axis.z - DVec3::Z).try_normalize()?;
        let ahead = self.axis.cross(down).truncate();
        let outer = self.radius + self.tube_radius;
        let sizes = |part: f64, other: f64| outer * hypot(SHADOW[0] * part, SHADOW[1] * other);
        let half = DVec2::new(sizes(ahead.x, ahead.y), sizes(ahead.y, ahead.x));
        let place = self.centre + down * self.radius - DVec3::Z * self.tube_radius;
        Some(Foot { place, radius: outer, half })
    }

    fn packed(&self) -> PackedShape {
        let form = PackedForm::Vector(self.axis, self.radius);
        PackedShape { place: self.centre, radius: self.tube_radius, form }
    }
}

/// A ring about its centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RingForm {
    pub axis: DVec3,
    pub radius: f64,
    pub tube_radius: f64,
}

impl RingForm {
    /// The point of the middle circle nearest to `position`.
    fn nearest_on_circle(&self, position: DVec3) -> DVec3 {
        let Self { axis, radius, .. } = *self;
        (position - axis * axis.dot(position)).normalize_or(axis.any_orthonormal_vector()) * radius
    }

    /// The part of the ray between the two planes that touch the ring and inside the ball around it, in front
    /// of the camera; `None` if there is none, or if it lies in the hole. Spares most rays the quartic.
    fn interval(&self, ray: &LocalRay) -> Option<[f64; 2]> {
        let (Self { axis, radius, tube_radius }, LocalRay { start, direction, behind }) = (*self, *ray);
        // Beyond the surface, which the ball touches where the ring is widest.
        let size = (radius + tube_radius) * (1.0 + 1e-9);
        let half_chord = (size * size - start.length_squared()).max(0.0).sqrt();
        let [along, along_slope] = [start.dot(axis), direction.dot(axis)];
        let thickness = tube_radius * (1.0 + 1e-9);
        // A ray in the planes' direction gives infinities of both signs, or of one if it lies outside.
        let planes = [-thickness, thickness].map(|plane| (plane - along) / along_slope);
        let low = planes[0].min(planes[1]).max(-half_chord).max(behind);
        let high = planes[0].max(planes[1]).min(half_chord);
        let hole = (radius - tube_radius) * (1.0 - 1e-9);
        let in_hole = |t: f64| (start + direction * t).cross(axis).length_squared() < hole * hole;
        // The distance from the axis is convex along a ray: both ends in the hole, all of it in the hole.
        (low < high && !(in_hole(low) && in_hole(high))).then_some([low, high])
    }

    /// (|p|^2 + R^2 - r^2)^2 - 4 R^2 (|p|^2 - (p . axis)^2) along p = start + t direction, constant first.
    fn quartic(&self, ray: &LocalRay) -> [f64; 5] {
        let (Self { axis, radius, tube_radius }, LocalRay { start, direction, .. }) = (*self, *ray);
        let half_slope = start.dot(direction);
        let [along, along_slope] = [start.dot(axis), direction.dot(axis)];
        let square = start.length_squared();
        let k = square + (radius - tube_radius) * (radius + tube_radius);
        let four_r2 = 4.0 * radius * radius;
        [
            k * k - four_r2 * (square - along * along),
            4.0 * half_slope * k - 2.0 * four_r2 * (half_slope - along * along_slope),
            2.0 * k + 4.0 * half_slope * half_slope - four_r2 * (1.0 - along_slope * along_slope),
            4.0 * half_slope,
            1.0,
        ]
    }

    /// Improves an entry by one step of Newton's method on the distance from the surface: the quartic of a
    /// thin ring resolves its tube to only R^2 / r units of rounding. Left out where the ray grazes so
    /// closely that the step would cross to the way out.
    fn polished(&self, t: f64, ray: &LocalRay) -> f64 {
        let position = ray.start + ray.direction * t;
        let from_circle = position - self.nearest_on_circle(position);
        let distance = from_circle.length();
        let excess = distance - self.tube_radius;
        let slope = from_circle.dot(ray.direction) / distance;
        if excess.abs() < 0.25 * slope * slope * self.tube_radius { t - excess / slope } else { t }
    }

    /// Turned around the axis by `turn`, and around the tube by `angle`, in its own axes.
    fn at(&self, turn: f64, angle: f64) -> DVec3 {
        let (sine, cosine) = sin_cos(angle);
        let off_axis = outward(turn) * (self.radius + self.tube_radius * cosine);
        off_axis + DVec3::Z * (self.tube_radius * sine)
    }
}

impl CentredShape for RingForm {
    fn entry(&self, ray: &LocalRay) -> Option<f64> {
        let interval = self.interval(ray)?;
        Some(self.polished(first_descent(&self.quartic(ray), interval)?, ray))
    }

    fn distance(&self, position: DVec3) -> (f64, DVec3) {
        let off = position - self.nearest_on_circle(position);
        (off.length() - self.tube_radius, off.normalize_or_zero())
    }

    fn normal(&self, position: DVec3) -> DVec3 {
        (position - self.nearest_on_circle(position)).normalize()
    }

    fn bounding_radius(&self) -> f64 {
        self.radius + self.tube_radius
    }

    fn half_sides(&self) -> DVec3 {
        disc(self.axis) * self.radius + self.tube_radius
    }

    fn grid_sizes(&self) -> [f64; 3] {
        [2.0 * (self.radius + self.tube_radius), 2.0 * self.tube_radius, 0.0]
    }

    fn parallels_radius(&self) -> f64 {
        self.tube_radius
    }

    fn squares(&self, step: f64) -> [f64; 2] {
        [closing(self.tube_radius, step) * self.tube_radius, closing(self.radius, step)]
    }

    fn along(&self, off_axis: f64, outward: DVec3, z: f64, _: f64) -> Arc {
        arc(off_axis - self.radius, outward, z, self.tube_radius)
    }

    fn stripes_radius(&self) -> Option<f64> {
        Some(self.radius)
    }

    /// Four places around it.
    fn visit_farthest(&self, visit: &mut dyn FnMut(DVec3)) {
        (0..4).for_each(|i| visit(self.at(FRAC_PI_2 * f64::from(i), 0.0)));
    }
}

/// Segments of the finest grid around the axis, and around the tube.
const SEGMENTS: [u32; 2] = [256, 24];
/// Segments of the coarsest grid in the same two ways.
const LEAST: [u32; 2] = [8, 4];

/// Corners and triangles of a ring.
pub(super) fn template(coarseness: Coarseness) -> Template {
    let around = coarseness.segments(0, SEGMENTS[0], LEAST[0]);
    // The finest grid has fewer segments there than other round bodies: they are counted from as many as
    // those.
    let tube = coarseness.segments(1, ROUND, LEAST[1]).min(SEGMENTS[1]);
    let profile = (0..=tube).map(|i| {
        let (sine, cosine) = sin_cos(TAU * f64::from(i) / f64::from(tube));
        [cosine as f32, sine as f32, 0.0, 0.0]
    });
    grid(&profile.collect::<Vec<_>>(), around)
}
