//! Measured accuracy and speed of each method, against the f64 reference.
//!
//! Knows neither the window nor the command line; both call it.

mod automatic;
mod cost;
mod difference;
mod expected;
mod formulas;
mod outline;
mod published;
mod rounds;
mod spread;
mod views;

pub use automatic::{Automatic, Choice, Machine, MethodViews, method_name};
pub use cost::{REFERENCE_SAMPLES, frame_ms, methods};
pub use difference::{ARCSECONDS, Difference, DifferenceFigures, PixelDifference, angle};
pub use expected::{Effort, ExpectedError, expected_error};
pub use formulas::{ConeFormula, formula_error};
pub use outline::{LARGEST_PX, RESOLUTION_PX};
pub use published::{PublishedError, published_error};
pub use rounds::{AfterRounds, RoundsError};
pub use spread::Spread;
pub use views::{TrackedPlace, view_at};
