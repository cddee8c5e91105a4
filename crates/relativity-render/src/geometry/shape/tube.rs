//! A cylinder with rounded ends (a capsule).

use std::f64::consts::FRAC_PI_2;

use glam::{DQuat, DVec3};
use relativity_core::math::sin_cos;

use super::questions::{CentredShape, LocalRay, PackedForm, PackedShape, PlacedShape};
use super::round::{Arc, arc, ball_entry, closing, grid_with_ends, outward, turn_to};
use super::strokes::{Path, Stroke};
use crate::geometry::capsule::Capsule;
use crate::geometry::corners::{Coarseness, Template};
use crate::geometry::kind::Kind;
use crate::kinematics::spin::Spin;

/// Steps along a tube from one of its samples to the next.
const ALONG: u32 = 4;

/// A tube where it is placed: its own capsule.
impl PlacedShape for Capsule {
    fn name(&self) -> &'static str {
        "tube"
    }

    fn kind(&self) -> Kind {
        Kind::Tube
    }

    fn numbers(&self) -> Vec<f64> {
        [&self.from.to_array()[..], &self.to.to_array(), &[self.radius]].concat()
    }

    fn is_round_about(&self, spin: &Spin) -> bool {
        spin.is_on_axle(self.from) && spin.is_on_axle(self.to)
    }

    fn turn(&self) -> DQuat {
        turn_to(self.to - self.from)
    }

    fn distance(&self, place: DVec3) -> f64 {
        let axis = self.to - self.from;
        let off = place - self.from;
        let along = (off.dot(axis) / axis.length_squared()).clamp(0.0, 1.0);
        (off - along * axis).length() - self.radius
    }

    fn ball_around(&self) -> ([f64; 3], f64) {
        (self.from.midpoint(self.to).to_array(), 0.5 * self.from.distance(self.to) + self.radius)
    }

    fn forward_most(&self) -> DVec3 {
        let front = if self.from.x > self.to.x { self.from } else { self.to };
        front + self.radius * DVec3::X
    }

    /// Along its middle line.
    fn samples(&self) -> Vec<DVec3> {
        (0..=ALONG).map(|step| self.from.lerp(self.to, f64::from(step) / f64::from(ALONG))).collect()
    }

    fn ends(&self) -> Option<[[f64; 3]; 2]> {
        Some([self.from.to_array(), self.to.to_array()])
    }

    fn strokes(&self) -> Vec<Stroke> {
        vec![Stroke { path: Path::Line { from: self.from, to: self.to }, radius: self.radius }]
    }

    fn capsules(&self) -> Vec<Capsule> {
        vec![*self]
    }

    fn packed(&self) -> PackedShape {
        PackedShape { place: self.from, radius: self.radius, form: PackedForm::Place(self.to) }
    }
}

/// A tube about its centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TubeForm {
    pub axis: DVec3,
    pub half_length: f64,
    pub radius: f64,
}

impl TubeForm {
    /// The point of its middle line nearest to `position`.
    fn nearest_on_axis(&self, position: DVec3) -> DVec3 {
        self.axis * self.axis.dot(position).clamp(-self.half_length, self.half_length)
    }
}

impl CentredShape for TubeForm {
    fn entry(&self, ray: &LocalRay) -> Option<f64> {
        let (Self { axis, half_length, radius }, LocalRay { start, direction, .. }) = (*self, *ray);
        let across = direction.cross(axis);
        let sine_squared = across.length_squared();
        // Distance of ray and axis is |start . across| / |across|: no difference of large squares.
        let offset = start.dot(across);
        let discriminant = radius * radius * sine_squared - offset * offset;
        if discriminant < 0.0 {
            return None;
        }
        let along_slope = direction.dot(axis);
        let cap = |end: f64| ray.in_front(ball_entry(start - axis * end, direction, radius)?);
        if sine_squared == 0.0 {
            return cap(-half_length.copysign(along_slope));
        }
        let t = -(start.cross(axis).dot(across) + discriminant.sqrt()) / sine_squared;
        let along = axis.dot(start) + along_slope * t;
        if along.abs() <= half_length { ray.in_front(t) } else { cap(half_length.copysign(along)) }
    }

    fn distance(&self, position: DVec3) -> (f64, DVec3) {
        let off = position - self.nearest_on_axis(position);
        (off.length() - self.radius, off.normalize_or_zero())
    }

    fn normal(&self, position: DVec3) -> DVec3 {
        (position - self.nearest_on_axis(position)).normalize()
    }

    fn bounding_radius(&self) -> f64 {
        self.half_length + self.radius
    }

    fn core(&self) -> (DVec3, f64) {
        (self.axis * self.half_length, self.radius)
    }

    fn half_sides(&self) -> DVec3 {
        self.axis.abs() * self.half_length + self.radius
    }

    fn half_length(&self) -> f64 {
        self.half_length
    }

    fn squares(&self, step: f64) -> [f64; 2] {
        [step, closing(self.radius, step)]
    }

    fn along(&self, off_axis: f64, outward: DVec3, z: f64, _: f64) -> Arc {
        along_tube(self.half_length, self.radius, off_axis, outward, z)
    }

    /// Visits a place at the rim of each end.
    fn visit_farthest(&self, visit: &mut dyn FnMut(DVec3)) {
        let rim = |t: f64| DVec3::Z * (t * self.half_length) + outward(0.0) * self.radius;
        [-1.0, 1.0].map(rim).into_iter().for_each(visit);
    }
}

/// The arc along a tube, or a ball, which is one without a length.
pub(super) fn along_tube(half_length: f64, radius: f64, off_axis: f64, outward: DVec3, z: f64) -> Arc {
    let beyond = z - z.clamp(-half_length, half_length);
    let (arc, gradient) = arc(off_axis, outward, beyond, radius);
    (half_length + (z - beyond) + arc, gradient)
}

/// Corners and triangles of a tube; of a ball, whose sides have no length.
pub(super) fn template(coarseness: Coarseness) -> Template {
    grid_with_ends(profile, coarseness)
}

/// From the pole of one end to that of the other.
fn profile(end: u32, side: u32) -> Vec<[f32; 4]> {
    let cap = |i: u32, sign: f64| {
        let (sine, cosine) = sin_cos(FRAC_PI_2 * f64::from(i) / f64::from(end));
        [sign as f32, (sign * cosine) as f32, sine as f32, 0.0]
    };
    let near = (0..=end).map(|i| cap(i, -1.0));
    let along = (1..side).map(|i| [(2.0 * f64::from(i) / f64::from(side) - 1.0) as f32, 0.0, 1.0, 0.0]);
    let far = (0..=end).rev().map(|i| cap(i, 1.0));
    near.chain(along).chain(far).collect()
}
