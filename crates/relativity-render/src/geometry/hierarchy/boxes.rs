//! Boxes that are tested together.

use glam::Vec3;

use crate::simd::lanes::{F, LANES, Simd, SimdBase, V3};

/// Number of boxes that are tested together.
pub const WIDTH: usize = LANES;

/// Boxes, counted from the middle of the group; those that lack are no box.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Boxes {
    /// Middles of the boxes, part by part.
    pub centre: [[f32; WIDTH]; 3],
    /// Half of its sides.
    pub half: [[f32; WIDTH]; 3],
}

impl Boxes {
    /// Loads the boxes into registers.
    #[inline(always)]
    pub fn on<S: Simd>(&self, simd: S) -> BoxesOn<S> {
        let three = |parts: &[[f32; WIDTH]; 3]| {
            let [x, y, z] = parts.map(|part| F::from_slice(simd, &part));
            V3 { x, y, z }
        };
        BoxesOn { centre: three(&self.centre), half: three(&self.half) }
    }
}

/// Boxes in registers, ready for tests.
pub struct BoxesOn<S: Simd> {
    centre: V3<S>,
    half: V3<S>,
}

impl<S: Simd> BoxesOn<S> {
    /// Returns the middles of the boxes along `direction`, and half of their sizes along one of this `size`.
    #[inline(always)]
    pub fn along(&self, direction: Vec3, size: Vec3) -> (F<S>, F<S>) {
        let dot = |v: V3<S>, w: Vec3| v.x * w.x + v.y * w.y + v.z * w.z;
        (dot(self.centre, direction), dot(self.half, size))
    }

    /// Returns the middles of the boxes along the axis of this number, and half of their sides there.
    #[inline(always)]
    pub fn across(&self, axis: usize) -> (F<S>, F<S>) {
        let part = |v: V3<S>| [v.x, v.y, v.z][axis];
        (part(self.centre), part(self.half))
    }

    /// No place in a box is farther from the middle of the group.
    #[inline(always)]
    pub fn farthest(&self) -> F<S> {
        // The sum of its parts is no less than a length.
        let place = self.centre.abs() + self.half;
        place.x + place.y + place.z
    }
}
