//! Draws a scene that moves past, as one aperture sees it at one time.
//!
//! A resting scene is ray-traced exactly in its rest frame: the camera's event and each line of sight
//! are boosted there, where rays are straight and bodies stand still. Knows wgpu, but neither windows
//! nor files.

pub mod body;
pub mod camera;
mod exact;
mod frame;
pub mod gpu;
mod palette;
mod target;
pub mod view;

pub use body::{Body, Shape};
pub use camera::{Camera, Gaze};
pub use exact::ExactRenderer;
pub use gpu::{Gpu, GpuError};
pub use target::{EyeTarget, Hit, HitImage};
pub use view::{Appearance, Colour, Geometry, Shading, View};
