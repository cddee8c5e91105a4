//! Places of a shape at rest that stand for all of it, and the ends of what is long.

use std::f64::consts::TAU;

use glam::{DQuat, DVec3};
use relativity_core::math::sin_cos;

use super::Shape;

/// Steps along a tube, and around a ring and an end of a cylinder.
const ALONG: u32 = 4;
const AROUND: u32 = 12;

impl Shape {
    /// Places at rest: along the middle lines of what is slender, tubes and rings; on balls where they end along the axes;
    /// the corners, middles of edges and middles of faces of boxes; around both ends of cylinders.
    #[must_use]
    pub fn samples(&self) -> Vec<DVec3> {
        match *self {
            Self::Sphere { center, radius } => {
                let ends = DVec3::AXES.into_iter().flat_map(|axis| [-axis, axis]);
                ends.map(|end| DVec3::from(center) + radius * end).collect()
            }
            Self::Tube { from, to, .. } => (0..=ALONG)
                .map(|step| DVec3::from(from).lerp(to.into(), f64::from(step) / f64::from(ALONG)))
                .collect(),
            Self::Ring { center, axis, radius, .. } => circle(center.into(), axis.into(), radius, AROUND),
            Self::Box { center, half, turn } => {
                let (turn, half) = (DQuat::from_array(turn), DVec3::from(half));
                let sides = [-1.0, 0.0, 1.0];
                let all = sides.into_iter().flat_map(|x| sides.map(|y| [x, y]));
                let all = all.flat_map(|[x, y]| sides.map(|z| DVec3::new(x, y, z)));
                all.filter(|place| *place != DVec3::ZERO)
                    .map(|place| DVec3::from(center) + turn * (half * place))
                    .collect()
            }
            Self::Cylinder { from, to, radius } => {
                let axis = DVec3::from(to) - DVec3::from(from);
                [from, to].into_iter().flat_map(|end| circle(end.into(), axis, radius, AROUND)).collect()
            }
        }
    }

    /// The middles of both ends at rest, of what has ends.
    #[must_use]
    pub const fn ends(&self) -> Option<[[f64; 3]; 2]> {
        match *self {
            Self::Tube { from, to, .. } | Self::Cylinder { from, to, .. } => Some([from, to]),
            Self::Sphere { .. } | Self::Ring { .. } | Self::Box { .. } => None,
        }
    }
}

/// Returns `count` places on the circle about `axis`, evenly spread.
#[must_use]
pub fn circle(center: DVec3, axis: DVec3, radius: f64, count: u32) -> Vec<DVec3> {
    let (across, up) = axis.normalize_or(DVec3::Z).any_orthonormal_pair();
    let place = |step| {
        let (sin, cos) = sin_cos(TAU * f64::from(step) / f64::from(count));
        center + radius * (cos * across + sin * up)
    };
    (0..count).map(place).collect()
}
