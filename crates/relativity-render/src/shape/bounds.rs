//! A ball around a shape.

use glam::DVec3;

use super::Shape;

impl Shape {
    /// The centre and the radius of a ball at rest that holds the shape.
    #[must_use]
    pub fn ball_around(&self) -> ([f64; 3], f64) {
        match *self {
            Self::Sphere { center, radius } => (center, radius),
            Self::Tube { from, to, radius } | Self::Cylinder { from, to, radius } => {
                let (from, to) = (DVec3::from(from), DVec3::from(to));
                (from.midpoint(to).to_array(), 0.5 * from.distance(to) + radius)
            }
            Self::Ring { center, radius, tube_radius, .. } => (center, radius + tube_radius),
            Self::Box { center, half, .. } => (center, DVec3::from(half).length()),
        }
    }
}
