//! Draws a scene that moves past, as one aperture sees it at one time.
//!
//! A resting scene is ray-traced exactly in its rest frame: the camera's event and each line of sight
//! are boosted there, where rays are straight and bodies stand still. Knows wgpu, but no windows, and reads and
//! writes no files.

pub mod backdrop;
pub mod body;
mod buffers;
pub mod camera;
mod canvas;
mod capsule;
pub mod colour;
pub mod cone;
mod effects;
mod exact;
mod footprint;
mod frame;
pub mod gpu;
mod hits;
pub mod intersect;
mod kind;
mod mesh;
#[doc(hidden)]
pub mod mirrors;
mod palette;
pub mod picture;
mod pipelines;
mod placed;
mod polynomial;
pub mod ray;
pub mod rectified_hits;
pub mod rectify;
pub mod reference;
pub mod shade;
mod shaders;
mod surface;
mod target;
mod tiles;
pub mod view;

pub use body::{Body, Shape};
pub use camera::{Camera, Gaze};
pub use exact::ExactRenderer;
pub use gpu::{Gpu, GpuError};
pub use mesh::MeshRenderer;
pub use picture::Picture;
pub use reference::{Hit, HitImage, ReferenceScene};
pub use target::EyeTarget;
pub use view::{Appearance, Colour, Geometry, Shading, View};
