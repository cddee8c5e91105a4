//! The files that are shown, watched for changes: on the desktop, and in a page, where they never change.

#[cfg(feature = "desktop")]
mod files;
#[cfg(not(feature = "desktop"))]
mod page;

#[cfg(feature = "desktop")]
pub use files::Watch;
#[cfg(not(feature = "desktop"))]
pub use page::Watch;
