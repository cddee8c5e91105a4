//! How much accuracy each method trades for its speed, measured against the f64 reference.
//!
//! Knows neither the window nor the command line; both call it.

mod difference;
mod expected;
mod formulas;
mod outline;
mod published;
mod renderers;
mod spread;
mod views;

pub use difference::{ARCSECONDS, Difference, DifferenceFigures, PixelDifference, angle};
pub use expected::{Effort, ExpectedError, expected_error};
pub use formulas::{Formula, FormulaError, formula_error};
pub use outline::{
    LARGEST_PX, OutlinePoint, RESOLUTION_PX, SilhouettePixels, displacement_px, silhouette_pixels,
};
pub use published::{PublishedError, published_error};
pub use renderers::{MESH_BOUNDS_PX, Method, REFERENCE_SAMPLES, Renderers};
pub use spread::Spread;
pub use views::{Place, view_at};
