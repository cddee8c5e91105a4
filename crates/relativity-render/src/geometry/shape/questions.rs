//! The questions that each shape answers in a file of its own.

use glam::{DQuat, DVec2, DVec3};

use super::round::Arc;
use super::strokes::{Onlooker, Path, Stroke};
use crate::geometry::block::Block;
use crate::geometry::capsule::Capsule;
use crate::geometry::kind::Kind;
use crate::kinematics::spin::Spin;

/// A shape where it is placed at rest.
pub(crate) trait PlacedShape {
    /// The name in scene files.
    fn name(&self) -> &'static str;

    /// The kind of the shape in the shaders.
    fn kind(&self) -> Kind;

    /// The numbers in the order of the scene format.
    fn numbers(&self) -> Vec<f64>;

    /// Whether it stays as it is while it turns about the axle of `spin`.
    fn is_round_about(&self, spin: &Spin) -> bool;

    /// The turn from its own axes to those of the rest frame.
    fn turn(&self) -> DQuat;

    /// The distance of `place` from the surface; below 0 inside.
    fn distance(&self, place: DVec3) -> f64;

    /// The centre and the radius of a ball that holds the shape.
    fn ball_around(&self) -> ([f64; 3], f64);

    /// The point with the largest x; any of them where there are several.
    fn forward_most(&self) -> DVec3;

    /// Places that stand for all of it.
    fn samples(&self) -> Vec<DVec3>;

    /// The middles of both ends, of what has ends.
    fn ends(&self) -> Option<[[f64; 3]; 2]> {
        None
    }

    /// The strokes that it is drawn with.
    fn strokes(&self) -> Vec<Stroke>;

    /// The line along which lines of sight touch it, if it is drawn with that, for the onlooker at its
    /// middle.
    fn silhouette(&self, _: &dyn Fn(DVec3) -> Onlooker) -> Option<Path> {
        None
    }

    /// Capsules that contain it; none for what is always in a block.
    fn capsules(&self) -> Vec<Capsule>;

    /// The block that contains it, if its bounds are better worked out from that than from capsules.
    fn block(&self) -> Option<Block> {
        None
    }

    /// The lowest place and the shadow there, if it stands on the ground at one place.
    fn foot(&self) -> Option<Foot> {
        None
    }

    /// Place and form for the shaders, as [`Placement`](crate::scene::prepared_body::Placement) packs them.
    fn packed(&self) -> PackedShape;
}

/// The lowest place of a shape, and the size of its shadow on the ground there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Foot {
    pub place: DVec3,
    /// Radius of the shape, by which it is measured how near the ground is.
    pub radius: f64,
    /// Half the length and the width of the shadow.
    pub half: DVec2,
}

/// The numbers of a shape in the shaders.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PackedShape {
    pub place: DVec3,
    pub radius: f64,
    /// A place, or a vector; and a number beside it.
    pub form: PackedForm,
}

/// The rest of these numbers.
#[derive(Debug, Clone, Copy)]
pub(crate) enum PackedForm {
    /// A second place.
    Place(DVec3),
    /// A vector, and a number.
    Vector(DVec3, f64),
}

/// A shape about its centre, prepared for rays, patterns and triangles. Places are from the centre; along the
/// axes of the rest frame, or the shape's own where that is said.
pub(crate) trait CentredShape {
    /// The first entry of a ray, as its parameter.
    fn entry(&self, ray: &LocalRay) -> Option<f64>;

    /// Returns the distance of `position` from the surface, below 0 inside; and the unit vector away from the
    /// nearest place on the surface.
    fn distance(&self, position: DVec3) -> (f64, DVec3);

    /// Outward unit normal at a `position` on the surface.
    fn normal(&self, position: DVec3) -> DVec3;

    /// Half its least width, seen along the unit vector `direction` from afar: of what is round the same from
    /// everywhere.
    fn half_width(&self, _direction: DVec3) -> f64 {
        self.parallels_radius()
    }

    /// Radius of a ball that holds it.
    fn bounding_radius(&self) -> f64;

    /// Half of a line through the centre, and a radius, within which of that line it lies.
    fn core(&self) -> (DVec3, f64) {
        (DVec3::ZERO, self.bounding_radius())
    }

    /// Half the sides of the least box around it.
    fn half_sides(&self) -> DVec3;

    /// Half the length between the ends; 0 without ends.
    fn half_length(&self) -> f64 {
        0.0
    }

    /// Returns its sizes in the ways in which its grid is divided: around, across an end and along the side
    /// of what has two ends; around the axis and around the tube of a ring; along the axes of a box.
    fn grid_sizes(&self) -> [f64; 3] {
        let radius = self.parallels_radius();
        [radius, radius, self.half_length()].map(|half| 2.0 * half)
    }

    /// Returns the radius of the circle that parallels divide; 0 of what has none. Most go around the core.
    fn parallels_radius(&self) -> f64 {
        let (_, radius) = self.core();
        radius
    }

    /// The steps of squares as near to `step` as close around the shape: along, a length, and around,
    /// radians.
    fn squares(&self, step: f64) -> [f64; 2];

    /// The arc along the axis, and its gradient, at a place so far off the own axis in the direction
    /// `outward` at the height `z`, where the normal has this part along the axis.
    fn along(&self, off_axis: f64, outward: DVec3, z: f64, normal: f64) -> Arc;

    /// The radius of the circle that stripes follow, of what they go around.
    fn stripes_radius(&self) -> Option<f64> {
        None
    }

    /// Visits places in the shape's own axes of which one is about as far away as the farthest of the
    /// surface. Nothing is allocated, since it is asked in each frame.
    fn visit_farthest(&self, visit: &mut dyn FnMut(DVec3));
}

/// A ray from a start near the body's centre, which lies at the origin.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LocalRay {
    pub start: DVec3,
    pub direction: DVec3,
    /// Parameter of the camera: what lies before it is behind the camera.
    pub behind: f64,
}

impl LocalRay {
    /// Returns `t` if it is in front of the camera.
    pub fn in_front(&self, t: f64) -> Option<f64> {
        (t > self.behind).then_some(t)
    }
}
