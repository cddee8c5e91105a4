//! A box: three pairs of flat faces at right angles.

use glam::{DMat3, DQuat, DVec2, DVec3};
use relativity_core::math;

use super::flat::{LEVEL, between_planes, block_distance};
use super::questions::{CentredShape, Foot, LocalRay, PackedForm, PackedShape, PlacedShape};
use super::round::Arc;
use super::strokes::Stroke;
use crate::geometry::block::Block;
use crate::geometry::capsule::Capsule;
use crate::geometry::corners::{Coarseness, Corner, Template};
use crate::geometry::kind::Kind;
use crate::kinematics::spin::Spin;

/// Size of a box's shadow on the ground, in parts of its own.
const SHADOW: f64 = 1.5;

/// A box where it is placed.
pub(super) struct Cuboid {
    pub centre: DVec3,
    pub half: DVec3,
    pub turn: DQuat,
}

impl PlacedShape for Cuboid {
    fn name(&self) -> &'static str {
        "box"
    }

    fn kind(&self) -> Kind {
        Kind::Box
    }

    /// Half its size, and its turn as a quaternion.
    fn numbers(&self) -> Vec<f64> {
        [&self.centre.to_array()[..], &self.half.to_array(), &self.turn.to_array()].concat()
    }

    fn is_round_about(&self, _: &Spin) -> bool {
        false
    }

    fn turn(&self) -> DQuat {
        self.turn
    }

    fn distance(&self, place: DVec3) -> f64 {
        let own = self.turn.conjugate() * (place - self.centre);
        let beyond = own.abs() - self.half;
        beyond.max(DVec3::ZERO).length() + beyond.max_element().min(0.0)
    }

    fn ball_around(&self) -> ([f64; 3], f64) {
        (self.centre.to_array(), self.half.length())
    }

    fn forward_most(&self) -> DVec3 {
        let own = self.turn.conjugate() * DVec3::X;
        // Along an edge or a face that is across x, its middle.
        let side = |i: usize| if own[i].abs() < LEVEL { 0.0 } else { self.half[i].copysign(own[i]) };
        let corner = DVec3::new(side(0), side(1), side(2));
        self.centre + self.turn * corner
    }

    /// The corners, the middles of edges and the middles of faces.
    fn samples(&self) -> Vec<DVec3> {
        let sides = [-1.0, 0.0, 1.0];
        let all = sides.into_iter().flat_map(|x| sides.map(|y| [x, y]));
        let all = all.flat_map(|[x, y]| sides.map(|z| DVec3::new(x, y, z)));
        all.filter(|place| *place != DVec3::ZERO)
            .map(|place| self.centre + self.turn * (self.half * place))
            .collect()
    }

    /// Returns the twelve edges.
    fn strokes(&self) -> Vec<Stroke> {
        let axes = DVec3::AXES.map(|axis| self.turn * (axis * self.half));
        let edge = |edge: usize| {
            let (along, corner) = (edge / 4, edge % 4);
            let sign = |bit: usize| if corner & bit == 0 { -1.0 } else { 1.0 };
            let middle = self.centre + sign(1) * axes[(along + 1) % 3] + sign(2) * axes[(along + 2) % 3];
            Stroke::line(middle - axes[along], middle + axes[along])
        };
        (0..12).map(edge).collect()
    }

    fn capsules(&self) -> Vec<Capsule> {
        Vec::new()
    }

    fn block(&self) -> Option<Block> {
        Some(Block::new(self.centre, self.half, self.turn))
    }

    fn foot(&self) -> Option<Foot> {
        let Self { half: DVec3 { x, y, z }, turn, centre } = *self;
        let sides = [DVec3::X * x, DVec3::Y * y, DVec3::Z * z].map(|side| (turn * side).abs());
        let half = sides.into_iter().sum::<DVec3>();
        let shadow: DVec2 = SHADOW * half.truncate();
        Some(Foot { place: centre - DVec3::Z * half.z, radius: half.max_element(), half: shadow })
    }

    fn packed(&self) -> PackedShape {
        let form = PackedForm::Vector(self.half, 0.0);
        PackedShape { place: self.centre, radius: self.half.min_element(), form }
    }
}

/// A box about its centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BoxForm {
    /// The box's own axes, as columns.
    pub axes: DMat3,
    pub half: DVec3,
}

