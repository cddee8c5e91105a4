//! The geometry of bodies at rest in the frame of their group: shapes and models of triangles, what contains
//! them, and the rays that meet them.

pub(crate) mod block;
pub(crate) mod capsule;
pub(crate) mod corners;
pub(crate) mod extent;
pub(crate) mod hierarchy;
pub mod intersect;
pub(crate) mod kind;
mod polynomial;
pub mod ray;
pub mod shape;
pub(crate) mod triangle_point;
pub mod triangles;
