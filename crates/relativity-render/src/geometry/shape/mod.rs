//! Solid shapes at rest in the frame of their group, and their geometry: a file for each shape, which answers
//! every question about it.

mod cuboid;
mod cylinder;
pub(crate) mod flat;
pub(crate) mod questions;
pub(crate) mod ring;
pub(crate) mod round;
mod sphere;
pub mod strokes;
#[cfg(test)]
mod tests;
mod tube;

use glam::{DMat3, DQuat, DVec3};

use crate::geometry::block::Block;
use crate::geometry::capsule::Capsule;
use crate::geometry::corners::{Coarseness, Template};
use crate::geometry::kind::Kind;
use crate::kinematics::spin::{Spin, about_y};
pub(crate) use cuboid::BoxForm;
use cuboid::Cuboid;
use cylinder::{Cylinder, CylinderForm};
use questions::{CentredShape, Foot, PackedShape, PlacedShape};
use ring::Ring;
pub(crate) use ring::RingForm;
use sphere::{Sphere, SphereForm};
use strokes::{Onlooker, Path, Stroke};
use tube::TubeForm;

/// A solid shape in the rest frame. Lengths in the scene's unit; `[x, y, z]`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Shape {
    /// A ball of any size.
    Sphere {
        /// Centre of the ball.
        centre: [f64; 3],
        /// Radius of the ball, above 0.
        radius: f64,
    },
    /// A cylinder with rounded ends (a capsule).
    Tube {
        /// Centre of one rounded end.
        from: [f64; 3],
        /// Centre of the other.
        to: [f64; 3],
        /// Radius of the tube, above 0.
        radius: f64,
    },
    /// A torus, the shape of a tyre.
    Ring {
        /// Centre of the torus.
        centre: [f64; 3],
        /// Unit vector along the axis of symmetry.
        axis: [f64; 3],
        /// Radius of the circle in the middle of the tube, above `tube_radius`.
        radius: f64,
        /// Radius of the tube, above 0.
        tube_radius: f64,
    },
    /// A box: three pairs of flat faces at right angles.
    Box {
        /// Centre of the box.
        centre: [f64; 3],
        /// Half its lengths along its own axes, above 0.
        half: [f64; 3],
        /// Unit quaternion `[x, y, z, w]` that turns its own axes into those of the rest frame.
        turn: [f64; 4],
    },
    /// A cylinder with flat ends.
    Cylinder {
        /// Centre of one flat end.
        from: [f64; 3],
        /// Centre of the other, elsewhere.
        to: [f64; 3],
        /// Radius of the cylinder, above 0.
        radius: f64,
    },
}

/// Returns the tube between these ends.
fn capsule(from: [f64; 3], to: [f64; 3], radius: f64) -> Capsule {
    Capsule { from: from.into(), to: to.into(), radius }
}

/// A shape about its centre, prepared for rays, patterns and triangles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum PreparedShape {
    Sphere(SphereForm),
    Tube(TubeForm),
    Ring(RingForm),
    Box(BoxForm),
    Cylinder(CylinderForm),
}

impl Shape {
    /// Asks the file of the shape.
    fn ask<T>(&self, question: impl FnOnce(&dyn PlacedShape) -> T) -> T {
        match *self {
            Self::Sphere { centre, radius } => question(&Sphere { centre: centre.into(), radius }),
            Self::Tube { from, to, radius } => question(&capsule(from, to, radius)),
            Self::Ring { centre, axis, radius, tube_radius } => {
                question(&Ring { centre: centre.into(), axis: axis.into(), radius, tube_radius })
            }
            Self::Box { centre, half, turn } => {
                question(&Cuboid { centre: centre.into(), half: half.into(), turn: DQuat::from_array(turn) })
            }
            Self::Cylinder { from, to, radius } => question(&Cylinder(capsule(from, to, radius))),
        }
    }

    /// The shape with its places mapped, and its own directions turned by `angle` about y, if at all.
    fn mapped(self, place: impl Fn([f64; 3]) -> [f64; 3], angle: Option<f64>) -> Self {
        match self {
            Self::Sphere { centre, radius } => Self::Sphere { centre: place(centre), radius },
            Self::Tube { from, to, radius } => Self::Tube { from: place(from), to: place(to), radius },
            Self::Ring { centre, axis, radius, tube_radius } => {
                let axis = angle.map_or(axis, |angle| about_y(axis.into(), angle).to_array());
                Self::Ring { centre: place(centre), axis, radius, tube_radius }
            }
            Self::Box { centre, half, turn } => {
                let turned = |angle| DQuat::from_rotation_y(angle) * DQuat::from_array(turn);
                let turn = angle.map_or(turn, |angle| turned(angle).to_array());
                Self::Box { centre: place(centre), half, turn }
            }
            Self::Cylinder { from, to, radius } => {
                Self::Cylinder { from: place(from), to: place(to), radius }
            }
        }
    }

