//! Draws groups of bodies that move past, each with a speed of its own along x, as one aperture sees them at
//! one time.
//!
//! A group is ray-traced exactly in its rest frame: the camera's event and each line of sight are boosted
//! there, where rays are straight and bodies stand still. [`PreparedScene`] holds what no view changes,
//! [`View`] and [`Appearance`] say what is seen and how it looks, and [`Renderers`] draw that by
//! any [`Method`]: the f64 reference on the CPU, a ray test per pixel in f32 on the GPU or on the CPU, or
//! triangles. Conventions are those of [`relativity_core`].
//!
//! # Scope
//!
//! Bodies are balls, tubes, rings, boxes and cylinders that glow, each at one wavelength, alike in all
//! directions in its rest frame; and models of [`Triangles`], painted in white light. They are opaque and do
//! not light each other; the shading is a choice of looks, fixed to the rest frame. Motion is uniform and
//! along x, but for bodies that turn evenly about an axle along y ([`Spin`]): nothing else accelerates, turns
//! or deforms. The camera is a pinhole that rests on the ground, or moves evenly in any direction. The
//! published binocular model, which has no lines of sight, is drawn by triangles alone.
//!
//! Out of scope are windows and files (it knows wgpu, but reads and writes nothing), and a medium: light
//! travels at c.
//!
//! # Examples
//!
//! What the left eye sees of a ball that comes past at 0.9 c, on the CPU and in f64:
//!
//! ```
//! use relativity_core::{Aperture, Speed};
//! use relativity_render::{Appearance, Body, Camera, Gaze, Geometry, PreparedScene, Shape, View};
//!
//! let shape = Shape::Sphere { centre: [0.0, 3.0, 2.0], radius: 0.5 };
//! let scene = PreparedScene::moving(&[Body::new(shape, 700.0)]);
//! let mut view = View {
//!     camera: Camera::new(Aperture::pair(0.1)[0], Gaze::STRAIGHT_AHEAD, 0.5, [64, 48]),
//!     speed: Speed::from_beta(0.9)?,
//!     observation_time: 1.1,
//!     geometry: Geometry::Seen,
//! };
//! let centre = view.apparent_position([0.0, 3.0, 2.0]).expect("inside the domain");
//! view.camera.gaze = Gaze::along(centre.to_array());
//!
//! let hit = scene.first_hit(&view, view.camera.line_of_sight([32.0, 24.0])).expect("a hit");
//! assert!((hit.distance - 4.5).abs() < 0.5 && hit.doppler_factor > 1.0);
//! let picture = scene.picture(&view, &Appearance::default(), 2);
//! assert_eq!(picture.rgba.len(), 64 * 48);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![cfg_attr(
    not(test),
    warn(clippy::disallowed_methods, clippy::disallowed_types, clippy::print_stdout, clippy::print_stderr)
)]
#![expect(
    clippy::inline_always,
    reason = "what runs on wide registers must be inlined into where they are chosen"
)]

// From the top: each imports from those below it, and none from one above, which `tests/layers` of the
// program holds.
mod renderers;

pub mod gpu;

mod cpu;

mod frame;

pub mod picture;

pub mod street;

pub mod light;

pub mod scene;

pub mod geometry;

pub mod view;

pub mod camera;

pub mod colour;

mod kinematics;

mod simd;

mod shaders;

pub use camera::outline::{Framing, Outline};
pub use camera::{Camera, Gaze, Projection};
pub use colour::paint::{Material, Paint};
pub use geometry::shape::Shape;
pub use geometry::triangle_point::TrianglePoint;
pub use geometry::triangles::{RawModel, Texture, Triangles, TrianglesError, Wrap};
pub use gpu::composer::{Composed, Composer};
pub use gpu::device::{Gpu, adapter_name, instance_flags, named_adapter};
pub use gpu::device_errors::{DeviceErrors, ErrorScopes};
pub use gpu::error::{GpuError, Undrawn};
pub use gpu::preparation::{NeededPipeline, PipelineMaker};
pub use gpu::target::EyeTarget;
pub use kinematics::relative_velocity::RelativeVelocity;
pub use kinematics::spin::{MaterialPoint, Spin};
pub use kinematics::velocity::{Motion, Velocity};
pub use light::daylight::Facing;
pub use light::falling::FallingDaylight;
pub use light::screen_light::{Light, received_intensity};
pub use picture::compose::Composition;
pub use picture::hit::{Hit, HitImage};
pub use picture::pixels::Picture;
pub use renderers::{Method, Renderers};
pub use scene::body::{Body, Emission, Pattern};
pub use scene::prepared_scene::{Group, PreparedScene};
pub use view::group_view::{GroupView, RestRay};
pub use view::{Appearance, Colour, Geometry, Shading, StreetColours, View};

/// The example of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
