//! Drawing on a graphics device, by a ray test per pixel or by triangles.

mod answers;
mod buffers;
pub(crate) mod canvas;
pub(crate) mod composer;
pub(crate) mod device;
mod device_cache;
pub(crate) mod device_errors;
pub(crate) mod drawing;
pub(crate) mod error;
pub(crate) mod mesh;
#[doc(hidden)]
pub mod mirrors;
mod models;
mod pipelines;
pub(crate) mod preparation;
pub(crate) mod rays;
mod sampling;
pub(crate) mod target;
