//! Blocks that contain a shape with flat faces: what its bounds in a picture are worked out from.

use glam::{DMat3, DQuat, DVec3};

use super::capsule::Capsule;
use crate::view::group_view::GroupView;

/// A box in the rest frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// Centre of the block.
    pub centre: DVec3,
    /// From there to the middles of three faces, at right angles.
    pub half_axes: [DVec3; 3],
    /// The least radius of the shape in it.
    pub radius: f64,
}

impl Block {
    /// The block with half these sides along its own axes, which have this `turn`.
    pub fn new(centre: DVec3, half: DVec3, turn: DQuat) -> Self {
        let axes = DMat3::from_quat(turn);
        let half_axes = [axes.x_axis * half.x, axes.y_axis * half.y, axes.z_axis * half.z];
        Self { centre, half_axes, radius: half.min_element() }
    }

    /// From the camera's event, in the axes along the group's motion.
    pub fn along_motion_from_camera(&self, view: &GroupView) -> Self {
        Self {
            centre: view.along_motion_from_camera(self.centre),
            half_axes: self.half_axes.map(|axis| view.velocity.motion_from_group(axis)),
            ..*self
        }
    }

    /// Returns both halves of the block, divided across its longest axis.
    pub fn halves(&self) -> [Self; 2] {
        let squares = DVec3::from(self.half_axes.map(DVec3::length_squared));
        let mut half = *self;
        half.half_axes[squares.max_position()] *= 0.5;
        let step = half.half_axes[squares.max_position()];
        [-step, step].map(|step| Self { centre: self.centre + step, ..half })
    }

    /// Returns the corners of the block.
    pub fn corners(&self) -> [DVec3; 8] {
        let [x, y, z] = self.half_axes;
        std::array::from_fn(|i| {
            let side = |bit: usize| if i & bit == 0 { -1.0 } else { 1.0 };
            self.centre + x * side(1) + y * side(2) + z * side(4)
        })
    }

    /// Returns the edges of the block, as tubes without a radius.
    pub fn edges(&self) -> impl Iterator<Item = Capsule> + use<> {
        let corners = self.corners();
        let edge = move |from: usize, bit: usize| {
            (from & bit == 0).then(|| Capsule { from: corners[from], to: corners[from | bit], radius: 0.0 })
        };
        (0..8).flat_map(move |from| [1, 2, 4].map(|bit| edge(from, bit)).into_iter().flatten())
    }

    /// The ball around it.
    pub fn ball_around(&self) -> Capsule {
        let radius = self.half_axes.iter().map(|axis| axis.length_squared()).sum::<f64>().sqrt();
        Capsule::ball(self.centre, radius)
    }

    /// Returns the distance of the block from the origin; 0 where it contains it.
    pub fn distance(&self) -> f64 {
        self.distance_from(DVec3::ZERO)
    }

    /// Returns the distance of the block from a place; 0 where it contains that.
    pub fn distance_from(&self, place: DVec3) -> f64 {
        let centre = self.centre - place;
        let nearest = self.half_axes.iter().fold(centre, |from_place, axis| {
            let along = -centre.dot(*axis) / axis.length_squared();
            from_place + *axis * along.clamp(-1.0, 1.0)
        });
        nearest.length()
    }
}
