//! What the map draws, as lines and marks in scene units: where things are at the observer's present T, beside where
//! they are seen. It knows nothing of the window, and asks the same functions as the views.
//!
//! Coordinates are from between the eyes: x along the motion, y away from the eyes, z up; those of the bicycle's frame
//! have their origin where the eyes' has it at t = 0.

mod diagram;
mod event;
mod light;

pub use diagram::{Cone, Diagram, home};
pub use event::{Event, Line};
pub use light::{Front, Ray, Worldline, fronts, rays};
