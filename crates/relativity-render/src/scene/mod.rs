//! A scene: its bodies with their patterns and wheels, prepared once for every view, and how rays enter them.

pub(crate) mod body;
pub(crate) mod clusters;
pub(crate) mod first_entry;
pub(crate) mod one_cone;
pub(crate) mod pattern;
pub mod prepared_body;
pub(crate) mod prepared_scene;
mod standing;
pub(crate) mod wheel;
