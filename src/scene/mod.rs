//! Scenes: what rides past, and how it is described in a file.

use relativity_render::Body;

/// A scene: bodies at rest in the moving frame, numbered from 0 in file order, and the ground they
/// pass over.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Its name, as shown.
    pub name: String,
    /// The bodies.
    pub bodies: Vec<Body>,
    /// Height of the resting ground (the grid), if there is one.
    pub ground_z: Option<f64>,
}
