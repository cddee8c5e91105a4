//! Coordinates on round shapes: along the axis, and around it.

use glam::DVec3;
use relativity_core::math::{atan2, hypot};

use crate::geometry::shape::PreparedShape;

/// A place on a round shape, in the shape's own coordinates.
#[derive(Debug, Clone, Copy)]
pub struct SurfacePlace {
    /// Arc along the axis, from the beginning; and its gradient.
    pub along: f64,
    pub along_gradient: DVec3,
    /// Angle around the axis, radians; and its gradient.
    pub around: f64,
    pub around_gradient: DVec3,
    /// Distance from the axis.
    pub off_axis: f64,
}

impl SurfacePlace {
    /// Returns the chart of `place`, on a round shape of this `form`, in its own axes.
    pub fn new(form: &PreparedShape, place: DVec3, normal: DVec3) -> Self {
        let DVec3 { x, y, z } = place;
        let off_axis = hypot(x, y);
        let outward = DVec3::new(x, y, 0.0) / off_axis.max(1e-30);
        let (along, along_gradient) = form.answers().along(off_axis, outward, z, normal.z);
        Self {
            along,
            along_gradient,
            around: atan2(y, x),
            around_gradient: DVec3::Z.cross(outward) / off_axis.max(1e-30),
            off_axis,
        }
    }
}
