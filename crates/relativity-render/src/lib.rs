//! Draws a scene that moves past, as one aperture sees it at one time.
//!
//! A resting scene is ray-traced exactly in its rest frame: the camera's event and each line of sight
//! are boosted there, where rays are straight and bodies stand still. Knows wgpu, but neither windows
//! nor files.

pub mod body;
pub mod camera;
pub mod colour;
pub mod intersect;
mod polynomial;
pub mod reference;
pub mod shade;
pub mod view;

pub use body::{Body, Shape};
pub use camera::{Camera, Gaze};
pub use reference::{Hit, ReferenceScene};
pub use view::{Appearance, Colour, Geometry, Shading, View};
