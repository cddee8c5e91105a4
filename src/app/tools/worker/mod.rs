//! Work in the background: on the desktop in a thread, in a page in another instance of the program.

#[cfg(not(feature = "desktop"))]
mod instance;
#[cfg(not(feature = "desktop"))]
mod page;
mod steps;
#[cfg(feature = "desktop")]
mod thread;

#[cfg(not(feature = "desktop"))]
pub use instance::{BackgroundWork, serve};
#[cfg(test)]
pub use steps::sent;
pub use steps::{StepOutcome, Wanted, Work};
#[cfg(feature = "desktop")]
pub use thread::{BackgroundWork, Worker};
