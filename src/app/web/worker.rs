//! Work in the background of a page, by the names that it has on the desktop.

pub use super::background_work::BackgroundWork;
pub use crate::app::steps::{StepOutcome, Wanted, Work};
