//! Motion, without light: velocities of groups past a camera, and the turning of bodies within a group.

pub mod relative_velocity;
pub mod spin;
pub mod velocity;
