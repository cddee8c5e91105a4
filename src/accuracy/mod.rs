//! Measured accuracy and speed of each method, against the f64 reference.
//!
//! Knows neither the window nor the command line; both call it.

mod automatic;
mod cost;
mod difference;
mod expected;
mod outline;
mod spread;
mod views;

pub use automatic::{Automatic, Choice, Machine, MethodViews, method_name};
pub use cost::{REFERENCE_SAMPLES, frame_ms, methods};
pub use difference::{ARCSECONDS, Difference, DifferenceFigures, PixelDifference};
pub use expected::{Effort, ExpectedError, expected_error, total_error_px};
pub use outline::{LARGEST_PX, RESOLUTION_PX};
pub use spread::Spread;
pub use views::{TrackedPlace, view_at};