impl CentredShape for BoxForm {
    fn entry(&self, ray: &LocalRay) -> Option<f64> {
        let (start, direction) = (self.axes.transpose() * ray.start, self.axes.transpose() * ray.direction);
        let (mut first, mut last) = (f64::NEG_INFINITY, f64::INFINITY);
        for i in 0..3 {
            let [enters, leaves] = between_planes(start[i], direction[i], self.half[i])?;
            (first, last) = (first.max(enters), last.min(leaves));
        }
        if first <= last { ray.in_front(first) } else { None }
    }

    fn distance(&self, position: DVec3) -> (f64, DVec3) {
        let (distance, outward) = block_distance(self.axes.transpose() * position, self.half);
        (distance, self.axes * outward)
    }

    fn normal(&self, position: DVec3) -> DVec3 {
        let own = self.axes.transpose() * position;
        let face = (own.abs() - self.half).max_position();
        self.axes.col(face) * own[face].signum()
    }

    fn half_width(&self, direction: DVec3) -> f64 {
        let half = self.half;
        // What is seen is a hexagon, with sides along the images of the axes.
        let steep = (self.axes.transpose() * direction).abs();
        let across = |i: usize, j: usize| {
            (half[i] * steep[j] + half[j] * steep[i]) / math::hypot(steep[i], steep[j]).max(1e-30)
        };
        let widths = [across(0, 1), across(1, 2), across(2, 0)];
        // Seen along an axis, that one has no image.
        widths.into_iter().filter(|&width| width > 0.0).fold(f64::INFINITY, f64::min)
    }

    fn bounding_radius(&self) -> f64 {
        self.half.length()
    }

    fn half_sides(&self) -> DVec3 {
        std::iter::zip(self.axes.to_cols_array_2d(), self.half.to_array())
            .map(|(axis, half)| DVec3::from(axis).abs() * half)
            .sum()
    }

    fn grid_sizes(&self) -> [f64; 3] {
        (2.0 * self.half).to_array()
    }

    fn parallels_radius(&self) -> f64 {
        0.0
    }

    fn squares(&self, step: f64) -> [f64; 2] {
        [step, 1.0]
    }

    /// Nothing: it has no axis.
    fn along(&self, _: f64, _: DVec3, _: f64, _: f64) -> Arc {
        (0.0, DVec3::ZERO)
    }

    /// Visits the eight corners.
    fn visit_farthest(&self, visit: &mut dyn FnMut(DVec3)) {
        let corner = |i: u32| {
            let sign = |bit: u32| if i & bit == 0 { -1.0 } else { 1.0 };
            DVec3::new(sign(1), sign(2), sign(4)) * self.half
        };
        (0..8).map(corner).for_each(visit);
    }
}

/// Segments of the finest grid along each axis.
const SEGMENTS: u32 = 128;

/// Corners and triangles of a box: the six faces of the cube from -1 to 1, each a grid.
pub(super) fn template(coarseness: Coarseness) -> Template {
    let mut template = Template::default();
    let segments = [0, 1, 2].map(|axis| coarseness.segments(axis, SEGMENTS, 1));
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            add_face(&mut template, axis, side, segments);
        }
    }
    template
}

/// Adds the face across `axis` on one `side`, a grid that has as many segments along each axis as `segments`
/// gives for it.
fn add_face(template: &mut Template, axis: usize, side: f32, segments: [u32; 3]) {
    // As seen from outside, the second axis is a quarter turn from the first.
    let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
    let (u, v) = if side > 0.0 { (first, second) } else { (second, first) };
    let start = template.corners.len() as u32;
    let share = |i: u32, along: usize| (2.0 * f64::from(i) / f64::from(segments[along]) - 1.0) as f32;
    for j in 0..=segments[v] {
        for i in 0..=segments[u] {
            let mut profile = [0.0, 0.0, 0.0, axis as f32];
            (profile[axis], profile[u], profile[v]) = (side, share(i, u), share(j, v));
            template.corners.push(Corner { profile, turn: [0.0; 2] });
        }
    }
    let row = segments[u] + 1;
    let lows = (0..segments[v]).flat_map(|j| (0..segments[u]).map(move |i| start + j * row + i));
    template
        .triangles
        .extend(lows.flat_map(|low| [low, low + 1, low + row, low + row, low + 1, low + row + 1]));
}
