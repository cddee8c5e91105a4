//! A cylinder with flat ends.

use glam::{DQuat, DVec2, DVec3};
use relativity_core::math;

use super::flat::{LEVEL, between_planes, block_distance};
use super::questions::{CentredShape, LocalRay, PackedForm, PackedShape, PlacedShape};
use super::round::{Arc, circle, closing, disc, grid_with_ends, outward};
use super::strokes::{Path, Stroke};
use crate::geometry::block::Block;
use crate::geometry::capsule::Capsule;
use crate::geometry::corners::{Coarseness, Template};
use crate::geometry::kind::Kind;
use crate::kinematics::spin::Spin;

/// Samples around each end.
const AROUND: u32 = 12;

/// A cylinder where it is placed, by the capsule around it: questions that do not depend on what the ends
/// look like are that one's.
pub(super) struct Cylinder(pub Capsule);

impl Cylinder {
    /// Half its sizes along its own axes.
    fn half(&self) -> DVec3 {
        let Capsule { from, to, radius } = self.0;
        DVec3::new(radius, radius, 0.5 * (to - from).length())
    }
}

impl PlacedShape for Cylinder {
    fn name(&self) -> &'static str {
        "cylinder"
    }

    fn kind(&self) -> Kind {
        Kind::Cylinder
    }

    fn numbers(&self) -> Vec<f64> {
        self.0.numbers()
    }

    fn is_round_about(&self, spin: &Spin) -> bool {
        self.0.is_round_about(spin)
    }

    fn turn(&self) -> DQuat {
        self.0.turn()
    }

    fn distance(&self, place: DVec3) -> f64 {
        let Capsule { from, to, radius } = self.0;
        let axis = to - from;
        let off = place - (from + 0.5 * axis);
        let along = off.dot(axis) / axis.length();
        let across = off.reject_from(axis).length();
        let beyond = DVec2::new(across - radius, along.abs() - 0.5 * axis.length());
        beyond.max(DVec2::ZERO).length() + beyond.max_element().min(0.0)
    }

    fn ball_around(&self) -> ([f64; 3], f64) {
        self.0.ball_around()
    }

    fn forward_most(&self) -> DVec3 {
        let Capsule { from, to, radius } = self.0;
        let axis = (to - from).normalize();
        let along = if axis.x.abs() < LEVEL { 0.5 } else { f64::from(axis.x > 0.0) };
        let outward = DVec3::X.reject_from_normalized(axis);
        let rim = if outward.length() < LEVEL { DVec3::ZERO } else { outward.normalize() * radius };
        from.lerp(to, along) + rim
    }

    /// Returns places around both ends.
    fn samples(&self) -> Vec<DVec3> {
        let Capsule { from, to, radius } = self.0;
        [from, to].into_iter().flat_map(|end| circle(end, to - from, radius, AROUND)).collect()
    }

    fn ends(&self) -> Option<[[f64; 3]; 2]> {
        self.0.ends()
    }

    /// Both ends, and four lines along it.
    fn strokes(&self) -> Vec<Stroke> {
        let Capsule { from, to, radius } = self.0;
        let axis = (to - from).try_normalize().unwrap_or(DVec3::Z);
        let ends = [from, to].map(|end| Stroke::edge(Path::circle(end, axis, radius)));
        // Where the sides are seen from above and from the side, as far as they can be.
        let beside = |towards: DVec3| towards.reject_from_normalized(axis).try_normalize();
        let sides = DVec3::AXES.into_iter().filter_map(beside);
        let offsets = sides.flat_map(|side| [radius * side, -radius * side]);
        ends.into_iter().chain(offsets.map(|offset| Stroke::line(from + offset, to + offset))).collect()
    }

    fn capsules(&self) -> Vec<Capsule> {
        vec![self.0]
    }

    /// Returns the block of a short cylinder: around a longer one the ends of a capsule are smaller than the
    /// corners of a block.
    fn block(&self) -> Option<Block> {
        let (half, Capsule { from, to, radius }) = (self.half(), self.0);
        (half.z < radius).then(|| Block::new(0.5 * (from + to), half, self.turn()))
    }

    fn packed(&self) -> PackedShape {
        let half = self.half();
        let form = PackedForm::Vector(half, 0.0);
        PackedShape { place: 0.5 * (self.0.from + self.0.to), radius: half.min_element(), form }
    }
}

