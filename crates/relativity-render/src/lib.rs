//! Draws a scene that moves past, as one aperture sees it at one time.
//!
//! A resting scene is ray-traced exactly in its rest frame: the camera's event and each line of sight
//! are boosted there, where rays are straight and bodies stand still. Knows wgpu, but neither windows
//! nor files.

pub mod backdrop;
pub mod body;
pub mod camera;
mod canvas;
pub mod colour;
pub mod cone;
mod effects;
mod exact;
mod frame;
pub mod gpu;
pub mod group;
mod hits;
pub mod intersect;
mod mesh;
mod palette;
pub mod picture;
mod polynomial;
pub mod ray;
pub mod rectified_hits;
pub mod rectify;
pub mod reference;
pub mod scene;
pub mod shade;
#[doc(hidden)]
pub mod shaders;
mod target;
mod tiles;
pub mod view;

pub use body::{Body, Shape};
pub use camera::{Camera, Gaze};
pub use exact::ExactRenderer;
pub use gpu::{Gpu, GpuError};
pub use group::{GroupView, Motion, RestRay, Velocity};
pub use mesh::MeshRenderer;
pub use picture::Picture;
pub use reference::{Hit, HitImage};
pub use scene::{Group, PreparedScene};
pub use target::EyeTarget;
pub use view::{Appearance, Colour, Geometry, Shading, View};