    /// Returns the shape's centre, and the shape about it.
    pub(crate) fn about_centre(&self) -> (DVec3, PreparedShape) {
        match *self {
            Self::Sphere { centre, radius } => (centre.into(), PreparedShape::Sphere(SphereForm { radius })),
            Self::Tube { from, to, radius } => {
                let (from, to) = (DVec3::from(from), DVec3::from(to));
                let half_length = 0.5 * (to - from).length();
                if half_length == 0.0 {
                    return (from, PreparedShape::Sphere(SphereForm { radius }));
                }
                let axis = (to - from) / (2.0 * half_length);
                (0.5 * (from + to), PreparedShape::Tube(TubeForm { axis, half_length, radius }))
            }
            Self::Ring { centre, axis, radius, tube_radius } => {
                (centre.into(), PreparedShape::Ring(RingForm { axis: axis.into(), radius, tube_radius }))
            }
            Self::Box { centre, half, turn } => {
                let axes = DMat3::from_quat(DQuat::from_array(turn));
                (centre.into(), PreparedShape::Box(BoxForm { axes, half: half.into() }))
            }
            Self::Cylinder { from, to, radius } => {
                let (from, to) = (DVec3::from(from), DVec3::from(to));
                let half_length = 0.5 * (to - from).length();
                let axis = (to - from).normalize();
                (0.5 * (from + to), PreparedShape::Cylinder(CylinderForm { axis, half_length, radius }))
            }
        }
    }

    /// The shape moved by `offset`.
    #[must_use]
    pub fn moved(self, offset: [f64; 3]) -> Self {
        self.mapped(|[x, y, z]| [x + offset[0], y + offset[1], z + offset[2]], None)
    }

    /// The shape turned by `angle` about the axle of `spin`, as [`Spin::turned`].
    #[must_use]
    pub(crate) fn turned(self, spin: &Spin, angle: f64) -> Self {
        self.mapped(|place| spin.turned(place.into(), angle).to_array(), Some(angle))
    }

    /// Returns the line along which the onlooker's lines of sight touch the shape; `onlooker_at` gives the
    /// onlooker for the shape's middle. `None` for shapes that are drawn with strokes; these do not call
    /// `onlooker_at`.
    #[must_use]
    pub fn silhouette(&self, onlooker_at: impl Fn(DVec3) -> Onlooker) -> Option<Path> {
        self.ask(|shape| shape.silhouette(&onlooker_at))
    }
}

/// Defines questions to a shape that its file answers.
macro_rules! questions {
    ($($(#[$doc:meta])* $visibility:vis fn $name:ident($($about:ident: $type:ty)?) -> $answer:ty;)*) => {
        impl Shape {$(
            $(#[$doc])*
            #[must_use]
            $visibility fn $name(&self $(, $about: $type)?) -> $answer {
                self.ask(|shape| shape.$name($($about)?))
            }
        )*}
    };
}

questions! {
    /// The name in scene files.
    pub fn name() -> &'static str;
    /// The numbers in the order of the scene format; of a box half its size, and its turn as a quaternion.
    pub fn numbers() -> Vec<f64>;
    /// Whether it stays as it is while it turns: a body of revolution about the axle of `spin`.
    pub fn is_round_about(spin: &Spin) -> bool;
    /// The distance of `place` at rest from the surface; below 0 inside.
    pub fn distance(place: DVec3) -> f64;
    /// The centre and the radius of a ball at rest that holds the shape.
    pub fn ball_around() -> ([f64; 3], f64);
    /// The point with the largest x, at rest; any of them where there are several.
    pub fn forward_most() -> DVec3;
    /// Places at rest that stand for all of it, such as the corners of a box.
    pub fn samples() -> Vec<DVec3>;
    /// The middles of both ends at rest, of what has ends.
    pub fn ends() -> Option<[[f64; 3]; 2]>;
    /// The strokes that it is drawn with, whoever looks; none of a ball, which is drawn with its
    /// [`Self::silhouette`].
    pub fn strokes() -> Vec<Stroke>;
    /// The turn from its own axes to those of the rest frame.
    ///
    /// The own z axis of a tube and of a cylinder (from `from` to `to`) and of a ring is its axis, reached by
    /// the shortest turn, which fixes the other two; to -z it is half a turn about x. A ball has the axes of
    /// the rest frame; a box says how it is turned.
    pub(crate) fn turn() -> DQuat;
    /// The kind of the shape in the shaders.
    pub(crate) fn kind() -> Kind;
    /// Capsules that contain it; none for a box.
    pub(crate) fn capsules() -> Vec<Capsule>;
    /// The block that contains it, if its bounds are better worked out from that than from capsules.
    pub(crate) fn block() -> Option<Block>;
    /// The lowest place and the shadow there, of a wheel that does not lie flat, a ball or a box.
    pub(crate) fn foot() -> Option<Foot>;
    /// Returns the shape's numbers for the shaders.
    pub(crate) fn packed() -> PackedShape;
}

impl PreparedShape {
    /// The answers of the shape's file.
    #[inline]
    pub fn answers(&self) -> &dyn CentredShape {
        match self {
            Self::Sphere(form) => form,
            Self::Tube(form) => form,
            Self::Ring(form) => form,
            Self::Box(form) => form,
            Self::Cylinder(form) => form,
        }
    }
}

/// Corners and triangles of the shape of this `kind`; none of a model, which has its own.
pub(crate) fn template(kind: Kind, coarseness: Coarseness) -> Template {
    match kind {
        Kind::Tube => tube::template(coarseness),
        Kind::Ring => ring::template(coarseness),
        Kind::Box => cuboid::template(coarseness),
        Kind::Cylinder => cylinder::template(coarseness),
        Kind::Model => Template::default(),
    }
}
