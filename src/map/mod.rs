//! The map, as lines and marks in scene units: places of things at the observer's present T, beside those
//! where they are seen. It knows nothing of the window, and asks the same functions as the views.
//!
//! Coordinates are from between resting eyes: x along the motion, y away from the eyes, z up; those of the
//! bicycle's frame have their origin where the eyes' has it at t = 0, and those of the frame of who rides
//! have it between the eyes.

mod chart;
mod clip;
mod close_up;
mod diagram;
mod fit;
mod instant;
mod light;
mod lines;
mod nearest;
mod present;
mod projection;
mod sight;
mod straight_line;
mod street;
#[cfg(test)]
mod tests;
mod worldline;

pub use chart::{Chart, Viewpoint};
pub use close_up::around_now;
pub use diagram::{Diagram, PastCone, chart, home, worldline_of_eye};
pub use fit::{WorldBox, plan_and_side};
pub use instant::{BodyPicture, MapInstant, Places};
pub use light::{Front, ReceivedRay, fronts, rays};
pub use lines::{BallOutline, OutlineLine, OutlineLines, Vertex};
pub use nearest::{Nearest, along};
pub use projection::MapProjection;
pub use sight::field_of_view;
pub use straight_line::StraightLine;
pub use street::{street_lines, way_of_rider};
pub use worldline::PointWorldline;
