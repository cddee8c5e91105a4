//! Pipelines that are made before a picture is drawn by them, while other pictures go on: on the desktop by a
//! thread, in a page between frames.

#[cfg(not(feature = "desktop"))]
mod page;
#[cfg(feature = "desktop")]
mod thread;

#[cfg(not(feature = "desktop"))]
pub use page::Preparing;
#[cfg(feature = "desktop")]
pub use thread::Preparing;