/// A cylinder about its centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CylinderForm {
    pub axis: DVec3,
    pub half_length: f64,
    pub radius: f64,
}

impl CylinderForm {
    /// `t` half lengths along the axis from the middle, and `share` of the radius off it, in its own axes.
    fn at(&self, t: f64, share: f64, angle: f64) -> DVec3 {
        outward(angle) * (share * self.radius) + DVec3::Z * (t * self.half_length)
    }
}

impl CentredShape for CylinderForm {
    fn entry(&self, ray: &LocalRay) -> Option<f64> {
        let (Self { axis, half_length, radius }, LocalRay { start, direction, .. }) = (*self, *ray);
        let [enters, leaves] = between_planes(axis.dot(start), axis.dot(direction), half_length)?;
        let across = direction.cross(axis);
        let sine_squared = across.length_squared();
        let (first, last) = if sine_squared == 0.0 {
            if start.cross(axis).length() > radius {
                return None;
            }
            (enters, leaves)
        } else {
            // As of a capsule.
            let offset = start.dot(across);
            let discriminant = radius * radius * sine_squared - offset * offset;
            if discriminant < 0.0 {
                return None;
            }
            let [middle, half_chord] = [-start.cross(axis).dot(across), discriminant.sqrt()];
            let side = [middle - half_chord, middle + half_chord].map(|along| along / sine_squared);
            (enters.max(side[0]), leaves.min(side[1]))
        };
        if first <= last { ray.in_front(first) } else { None }
    }

    fn distance(&self, position: DVec3) -> (f64, DVec3) {
        let along = self.axis.dot(position);
        let off_axis = position - self.axis * along;
        let own = DVec3::new(off_axis.length(), along, 0.0);
        let half = DVec3::new(self.radius, self.half_length, f64::INFINITY);
        let (distance, outward) = block_distance(own, half);
        (distance, off_axis.normalize_or_zero() * outward.x + self.axis * outward.y)
    }

    fn normal(&self, position: DVec3) -> DVec3 {
        let along = self.axis.dot(position);
        let off_axis = position - self.axis * along;
        if along.abs() - self.half_length > off_axis.length() - self.radius {
            self.axis * along.signum()
        } else {
            off_axis.normalize()
        }
    }

    fn half_width(&self, direction: DVec3) -> f64 {
        let cosine = self.axis.dot(direction).abs();
        let sine = self.axis.cross(direction).length();
        self.radius.min(self.half_length * sine + self.radius * cosine)
    }

    fn bounding_radius(&self) -> f64 {
        math::hypot(self.half_length, self.radius)
    }

    fn core(&self) -> (DVec3, f64) {
        (self.axis * self.half_length, self.radius)
    }

    fn half_sides(&self) -> DVec3 {
        self.axis.abs() * self.half_length + disc(self.axis) * self.radius
    }

    fn half_length(&self) -> f64 {
        self.half_length
    }

    fn squares(&self, step: f64) -> [f64; 2] {
        [step, closing(self.radius, step)]
    }

    /// On an end from its middle, on to the side.
    fn along(&self, off_axis: f64, outward: DVec3, z: f64, normal: f64) -> Arc {
        let Self { half_length, radius, .. } = *self;
        if normal.abs() > 0.5 {
            let inward = (radius - off_axis).copysign(normal);
            return (half_length + half_length.copysign(normal) + inward, outward * -normal.signum());
        }
        (z + half_length, DVec3::Z)
    }

    /// The middles of both ends.
    fn visit_farthest(&self, visit: &mut dyn FnMut(DVec3)) {
        [-1.0, 1.0].map(|t| self.at(t, 0.0, 0.0)).into_iter().for_each(visit);
    }
}

/// Corners and triangles of a cylinder.
pub(super) fn template(coarseness: Coarseness) -> Template {
    grid_with_ends(profile, coarseness)
}

/// From the middle of one end to that of the other.
fn profile(end: u32, side: u32) -> Vec<[f32; 4]> {
    let share = |i: u32, count: u32| (f64::from(i) / f64::from(count)) as f32;
    let near = (0..=end).map(|i| [-1.0, share(i, end), -1.0, 0.0]);
    let along = (0..=side).map(|i| [2.0 * share(i, side) - 1.0, 1.0, 0.0, 1.0]);
    let far = (0..=end).rev().map(|i| [1.0, share(i, end), 1.0, 0.0]);
    near.chain(along).chain(far).collect()
}
